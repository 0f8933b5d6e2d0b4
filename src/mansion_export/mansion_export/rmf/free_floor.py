"""The region of a floor where the centre of a fleet's robot may be, given that it can have doors opened."""

from dataclasses import dataclass

import shapely
from shapely.geometry import Polygon, box
from shapely.geometry.base import BaseGeometry

from mansion_export.meshes.door_sides import shaft_of
from mansion_export.meshes.walls import WallBodies
from mansion_geometry.doorways import depth_of_doors
from mansion_geometry.floor_regions import disc_positions, largest_first, open_floor, strip
from mansion_geometry.object_footprints import footprint, footprint_at, stops_robots
from mansion_geometry.robot_body import CLEARANCE
from mansion_msgs_py.scene import Door, FloorScene, LiftDetails, SceneCore
from mansion_msgs_py.shapes import Point

__all__ = ["CabinFrame", "cabin_frame", "free_floor", "walkable"]

CABIN_GAP, CABIN_WALL = 0.08, 0.05
"""Between shaft and cabin, and of the cabin's walls; metres. The gap is for lifts without details."""

FACINGS: dict[float, Point] = {0.0: (0.0, 1.0), 90.0: (-1.0, 0.0), 180.0: (0.0, -1.0), -90.0: (1.0, 0.0)}
"""The y axis of a frame that is turned by that many degrees."""


@dataclass(frozen=True, slots=True)
class CabinFrame:
    """A lift's cabin in a frame whose y axis points out through its door.

    Attributes
    ----------
    x, y : float
        Centre, metres.
    facing : (float, float)
        Unit vector from the cabin out through its door.
    rotation : float
        Degrees counter-clockwise from the plan's axes to the frame's.
    width, depth : float
        Along the door and away from it, outside.
    outer : Polygon
    """

    x: float
    y: float
    facing: Point
    rotation: float
    width: float
    depth: float
    outer: Polygon


def cabin_frame(core: SceneCore, scene: FloorScene) -> CabinFrame:
    """Return the cabin of a lift, seen from its door on this floor."""
    shaft = shaft_of(core, scene)
    x0, y0, x1, y1 = Polygon(core.polygon).buffer(-CABIN_GAP, join_style="mitre").bounds
    if isinstance(core.details, LiftDetails):
        (x0, y0, _), (x1, y1, _) = core.details.cabin
    facing = FACINGS[shaft.rotation]
    width, depth = (y1 - y0, x1 - x0) if facing[0] else (x1 - x0, y1 - y0)
    x, y = (x0 + x1) / 2, (y0 + y1) / 2
    return CabinFrame(x, y, facing, shaft.rotation, width, depth, box(x0, y0, x1, y1))


def free_floor(scene: FloorScene) -> BaseGeometry:
    """Return the floor that nothing lower than `mansion_geometry.robot_body.CLEARANCE` stands or hangs on; metres.

    Doors between rooms count as open, for a fleet asks for them to be opened; outer doors and stairs are not floor.
    """
    rooms = [Polygon(room.polygon, room.holes) for room in scene.rooms if room.kind != "stair"]
    depths = depth_of_doors(scene)
    inner = [strip(door.segment, depths[door.id] + 2e-3) for door in scene.doors if _inside(door, scene)]
    bodies = WallBodies(scene)
    solid = [
        footprint_at(part.center, part.size, part.rotation)
        for wall in scene.walls
        for part in bodies.boxes(wall)
        if part.center[2] - part.size[2] / 2 < CLEARANCE
    ]
    shafts = [Polygon(core.polygon) for core in scene.cores]
    solid += [footprint(item) for item in scene.objects if stops_robots(item)]
    floor = open_floor([open_floor(rooms, shafts), *inner], solid)
    return shapely.union_all([floor, *_cabins(scene)])


def walkable(scene: FloorScene, radius: float) -> list[Polygon]:
    """Return where the centre of a disc of this radius may be, as connected parts, largest first."""
    return largest_first(disc_positions(free_floor(scene), radius, quad_segs=8))


def _inside(door: Door, scene: FloorScene) -> bool:
    stairs = {core.id for core in scene.cores if core.type == "stair"}
    return door.rooms[1] is not None and not stairs & set(door.rooms)


def _cabins(scene: FloorScene) -> list[Polygon]:
    """Return the insides of the cabins, each with the way over its sill."""
    doors = {door.id: door for door in scene.doors}
    found = []
    for core in scene.cores:
        door = doors.get(core.door)
        if core.type != "elevator" or door is None:
            continue
        frame = cabin_frame(core, scene)
        (ax, ay), (bx, by) = door.segment
        fx, fy = frame.facing
        deep = abs((ax - frame.x) * fx + (ay - frame.y) * fy)
        sill = Polygon([(ax, ay), (bx, by), (bx - fx * deep, by - fy * deep), (ax - fx * deep, ay - fy * deep)])
        inside = frame.outer.buffer(-CABIN_WALL, join_style="mitre")
        found += [inside, sill]
    return found
