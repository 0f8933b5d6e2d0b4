"""Whether rooms are one piece after a move."""

from mansion_planner.solver.jit import kernel
from mansion_planner.solver.state import COUNT, HB, VB, Floats, Ints

__all__ = ["piece_size", "still_whole"]


@kernel
def piece_size(geometry: Floats, labels: Ints, j: int, i: int, stack: Ints, seen: Ints, stamp: int) -> int:
    """Return how many cells can be reached from (j, i) across borders within its label; mark them with `stamp`."""
    r = labels[j, i]
    columns = labels.shape[1]
    top = 0
    stack[0] = j * columns + i
    seen[j, i] = stamp
    found = 0
    while top >= 0:
        p = stack[top]
        top -= 1
        y = p // columns
        x = p - y * columns
        found += 1
        if labels[y, x + 1] == r and seen[y, x + 1] != stamp and geometry[y, x, VB] > 1e-6:
            seen[y, x + 1] = stamp
            top += 1
            stack[top] = p + 1
        if labels[y, x - 1] == r and seen[y, x - 1] != stamp and geometry[y, x - 1, VB] > 1e-6:
            seen[y, x - 1] = stamp
            top += 1
            stack[top] = p - 1
        if labels[y + 1, x] == r and seen[y + 1, x] != stamp and geometry[y, x, HB] > 1e-6:
            seen[y + 1, x] = stamp
            top += 1
            stack[top] = p + columns
        if labels[y - 1, x] == r and seen[y - 1, x] != stamp and geometry[y - 1, x, HB] > 1e-6:
            seen[y - 1, x] = stamp
            top += 1
            stack[top] = p - columns
    return found


@kernel
def still_whole(
    geometry: Floats,
    labels: Ints,
    stats: Floats,
    changes: Ints,
    made: int,
    stack: Ints,
    seen: Ints,
    stamps: Ints,
    rooms: int,
) -> bool:
    """Tell whether every room that the recorded changes touched is one piece and not empty."""
    first = stamps[0] + 1
    for k in range(made):
        y, x = changes[k, 0], changes[k, 1]
        z = changes[k, 2]
        if stats[z, COUNT] < 0.5:
            return False
        if seen[y, x] < first:
            stamps[0] += 1
            size = piece_size(geometry, labels, y, x, stack, seen, stamps[0])
            if size != int(stats[labels[y, x], COUNT] + 0.5):
                return False
        for q in range(4):
            yy = y + (q == 0) - (q == 1)
            xx = x + (q == 2) - (q == 3)
            if labels[yy, xx] == z and seen[yy, xx] < first and z < rooms:
                stamps[0] += 1
                size = piece_size(geometry, labels, yy, xx, stack, seen, stamps[0])
                if size != int(stats[z, COUNT] + 0.5):
                    return False
    return True
