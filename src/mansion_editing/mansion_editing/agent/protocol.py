"""What a policy and the editor exchange: actions, outcomes and, at the end, a verdict."""

from collections.abc import Generator
from dataclasses import dataclass, field
from typing import Any, TypeAlias

from mansion_msgs_py.errors import MansionError

__all__ = ["Action", "Outcome", "Policy", "Verdict"]


@dataclass(frozen=True)
class Action:
    """One turn: a thought and a call of a tool; arguments are JSON."""

    thought: str
    tool: str
    arguments: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Outcome:
    """What a tool answered: its reply, or why it refused."""

    value: Any = None
    error: MansionError | None = None


@dataclass(frozen=True)
class Verdict:
    """How a policy ends.

    Attributes
    ----------
    facts : list of str
        What was asked for, in words.
    failed : list of str
        What does not hold, each with its reason.
    """

    summary: str
    facts: list[str] = field(default_factory=list)
    failed: list[str] = field(default_factory=list)


Policy: TypeAlias = Generator[Action, Outcome, Verdict]
"""Yields actions, is sent outcomes, returns a verdict."""
