"""Which furniture of the brief goes into which room."""

from mansion_msgs_py.program import RequestedObject
from mansion_planner.brief.facts import ObjectFact
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.model import PlannedRoom, Storey
from mansion_planner.program.storeys import floors_of

__all__ = ["assign_furniture", "requested_objects"]


def assign_furniture(decisions: Decisions, storeys: list[Storey]) -> None:
    """Decide which planned rooms get the furniture that the brief wants, and how many pieces of it.

    A number for "each" is for every room of the name; any other is shared out among them. Furniture without a room goes
    to the room that is most likely to have it: the largest of those that the brief names, else the largest of all.
    """
    rooms = [(storey, room) for storey in storeys if storey.copy is None for top in storey.rooms for room in top.each()]
    copies = {storey.index: sum(other.copy == storey.index for other in storeys) for storey in storeys}
    for fact in decisions.facts.objects:
        if not fact.category:
            continue
        matching = _matching(decisions, fact, rooms)
        if not matching:
            continue
        count = 0 if fact.excluded else fact.count if fact.count is not None else 2
        if fact.each or fact.excluded or (fact.room and fact.count == 1 and not _singled(fact, matching)):
            shares = [count] * len(matching)
        elif not fact.room:
            matching, shares = [max(matching, key=_likelihood)], [count]
        else:
            total = sum(1 + copies[storey.index] for storey, _ in matching)
            shares = [-(-count // total)] * len(matching) if total > 1 else [count]
        for (storey, room), share in zip(matching, shares):
            decisions.furniture.setdefault((storey.index, room.id), []).append(
                RequestedObject(category=fact.category, count=share, words=fact.words)
            )


def _singled(fact: ObjectFact, matching: list[tuple[Storey, PlannedRoom]]) -> bool:
    return len(matching) > 1 and not fact.each


def _matching(
    decisions: Decisions, fact: ObjectFact, rooms: list[tuple[Storey, PlannedRoom]]
) -> list[tuple[Storey, PlannedRoom]]:
    floors = set(floors_of(fact.floors, decisions))
    named = [(s, r) for s, r in rooms if not floors or s.index in floors]
    if not fact.room:
        return named
    own = [(s, r) for s, r in named if r.base == fact.room]
    return own or [(s, r) for s, r in named if r.kind.name == fact.room_type]


def _likelihood(entry: tuple[Storey, PlannedRoom]) -> tuple[bool, bool, float]:
    _, room = entry
    return room.stated, room.kind.zone == "public", room.area


def requested_objects(decisions: Decisions, room: PlannedRoom, storey: Storey) -> list[RequestedObject]:
    """Return the furniture that `assign_furniture` gave a room; a storey that repeats another has the same."""
    return decisions.furniture.get((storey.copy or storey.index, room.id), [])
