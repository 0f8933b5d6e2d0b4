"""Matrices as macro objects: BUILDMACROOBJECT and DOWNGRADEMATRIX of Algorithm 4, lines 4 to 16."""

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from mansion_scene.placement.arrange import place_along_walls, repeated
from mansion_scene.placement.candidates import floor_poses, wall_poses
from mansion_scene.placement.floor import Floor
from mansion_scene.placement.groups import Spec
from mansion_scene.placement.scoring import pose_scores
from mansion_scene.placement.search import examine
from mansion_scene.placement.units import Unit

__all__ = ["downgrades", "focus_direction", "place_matrix"]

Floats = npt.NDArray[np.float64]


def downgrades(rows: int, cols: int) -> Iterator[tuple[int, int]]:
    """Yield smaller matrices, the one that keeps most copies first (DOWNGRADEMATRIX), beginning with the whole."""
    sizes = [(r, c) for r in range(1, rows + 1) for c in range(1, cols + 1)]
    yield from sorted(sizes, key=lambda s: (-s[0] * s[1], -min(s), -s[1]))


def focus_direction(floor: Floor) -> Floats | None:
    """Return the direction in which the board, stage or teacher's desk looks, None without one."""
    for copy in floor.placed:
        if floor.specs[copy.spec].role.focal:
            return np.array([-copy.box[3], copy.box[2]])
    return None


def place_matrix(
    floor: Floor,
    spec: Spec,
    unit: Unit,
    rng: np.random.Generator,
    aisle: float,
    *,
    whole: bool,
) -> tuple[int, int] | None:
    """Place the largest matrix of units that fits and return its size, None where not one copy does.

    Parameters
    ----------
    unit : Unit
        One copy with its members.
    aisle : float
        Widest gap between rows and columns that is tried, metres.
    whole : bool
        Whether only the whole matrix will do.
    """
    for rows, cols in downgrades(spec.rows, spec.cols):
        if whole and (rows, cols) != (spec.rows, spec.cols):
            break
        if spec.where == "edge" and min(rows, cols) <= 2:
            if place_along_walls(floor, spec, unit, min(rows, cols), max(rows, cols), rng, aisle):
                return rows, cols
            continue
        for gap_x, gap_y, lines, per_line in _spacings(spec, unit, rows, cols, aisle):
            if _place_macro(floor, spec, unit, (lines, per_line), (gap_x, gap_y), rng):
                return rows, cols
    return None


def _spacings(
    spec: Spec, unit: Unit, rows: int, cols: int, aisle: float
) -> list[tuple[float, float, int, int]]:
    """Return gaps between columns and rows with the macro's lines and copies a line, the most comfortable first.

    Shelves stand shoulder to shoulder with aisles between the rows; desks and seats may have either way through.
    """
    shelf = len(unit.parts) == 1 and not (spec.role.seat or spec.role.table)
    beside = [0.02, 0.45, aisle] if shelf else [aisle, 0.75, 0.6, 0.45, 0.3, 0.05]
    behind = [1.25 * aisle, aisle, 0.75, 0.6, 0.45]
    if not shelf:
        behind += [0.3, 0.15]
    ranked = []
    for gx in beside:
        for gy in behind:
            if max(gx if cols > 1 else 0.0, gy if rows > 1 else 0.0) < 0.45 and rows * cols > 2:
                continue
            comfort = min(gy, aisle) / aisle
            comfort += 0.5 * (gx < 0.1) if shelf else min(gx, aisle) / aisle
            comfort -= 0.2 * (gy > aisle)
            ranked.append((-comfort, gx, gy))
    spaced = []
    for _, gx, gy in sorted(ranked):
        spaced.append((gx, gy, rows, cols))
        if rows != cols:
            spaced.append((gx, gy, cols, rows))
    return spaced


def _place_macro(
    floor: Floor,
    spec: Spec,
    unit: Unit,
    shape: tuple[int, int],
    gaps: tuple[float, float],
    rng: np.random.Generator,
) -> bool:
    x0, x1, y0, y1 = unit.extent()
    px, py = x1 - x0 + gaps[0], y1 - y0 + gaps[1]
    width, depth = shape[1] * px - gaps[0], shape[0] * py - gaps[1]
    span = floor.room.bounds[2:] - floor.room.bounds[:2]
    if width * depth > floor.room.area or max(width, depth) > float(np.hypot(*span)):
        return False
    offsets = np.array([(c * px, r * py) for r in range(shape[0]) for c in range(shape[1])])
    centre = offsets.mean(axis=0)
    if spec.where == "edge":
        macro = repeated(unit, offsets - [centre[0], 0.0])
        poses = wall_poses(floor, macro.extent(), unit.sizes[0][1] / 2, rng)
    else:
        macro = repeated(unit, offsets - centre)
        poses = floor_poses(floor, rng, limit=500)
    poses = _facing(floor, spec, unit, poses)
    if not len(poses):
        return False
    poses = poses[floor.fits(poses, macro.array())]
    if not len(poses):
        return False
    if len(poses) > 80:
        poses = poses[np.sort(rng.choice(len(poses), 80, replace=False))]
    scores = pose_scores(floor, spec, macro, poses, rng, at_wall=spec.where == "edge")
    return examine(floor, macro, poses, scores) is not None


def _facing(floor: Floor, spec: Spec, unit: Unit, poses: Floats) -> Floats:
    """Keep poses at which those who sit look at the board, where there is one."""
    focus = focus_direction(floor)
    seated = [floor.specs[s].role.seat for s in unit.specs]
    if focus is None or not any(seated):
        return poses
    wanted = -focus if seated[0] else focus
    ahead = -poses[:, 3] * wanted[0] + poses[:, 2] * wanted[1]
    return np.asarray(poses[ahead > 0.9])
