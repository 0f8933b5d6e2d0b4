"""Is every boundary of a room either walled or a declared opening."""

from collections.abc import Iterator

from shapely import LineString
from shapely.ops import unary_union

from mansion_bringup.check.fault import Fault
from mansion_bringup.check.shapes import room_area
from mansion_msgs_py.scene import FloorScene

__all__ = ["check_walls"]

REACH = 0.26
"""Half the thickness of the thickest outer wall and a little: a room's boundary lies this near to a wall's line."""

GAP = 0.10
"""Metres of boundary without a wall that count as rounding."""


def check_walls(scene: FloorScene) -> Iterator[Fault]:
    """Yield a fault for each room whose boundary has a gap in its walls."""
    lines = [LineString(wall.segment) for wall in scene.walls]
    lines += [LineString(door.segment) for door in scene.doors if door.kind == "open"]
    for wall in scene.walls:
        if LineString(wall.segment).length < 1e-3:
            yield Fault("WALL", wall.id, "has no length")
    walled = unary_union([line.buffer(REACH) for line in lines])
    for room in scene.rooms:
        if room.kind in ("stair", "elevator"):
            continue
        bare = room_area(room).boundary.difference(walled).length
        if bare > GAP:
            yield Fault("WALL_GAP", room.id, f"{bare:.2f} m of its boundary have no wall")
