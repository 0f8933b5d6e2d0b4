"""Stairs and lifts of the scene: their doors, standard poses and details on one floor."""

import math
from collections.abc import Sequence

from mansion_msgs_py.scene import CoreDetails, Door, SceneCore
from mansion_msgs_py.shapes import Point, Point3
from mansion_msgs_py.stages import FurnishRequest
from mansion_scene.structure.dimensions import INTERIOR_THICKNESS
from mansion_scene.structure.interiors import Partition
from mansion_scene.structure.lifts import lift_details
from mansion_scene.structure.openings import Opening
from mansion_scene.structure.regions import FloorRegions, Region, ring_points
from mansion_scene.structure.stairs import stair_details, stair_frame

__all__ = ["entrance_pose", "scene_cores"]

_STAND_OFF = 0.6  # metres from the wall's face


def entrance_pose(opening: Opening, core: str, *, stand_off: float = _STAND_OFF) -> Point3:
    """Return the standard pose outside a core: before the middle of its door, facing away; x, y, yaw in degrees."""
    room = next(region for region in opening.regions if region is not None and region != core)
    nx, ny = opening.inward(room)
    (ax, ay), (bx, by) = opening.segment
    depth = INTERIOR_THICKNESS / 2 + stand_off
    return (
        round((ax + bx) / 2 + nx * depth, 4) + 0.0,
        round((ay + by) / 2 + ny * depth, 4) + 0.0,
        round(math.degrees(math.atan2(ny, nx)), 4) + 0.0,
    )


def scene_cores(
    request: FurnishRequest,
    floor: FloorRegions,
    partition: Partition,
    openings: Sequence[Opening],
    doors: Sequence[Door],
) -> list[SceneCore]:
    """Return the cores of a floor in the order of the building's.

    Every core opens by exactly one door on the floor: the first of its openings.
    """
    cores = []
    for region in floor.regions:
        if region.core is None:
            continue
        index = next(i for i, opening in enumerate(openings) if region.id in opening.regions)
        opening = openings[index]
        cores.append(
            SceneCore(
                id=region.id,
                type=region.core.type,
                polygon=ring_points(region.polygon.exterior),
                door=doors[index].id,
                entrance=entrance_pose(opening, region.id),
                floors=sorted(request.floors),
                details=_details(request, floor, region, partition, opening),
            )
        )
    return cores


def _details(
    request: FurnishRequest, floor: FloorRegions, region: Region, partition: Partition, opening: Opening
) -> CoreDetails:
    net = partition.nets[region.id]
    goes_up = any(number > floor.floor for number in request.floors)
    from_below = any(number < floor.floor for number in request.floors)
    if region.kind == "stair" and region.core is not None:
        frame = stair_frame(region.core, net, floor.outline)
        return stair_details(region.id, frame, request.floor.height, goes_up=goes_up, comes_from_below=from_below)
    inward = opening.inward(region.id)
    outward: Point = (-inward[0] + 0.0, -inward[1] + 0.0)
    order = sorted(range(len(request.floors)), key=lambda i: request.floors[i])
    return lift_details(
        net,
        opening.segment,
        outward,
        [request.floors[i] for i in order],
        [request.labels[i] if i < len(request.labels) else "" for i in order],
        goes_up=goes_up,
        comes_from_below=from_below,
    )
