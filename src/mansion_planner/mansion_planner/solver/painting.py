"""Painting cells: a cell changes its label, and every running statistic follows."""

from mansion_planner.solver.jit import kernel
from mansion_planner.solver.state import (
    AREA,
    CORNERS,
    COUNT,
    CX,
    CY,
    HB,
    HS,
    MX,
    MY,
    NEAR,
    PERIMETER,
    SIZE,
    VB,
    VS,
    Cells,
    Floats,
    Ints,
    State,
)

__all__ = ["paint", "recount", "repaint"]


@kernel
def _corners_at(stats: Floats, a: int, b: int, c: int, d: int, sign: float) -> None:
    """Add (or take away) what a vertex between cells a, b (below, left to right) and c, d (above) gives to corners.

    A label at one or three of the cells has a corner there, one at two cells across has two.
    """
    if (a == b and c == d) or (a == c and b == d):
        return
    if a == d:
        if b == a:
            stats[a, CORNERS] += sign
            stats[c, CORNERS] += sign
        elif c == a:
            stats[a, CORNERS] += sign
            stats[b, CORNERS] += sign
        else:
            stats[a, CORNERS] += 2.0 * sign
            stats[b, CORNERS] += sign
            stats[c, CORNERS] += sign
    elif b == c:
        if a == b:
            stats[b, CORNERS] += sign
            stats[d, CORNERS] += sign
        elif d == b:
            stats[b, CORNERS] += sign
            stats[a, CORNERS] += sign
        else:
            stats[b, CORNERS] += 2.0 * sign
            stats[a, CORNERS] += sign
            stats[d, CORNERS] += sign
    else:
        if a != b and a != c:
            stats[a, CORNERS] += sign
        if b != a and b != d:
            stats[b, CORNERS] += sign
        if c != a and c != d:
            stats[c, CORNERS] += sign
        if d != b and d != c:
            stats[d, CORNERS] += sign


@kernel
def _border(contact: Floats, straddle: Floats, old: int, new: int, other: int, length: float, wall: float) -> float:
    """Move one border of a cell from label `old` to `new`; return what both perimeters gain by their common wall."""
    if other == old:
        contact[old, new] += length
        contact[new, old] += length
        straddle[0] -= wall
        return length
    if other == new:
        contact[old, new] -= length
        contact[new, old] -= length
        straddle[0] += wall
        return -length
    contact[old, other] -= length
    contact[other, old] -= length
    contact[new, other] += length
    contact[other, new] += length
    return 0.0


@kernel
def paint(
    geometry: Floats,
    near: Ints,
    labels: Ints,
    stats: Floats,
    contact: Floats,
    straddle: Floats,
    j: int,
    i: int,
    new: int,
) -> None:
    """Give cell (j, i) the label `new`, which it has not, and update every statistic."""
    old = labels[j, i]
    n, s, e, w = labels[j + 1, i], labels[j - 1, i], labels[j, i + 1], labels[j, i - 1]
    ne, nw = labels[j + 1, i + 1], labels[j + 1, i - 1]
    se, sw = labels[j - 1, i + 1], labels[j - 1, i - 1]
    _corners_at(stats, old, e, n, ne, -1.0)
    _corners_at(stats, w, old, nw, n, -1.0)
    _corners_at(stats, s, se, old, e, -1.0)
    _corners_at(stats, sw, s, w, old, -1.0)
    _corners_at(stats, new, e, n, ne, 1.0)
    _corners_at(stats, w, new, nw, n, 1.0)
    _corners_at(stats, s, se, new, e, 1.0)
    _corners_at(stats, sw, s, w, new, 1.0)
    labels[j, i] = new
    a = geometry[j, i, AREA]
    x, y = a * geometry[j, i, CX], a * geometry[j, i, CY]
    east, west = geometry[j, i, VB], geometry[j, i - 1, VB]
    north, south = geometry[j, i, HB], geometry[j - 1, i, HB]
    both = _border(contact, straddle, old, new, e, east, geometry[j, i, VS])
    both += _border(contact, straddle, old, new, w, west, geometry[j, i - 1, VS])
    both += _border(contact, straddle, old, new, n, north, geometry[j, i, HS])
    both += _border(contact, straddle, old, new, s, south, geometry[j - 1, i, HS])
    stats[old, COUNT] -= 1.0
    stats[old, SIZE] -= a
    stats[old, MX] -= x
    stats[old, MY] -= y
    stats[new, COUNT] += 1.0
    stats[new, SIZE] += a
    stats[new, MX] += x
    stats[new, MY] += y
    apart = 0.0
    apart += east if e != old and e != new else 0.0
    apart += west if w != old and w != new else 0.0
    apart += north if n != old and n != new else 0.0
    apart += south if s != old and s != new else 0.0
    stats[old, PERIMETER] += both - apart
    stats[new, PERIMETER] += both + apart
    length = geometry[j, i, NEAR]
    if length > 0.0:
        k = near[j, i]
        contact[old, k] -= length
        contact[k, old] -= length
        contact[new, k] += length
        contact[k, new] += length


@kernel
def repaint(
    geometry: Floats,
    near: Ints,
    labels: Ints,
    stats: Floats,
    contact: Floats,
    straddle: Floats,
    changes: Ints,
    made: int,
    j: int,
    i: int,
    new: int,
) -> int:
    """Paint a cell, record its row, column and old label, and return the new number of records."""
    changes[made, 0] = j
    changes[made, 1] = i
    changes[made, 2] = labels[j, i]
    paint(geometry, near, labels, stats, contact, straddle, j, i, new)
    return made + 1


@kernel
def _meet(stats: Floats, contact: Floats, x: int, y: int, length: float) -> None:
    """Count a border between labels `x` and `y`."""
    contact[x, y] += length
    contact[y, x] += length
    stats[x, PERIMETER] += length
    stats[y, PERIMETER] += length


@kernel
def recount(cells: Cells, state: State) -> None:
    """Compute every running statistic of `state` from its labels."""
    labels, stats, contact, straddle = state.labels, state.stats, state.contact, state.straddle
    geometry, near = cells.geometry, cells.near
    rows, columns = labels.shape
    stats[:, :] = 0.0
    contact[:, :] = 0.0
    straddle[0] = 0.0
    for j in range(rows):
        for i in range(columns):
            x = labels[j, i]
            a = geometry[j, i, AREA]
            stats[x, COUNT] += 1.0
            stats[x, SIZE] += a
            stats[x, MX] += a * geometry[j, i, CX]
            stats[x, MY] += a * geometry[j, i, CY]
            if j + 1 < rows and i + 1 < columns:
                _corners_at(stats, x, labels[j, i + 1], labels[j + 1, i], labels[j + 1, i + 1], 1.0)
            if i + 1 < columns and labels[j, i + 1] != x:
                _meet(stats, contact, x, labels[j, i + 1], geometry[j, i, VB])
            elif i + 1 < columns:
                straddle[0] += geometry[j, i, VS]
            if j + 1 < rows and labels[j + 1, i] != x:
                _meet(stats, contact, x, labels[j + 1, i], geometry[j, i, HB])
            elif j + 1 < rows:
                straddle[0] += geometry[j, i, HS]
            length = geometry[j, i, NEAR]
            if length > 0.0:
                contact[x, near[j, i]] += length
                contact[near[j, i], x] += length
