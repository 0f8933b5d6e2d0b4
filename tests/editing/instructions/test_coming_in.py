"""What comes in and what goes, and what things could be."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Furnish, Mention, Move, Paint, Remove, Rename
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


def test_a_room_that_a_list_turns_into_another_is_called_so(editor: SceneEditor) -> None:
    text = "Turn the hall into a waiting room: the sofa goes with all that's on it, a bench comes in, the chairs stay."
    assert instruct(editor, text).done
    kinds = [item.category for _, item in editor.state.objects() if item.room == "F1/hall"]
    assert "sofa" not in kinds and kinds.count("bench") == 1 and kinds.count("chair") == 3
    room = editor.state.room("F1/hall")
    assert room is not None and room[1].name == "Waiting room"


def test_a_room_made_into_another_without_a_list_is_furnished(state: SceneState) -> None:
    (furnished,) = read_instruction("Make the hall into an office.", state).statements
    assert isinstance(furnished, Furnish) and furnished.kind == "office"


@pytest.mark.parametrize("room", ["the hall", "the room called Hall"])
def test_from_now_on_a_room_is_what_it_is_called(state: SceneState, room: str) -> None:
    (renamed,) = read_instruction(f'From now on {room} is "Studio".', state).statements
    assert isinstance(renamed, Rename) and renamed.name == "Studio"


def test_its_chair_is_no_kind_that_the_building_has_none_of(state: SceneState) -> None:
    instruction = read_instruction("Remove the sofa in the hall and its chair.", state)
    assert not any(isinstance(s, Remove) and s.things.noun == "sofa chair" for s in instruction.statements)


def test_a_list_about_other_rooms_turns_none_into_another(state: SceneState) -> None:
    text = "Turn the hall into an office. Remove the mug from the kitchen, put a plate on the table in the kitchen."
    statements = read_instruction(f"{text} The sofa in the bedroom stays.", state).statements
    assert [s.kind for s in statements if isinstance(s, Furnish)] == ["office"]


def test_several_new_things_go_somewhere(furnished_state: SceneState) -> None:
    read = read_instruction("A plate and two forks go on the dining table in the kitchen.", furnished_state)
    assert read.not_understood == []
    plate, forks = read.statements
    assert isinstance(plate, Add) and plate.things.noun == "plate" and plate.place.anchor is not None
    assert isinstance(forks, Add) and forks.things.amount.number == 2 and forks.place == plate.place


@pytest.mark.parametrize(
    "text",
    [
        "A plate and two forks go.",
        "A plate and two forks do not go on the dining table in the kitchen.",
        "Neither a plate nor two forks go on the dining table in the kitchen.",
        "A plate and the mug go on the dining table in the kitchen.",
    ],
)
def test_what_goes_away_or_nowhere_is_not_brought(furnished_state: SceneState, text: str) -> None:
    assert read_instruction(text, furnished_state).not_understood


def test_a_room_that_is_too_small_is_why_something_goes_elsewhere(furnished_state: SceneState) -> None:
    text = "There is no desk and the kitchen is too narrow for one, so put a desk in the hall."
    read = read_instruction(text, furnished_state)
    (desk,) = [statement for statement in read.statements if not isinstance(statement, Mention)]
    assert read.not_understood == []
    assert isinstance(desk, Add) and desk.place.rooms is not None and desk.place.rooms.words == "hall"


@pytest.mark.parametrize("number", ["bear", "bears"])
def test_what_stands_for_that_after_a_thing(furnished_state: SceneState, number: str) -> None:
    text = f"The teddy {number} what sits on the sofa in the hall must go on the dining table in the kitchen."
    read = read_instruction(text, furnished_state)
    (move,) = read.statements
    assert read.not_understood == []
    assert isinstance(move, Move) and move.things.place is not None and move.things.place.anchor is not None
