"""Where AI2-THOR's agent can stand: ``GetReachablePositions`` from the house JSON alone."""

from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from mansion_geometry.compiled import kernel
from mansion_geometry.thor.house_format import object_nodes
from mansion_msgs_py.shapes import Point

__all__ = ["ENOUGH_POSITIONS", "GRID", "connected_positions", "reachable_positions"]

Json: TypeAlias = dict[str, Any]
Bools: TypeAlias = npt.NDArray[np.bool_]
Floats: TypeAlias = npt.NDArray[np.float64]

GRID = 0.25
"""AI2-THOR's default ``gridSize``, metres."""

RADIUS = 0.2
"""Radius of the agent's capsule, metres."""

AGENT_TOP = 1.8
"""Height of the capsule; what hangs higher is no obstacle."""

STEP_OVER = 0.05
"""Height that the agent steps over, metres."""

ENOUGH_POSITIONS = 5
"""Reachable grid points that ``House.validate`` of ProcTHOR asks of each room."""


def connected_positions(house: Json, start: Point) -> list[list[Point]]:
    """Return the grid points (x, z) where the agent fits, in sets that steps of `GRID` in four directions connect.

    Parameters
    ----------
    house : dict
        House JSON; objects need ``size``.
    start : (x, z)
        A point of the grid, metres.
    """
    xs, zs, labels = _labelled_grid(house, start)
    return [_points(xs, zs, labels == label) for label in range(1, int(labels.max()) + 1)]


def reachable_positions(house: Json, start: Point) -> list[Point]:
    """Return the grid points (x, z) that the agent reaches from `start`, as ``GetReachablePositions`` does.

    Parameters
    ----------
    house : dict
        House JSON; objects need ``size``.
    start : (x, z)
        A point of the grid, metres.

    Returns
    -------
    list of (x, z)
        Empty where the agent does not fit at `start`.
    """
    xs, zs, labels = _labelled_grid(house, start)
    label = labels[int(np.argmin(np.abs(zs - start[1]))), int(np.argmin(np.abs(xs - start[0])))]
    return _points(xs, zs, labels == label) if label else []


def _points(xs: Floats, zs: Floats, chosen: Bools) -> list[Point]:
    return [(round(float(xs[j]), 4), round(float(zs[i]), 4)) for i, j in np.argwhere(chosen)]


def _labelled_grid(house: Json, start: Point) -> tuple[Floats, Floats, npt.NDArray[np.int32]]:
    """Return the coordinates of a grid through `start` and the number of each point's connected set, 0 for none."""
    xs, zs = _axes(house, start)
    free = _inside(house, xs, zs)
    passages = _steps(house, xs, zs)
    for item in object_nodes(house["objects"]):
        bottom = item["position"]["y"] - item["size"]["y"] / 2
        if bottom < AGENT_TOP and bottom + item["size"]["y"] > STEP_OVER:
            rows, columns, hit = _covered(item, xs, zs)
            free[rows, columns] &= ~hit
    return xs, zs, _components(free, *passages)


def _axes(house: Json, start: Point) -> tuple[Floats, Floats]:
    points = np.array([[p["x"], p["z"]] for room in house["rooms"] for p in room["floorPolygon"]])
    low = np.floor((points.min(0) - start) / GRID).astype(int)
    high = np.ceil((points.max(0) - start) / GRID).astype(int)
    return (start[0] + GRID * np.arange(low[0], high[0] + 1), start[1] + GRID * np.arange(low[1], high[1] + 1))


def _inside(house: Json, xs: Floats, zs: Floats) -> Bools:
    inside = np.zeros((len(zs), len(xs)), dtype=bool)
    for room in house["rooms"]:
        ring = [(p["x"], p["z"]) for p in room["floorPolygon"]]
        hit = np.zeros_like(inside)
        for (ax, az), (bx, bz) in zip(ring, ring[1:] + ring[:1]):
            if az != bz:
                cross = (bx - ax) * (zs - az) / (bz - az) + ax
                hit ^= ((az > zs) != (bz > zs))[:, None] & (xs[None, :] < cross[:, None])
        inside |= hit
    return inside


def _solid_parts(house: Json) -> list[tuple[float, float, float, float]]:
    """Walls between their passable doors, as segments (ax, az, bx, bz); one face of each twin."""
    gaps: dict[str, tuple[float, float]] = {}
    for door in house["doors"]:
        if not door["openable"] or door["openness"] > 0.5:
            low, high = (point["x"] for point in door["holePolygon"])
            gaps[door["wall0"]] = (low, high)
    parts = []
    twins = {door["wall1"]: door["wall0"] for door in house["doors"]}
    for wall in house["walls"]:
        if wall.get("empty") or wall["id"] in twins:
            continue
        (a, b) = wall["polygon"][0], wall["polygon"][1]
        ax, az, bx, bz = a["x"], a["z"], b["x"], b["z"]
        length = float(np.hypot(bx - ax, bz - az))
        low, high = gaps.get(wall["id"], (length, length))
        for s, t in ((0.0, low), (high, length)):
            if t - s > 1e-6:
                u, v = s / length, t / length
                parts.append((ax + (bx - ax) * u, az + (bz - az) * u, ax + (bx - ax) * v, az + (bz - az) * v))
    return parts


def _steps(house: Json, xs: Floats, zs: Floats) -> tuple[Bools, Bools, Bools]:
    """Points too near to a wall, and steps to the right and upwards that cross one."""
    near = np.zeros((len(zs), len(xs)), dtype=bool)
    right = np.zeros_like(near)
    up = np.zeros_like(near)
    grid_x, grid_z = np.meshgrid(xs, zs)
    for ax, az, bx, bz in _solid_parts(house):
        margin = 2 * GRID
        columns = slice(*np.searchsorted(xs, (min(ax, bx) - margin, max(ax, bx) + margin)))
        rows = slice(*np.searchsorted(zs, (min(az, bz) - margin, max(az, bz) + margin)))
        window = (rows, columns)
        x, z = grid_x[window], grid_z[window]
        for target, dx, dz in ((near, 0.0, 0.0), (right, GRID, 0.0), (up, 0.0, GRID)):
            distance = _distance(x, z, dx, dz, (ax, az, bx, bz))
            target[window] |= distance < RADIUS - 1e-6
    return near, right, up


def _distance(x: Floats, z: Floats, dx: float, dz: float, part: tuple[float, float, float, float]) -> Floats:
    """Distance of a wall from points, or from the middle third of a step from them."""
    ax, az, bx, bz = part
    length = (bx - ax) ** 2 + (bz - az) ** 2
    best = np.full(x.shape, np.inf)
    for share in (0.0,) if dx == dz == 0.0 else (0.25, 0.5, 0.75):
        px, pz = x + share * dx, z + share * dz
        t = np.clip(((px - ax) * (bx - ax) + (pz - az) * (bz - az)) / length, 0.0, 1.0)
        best = np.minimum(best, np.hypot(px - ax - t * (bx - ax), pz - az - t * (bz - az)))
    return best


def _components(free: Bools, near: Bools, right: Bools, up: Bools) -> npt.NDArray[np.int32]:
    """Label points that steps connect, from 1; 0 where the agent does not fit."""
    free = free & ~near
    go_right, go_up = np.zeros_like(free), np.zeros_like(free)
    go_right[:, :-1] = free[:, :-1] & free[:, 1:] & ~right[:, :-1]
    go_up[:-1] = free[:-1] & free[1:] & ~up[:-1]
    labels = np.zeros(free.shape, dtype=np.int32)
    _label(free, go_right, go_up, labels)
    return labels


@kernel
def _label(free: Bools, go_right: Bools, go_up: Bools, labels: npt.NDArray[np.int32]) -> None:
    """Flood each connected set of points with its number."""
    rows, columns = free.shape
    stack = np.empty(rows * columns, dtype=np.int64)
    label = 0
    for seed in range(rows * columns):
        if not free[seed // columns, seed % columns] or labels[seed // columns, seed % columns]:
            continue
        label += 1
        labels[seed // columns, seed % columns] = label
        stack[0] = seed
        size = 1
        while size > 0:
            size -= 1
            i, j = stack[size] // columns, stack[size] % columns
            for step in range(4):
                m = i + (step == 0) - (step == 1)
                n = j + (step == 2) - (step == 3)
                if m < 0 or n < 0 or m >= rows or n >= columns or labels[m, n]:
                    continue
                a, b = min(i, m), min(j, n)
                if (step < 2 and go_up[a, b]) or (step >= 2 and go_right[a, b]):
                    labels[m, n] = label
                    stack[size] = m * columns + n
                    size += 1


def _covered(item: Json, xs: Floats, zs: Floats) -> tuple[slice, slice, Bools]:
    """Return a window of the grid around an object, and which of its points the object's box is too near to."""
    angle = np.radians(item["rotation"]["y"])
    c, s = float(np.cos(angle)), float(np.sin(angle))
    x, z = item["position"]["x"], item["position"]["z"]
    a, b = item["size"]["x"] / 2, item["size"]["z"] / 2
    reach = float(np.hypot(a, b)) + RADIUS
    columns = slice(*np.searchsorted(xs, (x - reach, x + reach)))
    rows = slice(*np.searchsorted(zs, (z - reach, z + reach)))
    dx, dz = xs[None, columns] - x, zs[rows, None] - z
    # Turning clockwise by the angle maps local (w, d) to (w c + d s, d c - w s).
    w = np.maximum(np.abs(dx * c - dz * s) - a, 0.0)
    d = np.maximum(np.abs(dx * s + dz * c) - b, 0.0)
    return rows, columns, np.hypot(w, d) < RADIUS - 1e-6
