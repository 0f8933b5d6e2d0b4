"""What tells which thing is meant is joined to its name, and what it only is like is left out."""

import pytest

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.syntax.appositions import without_appositions
from mansion_editing.instructions.syntax.tagged_words import joined, tagged
from mansion_editing.state import SceneState


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("The mug, the one on the table, must go.", "The mug on the table must go."),
        ("remove two mugs (the ones on the table).", "remove two mugs on the table."),
        ("put a rug in the hall, a blue one.", "put a blue rug in the hall."),
        ("The hall needs a rug. Green, please.", "The hall needs a green rug."),
        ("rooms 1 and 2 get a lamp, same as room 3.", "rooms 1 and 2 get a lamp."),
        ("I want it in the same grey as the ones in the hall.", "I want it in grey."),
        ("the rug should be red instead of blue.", "the rug should be red."),
        ("move the lamp away from the sofa, at least 2 m.", "move the lamp at least 2 m away from the sofa."),
        ("remove one table and the four chairs that go with it.", "remove one table and its four chairs."),
        ("remove the mug, the cup and the plate.", "remove the mug, the cup and the plate."),
    ],
)
def test_appositions_are_joined(furnished_state: SceneState, text: str, plain: str) -> None:
    assert joined(without_appositions(tagged(text, Lexicon(furnished_state)))) == plain
