"""Carve room for loose objects out of the colliders that they lie in, on or under, so that they stay at rest."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from mansion_export.meshes.model import Model
from mansion_export.meshes.solids import Box
from mansion_export.physics.collision import Colliders, Shape, bounds_of, shape_scaled
from mansion_msgs_py.scene import FloorScene, SceneObject

__all__ = ["is_loose", "loose_colliders"]

Bounds: TypeAlias = tuple[float, float, float, float, float, float]
"""Lowest x, y, z and highest x, y, z."""

PLAY = 0.002
"""Metres between an object and the walls of its cavity."""

DEEP = 0.001
"""Bodies that share less than this, metres, only touch."""

SHELF = 0.01
"""Thickness of the board that is put below what an asset's pieces do not carry, metres."""

LEVEL = 0.004
"""Difference of heights below which an object rests on a face, metres."""


def is_loose(item: SceneObject) -> bool:
    """Whether an object can be picked up and would stay where it is without being held."""
    return item.pickupable and item.mount in ("floor", "surface", "inside")


@dataclass(frozen=True, slots=True)
class _Content:
    """A loose object in the frame of what it lies in."""

    bounds: Bounds
    carried: bool


def loose_colliders(scene: FloorScene, colliders: Colliders, model: Model) -> dict[str, tuple[Shape, ...]]:
    """Return the shapes of the objects that share room with a loose object or carry one.

    Parameters
    ----------
    scene : FloorScene
    colliders : Colliders
        What the floor's objects are without loose ones.
    model : Model
        The floor's model.

    Returns
    -------
    dict of str to tuple of Box or Hull
        By object id, in the object's own frame. Objects that are left out are as `colliders` has them.

    Notes
    -----
    A cavity has its floor at the loose object's lower face and is open to the front, or above where the object stands
    out, so that it can be taken. What an asset's boxes do not carry gets a thin board.
    """
    loose = [item for item in scene.objects if is_loose(item)]
    if not loose:
        return {}
    centers = np.array([item.position for item in loose])
    reach = np.array([np.hypot(item.size[0], item.size[1]) / 2 for item in loose])
    nodes = {node.id: node for node in model.nodes}
    found = {}
    for item in scene.objects:
        own = float(np.hypot(item.size[0], item.size[1])) / 2
        away = np.hypot(centers[:, 0] - item.position[0], centers[:, 1] - item.position[1])
        near = np.flatnonzero(away < reach + own)
        contents = []
        for other in (loose[i] for i in near.tolist()):
            carried = other.parent == item.id
            content = _Content(_bounds_in(item, other), carried)
            inside = carried or (
                _volume(other) < _volume(item)
                and item.parent != other.id
                and _overlap(content.bounds, _own_bounds(item))
            )
            if other is not item and inside:
                contents.append(content)
        if contents and item.id in nodes:
            node = nodes[item.id]
            shapes = [shape_scaled(shape, node.scale) for shape in colliders.of(node, model.meshes[node.mesh]) or ()]
            found[item.id] = tuple(_carved(item, shapes, contents))
    return found


def _volume(item: SceneObject) -> float:
    return item.size[0] * item.size[1] * item.size[2]


def _own_bounds(item: SceneObject) -> Bounds:
    w, d, h = (value / 2 for value in item.size)
    return -w, -d, -h, w, d, h


def _bounds_in(host: SceneObject, other: SceneObject) -> Bounds:
    """Return the box around another object in the host's frame."""
    turn = np.radians(other.rotation - host.rotation)
    c, s = abs(float(np.cos(turn))), abs(float(np.sin(turn)))
    w, d, h = (value / 2 for value in other.size)
    half = (w * c + d * s, w * s + d * c, h)
    angle = np.radians(-host.rotation)
    dx, dy = other.position[0] - host.position[0], other.position[1] - host.position[1]
    x = float(dx * np.cos(angle) - dy * np.sin(angle))
    y = float(dx * np.sin(angle) + dy * np.cos(angle))
    z = other.position[2] - host.position[2]
    return x - half[0], y - half[1], z - half[2], x + half[0], y + half[1], z + half[2]


def _overlap(one: Bounds, other: Bounds) -> bool:
    return all(min(one[k + 3], other[k + 3]) - max(one[k], other[k]) > DEEP for k in range(3))


def _carved(item: SceneObject, shapes: Sequence[Shape], contents: Sequence[_Content]) -> list[Shape]:
    """Cut the cavities out of the boxes of what they meet."""
    whole = [shape for shape in shapes if not any(_overlap(_bounds(shape), content.bounds) for content in contents)]
    parts = [_bounds(shape) for shape in shapes if not any(shape is kept for kept in whole)]
    for content in contents:
        parts = [rest for part in parts for rest in _without(part, content.bounds)]
    carriers = [*(_bounds(shape) for shape in whole), *parts]
    for content in contents:
        x0, y0, z0, x1, y1, _ = content.bounds
        rests = content.carried and z0 < item.size[2] / 2 + LEVEL
        if rests and not any(_carries(part, content.bounds) for part in carriers):
            parts.append((x0, y0, z0 - SHELF, x1, y1, z0))
    return [*whole, *(_box(part) for part in parts)]


def _bounds(shape: Shape) -> Bounds:
    low, high = bounds_of(shape)
    return low[0], low[1], low[2], high[0], high[1], high[2]


def _box(part: Bounds) -> Box:
    return Box(
        ((part[0] + part[3]) / 2, (part[1] + part[4]) / 2, (part[2] + part[5]) / 2),
        (part[3] - part[0], part[4] - part[1], part[5] - part[2]),
    )


def _carries(part: Bounds, content: Bounds) -> bool:
    across = min(part[3], content[3]) - max(part[0], content[0])
    deep = min(part[4], content[4]) - max(part[1], content[1])
    area = (content[3] - content[0]) * (content[4] - content[1])
    return abs(part[5] - content[2]) < LEVEL and across > 0 and deep > 0 and across * deep > 0.6 * area


def _without(part: Bounds, content: Bounds) -> list[Bounds]:
    """Cut a content's cavity out of a box; at most five boxes are left."""
    if not _overlap(part, content):
        return [part]
    out_above = content[5] > part[5] - DEEP
    low = [content[0] - PLAY, content[1] - PLAY, content[2]]
    high = [content[3] + PLAY, content[4] + PLAY if out_above else part[4], part[5] if out_above else content[5] + PLAY]
    rest: list[Bounds] = []
    core = list(part)
    # Level cuts first: what carries stays one board below the whole cavity.
    for axis in (2, 0, 1):
        for edge, inner in ((axis, low[axis]), (axis + 3, high[axis])):
            lower = edge < 3
            outside = inner - core[edge] if lower else core[edge] - inner
            if outside > DEEP:
                piece = list(core)
                piece[edge + 3 if lower else edge - 3] = inner
                rest.append((piece[0], piece[1], piece[2], piece[3], piece[4], piece[5]))
            if outside > 0:
                core[edge] = inner
    return rest
