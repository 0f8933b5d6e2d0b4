"""Walls with their openings, doors with their swings, windows."""

from collections.abc import Mapping, Sequence

import numpy as np

from mansion_export.meshes.door_sides import swing_side
from mansion_export.meshes.walls import WallBodies
from mansion_export.plan.palette import INK
from mansion_export.plan.shapes import Area, Canvas, Frame, Line, Shape, arc, rectangle
from mansion_msgs_py.scene import Door, FloorScene, Wall, Window
from mansion_msgs_py.shapes import Point, Segment

__all__ = ["draw_doors", "draw_walls", "draw_windows"]

DEFAULT_THICKNESS = 0.12

SILL = 0.05
"""Width of the lines that carry the wall's faces past a window, metres."""


def draw_walls(scene: FloorScene) -> list[Canvas]:
    """Draw each wall in pieces between its openings, thick and dark."""
    canvases = []
    bodies = WallBodies(scene)
    for wall in scene.walls:
        ink = INK["structural" if wall.structural else "outer_wall" if wall.exterior else "wall"]
        frame = segment_frame(wall.segment)
        half = wall.thickness / 2
        shapes = tuple(
            Area(frame.place(rectangle(low, -half, high, half)), ink, width=0.0) for low, high in bodies.pieces(wall)
        )
        canvases.append(Canvas("walls", shapes, wall.id))
    return canvases


def segment_frame(segment: Segment) -> Frame:
    """Return the frame of a segment: origin at its start, x along it, y to its left."""
    (ax, ay), (bx, by) = segment
    return Frame(ax, ay, float(np.degrees(np.arctan2(by - ay, bx - ax))))


def draw_windows(scene: FloorScene) -> list[Canvas]:
    """Draw windows as a pane in the middle of the wall, whose two faces go on as sills."""
    walls = {wall.id: wall for wall in scene.walls}
    return [_window(window, walls.get(window.wall)) for window in scene.windows]


def _window(window: Window, wall: Wall | None) -> Canvas:
    frame = segment_frame(window.segment)
    half = (wall.thickness if wall else DEFAULT_THICKNESS) / 2
    length = _length(window.segment)
    sill = min(SILL, half / 2)
    shapes: list[Shape] = [
        Area(frame.place(rectangle(0.0, -half, length, half)), INK["glass_fill"], width=0.0),
        *(
            Area(frame.place(rectangle(0.0, y, length, y + sill)), INK["outer_wall"], width=0.0)
            for y in (-half, half - sill)
        ),
        Line(frame.place([(0.0, 0.0), (length, 0.0)]), INK["glass"], 0.04),
    ]
    title = f"{window.id}: {length:.2f} x {window.height:.2f} m, sill {window.sill:.2f} m"
    return Canvas("windows", tuple(shapes), window.id, title)


def draw_doors(scene: FloorScene) -> list[Canvas]:
    """Draw doors with their leaves open and the arcs of their swings."""
    walls = {wall.id: wall for wall in scene.walls}
    rooms = {room.id: room.polygon for room in scene.rooms}
    rooms |= {core.id: core.polygon for core in scene.cores}
    return [_door(door, walls.get(door.wall), rooms) for door in scene.doors]


def _door(door: Door, wall: Wall | None, rooms: Mapping[str, Sequence[Point]]) -> Canvas:
    frame = segment_frame(door.segment)
    length = _length(door.segment)
    half = (wall.thickness if wall else DEFAULT_THICKNESS) / 2
    title = f"{door.id}: {door.kind}, {door.width:.2f} m"
    shapes: list[Shape]
    if door.kind == "open":
        shapes = [Line(frame.place([(0.0, 0.0), (length, 0.0)]), INK["furniture_detail"], 0.02, 0.12)]
        return Canvas("doors", tuple(shapes), door.id, title)
    shapes = [
        Area(frame.place(rectangle(0.0, -half, length, half)), INK["paper"], width=0.0),
        *(Line(frame.place([(x, -half), (x, half)]), INK["outer_wall"], 0.03) for x in (0.0, length)),
    ]
    if door.kind in ("doorway", "frame"):
        shapes += [
            Line(frame.place([(0.0, y), (length, y)]), INK["furniture_detail"], 0.015, 0.08) for y in (-half, half)
        ]
    elif door.kind == "garage":
        shapes += _slats(frame, length, half)
    elif door.kind == "sliding" or (door.hinge == "none" and door.kind != "doorway"):
        shapes += _sliding(frame, length)
    else:
        shapes += _leaves(door, frame, length, swing_side(door, rooms))
    return Canvas("doors", tuple(shapes), door.id, title)


def _sliding(frame: Frame, length: float) -> list[Shape]:
    """Draw two panels that meet in the middle, one behind the other."""
    middle = length / 2
    return [
        Area(frame.place(rectangle(0.0, -0.035, middle, -0.005)), INK["furniture_line"], width=0.0),
        Area(frame.place(rectangle(middle, 0.005, length, 0.035)), INK["furniture_line"], width=0.0),
    ]


def _slats(frame: Frame, length: float, half: float) -> list[Shape]:
    """Draw a garage door's slats in the wall, and the edges of its opening above them."""
    edges = [Line(frame.place([(0.0, y), (length, y)]), INK["furniture_detail"], 0.015, 0.08) for y in (-half, half)]
    slats = rectangle(0.0, -0.03, length, 0.03)
    return [*edges, Area(frame.place(slats), INK["furniture_line"], width=0.0)]


def _leaves(door: Door, frame: Frame, length: float, side: int) -> list[Shape]:
    """Draw open leaves and the quarter circles that they sweep, on the given side of the wall."""
    ink = INK["glass"] if door.kind in ("glazed", "balcony") else INK["door"]
    both = door.hinge == "both" or door.kind == "double"
    radius = length / 2 if both else length
    hinges = [0.0, length] if both else [length if door.hinge == "end" else 0.0]
    shapes: list[Shape] = []
    for x in hinges:
        inward = 0.0 if x == 0.0 else 180.0
        sweep = arc((x, 0.0), radius, inward, 90.0 * side if x == 0.0 else 180.0 - 90.0 * side)
        shapes.append(Area(frame.place([(x, 0.0), *sweep]), "#ffffff66", width=0.0))
        shapes.append(Line(frame.place(sweep), ink, 0.012))
        leaf = rectangle(x - 0.02, 0.0, x + 0.02, radius * side)
        shapes.append(Area(frame.place(leaf), ink, width=0.0))
    return shapes


def _length(segment: Segment) -> float:
    (ax, ay), (bx, by) = segment
    return float(np.hypot(bx - ax, by - ay))
