"""Provision a task: its needs are met with edits that land together or not at all."""

from mansion_editing.editor import SceneEditor
from mansion_editing.provisioning.task_needs import task_policy
from mansion_editing.runs.run import run_policy
from mansion_msgs_py.editing.instructions import AgentReport
from mansion_msgs_py.task import Task

__all__ = ["provision"]


def provision(editor: SceneEditor, task: Task) -> AgentReport:
    """Make a task possible with the fewest edits; they land together or not at all.

    Raises
    ------
    MansionError
        ``CONFLICT`` when edits wait to be saved.
    """
    return run_policy(editor, task_policy(editor, task), f"task {task.id}: {task.instruction}")
