"""The storeys of a building: role, use, hub, which repeat another, and what rooms the building type gives to each."""

from collections.abc import Sequence
from dataclasses import replace

from mansion_knowledge import BuildingType, KnowledgeBase, RoomEntry, is_class
from mansion_msgs_py.program import Downgrade, TraceEntry
from mansion_planner.brief.facts import FloorRef, RoomFact
from mansion_planner.program.decisions import Decisions, conflict, note
from mansion_planner.program.model import Storey
from mansion_planner.program.step_record import Record

__all__ = ["entries_of", "floors_of", "is_hall", "make_storeys"]


def make_storeys(decisions: Decisions, knowledge: KnowledgeBase) -> tuple[list[Storey], Record]:
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
            led = entrance or _upper_hub(use) == use.hub
            excluded = any(name == use.hub for name, _ in decisions.facts.excluded)
            lead = knowledge.room(use.hub) if led and not excluded else None
            hub = knowledge.room(_passage_hub(decisions, entrance=entrance))
        if not hall and hub.name == "lobby" and any(hub.name in (a.first, a.second) for a in decisions.facts.apart):
            hub = knowledge.room("corridor")  # what all others are reached through is beside all of them
        storeys.append(Storey(index=index, role=role, use=use, hub=hub, lead=lead))
    marked, repeats = _with_copies(decisions, storeys)
    shaped, setbacks = _shaped(decisions, marked)
    return shaped, repeats + setbacks


def _passage_hub(decisions: Decisions, *, entrance: bool) -> str:
    if decisions.building.family == "home":
        return next((fact.room_type for fact in decisions.facts.rooms if fact.room_type in _PASSAGES), "hallway")
    return "lobby" if entrance else "corridor"


def _with_copies(decisions: Decisions, storeys: Sequence[Storey]) -> tuple[list[Storey], Record]:
    """Return the storeys, those that repeat the lowest of their group marked; one with rooms of its own is left out."""
    trace: list[TraceEntry] = []
    downgrades: list[Downgrade] = []
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
                words = f'"{room.span.words}" is for storey {min(pinned)} alone'
                downgrades.append(conflict(fact.span.words, "storeys that differ", words, min(pinned)))
                group = [floor for floor in group if floor not in pinned]
        for floor in group[1:]:
            lowest = by_index[group[0]]
            by_index[floor] = replace(
                by_index[floor], copy=lowest.index, role=lowest.role, use=lowest.use, hub=lowest.hub
            )
        if len(group) > 1:
            note(trace, fact.span, f"storeys {group[1]} to {group[-1]} repeat storey {group[0]}")
    return list(by_index.values()), Record(tuple(trace), tuple(downgrades))


def _shaped(decisions: Decisions, storeys: Sequence[Storey]) -> tuple[list[Storey], Record]:
    """Return the storeys, the upper ones set back or the ground floor protruding where the brief says so."""
    facts = decisions.facts
    trace: list[TraceEntry] = []
    shaped = list(storeys)
    if facts.setback and decisions.floors > 1:
        depth = 3.0 if decisions.area < 260 else 4.0
        shaped = [replace(storey, setback=depth) if storey.index >= 2 else storey for storey in storeys]
        note(trace, facts.setback[0], f"storeys above the ground floor are {depth:g} m shorter")
    elif facts.protruding and decisions.floors > 1:
        shaped = [replace(storey, extension=4.0) if storey.index <= 1 else storey for storey in storeys]
        note(trace, facts.protruding[0], "the ground floor protrudes by 4 m")
    return shaped, Record(tuple(trace))


def is_hall(decisions: Decisions) -> bool:
    """Whether the main room is the hub.

    The type is planned so, the outline is a plain rectangle, and the brief neither excludes that room nor gives it a
    name or an area of its own. A home with a stair, with a hallway that the brief asks for or with three bedrooms has a
    hallway as its hub: nobody wants the living room to be the way to all of them.
    """
    facts, hub = decisions.facts, decisions.building.hub
    storeyed = decisions.floors + decisions.basements > 1
    passage = any(fact.room_type in _PASSAGES for fact in facts.rooms)
    bedrooms = sum(fact.count or 1 for fact in facts.rooms if is_class(fact.room_type, "sleeping"))
    if decisions.building.family == "home" and (storeyed or passage or bedrooms >= _APART):
        return False
    plain = not facts.shapes or facts.shapes[0][0] in ("rectangle", "square")
    named = any(fact.room_type == hub and (fact.name != hub or fact.area) for fact in facts.rooms)
    own = named and not decisions.building.alone
    excluded = any(name == hub for name, _ in facts.excluded)
    return decisions.building.parti == "hall" and plain and not decisions.free_form and not own and not excluded


_APART = 3
"""So many bedrooms of a home are reached from a hallway."""

_PASSAGES = frozenset({"corridor", "hallway"})
"""Types of the room that others are reached from in a home whose living room is not."""


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
    if index == decisions.floors and decisions.floors >= 3 and not _is_like_those_below(decisions, index):
        return "top"
    return "second" if index == 2 and decisions.floors >= 4 else "upper"


def _is_like_those_below(decisions: Decisions, index: int) -> bool:
    """Whether the brief tells a storey together with the one below: "each of the three floors above has six rooms"."""

    def told(floor: int) -> list[RoomFact]:
        facts = [fact for fact in decisions.facts.rooms if not any(ref.kind == "every" for ref in fact.floors)]
        return [fact for fact in facts if floor in floors_of(fact.floors, decisions)]

    here = told(index)
    each = all({"each", "every"} & set(ref.span.words.lower().split()) for fact in here for ref in fact.floors)
    return bool(here) and here == told(index - 1) and each


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
        elif ref.kind == "below_top":
            found.add(max(top - ref.first, 1))
        elif ref.kind == "not_top":
            found.update(range(1, top) if top > 1 else [1])
        elif ref.kind in ("odd", "even"):
            found.update(range(1 if ref.kind == "odd" else 2, top + 1, 2))
        elif ref.kind == "upper":
            found.update(range(2, (min(ref.first + 1, top) if ref.first else top) + 1) if top > 1 else [1])
        elif ref.kind == "middle":
            found.update(range(2, top) if top > 2 else [top])
        elif ref.kind == "lower":
            found.update(range(1, max(top // 2, 1) + 1))
        elif ref.kind == "basement":
            found.add(0)
    return sorted(found)
