"""Shortest smooth paths on a floor: A* on the inflated grid, straightened, with rounded corners."""

from collections.abc import Sequence
from itertools import pairwise
from math import dist

import numpy as np
import numpy.typing as npt

from mansion_geometry.floor_grid import GridFrame
from mansion_msgs_py.shapes import Point
from mansion_skills.navigation.grid_kernels import NO_CELL, astar, line_is_free, nearest_free

__all__ = ["SNAP", "find_path", "free_run", "is_clear", "path_length"]

Mask = npt.NDArray[np.bool_]

SNAP = 0.6
"""Greatest distance from a start or goal in a blocked cell to a free one, metres."""

ROUNDING = 0.3
"""Distance from a corner at which its rounding begins, metres."""

_PARTS = 4
_PASSES = 3


def path_length(points: Sequence[Point]) -> float:
    """Return the length of a polyline."""
    return sum(dist(a, b) for a, b in pairwise(points))


def is_clear(blocked: Mask, frame: GridFrame, a: Point, b: Point) -> bool:
    """Whether the straight way between two points is free."""
    k = 1.0 / frame.resolution
    return bool(
        line_is_free(
            blocked, (a[1] - frame.y0) * k, (a[0] - frame.x0) * k, (b[1] - frame.y0) * k, (b[0] - frame.x0) * k
        )
    )


def find_path(blocked: Mask, frame: GridFrame, start: Point, goal: Point, snap: float = SNAP) -> list[Point] | None:
    """Return a polyline from `start` to `goal`, or ``None``.

    A start in a blocked cell is first left towards the nearest free one, so that a robot gets out of any corner;
    a goal in a blocked cell is replaced by the nearest free one.

    Parameters
    ----------
    blocked : (rows, columns) array of bool
    snap : float
        How far a blocked goal may be from a free cell, metres; a start may be `SNAP` away.
    """
    first = _snapped(blocked, frame, start, SNAP)
    last = _snapped(blocked, frame, goal, snap)
    if first is None or last is None:
        return None
    cells = astar(blocked, first, last)
    if len(cells) == 0:
        return None
    points = [frame.center(int(cell) // frame.columns, int(cell) % frame.columns) for cell in cells]
    end = goal if not _is_blocked(blocked, frame, goal) else points[-1]
    if not _is_blocked(blocked, frame, start):
        points[0] = start
        points = points if len(points) > 1 else [start, end]
        points[-1] = end
        return _smoothed(blocked, frame, points)
    points[-1] = end
    return [start, *_smoothed(blocked, frame, points)]


def free_run(blocked: Mask, frame: GridFrame, start: Point, angle: float, reach: float) -> float:
    """Return how far the robot can go straight, metres.

    Where it stands in a blocked cell it may go as long as it gets out, `SNAP` metres at most.
    """
    ux, uy = float(np.cos(angle)), float(np.sin(angle))
    step = frame.resolution / 4
    inside = _is_blocked(blocked, frame, start)
    gone, free = 0.0, 0.0
    while gone < reach - 1e-9:
        gone = min(gone + step, reach)
        here = _is_blocked(blocked, frame, (start[0] + gone * ux, start[1] + gone * uy))
        if here and not inside:
            break
        if here and gone > SNAP:
            break
        if not here:
            inside, free = False, gone
    return free


def _is_blocked(blocked: Mask, frame: GridFrame, point: Point) -> bool:
    row, column = frame.cell(*point)
    return not frame.holds(row, column) or bool(blocked[row, column])


def _snapped(blocked: Mask, frame: GridFrame, point: Point, reach: float) -> int | None:
    row, column = frame.cell(*point)
    if frame.holds(row, column) and not blocked[row, column]:
        return row * frame.columns + column
    found = int(nearest_free(blocked, row, column, int(reach / frame.resolution)))
    return None if found == NO_CELL else found


def _smoothed(blocked: Mask, frame: GridFrame, points: list[Point]) -> list[Point]:
    """Straighten a path and round its corners, as far as every part of the result is free."""
    straight = _straightened(blocked, frame, points)
    for path in (_rounded(blocked, frame, straight), straight):
        if all(is_clear(blocked, frame, a, b) for a, b in pairwise(path)):
            return path
    return points


def _straightened(blocked: Mask, frame: GridFrame, points: list[Point]) -> list[Point]:
    for _ in range(_PASSES):
        before = path_length(points)
        points = _pulled(blocked, frame, points)[::-1]
        points = _pulled(blocked, frame, _subdivided(points))[::-1]
        if before - path_length(points) < 1e-3:
            break
        points = _subdivided(points)
    return _pulled(blocked, frame, points)


def _pulled(blocked: Mask, frame: GridFrame, points: list[Point]) -> list[Point]:
    """Drop each point that a straight line from the last kept one can skip (string pulling)."""
    kept = [points[0]]
    for here, after in pairwise(points[1:]):
        if not is_clear(blocked, frame, kept[-1], after):
            kept.append(here)
    return [*kept, points[-1]]


def _subdivided(points: list[Point]) -> list[Point]:
    dense = [points[0]]
    for a, b in pairwise(points):
        parts = max(1, int(dist(a, b) / 0.25))
        dense += [(a[0] + (b[0] - a[0]) * i / parts, a[1] + (b[1] - a[1]) * i / parts) for i in range(1, parts)]
        dense.append(b)
    return dense


def _rounded(blocked: Mask, frame: GridFrame, points: list[Point]) -> list[Point]:
    """Replace each corner by a quadratic curve where that is free."""
    smooth = [points[0]]
    for a, corner, b in zip(points, points[1:], points[2:]):
        before, after = _towards(corner, a), _towards(corner, b)
        curve = [_bezier(before, corner, after, i / _PARTS) for i in range(_PARTS + 1)]
        free = all(is_clear(blocked, frame, p, q) for p, q in pairwise(curve))
        smooth += curve if free else [corner]
    return [*smooth, points[-1]]


def _towards(corner: Point, other: Point) -> Point:
    t = min(ROUNDING, dist(corner, other) / 2) / max(dist(corner, other), 1e-9)
    return corner[0] + (other[0] - corner[0]) * t, corner[1] + (other[1] - corner[1]) * t


def _bezier(a: Point, b: Point, c: Point, t: float) -> Point:
    u = 1.0 - t
    return (u * u * a[0] + 2 * u * t * b[0] + t * t * c[0], u * u * a[1] + 2 * u * t * b[1] + t * t * c[1])
