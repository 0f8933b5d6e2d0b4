"""Dual-layer memory: what happened in this episode, and what failed in earlier ones (section E)."""

from dataclasses import dataclass, field

from mansion_tasks.agents.interface import Observation

__all__ = ["Memory"]

RECENT = 12
"""Steps of this episode that a prompt carries."""

MOST_LESSONS = 8
"""Failures of an episode that later ones are told."""

LONGEST = 300


@dataclass
class Memory:
    """The memory of an agent that asks a model.

    Attributes
    ----------
    past : tuple of str
        Failures of earlier episodes.
    """

    past: tuple[str, ...] = ()
    _steps: list[str] = field(default_factory=list)
    _failures: dict[str, None] = field(default_factory=dict)

    def note(self, observation: Observation) -> None:
        """Remember the last skill and what came of it."""
        call, result = observation.last_call, observation.last
        if call is None or result is None:
            return
        arguments = ", ".join(f"{key}={value}" for key, value in sorted(call.arguments.items()))
        line = f"{call.skill}({arguments}) -> {result.status.value}: {result.message}"[:LONGEST]
        self._steps.append(f"{observation.step}. {line}")
        if not observation.succeeded:
            wish = f"; to succeed: {result.satisfied_by}" if result.satisfied_by else ""
            failure = f"On floor {observation.floor}, {call.skill}: {result.message}{wish}"[:LONGEST]
            self._failures[failure] = None

    def remark(self, text: str) -> None:
        """Remember something that is no skill."""
        self._steps.append(text[:LONGEST])

    def recent(self) -> str:
        """Return the last steps, a line each."""
        return "\n".join(self._steps[-RECENT:]) or "nothing yet"

    def lessons(self) -> list[str]:
        """Return what failed in this episode, each failure once, the newest."""
        return list(self._failures)[-MOST_LESSONS:]
