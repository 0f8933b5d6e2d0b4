"""A partition with its polygons and their verdict, measured once."""

from dataclasses import dataclass

from shapely.geometry import MultiPolygon, Polygon

from mansion_planner.solver.model import FloorModel
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.polygons import room_shapes
from mansion_planner.solver.refine import Partition
from mansion_planner.solver.verify import Verdict, judge

__all__ = ["Measured", "measure"]


@dataclass(frozen=True)
class Measured:
    """A partition, its rooms' shapes in the model's frame, and what they are worth."""

    partition: Partition
    shapes: list[Polygon | MultiPolygon]
    verdict: Verdict

    @property
    def faultless(self) -> bool:
        """Every room is one piece and of a usable shape, and none straddles a structural wall."""
        return self.verdict.faults(()) == (0, 0)


def measure(model: FloorModel, partition: Partition, options: SolverOptions) -> Measured:
    """Trace and judge a partition."""
    shapes = room_shapes(model, partition.grid, partition.labels)
    return Measured(partition, shapes, judge(model, shapes, options))
