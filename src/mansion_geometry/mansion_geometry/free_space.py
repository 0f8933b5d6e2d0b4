"""Free space of a disc robot on a grid: inflation of walls and boxes, 4-connected regions, reachability.

Cells are squares of `cell` metres whose lattice starts at the lower left corner of the room's bounds; a cell is free
when its centre lies in the room and at least the robot's radius away from walls and boxes. A door opening is no wall.
Arrays are indexed ``[row (y), column (x)]``.
"""

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from mansion_geometry.compiled import kernel
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

Floats = npt.NDArray[np.float64]
Counts = npt.NDArray[np.int16]
Labels = npt.NDArray[np.int32]
Bools = npt.NDArray[np.bool_]

_LOOK_AROUND = 0.6
"""How far beyond a new box's inflation its surroundings are looked at, metres."""


@kernel
def _one_piece(
    counts: Counts, reached: Bools, r0: int, r1: int, c0: int, c1: int
) -> tuple[bool, int]:
    """Tell whether the free cells of a window that were reached hang together inside it, and count them.

    Where they do, blocking cells amid the window cut nothing off: a path through them can go round inside the window.
    """
    rows, cols = r1 - r0, c1 - c0
    seen = np.zeros((rows, cols), dtype=np.bool_)
    stack = np.empty(rows * cols, dtype=np.int32)
    total = 0
    start = -1
    for r in range(rows):
        for c in range(cols):
            if reached[r0 + r, c0 + c] and counts[r0 + r, c0 + c] == 0:
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
    return found == total, total


@kernel
def _approachable(
    reached: Bools, x0: float, y0: float, cell: float, box: Floats, reach: float, front: bool
) -> bool:
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
) -> int:
    """Return the first box that cannot be approached, -1 if all can.

    A box with `front` set needs a cell before its front, or one beside its `partner` (index, -1: none) that
    stands there.
    """
    for k in range(boxes.shape[0]):
        if not _approachable(reached, x0, y0, cell, boxes[k], reach, False):
            return k
        if front[k] and not _approachable(reached, x0, y0, cell, boxes[k], reach, True):
            p = partner[k]
            if p < 0 or not _approachable(reached, x0, y0, cell, boxes[p], reach, False):
                return k
    return -1


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
        self.counts = wall_counts(rows, cols, self.x0, self.y0, cell, edges, walls, radius)
        self.reached = np.zeros((rows, cols), dtype=np.bool_)
        self.free_cells = int((self.counts == 0).sum())
        self.thresholds = [
            near_segment(self.counts, self.x0, self.y0, cell, np.asarray(door, float), stand)
            for door in doors
        ]
        self.seeds, self.required = self._entries()
        self.reached_cells = int(flood_fill(self.counts, self.seeds, self.reached))
        self._undo = (np.zeros((0, 6)), self.reached, self.reached_cells)

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
        return other

    def add(self, boxes: Floats) -> bool:
        """Stamp boxes, shape (k, 6), grown by the robot's radius; tell whether the doors stay connected.

        `undo` takes the last addition back.
        """
        self._undo = (boxes, self.reached, self.reached_cells)
        self.free_cells -= self._stamp(boxes, 1)
        if len(boxes) > 3 or not self._shrink_locally(boxes):
            self._flood()
        return self._doors_joined()

    def undo(self) -> None:
        """Take back the last `add`."""
        boxes, self.reached, self.reached_cells = self._undo
        self.free_cells -= self._stamp(boxes, -1)

    def remove(self, boxes: Floats) -> None:
        """Take boxes away that stand."""
        self.free_cells -= self._stamp(boxes, -1)
        self._flood()

    def _stamp(self, boxes: Floats, delta: int) -> int:
        return int(stamp(self.counts, self.x0, self.y0, self.cell, boxes, self.radius, delta))

    def _flood(self) -> None:
        self.reached = np.zeros_like(self.reached)
        self.reached_cells = int(flood_fill(self.counts, self.seeds, self.reached))

    def _shrink_locally(self, boxes: Floats) -> bool:
        """Drop newly blocked cells from `reached` where a look around the boxes proves that nothing is cut off."""
        rows, cols = self.counts.shape
        margin = self.radius + _LOOK_AROUND
        spans = np.array(
            [cell_window(box, margin, self.x0, self.y0, self.cell, rows, cols) for box in boxes]
        )
        r0, r1 = int(spans[:, 0].min()), int(spans[:, 1].max())
        c0, c1 = int(spans[:, 2].min()), int(spans[:, 3].max())
        if (r1 - r0) * (c1 - c0) > rows * cols // 3:
            return False
        whole, left = _one_piece(self.counts, self.reached, r0, r1, c0, c1)
        if not whole:
            return False
        before = self.reached[r0:r1, c0:c1]
        self.reached_cells += left - int(before.sum())
        self.reached = self.reached.copy()
        self.reached[r0:r1, c0:c1] &= self.counts[r0:r1, c0:c1] == 0
        return True

    def _doors_joined(self) -> bool:
        """Tell whether every door's threshold is reached, the first one's being where one comes from."""
        flat = self.reached.ravel()
        return all(bool(flat[cells].any()) for cells in self.required)

    def first_unreachable(self, boxes: Floats, front: Bools, partner: Labels) -> int:
        """Return the index of the first box that cannot be approached, -1 if all can.

        Parameters
        ----------
        boxes : (m, 6) array
        front : (m,) bool array
            Whether a cell before the front is needed.
        partner : (m,) int32 array
            Index of the box (a chair at its desk) that counts for the front too, -1: none.
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
            )
        )
