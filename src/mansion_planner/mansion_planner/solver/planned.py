"""The layout that seed boxes describe by themselves, where they tile the free region.

A planner that knows the floor's shape gives boxes (Fig. 25) that leave nothing to search: painted from the loosest to
the tightest, each room gets its area. Such a layout is taken if its polygons realise every edge.
"""

import numpy as np

from mansion_msgs_py.layout import CutRoundRecord
from mansion_planner.solver.cutting import RoundsResult
from mansion_planner.solver.grid import SAME_LINE, Grid, make_grid
from mansion_planner.solver.model import FloorModel
from mansion_planner.solver.refine import Partition
from mansion_planner.solver.rounds import build_cut_rounds
from mansion_planner.solver.state import AREA, CX, CY, Floats, Ints

__all__ = ["planned_partition", "planned_rounds"]

AREA_TOLERANCE = 0.03
"""Share by which a painted room may miss its area."""

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
    free = grid.base == -1
    if (labels[free] == -1).any():
        return None
    sizes = grid.cells.geometry[..., AREA][: labels.shape[0], : labels.shape[1]]
    painted = np.array([sizes[free & (labels == k)].sum() for k in range(len(boxes))])
    if (np.abs(painted - model.targets) > AREA_TOLERANCE * model.targets).any():
        return None
    return Partition(grid, labels, 0.0)


def planned_rounds(model: FloorModel, partition: Partition) -> RoundsResult:
    """Return the cut schedule of a planned layout, for its record."""
    records = [
        CutRoundRecord(parent=cut.parent, children=list(cut.children), method="planned")
        for cut in build_cut_rounds(model)
    ]
    seeds = {room.id: (x, y) for room, (x, y) in zip(model.rooms, model.seeds.tolist())}
    return RoundsResult(partition.labels, records, seeds, 0.0, [])


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


def _painted(model: FloorModel, grid: Grid, boxes: list[Box]) -> Ints:
    labels = grid.base.copy()
    rows, columns = labels.shape
    x = grid.cells.geometry[:rows, :columns, CX]
    y = grid.cells.geometry[:rows, :columns, CY]
    area = grid.cells.geometry[:rows, :columns, AREA]
    free = grid.base == -1
    covers = [(x > b[0]) & (x < b[2]) & (y > b[1]) & (y < b[3]) & free for b in boxes]
    slack = [float(area[cover].sum() / model.targets[k]) for k, cover in enumerate(covers)]
    for k in sorted(range(len(boxes)), key=lambda k: (-slack[k], k)):
        labels[covers[k]] = k
    return labels
