"""Policies, which work by turns: they yield calls of tools, are sent the outcomes, and end with a verdict."""

from collections.abc import Generator
from dataclasses import dataclass, field
from typing import Any, TypeAlias

from mansion_msgs_py.errors import MansionError

__all__ = ["Action", "Outcome", "Policy", "Unmet", "Verdict", "ask"]


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
    question : bool
        It was only asked; `summary` is the answer.
    candidates : list of str
        Ids of what words may mean that fit several things.
    """

    summary: str
    facts: list[str] = field(default_factory=list)
    failed: list[str] = field(default_factory=list)
    question: bool = False
    candidates: list[str] = field(default_factory=list)


Policy: TypeAlias = Generator[Action, Outcome, Verdict]
"""Yields actions, is sent outcomes, returns a verdict."""


class Unmet(Exception):
    """Why a fact does not hold."""


def ask(thought: str, tool: str, arguments: dict[str, Any]) -> Generator[Action, Outcome, Any]:
    """Call a tool and return its reply.

    Raises
    ------
    Unmet
        Where the tool refuses.
    """
    answer = yield Action(thought, tool, arguments)
    if answer.error is not None:
        raise Unmet(str(answer.error))
    return answer.value
