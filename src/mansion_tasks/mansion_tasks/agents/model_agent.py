"""Agents that ask a language model: their memory of steps and failures, and when they give up (section E)."""

from abc import abstractmethod
from dataclasses import dataclass, field
from typing import Any, Final

from mansion_llm import Answer, LlmClient
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.task import SkillCall
from mansion_tasks.agents.interface import Agent, Briefing, Observation, Stop
from mansion_tasks.agents.recovery import CornerRecovery

__all__ = ["Memory", "ModelAgent"]

RECENT_STEPS: Final = 12
"""Steps of the present episode that a prompt carries."""

MAX_LESSONS: Final = 8
"""Failures of an episode that later episodes are told."""

MAX_LENGTH: Final = 300
"""Characters of a remembered step."""

MAX_UNUSABLE: Final = 3
"""Unusable answers in a row after which an agent gives up."""


@dataclass
class Memory:
    """What happened in this episode, and what failed in earlier ones.

    Attributes
    ----------
    past : tuple of str
        Failures of earlier episodes.
    """

    past: tuple[str, ...] = ()
    _steps: list[str] = field(default_factory=list)
    _failures: dict[str, None] = field(default_factory=dict)

    def record(self, observation: Observation) -> None:
        """Record the last skill and its result."""
        call, result = observation.last_call, observation.last
        if call is None or result is None:
            return
        arguments = ", ".join(f"{key}={value}" for key, value in sorted(call.arguments.items()))
        line = f"{call.skill}({arguments}) -> {result.status.value}: {result.message}"[:MAX_LENGTH]
        self._steps.append(f"{observation.step}. {line}")
        if not observation.succeeded:
            wish = f"; to succeed: {result.satisfied_by}" if result.satisfied_by else ""
            failure = f"On floor {observation.floor}, {call.skill}: {result.message}{wish}"[:MAX_LENGTH]
            self._failures[failure] = None

    def remark(self, text: str) -> None:
        """Record something other than a skill."""
        self._steps.append(text[:MAX_LENGTH])

    def recent(self) -> str:
        """Return the last steps, a line each."""
        return "\n".join(self._steps[-RECENT_STEPS:]) or "nothing yet"

    def lessons(self) -> list[str]:
        """Return the newest failures of this episode, each once."""
        return list(self._failures)[-MAX_LESSONS:]


class ModelAgent(Agent):
    """An agent whose skills a language model chooses.

    A subclass names itself and its access, and chooses in `_choose_skill`; leaving corners, memory and giving up are
    here.

    Parameters
    ----------
    client : LlmClient
    """

    def __init__(self, client: LlmClient) -> None:
        self._client = client
        self.reset(Briefing("", (), (), 0))

    def reset(self, briefing: Briefing) -> None:
        """See `Agent.reset`."""
        self._memory = Memory(briefing.lessons)
        self._recovery = CornerRecovery()
        self._unusable = 0
        self._notes: dict[str, Any] = {}

    def act(self, observation: Observation) -> SkillCall | Stop:
        """See `Agent.act`."""
        self._memory.record(observation)
        self._notes = {}
        way_out = self._recovery.step(observation)
        if way_out is not None:
            self._forget_plan()
            self._notes["recovery"] = "led out of a corner"
            return way_out
        return self._choose_skill(observation)

    @abstractmethod
    def _choose_skill(self, observation: Observation) -> SkillCall | Stop:
        """Ask the model for the next skill."""

    def _forget_plan(self) -> None:
        """Drop what was planned for the place from which the robot was just led away."""

    def _count_unusable(self, answer: Answer[Any] | None) -> Stop | None:
        """Count an unusable answer; return the end of the episode after `MAX_UNUSABLE` of them in a row.

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` when the endpoint gave no answer at all, which says nothing about the agent.
        """
        self._unusable += 1
        if self._unusable < MAX_UNUSABLE:
            return None
        if answer is not None and answer.value is None and not answer.faults:
            raise MansionError(
                ErrorCode.UNAVAILABLE, f"no answer from the model {MAX_UNUSABLE} times in a row: {answer.reason}"
            )
        return Stop(f"the model gave no usable answer {MAX_UNUSABLE} times in a row")

    def lessons(self) -> list[str]:
        """See `Agent.lessons`."""
        return self._memory.lessons()

    def notes(self) -> dict[str, Any]:
        """See `Agent.notes`."""
        return dict(self._notes)
