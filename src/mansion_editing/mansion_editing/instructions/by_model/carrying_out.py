"""Carry out an instruction that a model read: by the code for the rules' statements, and told who read what."""

from collections.abc import Generator

import msgspec

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.by_model.open_wishes import open_wish_policy
from mansion_editing.instructions.by_model.reading import ModelReading, read_with_model
from mansion_editing.instructions.run import MOST_EDITS, MOST_STEPS, carry_out, statement_policy
from mansion_editing.instructions.statements import Mention
from mansion_editing.runs.policies import Action, Outcome, Policy, Verdict
from mansion_editing.runs.run import run_policy
from mansion_llm import LlmClient
from mansion_msgs_py.editing.instructions import AgentReport
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["carry_out_with_model"]


def carry_out_with_model(client: LlmClient, editor: SceneEditor, text: str) -> AgentReport:
    """Let a model read an instruction, carry it out and check the scene; its edits land together or not at all.

    Returns
    -------
    AgentReport
        `read` and the message say who read what.

    Raises
    ------
    MansionError
        ``CONFLICT`` when edits wait in the editor already, ``UNAVAILABLE`` where the model's key or address is refused.
    """
    if editor.state.pending:
        raise MansionError(ErrorCode.CONFLICT, "edits wait to be saved; save or undo them first")
    reading = read_with_model(client, text, editor.refreshed())
    if reading.refusal or reading.open_wishes:
        policy = _refused(reading) if reading.refusal else _with_open_wishes(client, editor, reading)
        report = run_policy(editor, policy, text, most_steps=MOST_STEPS, most_edits=MOST_EDITS)
    else:
        report = carry_out(editor, reading.instruction, text)
    message = " ".join([f"{report.message.rstrip('.')}.", *_readers(reading)])
    return msgspec.structs.replace(report, message=message, read=reading.read)


def _refused(reading: ModelReading) -> Generator[Action, Outcome, Verdict]:
    yield from ()
    return Verdict(f"{reading.refusal}; say it in other words", failed=[reading.refusal])


def _with_open_wishes(client: LlmClient, editor: SceneEditor, reading: ModelReading) -> Policy:
    """Carry out the statements first, then what only a model can work on."""
    instruction = reading.instruction
    done: list[Verdict] = []
    if instruction.not_understood or any(not isinstance(one, Mention) for one in instruction.statements):
        done.append((yield from statement_policy(editor, instruction)))
    for wish in reading.open_wishes:
        if done and done[-1].failed:
            return done[-1]
        done.append((yield from open_wish_policy(client, editor, wish)))
    if done[-1].failed:
        return done[-1]
    return Verdict("; ".join(one.summary for one in done), [fact for one in done for fact in one.facts])


def _readers(reading: ModelReading) -> list[str]:
    """Return in sentences who read which words."""
    told = []
    for reader in ("model", "rules"):
        quotes = [repr(one.quote) for one in reading.read if one.read_by == reader and one.kind != "Mention"]
        if quotes:
            told.append(f"by the {reader}: {', '.join(quotes)}")
    out = [f"Read {'; '.join(told)}."] if told else []
    return (
        [*out, f"Of the model's answer not all was taken: {reading.reason}."]
        if reading.reason and not reading.refusal
        else out
    )
