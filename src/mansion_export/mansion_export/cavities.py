"""Collision boxes with room for what lies in or under them, so that loose objects rest and nothing bursts apart."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from mansion_assets.catalogue import Catalogue, load_catalogue
from mansion_assets.meshes import collision_boxes
from mansion_export.object_meshes import object_asset
from mansion_export.solids import Box
from mansion_msgs_py.scene import FloorScene, SceneObject

__all__ = ["is_loose", "loose_colliders"]

Bounds: TypeAlias = tuple[float, float, float, float, float, float]
"""Lowest x, y, z and highest x, y, z."""

PLAY = 0.002
"""Metres between an object and the walls of its cavity."""

DEEP = 0.001
"""Boxes that share less than this, metres, only touch."""

SHELF = 0.01
"""Thickness of the board that is put below what an asset's boxes do not carry, metres."""

LEVEL = 0.004


def is_loose(item: SceneObject) -> bool:
    """Whether an object can be picked up and would stay where it is without being held."""
    return item.pickupable and item.mount in ("floor", "surface", "inside")


@dataclass(frozen=True, slots=True)
class _Guest:
    """A loose object in the frame of what it lies in."""

    bounds: Bounds
    carried: bool


def loose_colliders(scene: FloorScene, catalogue: Catalogue | None = None) -> dict[str, tuple[Box, ...]]:
    """Return the collision boxes of the objects that share room with a loose object or carry one.

    Parameters
    ----------
    scene : FloorScene
    catalogue : Catalogue, optional
        The shipped one when it is left out.

    Returns
    -------
    dict of str to tuple of Box
        By object id, in the object's own frame. Objects that are left out have their whole box.

    Notes
    -----
    A cavity has its floor at the loose object's lower face and is open to the front, or above where the object stands
    out, so that it can be taken. What an asset's boxes do not carry gets a thin board.
    """
    known = catalogue or load_catalogue()
    loose = [item for item in scene.objects if is_loose(item)]
    if not loose:
        return {}
    centers = np.array([item.position for item in loose])
    reach = np.array([np.hypot(item.size[0], item.size[1]) / 2 for item in loose])
    colliders = {}
    for item in scene.objects:
        own = float(np.hypot(item.size[0], item.size[1])) / 2
        away = np.hypot(centers[:, 0] - item.position[0], centers[:, 1] - item.position[1])
        near = np.flatnonzero(away < reach + own)
        guests = []
        for other in (loose[i] for i in near.tolist()):
            carried = other.parent == item.id
            guest = _Guest(_bounds_in(item, other), carried)
            lies_in = carried or (
                _volume(other) < _volume(item) and item.parent != other.id and _overlap(guest.bounds, _whole(item))
            )
            if other is not item and lies_in:
                guests.append(guest)
        if guests:
            colliders[item.id] = tuple(_carved(item, known, guests))
    return colliders


def _volume(item: SceneObject) -> float:
    return item.size[0] * item.size[1] * item.size[2]


def _whole(item: SceneObject) -> Bounds:
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


def _carved(item: SceneObject, catalogue: Catalogue, guests: Sequence[_Guest]) -> list[Box]:
    parts = _asset_bounds(item, catalogue)
    for guest in guests:
        parts = [rest for part in parts for rest in _without(part, guest.bounds)]
    for guest in guests:
        x0, y0, z0, x1, y1, _ = guest.bounds
        lies = guest.carried and z0 < item.size[2] / 2 + LEVEL
        if lies and not any(_carries(part, guest.bounds) for part in parts):
            parts.append((x0, y0, z0 - SHELF, x1, y1, z0))
    return [
        Box(
            ((part[0] + part[3]) / 2, (part[1] + part[4]) / 2, (part[2] + part[5]) / 2),
            (part[3] - part[0], part[4] - part[1], part[5] - part[2]),
        )
        for part in parts
    ]


def _asset_bounds(item: SceneObject, catalogue: Catalogue) -> list[Bounds]:
    """Return the boxes of an object's asset at the object's size."""
    asset = object_asset(catalogue, item)
    if asset is None:
        return [_whole(item)]
    scale = [mine / its for mine, its in zip(item.size, asset.size)]
    found = []
    for box in collision_boxes(asset):
        low = [(c - s / 2) * k for c, s, k in zip(box.center, box.size, scale)]
        high = [(c + s / 2) * k for c, s, k in zip(box.center, box.size, scale)]
        found.append((low[0], low[1], low[2], high[0], high[1], high[2]))
    return found


def _carries(part: Bounds, guest: Bounds) -> bool:
    across = min(part[3], guest[3]) - max(part[0], guest[0])
    deep = min(part[4], guest[4]) - max(part[1], guest[1])
    area = (guest[3] - guest[0]) * (guest[4] - guest[1])
    return abs(part[5] - guest[2]) < LEVEL and across > 0 and deep > 0 and across * deep > 0.6 * area


def _without(part: Bounds, guest: Bounds) -> list[Bounds]:
    """Cut the guest's cavity out of a box; at most five boxes are left."""
    if not _overlap(part, guest):
        return [part]
    out_above = guest[5] > part[5] - DEEP
    low = [guest[0] - PLAY, guest[1] - PLAY, guest[2]]
    high = [guest[3] + PLAY, guest[4] + PLAY if out_above else part[4], part[5] if out_above else guest[5] + PLAY]
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
