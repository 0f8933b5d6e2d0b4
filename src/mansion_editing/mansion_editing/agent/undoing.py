"""An instruction that takes the last edit back, or does it again."""

import re
from typing import Final

from mansion_editing.editor import SceneEditor
from mansion_msgs_py.codec import to_builtins
from mansion_msgs_py.editing import AgentReport, AgentStep, EditResult
from mansion_msgs_py.errors import MansionError

__all__ = ["take_back", "tool_asked"]

_LAST: Final = (
    r"(?:that|it|this|what you (?:just |have just )?(?:did|done)|"
    r"(?:the|my|your|our) (?:last|latest|previous|most recent)(?: \w+)?)"
)
_BACK: Final = (
    rf"(?P<undo>undo(?: {_LAST})?|(?:revert|reverse|take back|roll back) {_LAST}|(?:take|roll) {_LAST} back)|"
    rf"(?P<redo>redo(?: {_LAST})?|do {_LAST} again)"
)
_ASKED: Final = re.compile(
    rf"(?:(?:please|now|then|no|ok|okay|sorry|(?:could|can|would) you)[, ]+)*(?:{_BACK})(?:,? please| again| for me)*",
    re.IGNORECASE,
)


def tool_asked(instruction: str) -> str:
    """Return the tool, Undo or Redo, that an instruction as a whole asks for; empty for others.

    Examples
    --------
    >>> tool_asked("Please undo that.")
    'Undo'
    >>> tool_asked("undo all edits of other people")
    ''
    """
    match = _ASKED.fullmatch(" ".join(instruction.split()).strip(" .,!?"))
    if match is None:
        return ""
    return "Undo" if match["undo"] else "Redo"


def take_back(editor: SceneEditor, tool: str) -> AgentReport:
    """Undo or redo this user's last edit, an instruction as a whole."""
    thought = f"The last edit is to be {'taken back' if tool == 'Undo' else 'done again'}."
    try:
        done: EditResult = editor.call(tool)
    except MansionError as error:
        step = AgentStep(thought=thought, tool=tool, observation=to_builtins(error.reply()))
        return AgentReport(message=str(error), done=False, steps=[step], failed=[str(error)])
    return AgentReport(
        message=done.message,
        done=True,
        steps=[AgentStep(thought=thought, tool=tool, observation=to_builtins(done))],
        facts=[f"the last edit {'taken back' if tool == 'Undo' else 'done again'}"],
        edits=1,
        saved=done.saved,
        transaction=done.transaction,
        object_ids=done.object_ids,
    )
