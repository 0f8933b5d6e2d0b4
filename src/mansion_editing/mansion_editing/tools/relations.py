"""Where an object is, from the geometry alone: beside, left of or between others, in a part of its room, turned to one.

All relations are those of footprints. ``left``, ``right``, ``front`` and ``behind`` are in the landmark's own frame, as
in Holodeck (arXiv 2312.09067) and the allocentric relations of ReferIt3D: its front is the side that it looks to, and
its left that of somebody who looks out of it, so that the left of a sofa is the left of who sits on it.
"""

import math
from dataclasses import dataclass
from typing import Final

from shapely import LineString, MultiPoint, Point, Polygon
from shapely.geometry.base import BaseGeometry

from mansion_editing.state import SceneState
from mansion_geometry.object_footprints import footprint, footprint_corners
from mansion_geometry.plane import turned
from mansion_msgs_py.editing.objects import Side, Spot
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom
from mansion_msgs_py.shapes import Point as PlanPoint
from mansion_scene.decor.frames import room_polygon, to_local, wall_edges

__all__ = [
    "FLOOR_GAP",
    "NO_WISH",
    "PlacingWish",
    "convex_corners",
    "extents",
    "footprint_gap",
    "fulfils",
    "greatest_gap",
    "looks_at",
    "middle_of",
    "relation_holds",
    "spot_shapes",
]

TOUCH = 0.02
"""Metres by which a footprint may reach over the line that it should be beyond."""

ROUNDING = 1e-3
"""Slack of a gap that was asked for, metres."""

SHARED = 0.5
"""Least share of the smaller of the two widths that face each other across a gap."""

FLOOR_GAP, FRONT_GAP, SURFACE_GAP, WALL_GAP = 0.8, 1.5, 0.3, 1.5
"""Greatest gap without `within`, metres: on a floor, before the front there, on a surface, of what hangs."""

NEARBY = 1.5
"""Greatest gap of what is near without a side, metres."""

CENTRED = 0.25
"""Greatest distance of what is between two from the line through their middles, metres."""

BACKED = 0.45
"""Greatest gap between what hangs on a wall and what stands below it, metres: furniture stands off its wall."""

LEVEL = 0.05
"""Heights of two feet on the same surface differ by less, metres."""

AT_WALL, IN_CORNER, AT_WINDOW, AT_DOOR = 0.10, 0.40, 1.0, 1.5
"""Greatest distance from a wall, a corner, and from the middle line of a window or a door, metres."""

MIDDLE_SHARE, MIDDLE = 0.2, 0.5
"""Greatest distance from the middle: a share of the room's least extent, but no less than this, metres."""

AIM = 30.0
"""Greatest angle between a front and the direction to what it is turned to, degrees."""


@dataclass(frozen=True)
class PlacingWish:
    """`PlacingWishes` with the objects that they name."""

    near: SceneObject | None = None
    side: Side = ""
    other: SceneObject | None = None
    within: float | None = None
    apart: float | None = None
    spot: Spot = ""
    door: str = ""
    facing: SceneObject | None = None

    @property
    def binding(self) -> bool:
        """Whether anything must hold; `near` alone is a preference."""
        return bool(self.side or self.spot or self.facing or self.within is not None or self.apart)


NO_WISH: Final = PlacingWish()


def relation_holds(
    state: SceneState,
    item: SceneObject,
    side: Side = "",
    near: str = "",
    other: str = "",
    within: float | None = None,
    spot: Spot = "",
    facing: str = "",
    door: str = "",
    apart: float | None = None,
) -> bool:
    """Whether an object is where a wish has it.

    Parameters
    ----------
    item : SceneObject
        In the scene or not; its room says on which floor it is.
    side, near, other, within, spot, facing, door, apart
        As in `PlacingWishes`, the objects by their ids. `near` without a side or a gap means nearby.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an object that is not there.

    Notes
    -----
    Tolerances are the constants of this module. In front, behind, left and right face the landmark with at least half
    of the smaller width. What is beside, in front, around, ... is at most 0.8 m away on a floor (1.5 m in front of
    something), 0.3 m on a surface, and on walls 1.5 m, unless `within` says otherwise.
    """
    wish = PlacingWish(
        side=side,
        within=within,
        apart=apart,
        spot=spot,
        door=door,
        near=state.get(near, "$.near")[1] if near else None,
        other=state.get(other, "$.other")[1] if other else None,
        facing=state.get(facing, "$.facing")[1] if facing else None,
    )
    found = state.room(item.room)
    return found is not None and fulfils(state.scenes[found[0]], found[1], item, wish)


def fulfils(scene: FloorScene, room: SceneRoom, item: SceneObject, wish: PlacingWish) -> bool:
    """Whether an object in a room of a floor is where a wish has it (see `relation_holds`)."""
    marks = [mark for mark in (wish.near, wish.other, wish.facing) if mark is not None]
    if any(mark.room != item.room or mark.id == item.id for mark in marks):
        return False
    if wish.near is not None and not _beside_landmark(item, wish, wish.near):
        return False
    if wish.facing is not None and not looks_at(item, wish.facing):
        return False
    return not wish.spot or _in_spot(scene, room, item, wish)


def _beside_landmark(item: SceneObject, wish: PlacingWish, near: SceneObject) -> bool:
    if wish.apart is not None and footprint_gap(item, near) < wish.apart - ROUNDING:
        return False
    if wish.side not in ("under", "above"):
        gap = greatest_gap(item, wish) + ROUNDING
        if not _same_level(item, near) or _least_gap(item, near) > gap or footprint_gap(item, near) > gap:
            return False
    elif wish.within is not None and footprint_gap(item, near) > wish.within + ROUNDING:
        return False
    if wish.side == "between":
        return wish.other is not None and _between(item, near, wish)
    if wish.side == "under":
        return _under(item, near)
    if wish.side == "above":
        return _above(item, near)
    if wish.side in ("left", "right", "front", "behind"):
        return _on_side(item, near, wish.side)
    return not wish.side or not _overlap(item, near)


def greatest_gap(item: SceneObject, wish: PlacingWish) -> float:
    """Return the greatest gap that a wish leaves between the footprints of an object and its landmark, metres."""
    if wish.within is not None:
        return wish.within
    if wish.side == "between" or (wish.side == "front" and item.mount == "wall"):
        return math.inf
    if item.mount in ("surface", "inside"):
        return FLOOR_GAP if wish.near is not None and _stands_apart(item, wish.near) else SURFACE_GAP
    if not wish.side:
        return NEARBY
    if item.mount in ("wall", "ceiling"):
        return WALL_GAP
    return FRONT_GAP if wish.side == "front" else FLOOR_GAP


def _same_level(item: SceneObject, near: SceneObject) -> bool:
    """Whether a small thing is on the surface of its landmark; what stands or hangs is judged from above.

    So is what lies on furniture beside a landmark that stands on the floor: a kettle on the counter beside the stove.
    """
    if item.mount not in ("surface", "inside") or _stands_apart(item, near):
        return True
    feet = [thing.bottom for thing in (item, near)]
    return item.parent == near.parent and abs(feet[0] - feet[1]) < LEVEL


def _stands_apart(item: SceneObject, near: SceneObject) -> bool:
    """Whether a landmark stands on the floor and is not what carries a thing."""
    return near.mount == "floor" and near.parent is None and item.parent not in (None, near.id)


def footprint_gap(item: SceneObject, other: SceneObject) -> float:
    """Return the distance between two footprints, metres."""
    return float(footprint(item).distance(footprint(other)))


def _least_gap(item: SceneObject, other: SceneObject) -> float:
    """Return a quick lower bound of the distance between two footprints, metres; negative where they may overlap."""
    return (
        math.dist(item.position[:2], other.position[:2])
        - (math.hypot(*item.size[:2]) + math.hypot(*other.size[:2])) / 2
    )


def _overlap(item: SceneObject, near: SceneObject) -> bool:
    if item.mount in ("wall", "ceiling"):
        return _heights_meet(item, near) and _reaches_into(item, near)
    return _reaches_into(item, near)


def _heights_meet(item: SceneObject, near: SceneObject) -> bool:
    return abs(item.position[2] - near.position[2]) < (item.size[2] + near.size[2]) / 2


def _reaches_into(item: SceneObject, near: SceneObject) -> bool:
    if _least_gap(item, near) > 0.0:
        return False
    return bool(footprint(item).intersection(footprint(near)).area > TOUCH * min(*item.size[:2], *near.size[:2]))


def extents(frame: SceneObject, item: SceneObject) -> tuple[float, float, float, float]:
    """Return the interval that a footprint covers across and along another object's frame: left, right, back, front."""
    corners = [to_local(frame, p) for p in footprint_corners(item.position, item.size, item.rotation)]
    us, vs = zip(*corners, strict=True)
    return min(us), max(us), min(vs), max(vs)


def _on_side(item: SceneObject, near: SceneObject, side: Side) -> bool:
    left, right, back, front = extents(near, item)
    half_w, half_d = near.size[0] / 2, near.size[1] / 2
    slack = BACKED if item.mount == "wall" else 0.0
    if side in ("left", "right"):
        beyond = -half_w - right if side == "left" else left - half_w
        facing = min(front, half_d) - max(back, -half_d - slack)
        least = min(front - back, 2 * half_d)
    else:
        beyond = back - half_d if side == "front" else -half_d - front
        facing = min(right, half_w) - max(left, -half_w)
        least = min(right - left, 2 * half_w)
    return beyond >= -TOUCH and facing >= SHARED * least - ROUNDING


def _between(item: SceneObject, near: SceneObject, wish: PlacingWish) -> bool:
    other = wish.other
    if other is None or not _in_strip(item, near, other):
        return False
    if not _same_level(item, other) or _overlap(item, near) or _overlap(item, other):
        return False
    if wish.within is not None and footprint_gap(item, other) > wish.within + ROUNDING:
        return False
    corners = [p for mark in (near, other) for p in footprint_corners(mark.position, mark.size, mark.rotation)]
    line = LineString([near.position[:2], other.position[:2]])
    middle = Point(item.position[:2])
    if not MultiPoint(corners).convex_hull.covers(middle) or line.distance(footprint(item)) > CENTRED:
        return False
    return bool(0.0 < line.project(middle) < line.length)


def _in_strip(item: SceneObject, near: SceneObject, other: SceneObject) -> bool:
    """Whether the middle of an object lies between two others along the line through theirs, and not far from it."""
    (ax, ay), (bx, by), (x, y) = near.position[:2], other.position[:2], item.position[:2]
    length = math.hypot(bx - ax, by - ay)
    if length < ROUNDING:
        return False
    along = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length
    across = abs((x - ax) * (by - ay) - (y - ay) * (bx - ax)) / length
    return 0.0 < along < length and across - math.hypot(*item.size[:2]) / 2 <= CENTRED


def _under(item: SceneObject, near: SceneObject) -> bool:
    """Whether an object stands below another; a rug need only lie below half of it."""
    foot = item.bottom
    if item.mount != "floor" or foot > LEVEL:
        return False
    shape, over = footprint(item), footprint(near)
    if item.size[2] <= near.bottom + LEVEL:
        return bool(shape.intersection(over).area >= 0.5 * min(shape.area, over.area))
    below_top = item.top <= near.top
    return below_top and bool(over.buffer(TOUCH).covers(shape))


def _above(item: SceneObject, near: SceneObject) -> bool:
    foot = item.bottom
    if item.mount not in ("wall", "ceiling") or foot < near.top - TOUCH:
        return False
    across, along = to_local(near, item.position)
    over = abs(across) <= near.size[0] / 2
    if item.mount == "ceiling":
        return over and abs(along) <= near.size[1] / 2
    return over and footprint_gap(item, near) <= BACKED


def looks_at(item: SceneObject, target: SceneObject) -> bool:
    """Whether the front of an object is turned to another: straight to any part of it, or nearly to its middle."""
    dx, dy = target.position[0] - item.position[0], target.position[1] - item.position[1]
    ahead = turned(0.0, 1.0, item.rotation)
    distance = math.hypot(dx, dy)
    if distance < ROUNDING:
        return False
    if ahead[0] * dx + ahead[1] * dy >= math.cos(math.radians(AIM)) * distance:
        return True
    far = distance + math.hypot(*target.size[:2])
    x, y = item.position[:2]
    return bool(LineString([(x, y), (x + far * ahead[0], y + far * ahead[1])]).intersects(footprint(target)))


def spot_shapes(scene: FloorScene, room: SceneRoom, spot: Spot, door: str = "") -> list[BaseGeometry]:
    """Return the walls, corners, windows or doors of a room, or its middle, as points and lines in the plan.

    Parameters
    ----------
    door : str
        Id of the only door that counts; all of the room when empty.
    """
    if spot == "wall":
        return [LineString([edge.start, edge.end]) for edge in wall_edges(room.net_polygon, room.net_holes)]
    if spot == "corner":
        return [Point(corner) for corner in convex_corners(room)]
    if spot == "window":
        return [LineString(window.segment) for window in scene.windows if window.room == room.id]
    if spot == "door":
        return [LineString(d.segment) for d in scene.doors if room.id in d.rooms and door in ("", d.id)]
    return [Point(middle_of(room)[0])] if spot == "middle" else []


_REACH: Final = {"wall": AT_WALL, "corner": IN_CORNER, "window": AT_WINDOW, "door": AT_DOOR}


def _in_spot(scene: FloorScene, room: SceneRoom, item: SceneObject, wish: PlacingWish) -> bool:
    if wish.spot == "middle":
        middle, reach = middle_of(room)
        return math.dist(middle, item.position[:2]) <= reach
    shape, most = footprint(item), _REACH[wish.spot]
    return any(one.distance(shape) <= most for one in spot_shapes(scene, room, wish.spot, wish.door))


def convex_corners(room: SceneRoom) -> list[PlanPoint]:
    """Return the corners of a room that two walls enclose."""
    edges = wall_edges(room.net_polygon)
    pairs = zip([edges[-1], *edges[:-1]], edges, strict=True)
    return [b.start for a, b in pairs if a.along[0] * b.along[1] - a.along[1] * b.along[0] > 0.2]


def middle_of(room: SceneRoom) -> tuple[PlanPoint, float]:
    """Return the middle of a room, a point of its floor, and how far from it still counts as the middle, metres."""
    area: Polygon = room_polygon(room.net_polygon, room.net_holes)
    center = area.centroid if area.covers(area.centroid) else area.representative_point()
    x0, y0, x1, y1 = area.bounds
    return (center.x, center.y), max(MIDDLE, MIDDLE_SHARE * min(x1 - x0, y1 - y0))
