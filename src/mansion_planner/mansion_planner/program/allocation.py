"""Give every storey its rooms: those that the brief asks for where it asks for them, then the building type's own."""

from dataclasses import dataclass, field

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_planner.brief.facts import FloorRef, RoomFact
from mansion_planner.knowledge import BuildingType, KnowledgeBase, RoomEntry, RoomType
from mansion_planner.program.decisions import Decisions, quoted
from mansion_planner.program.inference import note
from mansion_planner.program.model import PlannedRoom, Storey

__all__ = [
    "Allocation",
    "allocate",
    "entries_of",
    "floors_of",
    "is_hall",
    "make_storeys",
    "planned_room",
]

_KIN = (
    frozenset({"bedroom", "master_bedroom", "guest_room", "childrens_room"}),
    frozenset({"kitchen", "open_kitchen", "kitchen_diner"}),
    frozenset({"hotel_room", "hotel_suite"}),
    frozenset({"apartment", "small_apartment", "studio_apartment"}),
)
_EVERYWHERE = frozenset({"restroom", "storage", "corridor", "lobby", "janitor_closet"})


@dataclass
class Allocation:
    """Counts of the rooms that the brief asks for, by storey.

    Attributes
    ----------
    wanted : dict of int to list of RoomFact
        One fact for each room, by storey.
    settled : frozenset of str
        Room types whose number the brief settles; no storey adds more.
    """

    wanted: dict[int, list[RoomFact]] = field(default_factory=dict)
    settled: frozenset[str] = frozenset()


def make_storeys(decisions: Decisions, knowledge: KnowledgeBase) -> list[Storey]:
    """Return the storeys from the lowest to the highest, each with its role, its use and its hub."""
    storeys = []
    hall = is_hall(decisions)
    for index in range(1 - decisions.basements, decisions.floors + 1):
        use, role = _use(decisions, knowledge, index), _role(decisions, index)
        entrance = role in ("ground", "single")
        hub = knowledge.room(use.hub if entrance else use.hub_upper)
        if role == "basement" and use.parti != "hall":
            hub = knowledge.room("corridor" if use.family != "home" else "hallway")
        elif use.parti == "hall" and not entrance:
            hub = knowledge.room(_upper_hub(use))
        lead = None
        if use.parti == "hall" and not hall and role != "basement":
            lead = knowledge.room(use.hub)
            hub = knowledge.room(_passage_hub(decisions, entrance))
        storeys.append(Storey(index=index, role=role, use=use, hub=hub, lead=lead))
    _mark_copies(decisions, storeys)
    _shape_storeys(decisions, storeys)
    return storeys


def _passage_hub(decisions: Decisions, entrance: bool) -> str:
    if decisions.building.family == "home":
        return "hallway"
    return "lobby" if entrance else "corridor"


def _mark_copies(decisions: Decisions, storeys: list[Storey]) -> None:
    """Let storeys repeat the lowest of their group.

    Raises
    ------
    MansionError
        ``CONTRADICTION`` when the brief gives rooms to one storey of an identical group only.
    """
    by_index = {storey.index: storey for storey in storeys}
    for fact in decisions.facts.copies:
        group = [f for f in floors_of((fact.first,), decisions) if f in by_index]
        if fact.first.kind == "every":
            group = [f for f in group if f >= 1]
        for room in decisions.facts.rooms:
            pinned = set(floors_of(room.floors, decisions)) & set(group)
            if (
                pinned
                and not pinned >= set(group)
                and group[0] not in pinned
                and any(ref.kind in ("number", "top") for ref in room.floors)
            ):
                raise MansionError(
                    ErrorCode.CONTRADICTION,
                    f"{quoted(fact.span)} makes storeys identical, {quoted(room.span)} is for storey "
                    f"{min(pinned)} alone; keep one of the two",
                    path="$.description",
                    details={
                        "first": fact.span.words,
                        "second": room.span.words,
                        "stage": "program",
                    },
                )
        for floor in group[1:]:
            by_index[floor].copy = group[0]
            by_index[floor].role = by_index[group[0]].role
            by_index[floor].use = by_index[group[0]].use
            by_index[floor].hub = by_index[group[0]].hub
        if len(group) > 1:
            note(
                decisions.trace,
                fact.span,
                f"storeys {group[1]} to {group[-1]} repeat storey {group[0]}",
            )


def _shape_storeys(decisions: Decisions, storeys: list[Storey]) -> None:
    """Set upper storeys back, or let the ground floor protrude, where the brief says so."""
    facts = decisions.facts
    if facts.setback and decisions.floors > 1:
        depth = 3.0 if decisions.area < 260 else 4.0
        for storey in storeys:
            if storey.index >= 2:
                storey.setback = depth
        note(
            decisions.trace,
            facts.setback[0],
            f"storeys above the ground floor are {depth:g} m shorter",
        )
    elif facts.protruding and decisions.floors > 1:
        for storey in storeys:
            if storey.index <= 1:
                storey.extension = 4.0
        note(decisions.trace, facts.protruding[0], "the ground floor protrudes by 4 m")


def is_hall(decisions: Decisions) -> bool:
    """Whether the main room is the hub: the type is planned so, and the outline is a plain rectangle."""
    plain = not decisions.facts.shapes or decisions.facts.shapes[0][0] in ("rectangle", "square")
    return decisions.building.parti == "hall" and plain and not decisions.free_form


def _upper_hub(use: BuildingType) -> str:
    return {"sales_area": "sales_area", "living_room": "hallway"}.get(use.hub, use.hub_upper)


def _use(decisions: Decisions, knowledge: KnowledgeBase, index: int) -> BuildingType:
    for fact in decisions.facts.uses:
        if index in floors_of(fact.floors, decisions):
            return knowledge.buildings[fact.building_type]
    return decisions.building


def _role(decisions: Decisions, index: int) -> str:
    if index < 1:
        return "basement"
    if decisions.floors == 1:
        return "single"
    if index == 1:
        return "ground"
    if index == decisions.floors and decisions.floors >= 3:
        return "top"
    return "second" if index == 2 and decisions.floors >= 4 else "upper"


def entries_of(storey: Storey) -> tuple[RoomEntry, ...]:
    """Return the room list that the building type has for the storey's role."""
    lists = storey.use.storeys
    fallback = {
        "ground": ("ground", "single"),
        "second": ("second", "upper", "ground", "single"),
        "top": ("top", "upper", "ground", "single"),
        "upper": ("upper", "ground", "single"),
        "basement": ("basement",),
        "single": ("single",),
    }[storey.role]
    lead = (RoomEntry(storey.lead.name),) if storey.lead is not None else ()
    for role in fallback:
        if role in lists:
            return lead + lists[role]
    return (RoomEntry("storage", 40.0), RoomEntry("mechanical_room"), RoomEntry("electrical_room"))


def floors_of(refs: tuple[FloorRef, ...], decisions: Decisions) -> list[int]:
    """Return the storeys that floor references mean, ascending."""
    top = decisions.floors
    found: set[int] = set()
    for ref in refs:
        if ref.kind in ("number", "range"):
            found.update(range(ref.first, ref.last + 1))
        elif ref.kind in ("top", "roof"):
            found.update(range(max(top - max(ref.first, 1) + 1, 1), top + 1))
        elif ref.kind == "every":
            found.update(range(1, top + 1))
        elif ref.kind == "upper":
            found.update(range(2, top + 1) if top > 1 else [1])
        elif ref.kind == "middle":
            found.update(range(2, top) if top > 2 else [top])
        elif ref.kind == "lower":
            found.update(range(1, max(top // 2, 1) + 1))
        elif ref.kind == "basement":
            found.add(0)
    return sorted(found)


def people_rooms(decisions: Decisions, knowledge: KnowledgeBase) -> list[RoomFact]:
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
        if stated & _KIN[0]:
            return []
        grown = people.count if people.noun not in ("kid", "child") else people.count + 2
        count = max(1, min(grown - 1, 8))
        note(decisions.trace, people.span, f"{count} bedrooms for {people.count} people")
        return [RoomFact("bedroom", "bedroom", people.span, count)]
    if seats is None or people.noun in (
        "employee",
        "worker",
        "staff",
        "visitor",
        "teacher",
        "family",
    ):
        return []
    kind = knowledge.room(seats.room_type)
    if kind.name in stated:
        return []
    count = max(1, -(-people.count // int(seats.area or 1)))
    note(decisions.trace, people.span, f"{count} x {kind.name} for {people.count} people")
    return [RoomFact(kind.name, kind.name, people.span, count)]


def allocate(decisions: Decisions, knowledge: KnowledgeBase, storeys: list[Storey]) -> Allocation:
    """Distribute the rooms that the brief asks for over the storeys.

    Raises
    ------
    MansionError
        ``CONTRADICTION`` for a storey that does not exist, or a room that is asked for and excluded.
    """
    allocation = Allocation({storey.index: [] for storey in storeys})
    excluded = dict(decisions.facts.excluded)
    settled: set[str] = set()
    for fact in [*decisions.facts.rooms, *people_rooms(decisions, knowledge)]:
        if fact.room_type in excluded:
            raise MansionError(
                ErrorCode.CONTRADICTION,
                f"{quoted(fact.span)} asks for a room that {quoted(excluded[fact.room_type])} excludes; keep one",
                path="$.description",
                details={
                    "first": fact.span.words,
                    "second": excluded[fact.room_type].words,
                    "stage": "program",
                },
            )
        kind = knowledge.room(fact.room_type)
        if fact.count is not None and not (fact.room_type in _EVERYWHERE and fact.count == 1):
            settled.update(next((kin for kin in _KIN if fact.room_type in kin), {fact.room_type}))
        _distribute(fact, kind, decisions, storeys, allocation)
    allocation.settled = frozenset(settled | set(excluded))
    return allocation


def _distribute(
    fact: RoomFact,
    kind: RoomType,
    decisions: Decisions,
    storeys: list[Storey],
    allocation: Allocation,
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
        floor = min(floors, key=lambda f: (_load(allocation, f, decisions), f))
        allocation.wanted[floor].append(fact)
    note(decisions.trace, fact.span, f"{fact.name} x{count}")


def _beside(fact: RoomFact, decisions: Decisions, allocation: Allocation) -> list[int]:
    """Return the storeys of the rooms that this one is to stand beside, once they have theirs."""
    wanted = {a.second if a.first == fact.room_type else a.first for a in decisions.facts.adjacent
              if fact.room_type in (a.first, a.second)}  # fmt: skip
    return [
        floor for floor, facts in sorted(allocation.wanted.items())
        if any(other.room_type in wanted for other in facts)
    ]  # fmt: skip


def _load(allocation: Allocation, floor: int, decisions: Decisions) -> float:
    """How full a storey is with what the brief asks for."""
    del decisions
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


def planned_room(
    kind: RoomType,
    knowledge: KnowledgeBase,
    *,
    area: float | None = None,
    fact: RoomFact | None = None,
) -> PlannedRoom:
    """Make a room of a type with its suite; the area of a fact is kept."""
    stated = fact is not None and fact.area is not None
    wish = fact.area if fact is not None and fact.area is not None else area or kind.usual
    room = PlannedRoom(
        id=fact.name if fact is not None else kind.name,
        kind=kind,
        area=wish,
        least=wish if stated else min(kind.least, wish),
        most=wish if stated else max(kind.most, wish),
        fixed=stated,
        stated=fact is not None,
        notes=f"from {fact.span.words!r}" if fact is not None else "",
    )
    for entry in kind.suite:
        child = knowledge.room(entry.room_type)
        room.suite.append(planned_room(child, knowledge, area=entry.area))
    return room
