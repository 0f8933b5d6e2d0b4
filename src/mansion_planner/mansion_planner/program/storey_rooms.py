"""Choose the rooms of each storey: those that the brief asks for, and its type's own, with their areas."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import msgspec

from mansion_knowledge import KnowledgeBase, RoomEntry, RoomType
from mansion_language import singular
from mansion_msgs_py.program import TraceEntry
from mansion_planner.brief.bounds import within_bound
from mansion_planner.brief.facts import RoomFact
from mansion_planner.brief.sizes import size_bound
from mansion_planner.program.decisions import Decisions, note
from mansion_planner.program.furniture_areas import furniture_area, furniture_areas, usual_number
from mansion_planner.program.household import household_of, is_whole, main_room, private_types, use_of
from mansion_planner.program.model import PlannedRoom, Storey
from mansion_planner.program.step_record import Record
from mansion_planner.program.storeys import entries_of, floors_of

__all__ = [
    "Allocation",
    "allocate",
    "base_rooms",
    "fill_storey",
    "fit_areas",
    "hub_area",
    "listed_area",
    "name_rooms",
    "planned_room",
]


@dataclass(frozen=True)
class Allocation:
    """Counts of the rooms that the brief asks for, by storey.

    Attributes
    ----------
    wanted : dict of int to list of RoomFact
        One fact for each room, by storey.
    settled : frozenset of str
        Room types whose number the brief settles; no storey adds more.
    unwanted : dict of int to frozenset of str
        Room types that the brief does not want on a storey.
    complete : frozenset of int
        Storeys on which the brief wants no room but those that it names.
    furniture : dict of str to float
        Square metres that the furniture wanted in rooms of a name needs.
    households : dict of str to RoomFact
        What every unit holds that a storey adds by itself, by the room type that it counts as.
    """

    wanted: dict[int, list[RoomFact]] = field(default_factory=dict)
    settled: frozenset[str] = frozenset()
    unwanted: dict[int, frozenset[str]] = field(default_factory=dict)
    complete: frozenset[int] = frozenset()
    furniture: dict[str, float] = field(default_factory=dict)
    households: dict[str, RoomFact] = field(default_factory=dict)

    def added(self, entry: RoomEntry, knowledge: KnowledgeBase) -> PlannedRoom:
        """Return a room of a storey's list, with the rooms that the brief gives to every such unit."""
        kind = knowledge.room(entry.room_type)
        fact = self.households.get(kind.counts_as)
        if fact is not None:
            return planned_room(knowledge.room(fact.room_type), knowledge, fact=fact)
        return planned_room(kind, knowledge, area=entry.area)

    def adds(self, room_type: str, floor: int) -> bool:
        """Whether a storey may have rooms of a type that the brief does not ask for."""
        refused = room_type in self.settled or room_type in self.unwanted.get(floor, ())
        return floor not in self.complete and not refused


def _people_rooms(decisions: Decisions, knowledge: KnowledgeBase) -> tuple[RoomFact, str] | None:
    """Return the rooms that stated occupants need (classrooms for pupils, bedrooms for a family), and that in words."""
    facts, seats = decisions.facts, decisions.building.seats
    if not facts.occupants:
        return None
    people = facts.occupants[0]
    stated = {fact.room_type for fact in facts.rooms if fact.count is not None}
    if decisions.building.family == "home" and people.noun in (
        "family",
        "people",
        "person",
        "resident",
        "adult",
        "inhabitant",
        "kid",
        "child",
    ):
        if any(knowledge.room(name).counts_as == "bedroom" for name in stated):
            return None
        grown = people.count if people.noun not in ("kid", "child") else people.count + 2
        count = max(1, min(grown - 1, 8))
        return RoomFact("bedroom", "bedroom", people.span, count), f"{count} bedrooms for {people.count} people"
    if seats is None or people.noun in ("employee", "worker", "staff", "visitor", "teacher", "family"):
        return None
    kind = knowledge.room(seats.room_type)
    if kind.name in stated:
        return None
    count = max(1, -(-people.count // int(seats.area or 1)))
    return RoomFact(kind.name, kind.name, people.span, count), f"{count} x {kind.name} for {people.count} people"


MANY = 6
"""From so many pieces on, furniture that the brief puts in no room gets one that usually has as many."""


def _furniture_rooms(
    decisions: Decisions, knowledge: KnowledgeBase, storeys: Sequence[Storey]
) -> list[tuple[RoomFact, float]]:
    """Return the rooms for many pieces of furniture that the brief puts in none, and the square metres that they need.

    A room of the brief that usually has many takes them, else one of the building's own.
    """
    out = []
    for wanted in decisions.facts.objects:
        if wanted.room or wanted.excluded or not wanted.category or (wanted.count or 0) < MANY:
            continue

        def holds(room_type: str, category: str = wanted.category) -> float:
            return usual_number(room_type, category, knowledge.room(room_type).usual)

        floors = set(floors_of(wanted.floors, decisions))
        stated = [
            fact
            for fact in decisions.facts.rooms
            if holds(fact.room_type) >= MANY / 2
            and not (floors and fact.floors and floors.isdisjoint(floors_of(fact.floors, decisions)))
        ]
        own = [
            entry.room_type
            for storey in storeys
            for entry in entries_of(storey)
            if not floors or storey.index in floors
        ]
        if stated:
            out.append((max(stated, key=lambda fact: holds(fact.room_type)), 0.0))
        elif own and max(holds(name) for name in own) >= MANY / 2:
            best = max(own, key=holds)
            out.append((RoomFact(best, best, wanted.span, 1, floors=wanted.floors, each=wanted.each), 0.0))
        else:
            continue
        out[-1] = (out[-1][0], furniture_area(out[-1][0].room_type, wanted))
    return out


def allocate(decisions: Decisions, knowledge: KnowledgeBase, storeys: Sequence[Storey]) -> tuple[Allocation, Record]:
    """Distribute the rooms that the brief asks for over the storeys.

    A room that the brief asks for by name is built although another statement excludes its kind.
    """
    trace: list[TraceEntry] = []
    facts = list(decisions.facts.rooms)
    for_people = _people_rooms(decisions, knowledge)
    if for_people is not None:
        fact, effect = for_people
        note(trace, fact.span, effect)
        facts.append(fact)
    wanted: dict[int, list[RoomFact]] = {storey.index: [] for storey in storeys}
    for_furniture = _furniture_rooms(decisions, knowledge, storeys)
    furniture = furniture_areas(decisions.facts.rooms, decisions.facts.objects)
    for fact, area in for_furniture:
        furniture[fact.name] = max(area, furniture.get(fact.name, 0.0))
    asked = [*facts, *(fact for fact, _ in for_furniture if fact not in decisions.facts.rooms)]
    for fact in sorted(asked, key=lambda fact: _is_free_bathroom(fact, decisions)):  # once bedrooms have their storeys
        floors, where = _floors_for(fact, knowledge, decisions, storeys, wanted)
        for floor in floors:
            wanted[floor].append(fact)
        note(trace, fact.span, f"{fact.name} x{_number_of(fact)}{where}")
    allocation = Allocation(
        wanted=wanted,
        settled=_settled_types(facts, decisions, knowledge),
        unwanted=_unwanted_types(wanted, decisions, knowledge),
        complete=_complete_storeys(decisions, storeys),
        furniture=furniture,
        households={knowledge.room(fact.room_type).counts_as: fact for fact in decisions.facts.households},
    )
    return allocation, Record(tuple(trace))


def _complete_storeys(decisions: Decisions, storeys: Sequence[Storey]) -> frozenset[int]:
    """Return the storeys on which the brief names all rooms."""
    if decisions.facts.only:
        return frozenset(storey.index for storey in storeys)
    return frozenset(floor for _, refs in decisions.facts.only_on for floor in floors_of(refs, decisions))


def _settled_types(facts: Iterable[RoomFact], decisions: Decisions, knowledge: KnowledgeBase) -> frozenset[str]:
    """Return the room types whose number the brief settles, or that it excludes and does not ask for by name."""
    asked = {fact.room_type for fact in decisions.facts.rooms}
    refused = {name for name, _ in decisions.facts.excluded} | set(decisions.facts.combined)
    refused -= asked
    settled = refused.union(*(group for group in _REFUSED_TOGETHER if group & refused)) - asked
    for fact in facts:
        settled.update(*(_LEAVES_OUT.get(child.room_type, ()) for child in fact.suite))
        kind = knowledge.room(fact.room_type)
        if fact.count is not None and not (kind.common and fact.count == 1):
            settled.update(name for name, other in knowledge.rooms.items() if other.counts_as == kind.counts_as)
            settled.update(next((group for group in _SAME_USE if kind.name in group), ()))
            if kind.name == "private_office" and decisions.building.family != "office":
                settled.add("open_office")  # a factory with two offices has no third one
            if fact.count > 1:
                settled.update(_same_head(fact.name, knowledge))
                settled.update(_LEAVES_OUT.get(kind.name, ()))
            if fact.name == "bedroom" and fact.count > 1:
                settled |= _GUESTS_ROOMS - asked  # a hotel with twenty bedrooms has no other rooms to sleep in
    return frozenset(settled)


def _unwanted_types(
    wanted: Mapping[int, list[RoomFact]], decisions: Decisions, knowledge: KnowledgeBase
) -> dict[int, frozenset[str]]:
    """Return the room types that a storey adds none of: those that the brief excludes there or that are in a unit."""
    unwanted = {floor: frozenset(private_types(facts, knowledge)) for floor, facts in wanted.items()}
    for name, ref, _ in decisions.facts.excluded_on:
        like = next((group for group in _SAME_USE if name in group), frozenset())
        for floor in floors_of((ref,), decisions):
            unwanted[floor] = unwanted.get(floor, frozenset()) | {name} | like | _same_head(name, knowledge)
    return unwanted


_SAME_USE = (
    frozenset({"treatment_room", "dental_room", "consultation_room"}),
    frozenset({"cinema_hall", "auditorium"}),
    frozenset({"toilet", "restroom"}),
    frozenset({"classroom", "training_room"}),
    frozenset({"dorm_room", "hostel_dorm", "bunk_room", "holding_cell"}),
)
"""Room types that stand for each other: a stated number of one leaves no room for another."""

_REFUSED_TOGETHER = (frozenset({"cafeteria", "cafe", "restaurant"}),)
"""Room types of which a brief that refuses one by name wants none of the others."""

_LEAVES_OUT = {
    "bathroom": frozenset({"restroom", "toilet"}),
    "bedroom": frozenset({"nap_room"}),
    "judges_chamber": frozenset({"judges_chamber"}),
    "living_room": frozenset({"lounge"}),
}
"""Room types that a storey adds none of where the brief counts rooms, or gives to units, of another."""

_GUESTS_ROOMS = frozenset({"hotel_room", "hotel_suite", "resident_room", "patient_room", "dorm_room", "hostel_dorm"})
"""Rooms for those who sleep in a building that is no home; a brief may call them bedrooms."""

_GENERAL_HEADS = frozenset({"room", "hall", "area", "store", "storage", "space", "centre", "center", "section"})


def _same_head(name: str, knowledge: KnowledgeBase) -> set[str]:
    """Return the room types whose name ends in the same noun: a number of "offices" holds for every kind of office."""
    head = name.rpartition("_")[2]
    if head in _GENERAL_HEADS:
        return set()
    heads = next((group for group in _HEADS_ALIKE if head in group), {head})
    return {room for room in knowledge.rooms if room.rpartition("_")[2] in heads}


_HEADS_ALIKE = (frozenset({"lab", "laboratory"}),)
"""Nouns that mean the same at the end of a room's name."""


def _number_of(fact: RoomFact) -> int:
    return fact.count if fact.count is not None else 2


def _floors_for(
    fact: RoomFact,
    knowledge: KnowledgeBase,
    decisions: Decisions,
    storeys: Sequence[Storey],
    wanted: Mapping[int, Sequence[RoomFact]],
) -> tuple[list[int], str]:
    """Return the storeys of a fact's rooms, one entry for each room, and where the brief itself puts them, in words.

    Parameters
    ----------
    wanted : mapping of int to sequence of RoomFact
        What the storeys have so far: a room that the brief leaves free goes to the emptiest.
    """
    above = [storey.index for storey in storeys if storey.index >= 1]
    count = _number_of(fact)
    if fact.floors:
        chosen = [f for f in floors_of(fact.floors, decisions) if f in wanted] or [above[-1]]
        found: list[int] = []
        for number, floor in enumerate(chosen):
            found += [floor] * (count if fact.each else count // len(chosen) + (number < count % len(chosen)))
        return found, f" on storey {', '.join(str(floor) for floor in chosen)}"
    if fact.each:
        return [floor for floor in above for _ in range(count)], " on every storey"
    floors = _preferred(knowledge.room(fact.room_type), decisions, storeys)
    if _is_free_bathroom(fact, decisions):
        return _by_bedrooms(count, floors, wanted, knowledge), ""
    beside = _beside(fact, decisions, wanted)
    if beside and count == 1:
        floors = beside
    return _emptiest(fact, count, floors, wanted), ""


def _emptiest(fact: RoomFact, count: int, floors: Sequence[int], wanted: Mapping[int, Sequence[RoomFact]]) -> list[int]:
    """Return a storey for each of `count` rooms: the one where the brief asks for the least area so far."""
    areas = {floor: [other.area or _USUAL for other in wanted[floor]] for floor in floors}
    found = []
    for _ in range(count):
        floor = min(floors, key=lambda f: (sum(areas[f]), f))
        areas[floor].append(fact.area or _USUAL)
        found.append(floor)
    return found


def _is_free_bathroom(fact: RoomFact, decisions: Decisions) -> bool:
    """Whether a bathroom of a home is for the planner to put on a storey."""
    beside = any(fact.name in (a.first_name, a.second_name) for a in decisions.facts.adjacent)
    free = not fact.floors and not fact.each and not beside
    return free and fact.room_type == "bathroom" and decisions.building.family == "home"


_BY_DAY = 1.5
"""Bedrooms that a storey without any counts for when bathrooms are shared out over the storeys of a home."""


def _by_bedrooms(
    count: int, floors: Sequence[int], wanted: Mapping[int, Sequence[RoomFact]], knowledge: KnowledgeBase
) -> list[int]:
    """Return a storey for each of `count` bathrooms: the one with the most bedrooms for each bathroom there."""

    def number(floor: int, kind: str) -> int:
        return sum(knowledge.room(fact.room_type).counts_as == kind for fact in wanted[floor])

    bathrooms = {floor: number(floor, "bathroom") for floor in floors}
    found: list[int] = []
    for _ in range(count):
        floor = max(floors, key=lambda f: ((number(f, "bedroom") or _BY_DAY) / (bathrooms[f] + 1), -f))
        bathrooms[floor] += 1
        found.append(floor)
    return found


_USUAL = 14.0
"""Square metres that a room without a stated area counts for when rooms are shared out over storeys."""


def _beside(fact: RoomFact, decisions: Decisions, wanted: Mapping[int, Sequence[RoomFact]]) -> list[int]:
    """Return the storeys of the rooms that this one is to stand beside, once they have theirs."""
    names = {a.second_name if a.first_name == fact.name else a.first_name for a in decisions.facts.adjacent
             if fact.name in (a.first_name, a.second_name)}  # fmt: skip
    return [floor for floor, facts in sorted(wanted.items()) if any(other.name in names for other in facts)]


def _preferred(kind: RoomType, decisions: Decisions, storeys: Sequence[Storey]) -> list[int]:
    above = [storey.index for storey in storeys if storey.index >= 1]
    below = [storey.index for storey in storeys if storey.index < 1]
    home = decisions.building.family == "home"
    if kind.storey == "basement" and below:
        return below
    if kind.name in ("bathroom", "toilet") and home:
        return above[1:] + above[:1] if len(above) > 1 else above
    if kind.storey == "ground":
        if kind.name in ("classroom", "shop"):
            return above
        return above[:1]
    if kind.storey == "upper":
        return above[1:] or above
    if kind.storey == "top":
        return above[-1:]
    return above


_TIGHT = 0.8
"""Share of the floor that furniture needs to which a room may shrink."""


def planned_room(
    kind: RoomType, knowledge: KnowledgeBase, *, area: float | None = None, fact: RoomFact | None = None
) -> PlannedRoom:
    """Make a room of a type with its suite; the area of a fact is kept."""
    if fact is not None and fact.unit:
        return _planned_unit(kind, knowledge, fact)
    stated = fact is not None and fact.area is not None
    if fact is not None and fact.size and not stated:
        return _sized_room(kind, knowledge, fact)
    wish = within_bound(fact.area, fact.limit) if fact is not None and fact.area is not None else area or kind.usual
    furnished = fact is not None and wish > kind.usual
    return PlannedRoom(
        id=fact.name if fact is not None else kind.name,
        kind=kind,
        area=wish,
        least=wish if stated else max(min(kind.least, wish), _TIGHT * wish if furnished else 0.0),
        most=wish if stated else max(kind.most, 1.15 * wish if furnished else wish),
        fixed=stated,
        stated=fact is not None,
        suite=_suite(kind, knowledge, fact.suite if fact is not None else ()),
        notes=f"from {fact.span.words!r}" if fact is not None else "",
        base=fact.name if fact is not None else kind.name,
        label=_label_of_one(fact) if fact is not None else "",
    )


def _label_of_one(fact: RoomFact) -> str:
    """Return what the brief calls one of several rooms: "guest room" of "three guest rooms"."""
    first, gap, last = fact.label.rpartition(" ")
    one = fact.name.rpartition("_")[2]
    if last.lower() == one or singular(last.lower()) != one:
        return fact.label
    return f"{first}{gap}{one.capitalize() if last[:1].isupper() else one}"


def _sized_room(kind: RoomType, knowledge: KnowledgeBase, fact: RoomFact) -> PlannedRoom:
    """Make a room that is to be large or small for its kind; it may be more so than that."""
    wish = within_bound(*size_bound(fact.size, kind.least, kind.usual))
    large = fact.size == "large"
    return msgspec.structs.replace(
        planned_room(kind, knowledge, fact=replace(fact, size="")),
        area=wish,
        least=wish if large else min(kind.least, wish),
        most=max(kind.most, wish) if large else wish,
    )


def _suite(kind: RoomType, knowledge: KnowledgeBase, stated: Sequence[RoomFact]) -> tuple[PlannedRoom, ...]:
    """Make the rooms reached through one of a type: those stated, and the type's own of other zones."""
    rooms = [
        planned_room(knowledge.room(child.room_type), knowledge, fact=child)
        for child in stated
        for _ in range(child.count or 1)
    ]
    taken = {knowledge.room(child.room_type).zone for child in stated}
    for entry in kind.suite:
        child_kind = knowledge.room(entry.room_type)
        if not stated or child_kind.zone not in taken:
            rooms.append(planned_room(child_kind, knowledge, area=entry.area))
    return tuple(rooms)


def _planned_unit(kind: RoomType, knowledge: KnowledgeBase, fact: RoomFact) -> PlannedRoom:
    """Make the main room of a unit with the rooms that are reached through it; all share a stated area."""
    whole = fact.area if is_whole(fact, knowledge) else None
    main = main_room(fact, knowledge)
    stated, added = household_of(fact, knowledge)
    own = main.area if main is not None else None if whole else fact.area
    room = planned_room(kind, knowledge, fact=replace(fact, unit=False, suite=(), area=own))
    hall = kind.zone == "public" and not (kind.unit or room.fixed)
    rooms = [
        planned_room(knowledge.room(child.room_type), knowledge, fact=child)
        for child in stated
        for _ in range(child.count or 2)
    ]
    rooms += [
        planned_room(knowledge.room(entry.room_type), knowledge, area=entry.area)
        for entry in added
        for _ in range(entry.count)
    ]
    unit = msgspec.structs.replace(
        room,
        area=min(room.area, max(kind.least, _HALL)) if hall else room.area,
        notes=f"from {fact.label!r}",
        suite=tuple(rooms),
        serves_as=tuple(dict.fromkeys((main.room_type, main.name))) if main is not None else (),
    )
    return _of_area(unit, whole) if whole else unit


_HALL = 20.0
"""Square metres of the room that a cluster's or an office unit's other rooms are reached through."""

_LEAST_SHARE = 0.4
"""Of its usual area, what a room of a dwelling keeps whatever the area of the whole."""


def _of_area(unit: PlannedRoom, area: float) -> PlannedRoom:
    """Return a unit of `area` square metres: its rooms without a stated area of their own share what others leave."""
    rooms = unit.each()
    spare = area - sum(room.area for room in rooms if room.fixed)
    factor = max(spare / max(sum(room.area for room in rooms if not room.fixed), 1.0), _LEAST_SHARE)

    def scaled(room: PlannedRoom) -> PlannedRoom:
        if room.fixed:
            return room
        own = room.area * factor
        return msgspec.structs.replace(room, area=own, least=own, most=own, fixed=True)

    return unit.changed(scaled)


MOST_ROOMS = 34


def base_rooms(storey: Storey, allocation: Allocation, knowledge: KnowledgeBase) -> list[PlannedRoom]:
    """Return the rooms that the brief asks for on a storey, as rooms to be placed."""
    rooms = []
    for fact in allocation.wanted[storey.index]:
        if fact.room_type == storey.hub.name and fact.count == 1:
            continue
        kind = knowledge.room(fact.room_type)
        area = max(kind.usual, allocation.furniture.get(fact.name, 0.0))
        rooms.append(planned_room(kind, knowledge, area=area, fact=fact))
    return rooms


def listed_area(storey: Storey, allocation: Allocation, knowledge: KnowledgeBase) -> float:
    """Return what the rooms asked for and the storey's own list take at their usual sizes, square metres."""
    total = sum(room.gross for room in base_rooms(storey, allocation, knowledge))
    for entry in entries_of(storey):
        if allocation.adds(entry.room_type, storey.index) and not entry.repeat:
            total += entry.count * allocation.added(entry, knowledge).gross
    return total


def hub_area(storey: Storey, allocation: Allocation) -> float:
    """Return the area that the brief states, or its furniture needs, for the room that is a storey's hub, or 0."""
    own = [fact for fact in allocation.wanted[storey.index] if fact.room_type == storey.hub.name]
    stated = max((fact.area or 0.0 for fact in own), default=0.0)
    needed = max(allocation.furniture.get(name, 0.0) for name in ("", *(fact.name for fact in own)))
    return stated or (needed if needed > storey.hub.usual else 0.0)


def fill_storey(
    storey: Storey, allocation: Allocation, knowledge: KnowledgeBase, capacity: float, *, hub_share: float = 0.0
) -> list[PlannedRoom]:
    """Choose a storey's rooms: those asked for, then its type's list by priority, then what may repeat.

    Parameters
    ----------
    capacity : float
        Area for rooms, square metres.
    hub_share : float
        Area that the hub takes of it, where the hub is the main room.
    """
    rooms = base_rooms(storey, allocation, knowledge)
    present = {fact.room_type for fact in allocation.wanted[storey.index]}
    budget = capacity - hub_share
    needed = _needed_entries(storey, allocation, knowledge)
    for entry in needed:
        kind = knowledge.room(entry.room_type)
        if sum(room.least for top in rooms for room in top.each()) + kind.least <= _CROWDED * budget:
            rooms.append(allocation.added(entry, knowledge))
    used = sum(room.gross for room in rooms)
    repeats = []
    for entry in (entry for entry in entries_of(storey) if entry not in needed):
        kind = knowledge.room(entry.room_type)
        if entry.repeat:
            repeats.append(entry)
        if not allocation.adds(kind.name, storey.index) or kind.name == storey.hub.name:
            continue
        count = 0 if entry.repeat else max(entry.count - (kind.name in present), 0)
        for _ in range(count):
            room = allocation.added(entry, knowledge)
            if not hub_share:
                room = _beside_others(room, budget)
            small = min(room.gross, room.gross * 0.5 + 0.5 * kind.least)
            if used + small <= budget * 1.03 or (not rooms and used + kind.least <= budget):
                rooms.append(room)
                used += room.gross
    for entry in repeats:
        kind = knowledge.room(entry.room_type)
        while allocation.adds(kind.name, storey.index) and len(rooms) < MOST_ROOMS:
            room = allocation.added(entry, knowledge)
            if used + 0.72 * room.gross > budget:
                break
            rooms.append(room)
            used += room.gross
    return _topped_up(storey, allocation, knowledge, rooms, budget)


_MOST_OF_A_STOREY = 0.5
"""Of the area for rooms, what one that the brief does not ask for takes at most, unless its kind needs more."""


def _beside_others(room: PlannedRoom, budget: float) -> PlannedRoom:
    """Return a room of a storey's list, smaller where it would leave the others of the list no place."""
    most = max(_MOST_OF_A_STOREY * budget, room.kind.least)
    return room if room.fixed or room.suite or room.area <= most else msgspec.structs.replace(room, area=most)


def _needed_entries(storey: Storey, allocation: Allocation, knowledge: KnowledgeBase) -> list[RoomEntry]:
    """Return the rooms of a home's list to live, cook and wash in that the brief leaves open on every storey.

    Other rooms are made smaller for them: no home does without.
    """
    if storey.use.family != "home":
        return []
    stated = [fact for facts in allocation.wanted.values() for fact in facts]
    served = {use_of(knowledge.room(part.room_type)) for fact in stated for part in (fact, *fact.suite)}
    needed: dict[str, RoomEntry] = {}
    for entry in entries_of(storey):
        kind = knowledge.room(entry.room_type)
        need = use_of(kind)
        if need in _NEEDS and need not in served and allocation.adds(kind.name, storey.index):
            needed.setdefault(need, entry)
    found = [needed[need] for need in _NEEDS if need in needed]
    return [entry for entry in found if not entry.repeat and entry.count == 1]


_NEEDS = ("washing", "cooking", "living")
"""What a home must have, in the order in which a very small one keeps it."""

_CROWDED = 1.25
"""Of the area for rooms, what the least areas of a home's rooms may come to: small homes have smaller rooms."""


def _topped_up(
    storey: Storey, allocation: Allocation, knowledge: KnowledgeBase, rooms: Sequence[PlannedRoom], budget: float
) -> list[PlannedRoom]:
    """Return the rooms, with others of general use where the brief settles the number of those that would fill up."""
    filled = list(rooms)
    kinds = [knowledge.room(name) for name in knowledge.groups.filler_of(storey.use.family)]
    kinds = [kind for kind in kinds if allocation.adds(kind.name, storey.index)]
    for kind in kinds * (1 if storey.use.family == "home" else 3):
        used = sum(room.gross for room in filled)
        if used >= 0.82 * budget or len(filled) >= MOST_ROOMS:
            break
        if used + 0.8 * kind.usual <= budget:
            filled.append(planned_room(kind, knowledge))
    return filled


def fit_areas(rooms: Sequence[PlannedRoom], capacity: float) -> tuple[PlannedRoom, ...]:
    """Return the rooms scaled to fill `capacity`: stated areas stay, flexible rooms give and take first.

    Rooms that cannot fill it within their limits, or do not fit, take what there is in proportion.
    """
    every = [room for top in rooms for room in top.each()]
    loose = [room for room in every if not room.fixed]
    spare = capacity - sum(room.area for room in every if room.fixed)
    areas = [room.area for room in loose]
    # A room that meets its limit leaves its share to the others, so the scale is sought anew a few times. Only what
    # cannot be met within the limits is spread over all rooms without them.
    for limited in (True, False):
        for _ in range(6):
            total = sum(areas)
            if not loose or total <= 0 or abs(total - spare) < 0.01:
                break
            factor = spare / total
            areas = [_scaled(room, area, factor, limited=limited) for room, area in zip(loose, areas)]
    found = {id(room): area for room, area in zip(loose, areas)}
    return tuple(
        top.changed(lambda room: room if room.fixed else msgspec.structs.replace(room, area=found[id(room)]))
        for top in rooms
    )


def _scaled(room: PlannedRoom, area: float, factor: float, *, limited: bool) -> float:
    if not limited:
        return max(area * factor, 1.0)
    strength = factor if not room.kind.flexible or factor < 1.0 else factor * 1.05
    return min(max(area * strength, room.least), room.most)


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
