"""A receptacle as boxes for the physics engine: what carries an object on it, and what that could run into."""

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from mansion_assets.builder import Box
from mansion_assets.catalogue import Asset
from mansion_assets.meshes import collision_boxes, mesh
from mansion_editing.physics.engine import PosedBox
from mansion_editing.tools.ledges import Ledge
from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.shapes import Point3
from mansion_scene.decor.frames import to_floor

__all__ = ["half_diagonal", "heights_at", "receptacle_shell", "support_boxes"]

SLAB = 0.03
"""Thickness of what carries, metres."""

SOFT = ("seat", "mattress")
"""Kinds of surface whose mesh swells and sags."""

MOST_SWELL = 0.05
WALL = 0.01


def support_boxes(
    item: SceneObject, asset: Asset, ledge: Ledge, spot: tuple[float, float], reach: float
) -> list[PosedBox]:
    """Return the support below a ledge: a slab, and on soft tops the cushion below the object.

    Parameters
    ----------
    spot : (x, y)
        Where the object is to lie, in the receptacle's frame.
    reach : float
        Half diagonal of the object's rectangle, metres.
    """
    slab = Box((ledge.x, ledge.y, ledge.z - SLAB / 2), (ledge.w, ledge.d, SLAB))
    boxes = [_posed(item, slab)]
    if ledge.kind in SOFT:
        swell = _swell(item, asset, ledge, spot, reach)
        if swell > 1e-4:
            side = min(2 * reach, ledge.w), min(2 * reach, ledge.d)
            cushion = Box((*spot, ledge.z + swell / 2 - 0.01), (*side, swell + 0.02))
            boxes.append(_posed(item, cushion))
    return boxes


def _swell(item: SceneObject, asset: Asset, ledge: Ledge, spot: tuple[float, float], reach: float) -> float:
    """Height of the mesh above a ledge below an object, so that it lies on the cushion and not in it."""
    steps = np.linspace(-0.7 * reach, 0.7 * reach, 5)
    xs = np.clip(spot[0] + steps, ledge.x - ledge.w / 2, ledge.x + ledge.w / 2)
    ys = np.clip(spot[1] + steps, ledge.y - ledge.d / 2, ledge.y + ledge.d / 2)
    points = np.array([(x, y) for x in xs for y in ys])
    heights = heights_at(asset, points, ledge.z - MOST_SWELL, ledge.z + MOST_SWELL)
    return float(max(0.0, heights.max() - ledge.z)) if heights.size else 0.0


def heights_at(asset: Asset, points: npt.NDArray[np.float64], low: float, high: float) -> npt.NDArray[np.float64]:
    """Return the heights within [low, high] at which verticals through points meet an asset's mesh, metres.

    Parameters
    ----------
    points : (n, 2) array
        In the asset's frame, as are the heights.
    """
    found = []
    for part in mesh(asset):
        corners = part.vertices[part.faces]
        a, b, c = (corners[:, k, :] for k in range(3))
        area: npt.NDArray[np.float64]
        area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
        flat = np.abs(area) > 1e-12
        a, b, c, area = a[flat], b[flat], c[flat], area[flat]
        for x, y in points:
            u = ((x - a[:, 0]) * (c[:, 1] - a[:, 1]) - (y - a[:, 1]) * (c[:, 0] - a[:, 0])) / area
            v = ((b[:, 0] - a[:, 0]) * (y - a[:, 1]) - (b[:, 1] - a[:, 1]) * (x - a[:, 0])) / area
            hit = (u >= 0) & (v >= 0) & (u + v <= 1)
            z = a[hit, 2] + u[hit] * (b[hit, 2] - a[hit, 2]) + v[hit] * (c[hit, 2] - a[hit, 2])
            found += z[(z >= low) & (z <= high)].tolist()
    return np.array(found)


def receptacle_shell(item: SceneObject, asset: Asset, ledge: Ledge, size: Point3) -> list[PosedBox]:
    """Return the boxes that an object on a ledge could run into.

    Notes
    -----
    Inside a container these are the walls of its inner box, its door open: the front is left free. Elsewhere they are
    the asset's collision boxes, less those that fill the room above the whole ledge, which stand for a hollow body.
    """
    if ledge.inside:
        return [_posed(item, wall) for wall in _walls(ledge)]
    return [
        _posed(item, box)
        for box in collision_boxes(asset)
        if box.center[2] + box.size[2] / 2 > ledge.z + 0.004
        and box.center[2] - box.size[2] / 2 < ledge.z + size[2] + 0.01
        and not _fills(box, ledge)
    ]


def _walls(ledge: Ledge) -> Sequence[Box]:
    middle = ledge.z + ledge.clearance / 2
    left, right = ledge.x - ledge.w / 2 - WALL / 2, ledge.x + ledge.w / 2 + WALL / 2
    upright = (WALL, ledge.d, ledge.clearance)
    return [
        Box((left, ledge.y, middle), upright),
        Box((right, ledge.y, middle), upright),
        Box((ledge.x, ledge.y - ledge.d / 2 - WALL / 2, middle), (ledge.w, WALL, ledge.clearance)),
    ]


def _fills(box: Box, ledge: Ledge) -> bool:
    over = [
        min(box.center[k] + box.size[k] / 2, center + extent / 2)
        - max(box.center[k] - box.size[k] / 2, center - extent / 2)
        for k, center, extent in ((0, ledge.x, ledge.w), (1, ledge.y, ledge.d))
    ]
    covered = max(0.0, over[0]) * max(0.0, over[1])
    through = box.center[2] - box.size[2] / 2 < ledge.z + 0.004
    return through and covered > 0.9 * ledge.w * ledge.d


def _posed(item: SceneObject, box: Box) -> PosedBox:
    x, y = to_floor(item, (box.center[0], box.center[1]))
    sizes = tuple(max(float(value), 1e-3) for value in box.size)
    return PosedBox((x, y, item.position[2] + box.center[2]), (sizes[0], sizes[1], sizes[2]), item.rotation)


def half_diagonal(size: Point3) -> float:
    """Return half the diagonal of an object's rectangle, metres."""
    return math.hypot(size[0], size[1]) / 2
