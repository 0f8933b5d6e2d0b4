"""Doors as passages for a robot: which have no leaf, stand open or can be driven through, and their depth."""

from collections.abc import Iterable
from typing import Final

from mansion_msgs_py.scene import Door, FloorScene

__all__ = ["LEAFLESS", "PASSAGE_DEPTH", "depth_of_doors", "is_passable", "is_walkway"]

LEAFLESS: Final = ("open", "doorway", "frame")
"""Kinds of doors that cannot be closed."""

PASSAGE_DEPTH: Final = 0.28
"""Depth of the floor in a door between rooms that joins them through any wall, metres."""

LANDING_DEPTH: Final = 0.12
"""Depth of a door that is in no wall of the floor, a lift's landing door say; metres."""


def is_passable(door: Door) -> bool:
    """Whether a door lets a robot through as it stands."""
    return door.is_open or door.kind in LEAFLESS


def is_walkway(door: Door, cores: Iterable[str]) -> bool:
    """Whether a robot can drive through a door when it stands open: not into a shaft, not outside."""
    return None not in door.rooms and not set(cores).intersection(str(name) for name in door.rooms)


def depth_of_doors(scene: FloorScene) -> dict[str, float]:
    """Return how deep the wall around each door is, by the door's id; metres."""
    thickness = {wall.id: wall.thickness for wall in scene.walls}
    return {door.id: thickness.get(door.wall, LANDING_DEPTH) for door in scene.doors}
