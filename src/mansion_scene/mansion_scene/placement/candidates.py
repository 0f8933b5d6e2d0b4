"""Candidate poses: backs along walls, a grid over the floor, and rings around what an object belongs to."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from mansion_geometry.boxes import unit_vector
from mansion_scene.placement.floor import Floor
from mansion_scene.placement.room import Wall

__all__ = ["floor_poses", "ring_poses", "wall_poses"]

Floats = npt.NDArray[np.float64]
Extent = tuple[float, float, float, float]


def wall_poses(
    floor: Floor,
    extent: Extent,
    half_depth: float,
    rng: np.random.Generator,
    *,
    walls: Sequence[Wall] | None = None,
) -> Floats:
    """Return poses of a unit whose anchor has its back to a wall.

    Positions are a regular series, both corners, the middle, and next to whatever stands or must stay free along
    the wall.

    Parameters
    ----------
    extent : (x min, x max, y min, y max)
        Of the unit in its anchor's frame, metres.
    half_depth : float
        Of the anchor.
    walls : sequence of Wall, optional
        Which walls; all of the room's by default.

    Returns
    -------
    (n, 4) array
    """
    options = floor.options
    obstacles = np.concatenate([floor.boxes, floor.zones[:, :6]])
    rows = []
    for wall in floor.room.walls if walls is None else walls:
        stops = _stops(wall, extent, half_depth, obstacles, floor.gap, rng)
        backs = [options.wall_gap]
        if wall.length < extent[1] - extent[0]:
            # Short walls of a round or bevelled room: off the wall until the corners clear it.
            backs += [0.04, 0.08, 0.12]
        for back in backs:
            centre = wall.start + wall.inward * (half_depth + back)
            xy = centre[None, :] + stops[:, None] * wall.along[None, :]
            rows.append(np.hstack([xy, np.broadcast_to(wall.along, (len(stops), 2))]))
    return np.concatenate(rows) if rows else np.zeros((0, 4))


def _stops(
    wall: Wall,
    extent: Extent,
    half_depth: float,
    obstacles: Floats,
    gap: float,
    rng: np.random.Generator,
) -> Floats:
    """Return distances along a wall at which the anchor's centre may stand."""
    left, right = extent[0], extent[1]
    low, high = -left + gap, wall.length - right - gap
    if high < low:
        return np.array([wall.length / 2])
    step = max(0.05, (high - low) / 40)
    regular = np.arange(low + rng.uniform(0, step), high, step)
    special = [low, high, (low + high) / 2, -left + 0.3, wall.length - right - 0.3]
    if len(obstacles):
        q = obstacles[:, :2] - wall.start
        along = q @ wall.along
        away = q @ wall.inward
        c = np.abs(obstacles[:, 2] * wall.along[0] + obstacles[:, 3] * wall.along[1])
        s = np.abs(obstacles[:, 2] * wall.along[1] - obstacles[:, 3] * wall.along[0])
        reach_along = c * obstacles[:, 4] + s * obstacles[:, 5]
        reach_away = s * obstacles[:, 4] + c * obstacles[:, 5]
        depth = half_depth + extent[3]
        beside = (away - reach_away < depth) & (away + reach_away > 0.0)
        special += list((along + reach_along)[beside] + gap - left)
        special += list((along - reach_along)[beside] - gap - right)
    stops = np.concatenate([regular, np.array(special)])
    inside = np.round(stops[(stops >= low - 1e-9) & (stops <= high + 1e-9)], 6)
    return np.asarray(np.unique(inside))


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


def ring_poses(
    targets: Floats, hw: float, hd: float, gaps: tuple[float, ...], *, turned: tuple[int, ...]
) -> Floats:
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
    rows = []
    for side in range(4):
        # Outward normal of the side, its half extent, and the same along the side.
        u = targets[:, 2:4]
        v = np.column_stack([-u[:, 1], u[:, 0]])
        out = (v, -v, u, -u)[side]
        along = u if side < 2 else v
        half_out, half_along = targets[:, 5], targets[:, 4]
        if side >= 2:
            half_out, half_along = half_along, half_out
        for turn in turned:
            # Facing the side the front is -out, so the width axis is (-out_y, out_x); then turned.
            face = np.column_stack([-out[:, 1], out[:, 0]])
            for _ in range(turn):
                face = np.column_stack([-face[:, 1], face[:, 0]])
            deep, wide = (hd, hw) if turn % 2 == 0 else (hw, hd)
            flush = half_along - wide
            places = np.stack(
                [0 * flush, flush, -flush, flush / 2, -flush / 2, half_along, -half_along]
            )
            for gap in gaps:
                xy = targets[:, :2] + out * (half_out + gap + deep)[:, None]
                shifted = xy[None] + places[:, :, None] * along[None]
                rows.append(
                    np.concatenate([shifted, np.broadcast_to(face, shifted.shape)], axis=2).reshape(
                        -1, 4
                    )
                )
    return np.concatenate(rows)
