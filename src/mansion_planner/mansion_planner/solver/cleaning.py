"""Clean-up of one local candidate: spurs go, holes are filled (section C.2, last part).

Labels of the local grid: k for child k, FREE for the parent's unclaimed cells, OTHER for everything else.
"""

import numpy as np

from mansion_planner.solver.jit import kernel
from mansion_planner.solver.state import AREA, HB, VB, Floats, Ints

__all__ = ["FREE", "OTHER", "clean", "fill"]

FREE = -1
OTHER = -2
PASSES = 20


@kernel
def _components(work: Ints, geometry: Floats, value: int, mark: Ints, sizes: Floats) -> int:
    """Number the connected components of `value`; return how many there are (at most ``sizes.size``)."""
    rows, columns = work.shape
    stack = np.empty(4 * rows * columns, np.int64)
    mark[:, :] = -1
    found = 0
    for j in range(1, rows - 1):
        for i in range(1, columns - 1):
            if work[j, i] != value or mark[j, i] >= 0 or found >= sizes.size:
                continue
            top = 0
            stack[0] = j * columns + i
            mark[j, i] = found
            sizes[found] = 0.0
            while top >= 0:
                p = stack[top]
                top -= 1
                y, x = p // columns, p % columns
                sizes[found] += geometry[y, x, AREA]
                for q in range(4):
                    yy, xx = y + (q == 0) - (q == 1), x + (q == 2) - (q == 3)
                    s = geometry[min(y, yy), x, HB] if q < 2 else geometry[y, min(x, xx), VB]
                    if work[yy, xx] == value and mark[yy, xx] < 0 and s > 1e-6:
                        mark[yy, xx] = found
                        top += 1
                        stack[top] = yy * columns + xx
            found += 1
    return found


@kernel
def fill(work: Ints, geometry: Floats, children: int, keep_largest: bool) -> None:
    """Give each free component to the child with the longest boundary with it; the largest may stay the parent's."""
    rows, columns = work.shape
    mark = np.empty((rows, columns), np.int64)
    sizes = np.zeros(rows * columns)
    touch = np.zeros(children)
    found = _components(work, geometry, FREE, mark, sizes)
    largest = -1
    if keep_largest:
        for c in range(found):
            if largest < 0 or sizes[c] > sizes[largest]:
                largest = c
    for c in range(found):
        if c == largest:
            continue
        touch[:] = 0.0
        for j in range(1, rows - 1):
            for i in range(1, columns - 1):
                if mark[j, i] != c:
                    continue
                for q in range(4):
                    yy, xx = j + (q == 0) - (q == 1), i + (q == 2) - (q == 3)
                    s = geometry[min(j, yy), i, HB] if q < 2 else geometry[j, min(i, xx), VB]
                    if work[yy, xx] >= 0:
                        touch[work[yy, xx]] += s
        best = int(np.argmax(touch))
        if touch[best] > 0.0:
            for j in range(1, rows - 1):
                for i in range(1, columns - 1):
                    if mark[j, i] == c:
                        work[j, i] = best


@kernel
def _remove_spurs(work: Ints, children: int) -> int:
    """Free every spur cell once: at most one neighbour of the same room; return how many there were."""
    rows, columns = work.shape
    count = np.zeros(children, np.int64)
    spurs = np.empty((rows * columns, 2), np.int64)
    found = 0
    for j in range(1, rows - 1):
        for i in range(1, columns - 1):
            k = work[j, i]
            if k < 0:
                continue
            count[k] += 1
            same = (work[j, i + 1] == k) + (work[j, i - 1] == k)
            same += (work[j + 1, i] == k) + (work[j - 1, i] == k)
            if same <= 1:
                spurs[found, 0], spurs[found, 1] = j, i
                found += 1
    removed = 0
    for s in range(found):
        k = work[spurs[s, 0], spurs[s, 1]]
        if count[k] > 4:
            work[spurs[s, 0], spurs[s, 1]] = FREE
            count[k] -= 1
            removed += 1
    return removed


@kernel
def clean(work: Ints, geometry: Floats, children: int, keep_largest: bool) -> None:
    """Remove spurs until none is left and fill the holes, up to 20 times (section C.2, last part).

    Rooms of up to four cells keep their spurs. With `keep_largest` the largest free component stays the parent's.
    """
    for _ in range(PASSES):
        total = 0
        for _inner in range(work.size):
            removed = _remove_spurs(work, children)
            total += removed
            if removed == 0:
                break
        fill(work, geometry, children, keep_largest)
        if total == 0:
            return
