"""Candidate partitions of one cut round: growth from seeds, clean-up, topology predicate and energy (section C.2).

The kernels work on a local grid whose labels are k for child k, FREE for the parent's unclaimed cells and OTHER for
everything else.
"""

import numpy as np

from mansion_geometry.compiled import Floats, Ints, kernel
from mansion_planner.solver.grid import AREA, CX, CY, HB, VB
from mansion_planner.solver.partition import component, neighbour
from mansion_planner.solver.walls import border_sums, scan_walls

__all__ = ["FREE", "OTHER", "candidate_energy", "clean", "grow", "grow_batch"]


OVERSHOOT = 1.08
"""Share of its target area up to which a rectangle grows."""

ENOUGH, L_OVERSHOOT = 0.97, 1.25
"""Share of its target area from which a room needs no L-shape, and up to which an L-shape grows."""


@kernel
def _place_seeds(geometry: Floats, work: Ints, seeds: Floats, bounds: Ints, area: Floats) -> bool:
    """Give each child the free cell nearest its seed; tell whether each got one."""
    rows, columns = work.shape
    for k in range(seeds.shape[0]):
        best_j, best_i, nearest = -1, -1, 1e18
        for j in range(1, rows - 1):
            for i in range(1, columns - 1):
                if work[j, i] == FREE:
                    dx = geometry[j, i, CX] - seeds[k, 0]
                    dy = geometry[j, i, CY] - seeds[k, 1]
                    d = dx * dx + dy * dy
                    if d < nearest:
                        best_j, best_i, nearest = j, i, d
        if best_j < 0:
            return False
        work[best_j, best_i] = k
        area[k] = geometry[best_j, best_i, AREA]
        bounds[k, 0], bounds[k, 1] = best_j, best_j + 1
        bounds[k, 2], bounds[k, 3] = best_i, best_i + 1
    return True


@kernel
def _strip(bounds: Ints, k: int, side: int) -> tuple[int, int, int, int]:
    """Return the row and column range of the strip beyond side 0 to 3 (north, east, south, west)."""
    j0, j1, i0, i1 = bounds[k, 0], bounds[k, 1], bounds[k, 2], bounds[k, 3]
    if side == 0:
        return j1, j1 + 1, i0, i1
    if side == 1:
        return j0, j1, i1, i1 + 1
    if side == 2:
        return j0 - 1, j0, i0, i1
    return j0, j1, i0 - 1, i0


@kernel
def _least_filled(area: Floats, targets: Floats, done: Ints) -> int:
    """Return the child that lacks most of its target, or -1."""
    best = -1
    for k in range(targets.size):
        if done[k] == 0 and (best < 0 or area[k] * targets[best] < area[best] * targets[k]):
            best = k
    return best


@kernel
def _grow_rectangles(
    xs: Floats, ys: Floats, geometry: Floats, work: Ints, targets: Floats, bounds: Ints, area: Floats
) -> None:
    """Push out whole sides of the rectangles: the room that lacks most of its area first, and its squarest choice."""
    done = np.zeros(targets.size, np.int64)
    while True:
        k = _least_filled(area, targets, done)
        if k < 0:
            return
        best, best_cost, best_gain = -1, 1e18, 0.0
        for side in range(4):
            j0, j1, i0, i1 = _strip(bounds, k, side)
            gain, ok = 0.0, True
            for j in range(j0, j1):
                for i in range(i0, i1):
                    if work[j, i] != FREE:
                        ok = False
                    gain += geometry[j, i, AREA]
            if not ok or area[k] + gain > OVERSHOOT * targets[k]:
                continue
            high = ys[max(j1, bounds[k, 1])] - ys[min(j0, bounds[k, 0])]
            wide = xs[max(i1, bounds[k, 3])] - xs[min(i0, bounds[k, 2])]
            cost = max(high / wide, wide / high)
            if cost < best_cost:
                best, best_cost, best_gain = side, cost, gain
        if best < 0:
            done[k] = 1
            continue
        j0, j1, i0, i1 = _strip(bounds, k, best)
        work[j0:j1, i0:i1] = k
        area[k] += best_gain
        bounds[k, 0], bounds[k, 1] = min(bounds[k, 0], j0), max(bounds[k, 1], j1)
        bounds[k, 2], bounds[k, 3] = min(bounds[k, 2], i0), max(bounds[k, 3], i1)


@kernel
def _longest_run(work: Ints, xs: Floats, ys: Floats, k: int, run: Ints) -> float:
    """Find the longest straight run of free cells along child k; write line, begin, end and orientation to `run`."""
    rows, columns = work.shape
    longest = 0.0
    for side in range(4):
        along_x = side < 2
        back = 1 if side % 2 == 0 else -1
        lines = rows if along_x else columns
        steps = columns if along_x else rows
        for u in range(1, lines - 1):
            begin = -1
            for v in range(1, steps):
                if along_x:
                    ok = work[u, v] == FREE and work[u - back, v] == k
                else:
                    ok = work[v, u] == FREE and work[v, u - back] == k
                if ok and begin < 0:
                    begin = v
                if not ok and begin >= 0:
                    length = xs[v] - xs[begin] if along_x else ys[v] - ys[begin]
                    if length > longest + 1e-9:
                        longest = length
                        run[0], run[1], run[2], run[3] = u, begin, v, int(along_x)
                    begin = -1
    return longest


@kernel
def _grow_l_shapes(xs: Floats, ys: Floats, geometry: Floats, work: Ints, targets: Floats, area: Floats) -> None:
    """Let rooms that are still too small grow along their longest free side, which makes them L-shaped."""
    done = np.zeros(targets.size, np.int64)
    run = np.zeros(4, np.int64)
    while True:
        k = _least_filled(area, targets, done)
        if k < 0:
            return
        if area[k] >= ENOUGH * targets[k] or _longest_run(work, xs, ys, k, run) <= 0.0:
            done[k] = 1
            continue
        gain = 0.0
        for v in range(run[1], run[2]):
            gain += geometry[run[0], v, AREA] if run[3] == 1 else geometry[v, run[0], AREA]
        if area[k] + gain > L_OVERSHOOT * targets[k]:
            done[k] = 1
            continue
        for v in range(run[1], run[2]):
            if run[3] == 1:
                work[run[0], v] = k
            else:
                work[v, run[0]] = k
        area[k] += gain


@kernel
def grow(xs: Floats, ys: Floats, geometry: Floats, work: Ints, seeds: Floats, targets: Floats, vanishes: bool) -> bool:
    """Grow one candidate in place; False when there are fewer cells than children.

    Parameters
    ----------
    work : (rows, columns) int array
        FREE in the parent's region, OTHER elsewhere.
    seeds, targets : (children, 2), (children,) arrays
    vanishes : bool
        The parent keeps nothing: its whole region goes to the children.
    """
    children = targets.size
    bounds = np.zeros((children, 4), np.int64)
    area = np.zeros(children)
    if not _place_seeds(geometry, work, seeds, bounds, area):
        return False
    _grow_rectangles(xs, ys, geometry, work, targets, bounds, area)
    _grow_l_shapes(xs, ys, geometry, work, targets, area)
    fill(work, geometry, children, keep_largest=not vanishes)
    clean(work, geometry, children, keep_largest=not vanishes)
    return True


FREE = -1
OTHER = -2
PASSES = 20
"""Most cycles of removing spurs and filling holes (section C.2, last part)."""


@kernel
def _components(work: Ints, geometry: Floats, value: int, mark: Ints, sizes: Floats) -> int:
    """Number the connected components of `value` in `mark`, write their areas to `sizes`, return how many there are."""
    rows, columns = work.shape
    stack = np.empty(work.size, np.int64)
    mark[:, :] = -1
    found = 0
    for j in range(1, rows - 1):
        for i in range(1, columns - 1):
            if work[j, i] == value and mark[j, i] < 0:
                sizes[found] = component(geometry, work, j, i, stack, mark, found)[1]
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
                    y, x, border = neighbour(geometry, j, i, q)
                    if work[y, x] >= 0:
                        touch[work[y, x]] += border
        best = int(np.argmax(touch))
        if touch[best] > 0.0:
            for j in range(1, rows - 1):
                for i in range(1, columns - 1):
                    if mark[j, i] == c:
                        work[j, i] = best


@kernel
def _remove_spurs(work: Ints, children: int) -> int:
    """Free every spur cell (at most one neighbour of the same room) once; return how many there were."""
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
        fill(work, geometry, children, keep_largest=keep_largest)
        if total == 0:
            return


EPSILON = 1e-9
"""The epsilon of the min-max normalisation, and the tolerance of wall lengths, metres."""


@kernel
def _features(geometry: Floats, work: Ints, seeds: Floats, targets: Floats, out: Floats) -> None:
    """Write f_ratio, f_seed, f_wall and f_corner of each child to the rows of `out`.

    Cells that are OTHER lie beyond the parent's envelope.
    """
    rows, columns = work.shape
    children = targets.size
    area = np.zeros(children)
    mx = np.zeros(children)
    my = np.zeros(children)
    out[:, :] = 0.0
    for j in range(1, rows - 1):
        for i in range(1, columns - 1):
            k = work[j, i]
            if k < 0:
                continue
            a = geometry[j, i, AREA]
            area[k] += a
            mx[k] += a * geometry[j, i, CX]
            my[k] += a * geometry[j, i, CY]
            out[k, 2] += geometry[j, i, HB] * (work[j + 1, i] == OTHER)
            out[k, 2] += geometry[j - 1, i, HB] * (work[j - 1, i] == OTHER)
            out[k, 2] += geometry[j, i, VB] * (work[j, i + 1] == OTHER)
            out[k, 2] += geometry[j, i - 1, VB] * (work[j, i - 1] == OTHER)
    for j in range(rows - 1):
        for i in range(columns - 1):
            a, b, c, d = work[j, i], work[j, i + 1], work[j + 1, i], work[j + 1, i + 1]
            if a == OTHER or b == OTHER or c == OTHER or d == OTHER:
                continue
            for k in range(children):
                n = (a == k) + (b == k) + (c == k) + (d == k)
                if n == 1 or n == 3:
                    out[k, 3] += 1.0
                elif n == 2 and ((a == k and d == k) or (b == k and c == k)):
                    out[k, 3] += 2.0
    for k in range(children):
        out[k, 0] = abs(area[k] - targets[k]) / targets[k]
        if area[k] > 0.0:
            dx, dy = mx[k] / area[k] - seeds[k, 0], my[k] / area[k] - seeds[k, 1]
            out[k, 1] = (dx * dx + dy * dy) ** 0.5
        out[k, 3] = max(0.0, out[k, 3] - 4.0)


@kernel
def candidate_energy(features: Floats, weights: Floats) -> float:
    """Return ``E(L; w)`` of one candidate from the raw features of its rooms (rows).

    Only the seed distance is min-max normalised, across the candidate's rooms; the wall contact is clamped to [0, 1].

    Parameters
    ----------
    features : (children, 4) array
        f_ratio, f_seed (m), f_wall (m), f_corner.
    weights : (4,) array
        w_ratio, w_seed, w_corner, w_wall.
    """
    low, high = features[0, 1], features[0, 1]
    for k in range(features.shape[0]):
        low, high = min(low, features[k, 1]), max(high, features[k, 1])
    energy = 0.0
    for k in range(features.shape[0]):
        z = (features[k, 1] - low) / (high - low + EPSILON)
        energy += weights[0] * features[k, 0] + weights[1] * min(1.0, max(0.0, z))
        energy += weights[2] * features[k, 3] - weights[3] * min(1.0, max(0.0, features[k, 2]))
    return energy


@kernel
def _is_connected(work: Ints, geometry: Floats, value: int) -> bool:
    """Tell whether the cells of `value` exist and form one connected component."""
    rows, columns = work.shape
    stack, seen = np.empty(work.size, np.int64), np.zeros((rows, columns), np.int64)
    found = False
    for j in range(1, rows - 1):
        for i in range(1, columns - 1):
            if work[j, i] != value or seen[j, i] == 1:
                continue
            if found:
                return False
            component(geometry, work, j, i, stack, seen, 1)
            found = True
    return found


@kernel
def _parent_region(layout: Ints, parent: int, work: Ints) -> None:
    """Write the local labels of an uncut parent to `work`: FREE inside its region, OTHER elsewhere."""
    rows, columns = layout.shape
    for j in range(rows):
        for i in range(columns):
            work[j, i] = FREE if layout[j, i] == parent else OTHER


@kernel
def _all_connected(work: Ints, geometry: Floats, children: int, vanishes: bool) -> bool:
    """Tell whether each child, and what the parent keeps unless it vanishes, is one piece."""
    whole = vanishes or _is_connected(work, geometry, FREE)
    for k in range(children):
        whole = whole and _is_connected(work, geometry, k)
    return whole


@kernel
def _merge_into_layout(layout: Ints, work: Ints, children: Ints, trial: Ints) -> None:
    """Write the whole layout with the children's cells of `work` to `trial`."""
    rows, columns = layout.shape
    for j in range(rows):
        for i in range(columns):
            trial[j, i] = children[work[j, i]] if work[j, i] >= 0 else layout[j, i]


@kernel
def _count_unmet(links: Ints, need: Floats, straight: Floats) -> int:
    """Return how many links have a straight wall shorter than they need."""
    unmet = 0
    for e in range(links.shape[0]):
        unmet += straight[links[e, 0], links[e, 1]] < need[e] - EPSILON
    return unmet


@kernel
def grow_batch(
    xs: Floats,
    ys: Floats,
    geometry: Floats,
    layout: Ints,
    parent: int,
    children: Ints,
    rooms: Floats,
    links: Ints,
    need: Floats,
    side: Ints,
    batch: Floats,
    targets: Floats,
    weights: Floats,
    vanishes: bool,
    best_layout: Ints,
) -> tuple[int, float]:
    """Grow a batch of candidates and keep the best: fewest unmet links first, then the lowest energy.

    Parameters
    ----------
    layout : (rows, columns) int array
        Labels so far; `parent` is the label to split, `children` the new labels.
    links, need : (e, 3), (e,) arrays
        Edges whose two ends are in place after this round, and their wall lengths: ``Topo(., G_f)``.
    batch : (b, children, 2) array
        Seeds of each candidate.
    best_layout : (rows, columns) int array
        Receives the best candidate.

    Returns
    -------
    unmet : int
        Unmet links of the best candidate; 0 when it passes the predicate, -1 when no candidate is a partition.
    energy : float
    """
    work, trial = np.empty_like(layout), np.empty_like(layout)
    compressed, narrow = np.empty_like(layout), np.empty(layout.shape)
    features = np.zeros((targets.size, 4))
    straight = np.zeros((side.size, side.size))
    thin = np.zeros(rooms.shape[0])
    sums = border_sums(geometry)
    fewest, lowest = -1, 1e18
    for c in range(batch.shape[0]):
        _parent_region(layout, parent, work)
        if not grow(xs, ys, geometry, work, batch[c], targets, vanishes=vanishes):
            continue
        if not _all_connected(work, geometry, targets.size, vanishes=vanishes):
            continue
        _merge_into_layout(layout, work, children, trial)
        scan_walls(xs, ys, sums, rooms, side, trial, straight, thin, compressed, narrow)
        unmet = _count_unmet(links, need, straight)
        if fewest >= 0 and unmet > fewest:
            continue
        _features(geometry, work, batch[c], targets, features)
        energy = candidate_energy(features, weights)
        if fewest < 0 or unmet < fewest or energy < lowest:
            fewest, lowest = unmet, energy
            best_layout[:, :] = trial
    return fewest, lowest
