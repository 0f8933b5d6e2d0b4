"""The stages behind the services of a node graph."""

from mansion_bringup.client import MansionClient
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.stages import FurnishRequest, PlanReply

__all__ = ["RemoteStages"]


class RemoteStages:
    """`Stages` by service calls.

    Parameters
    ----------
    client : MansionClient
    timeout : float
        Seconds that one stage of one floor may take; ``TIMEOUT`` after that.
    """

    def __init__(self, client: MansionClient, timeout: float) -> None:
        self._client = client
        self._timeout = timeout

    def plan(self, request: BuildRequest) -> PlanReply:
        """See `Stages.plan`."""
        reply: PlanReply = self._client.call(
            "plan_program", request, reply=PlanReply, timeout=self._timeout
        )
        return reply

    def solve(self, problem: FloorProblem) -> FloorLayout:
        """See `Stages.solve`."""
        reply: FloorLayout = self._client.call(
            "solve_floor", problem, reply=FloorLayout, timeout=self._timeout
        )
        return reply

    def furnish(self, request: FurnishRequest) -> FloorScene:
        """See `Stages.furnish`."""
        reply: FloorScene = self._client.call(
            "furnish_floor", request, reply=FloorScene, timeout=self._timeout
        )
        return reply
