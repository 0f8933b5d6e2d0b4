"""Walls cut at their openings, as intervals along the wall and boxes in height."""

from dataclasses import dataclass

import numpy as np
from mansion_msgs_py.scene import FloorScene, Wall
from mansion_msgs_py.shapes import Segment

__all__ = [
    "Box",
    "Opening",
    "segment_box",
    "span",
    "wall_boxes",
    "wall_openings",
    "wall_pieces",
]


@dataclass(frozen=True, slots=True)
class Opening:
    """A hole in a wall, in metres along its centre line and above the floor."""

    id: str
    low: float
    high: float
    sill: float
    head: float


@dataclass(frozen=True, slots=True)
class Box:
    """A box in plan coordinates: centre, full sizes, and its heading in degrees."""

    center: tuple[float, float, float]
    size: tuple[float, float, float]
    rotation: float


def segment_box(segment: Segment, thickness: float, height: float, base: float = 0.0) -> Box:
    """Return the box that stands on a segment, e.g. a door's leaf when it is closed."""
    (ax, ay), (bx, by) = segment
    rotation = float(np.degrees(np.arctan2(by - ay, bx - ax)))
    length = float(np.hypot(bx - ax, by - ay))
    center = ((ax + bx) / 2, (ay + by) / 2, base + height / 2)
    return Box(center, (length, thickness, height), rotation)


def span(wall: Wall, segment: Segment) -> tuple[float, float]:
    """Project a segment on a wall's centre line; metres from the wall's start, ascending."""
    (ax, ay), (bx, by) = wall.segment
    length = float(np.hypot(bx - ax, by - ay)) or 1.0
    ux, uy = (bx - ax) / length, (by - ay) / length
    t = sorted((x - ax) * ux + (y - ay) * uy for x, y in segment)
    return t[0], t[1]


def wall_openings(scene: FloorScene, wall: Wall) -> list[Opening]:
    """Return the doors and windows of a wall from its start to its end."""
    found = [
        Opening(door.id, *span(wall, door.segment), 0.0, min(door.height, wall.height))
        for door in scene.doors
        if door.wall == wall.id
    ]
    found += [
        Opening(
            window.id,
            *span(wall, window.segment),
            window.sill,
            min(window.sill + window.height, wall.height),
        )
        for window in scene.windows
        if window.wall == wall.id
    ]
    return sorted(found, key=lambda opening: opening.low)


def wall_pieces(scene: FloorScene, wall: Wall) -> list[tuple[float, float]]:
    """Return the full-height parts of a wall between its openings, ends lengthened to close corners."""
    length, extra = _length(wall), wall.thickness / 2
    pieces = []
    reached = -extra
    for opening in wall_openings(scene, wall):
        if opening.low > reached:
            pieces.append((reached, opening.low))
        reached = max(reached, opening.high)
    if length + extra > reached:
        pieces.append((reached, length + extra))
    return pieces


def wall_boxes(scene: FloorScene, wall: Wall) -> list[Box]:
    """Return a wall as boxes: between, below and above its openings."""
    intervals = [(low, high, 0.0, wall.height) for low, high in wall_pieces(scene, wall)]
    for opening in wall_openings(scene, wall):
        if opening.sill > 0.0:
            intervals.append((opening.low, opening.high, 0.0, opening.sill))
        if opening.head < wall.height:
            intervals.append((opening.low, opening.high, opening.head, wall.height))
    (ax, ay), (bx, by) = wall.segment
    length = _length(wall) or 1.0
    ux, uy = (bx - ax) / length, (by - ay) / length
    rotation = float(np.degrees(np.arctan2(by - ay, bx - ax)))
    boxes = []
    for low, high, bottom, top in intervals:
        middle = (low + high) / 2
        center = (ax + ux * middle, ay + uy * middle, (bottom + top) / 2)
        boxes.append(Box(center, (high - low, wall.thickness, top - bottom), rotation))
    return boxes


def _length(wall: Wall) -> float:
    (ax, ay), (bx, by) = wall.segment
    return float(np.hypot(bx - ax, by - ay))
