"""Things that are put away: into furniture of their room, never out of the building."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.paraphrases.reading import read_in_other_words
from mansion_editing.instructions.phrases.storage import AWAY
from mansion_editing.instructions.statements import Move
from mansion_editing.state import SceneState


@pytest.mark.parametrize("text", ["Put the plate away.", "Put away the plate.", "Put the mugs on the table away."])
def test_what_is_put_away_is_kept(furnished_state: SceneState, text: str) -> None:
    (statement,) = read_in_other_words(text, furnished_state).statements
    assert isinstance(statement, Move) and statement.place == AWAY


def test_a_room_without_cupboards_is_asked_about(editor: SceneEditor) -> None:
    before = sorted(item.id for _, item in editor.state.objects())
    report = instruct(editor, "Put the mugs in private office 1 away.")
    assert not report.done and "say where" in report.message
    assert sorted(item.id for _, item in editor.state.objects()) == before
