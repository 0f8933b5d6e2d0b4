"""The building map and the navigation graph of Open-RMF, as YAML."""

import json
import math
from collections.abc import Sequence
from typing import TypeAlias, cast

from mansion_export.meshes.walls import span
from mansion_export.rmf.free_floor import cabin_frame
from mansion_export.rmf.graph import OPERATED, Lane, LevelGraph, Waypoint, building_graph
from mansion_geometry.robot_body import ROBOT_RADIUS
from mansion_msgs_py.scene import Door, FloorScene, SceneCore, StairDetails
from mansion_msgs_py.shapes import Point, Ring

__all__ = [
    "Corners",
    "Value",
    "building_map",
    "door_params",
    "lift_entries",
    "nav_graph",
    "operated_doors",
    "rmf_files",
    "slab_rings",
    "wall_pieces",
    "yaml_text",
]


Value: TypeAlias = "dict[str, Value] | list[Value] | str | bool | int | float"
"""What JSON and YAML hold."""

STRING, INTEGER, DOUBLE, BOOL = 1, 2, 3, 4
"""Types of parameters in ``building_map/param_value.py``."""

SHORTEST = 0.02
"""Pieces of wall shorter than this are left out, metres."""


def rmf_files(scenes: Sequence[FloorScene], radius: float = ROBOT_RADIUS) -> dict[str, bytes]:
    """Write a building for Open-RMF.

    Parameters
    ----------
    scenes : sequence of FloorScene
    radius : float
        Radius of the robot that the lanes are for, metres.

    Returns
    -------
    dict of str to bytes
        ``NAME.building.yaml`` and ``nav_graphs/0.yaml``, the graph that ``building_map_generator nav`` makes of it.
    """
    levels = building_graph(scenes, radius)
    name = levels[0].scene.building_id if levels else "building"
    return {
        f"{name}.building.yaml": yaml_text(building_map(name, levels)).encode(),
        "nav_graphs/0.yaml": yaml_text(nav_graph(name, levels)).encode(),
    }


def building_map(name: str, levels: Sequence[LevelGraph]) -> dict[str, Value]:
    """Return a building map (``rmf_building_map_tools``): metres, y up, one level for each floor."""
    return {
        "coordinate_system": "cartesian_meters",
        "name": name,
        "levels": {level.name: _level(level) for level in levels},
        "lifts": lift_entries(levels),
    }


def nav_graph(name: str, levels: Sequence[LevelGraph]) -> dict[str, Value]:
    """Return a navigation graph (``rmf_fleet_adapter``'s ``parse_graph``): every lane twice, once each way."""
    lifts = {
        lift: {"position": [entry["x"], entry["y"], entry["yaw"]], "dims": [entry["width"], entry["depth"]]}
        for lift, entry in cast("dict[str, dict[str, Value]]", lift_entries(levels)).items()
    }
    doors: dict[str, Value] = {
        door.id: {"endpoints": [[*_millimetres(a)], [*_millimetres(b)]], "map": level.name}
        for level in levels
        for door, a, b in operated_doors(level.scene)
    }
    return {
        "building_name": name,
        "levels": {level.name: _level_lanes(level) for level in levels},
        "lifts": cast(Value, lifts),
        "doors": doors,
        "offset": [0, 0],
    }


def _level(level: LevelGraph) -> dict[str, Value]:
    corners = Corners(len(level.waypoints))
    scene = level.scene
    walls: list[Value] = [[corners.at(a), corners.at(b), {}] for a, b in wall_pieces(scene)]
    doors: list[Value] = [
        [corners.at(a), corners.at(b), door_params(door, a, b, scene)] for door, a, b in operated_doors(scene)
    ]
    outlines, wells = slab_rings(scene)
    floors: list[Value] = [
        {"parameters": _texture(), "vertices": [corners.at(point) for point in ring]} for ring in outlines
    ]
    holes: list[Value] = [{"parameters": {}, "vertices": [corners.at(point) for point in ring]} for ring in wells]
    points: list[Value] = [
        [*point.place, 0.0, point.name, {key: [BOOL, True] for key in _marks(point)}] for point in level.waypoints
    ]
    points += [[x, y, 0.0, "", {}] for x, y in corners.places()]
    x_meters, y_meters = (max(point[k] for point in scene.outline) for k in (0, 1))
    return {
        "elevation": scene.elevation,
        "x_meters": x_meters,
        "y_meters": y_meters,
        "flattened_x_offset": 0.0,
        "flattened_y_offset": 0.0,
        "vertices": points,
        "lanes": [_lane(lane) for lane in level.lanes],
        "walls": walls,
        "doors": doors,
        "floors": floors,
        "holes": holes,
        "layers": {},
    }


def _lane(lane: Lane) -> Value:
    return [
        lane.start,
        lane.end,
        {"bidirectional": [BOOL, True], "graph_idx": [INTEGER, 0], "orientation": [STRING, ""]},
    ]


def _texture() -> dict[str, Value]:
    return {
        "texture_name": [STRING, "blue_linoleum"],
        "texture_rotation": [DOUBLE, 0.0],
        "texture_scale": [DOUBLE, 1.0],
    }


def _marks(point: Waypoint) -> list[str]:
    """Return what is true of a waypoint, as the formats call it."""
    marks = {
        "is_charger": point.charger,
        "is_holding_point": bool(point.name) and not point.lift,
        "is_parking_spot": point.parking,
    }
    return [key for key, holds in marks.items() if holds]


def _level_lanes(level: LevelGraph) -> dict[str, Value]:
    """Return a level's waypoints and lanes, waypoints numbered in the order in which lanes name them."""
    order = list(dict.fromkeys(i for lane in level.lanes for i in (lane.start, lane.end)))
    number = {old: new for new, old in enumerate(order)}
    vertices: list[Value] = []
    for i in order:
        point = level.waypoints[i]
        options: dict[str, Value] = {"name": point.name, **dict.fromkeys(_marks(point), True)}
        if point.lift:
            options["lift"] = point.lift
        vertices.append([*point.place, options])
    lanes: list[Value] = []
    for lane in level.lanes:
        options = {"door_name": lane.door} if lane.door else {}
        start, end = number[lane.start], number[lane.end]
        lanes += [[start, end, options], [end, start, options]]
    return {"vertices": vertices, "lanes": lanes}


def _millimetres(point: tuple[float, float]) -> tuple[float, float]:
    return (round(point[0], 3) + 0.0, round(point[1], 3) + 0.0)


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


def yaml_text(value: dict[str, Value], depth: int = 3) -> str:
    """Write a document.

    Parameters
    ----------
    value : dict
        Numbers are written with at most four decimals.
    depth : int
        Levels of dictionaries that are written as blocks; what is below them stands on one line, as JSON, which YAML
        1.2 holds in it.
    """
    return "\n".join(_lines(value, depth, "")) + "\n"


def _lines(value: dict[str, Value], depth: int, indent: str) -> list[str]:
    lines = []
    for key, item in value.items():
        name = f"{indent}{_flow(key)}:"
        if isinstance(item, dict) and item and depth > 1:
            lines += [name, *_lines(item, depth - 1, indent + "  ")]
        elif isinstance(item, list) and any(isinstance(part, list | dict) for part in item):
            lines += [name, *(f"{indent}  - {_flow(part)}" for part in item)]
        else:
            lines.append(f"{name} {_flow(item)}")
    return lines


def _flow(value: Value) -> str:
    return json.dumps(_rounded(value), ensure_ascii=False)


def _rounded(value: Value) -> Value:
    if isinstance(value, float):
        return round(value, 4) + 0.0
    if isinstance(value, list):
        return [_rounded(item) for item in value]
    if isinstance(value, dict):
        return {key: _rounded(item) for key, item in value.items()}
    return value
