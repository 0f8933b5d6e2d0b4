"""Vehicles behind the doors they drive in through: one behind each door of a hall of bays, abreast in a garage."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import numpy as np

from mansion_geometry.compiled import Floats
from mansion_scene.placement.floor import Floor
from mansion_scene.placement.groups import Spec
from mansion_scene.placement.search import examine
from mansion_scene.placement.units import Unit, UnitStyle, build_unit

__all__ = ["place_behind_doors"]

_BAY_DOOR, _CAR_DOOR = 3.0, 2.3
"""Least widths of the door of a bay and of a garage, metres."""

_BEFORE = (1.2, 1.0, 0.93, 1.5, 2.0)
"""Distances between the door of a bay and the vehicle behind it that are tried, metres."""

_BEFORE_CAR = (1.05, 0.85, 1.3, 1.6)
"""The same for a garage, where the place behind the door is all that is kept clear."""

_BESIDE = (0.9, 0.7, 0.55)
"""Distances between cars side by side that are tried, metres: a door opens half, or a person edges in."""

_ASIDE = (0.0, 0.3, -0.3, 0.6, -0.6, 1.0, -1.0)
"""Offsets of a row of cars from the middle of their door that are tried, metres."""


def place_behind_doors(floor: Floor, spec: Spec, count: int) -> int:
    """Place up to `count` vehicles behind the doors that they drive in through; return how many.

    In a hall of bays each stands behind a door of its own; in a garage all stand abreast behind its door. In other
    rooms none is placed: vehicles stand wherever there is place for them.
    """
    doors = sorted(floor.room.doors, key=_width, reverse=True)
    bays = [door for door in floor.room.doors if _width(door) >= _BAY_DOOR]
    if len(bays) >= 2 or (bays and not floor.room.garage):
        return _place_in_bays(floor, spec, count, bays)
    if floor.room.garage and doors and _width(doors[0]) >= _CAR_DOOR:
        return _place_abreast(floor, spec, count, doors[0])
    return 0


def _width(door: Floats) -> float:
    return float(np.hypot(*(door[2:] - door[:2])))


def _place_in_bays(floor: Floor, spec: Spec, count: int, bays: Sequence[Floats]) -> int:
    """Place a vehicle behind each door, as far as it fits."""
    unit = build_unit(spec, spec.size, {}, {}, UnitStyle(frozenset()))
    placed = 0
    for door in bays:
        if placed == count:
            break
        poses = np.array([_behind(floor, door, before + spec.size[1] / 2) for before in _BEFORE])
        poses = poses[floor.fits(poses, unit.array())] if len(poses) else poses
        placed += examine(floor, unit, poses, -np.arange(len(poses), dtype=float)) is not None
    return placed


def _place_abreast(floor: Floor, spec: Spec, count: int, door: Floats) -> int:
    """Place as many cars side by side behind a door as fit, up to `count`, in the largest size that fits so often."""
    free = replace(spec, where="unconstrained")  # a car stands behind the door, not with its back at a wall
    for number in range(count, 0, -1):
        for size in (spec.size, *spec.smaller):
            unit = build_unit(free, size, {}, {}, UnitStyle(frozenset()))
            for before, beside, aside in product(_BEFORE_CAR, _BESIDE, _ASIDE):
                pitch = size[0] + beside
                shifts = [aside + pitch * (place - (number - 1) / 2) for place in range(number)]
                poses = np.array([_behind(floor, door, before + size[1] / 2, shift) for shift in shifts])
                if floor.fits(poses, unit.array()).all() and _put_all(floor, unit, poses):
                    return number
    return 0


def _put_all(floor: Floor, unit: Unit, poses: Floats) -> bool:
    """Put a copy at every pose, or none."""
    before = floor.copy()
    if all(examine(floor, unit, pose[None], np.zeros(1)) is not None for pose in poses):
        return True
    floor.restore(before)
    return False


def _behind(floor: Floor, door: Floats, inside: float, aside: float = 0.0) -> tuple[float, float, float, float]:
    """Return the pose at a distance inside a door and an offset from its middle, facing it; metres."""
    middle = (door[:2] + door[2:]) / 2
    wall = min(floor.room.walls, key=lambda wall: abs(float((middle - wall.start) @ wall.inward)))
    x, y = middle + wall.inward * inside + wall.along * aside
    return float(x), float(y), float(-wall.inward[1]), float(wall.inward[0])
