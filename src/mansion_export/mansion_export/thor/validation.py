"""A validator of AI2-THOR house JSON that needs no Unity."""

import math
from collections import Counter
from collections.abc import Callable, Container, Iterable
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from shapely.geometry import Point, Polygon

from mansion_export.thor.reachability import ENOUGH_POSITIONS, reachable_positions
from mansion_export.thor.vocabulary import AGENT_MODES, HORIZONS, LAYERS, LIGHT_TYPES, SCHEMA
from mansion_geometry.rings import points_inside_ring, signed_area
from mansion_geometry.thor.house_format import object_nodes

__all__ = ["HouseFault", "validate_house"]

Json: TypeAlias = dict[str, Any]

SLACK = 2e-3
"""Metres of rounding."""

TOP_LEVEL = ("rooms", "walls", "doors", "windows", "objects", "proceduralParameters", "metadata")


class HouseFault(NamedTuple):
    """A fault: its kind, the JSON path or id where it is, and what was found instead of what is required."""

    kind: str
    where: str
    message: str

    def __str__(self) -> str:
        return f"{self.kind} {self.where}: {self.message}"


def vector(value: object) -> tuple[float, float, float] | None:
    """Return ``{"x", "y", "z"}`` as numbers, or None if it is something else."""
    if not isinstance(value, dict):
        return None
    found = [value.get(axis) for axis in ("x", "y", "z")]
    if not all(isinstance(part, (int, float)) and not isinstance(part, bool) for part in found):
        return None
    return (float(value["x"]), float(value["y"]), float(value["z"]))


def numbers(value: object, path: str = "$") -> Iterable[tuple[str, float]]:
    """Return every number of a JSON value with its path."""
    if isinstance(value, dict):
        for key, part in value.items():
            yield from numbers(part, f"{path}.{key}")
    elif isinstance(value, list):
        for i, part in enumerate(value):
            yield from numbers(part, f"{path}[{i}]")
    elif isinstance(value, float):
        yield path, value


def check_rooms(house: Json) -> list[HouseFault]:
    """Check ids, floor polygons (flat, simple, clockwise, apart) and materials."""
    faults = _repeated(house["rooms"], "rooms")
    shapes: list[tuple[str, Polygon]] = []
    for i, room in enumerate(house["rooms"]):
        name = str(room.get("id", f"rooms[{i}]"))
        for key in ("id", "roomType", "floorPolygon", "floorMaterial", "ceilings", "children"):
            if key not in room:
                faults.append(HouseFault("form", name, f"{key} is missing"))
        if not (room.get("floorMaterial") or {}).get("name"):
            faults.append(HouseFault("form", name, "floorMaterial needs a name"))
        if room.get("layer") not in LAYERS:
            faults.append(HouseFault("layer", name, f"layer {room.get('layer')} is not one of the four"))
        points = [vector(point) for point in room.get("floorPolygon", [])]
        if len(points) < 3 or any(point is None for point in points):
            faults.append(HouseFault("form", name, "floorPolygon needs three points with x, y, z"))
            continue
        ring = [(point[0], point[2]) for point in points if point is not None]
        shape = Polygon(ring)
        if not shape.is_valid or shape.area < 1e-3:
            faults.append(HouseFault("polygon", name, "floorPolygon is not simple"))
            continue
        if signed_area(ring) > 0:
            faults.append(HouseFault("polygon", name, "floorPolygon must run clockwise in (x, z)"))
        for other, known in shapes:
            if shape.intersection(known).area > 0.02:
                faults.append(HouseFault("polygon", name, f"its floor overlaps that of {other}"))
        shapes.append((name, shape))
    return faults


def check_walls(house: Json) -> list[HouseFault]:
    """Check that each wall stands upright, has its twin, and that neighbours have different layers."""
    faults = _repeated(house["walls"], "walls")
    rooms = {room["id"]: room.get("layer") for room in house["rooms"] if "id" in room}
    bases: Counter[tuple[float, ...]] = Counter()
    owners: dict[tuple[float, ...], Json] = {}
    for i, wall in enumerate(house["walls"]):
        name = str(wall.get("id", f"walls[{i}]"))
        points = [vector(point) for point in wall.get("polygon", [])]
        corners = [point for point in points if point is not None]
        if len(corners) != 4 or len(points) != 4:
            faults.append(HouseFault("form", name, "a wall's polygon has four points"))
            continue
        if wall.get("roomId") not in rooms:
            faults.append(HouseFault("form", name, f"room {wall.get('roomId')} does not exist"))
        elif wall.get("layer") != rooms[wall["roomId"]]:
            faults.append(HouseFault("layer", name, "its layer is not that of its room"))
        p0, p1, q0, q1 = corners
        if not (p0[::2] == q0[::2] and p1[::2] == q1[::2] and p0[1] == p1[1] < q0[1] == q1[1]):
            faults.append(HouseFault("wall", name, "its points must be two at the bottom and two above them"))
            continue
        key = (p0[0], p0[2], p1[0], p1[2])
        bases[key] += 1
        owners[key] = wall
    faults += _check_twins(bases, owners, rooms)
    return faults


def _check_twins(
    bases: Counter[tuple[float, ...]], owners: dict[tuple[float, ...], Json], rooms: dict[str, str | None]
) -> list[HouseFault]:
    faults = []
    for key, wall in owners.items():
        if bases[key] > 1:
            faults.append(HouseFault("wall", wall["id"], "two walls have the same two end points"))
        twin = owners.get((key[2], key[3], key[0], key[1]))
        if twin is None:
            faults.append(HouseFault("wall", wall["id"], "no twin runs the other way between its ends"))
            continue
        a, b = wall["roomId"], twin["roomId"]
        if bool(wall.get("empty")) != bool(twin.get("empty")):
            faults.append(HouseFault("wall", wall["id"], "it is empty and its twin is not"))
        if a < b and not wall.get("empty") and rooms.get(a) == rooms.get(b) and not _merged(a, b, owners):
            faults.append(HouseFault("layer", a, f"it has the layer of its neighbour {b}"))
    return faults


def _merged(a: str, b: str, owners: dict[tuple[float, ...], Json]) -> bool:
    """Tell whether open boundaries join two rooms, perhaps by way of others."""
    links: dict[str, set[str]] = {}
    for key, wall in owners.items():
        twin = owners.get((key[2], key[3], key[0], key[1]))
        if wall.get("empty") and twin is not None:
            links.setdefault(wall["roomId"], set()).add(twin["roomId"])
    seen, queue = {a}, [a]
    while queue:
        for other in links.get(queue.pop(), set()) - seen:
            seen.add(other)
            queue.append(other)
    return b in seen


def check_openings(house: Json) -> list[HouseFault]:
    """Check doors and windows against the walls that they are in."""
    walls = {wall["id"]: wall for wall in house["walls"] if "id" in wall}
    rooms = {room["id"] for room in house["rooms"] if "id" in room}
    openings = [("doors", door) for door in house["doors"]]
    openings += [("windows", window) for window in house["windows"]]
    faults = _repeated([opening for _, opening in openings], "doors and windows")
    holes: Counter[str] = Counter()
    for kind, opening in openings:
        name = str(opening.get("id", kind))

        def fault(message: str, name: str = name) -> None:
            faults.append(HouseFault("opening", name, message))

        if not opening.get("assetId"):
            fault("assetId is missing")
        if kind == "doors" and not ("openable" in opening and "openness" in opening):
            fault("a door needs openable and openness")
        for key in ("room0", "room1"):
            if opening.get(key) not in rooms:
                fault(f"{key} {opening.get(key)} does not exist")
        holes.update([str(opening.get("wall0")), str(opening.get("wall1"))])
        wall, twin = walls.get(opening.get("wall0", "")), walls.get(opening.get("wall1", ""))
        if wall is None or twin is None:
            fault("wall0 and wall1 must be walls of the house")
            continue
        if [wall["polygon"][i] for i in (0, 1)] != [twin["polygon"][i] for i in (1, 0)]:
            fault("wall0 and wall1 must be twins")
        if wall["roomId"] != opening.get("room0"):
            fault("wall0 must be a wall of room0")
        _check_hole(opening, wall, fault)
    faults += [
        HouseFault("opening", name, f"{count} holes in one wall; CreateHouse takes one")
        for name, count in holes.items()
        if count > 1
    ]
    return faults


def _check_hole(opening: Json, wall: Json, fault: Callable[[str], None]) -> None:
    """Check ``holePolygon`` (two points, lowest and highest corner along the wall) and the asset's place."""
    corners = [vector(point) for point in opening.get("holePolygon", [])]
    if len(corners) != 2 or corners[0] is None or corners[1] is None:
        fault("holePolygon must be exactly two points")
        return
    low, high = corners[0], corners[1]
    p0, p1, top = wall["polygon"][0], wall["polygon"][1], wall["polygon"][2]["y"]
    width = math.hypot(p1["x"] - p0["x"], p1["z"] - p0["z"])
    if not (-SLACK <= low[0] < high[0] <= width + SLACK):
        fault(f"the hole from {low[0]} to {high[0]} m is not within the wall's {width:.3f} m")
    if not (-SLACK <= low[1] < high[1] <= top + SLACK):
        fault(f"the hole from {low[1]} to {high[1]} m is not within the wall's height {top}")
    place = vector(opening.get("assetPosition"))
    if place is None:
        fault("assetPosition is missing")
    elif any(abs(place[i] - (low[i] + high[i]) / 2) > SLACK for i in (0, 1)):
        fault("assetPosition must be the middle of the hole")
    if wall.get("empty"):
        fault("its wall is empty")


def _repeated(items: list[Json], place: str) -> list[HouseFault]:
    counts = Counter(item.get("id") for item in items)
    return [
        HouseFault("id", str(name), f"the id appears {count} times in {place}")
        for name, count in counts.items()
        if count > 1 or not name
    ]


def check_metadata(house: Json) -> list[HouseFault]:
    """Check the schema's version and the poses of all agents, which must be ``TeleportFull`` arguments."""
    metadata = house["metadata"]
    faults = []
    if metadata.get("schema") != SCHEMA:
        faults.append(HouseFault("form", "metadata.schema", f"CreateHouse takes schema {SCHEMA}"))
    poses = {"agent": metadata.get("agent")}
    poses |= {f"agentPoses.{name}": (metadata.get("agentPoses") or {}).get(name) for name in AGENT_MODES}
    for name, pose in poses.items():
        if not isinstance(pose, dict):
            faults.append(HouseFault("form", f"metadata.{name}", "the pose is missing"))
            continue
        if vector(pose.get("position")) is None or vector(pose.get("rotation")) is None:
            faults.append(HouseFault("form", f"metadata.{name}", "position and rotation are x, y, z"))
        if pose.get("horizon") not in HORIZONS:
            faults.append(HouseFault("form", f"metadata.{name}", f"horizon is one of {HORIZONS}"))
        if ("standing" in pose) == name.endswith("locobot"):
            message = "a locobot cannot stand up" if "standing" in pose else "standing is missing"
            faults.append(HouseFault("form", f"metadata.{name}", message))
    return faults


def check_objects(house: Json, known_assets: Container[str] | None) -> list[HouseFault]:
    """Check ids, assets, finite poses, and that each object lies in its room and has its layer."""
    objects = list(object_nodes(house["objects"]))
    counts = Counter(item.get("id") for item in objects)
    faults = [
        HouseFault("id", str(name), f"{count} objects have this id")
        for name, count in counts.items()
        if count > 1 or not name
    ]
    rooms = {room["id"]: room for room in house["rooms"] if "id" in room}
    floors = {
        name: Polygon([(p["x"], p["z"]) for p in room["floorPolygon"]]).buffer(0.05)
        for name, room in rooms.items()
        if len(room.get("floorPolygon", [])) >= 3
    }
    for item in objects:
        name = str(item.get("id"))
        if not item.get("assetId"):
            faults.append(HouseFault("asset", name, "assetId is missing"))
        elif known_assets is not None and item["assetId"] not in known_assets:
            faults.append(HouseFault("asset", name, f"AI2-THOR has no asset {item['assetId']}"))
        position, size = vector(item.get("position")), vector(item.get("size"))
        if position is None or vector(item.get("rotation")) is None or size is None:
            faults.append(HouseFault("form", name, "position, rotation and size are x, y, z"))
            continue
        if position[1] - size[1] / 2 < -0.05:
            faults.append(HouseFault("object", name, "it reaches below the floor"))
        room = item.get("roomId")
        if room in floors and not floors[room].contains(Point(position[0], position[2])):
            faults.append(HouseFault("object", name, f"its centre is not in {room}"))
        if room in rooms and item.get("layer") != rooms[room].get("layer"):
            faults.append(HouseFault("layer", name, "its layer is not that of its room"))
        if not isinstance(item.get("kinematic"), bool):
            faults.append(HouseFault("form", name, "kinematic is true or false"))
    return faults


def check_parameters(house: Json) -> list[HouseFault]:
    """Check the lights, the sky box and the numbers that ``CreateHouse`` reads."""
    parameters = house["proceduralParameters"]
    keys = ("ceilingMaterial", "floorColliderThickness", "receptacleHeight", "lights", "skyboxId")
    faults = [
        HouseFault("form", f"proceduralParameters.{key}", "the key is missing") for key in keys if key not in parameters
    ]
    lights = parameters.get("lights", [])
    if not any(light.get("type") == "directional" for light in lights):
        faults.append(HouseFault("light", "proceduralParameters.lights", "there is no sun"))
    counts = Counter(light.get("id") for light in lights)
    faults += [
        HouseFault("id", str(name), f"{count} lights have this id") for name, count in counts.items() if count > 1
    ]
    for light in lights:
        name = str(light.get("id"))
        if light.get("type") not in LIGHT_TYPES or vector(light.get("position")) is None:
            faults.append(HouseFault("light", name, f"a type of {sorted(LIGHT_TYPES)} and a position are needed"))
        rgb = light.get("rgb") or {}
        if not all(isinstance(rgb.get(c), (int, float)) and 0 <= rgb[c] <= 1 for c in "rgb"):
            faults.append(HouseFault("light", name, "rgb runs from 0 to 1"))
        if light.get("type") == "point" and light.get("layer") in light.get("cullingMaskOff", []):
            faults.append(HouseFault("light", name, "it does not shine on its own layer"))
    return faults


def validate_house(house: Json, known_assets: Container[str] | None = None) -> list[HouseFault]:
    """Check a house JSON as far as that goes without Unity.

    Parameters
    ----------
    house : dict
        As `mansion_export.thor.house` makes it: schema 1.0.0, objects with ``size``.
    known_assets : container of str, optional
        AI2-THOR's asset ids; others are faults. Not checked when it is left out.

    Returns
    -------
    list of HouseFault
        Empty for a sound house. Beyond the schema it is checked that floors run clockwise and do not overlap, that
        walls come in twins with at most one hole each, that holes lie inside their walls, that neighbouring rooms
        have different layers, that objects stand in their rooms, and, as ``House.validate`` does in Unity, that the
        agent reaches at least five grid points in every room and none outside.
    """
    missing = [HouseFault("form", key, "the key is missing") for key in TOP_LEVEL if key not in house]
    if missing:
        return missing
    faults = [
        HouseFault("number", path, f"{value} is not finite")
        for path, value in numbers(house)
        if not math.isfinite(value)
    ]
    try:
        return [*faults, *_faults_of_parts(house, known_assets)]
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        why = f"a part is of another type than the schema's: {type(error).__name__}: {str(error)[:200]}"
        return [*faults, HouseFault("form", "house", why)]


def _faults_of_parts(house: Json, known_assets: Container[str] | None) -> list[HouseFault]:
    """Return the faults of a house that has all its keys; fails in any way on parts of other types."""
    faults = check_metadata(house)
    faults += check_rooms(house)
    faults += check_walls(house)
    faults += check_openings(house)
    faults += check_objects(house, known_assets)
    faults += check_parameters(house)
    if not any(fault.kind in ("form", "number", "wall", "opening") for fault in faults):
        faults += _check_reachability(house)
    return faults


def _check_reachability(house: Json) -> list[HouseFault]:
    position = vector(house["metadata"]["agent"]["position"])
    if position is None:
        return []
    start = (position[0], position[2])
    positions = reachable_positions(house, start)
    if not positions:
        return [HouseFault("agent", "metadata.agent", f"the agent does not fit at {start}")]
    xs, zs = np.array(positions, dtype=float).T
    homeless = np.ones(len(positions), dtype=bool)
    counts = {}
    for room in house["rooms"]:
        here = homeless & points_inside_ring([(p["x"], p["z"]) for p in room["floorPolygon"]], xs, zs)
        counts[room["id"]] = int(here.sum())
        homeless &= ~here
    found = [HouseFault("reach", str(positions[at]), "reachable, and in no room") for at in np.flatnonzero(homeless)]
    found += [
        HouseFault("reach", name, f"{count} reachable positions, {ENOUGH_POSITIONS} are required")
        for name, count in counts.items()
        if count < ENOUGH_POSITIONS
    ]
    return found
