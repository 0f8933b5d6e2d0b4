"""One call for an instruction (the offline policy, or a language model) or for a task's needs."""

from mansion_editing.agent.controller import run_agent
from mansion_editing.agent.needs import task_policy
from mansion_editing.agent.offline import offline_policy
from mansion_editing.agent.protocol import Policy
from mansion_editing.agent.undoing import take_back, tool_asked
from mansion_editing.editor import SceneEditor
from mansion_msgs_py.editing import AgentReport
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.task import Task

__all__ = ["instruct", "provision"]


def instruct(editor: SceneEditor, instruction: str, planner: str = "rules") -> AgentReport:
    """Carry out an instruction; its edits land together or not at all.

    Parameters
    ----------
    planner : {"rules", "llm"}

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for another planner, ``UNAVAILABLE`` for a model that is not configured, ``CONFLICT`` when
        edits wait to be saved.
    """
    tool = tool_asked(instruction) if planner == "rules" else ""
    if tool:
        return take_back(editor, tool)
    return run_agent(editor, _policy(editor, instruction, planner), instruction)


def provision(editor: SceneEditor, task: Task) -> AgentReport:
    """Make a task possible with the fewest edits; they land together or not at all.

    Raises
    ------
    MansionError
        ``CONFLICT`` when edits wait to be saved.
    """
    return run_agent(editor, task_policy(editor, task), f"task {task.id}: {task.instruction}")


def _policy(editor: SceneEditor, instruction: str, planner: str) -> Policy:
    if planner == "rules":
        return offline_policy(editor, instruction)
    if planner == "llm":
        from mansion_editing.agent.model import model_policy
        from mansion_llm import LlmClient

        return model_policy(LlmClient.from_environment(), editor, instruction)
    raise MansionError(ErrorCode.INVALID_PAYLOAD, f"no planner {planner!r}; use rules or llm", path="$.planner")
