"""Candidate poses: backs along walls, a grid over the floor, and rings around what an object belongs to."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from mansion_geometry.boxes import unit_vector
from mansion_scene.placement.floor import Floor
from mansion_scene.placement.pose_kernels import ring_rows, wall_rows
from mansion_scene.placement.room import Wall, wall_array

__all__ = ["floor_poses", "flush_poses", "ring_poses", "wall_poses"]

Floats = npt.NDArray[np.float64]
Extent = tuple[float, float, float, float]


def wall_poses(
    floor: Floor, extent: Extent, half_depth: float, rng: np.random.Generator, *, walls: Sequence[Wall] | None = None
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
    chosen = floor.room.walls if walls is None else walls
    if not chosen:
        return np.zeros((0, 4))
    rows = floor.room.wall_rows if walls is None else wall_array(walls)
    # Short walls of a round or bevelled room: off the wall until the corners clear it.
    backs = np.array([floor.options.wall_gap, 0.04, 0.08, 0.12])
    obstacles = np.concatenate([floor.boxes, floor.zones[:, :6]])
    phase = rng.random(len(rows))
    return np.asarray(wall_rows(rows, np.array(extent), half_depth, obstacles, floor.gap, backs, phase))


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
    """Return poses of a large unit at each gap from either end of the room's bounds, and amid them, shape (n, 4).

    A block that only just fits is missed by a grid; it fits flush with the walls. Only for rooms along the axes.

    Parameters
    ----------
    extent : (x min, x max, y min, y max)
        Of the unit in its anchor's frame, metres.
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
