"""Walls, doors, slabs and lifts as Open-RMF's building maps describe them."""

import math
from collections.abc import Sequence

from mansion_export.rmf.crossings import OPERATED
from mansion_export.rmf.free_floor import cabin_frame
from mansion_export.rmf.graph import LevelGraph
from mansion_export.rmf.yaml_text import Value
from mansion_export.solids import span
from mansion_msgs_py.scene import Door, FloorScene, SceneCore, StairDetails
from mansion_msgs_py.shapes import Point, Ring

__all__ = ["Corners", "door_params", "lift_entries", "operated_doors", "slab_rings", "wall_pieces"]

STRING, INTEGER, DOUBLE, BOOL = 1, 2, 3, 4
"""Types of parameters in ``building_map/param_value.py``."""

SHORTEST = 0.02
"""Pieces of wall shorter than this are left out, metres."""


def wall_pieces(scene: FloorScene) -> list[tuple[Point, Point]]:
    """Return the walls as centre lines, interrupted at doors; windows do not interrupt them."""
    found = []
    for wall in scene.walls:
        (ax, ay), (bx, by) = wall.segment
        length = math.hypot(bx - ax, by - ay)
        gaps = sorted(span(wall, door.segment) for door in scene.doors if door.wall == wall.id)
        at = 0.0
        for low, high in [*gaps, (length, length)]:
            if low - at > SHORTEST:
                found.append(tuple(_along(wall.segment, t / length) for t in (at, low)))
            at = max(at, high)
    return [(a, b) for a, b in found]


def _along(segment: tuple[Point, Point], t: float) -> Point:
    (ax, ay), (bx, by) = segment
    return (ax + (bx - ax) * t, ay + (by - ay) * t)


def operated_doors(scene: FloorScene) -> list[tuple[Door, Point, Point]]:
    """Return the doors with leaves, each from its hinge (or its first end) to its other end."""
    found = []
    for door in scene.doors:
        if door.kind in OPERATED:
            a, b = door.segment
            found.append((door, b, a) if door.hinge == "end" else (door, a, b))
    return found


def door_params(door: Door, start: Point, end: Point, scene: FloorScene) -> dict[str, Value]:
    """Return the parameters of a door's edge.

    In ``swing_door.py`` a leaf hangs from the edge's start, and with a negative direction turns to the left of the
    edge. A garage door, of slats that roll up, has no counterpart: it slides.
    """
    style = "double_hinged" if door.hinge == "both" else "hinged"
    if door.hinge == "none":
        style = "sliding" if door.kind == "garage" else "double_sliding"
    left = _left_of(start, end, door, scene)
    return {
        "motion_axis": [STRING, "start"],
        "motion_degrees": [DOUBLE, 90.0],
        "motion_direction": [INTEGER, -1 if left else 1],
        "name": [STRING, door.id],
        "plugin": [STRING, "normal"],
        "right_left_ratio": [DOUBLE, 1.0],
        "type": [STRING, style],
    }


def _left_of(start: Point, end: Point, door: Door, scene: FloorScene) -> bool:
    """Tell whether a door opens to the left of its edge."""
    wall = next((wall for wall in scene.walls if wall.id == door.wall), None)
    if wall is None or door.swing is None:
        return True
    (ax, ay), (bx, by) = wall.segment
    along = (end[0] - start[0]) * (bx - ax) + (end[1] - start[1]) * (by - ay) > 0.0
    return (door.swing == wall.left) == along


def slab_rings(scene: FloorScene) -> tuple[list[Ring], list[Ring]]:
    """Return the floor's outline, and the holes in it: courts and stair wells, but not the lifts' shafts."""
    wells = [
        core.details.floor_opening
        for core in scene.cores
        if isinstance(core.details, StairDetails) and core.details.floor_opening
    ]
    return [scene.outline], [*scene.holes, *wells]


def lift_entries(levels: Sequence[LevelGraph]) -> dict[str, Value]:
    """Return the lifts: cabin, door, and the levels where it opens."""
    found: dict[str, Value] = {}
    for name in sorted({core.id for level in levels for core in _lifts(level)}):
        stops = [(level, core) for level in levels for core in _lifts(level) if core.id == name]
        level, core = stops[0]
        frame = cabin_frame(core, level.scene)
        door = next(door for door in level.scene.doors if door.id == core.door)
        (ax, ay), (bx, by) = door.segment
        right = (frame.facing[1], -frame.facing[0])
        aside = ((ax + bx) / 2 - frame.x) * right[0] + ((ay + by) / 2 - frame.y) * right[1]
        found[name] = {
            "depth": frame.depth,
            "doors": {
                "door": {
                    "door_type": 2,
                    "motion_axis_orientation": 0,
                    "width": door.width,
                    "x": aside,
                    "y": frame.depth / 2,
                }
            },
            "highest_floor": stops[-1][0].name,
            "initial_floor_name": level.name,
            "level_doors": {stop.name: ["door"] for stop, _ in stops},
            "lowest_floor": level.name,
            "plugins": True,
            "reference_floor_name": level.name,
            "width": frame.width,
            "x": frame.x,
            "y": frame.y,
            "yaw": math.radians(frame.rotation),
        }
    return found


def _lifts(level: LevelGraph) -> list[SceneCore]:
    doors = {door.id for door in level.scene.doors}
    return [core for core in level.scene.cores if core.type == "elevator" and core.door in doors]


class Corners:
    """The vertices of a level, one for each place (to a millimetre) that lines meet at."""

    def __init__(self, taken: int) -> None:
        self._taken = taken
        self._index: dict[Point, int] = {}

    def at(self, point: Point) -> int:
        """Return the number of the vertex at a place."""
        place = (round(point[0], 3) + 0.0, round(point[1], 3) + 0.0)
        return self._index.setdefault(place, self._taken + len(self._index))

    def places(self) -> list[Point]:
        """Return all of them in order."""
        return list(self._index)
