"""Candidate poses: backs along walls, a grid over the floor, and rings around what an object belongs to."""

import math
from collections.abc import Sequence

import numpy as np

from mansion_geometry.boxes import unit_vector
from mansion_geometry.compiled import Floats, kernel
from mansion_scene.placement.floor import Floor
from mansion_scene.placement.room_model import Wall, wall_array

__all__ = ["floor_poses", "flush_poses", "opposite_poses", "ring_poses", "ring_rows", "wall_poses", "wall_rows"]


_SERIES = 41
"""Greatest number of positions in the regular series along a wall."""

_CORNER = 0.3
"""Distance from a wall's ends at which furniture is often placed, metres."""


@kernel
def _wall_stops(
    wall: Floats, extent: Floats, half_depth: float, obstacles: Floats, gap: float, phase: float, stops: Floats
) -> int:
    """Write the distances along a wall at which an anchor's centre may be, ascending; return how many."""
    left, right, length = extent[0], extent[1], wall[6]
    low, high = -left + gap, length - right - gap
    if high < low:
        # The wall is shorter than the unit, which may still fit between bevelled or round neighbours.
        stops[0] = length / 2
        return 1
    depth = half_depth + extent[3]
    count = 0
    step = max(0.05, (high - low) / 40)
    at = low + phase * step
    while at < high and count < _SERIES:
        stops[count] = at
        count += 1
        at += step
    for special in (low, high, (low + high) / 2, _CORNER - left, length - right - _CORNER):
        stops[count] = special
        count += 1
    # Next to each obstacle on either side, where it reaches into the strip of floor that the unit would cover.
    for m in range(obstacles.shape[0]):
        qx, qy = obstacles[m, 0] - wall[0], obstacles[m, 1] - wall[1]
        along, away = qx * wall[2] + qy * wall[3], qx * wall[4] + qy * wall[5]
        c = abs(obstacles[m, 2] * wall[2] + obstacles[m, 3] * wall[3])
        s = abs(obstacles[m, 2] * wall[3] - obstacles[m, 3] * wall[2])
        reach = c * obstacles[m, 4] + s * obstacles[m, 5]
        reach_away = s * obstacles[m, 4] + c * obstacles[m, 5]
        if away - reach_away < depth and away + reach_away > 0.0:
            stops[count] = along + reach + gap - left
            stops[count + 1] = along - reach - gap - right
            count += 2
    kept = 0
    for i in range(count):
        if low - 1e-9 <= stops[i] <= high + 1e-9:
            # Rounded, so that stops which coincide but for rounding are found equal by `wall_rows` and count once.
            stops[kept] = round(stops[i] * 1e6) / 1e6
            kept += 1
    stops[:kept].sort()
    return kept


@kernel
def wall_rows(
    walls: Floats, extent: Floats, half_depth: float, obstacles: Floats, gap: float, backs: Floats, phase: Floats
) -> Floats:
    """Return poses with the back to each wall: a regular series, corners, the middle, and beside obstacles.

    Parameters
    ----------
    walls : (w, 7) array
        Start, unit direction, inward normal, length.
    extent : (4,) array
        x min, x max, y min, y max of the unit in its anchor's frame.
    half_depth : float
        Half depth of the anchor, metres.
    obstacles : (m, 6) array
        Boxes that are placed or must stay free.
    gap : float
        Gap between neighbours, metres.
    backs : (b,) array
        Distances of the back from the wall; all but the first only at walls shorter than the unit.
    phase : (w,) array
        Offset of each wall's series within its first step, 0 to 1.

    Returns
    -------
    (n, 4) array; the stops of a wall ascend.
    """
    most = _SERIES + 5 + 2 * obstacles.shape[0]
    stops = np.empty(most)
    out = np.empty((walls.shape[0] * most * backs.shape[0], 4))
    n = 0
    for w in range(walls.shape[0]):
        count = _wall_stops(walls[w], extent, half_depth, obstacles, gap, phase[w], stops)
        sx, sy, ax, ay, nx, ny, length = walls[w]
        for b in range(1 if length >= extent[1] - extent[0] else backs.shape[0]):
            off = half_depth + backs[b]
            for i in range(count):
                if i > 0 and stops[i] == stops[i - 1]:
                    continue
                out[n, 0] = sx + nx * off + stops[i] * ax
                out[n, 1] = sy + ny * off + stops[i] * ay
                out[n, 2], out[n, 3] = ax, ay
                n += 1
    return out[:n].copy()


@kernel
def ring_rows(targets: Floats, hw: float, hd: float, gaps: Floats, turned: Floats) -> Floats:
    """Return poses of a box around targets: each side, along it, at each gap (see `ring_poses`)."""
    out = np.empty((4 * turned.shape[0] * gaps.shape[0] * 7 * targets.shape[0], 4))
    n = 0
    for side in range(4):
        for turn in turned:
            deep, wide = (hd, hw) if turn % 2 == 0 else (hw, hd)
            for gap in gaps:
                # Along the side: its middle, flush with either end, halfway to either, and centred on either end.
                for place in range(7):
                    for t in range(targets.shape[0]):
                        ux, uy = targets[t, 2], targets[t, 3]
                        # Outward normal of the side, its half extent, and the same along the side.
                        sign = 1.0 if side % 2 == 0 else -1.0
                        if side < 2:
                            ox, oy, gx, gy = -uy * sign, ux * sign, ux, uy
                            half_out, half_along = targets[t, 5], targets[t, 4]
                        else:
                            ox, oy, gx, gy = ux * sign, uy * sign, -uy, ux
                            half_out, half_along = targets[t, 4], targets[t, 5]
                        flush = half_along - wide
                        shift = 0.0
                        if place in (1, 2):
                            shift = flush
                        elif place in (3, 4):
                            shift = flush / 2
                        elif place > 4:
                            shift = half_along
                        if place in (2, 4, 6):
                            shift = -shift
                        off = half_out + gap + deep
                        # Facing the side the front is -out, so the width axis is (-out_y, out_x); then turned.
                        fx, fy = -oy, ox
                        for _ in range(math.floor(turn)):
                            fx, fy = -fy, fx
                        out[n, 0] = targets[t, 0] + ox * off + shift * gx
                        out[n, 1] = targets[t, 1] + oy * off + shift * gy
                        out[n, 2], out[n, 3] = fx, fy
                        n += 1
    return out


Extent = tuple[float, float, float, float]


def wall_poses(
    floor: Floor, extent: Extent, half_depth: float, rng: np.random.Generator, *, walls: Sequence[Wall] | None = None
) -> Floats:
    """Return poses of a unit whose anchor has its back to a wall.

    Positions are a regular series, both corners, the middle, and next to whatever is placed or must stay free
    along the wall.

    Parameters
    ----------
    extent : (x min, x max, y min, y max)
        Extent of the unit in its anchor's frame, metres.
    half_depth : float
        Half depth of the anchor, metres.
    walls : sequence of Wall, optional
        Walls to use; all of the room's by default.

    Returns
    -------
    (n, 4) array
    """
    chosen = floor.room.walls if walls is None else walls
    if not chosen:
        return np.zeros((0, 4))
    rows = floor.room.wall_rows if walls is None else wall_array(walls)
    # Short walls of a round or bevelled room: off the wall until the corners clear it.
    backs = np.array([floor.options.wall_gap, 0.04, 0.08, 0.12])
    obstacles = np.concatenate([floor.boxes, floor.zones[:, :6]])
    phase = rng.random(len(rows))
    return np.asarray(wall_rows(rows, np.array(extent), half_depth, obstacles, floor.gap, backs, phase))


def opposite_poses(floor: Floor, half_depth: float, targets: Floats) -> Floats:
    """Return poses with the back to a wall, straight ahead of a target and facing it, shape (n, 4)."""
    rows = []
    for target in targets:
        front = np.array([-target[3], target[2]])
        for wall in floor.room.walls:
            at = float((target[:2] - wall.start) @ wall.along)
            if wall.inward @ front < -0.99 and 0.0 < at < wall.length:
                centre = wall.start + at * wall.along + (half_depth + floor.options.wall_gap) * wall.inward
                rows.append((*centre, *wall.along))
    return np.array(rows).reshape(-1, 4)


def floor_poses(floor: Floor, rng: np.random.Generator, *, limit: int = 1200) -> Floats:
    """Return poses on a grid over the room in the direction of its walls, four rotations each, shape (n, 4)."""
    room = floor.room
    angles = room.angles or [0.0]
    rows = []
    x0, y0, x1, y1 = room.bounds
    middle = np.array([(x0 + x1) / 2, (y0 + y1) / 2])
    for rank, angle in enumerate(angles):
        share = limit if len(angles) == 1 else (2 * limit // 3 if rank == 0 else limit // 3)
        step = min(1.5, max(0.08, (4 * room.area / share) ** 0.5))
        c, s = unit_vector(angle)
        half = np.abs([(x1 - x0) * c, (y1 - y0) * s]).sum() / 2
        half_y = np.abs([(x1 - x0) * s, (y1 - y0) * c]).sum() / 2
        a = np.arange(-half + rng.uniform(0, step), half, step)
        b = np.arange(-half_y + rng.uniform(0, step), half_y, step)
        ga, gb = (g.ravel() for g in np.meshgrid(a, b))
        xy = middle + np.column_stack([ga * c - gb * s, ga * s + gb * c])
        for quarter in range(4):
            u = unit_vector(angle + 90.0 * quarter)
            rows.append(np.hstack([xy, np.broadcast_to(np.array(u), (len(xy), 2))]))
    return np.concatenate(rows)


def flush_poses(floor: Floor, extent: Extent, gaps: Sequence[float]) -> Floats:
    """Return poses of a large unit at each gap from either end of the room's bounds, and centred, shape (n, 4).

    A block that only just fits is missed by a grid; it fits flush with the walls. Only for rooms along the axes.

    Parameters
    ----------
    extent : (x min, x max, y min, y max)
        Extent of the unit in its anchor's frame, metres.
    gaps : sequence of float
        Distances from the bounds, metres.
    """
    if floor.room.angles[:1] != [0.0]:
        return np.zeros((0, 4))
    x0, x1, y0, y1 = extent
    left, low, right, high = (float(v) for v in floor.room.bounds)
    rows = []
    for a, b, c, d, u in (
        (x0, x1, y0, y1, (1.0, 0.0)),
        (-y1, -y0, x0, x1, (0.0, 1.0)),
        (-x1, -x0, -y1, -y0, (-1.0, 0.0)),
        (y0, y1, -x1, -x0, (0.0, -1.0)),
    ):
        xs = [(left + right - a - b) / 2, *(left + g - a for g in gaps), *(right - g - b for g in gaps)]
        ys = [(low + high - c - d) / 2, *(low + g - c for g in gaps), *(high - g - d for g in gaps)]
        rows += [(x, y, *u) for x in xs for y in ys]
    return np.array(rows)


def ring_poses(targets: Floats, hw: float, hd: float, gaps: tuple[float, ...], *, turned: tuple[int, ...]) -> Floats:
    """Return poses of a box around targets: each side, along it, at each gap.

    Parameters
    ----------
    targets : (m, 6) array
    hw, hd : float
        Half width and half depth of the box.
    gaps : tuple of float
        Distances from the target's side, metres.
    turned : tuple of int
        Quarter turns from facing the target's side (0: facing it, 2: its back to it).

    Returns
    -------
    (n, 4) array
    """
    return np.asarray(ring_rows(targets, hw, hd, np.array(gaps, dtype=float), np.array(turned, dtype=float)))
