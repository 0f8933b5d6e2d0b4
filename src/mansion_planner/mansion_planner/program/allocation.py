"""Give every storey the rooms that the brief asks for, where it asks for them."""

from dataclasses import dataclass, field

from mansion_knowledge import KnowledgeBase, RoomType
from mansion_planner.brief.facts import RoomFact
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.inference import note
from mansion_planner.program.model import PlannedRoom, Storey
from mansion_planner.program.storeys import floors_of

__all__ = ["Allocation", "allocate", "planned_room"]

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
    unwanted : dict of int to set of str
        Room types that the brief does not want on a storey.
    complete : bool
        The brief wants no room but those that it names.
    """

    wanted: dict[int, list[RoomFact]] = field(default_factory=dict)
    settled: frozenset[str] = frozenset()
    unwanted: dict[int, set[str]] = field(default_factory=dict)
    complete: bool = False

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
        if stated & _KIN[0]:
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
        if fact.count is not None and not (fact.room_type in _EVERYWHERE and fact.count == 1):
            settled.update(next((kin for kin in _KIN if fact.room_type in kin), {fact.room_type}))
            if fact.count > 1:
                settled.update(_same_head(fact.name, knowledge))
        _distribute(fact, kind, decisions, storeys, allocation)
    allocation.settled = frozenset(settled | set(excluded))
    allocation.complete = bool(decisions.facts.only)
    for name, ref, _ in decisions.facts.excluded_on:
        for floor in floors_of((ref,), decisions):
            allocation.unwanted.setdefault(floor, set()).update({name}, _same_head(name, knowledge))
    return allocation


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


def planned_room(
    kind: RoomType, knowledge: KnowledgeBase, *, area: float | None = None, fact: RoomFact | None = None
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
