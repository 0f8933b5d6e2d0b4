"""Choose the rooms of each storey: those that the brief asks for, and its type's own, with their areas."""

from dataclasses import dataclass, field, replace

from mansion_knowledge import KnowledgeBase, RoomEntry, RoomType
from mansion_planner.brief.facts import RoomFact
from mansion_planner.program.decisions import Decisions, note
from mansion_planner.program.furniture_areas import furniture_area, furniture_areas, usual_number
from mansion_planner.program.household import household_of, is_whole, main_room, private_types
from mansion_planner.program.model import PlannedRoom, Storey
from mansion_planner.program.storeys import entries_of, floors_of

__all__ = ["Allocation", "allocate", "base_rooms", "fill_storey", "fit_areas", "hub_area", "name_rooms", "planned_room"]


@dataclass
class Allocation:
    """Counts of the rooms that the brief asks for, by storey.

    Attributes
    ----------
    wanted : dict of int to list of RoomFact
        One fact for each room, by storey.
    settled : frozenset of str
        Room types whose number the brief settles; no storey adds more.
    unwanted : dict of int to set of str
        Room types that the brief does not want on a storey.
    complete : bool
        The brief wants no room but those that it names.
    furniture : dict of str to float
        Square metres that the furniture wanted in rooms of a name needs.
    households : dict of str to RoomFact
        What every unit holds that a storey adds by itself, by the room type that it counts as.
    """

    wanted: dict[int, list[RoomFact]] = field(default_factory=dict)
    settled: frozenset[str] = frozenset()
    unwanted: dict[int, set[str]] = field(default_factory=dict)
    complete: bool = False
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
        return not self.complete and room_type not in self.settled and room_type not in self.unwanted.get(floor, ())


def _people_rooms(decisions: Decisions, knowledge: KnowledgeBase) -> list[RoomFact]:
    """Return the rooms that stated occupants need: classrooms for pupils, bedrooms for a family."""
    facts, seats = decisions.facts, decisions.building.seats
    if not facts.occupants:
        return []
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
            return []
        grown = people.count if people.noun not in ("kid", "child") else people.count + 2
        count = max(1, min(grown - 1, 8))
        note(decisions.trace, people.span, f"{count} bedrooms for {people.count} people")
        return [RoomFact("bedroom", "bedroom", people.span, count)]
    if seats is None or people.noun in ("employee", "worker", "staff", "visitor", "teacher", "family"):
        return []
    kind = knowledge.room(seats.room_type)
    if kind.name in stated:
        return []
    count = max(1, -(-people.count // int(seats.area or 1)))
    note(decisions.trace, people.span, f"{count} x {kind.name} for {people.count} people")
    return [RoomFact(kind.name, kind.name, people.span, count)]


MANY = 6
"""From so many pieces on, furniture that the brief puts in no room gets one that usually has as many."""


def _furniture_rooms(
    decisions: Decisions, knowledge: KnowledgeBase, storeys: list[Storey]
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


def allocate(decisions: Decisions, knowledge: KnowledgeBase, storeys: list[Storey]) -> Allocation:
    """Distribute the rooms that the brief asks for over the storeys.

    A room that the brief asks for by name is built although another statement excludes its kind.
    """
    allocation = Allocation({storey.index: [] for storey in storeys})
    wanted = {fact.room_type for fact in decisions.facts.rooms}
    excluded = {name for name, _ in decisions.facts.excluded} - wanted
    settled: set[str] = set()
    for fact in [*decisions.facts.rooms, *_people_rooms(decisions, knowledge)]:
        kind = knowledge.room(fact.room_type)
        if fact.count is not None and not (kind.common and fact.count == 1):
            settled.update(name for name, other in knowledge.rooms.items() if other.counts_as == kind.counts_as)
            settled.update(next((group for group in _SAME_USE if kind.name in group), ()))
            if fact.count > 1:
                settled.update(_same_head(fact.name, knowledge))
        _distribute(fact, kind, decisions, storeys, allocation)
    allocation.settled = frozenset(settled | set(excluded))
    allocation.complete = bool(decisions.facts.only)
    allocation.furniture = furniture_areas(decisions.facts.rooms, decisions.facts.objects)
    for fact, area in _furniture_rooms(decisions, knowledge, storeys):
        allocation.furniture[fact.name] = max(area, allocation.furniture.get(fact.name, 0.0))
        if fact not in decisions.facts.rooms:
            _distribute(fact, knowledge.room(fact.room_type), decisions, storeys, allocation)
    for name, ref, _ in decisions.facts.excluded_on:
        for floor in floors_of((ref,), decisions):
            like = next((group for group in _SAME_USE if name in group), frozenset())
            allocation.unwanted.setdefault(floor, set()).update({name}, like, _same_head(name, knowledge))
    allocation.households = {knowledge.room(fact.room_type).counts_as: fact for fact in decisions.facts.households}
    for floor, facts in allocation.wanted.items():
        allocation.unwanted.setdefault(floor, set()).update(private_types(facts, knowledge))
    return allocation


_SAME_USE = (
    frozenset({"treatment_room", "dental_room", "consultation_room"}),
    frozenset({"cinema_hall", "auditorium"}),
    frozenset({"toilet", "restroom"}),
    frozenset({"classroom", "training_room"}),
    frozenset({"dorm_room", "hostel_dorm", "bunk_room", "holding_cell"}),
)
"""Room types that stand for each other: a stated number of one leaves no room for another."""

_GENERAL_HEADS = frozenset({"room", "hall", "area", "store", "storage", "space", "centre", "center", "section"})


def _same_head(name: str, knowledge: KnowledgeBase) -> set[str]:
    """Return the room types whose name ends in the same noun: a number of "offices" holds for every kind of office."""
    head = name.rpartition("_")[2]
    if head in _GENERAL_HEADS:
        return set()
    return {room for room in knowledge.rooms if room.rpartition("_")[2] == head}


def _distribute(
    fact: RoomFact, kind: RoomType, decisions: Decisions, storeys: list[Storey], allocation: Allocation
) -> None:
    above = [storey.index for storey in storeys if storey.index >= 1]
    count = fact.count if fact.count is not None else 2
    if fact.floors:
        chosen = [f for f in floors_of(fact.floors, decisions) if f in allocation.wanted]
        if not chosen:
            chosen = [above[-1]]
        for number, floor in enumerate(chosen):
            each = count if fact.each else count // len(chosen) + (number < count % len(chosen))
            allocation.wanted[floor] += [fact] * each
        names = ", ".join(str(floor) for floor in chosen)
        note(decisions.trace, fact.span, f"{fact.name} x{count} on storey {names}")
        return
    if fact.each:
        for floor in above:
            allocation.wanted[floor] += [fact] * count
        note(decisions.trace, fact.span, f"{fact.name} x{count} on every storey")
        return
    floors = _preferred(kind, decisions, storeys)
    beside = _beside(fact, decisions, allocation)
    if beside and count == 1:
        floors = beside
    for _ in range(count):
        floor = min(floors, key=lambda f: (_load(allocation, f), f))
        allocation.wanted[floor].append(fact)
    note(decisions.trace, fact.span, f"{fact.name} x{count}")


def _beside(fact: RoomFact, decisions: Decisions, allocation: Allocation) -> list[int]:
    """Return the storeys of the rooms that this one is to stand beside, once they have theirs."""
    wanted = {a.second_name if a.first_name == fact.name else a.first_name for a in decisions.facts.adjacent
              if fact.name in (a.first_name, a.second_name)}  # fmt: skip
    return [
        floor for floor, facts in sorted(allocation.wanted.items())
        if any(other.name in wanted for other in facts)
    ]  # fmt: skip


def _load(allocation: Allocation, floor: int) -> float:
    """How full a storey is with what the brief asks for."""
    return sum(fact.area or 14.0 for fact in allocation.wanted[floor])


def _preferred(kind: RoomType, decisions: Decisions, storeys: list[Storey]) -> list[int]:
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
    wish = fact.area if fact is not None and fact.area is not None else area or kind.usual
    furnished = fact is not None and wish > kind.usual
    room = PlannedRoom(
        id=fact.name if fact is not None else kind.name,
        kind=kind,
        area=wish,
        least=wish if stated else max(min(kind.least, wish), _TIGHT * wish if furnished else 0.0),
        most=wish if stated else max(kind.most, 1.15 * wish if furnished else wish),
        fixed=stated,
        stated=fact is not None,
        notes=f"from {fact.span.words!r}" if fact is not None else "",
        base=fact.name if fact is not None else kind.name,
        label=fact.label if fact is not None else "",
    )
    stated_suite = fact.suite if fact is not None else ()
    for child in stated_suite:
        room.suite += [
            planned_room(knowledge.room(child.room_type), knowledge, fact=child) for _ in range(child.count or 1)
        ]
    taken = {knowledge.room(child.room_type).zone for child in stated_suite}
    for entry in kind.suite:
        child_kind = knowledge.room(entry.room_type)
        if not stated_suite or child_kind.zone not in taken:
            room.suite.append(planned_room(child_kind, knowledge, area=entry.area))
    return room


def _planned_unit(kind: RoomType, knowledge: KnowledgeBase, fact: RoomFact) -> PlannedRoom:
    """Make the main room of a unit with the rooms that are reached through it; all share a stated area."""
    whole = fact.area if is_whole(fact, knowledge) else None
    main = main_room(fact, knowledge)
    stated, added = household_of(fact, knowledge)
    own = main.area if main is not None else None if whole else fact.area
    room = planned_room(kind, knowledge, fact=replace(fact, unit=False, suite=(), area=own))
    if kind.zone == "public" and not (kind.unit or room.fixed):
        room.area = min(room.area, max(kind.least, _HALL))
    room.notes = f"from {fact.label!r}"
    room.suite = [
        planned_room(knowledge.room(child.room_type), knowledge, fact=child)
        for child in stated
        for _ in range(child.count or 2)
    ]
    room.suite += [
        planned_room(knowledge.room(entry.room_type), knowledge, area=entry.area)
        for entry in added
        for _ in range(entry.count)
    ]
    if main is not None:
        room.serves_as = tuple(dict.fromkeys((main.room_type, main.name)))
    if whole:
        _share_area(room.each(), whole)
    return room


_HALL = 20.0
"""Square metres of the room that a cluster's or an office unit's other rooms are reached through."""

_LEAST_SHARE = 0.4
"""Of its usual area, what a room of a dwelling keeps whatever the area of the whole."""


def _share_area(rooms: list[PlannedRoom], area: float) -> None:
    """Scale the rooms of a unit without a stated area of their own so that all have `area` together, square metres."""
    loose = [room for room in rooms if not room.fixed]
    spare = area - sum(room.area for room in rooms if room.fixed)
    factor = max(spare / max(sum(room.area for room in loose), 1.0), _LEAST_SHARE)
    for room in loose:
        room.area *= factor
        room.least = room.most = room.area
        room.fixed = True


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
    used = sum(room.gross for room in rooms)
    repeats = []
    for entry in entries_of(storey):
        kind = knowledge.room(entry.room_type)
        if entry.repeat:
            repeats.append(entry)
        if not allocation.adds(kind.name, storey.index) or kind.name == storey.hub.name:
            continue
        count = 0 if entry.repeat else max(entry.count - (kind.name in present), 0)
        for _ in range(count):
            room = allocation.added(entry, knowledge)
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
    _top_up(storey, allocation, knowledge, rooms, budget)
    return rooms


def _top_up(
    storey: Storey, allocation: Allocation, knowledge: KnowledgeBase, rooms: list[PlannedRoom], budget: float
) -> None:
    """Add rooms of general use where the brief settles the number of those that would fill the storey."""
    kinds = [knowledge.room(name) for name in knowledge.groups.filler_of(storey.use.family)]
    kinds = [kind for kind in kinds if allocation.adds(kind.name, storey.index)]
    for kind in kinds * 3:
        used = sum(room.gross for room in rooms)
        if used >= 0.82 * budget or len(rooms) >= MOST_ROOMS:
            return
        if used + 0.8 * kind.usual <= budget:
            rooms.append(planned_room(kind, knowledge))


def fit_areas(rooms: list[PlannedRoom], capacity: float) -> float:
    """Scale the rooms to fill `capacity`: stated areas stay, flexible rooms give and take first.

    Returns
    -------
    float
        Area that is left when every room is at its limit (negative when they do not fit).
    """
    every = [room for top in rooms for room in top.each()]
    fixed = sum(room.area for room in every if room.fixed)
    loose = [room for room in every if not room.fixed]
    spare = capacity - fixed
    # A room that meets its limit leaves its share to the others, so the scale is sought anew a few times. Only what
    # cannot be met within the limits is spread over all rooms without them.
    for limited in (True, False):
        for _ in range(6):
            total = sum(room.area for room in loose)
            if not loose or total <= 0 or abs(total - spare) < 0.01:
                break
            _scale(loose, spare / total, limited=limited)
    return capacity - sum(room.area for room in every)


def _scale(rooms: list[PlannedRoom], factor: float, *, limited: bool) -> None:
    for room in rooms:
        strength = factor if not room.kind.flexible or factor < 1.0 else factor * 1.05
        if limited:
            room.area = min(max(room.area * strength, room.least), room.most)
        else:
            room.area = max(room.area * factor, 1.0)


_CIRCULATION = frozenset({"corridor", "wing", "far", "stair", "elevator"})


def name_rooms(storey: Storey, hub_id: str) -> None:
    """Number the rooms of a storey: ``meeting_room_1``; a name that occurs once stays bare.

    No room takes the name of the hub, of a corridor that the sketch adds, or of a core.
    """
    counts: dict[str, int] = {}
    every = [room for top in storey.rooms for room in top.each()]
    for room in every:
        if room.id in _CIRCULATION:
            room.id = f"{room.id}_area"
        counts[room.id] = counts.get(room.id, 0) + 1
    used = {hub_id} | {name for name, count in counts.items() if count == 1 and name != hub_id}
    seen: dict[str, int] = {}
    for room in every:
        base = room.id
        if counts[base] == 1 and base != hub_id:
            continue
        while room.id == base or room.id in used:
            seen[base] = seen.get(base, 0) + 1
            room.id = f"{base}_{seen[base]}"
        used.add(room.id)
