"""The grids of one floor: obstacles, where the robot's centre may be, and what blocks the view."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import hypot

import numpy as np
import numpy.typing as npt

from mansion_geometry.disc_cells import inflate, stamp_disc
from mansion_geometry.doorways import LEAFLESS, PASSAGE_DEPTH, depth_of_doors, is_passable, is_walkway
from mansion_geometry.floor_grid import (
    FREE,
    OCCUPIED,
    RESOLUTION,
    UNKNOWN,
    GridFrame,
    fill_box,
    fill_rings,
    fill_strip,
    map_frame,
)
from mansion_geometry.robot_body import in_the_way
from mansion_msgs_py.scene import Door, FloorScene
from mansion_msgs_py.shapes import Point, Point3, Size3

__all__ = ["Body", "FloorMap", "shaft_cells"]

_NONE, _CABIN, _OPENING = 0, 1, 2

EYE_LEVEL = 1.4
"""Height from which objects block the view, metres."""

SEE_THROUGH = ("glazed",)

_INSIDE, _OUTSIDE = 0, -1

_WALL = -1

_CLEAR = 0


def shaft_cells(scene: FloorScene, frame: GridFrame) -> npt.NDArray[np.bool_]:
    """Return the cells that the floor's ``map.pgm`` has free inside and at the mouths of its cores.

    Parameters
    ----------
    scene : FloorScene
    frame : GridFrame

    Returns
    -------
    array of bool, shape (rows, columns)
    """
    marks = np.zeros(frame.shape, dtype=np.int16)
    for core in scene.cores:
        if core.type == "elevator":
            fill_rings(marks, frame, [core.polygon], _CABIN)
    for wall in scene.walls:
        fill_strip(marks, frame, wall.segment, wall.thickness, _NONE, longer=wall.thickness)
    names = {core.id for core in scene.cores}
    depths = depth_of_doors(scene)
    for door in scene.doors:
        if names.intersection(str(name) for name in door.rooms):
            fill_strip(marks, frame, door.segment, depths[door.id], _OPENING if is_passable(door) else _NONE)
    free: npt.NDArray[np.bool_] = marks != _NONE
    return free


@dataclass(frozen=True)
class Body:
    """An object as the map sees it; `number` is its label in the view grid, 1 or more."""

    id: str
    position: Point3
    size: Size3
    rotation: float
    carried: bool
    number: int

    @property
    def bottom(self) -> float:
        """Height of its lower side, metres."""
        return self.position[2] - self.size[2] / 2

    @property
    def top(self) -> float:
        """Height of its upper side, metres."""
        return self.position[2] + self.size[2] / 2


def _may_touch(door: Door, middle: Point, half: float) -> bool:
    """Whether a door's passage may reach into a square about a point."""
    (ax, ay), (bx, by) = door.segment
    reach = half + 2 * RESOLUTION + hypot(bx - ax, by - ay) / 2 + 0.5
    x, y = (ax + bx) / 2 - middle[0], (ay + by) / 2 - middle[1]
    return max(abs(x), abs(y)) <= reach


def _stands_near(body: Body, middle: Point, half: float) -> bool:
    """Whether a body may reach into a square about a point."""
    reach = half + 2 * RESOLUTION + hypot(body.size[0], body.size[1]) / 2 + RESOLUTION
    x, y = body.position[0] - middle[0], body.position[1] - middle[1]
    return max(abs(x), abs(y)) <= reach


class FloorMap:
    """Grids of one floor, updated when a door or a standing object changes.

    Parameters
    ----------
    scene : FloorScene
    radius : float
        Robot's radius, metres.

    Attributes
    ----------
    rooms : array of int16
        Number of the room (1 for the first of the scene) that each cell belongs to; 0 is none.
    occupied, blocked : array of bool
        Cells with an obstacle, and cells where the robot's centre cannot be.
    version : int
        Counts the updates.
    is_open : dict
        Door id to whether it stands open in the grids.
    view : array of int16
        What ends a line of sight: 0 nothing, -1 a wall or a closed door, else a body's number.
    """

    def __init__(self, scene: FloorScene, radius: float) -> None:
        self.scene = scene
        self.radius = radius
        self.frame = map_frame(scene)
        shape = self.frame.shape
        self._outside = self._outdoors()
        self._shafts = shaft_cells(scene, self.frame)
        self.rooms = np.zeros(shape, dtype=np.int16)
        self._bare = np.full(shape, _WALL, dtype=np.int16)
        self._fill_rooms()
        self._thickness = {wall.id: wall.thickness for wall in scene.walls}
        self._cores = [core.id for core in scene.cores]
        self.version = 0
        self.is_open: dict[str, bool] = {}
        self._bodies: list[Body] = []
        self.view: npt.NDArray[np.int16] = self._bare
        self.occupied: npt.NDArray[np.bool_] = self._bare != _CLEAR
        self.blocked: npt.NDArray[np.bool_] = self.occupied

    def _outdoors(self) -> npt.NDArray[np.bool_]:
        marks = np.full(self.frame.shape, _OUTSIDE, dtype=np.int16)
        fill_rings(marks, self.frame, [self.scene.outline], _INSIDE)
        for hole in self.scene.holes:
            fill_rings(marks, self.frame, [hole], _OUTSIDE)
        for wall in self.scene.walls:
            fill_strip(marks, self.frame, wall.segment, wall.thickness, _INSIDE, longer=wall.thickness)
        outdoors: npt.NDArray[np.bool_] = marks == _OUTSIDE
        return outdoors

    def _fill_rooms(self) -> None:
        for number, room in enumerate(self.scene.rooms, start=1):
            fill_rings(self.rooms, self.frame, [room.polygon], number)
            if room.kind not in ("stair", "elevator"):
                fill_rings(self._bare, self.frame, [room.net_polygon, *room.net_holes], _CLEAR)
        for core in self.scene.cores:
            fill_rings(self._bare, self.frame, [core.polygon], _WALL)

    def update(self, bodies: Iterable[Body], is_open: Mapping[str, bool]) -> None:
        """Redraw the grids with the doors and bodies as they are now.

        Parameters
        ----------
        bodies : iterable of Body
        is_open : mapping
            Door id to whether it stands open now, for every door of the floor.
        """
        self.is_open = dict(is_open)
        self._bodies = [body for body in bodies if not body.carried and in_the_way(body.bottom, body.top)]
        solid, view = self._drawn(self.scene.doors, self._bodies)
        self.version += 1
        self.view = view
        self.occupied = solid != _CLEAR
        self.blocked = inflate(self.occupied, self.radius / RESOLUTION)

    def swing(self, name: str, *, is_open: bool) -> None:
        """Open or close one door, as `update` would, by redrawing only its surroundings."""
        door = next(door for door in self.scene.doors if door.id == name)
        self.is_open[name] = is_open
        if door.kind in LEAFLESS or not is_walkway(door, self._cores):
            return
        (ax, ay), (bx, by) = door.segment
        middle = ((ax + bx) / 2, (ay + by) / 2)
        depth = self._thickness.get(door.wall, 0.0) + PASSAGE_DEPTH / 2
        half = hypot(bx - ax, by - ay) / 2 + depth + 2 * RESOLUTION
        near = [other for other in self.scene.doors if _may_touch(other, middle, half)]
        bodies = [body for body in self._bodies if _stands_near(body, middle, half)]
        solid, view = self._drawn(near, bodies)
        there = self.frame.window(*middle, half)
        self.version += 1
        self.view, self.occupied = self.view.copy(), self.occupied.copy()
        self.view[there] = view[there]
        self.occupied[there] = solid[there] != _CLEAR
        inner = self.frame.window(*middle, half + self.radius + RESOLUTION)
        outer = self.frame.window(*middle, half + 2 * (self.radius + RESOLUTION))
        grown = inflate(np.ascontiguousarray(self.occupied[outer]), self.radius / RESOLUTION)
        rows, columns = (slice(a.start - b.start, a.stop - b.start) for a, b in zip(inner, outer))
        self.blocked = self.blocked.copy()
        self.blocked[inner] = grown[rows, columns]

    def _drawn(
        self, doors: Iterable[Door], bodies: Iterable[Body]
    ) -> tuple[npt.NDArray[np.int16], npt.NDArray[np.int16]]:
        """Return what stands in the way and what blocks the view, with some doors and bodies drawn."""
        solid, view = self._bare.copy(), self._bare.copy()
        for door in doors:
            self._cut(door, solid, view, is_open=self.is_open[door.id])
        for body in bodies:
            fill_box(solid, self.frame, body.position, body.size, body.rotation, body.number)
            if body.top > EYE_LEVEL:
                fill_box(view, self.frame, body.position, body.size, body.rotation, body.number, _CLEAR)
        return solid, view

    def _cut(self, door: Door, solid: npt.NDArray[np.int16], view: npt.NDArray[np.int16], *, is_open: bool) -> None:
        if not is_walkway(door, self._cores):
            return
        passable = is_open or door.kind in LEAFLESS
        depth = max(self._thickness.get(door.wall, 0.0) + 2 * RESOLUTION, PASSAGE_DEPTH)
        if passable:
            fill_strip(solid, self.frame, door.segment, depth, _CLEAR)
        if passable or door.kind in SEE_THROUGH:
            fill_strip(view, self.frame, door.segment, depth, _CLEAR)

    def room_at(self, x: float, y: float) -> str | None:
        """Return the id of the room that holds a point, or ``None``."""
        row, column = self.frame.cell(x, y)
        number = int(self.rooms[row, column]) if self.frame.holds(row, column) else 0
        return self.scene.rooms[number - 1].id if number else None

    def is_free(self, x: float, y: float) -> bool:
        """Whether the robot's centre can be at a point."""
        row, column = self.frame.cell(x, y)
        return self.frame.holds(row, column) and not self.blocked[row, column]

    def blocked_with(self, discs: Iterable[tuple[Point, float]]) -> npt.NDArray[np.bool_]:
        """Return `blocked` with further discs (centre, and radius for the robot's centre; metres)."""
        discs = list(discs)
        if not discs:
            return self.blocked
        mask = self.blocked.copy()
        for (x, y), radius in discs:
            row, column = self.frame.coordinates(x, y)
            stamp_disc(mask, row - 0.5, column - 0.5, radius / RESOLUTION)
        return mask

    def occupancy(self) -> npt.NDArray[np.int8]:
        """Return the values of ``nav_msgs/OccupancyGrid``, shape (rows, columns); at first those of ``map.pgm``."""
        data = np.where(self.occupied, OCCUPIED, FREE).astype(np.int8)
        data[self._outside] = UNKNOWN
        data[self._shafts] = FREE
        return data
