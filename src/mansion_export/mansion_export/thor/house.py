"""A floor as an AI2-THOR house, schema 1.0.0 (``ProceduralTools.CreateHouse``)."""

import itertools
from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
import shapely
from shapely.geometry import Polygon, box

from mansion_export.licences import PROJECT, licence_records
from mansion_export.thor.layers import room_layers
from mansion_export.thor.reachability import ENOUGH_POSITIONS, GRID, connected_positions
from mansion_export.thor.vocabulary import AGENT_MODES, LAYERS, SCHEMA, ceiling_material, floor_material, room_type, sky
from mansion_export.thor.walls import build_structure
from mansion_geometry.rings import polygon_parts
from mansion_geometry.thor.house_format import AGENT_HEIGHT, thor_euler, thor_heading, thor_point, upright
from mansion_msgs_py.building_folder import floor_directory
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.scene import FloorScene, Light, SceneObject, SceneRoom
from mansion_msgs_py.shapes import Point

__all__ = ["house", "house_files"]

Json: TypeAlias = dict[str, Any]

GRID_SHIFTS = 3
"""Shifts of the agent's grid that are tried in each direction."""

SLIT = 0.002
"""Width of the cut that joins a hole to the outer ring, metres: AI2-THOR's floor polygons have no holes."""


def house(scene: FloorScene) -> Json:
    """Make the house JSON of a floor.

    Parameters
    ----------
    scene : FloorScene

    Returns
    -------
    dict
        Top level ``rooms``, ``walls``, ``doors``, ``windows``, ``objects``, ``proceduralParameters``, ``metadata``.
        ``metadata.mansion`` names the building and floor, the cores with the poses at their doors, and under
        ``omitted`` every object that is left out because AI2-THOR has no asset for it.
    """
    rooms = [room for room in scene.rooms if room.kind not in ("stair", "elevator")]
    height = round(max((wall.height for wall in scene.walls), default=scene.height - 0.2), 4)
    structure = build_structure(scene, height)
    layers = room_layers([room.id for room in rooms], structure.neighbours, structure.merged)
    objects, omitted = _objects(scene, layers)
    made: Json = {
        "rooms": [_room(room, layers[room.id]) for room in rooms],
        "walls": [{**wall, "layer": layers[wall["roomId"]]} for wall in structure.walls],
        "doors": structure.doors,
        "windows": structure.windows,
        "objects": objects,
        "proceduralParameters": _parameters(scene, rooms, layers, height),
    }
    agent = _agent(scene, made)
    warnings = dict.fromkeys(structure.misplaced, "no wall was found for this opening")
    metadata = {
        "schema": SCHEMA,
        "roomSpecId": scene.building_id,
        "agent": agent,
        "agentPoses": {mode: _pose(agent, mode) for mode in AGENT_MODES},
        "warnings": warnings,
        "mansion": _provenance(scene, omitted),
    }
    return {**made, "metadata": metadata}


def house_files(scene: FloorScene) -> dict[str, bytes]:
    """Return ``house.json`` of a floor by its path in the building's folder."""
    return {f"{floor_directory(scene.floor)}/house.json": encode_bytes(house(scene))}


def _pose(agent: Json, mode: str) -> Json:
    return {key: value for key, value in agent.items() if mode != "locobot" or key != "standing"}


def _room(room: SceneRoom, layer: str) -> Json:
    ring = _without_holes(room.polygon, room.holes)
    return {
        "id": room.id,
        "roomType": room_type(room.room_type),
        "name": room.name or room.room_type,
        "floorPolygon": [thor_point(x, y, 0.0) for x, y in reversed(ring)],
        "floorMaterial": floor_material(room.floor_material),
        "ceilings": [{"material": ceiling_material(room.ceiling_material)}],
        "children": [],
        "layer": layer,
    }


def _without_holes(ring: Sequence[Point], holes: Sequence[Sequence[Point]]) -> Sequence[Point]:
    """Cut a slit from each hole to the right until it meets the outside, or open it where it touches that."""
    if not holes:
        return ring
    polygon = Polygon(ring, holes)
    for hole in holes:
        touched = shapely.get_coordinates(Polygon(ring).exterior.intersection(shapely.LinearRing(hole)))
        if len(touched):
            # A slit elsewhere would cut the room in two.
            polygon = polygon.difference(shapely.Point(touched[0]).buffer(SLIT, cap_style="square"))
            continue
        x, y = max(hole)
        ray = shapely.intersection(shapely.LineString([(x, y), (polygon.bounds[2] + 1.0, y)]), Polygon(ring))
        first = min((part for part in shapely.get_parts(ray)), key=lambda part: float(part.bounds[0]))
        slit = box(x - SLIT, y - SLIT, float(first.bounds[2]) + SLIT, y)
        polygon = polygon.difference(slit)
    outer = max(polygon_parts(polygon), key=lambda part: float(part.area)).exterior
    return list(shapely.geometry.polygon.orient(Polygon(outer)).exterior.coords)[:-1]


def _parameters(scene: FloorScene, rooms: list[SceneRoom], layers: Mapping[str, str], height: float) -> Json:
    skybox, pitch, yaw, intensity, (r, g, b) = sky(scene.sky.name)
    sun: Json = {
        "id": "DirectionalLight",
        "type": "directional",
        "position": {"x": 0.84, "y": 0.1855, "z": -1.09},
        "rotation": {"x": pitch, "y": yaw, "z": 0},
        "intensity": intensity,
        "indirectMultiplier": 1.0,
        "rgb": {"r": r, "g": g, "b": b, "a": 1},
        "shadow": _shadow(0.0),
    }
    names = {room.id for room in rooms}
    lamps = [light for light in scene.lights if light.room in names and light.kind != "directional"]
    return {
        "ceilingMaterial": ceiling_material(""),
        "floorColliderThickness": 1.0,
        "receptacleHeight": 0.7,
        "lights": [sun, *(_lamp(lamp, layers, height) for lamp in lamps)],
        "reflections": [],
        "skyboxId": skybox,
    }


def _lamp(light: Light, layers: Mapping[str, str], height: float) -> Json:
    """Return a room's lamp as a point light that shines on the room's own layer only."""
    layer = layers[light.room or ""]
    red, green, blue = (int(light.color[i : i + 2], 16) / 255.0 for i in (1, 3, 5))
    x, y, z = light.position
    return {
        "id": light.id,
        "type": "point",
        "position": thor_point(x, y, min(z, height - 0.2)),
        "intensity": round(min(0.75 * light.intensity, 1.5), 3),
        "range": round(max(light.range, 5.0), 3),
        "indirectMultiplier": 1.0,
        "rgb": {"r": round(red, 4), "g": round(green, 4), "b": round(blue, 4), "a": 1},
        "shadow": _shadow(0.05),
        "layer": layer,
        "cullingMaskOff": [other for other in LAYERS if other != layer],
    }


def _shadow(bias: float) -> Json:
    return {
        "type": "Soft",
        "strength": 1.0,
        "normalBias": 0.0,
        "bias": bias,
        "nearPlane": 0.2,
        "resolution": "FromQualitySettings",
    }


def _agent(scene: FloorScene, made: Json) -> Json:
    """Return the spawn pose, moved to the nearest grid point from which the agent reaches most rooms.

    AI2-THOR's grid starts where the agent stands. Where a grid through multiples of `GRID` misses a narrow passage, one
    that is shifted by multiples of a third of `GRID` may find it.
    """
    if scene.spawn is not None:
        x, y, heading = scene.spawn.x, scene.spawn.y, thor_heading(scene.spawn.yaw)
    else:
        x, y = scene.rooms[0].polygon[0]
        heading = 0.0
    corner = (round(x / GRID) * GRID, round(y / GRID) * GRID)
    rings = [[(p["x"], p["z"]) for p in room["floorPolygon"]] for room in made["rooms"]]
    best: tuple[int, int] = (-1, -1)
    points: list[Point] = []
    for i, j in sorted(itertools.product(range(GRID_SHIFTS), repeat=2), key=max):
        start = (corner[0] + i * GRID / GRID_SHIFTS, corner[1] + j * GRID / GRID_SHIFTS)
        for component in connected_positions(made, start):
            score = (_served(component, rings), len(component))
            if score > best:
                best, points = score, component
        if best[0] == len(rings):
            break
    if points:
        x, y = min(points, key=lambda p: ((p[0] - x) ** 2 + (p[1] - y) ** 2, p))
    return {"position": thor_point(x, y, AGENT_HEIGHT), "rotation": upright(heading), "horizon": 30, "standing": True}


def _served(points: Sequence[Point], rings: Sequence[Sequence[Point]]) -> int:
    """Count the rooms that hold enough of the points."""
    if len(points) < ENOUGH_POSITIONS:
        return 0
    x, y = np.array(points).T
    return sum(int(shapely.contains_xy(Polygon(ring), x, y).sum()) >= ENOUGH_POSITIONS for ring in rings)


def _provenance(scene: FloorScene, omitted: list[Json]) -> Json:
    return {
        "building": scene.building_id,
        "floor": scene.floor,
        "floors": scene.floors,
        "elevation": scene.elevation,
        "revision": scene.revision,
        "cores": [
            {
                "id": core.id,
                "type": core.type,
                "door": core.door,
                "floors": core.floors,
                "entrance": {
                    "position": thor_point(core.entrance[0], core.entrance[1], AGENT_HEIGHT),
                    "rotation": upright(thor_heading(core.entrance[2])),
                },
            }
            for core in scene.cores
        ],
        "omitted": omitted,
        "copyright": PROJECT,
        "licences": licence_records([scene]),
    }


def _objects(scene: FloorScene, layers: Mapping[str, str]) -> tuple[list[Json], list[Json]]:
    """Return the trees of a floor's objects, and the objects that the house leaves out with the reason of each.

    Left out is what AI2-THOR has no asset for, and what would hang in the air without one of those.
    """
    items = {item.id: item for item in scene.objects}
    made: dict[str, Json] = {}
    omitted: dict[str, Json] = {}
    roots: list[Json] = []

    def add(item: SceneObject) -> None:
        """Add an object after what carries it."""
        if item.id in made or item.id in omitted:
            return
        parent = items.get(item.parent or "")
        if parent is not None and parent is not item:
            add(parent)
        reason = ""
        if item.asset_id is None:
            reason = "AI2-THOR has no such asset"
        elif parent is not None and parent.id in omitted:
            reason = f"{parent.id}, which carries it, is left out"
        if reason:
            omitted[item.id] = {"id": item.id, "category": item.category, "reason": reason}
            return
        made[item.id] = _object(item, layers)
        siblings = made[parent.id]["children"] if parent is not None else roots
        siblings.append(made[item.id])

    for item in scene.objects:
        add(item)
    return roots, list(omitted.values())


def _object(item: SceneObject, layers: Mapping[str, str]) -> Json:
    """Return an object's node without what it carries; its position is the centre of its bounding box."""
    width, depth, height = item.size
    made: Json = {
        "id": item.id,
        "assetId": item.asset_id,
        "position": thor_point(*item.position),
        "rotation": thor_euler(item.rotation),
        "kinematic": not item.pickupable,
        "roomId": item.room,
        "size": thor_point(width, depth, height),
        "children": [],
    }
    if item.room in layers:
        made["layer"] = layers[item.room]
    if "open" in item.states:
        made["openness"] = float(item.states["open"])
    if "on" in item.states:
        made["isOn"] = bool(item.states["on"])
    return made
