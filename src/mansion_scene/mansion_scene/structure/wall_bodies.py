"""Numbered walls from boundary stretches, and the doors and windows in them, in the scene's types."""

import math
from collections.abc import Mapping, Sequence

from mansion_msgs_py.scene import Door, SceneRoom, Wall, Window
from mansion_msgs_py.shapes import Point, Segment
from mansion_scene.structure.dimensions import (
    DOOR_HEIGHT,
    EXTERIOR_THICKNESS,
    GARAGE_DOOR_HEIGHT,
    INTERIOR_THICKNESS,
    PARAPET_HEIGHT,
)
from mansion_scene.structure.facade_materials import DEFAULT_FACADE
from mansion_scene.structure.openings import Opening
from mansion_scene.structure.regions import FloorRegions, ring_points
from mansion_scene.structure.room_classes import is_class
from mansion_scene.structure.stretches import Stretch
from mansion_scene.structure.windows import WindowOpening

__all__ = ["number_doors", "number_walls", "number_windows"]

_CORE_WALL = "raw_concrete"


def _outside(stretch: Stretch, point: Point) -> Point:
    """Move a point of an exterior stretch from the outline to the outer wall's centre line."""
    dx, dy = stretch.direction
    half = EXTERIOR_THICKNESS / 2
    return round(point[0] + dy * half, 4) + 0.0, round(point[1] - dx * half, 4) + 0.0


def _outline_corners(floor: FloorRegions) -> dict[Point, Point]:
    """Return, for each corner of the outline, where the centre lines of its two outer walls meet."""
    corners: dict[Point, Point] = {}
    for ring in (floor.outline.exterior, *floor.outline.interiors):
        points = ring_points(ring)
        for index, point in enumerate(points):
            before, after = points[index - 1], points[(index + 1) % len(points)]
            (ax, ay), (bx, by) = _outward(before, point), _outward(point, after)
            scale = EXTERIOR_THICKNESS / 2 / max(1.0 + ax * bx + ay * by, 0.2)
            meeting = point[0] + (ax + bx) * scale, point[1] + (ay + by) * scale
            corners[_key(point)] = round(meeting[0], 4) + 0.0, round(meeting[1], 4) + 0.0
    return corners


def _outward(start: Point, end: Point) -> Point:
    length = math.dist(start, end)
    return (end[1] - start[1]) / length, (start[0] - end[0]) / length


def _key(point: Point) -> Point:
    return round(point[0], 2) + 0.0, round(point[1], 2) + 0.0


def _center_line(stretch: Stretch, corners: Mapping[Point, Point]) -> Segment:
    """Return the centre line of a stretch's wall; outer walls meet at the corners of the building."""
    if not stretch.exterior:
        return _on_wall(stretch, (stretch.start, stretch.end))
    ends = [corners.get(_key(point)) or _outside(stretch, point) for point in (stretch.start, stretch.end)]
    return ends[0], ends[1]


def _on_wall(stretch: Stretch, segment: Segment) -> Segment:
    if stretch.exterior:
        return _outside(stretch, segment[0]), _outside(stretch, segment[1])
    (ax, ay), (bx, by) = segment
    return (round(ax, 4) + 0.0, round(ay, 4) + 0.0), (round(bx, 4) + 0.0, round(by, 4) + 0.0)


def number_walls(
    floor: FloorRegions,
    stretches: Sequence[Stretch],
    rooms: Mapping[str, SceneRoom],
    ceiling: float,
    facade: str = DEFAULT_FACADE,
) -> list[tuple[Stretch, Wall]]:
    """Return each stretch with its wall; ids count in the floor's order.

    Balconies and terraces have a parapet towards the outside instead of a wall.
    """
    corners = _outline_corners(floor)
    walls = []
    for number, stretch in enumerate(stretches, start=1):
        parapet = stretch.exterior and is_class(floor.by_id[stretch.left].room_type, "outdoor")
        walls.append(
            (
                stretch,
                Wall(
                    id=f"F{floor.floor}/wall_{number}",
                    segment=_center_line(stretch, corners),
                    thickness=EXTERIOR_THICKNESS if stretch.exterior else INTERIOR_THICKNESS,
                    height=PARAPET_HEIGHT if parapet else ceiling,
                    exterior=stretch.exterior,
                    structural=stretch.structural,
                    left=stretch.left,
                    right=stretch.right,
                    left_material=_face(stretch.left, rooms),
                    right_material=facade if stretch.exterior else _face(stretch.right, rooms),
                ),
            )
        )
    return walls


def _face(region: str | None, rooms: Mapping[str, SceneRoom]) -> str:
    room = rooms.get(region) if region is not None else None
    return room.wall_material if room is not None else _CORE_WALL


def _wall_of(walls: Sequence[tuple[Stretch, Wall]], stretch: Stretch) -> Wall:
    """Return the wall of the stretch that an opening interrupts (the opening may know only a part of it)."""
    middle = stretch.at(stretch.length / 2)
    for own, wall in walls:
        if (own.left, own.right) != (stretch.left, stretch.right):
            continue
        dx, dy = own.direction
        along = (middle[0] - own.start[0]) * dx + (middle[1] - own.start[1]) * dy
        across = (middle[0] - own.start[0]) * dy - (middle[1] - own.start[1]) * dx
        if abs(across) < 0.01 and -0.01 < along < own.length + 0.01:
            return wall
    raise AssertionError(f"no wall between {stretch.left} and {stretch.right} at {middle}")


def number_doors(
    floor: FloorRegions, walls: Sequence[tuple[Stretch, Wall]], openings: Sequence[Opening], ceiling: float
) -> list[Door]:
    """Return the doors in the order of the openings, numbered on."""
    doors = []
    for number, opening in enumerate(openings, start=1):
        kind = opening.kind
        is_open = kind.kind == "open"
        segment = _on_wall(opening.stretch, opening.segment)
        tall = GARAGE_DOOR_HEIGHT if kind.kind == "garage" else DOOR_HEIGHT
        doors.append(
            Door(
                id=f"F{floor.floor}/door_{number}",
                kind=kind.kind,
                segment=segment,
                rooms=opening.regions,
                width=round(math.dist(*segment), 4),
                height=ceiling if is_open else round(min(tall, ceiling - 0.05), 4),
                wall="" if is_open else _wall_of(walls, opening.stretch).id,
                hinge=opening.hinge,
                swing=opening.swing,
                is_open=kind.kind not in ("sliding", "entrance", "garage"),
                material=kind.material,
            )
        )
    return doors


def number_windows(
    floor: FloorRegions, walls: Sequence[tuple[Stretch, Wall]], windows: Sequence[WindowOpening]
) -> list[Window]:
    """Return the windows in their order, numbered on."""
    return [
        Window(
            id=f"F{floor.floor}/window_{number}",
            wall=_wall_of(walls, window.stretch).id,
            room=window.region,
            segment=_on_wall(window.stretch, window.segment),
            sill=window.kind.sill,
            height=window.kind.height,
            kind=window.kind.name,
        )
        for number, window in enumerate(windows, start=1)
    ]
