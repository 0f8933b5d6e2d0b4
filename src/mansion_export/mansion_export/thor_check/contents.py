"""Checks of objects, lights and metadata."""

from collections import Counter
from collections.abc import Container

from shapely.geometry import Point, Polygon

from mansion_export.thor_check.fault import HouseFault, Json, flatten, vector

__all__ = ["check_metadata", "check_objects", "check_parameters"]

AGENTS = ("default", "arm", "stretch", "locobot")
LIGHTS = frozenset(["point", "directional", "spot"])
HORIZONS = (-30, 0, 30, 60)


def check_metadata(house: Json) -> list[HouseFault]:
    """Check the schema's version and the poses of all agents, which must be ``TeleportFull`` arguments."""
    metadata = house["metadata"]
    faults = []
    if metadata.get("schema") != "1.0.0":
        faults.append(HouseFault("form", "metadata.schema", "CreateHouse takes schema 1.0.0"))
    poses = {"agent": metadata.get("agent")}
    poses |= {f"agentPoses.{name}": (metadata.get("agentPoses") or {}).get(name) for name in AGENTS}
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
    objects = flatten(house["objects"])
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
        if light.get("type") not in LIGHTS or vector(light.get("position")) is None:
            faults.append(HouseFault("light", name, f"a type of {sorted(LIGHTS)} and a position are needed"))
        rgb = light.get("rgb") or {}
        if not all(isinstance(rgb.get(c), (int, float)) and 0 <= rgb[c] <= 1 for c in "rgb"):
            faults.append(HouseFault("light", name, "rgb runs from 0 to 1"))
        if light.get("type") == "point" and light.get("layer") in light.get("cullingMaskOff", []):
            faults.append(HouseFault("light", name, "it does not shine on its own layer"))
    return faults
