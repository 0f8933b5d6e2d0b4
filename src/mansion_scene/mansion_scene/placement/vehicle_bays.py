"""Vehicles in a hall of bays: each stands behind a door of its own, nose to it."""

import numpy as np

from mansion_geometry.compiled import Floats
from mansion_scene.placement.floor import Floor
from mansion_scene.placement.groups import Spec
from mansion_scene.placement.search import examine
from mansion_scene.placement.units import UnitStyle, build_unit

__all__ = ["place_behind_doors"]

_DOOR = 3.0
"""Least width of the door of a bay, metres."""

_BEFORE = (1.2, 1.0, 0.93, 1.5, 2.0)
"""Distances between a door and the vehicle behind it that are tried, metres."""


def place_behind_doors(floor: Floor, spec: Spec, count: int) -> int:
    """Place up to `count` vehicles behind the doors of a room with two and more bays; return how many.

    Where a room has one such door only, vehicles stand wherever there is place for them.
    """
    bays = [door for door in floor.room.doors if np.hypot(*(door[2:] - door[:2])) >= _DOOR]
    if len(bays) < 2:
        return 0
    unit = build_unit(spec, spec.size, {}, {}, UnitStyle(frozenset()))
    placed = 0
    for door in bays:
        if placed == count:
            break
        poses = _poses(floor, door, spec.size[1])
        poses = poses[floor.fits(poses, unit.array())] if len(poses) else poses
        placed += examine(floor, unit, poses, -np.arange(len(poses), dtype=float)) is not None
    return placed


def _poses(floor: Floor, door: Floats, depth: float) -> Floats:
    """Return poses abreast of a door, the best first, with the front towards it."""
    middle = (door[:2] + door[2:]) / 2
    wall = min(floor.room.walls, key=lambda wall: abs(float((middle - wall.start) @ wall.inward)))
    poses = []
    for before in _BEFORE:
        x, y = middle + wall.inward * (before + depth / 2)
        poses.append((x, y, -wall.inward[1], wall.inward[0]))
    return np.array(poses)
