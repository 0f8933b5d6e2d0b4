"""Checks that the rooms partition their floor, and that rooms and cores are walled all around but for openings."""

from collections.abc import Iterator

from shapely import LineString, Polygon, STRtree
from shapely.ops import unary_union

from mansion_bringup.check.fault import Fault
from mansion_bringup.check.shapes import free_region, net_area, room_area
from mansion_msgs_py.scene import FloorScene

__all__ = ["check_partition", "check_walls"]

COVERAGE = 0.999
AREA_SLACK = 0.01
"""Square metres of overlap or overhang that count as rounding."""


def check_partition(scene: FloorScene) -> Iterator[Fault]:
    """Yield faults of the rooms' polygons."""
    rooms = [room for room in scene.rooms if room.kind not in ("stair", "elevator")]
    shapes = [room_area(room) for room in rooms]
    for room, shape in zip(rooms, shapes):
        if abs(shape.area - room.area) > 0.02 * shape.area + AREA_SLACK:
            yield Fault("ROOM_AREA", room.id, f"states an area of {room.area:.2f} m2, but has {shape.area:.2f} m2")
    region = free_region(scene.outline, scene.holes, [core.polygon for core in scene.cores])
    for room, shape in zip(rooms, shapes):
        net = net_area(room)
        if net.difference(shape.buffer(1e-3)).area > AREA_SLACK:
            yield Fault("ROOM_NET", room.id, "its net interior is not within the room")
        beyond = shape.difference(region).area
        if beyond > AREA_SLACK:
            yield Fault("ROOM_OUTSIDE", room.id, f"{beyond:.2f} m2 lie outside the floor or in a core")
    tree = STRtree(shapes)
    for index, shape in enumerate(shapes):
        for other in sorted(tree.query(shape)):
            if other > index and (shared := shape.intersection(shapes[other]).area) > AREA_SLACK:
                where = f"{rooms[index].id} and {rooms[other].id}"
                yield Fault("ROOM_OVERLAP", where, f"overlap by {shared:.2f} m2")
    covered = unary_union(shapes).intersection(region).area / region.area
    if covered < COVERAGE:
        yield Fault("COVERAGE", f"floor {scene.floor}", f"rooms cover {covered:.1%} of the floor")


REACH = 0.26
"""Half the thickness of the thickest outer wall and a little: a room's boundary lies this near to a wall's line."""

GAP = 0.10
"""Metres of boundary without a wall that count as rounding."""


def check_walls(scene: FloorScene) -> Iterator[Fault]:
    """Yield a fault for each room and each core whose boundary has a gap in its walls."""
    lines = [LineString(wall.segment) for wall in scene.walls]
    lines += [LineString(door.segment) for door in scene.doors if door.kind == "open"]
    walled = unary_union([line.buffer(REACH) for line in lines])
    rooms = (room for room in scene.rooms if room.kind not in ("stair", "elevator"))
    enclosed = [(room.id, room_area(room)) for room in rooms]
    enclosed += [(f"{core.id} on floor {scene.floor}", Polygon(core.polygon)) for core in scene.cores]
    for where, shape in enclosed:
        bare = shape.boundary.difference(walled).length
        if bare > GAP:
            yield Fault("WALL_GAP", where, f"{bare:.2f} m of its boundary have no wall")
