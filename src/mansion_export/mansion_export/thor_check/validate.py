"""All checks of a house, in order: form, structure, contents, reachability."""

import math
from collections.abc import Container

from mansion_export.sides import contains
from mansion_export.thor.reachability import reachable
from mansion_export.thor_check.contents import check_metadata, check_objects, check_parameters
from mansion_export.thor_check.fault import HouseFault, Json, numbers, vector
from mansion_export.thor_check.structure import check_openings, check_rooms, check_walls

__all__ = ["LEAST_POSITIONS", "validate_house"]

LEAST_POSITIONS = 5
"""Reachable grid points that ``House.validate`` of ProcTHOR asks of each room."""

TOP_LEVEL = ("rooms", "walls", "doors", "windows", "objects", "proceduralParameters", "metadata")


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
    faults += check_metadata(house)
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
    components = reachable(house, start)
    if not components:
        return [HouseFault("agent", "metadata.agent", f"the agent does not fit at {start}")]
    found: list[HouseFault] = []
    counts = {room["id"]: 0 for room in house["rooms"]}
    rings = {room["id"]: [(p["x"], p["z"]) for p in room["floorPolygon"]] for room in house["rooms"]}
    for x, z in components[0]:
        home = next((name for name, ring in rings.items() if contains(ring, x, z)), None)
        if home is None:
            found.append(HouseFault("reach", f"({x}, {z})", "reachable, and in no room"))
        else:
            counts[home] += 1
    found += [
        HouseFault("reach", name, f"{count} reachable positions, {LEAST_POSITIONS} are asked")
        for name, count in counts.items()
        if count < LEAST_POSITIONS
    ]
    return found
