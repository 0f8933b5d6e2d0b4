"""Carry out an instruction in words, read by rules or by a language model."""

from mansion_editing.editor import SceneEditor
from mansion_msgs_py.editing.instructions import AgentReport
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.late_imports import importing

__all__ = ["instruct"]


def instruct(editor: SceneEditor, instruction: str, planner: str = "rules", *, partly: bool = False) -> AgentReport:
    """Carry out an instruction; its edits land together or not at all.

    Parameters
    ----------
    planner : {"rules", "llm"}
    partly : bool
        The rules do what they can of it and say what they did not; all or nothing otherwise.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for another planner, ``UNAVAILABLE`` for a model that is not configured, ``CONFLICT`` when
        edits wait to be saved, ``CANCELED`` where it was cancelled (see `SceneEditor.cancellable`).
    """
    if planner == "rules":
        with importing:
            from mansion_editing.instructions.conversation import brief_of
            from mansion_editing.instructions.paraphrases.reading import read_in_other_words
            from mansion_editing.instructions.run import carry_out

        read = read_in_other_words(instruction, editor.state, brief_of(editor))
        return carry_out(editor, read, instruction, partly=partly)
    if planner == "llm":
        with importing:
            from mansion_editing.instructions.by_model.carrying_out import carry_out_with_model
            from mansion_llm import LlmClient

        return carry_out_with_model(LlmClient.from_environment(cancelled=editor.cancelled), editor, instruction)
    raise MansionError(ErrorCode.INVALID_PAYLOAD, f"no planner {planner!r}; use rules or llm", path="$.planner")
