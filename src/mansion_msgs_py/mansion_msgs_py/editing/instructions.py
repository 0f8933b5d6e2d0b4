"""Instructions in words and tasks to provision, and the report of what was done."""

from typing import Annotated, Any, Literal

import msgspec

from mansion_msgs_py.editing.open_buildings import ToolArgs
from mansion_msgs_py.task import Task

__all__ = ["AgentReport", "AgentStep", "InstructArgs", "ProvisionArgs", "ReadStatement"]


class InstructArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """An instruction for the editing agent; `planner` as in a `BuildRequest`.

    Attributes
    ----------
    partly : bool
        The rules do what they can of it and say what they did not; all or nothing otherwise.
    """

    instruction: Annotated[str, msgspec.Meta(max_length=4000)]
    planner: Literal["rules", "llm"] = "rules"
    partly: bool = False


class ProvisionArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """A task to make possible: what it needs is checked, and provided where it is missing."""

    task: Task


class AgentStep(msgspec.Struct, frozen=True, kw_only=True):
    """One turn of the agent: what it thought, the tool it called and what it saw."""

    thought: str
    tool: str = ""
    arguments: dict[str, Any] = {}
    observation: Any = None
    refused: bool = False


class ReadStatement(msgspec.Struct, frozen=True, kw_only=True):
    """One statement of an instruction: what it asks for, the words that say so, and who read it."""

    kind: str
    quote: str
    read_by: Literal["model", "rules"] = "rules"


class AgentReport(msgspec.Struct, kw_only=True, frozen=True):
    """Reply of ``scene/instruct`` and ``scene/provision``.

    Attributes
    ----------
    done : bool
        Every fact that the instruction asks for, or the task needs, holds.
    facts, failed : list of str
        What was asked, in words; and what could not be met, each with its reason.
    edits : int
        Tools that changed something.
    question : bool
        It was only asked about the building; `message` is the answer.
    candidates : list of str
        Ids of what words may mean that fit several things.
    read : list of ReadStatement
        What a model and the rules read together, in the order of the text; empty where the rules read alone.
    """

    message: str
    done: bool
    steps: list[AgentStep] = []
    facts: list[str] = []
    failed: list[str] = []
    edits: int = 0
    saved: bool = False
    transaction: int | None = None
    object_ids: list[str] = []
    question: bool = False
    candidates: list[str] = []
    read: list[ReadStatement] = []
