"""Choose the rooms of each storey: those that the brief asks for, and its type's own, with their areas."""

from collections import Counter
from collections.abc import Collection, Sequence
from dataclasses import replace

import msgspec

from mansion_knowledge import KnowledgeBase, RoomEntry
from mansion_planner.brief.facts import RoomFact
from mansion_planner.program.allocation import Allocation
from mansion_planner.program.household import STUDIO, use_of
from mansion_planner.program.model import PlannedRoom, Storey
from mansion_planner.program.people_rooms import SLEPT_IN_TOGETHER
from mansion_planner.program.planned_rooms import planned_room
from mansion_planner.program.room_growth import (
    at_home,
    growth_weight,
    is_described,
    is_needed,
    most_sensible,
    reach,
    weight_beyond,
)
from mansion_planner.program.storeys import entries_of

__all__ = [
    "MOST_ROOMS",
    "base_rooms",
    "fill_storey",
    "fit_areas",
    "hub_area",
    "listed_area",
    "name_rooms",
    "needed_area",
]


MOST_ROOMS = 34
"""Number of rooms of a storey from which on none is added merely to fill it."""


def base_rooms(storey: Storey, allocation: Allocation, knowledge: KnowledgeBase) -> list[PlannedRoom]:
    """Return the rooms that the brief asks for on a storey, as rooms to be placed."""
    rooms = []
    for fact in allocation.wanted[storey.index]:
        if fact.count == 1 and (fact.room_type == storey.hub.name or _is_way(fact, storey)):
            continue
        kind = knowledge.room(fact.room_type)
        kind = at_home(kind) if storey.use.family == "home" and fact.size != "large" else kind
        placed = fact.name in allocation.places
        area = max(kind.least if placed else kind.usual, allocation.furniture.get(fact.name, 0.0))
        room = planned_room(kind, knowledge, area=area, fact=fact)
        if not fact.known and fact.name.endswith("_room"):
            rooms.append(room if room.fixed else msgspec.structs.replace(room, most=min(room.most, _MOST_LIKE * area)))
        elif placed and kind.name in SLEPT_IN_TOGETHER and not room.fixed:
            rooms.append(msgspec.structs.replace(room, most=min(room.most, _MOST_BY_PLACES * area)))
        else:
            rooms.append(room if placed or fact.size else _as_in_its_building(room, storey))
    return rooms


_MOST_BY_PLACES = 1.25
"""Greatest share of what its beds need for a room whose beds the brief counts."""


def _is_way(fact: RoomFact, storey: Storey) -> bool:
    """Whether a room of the brief is the corridor along which a storey's rooms lie anyway."""
    along = storey.use.parti == "spine" and storey.use.family != "home" and storey.hub.zone == "circulation"
    return along and fact.room_type == "corridor" and not fact.area


_MOST_LIKE = 1.6
"""Greatest share of a type's usual area for a room that is only like it: the instrument room like a laboratory."""


_LEAST_LISTED = 0.6
"""Least share of its kind's usual area for a room of the brief where its building usually has a small one."""


def _as_in_its_building(room: PlannedRoom, storey: Storey) -> PlannedRoom:
    """Return a room as large as the building type's own list has it: the kitchen of a villa, a clinic's laboratory.

    Stores in a basement are no measure for those above.
    """
    below = storey.role == "basement"
    areas = [
        entry.area for role, entries in storey.use.storeys.items() for entry in entries
        if entry.room_type == room.kind.name and entry.area and (role == "basement") is below
    ]  # fmt: skip
    area = max([*areas, _LEAST_LISTED * room.kind.usual])
    own = room.area == room.kind.usual and not room.kind.toilet
    if room.fixed or not areas or not (own or area > room.area):
        return room
    return msgspec.structs.replace(room, area=area, most=max(room.most, area))


def listed_area(storey: Storey, allocation: Allocation, knowledge: KnowledgeBase) -> float:
    """Return what the rooms asked for and the storey's own list take at their usual sizes, square metres.

    Where the brief tells what the building holds, those alone of the list count that serve it.
    """
    total = sum(room.gross for room in base_rooms(storey, allocation, knowledge))
    main = _needed_entries(storey, allocation, knowledge) if allocation.told else []
    for entry in entries_of(storey):
        if not allocation.adds(entry.room_type, storey.index) or entry.repeat:
            continue
        if (
            allocation.told
            and entry not in main
            and not is_needed(knowledge.room(entry.room_type), storey.use, told=True)
        ):
            continue
        total += entry.count * allocation.added(entry, knowledge).gross
    return total


def hub_area(storey: Storey, allocation: Allocation) -> float:
    """Return the area that the brief states, or its furniture needs, for the room that is a storey's hub, or 0."""
    own = [fact for fact in allocation.wanted[storey.index] if fact.room_type == storey.hub.name]
    stated = max((fact.area or 0.0 for fact in own), default=0.0)
    needed = max(allocation.furniture.get(name, 0.0) for name in ("", *(fact.name for fact in own)))
    return stated or (needed if needed > storey.hub.usual else 0.0)


def needed_area(storey: Storey, allocation: Allocation, knowledge: KnowledgeBase) -> float:
    """Return the least area of the rooms asked for and of those that no such building does without, square metres."""
    asked = sum(room.least for top in base_rooms(storey, allocation, knowledge) for room in top.each())
    return asked + sum(
        knowledge.room(entry.room_type).least for entry in _needed_entries(storey, allocation, knowledge)
    )


def fill_storey(
    storey: Storey,
    allocation: Allocation,
    knowledge: KnowledgeBase,
    capacity: float,
    *,
    hub_share: float = 0.0,
    most_rooms: int = MOST_ROOMS,
    elsewhere: Collection[str] = (),
) -> list[PlannedRoom]:
    """Choose a storey's rooms: those asked for, then its type's list by priority, then what may repeat.

    Parameters
    ----------
    capacity : float
        Area for rooms, square metres.
    hub_share : float
        Area that the hub takes of it, where the hub is the main room.
    most_rooms : int
        Number of rooms from which on none is added merely to fill the storey.
    elsewhere : collection of str
        Types of rooms that other storeys have although the brief does not ask for them.
    """
    budget = capacity - hub_share
    rooms = _with_main_room(base_rooms(storey, allocation, knowledge), storey, budget)
    needed = _needed_entries(storey, allocation, knowledge)
    for entry in (each for each in needed for _ in range(each.count)):
        kind = knowledge.room(entry.room_type)
        if sum(room.least for top in rooms for room in top.each()) + kind.least <= _CROWDED * budget:
            rooms.append(allocation.added(entry, knowledge))
    described = allocation.told or is_described(rooms, budget)
    rooms = _with_listed(
        storey, allocation, knowledge, rooms, budget, elsewhere, needed=needed, beside_hub=not hub_share
    )
    rooms = _with_more_baths(storey, allocation, knowledge, rooms, budget)
    used = sum(room.gross for room in rooms)
    for entry in (entry for entry in entries_of(storey) if entry.repeat and entry not in needed):
        while allocation.adds(entry.room_type, storey.index) and len(rooms) < most_rooms:
            room = allocation.added(entry, knowledge)
            if used + 0.72 * room.gross > budget or (described and reach(rooms) >= budget):
                break
            rooms.append(room)
            used += room.gross
    return _topped_up(
        storey, allocation, knowledge, rooms, budget, most_rooms, elsewhere,
        described=described, beside_hub=not hub_share,
    )  # fmt: skip


_MAIN, _MOST_MAIN = 0.45, 0.8
"""Share of the area for rooms that a public building's main room takes where it is not the hub, and the greatest."""


def _with_main_room(rooms: Sequence[PlannedRoom], storey: Storey, budget: float) -> list[PlannedRoom]:
    """Return the rooms asked for, the one that the type is there for as large as the others let it be.

    The storage hall of a warehouse, which has a name of its own, so that it is not the hub.
    """
    main = [room for room in rooms if room.kind.name == storey.use.hub and not room.fixed and not room.suite]
    if storey.use.family == "home" or len(main) != 1 or not main[0].kind.flexible:
        return list(rooms)
    others = sum(room.gross for room in rooms) - main[0].area
    area = max(main[0].area, min(_MAIN * budget, budget - others))
    grown = msgspec.structs.replace(main[0], area=area, most=max(main[0].most, _MOST_MAIN * budget))
    return [grown if room is main[0] else room for room in rooms]


def _with_listed(
    storey: Storey,
    allocation: Allocation,
    knowledge: KnowledgeBase,
    rooms: Sequence[PlannedRoom],
    budget: float,
    elsewhere: Collection[str],
    *,
    needed: Sequence[RoomEntry],
    beside_hub: bool,
) -> list[PlannedRoom]:
    """Return the rooms with those of the storey's list that still fit, each as often as the list says.

    Where the brief describes the storey and its rooms can fill it, it gets those alone that serve them.

    Parameters
    ----------
    needed : sequence of RoomEntry
        Entries of the list that are among the rooms already.
    beside_hub : bool
        The hub is a passage, and no room of the list may crowd the others out.
    """
    filled = list(rooms)
    present = Counter(fact.room_type for fact in allocation.wanted[storey.index])
    used = sum(room.gross for room in filled)
    described = allocation.told or is_described(rooms, budget)
    home = storey.use.family == "home"
    extras = (storey.use.filler or knowledge.groups.filler_of(storey.use.family)) if home else ()
    for entry in (entry for entry in entries_of(storey) if entry not in needed):
        kind = knowledge.room(entry.room_type)
        enough = reach(filled) >= budget or (allocation.told and not beside_hub)
        if described and not is_needed(kind, storey.use, told=allocation.told) and enough:
            continue
        if kind.name == "bathroom" and _has_baths(filled):
            continue
        if not allocation.adds(kind.name, storey.index) or kind.name == storey.hub.name:
            continue
        if kind.name in extras and kind.name in elsewhere:
            continue
        for _ in range(0 if entry.repeat else max(entry.count - present[kind.name], 0)):
            room = allocation.added(entry, knowledge)
            room = _beside_others(room, budget) if beside_hub else room
            small = min(room.gross, room.gross * 0.5 + 0.5 * kind.least)
            if used + small <= budget * 1.03 or (not filled and used + kind.least <= budget):
                filled.append(room)
                used += room.gross
    return filled


def _has_baths(rooms: Sequence[PlannedRoom]) -> bool:
    """Whether each of several bedrooms of a storey has a bathroom for itself."""
    slept_in = [room for room in rooms if room.kind.sleeping]
    return len(slept_in) > 1 and all(any(child.kind.wet for child in room.suite) for room in slept_in)


_SHARING_A_BATH = 2
"""Bedrooms of a home's storey for each bathroom, where the storey has area to spare."""


def _with_more_baths(
    storey: Storey, allocation: Allocation, knowledge: KnowledgeBase, rooms: Sequence[PlannedRoom], budget: float
) -> list[PlannedRoom]:
    """Return the rooms of a home's storey with bathrooms for its bedrooms, before it gets rooms that only fill up."""
    filled = list(rooms)
    if storey.use.family != "home" or not allocation.adds("bathroom", storey.index):
        return filled
    sharing = sum(room.kind.sleeping and not any(child.kind.wet for child in room.suite) for room in filled)
    baths = sum(room.kind.name == "bathroom" for room in filled)
    bath = planned_room(knowledge.room("bathroom"), knowledge)
    used = sum(room.gross for room in filled)
    while baths * _SHARING_A_BATH < sharing - 1 and used + _LEAST_SPARE * bath.area <= budget:
        filled.append(bath)
        baths, used = baths + 1, used + bath.area
    return filled


_LEAST_SPARE = 2.0
"""Area that a storey has to spare for each further bathroom, in those of one."""

_MOST_OF_A_STOREY = 0.5
"""Greatest share of the area for rooms of one that the brief does not ask for, unless its kind needs more."""


def _beside_others(room: PlannedRoom, budget: float) -> PlannedRoom:
    """Return a room of a storey's list, smaller where it would leave the others of the list no place."""
    most = max(_MOST_OF_A_STOREY * budget, room.kind.least)
    return room if room.fixed or room.suite or room.area <= most else msgspec.structs.replace(room, area=most)


def _needed_entries(storey: Storey, allocation: Allocation, knowledge: KnowledgeBase) -> list[RoomEntry]:
    """Return the rooms of a storey's list that no such building does without, where the brief leaves them open.

    Other rooms are made smaller for them. A home has rooms to live, cook and wash in; in a studio people cook where
    they live. Other buildings have, behind their entrance, the rooms that they are there for.
    """
    if storey.use.family != "home":
        if storey.role not in ("single", "ground"):
            return []
        open_to = storey.use.main - {fact.room_type for fact in allocation.wanted[storey.index]}
        return [e for e in entries_of(storey) if e.room_type in open_to and allocation.adds(e.room_type, storey.index)]
    needs = [need for need in _NEEDS if not (need == "cooking" and storey.hub.name == STUDIO)]
    if storey.role == "single" and storey.hub.name == "living_room":
        needs.append("sleeping")  # a small flat keeps its bedroom; larger homes have several anyway
    stated = [fact for facts in allocation.wanted.values() for fact in facts]
    served = {use_of(knowledge.room(part.room_type)) for fact in stated for part in (fact, *fact.suite)}
    needed: dict[str, RoomEntry] = {}
    for entry in entries_of(storey):
        kind = knowledge.room(entry.room_type)
        need = use_of(kind)
        if need in needs and need not in served and allocation.adds(kind.name, storey.index):
            needed.setdefault(need, entry)
    found = [needed[need] for need in needs if need in needed]
    asleep = [replace(entry, count=1, repeat=False) for entry in found if entry is needed.get("sleeping")]
    return [*(entry for entry in found if not entry.repeat and entry.count == 1 and entry not in asleep), *asleep]


_NEEDS = ("washing", "cooking", "living")
"""What a home must have, in the order in which a very small one keeps it."""

_CROWDED = 1.25
"""Share of the area for rooms that the least areas of a home's rooms may come to: small homes have smaller rooms."""


_ONE_A_STOREY = frozenset(
    """
    lounge common_room laundry_room gym cafe bar sauna business_center computer_lab art_room break_room archive
    training_room storage
    """.split()
)
"""Rooms of general use that a storey is not filled up with more than once."""

_ONE_A_BUILDING = frozenset("gym sauna business_center computer_lab art_room training_room".split())
"""Those that a building is not filled up with more than once; a home has none twice."""

_ENOUGH, _ENOUGH_FOR_GUESTS = 0.82, 0.7
"""Share of the area for rooms that rooms may take so that they grow to fill it: those of hotels rather grow than get
lounges beside them that nobody asked for."""


def _topped_up(
    storey: Storey,
    allocation: Allocation,
    knowledge: KnowledgeBase,
    rooms: Sequence[PlannedRoom],
    budget: float,
    most: int,
    elsewhere: Collection[str],
    *,
    described: bool,
    beside_hub: bool,
) -> list[PlannedRoom]:
    """Return the rooms, with others of general use where the brief settles the number of those that would fill up.

    A storey that the brief describes gets none as soon as its rooms can grow to fill it.
    """
    filled = list(rooms)
    if storey.hub.zone == "service" or storey.hub.name == STUDIO or (allocation.told and not beside_hub):
        return filled  # a hall for cars, goods or machines takes what is left, and so do a studio and a hall of guests
    names = storey.use.filler or knowledge.groups.filler_of(storey.use.family)
    home = storey.use.family == "home"
    once = storey.use.family in ("home", "lodging")
    turn = 0 if once else max(storey.index - 1, 0) % len(names)  # storeys of one kind do not all get the same
    kinds = [knowledge.room(name) for name in names[turn:] + names[:turn]]
    stated = {fact.room_type for facts in allocation.wanted.values() for fact in facts}
    there = {room.kind.name for room in filled}
    kinds = [
        kind
        for kind in kinds
        if allocation.adds(kind.name, storey.index)
        and not (kind.storey == "ground" and storey.index >= 2)
        and kind.name not in stated
        and not ((home or kind.name in _ONE_A_STOREY) and kind.name in there)
        and not ((home or kind.name in _ONE_A_BUILDING) and kind.name in elsewhere)
    ]
    if home and storey.index >= 2:
        kinds.sort(key=lambda kind: kind.storey != "upper")
    enough = _ENOUGH_FOR_GUESTS if storey.use.family == "lodging" else _ENOUGH
    for kind in kinds + ([] if once or described else [kind for kind in kinds if kind.name not in _ONE_A_STOREY] * 2):
        used = sum(room.gross for room in filled)
        if used >= enough * budget or len(filled) >= most or (described and reach(filled) >= budget):
            break
        if used + 0.8 * kind.usual <= budget:
            filled.append(planned_room(kind, knowledge))
    return filled


def fit_areas(rooms: Sequence[PlannedRoom], capacity: float) -> tuple[PlannedRoom, ...]:
    """Return the rooms scaled to fill `capacity`: stated areas stay, flexible rooms give and take first.

    Rooms that do not fit within their limits give in proportion; where they cannot fill it, those that are good at any
    size take more than toilets, baths and stores.
    """
    every = [room for top in rooms for room in top.each()]
    loose = [room for room in every if not room.fixed]
    spare = capacity - sum(room.area for room in every if room.fixed)
    areas = [room.area for room in loose]
    # A room that meets its limit leaves its share to the others, so the scale is sought anew a few times. Only what
    # cannot be met within the limits is spread over all rooms without them.
    for scaled in (_within_limits, _beyond_limits, _in_proportion):
        for _ in range(6):
            total = sum(areas)
            if not loose or total <= 0 or abs(total - spare) < 0.01:
                break
            factor = spare / total
            areas = [scaled(room, area, factor) for room, area in zip(loose, areas)]
    found = {id(room): area for room, area in zip(loose, areas)}
    return tuple(
        top.changed(lambda room: room if room.fixed else msgspec.structs.replace(room, area=found[id(room)]))
        for top in rooms
    )


def _within_limits(room: PlannedRoom, area: float, factor: float) -> float:
    strength = factor if factor < 1.0 else 1.0 + (factor - 1.0) * growth_weight(room)
    return min(max(area * strength, room.least), most_sensible(room))


def _beyond_limits(room: PlannedRoom, area: float, factor: float) -> float:
    return _in_proportion(room, area, factor if factor < 1.0 else 1.0 + (factor - 1.0) * weight_beyond(room))


def _in_proportion(room: PlannedRoom, area: float, factor: float) -> float:
    return max(area * factor, 1.0)


_CIRCULATION = frozenset({"corridor", "wing", "far", "stair", "elevator"})


def name_rooms(rooms: Sequence[PlannedRoom], hub_id: str) -> tuple[PlannedRoom, ...]:
    """Return a storey's rooms numbered: ``meeting_room_1``; a name that occurs once stays bare.

    No room takes the name of the hub, of a corridor that the sketch adds, or of a core.
    """
    every = [room for top in rooms for room in top.each()]
    bases = [f"{room.id}_area" if room.id in _CIRCULATION else room.id for room in every]
    counts = Counter(bases)
    used = {hub_id} | {name for name, count in counts.items() if count == 1 and name != hub_id}
    seen: Counter[str] = Counter()
    names: dict[int, str] = {}
    for room, base in zip(every, bases):
        name = base
        if counts[base] > 1 or base == hub_id:
            while name == base or name in used:
                seen[base] += 1
                name = f"{base}_{seen[base]}"
            used.add(name)
        names[id(room)] = name

    def named(room: PlannedRoom) -> PlannedRoom:
        name = names[id(room)]
        return room if name == room.id else msgspec.structs.replace(room, id=name)

    return tuple(top.changed(named) for top in rooms)
