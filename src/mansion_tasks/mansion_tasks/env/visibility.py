"""Which objects the camera sees: the rules of `ListVisible` on arrays, for thousands of steps a second."""

import math
from collections.abc import Collection
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from mansion_geometry.compiled import Bools, Floats, Ints, kernel
from mansion_geometry.floor_grid import RESOLUTION
from mansion_msgs_py.world import ObjectState
from mansion_skills.navigation.grid_kernels import sees
from mansion_skills.skills.visibility import (
    CAMERA_HEIGHT,
    SIGHT_END,
    VIEW_ANGLE,
    VIEW_RANGE,
    closed_carrier,
    sight_points,
)
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["VisibilityIndex", "View"]

Labels = npt.NDArray[np.int16]

_CHAIN = 4
"""Links of a chain of carriers that count: an object on a tray on a table in a crate."""


@dataclass
class _FloorArrays:
    """The objects that are or were on one floor, a row each, by their ids.

    Attributes
    ----------
    states : list of ObjectState or None
        State that a row was made from; ``None``, and `shut`, for an object that has left the floor.
    boxes : (n, 6) array
        Centre in plan, half width and depth, cosine and sine of the rotation.
    heights : (n, 3) array
        Lower side, middle, top.
    points : (n, 5, 2) array
        Points of which one must be visible.
    labels : (n, 4) array
        Labels of the object and its carriers in the view grid, 0 for none.
    version : int
        Version of the floor's map.
    """

    names: list[str]
    states: list[ObjectState | None]
    numbers: dict[str, int]
    boxes: Floats
    heights: Floats
    points: Floats
    labels: Labels
    shut: Bools
    is_open: Bools
    version: int
    rows: dict[str, int]

    def update(self, world: World, states: Collection[ObjectState], numbers: dict[str, int], version: int) -> None:
        """Bring the rows up to date; those of unchanged states stay as they are."""
        if numbers is not self.numbers:
            self.numbers = numbers
            self.states = [None] * len(self.states)
        here = np.zeros(len(self.states), dtype=np.bool_)
        for state in states:
            row = self.rows[state.id]
            here[row] = True
            if self.states[row] is not state:
                self._set_row(world, row, state)
                for name in world.objects.carried_with(state.id):
                    if name in self.rows:
                        self._set_carriers(world, self.rows[name], world.objects.state(name))
        for row in np.flatnonzero(~here).tolist():
            self.states[row], self.shut[row] = None, True
        self.version = version

    def _set_row(self, world: World, row: int, state: ObjectState) -> None:
        self.states[row] = state
        self.is_open[row] = state.states.get("open") is True
        kind = world.objects.kinds[state.id]
        assert state.position is not None
        x, y, z = state.position
        angle = math.radians(state.rotation)
        halves = (kind.size[0] / 2, kind.size[1] / 2)
        self.boxes[row] = (x, y, *halves, math.cos(angle), math.sin(angle))
        self.heights[row] = (z - kind.size[2] / 2, z, z + kind.size[2] / 2)
        self.points[row] = sight_points(state, kind)

    def _set_carriers(self, world: World, row: int, state: ObjectState) -> None:
        """Set the numbers of an object and of what carries it, and whether one of these is closed."""
        self.labels[row] = 0
        self.labels[row, 0] = self.numbers.get(state.id, 0)
        self.shut[row] = closed_carrier(world, state) is not None
        entry, link = state, 1
        while entry.parent is not None and link < _CHAIN:
            entry = world.objects.state(entry.parent)
            self.labels[row, link] = self.numbers.get(entry.id, 0)
            link += 1


@dataclass(frozen=True)
class View:
    """The objects in view, the nearest first.

    Attributes
    ----------
    ids : list of str
    distances : (n,) array
        To their boxes, metres.
    bearings : (n,) array
        Bearings of the centres, degrees, left is positive.
    is_open : (n,) array of bool
        Whether each stands open.
    """

    ids: list[str]
    distances: Floats
    bearings: Floats
    is_open: Bools


class VisibilityIndex:
    """Arrays of the objects of one world; `look` finds those in view, as ``list_visible`` lists them.

    Parameters
    ----------
    world : World
    """

    def __init__(self, world: World) -> None:
        self._world = world
        self._floors: dict[int, _FloorArrays] = {}
        self._stale: set[int] = set()

    def world_changed(self) -> None:
        """Mark the arrays as out of date: an object was moved, opened or switched."""
        self._stale = set(self._floors)

    def look(
        self, robot: RobotBody, most: int | None = None, always: Collection[str] = (), distance: float = VIEW_RANGE
    ) -> View:
        """Return the objects in view.

        Parameters
        ----------
        robot : RobotBody
        most : int, optional
            Greatest number of objects; the nearest are kept.
        always : collection of str
            Objects that are looked for even behind the nearest `most`.
        distance : float
            Metres.
        """
        rows = self._arrays(robot.floor)
        grid = self._world.view(robot.floor).map
        wanted = np.zeros(len(rows.states), dtype=np.bool_)
        for name in always:
            if name in rows.rows:
                wanted[rows.rows[name]] = True
        found, away, bearing = _look(
            grid.view,
            (grid.frame.x0, grid.frame.y0),
            (robot.pose.x, robot.pose.y, robot.pose.yaw, robot.pitch, robot.radius),
            distance,
            len(rows.states) if most is None else most,
            wanted,
            rows.boxes,
            rows.heights,
            rows.points,
            rows.labels,
            rows.shut,
        )
        ids = [rows.names[i] for i in found.tolist()]
        return View(ids, away, bearing, rows.is_open[found])

    def _arrays(self, floor: int) -> _FloorArrays:
        rows = self._floors.get(floor)
        version = self._world.view(floor).map.version
        if rows is None or rows.version != version or floor in self._stale:
            rows = self._floors[floor] = self._updated(floor, rows, version)
            self._stale.discard(floor)
        return rows

    def _updated(self, floor: int, rows: _FloorArrays | None, version: int) -> _FloorArrays:
        """Return a floor's arrays, the present ones brought up to date if they have a row for every object."""
        states = self._world.objects.on_floor(floor)
        if rows is None or any(state.id not in rows.rows for state in states):
            known = [] if rows is None else [state for state in rows.states if state is not None]
            rows = _empty_arrays(sorted({state.id for state in [*known, *states]}))
        rows.update(self._world, states, self._world.view(floor).numbers, version)
        return rows


def _empty_arrays(names: list[str]) -> _FloorArrays:
    count = len(names)
    return _FloorArrays(
        names,
        [None] * count,
        {},
        np.zeros((count, 6)),
        np.zeros((count, 3)),
        np.zeros((count, 5, 2)),
        np.zeros((count, _CHAIN), dtype=np.int16),
        np.ones(count, dtype=np.bool_),
        np.zeros(count, dtype=np.bool_),
        -1,
        {name: row for row, name in enumerate(names)},
    )


@kernel
def _in_picture(
    dx: float, dy: float, ahead: tuple[float, float], tilt: tuple[float, float, float], heights: Floats
) -> bool:
    """Whether a point of an object is in the picture: `tilt` is the tangents below and above, and the radius."""
    away = math.hypot(dx, dy)
    forward = dx * ahead[0] + dy * ahead[1]
    if away > tilt[2] and (forward <= 0.0 or abs(dy * ahead[0] - dx * ahead[1]) > forward * _HALF_WIDTH):
        return False
    flat = max(away, tilt[2])
    low, high = heights[0] - CAMERA_HEIGHT, heights[2] - CAMERA_HEIGHT
    return bool(low <= flat * tilt[1] and high >= flat * tilt[0])


_HALF_WIDTH = math.tan(math.radians(VIEW_ANGLE / 2)) * (1.0 + 1e-12)
_LEVEL = 89.9
"""Degrees up or down from which the picture's edge counts as straight up or down."""


@kernel
def _tangent(angle: float) -> float:
    if angle >= _LEVEL:
        return math.inf
    return -math.inf if angle <= -_LEVEL else math.tan(math.radians(angle))


@kernel
def _distances(x: float, y: float, reach: float, boxes: Floats, shut: Bools) -> Floats:
    """Return the distance to each box, infinite when it is out of reach or shut away."""
    count = boxes.shape[0]
    away = np.full(count, np.inf)
    for i in range(count):
        dx, dy = x - boxes[i, 0], y - boxes[i, 1]
        far = reach + 2.0 * (boxes[i, 2] + boxes[i, 3])
        if shut[i] or dx * dx + dy * dy > far * far:
            continue
        c, s = boxes[i, 4], boxes[i, 5]
        across = max(abs(c * dx + s * dy) - boxes[i, 2], 0.0)
        along = max(abs(c * dy - s * dx) - boxes[i, 3], 0.0)
        distance = math.hypot(across, along)
        if distance <= reach:
            away[i] = distance
    return away


@kernel
def _look(
    view: Labels,
    origin: tuple[float, float],
    pose: tuple[float, float, float, float, float],
    reach: float,
    most: int,
    wanted: Bools,
    boxes: Floats,
    heights: Floats,
    points: Floats,
    labels: Labels,
    shut: Bools,
) -> tuple[Ints, Floats, Floats]:
    """Return the rows of the objects in view, nearest first, with their distances and bearings."""
    x, y, yaw, pitch, radius = pose
    heading = math.radians(yaw)
    ahead = (math.cos(heading), math.sin(heading))
    tilt = (_tangent(pitch - VIEW_ANGLE / 2), _tangent(pitch + VIEW_ANGLE / 2), radius)
    away = _distances(x, y, reach, boxes, shut)
    near = np.flatnonzero(np.isfinite(away))
    order = near[np.argsort(away[near], kind="mergesort")]
    found = np.empty(order.shape[0], dtype=np.int64)
    count = 0
    row, column = (y - origin[1]) / RESOLUTION, (x - origin[0]) / RESOLUTION
    for i in order:
        if count >= most and not wanted[i]:
            continue
        for k in range(points.shape[1]):
            px, py = points[i, k, 0], points[i, k, 1]
            if not _in_picture(px - x, py - y, ahead, tilt, heights[i]):
                continue
            r1, c1 = (py - origin[1]) / RESOLUTION, (px - origin[0]) / RESOLUTION
            if sees(view, row, column, r1, c1, SIGHT_END, labels[i]):
                found[count] = i
                count += 1
                break
    rows = found[:count].copy()
    bearings = np.empty(count)
    for n in range(count):
        turn = math.degrees(math.atan2(boxes[rows[n], 1] - y, boxes[rows[n], 0] - x)) - yaw
        turn %= 360.0
        bearings[n] = turn - 360.0 if turn > 180.0 else turn
    return rows, away[rows], bearings
