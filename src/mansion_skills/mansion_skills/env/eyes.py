"""What the camera sees, for many steps a second: the rules of `ListVisible` on arrays."""

import math
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from mansion_geometry.compiled import kernel
from mansion_msgs_py.world import ObjectState
from mansion_skills.navigation.floor_map import RESOLUTION
from mansion_skills.navigation.search import sees
from mansion_skills.skills.seeing import (
    CAMERA_HEIGHT,
    VIEW_ANGLE,
    VIEW_RANGE,
    closed_carrier,
    sight_points,
)
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["Eyes", "InView"]

Floats = npt.NDArray[np.float64]
Labels = npt.NDArray[np.int16]
Mask = npt.NDArray[np.bool_]

_THIN = 3.0
_CHAIN = 4
"""Carriers of carriers that count: a thing on a tray on a table in a crate."""


@dataclass
class _FloorArrays:
    """The objects of one floor, a row each.

    Attributes
    ----------
    boxes : (n, 6) array
        Centre in plan, half width and depth, cosine and sine of the rotation.
    heights : (n, 3) array
        Lower side, middle, top.
    points : (n, 5, 2) array
        By which each is seen.
    labels : (n, 4) array
        Numbers of it and its carriers in the view grid.
    """

    states: list[ObjectState]
    boxes: Floats
    heights: Floats
    points: Floats
    labels: Labels
    shut: Mask
    version: int
    rows: dict[str, int] = field(default_factory=dict)


@dataclass(frozen=True)
class InView:
    """An object in view: distance to its box (metres), and bearing of its centre (degrees, left is positive)."""

    id: str
    distance: float
    bearing: float


class Eyes:
    """Sees for the robots of one world; `look` gives what ``list_visible`` lists.

    Parameters
    ----------
    world : World
    """

    def __init__(self, world: World) -> None:
        self._world = world
        self._floors: dict[int, _FloorArrays] = {}
        self._stale: set[int] = set()

    def world_changed(self) -> None:
        """Look at the objects anew: one was moved, opened or switched."""
        self._stale = set(self._floors)

    def look(self, robot: RobotBody, distance: float = VIEW_RANGE) -> list[InView]:
        """Return the objects in view, the nearest first."""
        rows = self._arrays(robot.floor)
        grid = self._world.view(robot.floor).map
        away, bearing = _look(
            grid.view,
            grid.frame.x0,
            grid.frame.y0,
            robot.pose.x,
            robot.pose.y,
            robot.pose.yaw,
            robot.pitch,
            robot.radius,
            distance,
            rows.boxes,
            rows.heights,
            rows.points,
            rows.labels,
            rows.shut,
        )
        found = np.flatnonzero(np.isfinite(away))
        order = sorted(found.tolist(), key=lambda i: (round(away[i], 3), rows.states[i].id))
        return [InView(rows.states[i].id, float(away[i]), float(bearing[i])) for i in order]

    def _arrays(self, floor: int) -> _FloorArrays:
        rows = self._floors.get(floor)
        version = self._world.view(floor).map.version
        if rows is None or rows.version != version or floor in self._stale:
            rows = self._floors[floor] = self._built(floor, rows, version)
            self._stale.discard(floor)
        return rows

    def _built(self, floor: int, old: _FloorArrays | None, version: int) -> _FloorArrays:
        """Return a floor's arrays; rows of objects that are as they were are taken over."""
        world = self._world
        states = world.objects.on_floor(floor)
        count = len(states)
        made = _FloorArrays(
            states,
            np.zeros((count, 6)),
            np.zeros((count, 3)),
            np.zeros((count, 5, 2)),
            np.zeros((count, _CHAIN), dtype=np.int16),
            np.zeros(count, dtype=np.bool_),
            version,
            {state.id: row for row, state in enumerate(states)},
        )
        numbers = world.view(floor).numbers
        for row, state in enumerate(states):
            before = None if old is None else old.rows.get(state.id)
            if old is not None and before is not None and old.states[before] is state:
                made.boxes[row] = old.boxes[before]
                made.heights[row] = old.heights[before]
                made.points[row] = old.points[before]
            else:
                self._fill(made, row, state)
            entry: ObjectState | None = state
            for link in range(_CHAIN):
                made.labels[row, link] = 0 if entry is None else numbers.get(entry.id, 0)
                up = None if entry is None else entry.parent
                entry = None if up is None else world.objects.state(up)
            made.shut[row] = state.parent is not None and closed_carrier(world, state) is not None
        return made

    def _fill(self, made: _FloorArrays, row: int, state: ObjectState) -> None:
        kind = self._world.objects.kinds[state.id]
        assert state.position is not None
        x, y, z = state.position
        angle = math.radians(state.rotation)
        halves = (kind.size[0] / 2, kind.size[1] / 2)
        made.boxes[row] = (x, y, *halves, math.cos(angle), math.sin(angle))
        made.heights[row] = (z - kind.size[2] / 2, z, z + kind.size[2] / 2)
        made.points[row] = sight_points(state, kind)


@kernel
def _bearing(dx: float, dy: float, yaw: float) -> float:
    turn = (math.degrees(math.atan2(dy, dx)) - yaw) % 360.0
    return turn - 360.0 if turn > 180.0 else turn


@kernel
def _in_picture(away: float, bearing: float, pitch: float, radius: float, heights: Floats) -> bool:
    if away > radius and abs(bearing) > VIEW_ANGLE / 2:
        return False
    flat = max(away, radius)
    low = math.degrees(math.atan2(heights[0] - CAMERA_HEIGHT, flat))
    middle = math.degrees(math.atan2(heights[1] - CAMERA_HEIGHT, flat))
    high = math.degrees(math.atan2(heights[2] - CAMERA_HEIGHT, flat))
    least, most = min(low, middle, high), max(low, middle, high)
    return least <= pitch + VIEW_ANGLE / 2 and most >= pitch - VIEW_ANGLE / 2


@kernel
def _look(
    view: Labels,
    x0: float,
    y0: float,
    x: float,
    y: float,
    yaw: float,
    pitch: float,
    radius: float,
    reach: float,
    boxes: Floats,
    heights: Floats,
    points: Floats,
    labels: Labels,
    shut: Mask,
) -> tuple[Floats, Floats]:
    """Return each object's distance (infinite when it is not seen) and bearing."""
    count = boxes.shape[0]
    found = np.full(count, np.inf)
    bearings = np.zeros(count)
    row, column = (y - y0) / RESOLUTION, (x - x0) / RESOLUTION
    for i in range(count):
        dx, dy = x - boxes[i, 0], y - boxes[i, 1]
        far = reach + 2.0 * (boxes[i, 2] + boxes[i, 3])
        if shut[i] or dx * dx + dy * dy > far * far:
            continue
        c, s = boxes[i, 4], boxes[i, 5]
        across = max(abs(c * dx + s * dy) - boxes[i, 2], 0.0)
        along = max(abs(c * dy - s * dx) - boxes[i, 3], 0.0)
        distance = math.hypot(across, along)
        if distance > reach:
            continue
        for k in range(points.shape[1]):
            px, py = points[i, k, 0], points[i, k, 1]
            away = math.hypot(px - x, py - y)
            if not _in_picture(away, _bearing(px - x, py - y, yaw), pitch, radius, heights[i]):
                continue
            r1, c1 = (py - y0) / RESOLUTION, (px - x0) / RESOLUTION
            if sees(view, row, column, r1, c1, _THIN, labels[i]):
                found[i] = distance
                bearings[i] = _bearing(-dx, -dy, yaw)
                break
    return found, bearings
