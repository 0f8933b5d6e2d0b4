"""The three stages of Algorithm 1 behind one interface, and their in-process form."""

from typing import Protocol

from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.stages import FurnishRequest, PlanReply

__all__ = ["LocalStages", "Stages"]


class Stages(Protocol):
    """What the director asks of the planner, the solver and the placer; each raises `MansionError`."""

    def plan(self, request: BuildRequest) -> PlanReply:
        """Program, room graphs and problems (Algorithm 1, lines 1 to 7)."""

    def solve(self, problem: FloorProblem) -> FloorLayout:
        """The layout of one floor (line 8)."""

    def furnish(self, request: FurnishRequest) -> FloorScene:
        """The furnished scene of one floor (lines 9 to 17)."""


class LocalStages:
    """The stages as plain function calls in this process."""

    def plan(self, request: BuildRequest) -> PlanReply:
        """See `Stages.plan`."""
        from mansion_planner.plan import plan_building

        return plan_building(request)

    def solve(self, problem: FloorProblem) -> FloorLayout:
        """See `Stages.solve`."""
        from mansion_planner.solver import solve_floor

        return solve_floor(problem)

    def furnish(self, request: FurnishRequest) -> FloorScene:
        """See `Stages.furnish`."""
        from mansion_scene.assembly import furnish_floor

        return furnish_floor(request)
