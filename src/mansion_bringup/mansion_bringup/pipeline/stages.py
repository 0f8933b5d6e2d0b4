"""The three stages of Algorithm 1 behind one interface: function calls in this process, or services of a node graph."""

import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final, Protocol, TypeVar

from mansion_msgs_py.interfaces import service
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.stages import FurnishRequest, PlanReply

if TYPE_CHECKING:
    from mansion_bringup.client import MansionClient

__all__ = ["LocalStages", "RemoteStages", "Stages"]


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
        with importing:
            from mansion_planner.plan import plan_building

        return plan_building(request)

    def solve(self, problem: FloorProblem) -> FloorLayout:
        """See `Stages.solve`."""
        with importing:
            from mansion_planner.solver import solve_floor

        return solve_floor(problem)

    def furnish(self, request: FurnishRequest) -> FloorScene:
        """See `Stages.furnish`."""
        with importing:
            from mansion_scene.assembly import furnish_floor

        return furnish_floor(request)


T = TypeVar("T")
LOOK: Final = 1.0
"""Seconds between two looks at a node that does not serve yet."""


class RemoteStages:
    """`Stages` by service calls.

    A node that runs but does not serve yet (after an installation the floor solver first compiles its kernels, for a
    minute) is waited for as long as a stage may take.

    Parameters
    ----------
    client : MansionClient
    timeout : float
        Seconds that one stage of one floor may take; ``TIMEOUT`` after that.
    discovery : float
        Seconds for a running node to be found; ``UNAVAILABLE`` after that.
    cancelled : callable
        Asked while a stage runs whether its result is not wanted any more; the stage is ``CANCELED`` then.
    """

    def __init__(
        self,
        client: "MansionClient",
        timeout: float,
        discovery: float = 5.0,
        cancelled: Callable[[], bool] = lambda: False,
    ) -> None:
        self._client = client
        self._timeout = timeout
        self._discovery = discovery
        self._cancelled = cancelled

    def plan(self, request: BuildRequest) -> PlanReply:
        """See `Stages.plan`."""
        return self._call("plan_program", request, PlanReply)

    def solve(self, problem: FloorProblem) -> FloorLayout:
        """See `Stages.solve`."""
        return self._call("solve_floor", problem, FloorLayout)

    def furnish(self, request: FurnishRequest) -> FloorScene:
        """See `Stages.furnish`."""
        return self._call("furnish_floor", request, FloorScene)

    def _call(self, name: str, request: Any, reply: type[T]) -> T:
        self._await_loading(name)
        answer: T = self._client.call(
            name, request, reply=reply, timeout=self._timeout, wait=0.0, cancelled=self._cancelled
        )
        return answer

    def _await_loading(self, name: str) -> None:
        """Wait for a service whose node is up; the call itself reports one that is not."""
        if self._client.wait_served(name, self._discovery):
            return
        deadline = time.monotonic() + self._timeout
        while self._client.sees_node(service(name).node) and time.monotonic() < deadline:
            if self._cancelled() or self._client.wait_served(name, LOOK):
                return
