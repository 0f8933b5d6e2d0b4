"""Which object rests on or lies in which, from boxes alone (tool cards CheckSurface and SearchContents)."""

import math

import numpy as np
import numpy.typing as npt

from mansion_assets.catalogue import Asset
from mansion_editing.state import FloorIndex
from mansion_msgs_py.scene import SceneObject
from mansion_scene.decor.frames import to_local

__all__ = ["Column", "contents", "on_top", "within_plan"]

REST = 0.05
"""Greatest distance between a surface and the foot of what rests on it, metres."""

LOW = 0.02
"""Furniture lower than this stands on the floor, metres."""

EDGE = 0.01
"""Slack of footprints, metres."""

Column = npt.NDArray[np.intp]
"""Numbers of the objects whose centre lies over a receptacle."""


def within_plan(index: FloorIndex, receptacle: SceneObject) -> Column:
    """Return the objects whose centroid lies within the receptacle's rectangle, seen from above; itself left out."""
    boxes = index.boxes
    angle = math.radians(-receptacle.rotation)
    dx = boxes[:, 0] - receptacle.position[0]
    dy = boxes[:, 1] - receptacle.position[1]
    u = math.cos(angle) * dx - math.sin(angle) * dy
    v = math.sin(angle) * dx + math.cos(angle) * dy
    inside = (np.abs(u) <= receptacle.size[0] / 2 + EDGE) & (np.abs(v) <= receptacle.size[1] / 2 + EDGE)
    own = index.at.get(receptacle.id, -1)
    return np.array([n for n in np.flatnonzero(inside) if n != own], dtype=np.intp)


def on_top(index: FloorIndex, receptacle: SceneObject, asset: Asset | None) -> list[SceneObject]:
    """Return what rests on a receptacle: on its top, or on a surface of its asset (a seat, a shelf).

    Notes
    -----
    On top is a child whose centroid lies above the top of the parent's bounding box and whose foot is within 5 cm
    of it. What hangs from the ceiling rests on nothing. Where something stands in between, that one is the carrier.
    """
    found = []
    for number in within_plan(index, receptacle):
        item = index.objects[int(number)]
        if item.mount == "ceiling" or (item.mount == "wall" and item.parent is None):
            continue
        foot = item.position[2] - item.size[2] / 2
        if item.mount == "floor" and foot < LOW and receptacle.size[2] > REST:
            continue
        if _rests(item, receptacle, asset) and not _nested(index, item, receptacle):
            found.append(item)
    return found


def contents(index: FloorIndex, receptacle: SceneObject, asset: Asset | None) -> list[SceneObject]:
    """Return what lies in a container: its centroid strictly within the container's vertical range.

    Notes
    -----
    What rests on a seat, a mattress or a top below the container's highest point is not inside it; what stands on one
    of its shelves is, as the card has it, and lies on it too. Furniture that stands below a table top on the floor is
    inside only where one of the container's inner boxes holds it.
    """
    low = receptacle.position[2] - receptacle.size[2] / 2
    high = receptacle.position[2] + receptacle.size[2] / 2
    found = []
    for number in within_plan(index, receptacle):
        item = index.objects[int(number)]
        if item.mount == "ceiling" or not low < item.position[2] < high:
            continue
        loose = item.mount in ("surface", "inside") or item.pickupable
        held = _in_volume(item, receptacle, asset)
        open_seat = not held and _rests(item, receptacle, asset, shelves=False)
        if (held or (loose and not open_seat)) and not _nested(index, item, receptacle):
            found.append(item)
    return found


def _rests(item: SceneObject, receptacle: SceneObject, asset: Asset | None, shelves: bool = True) -> bool:
    foot = item.position[2] - item.size[2] / 2
    top = receptacle.position[2] + receptacle.size[2] / 2
    if item.position[2] > top and abs(foot - top) <= REST:
        return True
    if asset is None:
        return False
    x, y = to_local(receptacle, item.position)
    for s in asset.surfaces:
        if s.kind == "shelf" and not shelves:
            continue
        near = abs(foot - (receptacle.position[2] + s.z)) <= REST
        if near and abs(x - s.x) <= s.w / 2 + EDGE and abs(y - s.y) <= s.d / 2 + EDGE:
            return True
    return False


def _in_volume(item: SceneObject, receptacle: SceneObject, asset: Asset | None) -> bool:
    if asset is None:
        return False
    x, y = to_local(receptacle, item.position)
    z = item.position[2] - receptacle.position[2]
    return any(
        abs(x - v.x) <= v.w / 2 + EDGE and abs(y - v.y) <= v.d / 2 + EDGE and abs(z - v.z) <= v.h / 2 + EDGE
        for v in asset.volumes
    )


def _nested(index: FloorIndex, item: SceneObject, receptacle: SceneObject) -> bool:
    """Whether the scene names another carrier that stands on or in this receptacle itself, and still holds the item."""
    number = index.at.get(item.parent or "", -1)
    if number < 0 or item.parent == receptacle.id:
        return False
    carrier = index.objects[number]
    x, y = to_local(carrier, item.position)
    over = abs(x) <= carrier.size[0] / 2 + EDGE and abs(y) <= carrier.size[1] / 2 + EDGE
    low, high = item.position[2] - item.size[2] / 2, item.position[2] + item.size[2] / 2
    base = carrier.position[2] - carrier.size[2] / 2
    roof = carrier.position[2] + carrier.size[2] / 2
    return over and low <= roof + REST and high >= base
