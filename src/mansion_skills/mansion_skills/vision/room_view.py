"""The widest view of a room: where to stand and which way to look for a picture that shows most of it.

Places in the room and directions are tried on the floor's grid. What counts is the share of the room's floor and the
share of its furniture that the camera has in view from there.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np

from mansion_geometry.compiled import Bools, Floats, Ints
from mansion_geometry.floor_grid import RESOLUTION, fill_box, fill_rings, fill_strip
from mansion_geometry.plane import turned
from mansion_msgs_py.shapes import Point
from mansion_msgs_py.world import Pose2D
from mansion_skills.navigation.grid_kernels import cast_rays, clearance
from mansion_skills.skills.visibility import CAMERA_HEIGHT, VIEW_ANGLE, VIEW_RANGE, sight_points
from mansion_skills.vision.articulation import leaves_of
from mansion_skills.world.floor_view import FloorView, Landmark, bodies_of, reached_cells
from mansion_skills.world.objects import ObjectTable
from mansion_skills.world.world import World

__all__ = ["widest_view"]

MOST_PLACES: Final = 120
"""Most places of a room that are tried, on a square lattice."""

DIRECTIONS: Final = 36
RAYS: Final = 180

MARGIN: Final = 0.15
"""Metres by which the robot stands clear of what it could touch, where there is such a place."""

STEEPEST: Final = 0.75
"""Tangent of how far below the horizon a picture reaches whose height is three quarters of its width."""

AHEAD: Final = 1.0
"""Metres that should be free in the middle of a picture; what stands nearer there takes from it in proportion."""

MIDDLE: Final = 40.0
"""Degrees across the middle of a picture."""

IN_FRONT: Final = 0.8
"""Height from which something in the middle of a picture hides what is behind it, metres."""

CHAMFER: Final = 3
"""What `clearance` counts for a cell."""


@dataclass(frozen=True)
class _Furniture:
    """The points by which the furniture of a room is seen; the weights of all add up to 1, or there are none.

    Attributes
    ----------
    x, y, height : (n,) arrays
        Metres.
    depth : (n,) array
        How long before the point a line of sight may end, for it is the object itself that ends it; metres.
    weight : (n,) array
    """

    x: Floats
    y: Floats
    height: Floats
    depth: Floats
    weight: Floats


def widest_view(world: World, landmark: Landmark) -> Pose2D:
    """Return the pose in a room from which most of it is seen.

    Parameters
    ----------
    world : World
    landmark : Landmark
        A room's.

    Returns
    -------
    Pose2D
        A place where the robot can be, one that it can reach where the room has such; the landmark's own pose in a
        room without any. The same world gives the same pose.
    """
    view = world.view(landmark.floor)
    number = 1 + [room.id for room in view.scene.rooms].index(landmark.name)
    ends = _ends_of_sight(world, view, number)
    tall = ends | _tall(world.objects, view)
    furniture = _furniture(world.objects, landmark)
    area = float(np.count_nonzero(view.map.rooms == number)) * RESOLUTION**2
    best, found = 0.0, landmark.pose
    for row, column in _places(view, number).tolist():
        x, y = view.map.frame.center(row, column)
        ranges = _ranges(ends, row, column)
        scores = _floor_seen(ranges) / area + _furniture_seen(ranges, (x, y), furniture)
        scores *= _room_ahead(_ranges(tall, row, column))
        direction = int(np.argmax(scores))
        # Sums in another order differ by rounding; among equals the first place counts.
        if scores[direction] > best + 1e-9:
            best = float(scores[direction])
            found = Pose2D(x=round(x, 3), y=round(y, 3), yaw=direction * 360.0 / DIRECTIONS)
    return found


def _ends_of_sight(world: World, view: FloorView, number: int) -> Bools:
    """Return the cells at which a view of a room ends: its bounds, what is higher than eyes, leaves that stand open."""
    grid = view.map
    leaves = np.zeros(grid.frame.shape, dtype=np.int16)
    for door in view.scene.doors:
        if grid.is_open[door.id] and view.scene.rooms[number - 1].id in door.rooms:
            found = leaves_of(door, 1.0, grid.room_at)
            for leaf in found:
                dx, dy = turned(door.width / len(found), 0.0, leaf.yaw)
                segment = (leaf.x, leaf.y), (leaf.x + dx, leaf.y + dy)
                fill_strip(leaves, grid.frame, segment, RESOLUTION, 1)
    ends: Bools = (grid.rooms != number) | (grid.view != 0) | (leaves != 0)
    return ends


def _tall(objects: ObjectTable, view: FloorView) -> Bools:
    """Return the cells with something that is in the way of a picture, also where the camera looks over it."""
    marks = np.zeros(view.map.frame.shape, dtype=np.int16)
    for body in bodies_of(view.floor, objects):
        if not body.carried and body.bottom < CAMERA_HEIGHT and body.top > IN_FRONT:
            fill_box(marks, view.map.frame, body.position, body.size, body.rotation, 1)
    tall: Bools = marks != 0
    return tall


def _places(view: FloorView, number: int) -> Ints:
    """Return rows and columns of the places that are tried, shape (n, 2)."""
    grid, room = view.map, view.scene.rooms[number - 1]
    inside = np.zeros(grid.frame.shape, dtype=np.int16)
    fill_rings(inside, grid.frame, [room.net_polygon, *room.net_holes], 1)
    free = (inside != 0) & ~grid.blocked
    reached = free & reached_cells(grid)
    clear = reached & (clearance(grid.blocked) > CHAMFER * MARGIN / RESOLUTION)
    cells = next((found for found in map(np.argwhere, (clear, reached)) if len(found)), np.argwhere(free))
    step, lattice = 1, cells
    while len(lattice) > MOST_PLACES:
        step += 1
        lattice = cells[(cells % step == 0).all(axis=1)]
    return lattice


def _furniture(objects: ObjectTable, landmark: Landmark) -> _Furniture:
    """Return what of a room's furniture is to be seen; an object weighs as the larger of its upright faces."""
    rows = []
    for state in objects.on_floor(landmark.floor):
        if state.room != landmark.name or state.mount in ("surface", "inside", "ceiling"):
            continue
        assert state.position is not None
        width, depth, height = objects.kinds[state.id].size
        points = sight_points(state, objects.kinds[state.id])
        face = max(width, depth) * height / len(points)
        rows += [(x, y, state.position[2], max(width, depth) / 2, face) for x, y in points]
    table = np.array(rows, dtype=np.float64).reshape(-1, 5)
    x, y, height, depth, weight = table.T
    return _Furniture(x, y, height, depth, weight / max(float(weight.sum()), 1e-9))


def _ranges(ends: Bools, row: int, column: int) -> Floats:
    """Return how far the camera sees from the middle of a cell in each of the `RAYS` directions, metres."""
    angles = np.arange(RAYS) * (2 * np.pi / RAYS)
    return RESOLUTION * cast_rays(ends, row + 0.5, column + 0.5, angles, VIEW_RANGE / RESOLUTION)


def _across(values: Floats, degrees: float) -> Floats:
    """Return the values of the rays within an angle about each of the `DIRECTIONS`, shape (directions, rays)."""
    half = round(degrees / 360.0 * RAYS) // 2
    middles = np.arange(DIRECTIONS) * (RAYS // DIRECTIONS)
    found: Floats = values[(middles[:, None] + np.arange(-half, half + 1)) % RAYS]
    return found


def _shown(aside: Floats) -> Floats:
    """Return the weight of an object by its bearing in degrees: 1 in the middle of the picture, 1/2 at its edges."""
    found: Floats = np.where(np.abs(aside) <= VIEW_ANGLE / 2, np.cos(np.radians(aside)) ** 2, 0.0)
    return found


def _floor_seen(ranges: Floats) -> Floats:
    """Return the floor in view in each direction, square metres."""
    sectors = _across(ranges**2 / 2 * (2 * np.pi / RAYS), VIEW_ANGLE)
    found: Floats = sectors @ _shown(np.linspace(-VIEW_ANGLE / 2, VIEW_ANGLE / 2, sectors.shape[1]))
    return found


def _furniture_seen(ranges: Floats, place: Point, furniture: _Furniture) -> Floats:
    """Return the share of the furniture that is in the picture in each direction."""
    dx, dy = furniture.x - place[0], furniture.y - place[1]
    away, bearing = np.hypot(dx, dy), np.degrees(np.arctan2(dy, dx))
    ray = np.round(bearing / 360.0 * RAYS).astype(np.int64) % RAYS
    seen = (ranges[ray] + furniture.depth >= away) & (away * STEEPEST >= CAMERA_HEIGHT - furniture.height)
    yaws = np.arange(DIRECTIONS) * (360.0 / DIRECTIONS)
    aside = (bearing - yaws[:, None] + 180.0) % 360.0 - 180.0
    found: Floats = _shown(aside) @ (furniture.weight * seen)
    return found


def _room_ahead(ranges: Floats) -> Floats:
    """Return how free the middle of the picture is in each direction, 0 to 1."""
    found: Floats = np.minimum(_across(ranges, MIDDLE).min(axis=1) / AHEAD, 1.0)
    return found
