"""Rooms that a brief has entered from another one: "a balcony off the bedroom", "a pantry off the kitchen"."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Final

import msgspec

from mansion_knowledge import is_class
from mansion_planner.brief.facts import AdjacencyFact
from mansion_planner.program.model import DOOR_WALL, Placement, Sketch, shared_wall

__all__ = ["entered_as_told"]

_MOST: Final = 40.0
"""Largest room that has its only door to another room, square metres; a larger one is a thoroughfare."""


def entered_as_told(sketch: Sketch, wishes: Sequence[AdjacencyFact]) -> Sketch:
    """Return a sketch in which rooms are reached from the rooms that a brief has them entered from.

    Of the two it is the one outdoors, else the first named, that is reached from the other instead of a corridor. It
    stays as it is where they share no wall that takes a door, or where others are reached through it.

    Parameters
    ----------
    sketch : Sketch
    wishes : sequence of AdjacencyFact
        Those without `door` are passed over.
    """
    for fact in wishes:
        moved = next(_moves(sketch, fact), None) if fact.door else None
        if moved is not None:
            inner, outer = moved
            rooms = [msgspec.structs.replace(p, parent=outer.room.id) if p is inner else p for p in sketch.rooms]
            sketch = replace(sketch, rooms=rooms)
    return sketch


def _moves(sketch: Sketch, fact: AdjacencyFact) -> Iterator[tuple[Placement, Placement]]:
    """Yield rooms that a wish means and that can change what they are reached from, each with that room."""
    corridors = {corridor.id for corridor in sketch.corridors}
    entered = {p.parent for p in sketch.rooms} | set(sketch.core_parent.values())
    firsts, seconds = (
        [p for p in sketch.rooms if p.room.called(name)]
        for name in (fact.first_name or fact.first, fact.second_name or fact.second)
    )
    pairs = [(a, b) for a in firsts for b in seconds if a is not b]
    pairs += [(b, a) for a, b in pairs]
    pairs.sort(key=lambda pair: not is_class(pair[0].room.kind.name, "outdoor"))
    for inner, outer in pairs:
        free = inner.parent in corridors and inner.room.id not in entered and inner.area <= _MOST
        if free and outer.parent != inner.room.id and shared_wall(inner.boxes, outer.boxes) >= DOOR_WALL:
            yield inner, outer
