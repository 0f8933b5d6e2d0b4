"""What comes in and what goes, and what things could be."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Paint, Remove
from mansion_editing.state import SceneState


@pytest.mark.parametrize(
    "text",
    [
        "In the hall the sofa goes, a bench with a pillow on it and an armchair come in.",
        "The sofa in the hall goes; a bench with a pillow on it and an armchair should come in.",
    ],
)
def test_new_things_come_in_where_others_go(state: SceneState, text: str) -> None:
    instruction = read_instruction(text, state)
    gone, *new = instruction.statements
    assert not instruction.not_understood and isinstance(gone, Remove) and gone.things.place is not None
    assert [s.things.noun for s in new if isinstance(s, Add)] == ["bench", "pillow", "armchair"]


def test_new_things_come_into_a_room(state: SceneState) -> None:
    said = read_instruction("A bench and a floor lamp should come into the hall.", state).statements
    assert len(said) == 2
    assert all(isinstance(s, Add) and s.place.rooms is not None and s.place.rooms.words == "hall" for s in said)


def test_a_new_thing_after_a_removal_is_no_other_that_goes(state: SceneState) -> None:
    instruction = read_instruction("The sofa in the hall goes, a mug too.", state)
    assert instruction.not_understood or not any(
        isinstance(s, Remove) and s.things.noun == "mug" for s in instruction.statements
    )


@pytest.mark.parametrize(
    "text", ["Could the chairs in the hall be red ones?", "Could the chairs in the hall be painted red?"]
)
def test_what_could_be_of_another_colour_is_painted(state: SceneState, text: str) -> None:
    (painted,) = read_instruction(text, state).statements
    assert isinstance(painted, Paint) and painted.colour == "red" and painted.things.plural


def test_what_could_be_there_is_brought(editor: SceneEditor) -> None:
    (there,) = read_instruction("Could there be two mugs on the sofa in the hall?", editor.state).statements
    assert isinstance(there, Ensure) and there.things.amount.number == 2
    report = instruct(editor, "Could a mug be left on the sofa in the hall?")
    assert report.done and any(item.category == "mug" and item.room == "F1/hall" for _, item in editor.state.objects())


def test_the_place_a_sentence_begins_with_is_where_things_go_from(editor: SceneEditor) -> None:
    report = instruct(editor, "In the private office the dining table must go.")
    assert report.done and editor.state.find("F1/kitchen/dining_table_1") is not None
    assert editor.state.find("F2/private_office_1/dining_table_1") is None


def test_a_small_thing_is_put_beside_another_on_a_table(state: SceneState) -> None:
    (added,) = read_instruction("Put a plate on the table in the kitchen next to the mug.", state).statements
    assert isinstance(added, Add) and added.place.relation == "beside"
