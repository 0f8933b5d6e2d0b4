"""Stairs and lifts of the scene: their doors, standard poses and details on one floor."""

import math
from collections.abc import Sequence
from typing import Final

from shapely.geometry import Polygon

from mansion_msgs_py.scene import CoreDetails, Door, LiftButton, LiftDetails, SceneCore
from mansion_msgs_py.shapes import Point, Point3, Ring, Segment
from mansion_msgs_py.stages import FurnishRequest
from mansion_scene.structure.dimensions import INTERIOR_THICKNESS
from mansion_scene.structure.interiors import Partition
from mansion_scene.structure.openings import Opening
from mansion_scene.structure.regions import FloorRegions, Region, ring_points
from mansion_scene.structure.stairs import core_interior, stair_details, stair_frame

__all__ = ["entrance_pose", "lift_details", "scene_cores"]

_GAP: Final = 0.08  # between the cabin and the shaft's walls
_CABIN_HEIGHT: Final = 2.3
_PANEL_HEIGHT: Final = 1.1
_BUTTON_PITCH: Final = 0.07
_PANEL_OFFSET: Final = 0.25
_BUTTONS_HEIGHT: Final = 1.25
_BUTTONS_IN_TWO_COLUMNS: Final = 24
_CABIN_WALL: Final = 0.05
_STAND_OFF: Final = 0.6  # from a core's wall to the pose before its door
_PLATE: Final = 0.02  # from a panel's middle to the face of its buttons


def lift_details(
    net: Polygon,
    landing_door: Segment,
    outward: Point,
    floors: Sequence[int],
    labels: Sequence[str],
    *,
    goes_up: bool,
    comes_from_below: bool,
) -> LiftDetails:
    """Lay out a lift on one floor.

    Parameters
    ----------
    net : Polygon
        Net interior of the shaft.
    landing_door : Segment
        Clear opening of the landing door.
    outward : Point
        Unit vector from the shaft out through the landing door.
    floors, labels : sequence
        All floors of the building, ascending, and what their buttons say.
    """
    x0, y0, x1, y1 = net.bounds
    cabin = (x0 + _GAP, y0 + _GAP, x1 - _GAP, y1 - _GAP)
    ring: Ring = [(round(x, 4), round(y, 4)) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
    panel = _button_panel(cabin, outward)
    return LiftDetails(
        cabin=((round(cabin[0], 4), round(cabin[1], 4), 0.0), (round(cabin[2], 4), round(cabin[3], 4), _CABIN_HEIGHT)),
        facing=round(math.degrees(math.atan2(outward[1], outward[0])), 4) + 0.0,
        call_panel=_call_panel(landing_door, outward),
        button_panel=panel,
        buttons=_buttons(panel, floors, labels, outward),
        floor_opening=ring if comes_from_below else [],
        ceiling_opening=ring if goes_up else [],
    )


def _call_panel(door: Segment, outward: Point) -> Point3:
    """Return the position of the call panel: on the wall to the right of the door as seen from outside."""
    (ox, oy), right = outward, (-outward[1], outward[0])
    end = max(door, key=lambda p: p[0] * right[0] + p[1] * right[1])
    face = INTERIOR_THICKNESS / 2 + 0.01
    return (
        round(end[0] + right[0] * _PANEL_OFFSET + ox * face, 4),
        round(end[1] + right[1] * _PANEL_OFFSET + oy * face, 4),
        _PANEL_HEIGHT,
    )


def _button_panel(cabin: tuple[float, float, float, float], outward: Point) -> Point3:
    """Return the position of the button panel: on the cabin's rear wall, in view through the open door."""
    (ox, oy), (rx, ry) = outward, (-outward[1], outward[0])
    cx, cy = (cabin[0] + cabin[2]) / 2, (cabin[1] + cabin[3]) / 2
    half_out = abs(ox) * (cabin[2] - cabin[0]) / 2 + abs(oy) * (cabin[3] - cabin[1]) / 2
    half_side = abs(rx) * (cabin[2] - cabin[0]) / 2 + abs(ry) * (cabin[3] - cabin[1]) / 2
    back, side = half_out - _CABIN_WALL - _PLATE, 0.4 * half_side
    return (round(cx - ox * back + rx * side, 4), round(cy - oy * back + ry * side, 4), _BUTTONS_HEIGHT)


def _buttons(panel: Point3, floors: Sequence[int], labels: Sequence[str], outward: Point) -> list[LiftButton]:
    """Return the buttons in two columns, three from 25 floors, the lowest floor bottom left."""
    columns = 2 if len(floors) <= _BUTTONS_IN_TWO_COLUMNS else 3
    rows = -(-len(floors) // columns)
    # Seen from the door, columns run to the right: against the vector to the left of the cabin's heading.
    rx, ry = outward[1], -outward[0]
    buttons = []
    for index, floor in enumerate(floors):
        row, column = divmod(index, columns)
        across = ((columns - 1) / 2 - column) * _BUTTON_PITCH
        buttons.append(
            LiftButton(
                floor=floor,
                label=labels[index] if index < len(labels) and labels[index] else str(floor),
                position=(
                    round(panel[0] + rx * across + outward[0] * _PLATE, 4),
                    round(panel[1] + ry * across + outward[1] * _PLATE, 4),
                    round(panel[2] + (row - (rows - 1) / 2) * _BUTTON_PITCH, 4),
                ),
            )
        )
    return buttons


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
    # Walls on other sides of other floors would shift flights and shafts: what all floors share is the core alone.
    net = partition.nets[region.id] if region.core is None else core_interior(region.core)
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
