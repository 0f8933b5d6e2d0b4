"""What lies on a surface, shifted aside on it until a further thing has a place."""

from collections.abc import Sequence
from typing import Final

import numpy as np
import numpy.typing as npt

from mansion_editing.state import FloorIndex
from mansion_editing.tools.ledges import GAP, Ledge, obstacles, places_on_ledge
from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.shapes import Point, Point3
from mansion_scene.decor.frames import to_floor

__all__ = ["shifts_for"]

_SAME_LEVEL: Final = 0.03
"""Greatest distance of a foot from the ledge that it stands on, metres."""

_MOST_SHIFTED: Final = 3


def shifts_for(
    index: FloorIndex, receptacle: SceneObject, ledge: Ledge, size: Point3, movable: Sequence[SceneObject]
) -> list[tuple[str, Point]] | None:
    """Return where things on a ledge go, on the floor's plan, so that one more fits; None where it does not.

    Parameters
    ----------
    size : (w, d, h)
        Of what shall fit.
    movable : sequence of SceneObject
        What may be shifted, as it is turned; the rest stays.
    """
    level = receptacle.position[2] + ledge.z
    here = [item for item in movable if abs(item.position[2] - item.size[2] / 2 - level) <= _SAME_LEVEL]
    if not here or size[2] > ledge.headroom:
        return None
    fixed = obstacles(index, receptacle, {receptacle.id, *(item.id for item in here)})
    boxes = {item.id: _box_of(index, receptacle, item) for item in here}
    for u, v, turn in _spots(ledge, fixed, size):
        w, d = (size[0], size[1]) if turn == 0.0 else (size[1], size[0])
        taken = np.array([[u, v, w / 2, d / 2, ledge.z, ledge.z + size[2]]])
        displaced = [item for item in here if _overlap(boxes[item.id], taken[0])]
        if not 0 < len(displaced) <= _MOST_SHIFTED:
            continue
        found = _elsewhere(index, receptacle, ledge, taken, {item.id: boxes[item.id] for item in displaced})
        if found is not None:
            return [(name, to_floor(receptacle, spot)) for name, spot in found.items()]
    return None


def _box_of(index: FloorIndex, receptacle: SceneObject, item: SceneObject) -> npt.NDArray[np.float64]:
    others = {other.id for other in index.objects if other.id != item.id}
    box: npt.NDArray[np.float64] = obstacles(index, receptacle, {receptacle.id, *others})[0]
    return box


def _spots(ledge: Ledge, fixed: npt.NDArray[np.float64], size: Point3) -> list[tuple[float, float, float]]:
    """Return places that what cannot move leaves free: the best ones, and those nearest to the corners."""
    corners = [(ledge.x + sx * ledge.w / 2, ledge.y + sy * ledge.d / 2) for sx in (-1, 1) for sy in (-1, 1)]
    found: dict[tuple[float, float, float], None] = {}
    for landmark in (None, *corners):
        for turn in (0.0, 90.0):
            for place in places_on_ledge(ledge, fixed, size, turn, 0.0, landmark)[:1]:
                found[(place.x, place.y, turn)] = None
    return list(found)


def _overlap(one: npt.NDArray[np.float64], other: npt.NDArray[np.float64]) -> bool:
    apart = max(abs(one[0] - other[0]) - one[2] - other[2], abs(one[1] - other[1]) - one[3] - other[3])
    return bool(apart < GAP)


def _elsewhere(
    index: FloorIndex,
    receptacle: SceneObject,
    ledge: Ledge,
    taken: npt.NDArray[np.float64],
    boxes: dict[str, npt.NDArray[np.float64]],
) -> dict[str, Point] | None:
    """Return places on the ledge for things, clear of all places that are taken now or will be; the largest first."""
    spots: dict[str, Point] = {}
    for name in sorted(boxes, key=lambda key: (-boxes[key][2] * boxes[key][3], key)):
        _, _, hw, hd, low, high = (float(value) for value in boxes[name])
        staying = np.concatenate([obstacles(index, receptacle, {receptacle.id, name}), taken])
        places = places_on_ledge(ledge, staying, (2 * hw, 2 * hd, high - low), 0.0, 0.0)
        if not places:
            return None
        spots[name] = (places[0].x, places[0].y)
        taken = np.concatenate([taken, np.array([[*spots[name], hw, hd, low, high]])])
    return spots
