"""Carry out an instruction that was read: each statement with tools, the whole checked, and landed or dropped."""

import re
from collections.abc import Generator
from dataclasses import dataclass, field, replace
from typing import Final

import msgspec

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.checking.faults import Step, faults, moved_aside
from mansion_editing.instructions.conversation import amended, context_of, is_taken_back, remember, repeated
from mansion_editing.instructions.doing.answering import holds
from mansion_editing.instructions.doing.carrying_out import carry
from mansion_editing.instructions.meaning.bare_nouns import with_existing_things
from mansion_editing.instructions.meaning.brief import asked_of
from mansion_editing.instructions.meaning.chosen_owners import with_owners_chosen
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import things_of
from mansion_editing.instructions.meaning.vacated import went_away
from mansion_editing.instructions.statements import Ask, History, Instruction, Keep, Mention, Things, When
from mansion_editing.runs.policies import Action, Outcome, Policy, Unmet, Verdict
from mansion_editing.runs.run import run_policy
from mansion_editing.state import SceneState
from mansion_msgs_py.codec import to_builtins
from mansion_msgs_py.editing.changes import EditResult
from mansion_msgs_py.editing.instructions import AgentReport, AgentStep
from mansion_msgs_py.errors import MansionError

__all__ = ["MOST_EDITS", "MOST_STEPS", "carry_out", "statement_policy"]

MOST_STEPS, MOST_EDITS = 12_000, 3_000
"""What is enough for a statement about all things of a large building."""


def carry_out(editor: SceneEditor, instruction: Instruction, text: str, *, partly: bool = False) -> AgentReport:
    """Carry out an instruction and check the scene; its edits land together or not at all.

    Parameters
    ----------
    text : str
        The instruction's own words, for the log.
    partly : bool
        What is understood and can be done lands though the rest is not; all or nothing otherwise.

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
            return _undone_or_redone(editor, "Redo", first.times)
        if first.what == "amend":
            return _amended(editor, first, text)
        try:
            taken_back = is_taken_back(first, editor)
        except MansionError as error:
            return run_policy(editor, _refused_policy(error), text)
        if taken_back:
            return _undone_or_redone(editor, "Undo", first.times)
    policy = statement_policy(editor, instruction, partly=partly)
    return run_policy(editor, policy, text, most_steps=MOST_STEPS, most_edits=MOST_EDITS)


def _undone_or_redone(editor: SceneEditor, tool: str, times: int) -> AgentReport:
    """Undo or redo so many edits, or none of them."""
    reports: list[AgentReport] = []
    for _ in range(times):
        report = _undo_or_redo(editor, tool)
        if not report.done:
            for _ in reports:
                _undo_or_redo(editor, "Redo" if tool == "Undo" else "Undo")
            return report
        reports.append(report)
    message = "; ".join(report.message for report in reports)
    return msgspec.structs.replace(reports[-1], message=message, edits=len(reports))


def _amended(editor: SceneEditor, statement: History, text: str) -> AgentReport:
    """Take the last edit back and do it at another place, or leave it where that cannot be done."""
    try:
        instruction = Instruction(statements=amended(statement, editor))
    except MansionError as error:
        return run_policy(editor, _refused_policy(error), text)
    taken_back = _undo_or_redo(editor, "Undo")
    if not taken_back.done:
        return taken_back
    report = run_policy(
        editor, statement_policy(editor, instruction), text, most_steps=MOST_STEPS, most_edits=MOST_EDITS
    )
    if not report.done:
        _undo_or_redo(editor, "Redo")
        return report
    return msgspec.structs.replace(report, message=f"{taken_back.message}; {report.message}")


def _refused_policy(error: MansionError) -> Policy:
    yield from ()
    return _refused(error, "")


_EXAMPLES: Final = (
    'what can be asked for: "put two red mugs on the desk in the study", "remove two of the four chairs in the lobby", '
    '"turn the floor lamp upstairs off", "move the plant to the corner of the kitchen", "rename the study to Den"'
)


_OPENINGS: Final = re.compile(r"\b(door|window)s?\b", re.IGNORECASE)
_OF_OPENINGS: Final = (
    'name a door by the rooms that it joins ("close the door between the kitchen and the hall"); a door can also be'
    ' added ("add a door between the kitchen and the dining room"); windows are part of the structure'
)


def statement_policy(editor: SceneEditor, instruction: Instruction, *, partly: bool = False) -> Policy:
    """Carry out the statements of an instruction in turn, and check what became of them.

    Parameters
    ----------
    partly : bool
        As of `carry_out`.
    """
    asked = [statement for statement in instruction.statements if not isinstance(statement, Mention)]
    unread = _unread(instruction)
    if not asked or (unread and not partly):
        reason = f"{unread}; {_accepted(instruction)}" if unread else "the words ask for nothing"
        return Verdict(reason, failed=[reason])
    try:
        instruction = repeated(instruction, editor)
    except MansionError as error:
        return _refused(error, "")
    brief = asked_of(editor.store.building.program)
    context = replace(context_of(editor), kept=_kept(instruction, editor.state), brief=brief)
    instruction = with_existing_things(instruction, editor.state, context)
    instruction = with_owners_chosen(instruction, editor.state, context)
    course = _Course(editor.state, context, missed=[unread] if unread else [])
    refused = yield from _carried_out(instruction, course, partly=partly)
    if refused is not None:
        return refused
    found = faults(course.steps)
    if found:
        return Verdict(f"the edit was dropped: {'; '.join(found)}", failed=found)
    if all(isinstance(statement, Ask) for statement in asked):
        remember(editor, course.context)
        return Verdict(" ".join(course.replies), course.replies, question=True)
    if partly and not course.steps:
        return Verdict("; ".join(course.missed), failed=course.missed)
    replies = [*course.replies, *(f"not done: {reason}" for reason in course.missed)]
    passed = [s.quote for s in instruction.statements if isinstance(s, Mention) and s.passed_over]
    replies += [f"not acted on: {quote!r}" for quote in passed]
    replies += [f"read as: {instruction.read_as!r}"] if instruction.read_as else []
    told = f" (ignored, as scenes do not record it: {', '.join(instruction.ignored)})" if instruction.ignored else ""
    return Verdict("; ".join(replies) + told, replies)


@dataclass
class _Course:
    """How far the statements of an instruction are carried out.

    Attributes
    ----------
    missed : list of str
        What was not understood or could not be done.
    answers : list
        Conditions that were looked at, and whether they held.
    """

    state: SceneState
    context: Context
    missed: list[str]
    steps: list[Step] = field(default_factory=list)
    replies: list[str] = field(default_factory=list)
    answers: list[tuple[Ask, bool]] = field(default_factory=list)


def _unread(instruction: Instruction) -> str:
    """Return words for what was not understood; empty where all was."""
    words = "; ".join(repr(part[:80]) for part in instruction.not_understood)
    return f"not understood: {words}" if words else ""


def _accepted(instruction: Instruction) -> str:
    """Return words for what can be asked for instead of what was not understood."""
    openings = any(_OPENINGS.search(part) for part in instruction.not_understood)
    return _OF_OPENINGS if openings else _EXAMPLES


def _carried_out(
    instruction: Instruction, course: _Course, *, partly: bool
) -> Generator[Action, Outcome, Verdict | None]:
    """Carry out the statements in turn; return the refusal of the first that cannot be, where all have to."""
    before = course.state.copied()
    for statement in instruction.statements:
        mark = len(course.state.pending)
        try:
            if isinstance(statement, When):
                if _answer(statement.ask, course.answers, course.state, course.context) != statement.holds:
                    course.replies.append(f"{statement.quote}: not so, nothing had to change")
                    continue
                statement = statement.then
            done = yield from carry(statement, course.state, course.context)
        except (Unmet, MansionError) as error:
            refused = _refused(error, statement.quote)
            if not partly:
                return refused
            course.state.roll_back(mark)
            course.missed.append(refused.summary)
            continue
        after = course.state.copied()
        step = Step(statement, course.context, before, after)
        wrong = faults([step]) if partly else []
        if wrong:
            course.state.roll_back(mark)
            course.missed += wrong
            continue
        course.steps.append(step)
        course.replies += [*([done.reply] if done.reply else []), *moved_aside(step)]
        gone = went_away(before, after)
        before, course.context = after, replace(done.context, vacated=gone or done.context.vacated)
    return None


def _answer(ask: Ask, answers: list[tuple[Ask, bool]], state: SceneState, context: Context) -> bool:
    """Return whether a condition holds; one that was looked at before ("if so ..., otherwise ...") as it was then."""
    known = next((held for one, held in answers if one == ask), None)
    if known is None:
        known = holds(ask, state, context)
        answers.append((ask, known))
    return known


def _kept(instruction: Instruction, state: SceneState) -> frozenset[str]:
    """Return the ids of what shall stay as it is, wherever in the instruction that is said."""
    keeps = [s for s in instruction.statements if isinstance(s, Keep) and not _refers(s.things)]
    return frozenset(item.id for keep in keeps for item in things_of(state, keep.things, Context()))


def _refers(things: Things) -> bool:
    """Whether words for what stays mean what was mentioned before, or what is in it."""
    anchor = None if things.place is None else things.place.anchor
    return bool(things.refers) or (anchor is not None and bool(anchor.refers))


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
