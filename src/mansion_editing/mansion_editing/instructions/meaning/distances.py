"""Which of several things is the nearest to something, or the farthest from it."""

import math
from collections.abc import Sequence
from typing import Final

from shapely.geometry.base import BaseGeometry

from mansion_editing.instructions.meaning.numbers import means_several
from mansion_editing.instructions.statements import Things
from mansion_editing.state import SceneState
from mansion_editing.tools.relations import spot_shapes
from mansion_geometry.object_footprints import footprint
from mansion_msgs_py.scene import SceneObject

__all__ = ["by_distance"]

MARGIN: Final = 0.1
"""Metres by which the next one must be farther off, so that it is plain which is meant."""


def by_distance(
    state: SceneState, pool: Sequence[SceneObject], things: Things, marks: Sequence[SceneObject]
) -> list[SceneObject]:
    """Return the things that words like ``the two chairs nearest the door`` mean, one in each room that has some.

    Where one is meant and the next one is hardly farther off it is returned too, so that the words fit more than they
    mean; of several any of those that are equally far off will do.

    Parameters
    ----------
    marks : sequence of SceneObject
        What the place of `things` is about, where that is no spot of a room.
    """
    place = things.place
    if place is None:
        return list(pool)
    sign = 1.0 if place.relation == "nearest" else -1.0
    rooms: dict[str, list[tuple[float, SceneObject]]] = {}
    for item in pool:
        found = state.room(item.room)
        if found is None:
            continue
        here = [footprint(mark) for mark in marks if mark.room == item.room and mark.id != item.id]
        shapes: list[BaseGeometry] = (
            spot_shapes(state.scenes[found[0]], found[1], place.spot) if place.anchor is None else [*here]
        )
        away = min((shape.distance(footprint(item)) for shape in shapes), default=math.inf)
        if away < math.inf:
            rooms.setdefault(item.room, []).append((sign * away, item))
    number = max(1, things.amount.number) if means_several(things) else 1
    return [item for ranked in rooms.values() for item in _first(ranked, number)]


def _first(ranked: list[tuple[float, SceneObject]], number: int) -> list[SceneObject]:
    ordered = sorted(ranked, key=lambda pair: (round(pair[0], 4), pair[1].id))
    if number > 1:
        return [item for _, item in ordered[:number]]
    limit = ordered[min(number, len(ordered)) - 1][0] + MARGIN
    return [item for away, item in ordered if away < limit]
