"""Free space of a disc robot on a grid: inflation of walls and boxes, 4-connected regions, reachability.

Cells are squares of `cell` metres whose lattice starts at the lower left corner of the room's bounds; a cell is free
when its centre lies in the room and at least the robot's radius away from walls and boxes. A door opening is no wall.
Arrays are indexed ``[row (y), column (x)]``.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mansion_geometry.compiled import Bools, Counts, Floats, Labels, kernel
from mansion_geometry.floor_grid import check_cells
from mansion_geometry.free_cells import (
    SLACK,
    cell_window,
    connected_components,
    flood_fill,
    near_segment,
    stamp,
    wall_counts,
)

__all__ = ["FreeGrid", "connected_components", "flood_fill"]


_LOOK_AROUND = 0.6
"""How far beyond a new box's inflation its surroundings are looked at, metres."""


@kernel
def _window(
    boxes: Floats, margin: float, x0: float, y0: float, cell: float, rows: int, cols: int
) -> tuple[int, int, int, int]:
    """Return the rows and columns [r0, r1) x [c0, c1) around all boxes."""
    r0, r1, c0, c1 = rows, 0, cols, 0
    for k in range(boxes.shape[0]):
        a, b, c, d = cell_window(boxes[k], margin, x0, y0, cell, rows, cols)
        r0, r1, c0, c1 = min(r0, a), max(r1, b), min(c0, c), max(c1, d)
    return r0, r1, c0, c1


@kernel
def _shrink(counts: Counts, reached: Bools, r0: int, r1: int, c0: int, c1: int) -> tuple[bool, int]:
    """Drop blocked cells of a window from `reached` if the others are connected in it; return whether, and how many.

    Where they are, blocking cells inside the window cut nothing off: a path through them can go round inside it.
    """
    rows, cols = r1 - r0, c1 - c0
    seen = np.zeros((rows, cols), dtype=np.bool_)
    stack = np.empty(rows * cols, dtype=np.int32)
    total, before = 0, 0
    start = -1
    for r in range(rows):
        for c in range(cols):
            if reached[r0 + r, c0 + c]:
                before += 1
                if counts[r0 + r, c0 + c] == 0:
                    total += 1
                    start = r * cols + c
    if total == 0:
        return False, 0
    seen[start // cols, start % cols] = True
    stack[0] = start
    top, found = 1, 0
    while top > 0:
        top -= 1
        found += 1
        r, c = stack[top] // cols, stack[top] % cols
        for dr, dc in ((-1, 0), (1, 0), (0, -1), (0, 1)):
            rr, cc = r + dr, c + dc
            if rr < 0 or rr >= rows or cc < 0 or cc >= cols or seen[rr, cc]:
                continue
            if reached[r0 + rr, c0 + cc] and counts[r0 + rr, c0 + cc] == 0:
                seen[rr, cc] = True
                stack[top] = rr * cols + cc
                top += 1
    if found != total:
        return False, 0
    for r in range(r0, r1):
        for c in range(c0, c1):
            if counts[r, c] != 0:
                reached[r, c] = False
    return True, before - total


@kernel
def _approachable(reached: Bools, x0: float, y0: float, cell: float, box: Floats, reach: float, front: bool) -> bool:
    """Tell whether a reached cell lies at most `reach` from a box (`front`: before its front edge)."""
    rows, cols = reached.shape
    r0, r1, c0, c1 = cell_window(box, reach, x0, y0, cell, rows, cols)
    limit = (reach + SLACK) ** 2
    for r in range(r0, r1):
        qy = y0 + (r + 0.5) * cell - box[1]
        for c in range(c0, c1):
            if not reached[r, c]:
                continue
            qx = x0 + (c + 0.5) * cell - box[0]
            along, ahead = qx * box[2] + qy * box[3], -qx * box[3] + qy * box[2]
            if front and (ahead < box[5] or abs(along) > box[4] + 0.1):
                continue
            dx, dy = max(abs(along) - box[4], 0.0), max(abs(ahead) - box[5], 0.0)
            if dx * dx + dy * dy <= limit:
                return True
    return False


@kernel
def _first_unreachable(
    reached: Bools,
    x0: float,
    y0: float,
    cell: float,
    boxes: Floats,
    reach: float,
    front: Bools,
    partner: Labels,
    window: tuple[int, int, int, int],
) -> int:
    """Return the first box that cannot be approached, -1 if all can.

    A box with `front` set needs a cell before its front, or one beside its `partner` (index, -1: none) that
    stands there. Boxes out of reach of the `window` of cells [r0, r1) x [c0, c1) are passed over.
    """
    rows, cols = reached.shape
    r0, r1, c0, c1 = window
    for k in range(boxes.shape[0]):
        beyond = reach
        if partner[k] >= 0:
            other = boxes[partner[k]]
            beyond += math.hypot(other[0] - boxes[k, 0], other[1] - boxes[k, 1])
            beyond += math.hypot(other[4], other[5])
        a, b, c, d = cell_window(boxes[k], beyond, x0, y0, cell, rows, cols)
        if a >= r1 or b <= r0 or c >= c1 or d <= c0:
            continue
        if not _approachable(reached, x0, y0, cell, boxes[k], reach, False):
            return k
        if front[k] and not _approachable(reached, x0, y0, cell, boxes[k], reach, True):
            p = partner[k]
            if p < 0 or not _approachable(reached, x0, y0, cell, boxes[p], reach, False):
                return k
    return -1


@dataclass(frozen=True)
class _Undo:
    """What the last `add` replaced: the boxes it stamped, and the reached cells of a window as they were."""

    boxes: Floats
    cells: Bools
    window: tuple[int, int, int, int]
    reached_cells: int


class FreeGrid:
    """The free cells of one room, kept up to date as boxes come and go.

    Parameters
    ----------
    edges : (e, 4) array
        The room's boundary, interior on the left.
    walls : (w, 4) array
        The boundary without door openings.
    doors : sequence of (4,) arrays
        Door segments; free cells at most `stand` metres from one are its threshold.
    radius : float
        The robot's radius, metres.
    reach : float
        How far beyond its body the robot reaches, metres.
    cell : float
        Cell size, metres.
    """

    def __init__(
        self,
        edges: Floats,
        walls: Floats,
        doors: Sequence[Floats],
        *,
        radius: float = 0.20,
        reach: float = 0.30,
        cell: float = 0.05,
        stand: float = 0.10,
    ) -> None:
        self.cell, self.radius, self.reach = cell, radius, reach
        self.x0 = float(min(edges[:, 0].min(), edges[:, 2].min()))
        self.y0 = float(min(edges[:, 1].min(), edges[:, 3].min()))
        width = float(max(edges[:, 0].max(), edges[:, 2].max())) - self.x0
        height = float(max(edges[:, 1].max(), edges[:, 3].max())) - self.y0
        # As many cell centres as lie below the far side, at least one.
        cols = max(1, math.ceil(width / cell - 0.5 - 1e-9))
        rows = max(1, math.ceil(height / cell - 0.5 - 1e-9))
        check_cells(rows, cols)
        self.counts = wall_counts(rows, cols, self.x0, self.y0, cell, edges, walls, radius)
        self.reached = np.zeros((rows, cols), dtype=np.bool_)
        self.free_cells = int((self.counts == 0).sum())
        self.thresholds = [
            near_segment(self.counts, self.x0, self.y0, cell, np.asarray(door, float), stand) for door in doors
        ]
        self.seeds, self.required = self._entries()
        self.reached_cells = int(flood_fill(self.counts, self.seeds, self.reached))
        self._whole = (0, rows, 0, cols)
        self._changed = self._whole
        self._undo = _Undo(np.zeros((0, 6)), self.reached, self._whole, self.reached_cells)

    def _entries(self) -> tuple[Labels, list[Labels]]:
        """Return the cells that one enters by, and the thresholds that must stay connected to them."""
        labels, sizes = connected_components(self.counts)
        if not len(sizes):
            return np.zeros(0, dtype=np.int32), []
        flat = labels.ravel()
        entered = sorted({int(label) for cells in self.thresholds for label in flat[cells]})
        pool = entered or range(1, len(sizes) + 1)
        main = max(pool, key=lambda label: (int(sizes[label - 1]), -label))
        required = [cells[flat[cells] == main] for cells in self.thresholds]
        required = [cells for cells in required if len(cells)]
        if required:
            return required[0], required
        return np.flatnonzero(flat == main).astype(np.int32), []

    def copy(self) -> "FreeGrid":
        """Return an independent copy."""
        other = object.__new__(FreeGrid)
        other.__dict__.update(self.__dict__)
        other.counts = self.counts.copy()
        other.reached = self.reached.copy()
        return other

    def add(self, boxes: Floats) -> bool:
        """Stamp boxes, shape (k, 6), grown by the robot's radius; tell whether the doors stay connected.

        `undo` takes the last addition back.
        """
        self.free_cells -= self._stamp(boxes, 1)
        if len(boxes) > 3 or not self._shrink_locally(boxes):
            self._undo = _Undo(boxes, self.reached, self._whole, self.reached_cells)
            self._flood()
        return self._doors_joined()

    def undo(self) -> None:
        """Take back the last `add`."""
        last = self._undo
        if last.window == self._whole:
            self.reached = last.cells
        else:
            r0, r1, c0, c1 = last.window
            self.reached[r0:r1, c0:c1] = last.cells
        self.reached_cells = last.reached_cells
        self.free_cells -= self._stamp(last.boxes, -1)
        self._changed = self._whole

    def remove(self, boxes: Floats) -> None:
        """Take boxes away that stand."""
        self.free_cells -= self._stamp(boxes, -1)
        self._flood()

    def _stamp(self, boxes: Floats, delta: int) -> int:
        return int(stamp(self.counts, self.x0, self.y0, self.cell, boxes, self.radius, delta))

    def _flood(self) -> None:
        self.reached = np.zeros_like(self.reached)
        self.reached_cells = int(flood_fill(self.counts, self.seeds, self.reached))
        self._changed = self._whole

    def _shrink_locally(self, boxes: Floats) -> bool:
        """Drop newly blocked cells from `reached` where a look around the boxes proves that nothing is cut off."""
        rows, cols = self.counts.shape
        margin = self.radius + _LOOK_AROUND
        r0, r1, c0, c1 = _window(boxes, margin, self.x0, self.y0, self.cell, rows, cols)
        if (r1 - r0) * (c1 - c0) > rows * cols // 3:
            return False
        before = self.reached[r0:r1, c0:c1].copy()
        whole, lost = _shrink(self.counts, self.reached, r0, r1, c0, c1)
        if whole:
            self._undo = _Undo(boxes, before, (r0, r1, c0, c1), self.reached_cells)
            self._changed = (r0, r1, c0, c1)
            self.reached_cells -= lost
        return bool(whole)

    def _doors_joined(self) -> bool:
        """Tell whether every door's threshold is reached, the first one's being where one comes from."""
        flat = self.reached.ravel()
        return all(bool(flat[cells].any()) for cells in self.required)

    def first_unreachable(self, boxes: Floats, front: Bools, partner: Labels, *, changed: bool = False) -> int:
        """Return the index of the first box that cannot be approached, -1 if all can.

        Parameters
        ----------
        boxes : (m, 6) array
        front : (m,) bool array
            Whether a cell before the front is needed.
        partner : (m,) int32 array
            Index of the box (a chair at its desk) that counts for the front too, -1: none.
        changed : bool
            Look only at boxes near what the last `add` changed; the others are as approachable as before.
        """
        return int(
            _first_unreachable(
                self.reached,
                self.x0,
                self.y0,
                self.cell,
                boxes,
                self.radius + self.reach,
                front,
                partner,
                self._changed if changed else self._whole,
            )
        )
