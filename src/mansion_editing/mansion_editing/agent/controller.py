"""The ReAct controller (supplement, D.1): runs a policy against the tools within bounds, and lands the result whole."""

from typing import Any, Final

from mansion_editing.agent.protocol import Action, Outcome, Policy, Verdict
from mansion_editing.editor import ACTION_TOOLS, PERCEPTION_TOOLS, SceneEditor
from mansion_msgs_py.codec import decode, encode, to_builtins
from mansion_msgs_py.editing import AgentReport, AgentStep
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["AGENT_TOOLS", "MOST_EDITS", "MOST_STEPS", "run_agent"]

AGENT_TOOLS: Final[dict[str, type[Any]]] = {**PERCEPTION_TOOLS, **ACTION_TOOLS}
"""All that an agent may call; walls, doors and cores have no tool, files and other buildings neither."""

MOST_STEPS: Final = 400
MOST_EDITS: Final = 120
MOST_REFUSED: Final = 8


def run_agent(editor: SceneEditor, policy: Policy, what: str) -> AgentReport:
    """Let a policy work until it ends or a bound is reached.

    Parameters
    ----------
    editor : SceneEditor
        With nothing waiting to be saved.
    what : str
        The instruction, for the log.

    Returns
    -------
    AgentReport
        Edits land as one transaction when every fact holds, and not at all otherwise.

    Raises
    ------
    MansionError
        ``CONFLICT`` when edits wait in the editor already.
    """
    if editor.state.pending:
        raise MansionError(ErrorCode.CONFLICT, "edits wait to be saved; save or undo them first")
    autosave, editor.autosave = editor.autosave, False
    run = _Run(editor)
    try:
        editor.reload()
        verdict = run.drive(policy)
        return run.finish(verdict, what, land=autosave)
    finally:
        editor.autosave = autosave
        if autosave and editor.state.pending:
            editor.reload()


class _Run:
    """The steps of one run."""

    def __init__(self, editor: SceneEditor) -> None:
        self.editor = editor
        self.steps: list[AgentStep] = []
        self.edits = 0
        self.refused = 0

    def drive(self, policy: Policy) -> Verdict:
        """Answer a policy's actions until it returns."""
        try:
            action = next(policy)
            while True:
                if len(self.steps) >= MOST_STEPS or self.edits >= MOST_EDITS:
                    return _stopped(f"stopped after {len(self.steps)} steps, {self.edits} edits")
                if self.refused >= MOST_REFUSED:
                    return _stopped(f"stopped: {self.refused} actions outside the tools")
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

    def _note(self, action: Action, observation: Any, refused: bool = False) -> None:
        self.steps.append(
            AgentStep(
                thought=action.thought,
                tool=action.tool[:80],
                arguments=action.arguments,
                observation=to_builtins(observation),
                refused=refused,
            )
        )

    def finish(self, verdict: Verdict, what: str, *, land: bool) -> AgentReport:
        """Land the edits when all facts hold, else drop them."""
        failed = list(verdict.failed)
        report = AgentReport(
            message=verdict.summary,
            done=not failed,
            steps=self.steps,
            facts=verdict.facts,
            failed=failed,
            edits=self.edits,
        )
        if failed:
            self.editor.reload()
        elif land and self.editor.state.pending:
            try:
                saved = self.editor.save(what)
            except MansionError as error:
                report.done, report.failed = False, [str(error)]
                report.message = f"the edits were refused: {error}"
                return report
            report.saved, report.transaction = True, saved.transaction
            report.object_ids = saved.object_ids
        elif self.editor.state.pending:
            report.object_ids = list(dict.fromkeys(c.id for c in self.editor.state.pending))
        return report


def _stopped(reason: str) -> Verdict:
    return Verdict(reason, failed=[reason])


def _checked(action: Action) -> Any:
    kind = AGENT_TOOLS.get(action.tool)
    if kind is None:
        raise MansionError(
            ErrorCode.NOT_FOUND,
            f"there is no tool {str(action.tool)[:80]!r}; tools are {', '.join(AGENT_TOOLS)}",
            path="$.tool",
        )
    if "editor" in action.arguments:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "an agent works in its own building alone", path="$.editor")
    return decode(kind, encode(action.arguments))
