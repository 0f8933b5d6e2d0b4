"""Partitions that searches start from: seed boxes, rectangles fitted to seeds, floods, and carved access edges."""

import numpy as np

from mansion_geometry.compiled import Bools, Floats, Ints, kernel
from mansion_planner.solver.grid import AREA, CX, CY, HB, SAME_LINE, VB, Cells, Grid, make_grid
from mansion_planner.solver.partition import COUNT, LEAST_BORDER, Partition, State, component, neighbour
from mansion_planner.solver.problem import ACCESS, MIN_WIDTH, SEED_WEIGHT, SEED_X, SEED_Y, TARGET, FloorModel, Goal

__all__ = ["carve_open_links", "fit_rectangles", "flood", "paint_rectangles", "planned_partition"]


UNCLAIMED = -1
"""Label of a free cell that belongs to no room yet (as in `Grid.base`)."""

AREA_TOLERANCE = 0.03
"""Share by which a painted room may miss its area."""

SLIVER = 0.001
"""Share of its area that a painted room may have too much or too little without that another is painted over it."""

Box = tuple[float, float, float, float]


def planned_partition(model: FloorModel, major: tuple[Floats, Floats]) -> Partition | None:
    """Return the partition that the seed boxes paint, or ``None`` where they do not tile the region.

    Parameters
    ----------
    major : pair of arrays
        Lines of outline, holes and obstacles; the boxes' own lines join them.
    """
    boxes = _boxes(model)
    if boxes is None or model.angle != 0.0:
        return None
    grid = make_grid(
        model,
        _with_lines(major[0], [side for box in boxes for side in (box[0], box[2])]),
        _with_lines(major[1], [side for box in boxes for side in (box[1], box[3])]),
    )
    labels = _painted(model, grid, boxes)
    return Partition(grid, labels, 0.0) if labels is not None else None


def _boxes(model: FloorModel) -> list[Box] | None:
    plan = {b.room_id: b for b in model.problem.seeds.boxes} if model.problem.seeds else {}
    boxes: list[Box] = []
    for room in model.rooms:
        box = room.seed_box or plan.get(room.id)
        if box is None:
            return None
        boxes.append((min(box.x), min(box.y), max(box.x), max(box.y)))
    return boxes


def _with_lines(lines: Floats, extra: list[float]) -> Floats:
    """Join coordinates inside the outline to `lines`; those next to a line are that line."""
    inside = [value for value in extra if lines[0] < value < lines[-1]]
    own = set(lines.tolist())
    kept: list[float] = []
    for value in np.unique(np.concatenate([lines, inside])).tolist():
        if kept and value - kept[-1] <= 10 * SAME_LINE:
            if value in own:
                kept[-1] = value
            continue
        kept.append(value)
    return np.array(kept)


def _painted(model: FloorModel, grid: Grid, boxes: list[Box]) -> Ints | None:
    """Return the labels of cells when boxes are painted over each other; ``None`` where rooms do not get their areas.

    Boxes around rooms that are no rectangles overlap. Those with much floor beside their room's are painted first; a
    room that gets too little is then painted after the one that took it.
    """
    rows, columns = grid.base.shape
    x = grid.cells.geometry[:rows, :columns, CX]
    y = grid.cells.geometry[:rows, :columns, CY]
    area = grid.cells.geometry[:rows, :columns, AREA]
    free = grid.base == -1
    covers = [(x > b[0]) & (x < b[2]) & (y > b[1]) & (y < b[3]) & free for b in boxes]
    slack = [float(area[cover].sum() / model.targets[k]) for k, cover in enumerate(covers)]
    order = sorted(range(len(boxes)), key=lambda k: (-slack[k], k))
    best, least = grid.base, np.inf
    for _ in range(2 * len(boxes)):
        labels = grid.base.copy()
        for k in order:
            labels[covers[k]] = k
        found = np.array([area[free & (labels == k)].sum() for k in range(len(boxes))])
        surplus = (found - model.targets) / model.targets
        if (labels[free] >= 0).all() and np.abs(surplus).max() < least:
            best, least = labels, float(np.abs(surplus).max())
        swap = _covered_too_much(order, covers, surplus)
        if swap is None:
            break
        order.remove(swap[0])
        order.insert(order.index(swap[1]) + 1, swap[0])
    return best if least <= AREA_TOLERANCE else None


def _covered_too_much(order: list[int], covers: list[Bools], surplus: Floats) -> tuple[int, int] | None:
    """Return the room that lacks most of its area, and the one painted over it that has most too much of its own."""
    for k in sorted(order, key=lambda k: (surplus[k], k)):
        if surplus[k] >= -SLIVER:
            return None
        later = order[order.index(k) + 1 :]
        over = [j for j in later if surplus[j] > SLIVER and (covers[j] & covers[k]).any()]
        if over:
            return k, max(over, key=lambda j: (surplus[j], j))
    return None


@kernel
def _prefix(cells: Cells) -> Floats:
    """Return prefix sums of area and first moments, shape (3, rows + 1, columns + 1)."""
    rows, columns = cells.free.shape
    total = np.zeros((3, rows + 1, columns + 1))
    for j in range(rows):
        for i in range(columns):
            a = cells.geometry[j, i, AREA] if cells.free[j, i] else 0.0
            for q in range(3):
                v = a
                if q == 1:
                    v = a * cells.geometry[j, i, CX]
                elif q == 2:
                    v = a * cells.geometry[j, i, CY]
                total[q, j + 1, i + 1] = v + total[q, j, i + 1] + total[q, j + 1, i] - total[q, j, i]
    return total


@kernel
def _within(total: Floats, q: int, j0: int, j1: int, i0: int, i1: int) -> float:
    return float(total[q, j1, i1] - total[q, j0, i1] - total[q, j1, i0] + total[q, j0, i0])


@kernel
def _misfit(total: Floats, room: Floats, j0: int, j1: int, i0: int, i1: int, height: float, span: float) -> float:
    """Return the cost of a rectangle of `height` and `span` as a room's start; infinity where its area is far off."""
    t = room[TARGET]
    a = _within(total, 0, j0, j1, i0, i1)
    if a < 0.7 * t or a > 1.4 * t:
        return np.inf
    dx = _within(total, 1, j0, j1, i0, i1) / a - room[SEED_X]
    dy = _within(total, 2, j0, j1, i0, i1) / a - room[SEED_Y]
    cost = abs(a - t) / t + 2.0 * (dx * dx + dy * dy) ** 0.5 / t**0.5
    cost += 0.3 * (1.0 - a / (height * span))
    cost += 0.15 * max(0.0, (span + height) / (2.0 * (span * height) ** 0.5) - 1.1)
    if min(span, height) < room[MIN_WIDTH]:
        cost += 1.0
    return float(cost)


@kernel
def _ranges(lines: Floats, seed: float, reach: float) -> Ints:
    """Return the pairs of lines that have the seed between them, both within `reach` of it but for one cell."""
    found = np.empty((lines.size * lines.size, 2), np.int64)
    made = 0
    for k0 in range(1, lines.size - 2):
        if lines[k0] > seed or lines[k0 + 1] < seed - reach:
            continue
        for k1 in range(k0 + 1, lines.size - 1):
            if lines[k1] >= seed and lines[k1 - 1] <= seed + reach:
                found[made, 0], found[made, 1] = k0, k1
                made += 1
    return found[:made]


@kernel
def _insert(costs: Floats, boxes: Ints, made: int, cost: float) -> int:
    """Make room for `cost` in the ascending ``costs[:made]``; return the place, whose box is to be written."""
    k = made
    while k > 0 and costs[k - 1] > cost:
        costs[k] = costs[k - 1]
        boxes[k] = boxes[k - 1]
        k -= 1
    costs[k] = cost
    return k


@kernel
def _fit_room(cells: Cells, total: Floats, room: Floats, r: int, keep: int, boxes: Ints, costs: Floats) -> int:
    """Write the rectangles that fit room `r` best, best first, to `boxes` and `costs`; return how many."""
    xs, ys, t = cells.xs, cells.ys, room[TARGET]
    reach = 1.6 * t**0.5
    across, along = _ranges(xs, room[SEED_X], reach), _ranges(ys, room[SEED_Y], reach)
    made = 0
    for p in range(along.shape[0]):
        j0, j1 = along[p, 0], along[p, 1]
        height = ys[j1] - ys[j0]
        for q in range(across.shape[0]):
            i0, i1 = across[q, 0], across[q, 1]
            span = xs[i1] - xs[i0]
            if height * span < 0.7 * t or height * span > 2.0 * t:
                continue
            cost = _misfit(total, room, j0, j1, i0, i1, height, span)
            if cost == np.inf or (made == keep and cost >= costs[made - 1]):
                continue
            made = min(made, keep - 1)
            k = _insert(costs, boxes, made, cost)
            boxes[k, 0] = r
            boxes[k, 1], boxes[k, 2], boxes[k, 3], boxes[k, 4] = j0, j1, i0, i1
            made += 1
    return made


@kernel
def fit_rectangles(cells: Cells, goal: Goal, keep: int) -> tuple[Ints, Floats]:
    """List, for each room with a seed, the grid rectangles that fit its area and centroid best.

    A rectangle stands for its part inside the free region.

    Returns
    -------
    boxes : (k, 5) int array
        Room, first row, last row + 1, first column, last column + 1; best first for each room.
    costs : (k,) array
    """
    total = _prefix(cells)
    n = goal.rooms.shape[0]
    boxes, costs = np.empty((n * keep, 5), np.int64), np.empty(n * keep)
    made = 0
    for r in range(n):
        if goal.rooms[r, SEED_WEIGHT] > 0.0:
            made += _fit_room(cells, total, goal.rooms[r], r, keep, boxes[made:], costs[made:])
    return boxes[:made], costs[:made]


@kernel
def paint_rectangles(base: Ints, cells: Cells, boxes: Ints, costs: Floats) -> Ints:
    """Return `base` with the unclaimed cells of each room's best rectangle given to it, well-fitting rooms first."""
    labels = base.copy()
    done = np.zeros(boxes.shape[0], np.bool_)
    while True:
        best = -1
        for k in range(boxes.shape[0]):
            first = k == 0 or boxes[k - 1, 0] != boxes[k, 0]
            if first and not done[k] and (best < 0 or costs[k] < costs[best]):
                best = k
        if best < 0:
            return labels
        done[best] = True
        for j in range(boxes[best, 1], boxes[best, 2]):
            for i in range(boxes[best, 3], boxes[best, 4]):
                if cells.free[j, i] and labels[j, i] == UNCLAIMED:
                    labels[j, i] = boxes[best, 0]


@kernel
def _keep_largest_component(labels: Ints, cells: Cells, r: int) -> bool:
    """Unclaim all of room r's connected components but the largest; tell whether the room has a cell."""
    rows, columns = labels.shape
    seen, stack = np.zeros((rows, columns), np.int64), np.empty(labels.size, np.int64)
    largest, largest_area, count = 0, -1.0, 0
    for j in range(1, rows - 1):
        for i in range(1, columns - 1):
            if labels[j, i] != r or seen[j, i] > 0:
                continue
            count += 1
            area = component(cells.geometry, labels, j, i, stack, seen, count)[1]
            if area > largest_area:
                largest, largest_area = count, area
    for j in range(1, rows - 1):
        for i in range(1, columns - 1):
            if labels[j, i] == r and seen[j, i] != largest:
                labels[j, i] = UNCLAIMED
    return count > 0


@kernel
def _claim_nearest(labels: Ints, cells: Cells, r: int, sx: float, sy: float) -> bool:
    """Give room `r` the unclaimed cell nearest its seed (sx, sy); tell whether there is one."""
    rows, columns = labels.shape
    best, nearest = -1, 1e18
    for j in range(1, rows - 1):
        for i in range(1, columns - 1):
            if labels[j, i] == UNCLAIMED:
                d = (cells.geometry[j, i, CX] - sx) ** 2 + (cells.geometry[j, i, CY] - sy) ** 2
                if d < nearest:
                    best, nearest = j * columns + i, d
    if best >= 0:
        labels[best // columns, best % columns] = r
    return best >= 0


def flood(labels: Ints, cells: Cells, goal: Goal, seeds: Floats) -> Ints | None:
    """Fill all unclaimed cells (-1): the room that lacks most of its area takes the nearest cell at its edge.

    Rooms without a cell start at the unclaimed cell nearest their seed; of a room in pieces only the largest stays.

    Parameters
    ----------
    labels : (rows, columns) int array
    seeds : (rooms, 2) array
        A point for each room, metres.

    Returns
    -------
    (rows, columns) int array or None
        New labels; None where a room gets no cell or a free cell no room.
    """
    filled = labels.copy()
    return filled if _flood(filled, cells, goal, seeds) else None


@kernel
def _take_stock(labels: Ints, cells: Cells, areas: Floats) -> int:
    """Add the cells of each room to `areas`; return how many free cells no room has claimed."""
    rows, columns = labels.shape
    unclaimed = 0
    for j in range(1, rows - 1):
        for i in range(1, columns - 1):
            if labels[j, i] == UNCLAIMED:
                unclaimed += 1
            elif labels[j, i] < areas.size:
                areas[labels[j, i]] += cells.geometry[j, i, AREA]
    return unclaimed


@kernel
def _most_lacking(areas: Floats, targets: Floats, closed: Bools) -> int:
    """Return the room that has the smallest part of its target, of those that are not `closed`, or -1."""
    r = -1
    for k in range(areas.size):
        if not closed[k] and (r < 0 or areas[k] / targets[k] < areas[r] / targets[r]):
            r = k
    return r


@kernel
def _nearest_at_edge(labels: Ints, cells: Cells, r: int, sx: float, sy: float) -> int:
    """Return the unclaimed cell at the edge of room `r` that is nearest its seed (sx, sy), as an index, or -1."""
    rows, columns = labels.shape
    best, nearest = -1, 1e18
    for j in range(1, rows - 1):
        for i in range(1, columns - 1):
            if labels[j, i] != UNCLAIMED:
                continue
            touch = 0
            touch += labels[j, i + 1] == r and cells.geometry[j, i, VB] > LEAST_BORDER
            touch += labels[j, i - 1] == r and cells.geometry[j, i - 1, VB] > LEAST_BORDER
            touch += labels[j + 1, i] == r and cells.geometry[j, i, HB] > LEAST_BORDER
            touch += labels[j - 1, i] == r and cells.geometry[j - 1, i, HB] > LEAST_BORDER
            if touch == 0:
                continue
            dx, dy = abs(cells.geometry[j, i, CX] - sx), abs(cells.geometry[j, i, CY] - sy)
            # A measure of distance between the maximum norm and the Euclidean one grows rooms that are nearly squares;
            # a cell with the room on several sides counts as nearer, so that notches fill first.
            d = max(dx, dy) + 0.3 * min(dx, dy) - 0.5 * touch
            if d < nearest:
                best, nearest = j * columns + i, d
    return best


@kernel
def _flood(labels: Ints, cells: Cells, goal: Goal, seeds: Floats) -> bool:
    """Fill `labels` in place; tell whether every room has a cell and every free cell a room."""
    columns, n = labels.shape[1], goal.rooms.shape[0]
    for r in range(n):
        if not _keep_largest_component(labels, cells, r) and not _claim_nearest(
            labels, cells, r, seeds[r, 0], seeds[r, 1]
        ):
            return False
    areas, closed = np.zeros(n), np.zeros(n, np.bool_)
    unclaimed = _take_stock(labels, cells, areas)
    while unclaimed > 0:
        r = _most_lacking(areas, goal.rooms[:, TARGET], closed)
        if r < 0:
            return False
        best = _nearest_at_edge(labels, cells, r, seeds[r, 0], seeds[r, 1])
        if best < 0:
            closed[r] = True
            continue
        labels[best // columns, best % columns] = r
        areas[r] += cells.geometry[best // columns, best % columns, AREA]
        unclaimed -= 1
    return True


@kernel
def _cheapest_paths(cells: Cells, labels: Ints, a: int) -> tuple[Floats, Ints]:
    """Return the area, m2, that the cheapest path from room `a` takes to each cell, and the path's cell before it.

    Relaxes all cells until nothing changes (R. Bellman (1958), On a routing problem); the grid is small and few links
    are carved, so that a heap would not pay.
    """
    rows, columns = labels.shape
    far = np.where(labels == a, 0.0, np.inf)
    before = np.full((rows, columns), -1, np.int64)
    changed = True
    while changed:
        changed = False
        for j in range(1, rows - 1):
            for i in range(1, columns - 1):
                if not cells.free[j, i] or labels[j, i] == a:
                    continue
                for q in range(4):
                    y, x, border = neighbour(cells.geometry, j, i, q)
                    step = far[y, x] + cells.geometry[j, i, AREA]
                    if border > LEAST_BORDER and step < far[j, i] - 1e-9:
                        far[j, i] = step
                        before[j, i] = y * columns + x
                        changed = True
    return far, before


@kernel
def _carve(cells: Cells, labels: Ints, a: int, b: int) -> bool:
    """Give room `a` the cheapest path to the border of `b`, three cells wide; tell whether there is one."""
    rows, columns = labels.shape
    far, before = _cheapest_paths(cells, labels, a)
    best, least = -1, np.inf
    for j in range(1, rows - 1):
        for i in range(1, columns - 1):
            if labels[j, i] == b or far[j, i] >= least:
                continue
            if labels[j, i + 1] == b or labels[j, i - 1] == b or labels[j + 1, i] == b or labels[j - 1, i] == b:
                best, least = j * columns + i, far[j, i]
    if best < 0:
        return False
    while best >= 0:
        j, i = best // columns, best % columns
        for y in range(j - 1, j + 2):
            for x in range(i - 1, i + 2):
                if cells.free[y, x] and labels[y, x] != b:
                    labels[y, x] = a
        best = before[j, i]
    return True


@kernel
def carve_open_links(cells: Cells, goal: Goal, state: State) -> Ints:
    """Return labels in which the access links that `state` leaves open are carved where there is a path.

    The room with more cells reaches for the other one. Rooms may be left disconnected or without a cell, which `flood`
    repairs.
    """
    labels = state.labels.copy()
    rooms = goal.rooms.shape[0]
    for e in range(goal.links.shape[0]):
        a, b = goal.links[e, 0], goal.links[e, 1]
        if goal.links[e, 2] != ACCESS or state.straight[a, b] >= goal.need[e]:
            continue
        if a >= rooms or (b < rooms and state.stats[b, COUNT] > state.stats[a, COUNT]):
            a, b = b, a
        if a < rooms:
            _carve(cells, labels, a, b)
    return labels
