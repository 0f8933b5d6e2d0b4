"""Where two rooms of a drawing touch and no wall stands between them."""

from collections.abc import Callable, Collection, Sequence
from itertools import combinations
from typing import Final

import shapely
from shapely.geometry import LineString, Polygon

from mansion_msgs_py.building_plan import PlanDoor, PlanRoom

__all__ = ["unwalled"]

_TOUCHING: Final = 0.02
_LEAST: Final = 0.7
"""Shortest stretch without a wall that counts, metres."""

_WHOLE: Final = 0.9
"""Share of what two rooms have in common from which all of it is open."""


def unwalled(
    rooms: Sequence[PlanRoom], joined: Collection[frozenset[str]], walls: Callable[[], Sequence[Polygon]]
) -> list[PlanDoor]:
    """Return openings between rooms that touch where no wall stands.

    Parameters
    ----------
    rooms : sequence of PlanRoom
        With polygons in metres between the faces of their walls.
    joined : collection of frozenset of str
        Names of two rooms that are open to each other already.
    walls : callable
        Returns where walls stand; called only where rooms touch.
    """
    shapes = [shapely.make_valid(Polygon(room.polygon, room.holes)) for room in rooms]
    touching = []
    for i, j in combinations(range(len(rooms)), 2):
        if frozenset((_name(rooms[i]), _name(rooms[j]))) in joined or shapes[i].distance(shapes[j]) > _TOUCHING:
            continue
        shared = shapes[i].boundary.intersection(shapes[j].buffer(_TOUCHING))
        if shared.length >= _LEAST:
            touching.append((i, j, shapely.line_merge(shared)))
    if not touching:
        return []
    standing = shapely.union_all(list(walls())).buffer(_TOUCHING)
    found = []
    for i, j, shared in touching:
        free = shared.difference(standing)
        pieces = [piece for piece in shapely.get_parts(free) if isinstance(piece, LineString)]
        longest = max(pieces, key=lambda piece: piece.length, default=LineString())
        names = [_name(rooms[i]), _name(rooms[j])]
        if free.length >= _WHOLE * shared.length:
            found.append(PlanDoor(rooms=names, kind="open"))
        elif longest.length >= _LEAST:
            (ax, ay), (bx, by) = longest.coords[0], longest.coords[-1]
            found.append(PlanDoor(rooms=names, kind="doorway", segment=((ax, ay), (bx, by))))
    return found


def _name(room: PlanRoom) -> str:
    return room.id or room.name
