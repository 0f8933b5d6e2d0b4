"""Matrices as macro objects: BUILDMACROOBJECT and DOWNGRADEMATRIX of Algorithm 4, lines 4 to 16."""

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from mansion_scene.placement.arrange import place_along_walls, repeated
from mansion_scene.placement.candidates import floor_poses, flush_poses, wall_poses
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
    floor: Floor, spec: Spec, unit: Unit, rng: np.random.Generator, aisle: float, *, whole: bool
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
        if _place_whole(floor, spec, unit, rows, cols, rng, aisle):
            return rows, cols
    return None


def _place_whole(
    floor: Floor, spec: Spec, unit: Unit, rows: int, cols: int, rng: np.random.Generator, aisle: float
) -> bool:
    """Place a matrix of one size at the most comfortable spacing that fits."""
    shapes = [(rows, cols)] if rows == cols else [(rows, cols), (cols, rows)]
    spacings = _spacings(floor, spec, unit, rows * cols, aisle)
    for tried, gaps in enumerate(spacings):
        if tried == 2:
            # What does not fit at the narrowest spacings fits at no wider one.
            shapes = [
                shape
                for shape in shapes
                if any(len(_macro_poses(floor, spec, unit, shape, narrow, rng)[1]) for narrow in _narrowest(spacings))
            ]
        for shape in shapes:
            if _place_macro(floor, spec, unit, shape, gaps, rng):
                return True
    return False


def _narrowest(spacings: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return the spacings that no other undercuts in both directions."""
    return [(x, y) for x, y in spacings if not any((a <= x and b <= y) and (a, b) != (x, y) for a, b in spacings)]


def _spacings(floor: Floor, spec: Spec, unit: Unit, copies: int, aisle: float) -> list[tuple[float, float]]:
    """Return gaps between columns and between rows, the most comfortable first.

    Shelves and the seats of an audience stand shoulder to shoulder with aisles between the rows; desks may have
    either way through.
    """
    lane = floor.passage
    if len(unit.parts) == 1 and not spec.role.table:
        beside = floor.gap
        return [
            *((beside, 1.25 * aisle), (beside, aisle), (beside, 0.75), (beside, 0.6), (beside, lane)),
            *((aisle, aisle), (0.6, 0.6), (lane, lane), (lane, beside)),
        ]
    spacings = [
        *((aisle, aisle), (0.8, aisle), (aisle, 0.6), (0.75, 0.75), (0.75, 0.45), (0.6, 0.6)),
        *((0.6, 0.3), (0.3, 0.6), (lane, 0.3), (0.3, lane), (lane, 0.12), (0.05, 0.6), (0.12, lane)),
        *((0.05, lane), (lane, 0.03), (0.02, lane)),
    ]
    if copies <= 4:
        spacings.append((0.1, 0.1))
    return [(x, y) for x, y in spacings if max(x, y) <= aisle + 1e-9]


def _macro_poses(
    floor: Floor, spec: Spec, unit: Unit, shape: tuple[int, int], gaps: tuple[float, float], rng: np.random.Generator
) -> tuple[Unit, Floats]:
    """Return the macro object of a matrix (BUILDMACROOBJECT) and poses at which it is in bounds and free."""
    x0, x1, y0, y1 = unit.extent()
    px, py = x1 - x0 + gaps[0], y1 - y0 + gaps[1]
    width, depth = shape[1] * px - gaps[0], shape[0] * py - gaps[1]
    span = floor.room.bounds[2:] - floor.room.bounds[:2]
    if width * depth > floor.room.area or max(width, depth) > float(np.hypot(*span)):
        return unit, np.zeros((0, 4))
    offsets = np.array([(c * px, r * py) for r in range(shape[0]) for c in range(shape[1])])
    centre = offsets.mean(axis=0)
    if spec.where == "edge":
        macro = repeated(unit, offsets - [centre[0], 0.0])
        # Only the first row of a block of three and more can be at the wall.
        row = len(unit.parts) * shape[1]
        macro.parts[row:] = [(*part[:7], 0.0) for part in macro.parts[row:]]
        poses = wall_poses(floor, macro.extent(), unit.sizes[0][1] / 2, rng)
    else:
        macro = repeated(unit, offsets - centre)
        flush = flush_poses(floor, macro.extent(), (floor.gap, floor.passage, floor.room.aisle))
        poses = np.concatenate([flush, floor_poses(floor, rng, limit=1000)])
    poses = _facing(floor, spec, unit, poses)
    if not len(poses):
        return macro, poses
    return macro, poses[floor.fits(poses, macro.array())]


def _place_macro(
    floor: Floor, spec: Spec, unit: Unit, shape: tuple[int, int], gaps: tuple[float, float], rng: np.random.Generator
) -> bool:
    macro, poses = _macro_poses(floor, spec, unit, shape, gaps, rng)
    if not len(poses):
        return False
    if len(poses) > 80:
        poses = poses[np.sort(rng.choice(len(poses), 80, replace=False))]
    scores = pose_scores(floor, spec, macro, poses, rng, at_wall=spec.where == "edge")
    scores += _before_the_board(floor, spec, unit, poses)
    return examine(floor, macro, poses, scores, most=5) is not None


def _facing(floor: Floor, spec: Spec, unit: Unit, poses: Floats) -> Floats:
    """Keep poses at which those who sit look at the board, where there is one."""
    focus = focus_direction(floor)
    seated = [floor.specs[s].role.seat for s in unit.specs]
    if focus is None or not any(seated):
        return poses
    wanted = -focus if seated[0] else focus
    ahead = -poses[:, 3] * wanted[0] + poses[:, 2] * wanted[1]
    return np.asarray(poses[ahead > 0.9])


def _before_the_board(floor: Floor, spec: Spec, unit: Unit, poses: Floats) -> Floats:
    """Rows that look at a board stand centred before it."""
    for copy in floor.placed:
        if floor.specs[copy.spec].role.focal and any(floor.specs[s].role.seat for s in unit.specs):
            aside = (poses[:, :2] - np.array(copy.box[:2])) @ np.array(copy.box[2:4])
            return np.asarray(-0.3 * np.minimum(np.abs(aside), 4.0))
    return np.zeros(len(poses))
