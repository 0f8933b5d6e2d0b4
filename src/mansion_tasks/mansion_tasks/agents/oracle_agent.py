"""Follows the plan that came with the task: the ceiling of every comparison."""

from typing import Any

from mansion_msgs_py.task import SkillCall
from mansion_tasks.agents.interface import Access, Agent, Briefing, Observation, Stop

__all__ = ["OracleAgent"]


class OracleAgent(Agent):
    """Calls the plan's skills one after the other; it is the only agent that is given the plan.

    Examples
    --------
    >>> from mansion_msgs_py.world import Pose2D
    >>> agent = OracleAgent()
    >>> agent.reset(Briefing("turn", (1,), ("1",), 9, plan=(SkillCall(skill="Rotate"),)))
    >>> agent.act(Observation("turn", 0, 9, 1, (1,), Pose2D(x=0, y=0))).skill
    'Rotate'
    """

    name = "oracle"
    access = Access(plan=True)

    def __init__(self) -> None:
        self._plan: list[SkillCall] = []

    def reset(self, briefing: Briefing) -> None:
        """See `Agent.reset`."""
        self._plan = list(briefing.plan)

    def act(self, observation: Observation) -> SkillCall | Stop:
        """See `Agent.act`."""
        return self._plan.pop(0) if self._plan else Stop("the plan is done", done=True)

    def lessons(self) -> list[str]:
        """See `Agent.lessons`: there is nothing to learn."""
        return []

    def notes(self) -> dict[str, Any]:
        """See `Agent.notes`."""
        return {}
