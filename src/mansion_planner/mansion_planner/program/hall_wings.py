"""A hall of the ground floor in a wing of one storey: a school's gym stands beside its classrooms, not below them."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from mansion_knowledge import RoomType
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.model import Massing, PlannedRoom, Storey

__all__ = ["hall_of_wing", "is_free_for_wing", "is_hall_of_wing", "with_hall_wing"]

_LEAST = 110.0
"""Square metres from which on a hall has a wing of its own."""

_ASPECT = (0.45, 2.2)
"""Least and greatest length of the wing to the depth of the building."""

_OTHERS = 0.6
"""Least area of the other rooms of the ground floor to that of any storey above: the hall fills it up otherwise."""


def is_free_for_wing(decisions: Decisions) -> bool:
    """Whether a building has several storeys along corridors, and nobody states areas or the outline."""
    facts, building = decisions.facts, decisions.building
    outline = facts.shapes or facts.setback or facts.protruding or decisions.outline is not None or decisions.free_form
    plain = building.parti == "spine" and building.family != "home" and not decisions.area_stated
    return plain and not outline and decisions.floors > 1


def is_hall_of_wing(kind: RoomType, area: float) -> bool:
    """Whether a room of a type and an area, in square metres, is a hall that may have a wing."""
    return kind.whole and kind.zone == "public" and area >= _LEAST


def hall_of_wing(
    decisions: Decisions, storeys: Sequence[Storey], asked: Mapping[int, Sequence[PlannedRoom]]
) -> PlannedRoom | None:
    """Return the hall of the brief that gets a wing; ``None`` where there is none.

    Parameters
    ----------
    decisions : Decisions
    storeys : sequence of Storey
    asked : mapping of int to sequence of PlannedRoom
        The rooms that the brief asks for, by storey.
    """
    ground = next((storey for storey in storeys if storey.role == "ground"), None)
    if ground is None or not is_free_for_wing(decisions) or any(storey.copy is not None for storey in storeys):
        return None
    rooms = asked[ground.index]
    halls = [room for room in rooms if is_hall_of_wing(room.kind, room.area) and not room.suite]
    if len(halls) != 1:
        return None
    others = sum(room.gross for room in rooms) - halls[0].gross
    above = max(sum(room.gross for room in asked[storey.index]) for storey in storeys if storey.index > ground.index)
    return halls[0] if others >= _OTHERS * above else None


def with_hall_wing(massing: Massing, storeys: Sequence[Storey], hall: PlannedRoom | None) -> list[Storey]:
    """Return the storeys, the ground floor longer by the hall, where that makes a hall of good proportions."""
    if hall is None or massing.wings or massing.hall or massing.aisles is not None:
        return list(storeys)
    length = float(max(round(hall.area / massing.depth), 1))
    least, most = _ASPECT
    if not least * massing.depth <= length <= most * massing.depth:
        return list(storeys)
    return [
        replace(storey, extension=length, hall_wing=True) if storey.role == "ground" else storey for storey in storeys
    ]
