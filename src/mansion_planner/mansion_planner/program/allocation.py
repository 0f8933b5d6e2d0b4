"""Give every storey its rooms: those that the brief asks for where it asks for them, then the building type's own."""

from dataclasses import dataclass, field

from mansion_msgs_py.errors import ErrorCode, MansionError

from mansion_planner.brief.facts import FloorRef, RoomFact
from mansion_planner.knowledge import BuildingType, KnowledgeBase, RoomEntry, RoomType
from mansion_planner.program.decisions import Decisions, note, quoted
from mansion_planner.program.model import PlannedRoom, Storey

__all__ = ["Allocation", "allocate", "floors_of", "make_storeys"]

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
    for index in range(1 - decisions.basements, decisions.floors + 1):
        use, role = _use(decisions, knowledge, index), _role(decisions, index)
        entrance = role in ("ground", "single")
        hub = knowledge.room(use.hub if entrance else use.hub_upper)
        if role == "basement" and use.parti != "hall":
            hub = knowledge.room("corridor" if use.family != "home" else "hallway")
        elif use.parti == "hall" and not entrance:
            hub = knowledge.room(_upper_hub(use))
        storeys.append(Storey(index=index, role=role, use=use, hub=hub))
    return storeys


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
    for role in fallback:
        if role in lists:
            return lists[role]
    return (RoomEntry("storage", 40.0), RoomEntry("mechanical_room"), RoomEntry("electrical_room"))


def floors_of(refs: tuple[FloorRef, ...], decisions: Decisions) -> list[int]:
    """Return the storeys that floor references mean, ascending."""
    top, found = decisions.floors, set()
    for ref in refs:
        if ref.kind in ("number", "range"):
            found.update(range(ref.first, ref.last + 1))
        elif ref.kind in ("top", "roof"):
            found.add(top)
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


def allocate(decisions: Decisions, knowledge: KnowledgeBase, storeys: list[Storey]) -> Allocation:
    """Distribute the rooms that the brief asks for over the storeys.

    Raises
    ------
    MansionError
        ``CONTRADICTION`` for a storey that does not exist, or a room that is asked for and excluded.
    """
    allocation = Allocation({storey.index: [] for storey in storeys})
    excluded = {name: span for name, span in decisions.facts.excluded}
    settled: set[str] = set()
    for fact in decisions.facts.rooms:
        if fact.room_type in excluded:
            raise MansionError(
                ErrorCode.CONTRADICTION,
                f"{quoted(fact.span)} asks for a room that {quoted(excluded[fact.room_type])} excludes; keep one",
                path="$.description",
                details={"first": fact.span.words, "second": excluded[fact.room_type].words, "stage": "program"},
            )
        kind = knowledge.room(fact.room_type)
        if fact.count is not None and not (fact.room_type in _EVERYWHERE and fact.count == 1):
            settled.update(next((kin for kin in _KIN if fact.room_type in kin), {fact.room_type}))
        _distribute(fact, kind, decisions, storeys, allocation)
    allocation.settled = frozenset(settled | set(excluded))
    return allocation


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
    for _ in range(count):
        floor = min(floors, key=lambda f: (_load(allocation, f, decisions), f))
        allocation.wanted[floor].append(fact)
    note(decisions.trace, fact.span, f"{fact.name} x{count}")


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
    )
    for entry in kind.suite:
        child = knowledge.room(entry.room_type)
        room.suite.append(planned_room(child, knowledge, area=entry.area))
    return room
