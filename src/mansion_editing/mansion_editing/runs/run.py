"""Let a policy work in an editor: its calls of tools are checked and bounded, and land together or not at all."""

from typing import Any, Final

import msgspec

from mansion_editing.editor import ACTION_TOOLS, FLOOR_TOOLS, PERCEPTION_TOOLS, SceneEditor
from mansion_editing.runs.policies import Action, Outcome, Policy, Verdict
from mansion_msgs_py.codec import decode, encode, to_builtins
from mansion_msgs_py.editing.instructions import AgentReport, AgentStep
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.wording import counted

__all__ = ["MOST_EDITS", "MOST_STEPS", "RUN_TOOLS", "run_policy"]

RUN_TOOLS: Final[dict[str, type[Any]]] = {**PERCEPTION_TOOLS, **ACTION_TOOLS, **FLOOR_TOOLS}
"""All that a policy may call; files and other buildings have no tool."""

MOST_STEPS: Final = 400
MOST_EDITS: Final = 120
MOST_REFUSED: Final = 8


def run_policy(
    editor: SceneEditor, policy: Policy, what: str, *, most_steps: int = MOST_STEPS, most_edits: int = MOST_EDITS
) -> AgentReport:
    """Let a policy work until it ends or a bound is reached.

    Parameters
    ----------
    editor : SceneEditor
        With nothing waiting to be saved.
    what : str
        The instruction, for the log.
    most_steps, most_edits : int
        Calls of tools, and those that change something, after which the policy is stopped.

    Returns
    -------
    AgentReport
        Edits land as one transaction when every fact holds, and not at all otherwise.

    Raises
    ------
    MansionError
        ``CONFLICT`` when edits wait in the editor already, ``CANCELED`` where the run was cancelled (see
        `SceneEditor.cancellable`).
    """
    if editor.state.pending:
        raise MansionError(ErrorCode.CONFLICT, "there are unsaved edits; save or undo them first")
    autosave, editor.autosave = editor.autosave, False
    run = _Run(editor, most_steps, most_edits)
    try:
        editor.reload()
        verdict = run.drive(policy)
        editor.go_on()
        return run.finish(verdict, what, land=autosave)
    finally:
        editor.autosave = autosave
        if autosave and editor.state.pending:
            editor.reload()


class _Run:
    """The steps of one run."""

    def __init__(self, editor: SceneEditor, most_steps: int, most_edits: int) -> None:
        self.editor, self.most_steps, self.most_edits = editor, most_steps, most_edits
        self.steps: list[AgentStep] = []
        self.edits = 0
        self.refused = 0

    def drive(self, policy: Policy) -> Verdict:
        """Answer a policy's actions until it returns."""
        try:
            action = next(policy)
            while True:
                if len(self.steps) >= self.most_steps or self.edits >= self.most_edits:
                    return _stopped(f"stopped after {counted(len(self.steps), 'step')}, {counted(self.edits, 'edit')}")
                if self.refused >= MOST_REFUSED:
                    return _stopped(f"stopped after {counted(self.refused, 'invalid action')}")
                action = policy.send(self.act(action))
        except StopIteration as end:
            verdict: Verdict = end.value
            return verdict
        except MansionError as error:
            return Verdict(str(error), failed=[str(error)])

    def act(self, action: Action) -> Outcome:
        """Check an action against the tools' schemas and run it."""
        try:
            arguments = _checked(action)
        except MansionError as error:
            self.refused += 1
            self._note(action, error.reply(), refused=True)
            return Outcome(error=error)
        try:
            value = self.editor.call(action.tool, arguments)
        except MansionError as error:
            self._note(action, error.reply())
            return Outcome(error=error)
        if action.tool in ACTION_TOOLS and value.object_ids:
            self.edits += 1
        self._note(action, value)
        return Outcome(value)

    def _note(self, action: Action, observation: Any, *, refused: bool = False) -> None:
        self.steps.append(
            AgentStep(
                thought=action.thought,
                tool=action.tool[:80],
                arguments=action.arguments,
                observation=to_builtins(observation),
                refused=refused,
            )
        )

    def finish(self, verdict: Verdict, instruction: str, *, land: bool) -> AgentReport:
        """Land the edits when all facts hold, else drop them."""
        report = AgentReport(
            message=verdict.summary,
            done=not verdict.failed,
            steps=self.steps,
            facts=verdict.facts,
            failed=list(verdict.failed),
            edits=self.edits,
            question=verdict.question,
            candidates=verdict.candidates,
        )
        if verdict.failed:
            self.editor.reload()
            return report
        pending = self.editor.state.pending
        if not land or not pending:
            return msgspec.structs.replace(report, object_ids=list(dict.fromkeys(change.id for change in pending)))
        try:
            saved = self.editor.save(instruction)
        except MansionError as error:
            message = f"the edits were refused: {error}"
            return msgspec.structs.replace(report, message=message, done=False, failed=[str(error)])
        return msgspec.structs.replace(report, saved=True, transaction=saved.transaction, object_ids=saved.object_ids)


def _stopped(reason: str) -> Verdict:
    return Verdict(reason, failed=[reason])


def _checked(action: Action) -> Any:
    kind = RUN_TOOLS.get(action.tool)
    if kind is None:
        raise MansionError(
            ErrorCode.NOT_FOUND,
            f"there is no tool {str(action.tool)[:80]!r}; tools are {', '.join(RUN_TOOLS)}",
            path="$.tool",
        )
    if "editor" in action.arguments:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "an agent edits only its own building", path="$.editor")
    return decode(kind, encode(action.arguments))
