"""A building for Open-RMF: the map that its traffic editor opens, and the graph that its fleet adapters read."""

from collections.abc import Sequence
from typing import cast

from mansion_export.rmf.fixtures import (
    BOOL,
    DOUBLE,
    INTEGER,
    STRING,
    Corners,
    door_params,
    lift_entries,
    operated_doors,
    slab_rings,
    wall_pieces,
)
from mansion_export.rmf.graph import Lane, LevelGraph, Waypoint, building_graph
from mansion_export.rmf.yaml_text import Value, yaml_text
from mansion_geometry.robot_body import ROBOT_RADIUS
from mansion_msgs_py.scene import FloorScene

__all__ = ["building_map", "nav_graph", "rmf_files"]


def rmf_files(scenes: Sequence[FloorScene], radius: float = ROBOT_RADIUS) -> dict[str, bytes]:
    """Write a building for Open-RMF.

    Parameters
    ----------
    scenes : sequence of FloorScene
    radius : float
        Of the robot that the lanes are for, metres.

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
