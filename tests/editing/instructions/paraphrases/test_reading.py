"""Instructions that are not understood as they stand are read in other words, and never as what they do not ask."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.paraphrases.reading import read_in_other_words
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Keep, Mention, Statement
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
            "The sofa makes a dreadful noise, can somebody please whisk it away from the hall?",
            "Remove the sofa from the hall.",
        ),
        ("Ahead of the wedding could you put a plant in the hall?", "Put a plant in the hall."),
        ("Granny can't get up from the sofa any more; put a bench in the kitchen.", "Put a bench in the kitchen."),
        ("Plonk a bench in the kitchen.", "Put a bench in the kitchen."),
        ("Lug the sofa from the hall to the kitchen.", "Move the sofa from the hall to the kitchen."),
        ("The three chairs in the hall are wobbly and can be removed.", "Remove the three chairs in the hall."),
    ],
)
def test_what_is_put_another_way_is_understood(furnished_state: SceneState, said: str, meant: str) -> None:
    assert read_instruction(said, furnished_state).not_understood
    assert _asked(said, furnished_state) == _asked(meant, furnished_state)


@pytest.mark.parametrize(
    "said",
    [
        "Admire the sofa in the hall.",
        "Seeing as we are eight, there ought to be a plate for everybody on the dining table.",
        "Everything has to be off in the kitchen at night: the sofa.",
        "Frobnicate the chairs in the hall.",
        "Without the sofa put a bench in the hall.",
    ],
)
def test_what_is_not_certain_is_not_understood(furnished_state: SceneState, said: str) -> None:
    assert read_in_other_words(said, furnished_state).not_understood


def test_the_answer_says_how_it_was_read_and_what_was_left_out(editor: SceneEditor) -> None:
    report = instruct(editor, "Granny can't get up from the sofa any more; plonk a chair in the kitchen.")
    assert report.done
    assert "not acted on: 'Granny cannot get up from the sofa any more'" in report.message
    assert "read as: 'put a chair in the kitchen.'" in report.message


def test_what_is_added_up_to_a_total_takes_nothing_away(editor: SceneEditor) -> None:
    report = instruct(editor, "Add one more chair so that there are two.")
    assert not report.done
    assert "already" in report.message


def test_nothing_that_remains_is_taken_away(furnished_state: SceneState) -> None:
    read = read_in_other_words("Make sure that no plate remains on the dining table in the kitchen.", furnished_state)
    assert [s.things.amount.kind for s in read.statements if isinstance(s, Ensure)] == ["none"]


def test_none_that_is_moved_stays(furnished_state: SceneState) -> None:
    read = read_in_other_words(
        "None of the chairs in the hall are to be moved; a fourth one must be added.", furnished_state
    )
    kept, added = read.statements
    assert isinstance(kept, Keep)
    assert kept.things.amount.kind == "all"
    assert isinstance(added, Add)
    assert added.things.amount.kind == "more"
    assert added.place.rooms is not None
    assert added.place.rooms.same


@pytest.mark.parametrize(
    "said",
    [
        "Could we fit a piano into the hall, what do you think?",
        "Fold the whole house in half and stuff it into the kitchen.",
    ],
)
def test_neither_questions_nor_orders_are_left_out(furnished_state: SceneState, said: str) -> None:
    assert read_in_other_words(said, furnished_state).not_understood
