"""What only tells something is left out of a text, in a time that does not grow without bounds."""

import pytest

from mansion_editing.instructions.paraphrases.remarks import without_remarks
from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.state import SceneState


def _left(text: str, state: SceneState) -> list[str]:
    return [left.text for left in without_remarks(text, Lexicon(state), tuple(state.floors))]


@pytest.mark.parametrize("mark", ["(", ", and ", " - "])
def test_a_sentence_of_very_many_parts_is_left_as_it_is(mark: str, furnished_state: SceneState) -> None:
    assert _left(f"Remove the sofa{mark * 5_000}", furnished_state) == []


def test_how_a_thing_shall_be_is_no_remark(furnished_state: SceneState) -> None:
    text = "Put a mug on the sofa in the hall, switched on so I can find it."
    assert "Put a mug on the sofa in the hall." not in _left(text, furnished_state)


def test_what_happened_before_is_one(furnished_state: SceneState) -> None:
    (left,) = _left("Granny can't get up from the sofa any more; put a bench in the kitchen.", furnished_state)
    assert left.strip(" ;") == "put a bench in the kitchen."
