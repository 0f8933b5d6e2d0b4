"""Baseline agents: one that calls skills at random, and one that follows the oracle's plan."""

from typing import Any

import numpy as np

from mansion_msgs_py.task import SkillCall
from mansion_tasks.agents.interface import Access, Agent, Briefing, Observation, Stop

__all__ = ["OracleAgent", "RandomAgent"]

SKILLS = (
    "GoToLandmark",
    "GoNearObject",
    "MoveAhead",
    "Rotate",
    "OpenDoor",
    "OpenObject",
    "CloseObject",
    "PickUp",
    "Place",
    "CallElevator",
    "UseElevator",
    "TakeStairs",
    "ToggleOn",
    "ToggleOff",
)


class RandomAgent(Agent):
    """Chooses a skill, and arguments that exist, each uniformly; it knows what any client of the services does.

    Examples
    --------
    >>> from mansion_msgs_py.world import Pose2D
    >>> agent = RandomAgent()
    >>> agent.reset(Briefing("carry a mug", (1, 2), ("1", "2"), 50, seed=3))
    >>> isinstance(agent.act(Observation("carry a mug", 0, 50, 1, (1, 2), Pose2D(x=0, y=0))), SkillCall)
    True
    """

    name = "random"
    access = Access()

    def __init__(self) -> None:
        self._rng = np.random.default_rng(0)

    def reset(self, briefing: Briefing) -> None:
        """See `Agent.reset`."""
        self._rng = np.random.default_rng(briefing.seed)

    def act(self, observation: Observation) -> SkillCall | Stop:
        """See `Agent.act`."""
        skill = self._choice(SKILLS)
        return SkillCall(skill=skill, arguments=self._arguments(skill, observation))

    def _arguments(self, skill: str, observation: Observation) -> dict[str, Any]:
        objects = [item.ref for item in observation.visible]
        if skill == "GoToLandmark":
            return {"landmark": self._choice([entry.name for entry in observation.landmarks])}
        if skill == "MoveAhead":
            return {"distance": round(float(self._rng.uniform(-0.5, 2.0)), 2)}
        if skill == "Rotate":
            return {"degrees": self._choice((-90.0, -45.0, 45.0, 90.0, 180.0))}
        if skill == "UseElevator":
            return {"target_floor": self._choice(observation.floors)}
        if skill == "TakeStairs":
            return {"direction": self._choice(("Up", "Down"))}
        if skill == "Place":
            return {"target": self._choice([*objects, "floor"]), "relation": self._choice(("on", "in"))}
        if skill in ("CallElevator", "OpenDoor"):
            return {}
        return {"object": self._choice(objects)}

    def _choice(self, options: Any) -> Any:
        return options[int(self._rng.integers(len(options)))] if options else ""

    def lessons(self) -> list[str]:
        """See `Agent.lessons`: chance learns nothing."""
        return []

    def notes(self) -> dict[str, Any]:
        """See `Agent.notes`."""
        return {}


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
