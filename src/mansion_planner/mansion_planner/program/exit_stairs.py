"""Whether the occupants of upper storeys, or their way to the stair, ask for a second one."""

from collections.abc import Sequence
from typing import Final

from mansion_knowledge import KnowledgeBase
from mansion_knowledge.norms import load_norms
from mansion_planner.program.allocation import Allocation
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.model import Storey
from mansion_planner.program.storey_rooms import base_rooms
from mansion_planner.program.storeys import entries_of

__all__ = ["second_stair"]

_LARGE: Final = 340.0
"""Area of a storey from which three storeys have two stairs in any public building, square metres."""

_LEAST: Final = 150.0
"""Area of a storey below which two stairs would take a quarter of it, square metres."""

_WIDEST_ROOM: Final = 150.0
"""Area of the largest room up to which both ends of the corridor may have a stair, square metres."""

_WIDEST_STATED, _WIDEST_OWN = 120.0, 200.0
"""The same where only the rules of exits ask for two stairs: of rooms of the brief, and of the type's own list."""

_DEPTH, _ASIDE = 13.0, 5.0
"""Usual depth of a bar of rooms along a corridor, and the way within a room to its door, metres."""

_ROOMS: Final = 0.75
"""Share of a storey that rooms take."""


def second_stair(
    decisions: Decisions, storeys: Sequence[Storey], allocation: Allocation, knowledge: KnowledgeBase
) -> str:
    """Return why a building has a second stair at the far end of its corridor; empty where it has one stair.

    Halls, houses and outlines that are set back or protrude have no place for it.
    """
    facts = decisions.facts
    if (
        decisions.building.family == "home" or decisions.building.parti != "spine"
        or facts.setback or facts.protruding
    ):  # fmt: skip
        return ""
    stated = max(
        [fact.area or knowledge.room(fact.room_type).usual for each in allocation.wanted.values() for fact in each],
        default=0.0,
    )
    own = max(
        [entry.area or knowledge.room(entry.room_type).usual for storey in storeys for entry in entries_of(storey)],
        default=0.0,
    )
    if len(storeys) >= 3 and decisions.area >= _LARGE and max(stated, own) <= _WIDEST_ROOM:
        return "more than 340 m2 a storey"
    stated = max(stated, *allocation.furniture.values(), 0.0)
    if decisions.outline is not None or decisions.area < _LEAST or stated > _WIDEST_STATED or own > _WIDEST_OWN:
        return ""
    return _asked(decisions, storeys, allocation, knowledge)


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
