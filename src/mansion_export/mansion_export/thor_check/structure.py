"""Checks of rooms, wall twins and the holes in them."""

import math
from collections import Counter
from collections.abc import Callable

from shapely.geometry import Polygon

from mansion_export.thor_check.fault import HouseFault, Json, vector

__all__ = ["check_openings", "check_rooms", "check_walls"]

LAYERS = frozenset(f"Procedural{i}" for i in range(4))
SLACK = 2e-3
"""Metres of rounding."""


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
            faults.append(HouseFault("layer", name, f"layer {room.get('layer')} is none of the four"))
        points = [vector(point) for point in room.get("floorPolygon", [])]
        if len(points) < 3 or any(point is None for point in points):
            faults.append(HouseFault("form", name, "floorPolygon needs three points with x, y, z"))
            continue
        ring = [(point[0], point[2]) for point in points if point is not None]
        shape = Polygon(ring)
        if not shape.is_valid or shape.area < 1e-3:
            faults.append(HouseFault("polygon", name, "floorPolygon is not simple"))
            continue
        if _signed_area(ring) > 0:
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
            faults.append(HouseFault("form", name, f"room {wall.get('roomId')} is not there"))
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
                fault(f"{key} {opening.get(key)} is not there")
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


def _signed_area(ring: list[tuple[float, float]]) -> float:
    return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1]))
