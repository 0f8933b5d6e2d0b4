"""Kernels that make candidate poses: stops along walls, and rings around boxes."""

import math

import numpy as np
import numpy.typing as npt

from mansion_geometry.compiled import kernel

__all__ = ["ring_rows", "wall_rows"]

Floats = npt.NDArray[np.float64]

_SERIES = 41
"""Most stops of a wall's regular series."""

_CORNER = 0.3
"""Distance from a wall's ends at which furniture often stands, metres."""


@kernel
def _wall_stops(
    wall: Floats, extent: Floats, half_depth: float, obstacles: Floats, gap: float, phase: float, stops: Floats
) -> int:
    """Write the distances along a wall at which an anchor's centre may stand, ascending; return how many."""
    left, right, length = extent[0], extent[1], wall[6]
    low, high = -left + gap, length - right - gap
    if high < low:
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
        Of the anchor.
    obstacles : (m, 6) array
        What stands or must stay free.
    gap : float
        Between neighbours, metres.
    backs : (b,) array
        Distances of the back from the wall; all but the first only at walls shorter than the unit.
    phase : (w,) array
        Where in its first step each wall's series begins, 0 to 1.

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
