"""The topology predicate and the energy of section C.2 for the local candidates of one cut round."""

import numpy as np

from mansion_planner.solver.cleaning import FREE, OTHER
from mansion_planner.solver.growth import grow
from mansion_planner.solver.jit import kernel
from mansion_planner.solver.state import AREA, CX, CY, HB, VB, Floats, Ints
from mansion_planner.solver.widths import border_sums, scan_runs

__all__ = ["candidate_energy", "grow_batch"]

EPSILON = 1e-9


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
def _one_piece(work: Ints, geometry: Floats, value: int) -> bool:
    """Tell whether the cells of `value` exist and are connected across borders."""
    rows, columns = work.shape
    stack = np.empty(4 * rows * columns, np.int64)
    seen = np.zeros((rows, columns), np.bool_)
    pieces = 0
    for j in range(1, rows - 1):
        for i in range(1, columns - 1):
            if work[j, i] != value or seen[j, i]:
                continue
            pieces += 1
            if pieces > 1:
                return False
            top = 0
            stack[0] = j * columns + i
            seen[j, i] = True
            while top >= 0:
                p = stack[top]
                top -= 1
                y, x = p // columns, p % columns
                for q in range(4):
                    yy, xx = y + (q == 0) - (q == 1), x + (q == 2) - (q == 3)
                    s = geometry[min(y, yy), x, HB] if q < 2 else geometry[y, min(x, xx), VB]
                    if work[yy, xx] == value and not seen[yy, xx] and s > 1e-6:
                        seen[yy, xx] = True
                        top += 1
                        stack[top] = yy * columns + xx
    return pieces == 1


@kernel
def _parent_region(layout: Ints, parent: int, work: Ints) -> None:
    """Write the local labels of an uncut parent to `work`: FREE inside its region, OTHER elsewhere."""
    rows, columns = layout.shape
    for j in range(rows):
        for i in range(columns):
            work[j, i] = FREE if layout[j, i] == parent else OTHER


@kernel
def _all_whole(work: Ints, geometry: Floats, children: int, vanishes: bool) -> bool:
    """Tell whether each child, and what the parent keeps unless it vanishes, is one piece."""
    whole = vanishes or _one_piece(work, geometry, FREE)
    for k in range(children):
        whole = whole and _one_piece(work, geometry, k)
    return whole


@kernel
def _globally_labelled(layout: Ints, work: Ints, children: Ints, trial: Ints) -> None:
    """Write the whole layout with the children's cells of `work` to `trial`."""
    rows, columns = layout.shape
    for j in range(rows):
        for i in range(columns):
            trial[j, i] = children[work[j, i]] if work[j, i] >= 0 else layout[j, i]


@kernel
def _unmet_links(links: Ints, need: Floats, run: Floats) -> int:
    """Return how many links have a straight wall shorter than they need."""
    unmet = 0
    for e in range(links.shape[0]):
        unmet += run[links[e, 0], links[e, 1]] < need[e] - EPSILON
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
    few, narrow = np.empty_like(layout), np.empty(layout.shape)
    features = np.zeros((targets.size, 4))
    run = np.zeros((side.size, side.size))
    thin = np.zeros(rooms.shape[0])
    sums = border_sums(geometry)
    fewest, lowest = -1, 1e18
    for c in range(batch.shape[0]):
        _parent_region(layout, parent, work)
        if not grow(xs, ys, geometry, work, batch[c], targets, vanishes):
            continue
        if not _all_whole(work, geometry, targets.size, vanishes):
            continue
        _globally_labelled(layout, work, children, trial)
        scan_runs(xs, ys, sums, rooms, side, trial, run, thin, few, narrow)
        unmet = _unmet_links(links, need, run)
        if fewest >= 0 and unmet > fewest:
            continue
        _features(geometry, work, batch[c], targets, features)
        energy = candidate_energy(features, weights)
        if fewest < 0 or unmet < fewest or energy < lowest:
            fewest, lowest = unmet, energy
            best_layout[:, :] = trial
    return fewest, lowest
