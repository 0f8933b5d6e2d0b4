"""Instructions beside clauses that only tell something, however they are worded, are read for what they ask."""

import pytest

from mansion_editing.instructions.paraphrases.reading import read_in_other_words
from mansion_editing.instructions.statements import Mention, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_in_other_words(text, state)
    assert read.not_understood == []
    asked = [s for s in read.statements if not isinstance(s, Mention)]
    return [type(s)(**{f: getattr(s, f) for f in s.__struct_fields__ if f != "quote"}) for s in asked]


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        (
            "I keep bumping into the sofa in the hall, shove it over to the kitchen.",
            "Move the sofa in the hall to the kitchen.",
        ),
        (
            "Nobody sits on the sofa in the hall, so: off to the kitchen with it!",
            "Move the sofa in the hall to the kitchen.",
        ),
        (
            "Of the three chairs in the hall take two away, whichever you like.",
            "Remove two of the three chairs in the hall.",
        ),
        (
            "It would make sense for the sofa in the hall to be moved to the kitchen.",
            "Move the sofa in the hall to the kitchen.",
        ),
        ("sofa: hall -> kitchen", "Move the sofa from the hall to the kitchen."),
        ("There are three chairs in the hall. Make it two.", "There should be exactly two chairs in the hall."),
        (
            "Swop the sofa and the dining table round please, so that each one stands where the other was.",
            "Swap the sofa and the dining table.",
        ),
    ],
)
def test_what_is_asked_for_is_read(furnished_state: SceneState, said: str, meant: str) -> None:
    assert _asked(said, furnished_state) == _asked(meant, furnished_state)


@pytest.mark.parametrize(
    "said",
    [
        "The rest can go to the attic of my aunt. Remove the sofa.",
        "Put a plant in the hall, I mean in the attic of my aunt.",
        "Would you?",
        "Wherever you find a lamp that I dislike, remove it.",
    ],
)
def test_what_is_not_certain_is_not_half_done(furnished_state: SceneState, said: str) -> None:
    assert read_in_other_words(said, furnished_state).not_understood


def test_what_is_taken_back_is_not_asked_for(furnished_state: SceneState) -> None:
    read = read_in_other_words("Swap the sofa with the table... no. Just remove a chair.", furnished_state)
    assert read.not_understood or [type(s).__name__ for s in read.statements if not isinstance(s, Mention)] == [
        "Remove"
    ]
