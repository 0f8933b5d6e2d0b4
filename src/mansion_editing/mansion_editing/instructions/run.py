"""Carry out an instruction that was read: each statement with tools, the whole checked, and landed or dropped."""

from dataclasses import replace
from typing import Final

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.checking.faults import Step, faults, moved_aside
from mansion_editing.instructions.conversation import context_of, is_taken_back, repeated
from mansion_editing.instructions.doing.carrying_out import carry
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import things_of
from mansion_editing.instructions.statements import Ask, History, Instruction, Keep, Mention
from mansion_editing.runs.policies import Policy, Unmet, Verdict
from mansion_editing.runs.run import run_policy
from mansion_editing.state import SceneState
from mansion_msgs_py.codec import to_builtins
from mansion_msgs_py.editing.changes import EditResult
from mansion_msgs_py.editing.instructions import AgentReport, AgentStep
from mansion_msgs_py.errors import MansionError

__all__ = ["MOST_EDITS", "MOST_STEPS", "carry_out", "statement_policy"]

MOST_STEPS, MOST_EDITS = 12_000, 3_000
"""What is enough for a statement about all things of a large building."""


def carry_out(editor: SceneEditor, instruction: Instruction, text: str) -> AgentReport:
    """Carry out an instruction and check the scene; its edits land together or not at all.

    Parameters
    ----------
    text : str
        The instruction's own words, for the log.

    Returns
    -------
    AgentReport
        `message` says what was there and what changed, or answers the question, or why nothing was done.

    Raises
    ------
    MansionError
        ``CONFLICT`` when edits wait in the editor already.
    """
    (first, *more) = instruction.statements or [Mention()]
    if isinstance(first, History) and not more and not instruction.not_understood:
        if first.what == "redo":
            return _undo_or_redo(editor, "Redo")
        if is_taken_back(first, editor):
            return _undo_or_redo(editor, "Undo")
    return run_policy(editor, statement_policy(editor, instruction), text, most_steps=MOST_STEPS, most_edits=MOST_EDITS)


_EXAMPLES: Final = (
    'what can be asked for: "put two red mugs on the desk in the study", "remove two of the four chairs in the lobby", '
    '"turn the floor lamp upstairs off", "move the plant to the corner of the kitchen", "rename the study to Den"'
)


def statement_policy(editor: SceneEditor, instruction: Instruction) -> Policy:
    """Carry out the statements of an instruction in turn, and check what became of them."""
    if instruction.not_understood:
        words = "; ".join(repr(part[:80]) for part in instruction.not_understood)
        reason = f"not understood: {words}; {_EXAMPLES}"
        return Verdict(reason, failed=[reason])
    asked = [statement for statement in instruction.statements if not isinstance(statement, Mention)]
    if not asked:
        return Verdict("the words ask for nothing", failed=["the words ask for nothing"])
    try:
        instruction = repeated(instruction, editor)
    except MansionError as error:
        return _refused(error, "")
    state = editor.state
    steps: list[Step] = []
    replies: list[str] = []
    before = state.copied()
    context = replace(context_of(editor), kept=_kept(instruction, state))
    for statement in instruction.statements:
        try:
            done = yield from carry(statement, state, context)
        except (Unmet, MansionError) as error:
            return _refused(error, statement.quote)
        after = state.copied()
        step = Step(statement, context, before, after)
        steps.append(step)
        replies += [done.reply] if done.reply else []
        replies += moved_aside(step)
        before, context = after, done.context
    found = faults(steps)
    if found:
        return Verdict(f"the edit was dropped: {'; '.join(found)}", failed=found)
    if all(isinstance(statement, Ask) for statement in asked):
        return Verdict(" ".join(replies), replies, question=True)
    told = f" (ignored, as scenes do not record it: {', '.join(instruction.ignored)})" if instruction.ignored else ""
    return Verdict("; ".join(replies) + told, replies)


def _kept(instruction: Instruction, state: SceneState) -> frozenset[str]:
    """Return the ids of what shall stay as it is, wherever in the instruction that is said."""
    keeps = [s for s in instruction.statements if isinstance(s, Keep) and not s.things.refers]
    return frozenset(item.id for keep in keeps for item in things_of(state, keep.things, Context()))


def _refused(error: Unmet | MansionError, quote: str) -> Verdict:
    reason = error.info.message if isinstance(error, MansionError) else str(error)
    candidates = error.info.details.get("candidates", []) if isinstance(error, MansionError) else []
    message = f"{quote}: {reason}" if quote else reason
    return Verdict(message, failed=[message], candidates=[str(name) for name in candidates])


def _undo_or_redo(editor: SceneEditor, tool: str) -> AgentReport:
    """Undo or redo this user's last edit, an instruction as a whole."""
    thought = f"{tool} the last edit."
    try:
        done: EditResult = editor.call(tool)
    except MansionError as error:
        step = AgentStep(thought=thought, tool=tool, observation=to_builtins(error.reply()))
        return AgentReport(message=str(error), done=False, steps=[step], failed=[str(error)])
    return AgentReport(
        message=done.message,
        done=True,
        steps=[AgentStep(thought=thought, tool=tool, observation=to_builtins(done))],
        facts=[f"the last edit {'undone' if tool == 'Undo' else 'redone'}"],
        edits=1,
        saved=done.saved,
        transaction=done.transaction,
        object_ids=done.object_ids,
    )
