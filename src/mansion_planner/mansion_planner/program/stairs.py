"""Stairs of a building: how high its storeys are, how large the stairs, and whether storeys call for a second one."""

from collections.abc import Collection, Sequence
from typing import Final

from mansion_knowledge import KnowledgeBase
from mansion_knowledge.norms import load_norms
from mansion_planner.program.allocation import Allocation
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.model import PUBLIC_STAIR, Storey
from mansion_planner.program.storey_rooms import base_rooms
from mansion_planner.program.storeys import entries_of, is_hall

__all__ = ["second_stair", "stair_size", "storey_height"]

_SLAB: Final = 0.25
"""Metres of a storey's height that the slab takes; the rest is the clear height."""

_HEIGHTS: Final = (2.65, 4.2)
"""Least and greatest height of a storey that stairs of one flight pair reach, metres."""

_DOMESTIC_STAIRS: Final = ((3.0, (2, 4)), (_HEIGHTS[1], (2, 5)))
"""Greatest storey height of a home, and width and length of a core with two flights of 0.88 m, metres."""


def storey_height(decisions: Decisions, storey: Storey) -> float:
    """Return the height of a storey: for the ceilings that the brief wants there, or as is usual for its use."""
    kinds = {room.kind.name for top in storey.rooms for room in top.each()}
    wished = [fact.height for fact in decisions.facts.heights if not fact.room_type or fact.room_type in kinds]
    if wished:
        return round(min(max(max(wished) + _SLAB, _HEIGHTS[0]), _HEIGHTS[1]), 3)
    return min(max(storey.use.height, 3.0), _HEIGHTS[1])


def stair_size(decisions: Decisions, storeys: Sequence[Storey]) -> tuple[int, int]:
    """Return the width and length of a stair core in whole metres: a home for one household has a small one.

    Storeys need not have their rooms yet, so ceilings that are asked for in some rooms count everywhere.
    """
    if any(storey.use.family != "home" for storey in storeys):
        return PUBLIC_STAIR
    wished = [fact.height + _SLAB for fact in decisions.facts.heights]
    height = min(max([storey_height(decisions, storey) for storey in storeys] + wished), _HEIGHTS[1])
    return next(size for most, size in _DOMESTIC_STAIRS if height <= most)


_LARGE: Final = 340.0
"""Area of a storey from which three storeys have two stairs in any public building, square metres."""

_LEAST: Final = 150.0
"""Area of a storey below which two stairs would take a quarter of it, square metres."""

_WIDEST_ROOM: Final = 150.0
"""Area of the largest room up to which both ends of the corridor may have a stair, square metres."""

_WIDEST_STATED, _WIDEST_OWN = 120.0, 200.0
"""The same where only the rules of exits ask for two stairs: of rooms of the brief, and of the type's own list."""

_WIDEST_GROUND = 300.0
"""The same of the ground floor, where a hall may close the bar with the stair in its corner."""

_WIDEST_BESIDE_HALL = 60.0
"""Area of the largest room beside a hall that has a stair at both ends of its north side, square metres."""

_DEPTH, _ASIDE = 13.0, 5.0
"""Usual depth of a bar of rooms along a corridor, and the way within a room to its door, metres."""

_ROOMS: Final = 0.75
"""Share of a storey that rooms take."""


def second_stair(
    decisions: Decisions, storeys: Sequence[Storey], allocation: Allocation, knowledge: KnowledgeBase
) -> str:
    """Return why a building has a second stair at the far end of its corridor; empty where it has one stair.

    Houses, storeys of one room and outlines that are set back or protrude have no place for it.
    """
    facts, hall = decisions.facts, is_hall(decisions)
    if (
        decisions.building.family == "home" or not (hall or decisions.building.parti == "spine")
        or facts.setback or facts.protruding or _has_storey_of_one_room(storeys, allocation)
    ):  # fmt: skip
        return ""
    halls = {storey.hub.name for storey in storeys if storey.index <= 1} if hall else set()
    asked = _stated(allocation, knowledge, halls)
    stated, own = (_widest(found, storeys) for found in (asked, _listed(storeys, knowledge)))
    if len(storeys) >= 3 and decisions.area >= _LARGE and max(*stated, *own) <= _WIDEST_ROOM and not hall:
        return "more than 340 m2 a storey"
    upper = max([stated[1], *(area for name, area in allocation.furniture.items() if name not in halls)])
    most = (_WIDEST_BESIDE_HALL, _WIDEST_BESIDE_HALL) if hall else (_WIDEST_STATED, _WIDEST_OWN)
    ground = most[0] if hall else _WIDEST_GROUND
    if (
        decisions.outline is not None or decisions.area < _LEAST
        or upper > most[0] or own[1] > most[1] or max(stated[0], own[0]) > ground
    ):  # fmt: skip
        return ""
    return _asked(decisions, storeys, allocation, knowledge)


def _has_storey_of_one_room(storeys: Sequence[Storey], allocation: Allocation) -> bool:
    """Whether a storey is to be a single room, which a corridor between two stairs would cut in two."""
    return any(storey.index in allocation.complete and len(allocation.wanted[storey.index]) == 1 for storey in storeys)


_Sizes = list[tuple[int, float]]
"""Storeys and square metres of rooms."""


def _stated(allocation: Allocation, knowledge: KnowledgeBase, halls: Collection[str]) -> _Sizes:
    """Return the rooms that the brief asks for, without those that are the hubs of `halls`."""
    return [
        (floor, fact.area or knowledge.room(fact.room_type).usual)
        for floor, facts in allocation.wanted.items()
        for fact in facts
        if fact.name not in halls
    ]


def _listed(storeys: Sequence[Storey], knowledge: KnowledgeBase) -> _Sizes:
    """Return the rooms of the building type's own lists, without the hubs of halls."""
    return [
        (storey.index, entry.area or knowledge.room(entry.room_type).usual)
        for storey in storeys
        for entry in entries_of(storey)
        if entry.room_type != storey.hub.name
    ]


def _widest(sizes: _Sizes, storeys: Sequence[Storey]) -> tuple[float, float]:
    """Return the area of the largest room of the ground floor, and of all other storeys."""
    ground = next((storey.index for storey in storeys if storey.role == "ground"), 1)
    return (
        max((area for floor, area in sizes if floor == ground), default=0.0),
        max((area for floor, area in sizes if floor != ground), default=0.0),
    )


def _asked(decisions: Decisions, storeys: Sequence[Storey], allocation: Allocation, knowledge: KnowledgeBase) -> str:
    """Return which rule of exits asks for two stairs; empty where none does."""
    norms, kind, family = load_norms(), decisions.building.name, decisions.building.family
    exits, travel = norms.rules["exits"], norms.rules["single_exit_travel"]
    upper = [storey for storey in storeys if storey.index >= 2]
    if not upper or not exits.holds_for(family):
        return ""
    if upper[-1].index > 2:
        return f"a storey {upper[-1].index} above the second"
    people = max(_occupants(decisions.area, storey, allocation, knowledge) for storey in upper)
    if people > exits.limit("upper"):
        return f"about {people:.0f} people on an upper storey"
    way = decisions.area / _DEPTH + _ASIDE
    limit = travel.limit(kind, family)
    return f"ways of more than {limit:.0f} m" if way > limit else ""


def _occupants(area: float, storey: Storey, allocation: Allocation, knowledge: KnowledgeBase) -> float:
    """Return about how many people a storey of `area` square metres holds, its rooms at their usual proportions."""
    rooms = [(room.kind.name, room.area) for top in base_rooms(storey, allocation, knowledge) for room in top.each()]
    for entry in entries_of(storey):
        if allocation.adds(entry.room_type, storey.index):
            added = [room for _ in range(max(entry.count, 1)) for room in allocation.added(entry, knowledge).each()]
            rooms += [(room.kind.name, room.area) for room in added]
    norms, total = load_norms(), sum(size for _, size in rooms)
    people = sum(norms.people(name, size, knowledge) for name, size in rooms)
    return people * _ROOMS * area / total if total else 0.0
