"""Straight walls and narrow places of a partition, found on the few grid lines along which its labels change."""

import numpy as np

from mansion_geometry.compiled import Floats, Ints, kernel
from mansion_planner.solver.grid import AREA, HB, VB
from mansion_planner.solver.problem import MIN_WIDTH, TARGET

__all__ = ["LARGE", "border_sums", "scan_walls"]


LARGE = 6.0
"""Area, m2, from which narrow places cost the same in rooms of any size."""

PINCH = 0.1
"""Share of a room's area that a pinch counts as narrow, at least; twice this facing nothing is left."""

MOST_NOTCHES = 256
"""Notches that are looked at on one floor; further ones cost nothing."""

AREA_SUM, H_SUM, V_SUM = range(3)
"""Last index of `border_sums`: areas, borders along rows, borders along columns."""


@kernel
def border_sums(geometry: Floats) -> Floats:
    """Return running sums of a grid, from which the area of a block and the length of a wall are differences.

    Areas are summed over all cells below and left (a summed-area table, F. C. Crow (1984), Summed-area tables for
    texture mapping), borders along their lines.

    Returns
    -------
    (rows + 1, columns + 1, 3) array
    """
    rows, columns = geometry.shape[0], geometry.shape[1]
    sums = np.zeros((rows + 1, columns + 1, 3))
    for j in range(rows):
        for i in range(columns):
            sums[j + 1, i + 1, AREA_SUM] = (
                geometry[j, i, AREA] + sums[j, i + 1, AREA_SUM] + sums[j + 1, i, AREA_SUM] - sums[j, i, AREA_SUM]
            )
            sums[j, i + 1, H_SUM] = sums[j, i, H_SUM] + geometry[j, i, HB]
            sums[j + 1, i, V_SUM] = sums[j, i, V_SUM] + geometry[j, i, VB]
    return sums


@kernel
def _compress(labels: Ints, compressed: Ints, lines: Ints) -> tuple[int, int]:
    """Leave out lines along which no label changes.

    Writes the labels of the blocks of cells between the others to `compressed`, the first row and column of each block
    (and one past the last) to the two rows of `lines`, and returns how many block rows and columns there are.
    """
    rows, columns = labels.shape
    changed = np.zeros(columns, np.int64)
    block_rows, block_columns = 0, 0
    for j in range(rows):
        difference = 1 if j == 0 else 0
        if j > 0:
            for i in range(columns):
                difference |= labels[j, i] ^ labels[j - 1, i]
        if difference != 0:
            lines[0, block_rows] = j
            block_rows += 1
            for i in range(1, columns):
                changed[i] |= labels[j, i] ^ labels[j, i - 1]
    lines[0, block_rows] = rows
    changed[0] = 1
    for i in range(columns):
        if changed[i] != 0:
            lines[1, block_columns] = i
            for p in range(block_rows):
                compressed[p, block_columns] = labels[lines[0, p], i]
            block_columns += 1
    lines[1, block_columns] = columns
    return block_rows, block_columns


@kernel
def _record_wall(straight: Floats, side: Ints, a: int, b: int, facing: int, length: float) -> None:
    """Record a straight wall if it is the longest between its labels and on their door sides.

    Parameters
    ----------
    a, b : int
        Label below (or left of) the wall, and above (or right of) it.
    facing : int
        Side of `a` that the wall is on: 1 north or 2 east. For `b` it is the opposite side, 3 or 4.
    """
    if a == b or length <= straight[a, b]:
        return
    if side[a] != 0 and side[a] != facing:
        return
    if side[b] != 0 and side[b] != facing + 2:
        return
    straight[a, b] = length
    straight[b, a] = length


@kernel
def _notch(sw: int, nw: int, se: int, ne: int) -> int:
    """Return the quarter (0 NE, 1 SW, 2 NW, 3 SE) that is cut out of a label around a vertex, or -1."""
    if sw == nw:
        if sw == se:
            return 0 if ne != sw else -1
        return 3 if ne == nw else -1
    if se == ne:
        if nw == se:
            return 1
        return 2 if sw == se else -1
    return -1


@kernel
def _add_pinches(xs: Floats, ys: Floats, rooms: Floats, notches: Ints, last: Ints, thin: Floats) -> None:
    """Add to `thin` where opposite notches of a room leave too narrow a neck.

    Parameters
    ----------
    notches : (k, 3) int array
        Column line, row line, and the notch before this one of the same room and quarter (or -1).
    last : (rooms, 4) int array
        Last notch of each room and quarter, or -1.
    """
    for r in range(rooms.shape[0]):
        for quarter in range(0, 4, 2):
            p = last[r, quarter]
            while p >= 0:
                q = last[r, quarter + 1]
                while q >= 0:
                    across = xs[notches[p, 0]] - xs[notches[q, 0]]
                    if quarter == 2:
                        across = -across
                    along = ys[notches[p, 1]] - ys[notches[q, 1]]
                    neck = max(across, along) / rooms[r, MIN_WIDTH]
                    if min(across, along) > -1e-6 and neck < 1.0 - 1e-6:
                        thin[r] += min(LARGE, rooms[r, TARGET]) * (PINCH + PINCH * (1.0 - neck))
                    q = notches[q, 2]
                p = notches[p, 2]


@kernel
def _scan_stripes(
    along: Floats,
    across: Floats,
    areas: Floats,
    rooms: Floats,
    compressed: Ints,
    stripes: Ints,
    blocks: Ints,
    count: tuple[int, int],
    narrow: Floats,
    thin: Floats,
    second: bool,
) -> None:
    """Add to `thin` what rooms lack of their minimum width along each stripe of blocks.

    The first scan, along rows, marks the narrow blocks; the second, along columns, adds the area of all blocks that are
    narrow either way.

    Parameters
    ----------
    along, across : arrays
        Grid lines that the stripes cross and lie between.
    areas : (lines across, lines along) array
        Running sums of areas.
    stripes, blocks : arrays
        First grid line of each stripe and of each block in it; `count` says how many there are.
    """
    n = rooms.shape[0]
    for p in range(1, count[0]):
        a0, a1 = stripes[p], stripes[p + 1]
        deep = across[a1] - across[a0]
        begin, previous = 0, compressed[p, 0]
        for q in range(1, count[1]):
            x = compressed[p, q]
            if x == previous:
                continue
            if previous < n:
                missing = rooms[previous, MIN_WIDTH] - (along[blocks[q]] - along[blocks[begin]])
                short = missing > 1e-6
                if short:
                    thin[previous] += missing * deep
                for k in range(begin, q):
                    if not second:
                        narrow[p, k] = 1.0 if short else 0.0
                    elif short or narrow[p, k] > 0.5:
                        b0, b1 = blocks[k], blocks[k + 1]
                        thin[previous] += areas[a1, b1] - areas[a1, b0] - areas[a0, b1] + areas[a0, b0]
            begin, previous = q, x


@kernel
def _scan_columns(
    sums: Floats, side: Ints, compressed: Ints, lines: Ints, block_rows: int, block_columns: int, straight: Floats
) -> None:
    """Find the longest straight walls that straight along columns."""
    for q in range(block_columns - 1):
        a, b, begin = compressed[0, q], compressed[0, q + 1], 0
        i = lines[1, q + 1] - 1
        for p in range(1, block_rows):
            x, y = compressed[p, q], compressed[p, q + 1]
            if x == a and y == b:
                continue
            if a != b:
                length = sums[lines[0, p], i, V_SUM] - sums[lines[0, begin], i, V_SUM]
                _record_wall(straight, side, a, b, 2, length)
            a, b, begin = x, y, p


@kernel
def _scan_rows(
    sums: Floats,
    side: Ints,
    compressed: Ints,
    lines: Ints,
    block_rows: int,
    block_columns: int,
    straight: Floats,
    notches: Ints,
    last: Ints,
) -> None:
    """Find the longest straight walls that straight along rows, and the notches of rooms."""
    n = last.shape[0]
    made = 0
    for p in range(block_rows - 1):
        a, b, begin = compressed[p, 0], compressed[p + 1, 0], 0
        j = lines[0, p + 1] - 1
        for q in range(1, block_columns):
            x, y = compressed[p, q], compressed[p + 1, q]
            if x == a and y == b:
                continue
            if a != b:
                length = sums[j, lines[1, q], H_SUM] - sums[j, lines[1, begin], H_SUM]
                _record_wall(straight, side, a, b, 1, length)
            quarter = _notch(a, b, x, y)
            if quarter >= 0 and made < MOST_NOTCHES:
                r = y if quarter == 1 or quarter == 2 else a
                if r < n:
                    notches[made, 0], notches[made, 1] = lines[1, q], lines[0, p + 1]
                    notches[made, 2] = last[r, quarter]
                    last[r, quarter] = made
                    made += 1
            a, b, begin = x, y, q


@kernel
def scan_walls(
    xs: Floats,
    ys: Floats,
    sums: Floats,
    rooms: Floats,
    side: Ints,
    labels: Ints,
    straight: Floats,
    thin: Floats,
    compressed: Ints,
    narrow: Floats,
) -> None:
    """Find the longest straight wall of each pair of labels, and each room's area narrower than its minimum width.

    To that area the one that would make those places wide enough is added, so that a sliver is not cheap, and
    something for each pinch.

    Parameters
    ----------
    sums : (rows + 1, columns + 1, 3) array
        From `border_sums`.
    compressed, narrow : (rows, columns) arrays
        Scratch.
    """
    straight[:, :] = 0.0
    thin[:] = 0.0
    lines = np.empty((2, max(labels.shape[0], labels.shape[1]) + 1), np.int64)
    notches = np.empty((MOST_NOTCHES, 3), np.int64)
    last = np.full((rooms.shape[0], 4), -1, np.int64)
    block_rows, block_columns = _compress(labels, compressed, lines)
    areas, level, upright = sums[:, :, AREA_SUM], lines[0], lines[1]
    size = (block_rows, block_columns)
    _scan_stripes(xs, ys, areas, rooms, compressed, level, upright, size, narrow, thin, second=False)
    size = (block_columns, block_rows)
    _scan_stripes(ys, xs, areas.T, rooms, compressed.T, upright, level, size, narrow.T, thin, second=True)
    _scan_columns(sums, side, compressed, lines, block_rows, block_columns, straight)
    _scan_rows(sums, side, compressed, lines, block_rows, block_columns, straight, notches, last)
    _add_pinches(xs, ys, rooms, notches, last, thin)
