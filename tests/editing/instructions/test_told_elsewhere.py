"""What words say of where things are, what stands there and what is left alone is not guessed otherwise."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Clear, Keep, Move, Remove, SetState
from mansion_editing.state import SceneState


@pytest.mark.parametrize(
    "text",
    [
        "The mug is in the hall. Bring it to the kitchen and put it on the fridge.",
        "Take the plate from the hall to the kitchen and put it in the fridge.",
    ],
)
def test_what_is_elsewhere_than_told_is_not_moved_instead(editor: SceneEditor, text: str) -> None:
    report = instruct(editor, text)
    assert not report.done and report.edits == 0


def test_what_went_there_before_is_left(editor: SceneEditor) -> None:
    assert instruct(editor, "Bring the plate from the hall to the kitchen.").done


@pytest.mark.parametrize("text", ["Take two of the three mugs off the sofa and put them on the dining table upstairs."])
def test_some_of_those_that_are_told_to_be_there_are_no_new_ones(editor: SceneEditor, text: str) -> None:
    report = instruct(editor, text)
    assert not report.done and report.edits == 0


@pytest.mark.parametrize(
    "text",
    [
        "Wipe the dining table in the kitchen, take the vase off.",
        "Put a mug on the dining table in the kitchen. The vase and the plate are not needed, take them off.",
    ],
)
def test_what_is_taken_off_lay_on_what_was_named(furnished_state: SceneState, text: str) -> None:
    gone = [s for s in read_instruction(text, furnished_state).statements if isinstance(s, Remove)]
    assert gone
    for statement in gone:
        place = statement.things.place
        assert place is not None and place.anchor is not None and place.anchor.noun == "dining table"


def test_what_is_taken_away_may_be_anywhere(furnished_state: SceneState) -> None:
    text = "Put a mug on the dining table in the kitchen. Take the plate away."
    gone = [s for s in read_instruction(text, furnished_state).statements if isinstance(s, Remove)]
    assert [s.things.place for s in gone] == [None]


def test_nothing_there_after_what_is_put_elsewhere_empties_nothing(furnished_state: SceneState) -> None:
    instruction = read_instruction("Put two eggs in the fridge, and nothing on the dining table.", furnished_state)
    assert instruction.not_understood
    assert not any(isinstance(s, Clear) for s in instruction.statements)


@pytest.mark.parametrize(
    "text",
    ["Remove the mug from the kitchen and into the hall.", "Take the mug out of the kitchen, then into the hall."],
)
def test_where_something_goes_is_no_second_place_to_remove_it_from(furnished_state: SceneState, text: str) -> None:
    instruction = read_instruction(text, furnished_state)
    gone = [s for s in instruction.statements if isinstance(s, Remove)]
    assert instruction.not_understood or (not gone and any(isinstance(s, Move) for s in instruction.statements))


@pytest.mark.parametrize("text", ["Don't touch the kitchen.", "Leave the kitchen alone."])
def test_a_room_is_left_alone_with_what_is_in_it(furnished_state: SceneState, text: str) -> None:
    statements = read_instruction(f"{text} Remove all mugs.", furnished_state).statements
    kept = [s for s in statements if isinstance(s, Keep)]
    rooms = [s.things.place.rooms for s in kept if s.things.place is not None]
    assert [room.words for room in rooms if room is not None] == ["kitchen"]


@pytest.mark.parametrize(
    "text",
    [
        "Put a plate on the dining table by the window in the kitchen.",
        "Put a plate on the red dining table in the kitchen.",
        "Put a plate on each desk in the kitchen.",
    ],
)
def test_furniture_that_is_not_as_told_is_not_brought(editor: SceneEditor, text: str) -> None:
    report = instruct(editor, text)
    assert not report.done and report.edits == 0


def test_furniture_joins_what_it_cannot_stand_on(furnished_state: SceneState) -> None:
    (added,) = read_instruction("Add one more chair to the dining table in the kitchen.", furnished_state).statements
    assert isinstance(added, Add) and added.place.relation == "beside"


def test_the_storey_that_a_sentence_begins_with_holds_for_both_that_change_places(furnished_state: SceneState) -> None:
    text = "On the ground floor, swap the sofa of the hall with the table of the kitchen."
    (swap,) = read_instruction(text, furnished_state).statements
    for things in (getattr(swap, "one", None), getattr(swap, "other", None)):
        assert things is not None and things.place.rooms.floors == (1,)


def test_an_order_after_then_is_no_aside(furnished_state: SceneState) -> None:
    instruction = read_instruction(
        "Clear the dining table in the kitchen, then put a flurbish mug on it.", furnished_state
    )
    assert instruction.not_understood


@pytest.mark.parametrize("text", ["Turn on boht lights in the kitchen.", "Turn on both lights in the kitchen."])
def test_a_swap_of_letters_is_mended_before_another_word_is_taken(furnished_state: SceneState, text: str) -> None:
    (lit,) = read_instruction(text, furnished_state).statements
    assert isinstance(lit, SetState) and lit.things.amount.number == 2


def test_a_thing_that_is_not_there_owns_nothing(furnished_state: SceneState) -> None:
    assert read_instruction("Turn on the boot lights in the kitchen.", furnished_state).not_understood


def test_it_without_a_noun_is_no_name_for_one(furnished_state: SceneState) -> None:
    assert read_instruction("The sofa is too small. Replace it by a bigger one.", furnished_state).not_understood


def test_the_rest_is_left_also_where_there_is_none(editor: SceneEditor) -> None:
    assert instruct(editor, "Remove the mug in the kitchen. Leave the plate and the rest where they are.").done


@pytest.mark.parametrize("tail", ["neither is the plate", "nor is the plate", "likewise the plate"])
def test_the_same_of_another_thing_is_no_aside(editor: SceneEditor, tail: str) -> None:
    text = f"The mug in the kitchen isn't needed any more, {tail}."
    instruction = read_instruction(text, editor.state)
    gone = [s.things.noun for s in instruction.statements if isinstance(s, Remove)]
    assert instruction.not_understood or gone == ["mug", "plate"]


def test_what_comes_instead_of_something_does_not_go_on_it(furnished_state: SceneState) -> None:
    instruction = read_instruction("Instead of the mug on the dining table in the kitchen put a vase.", furnished_state)
    placed = [s for s in instruction.statements if isinstance(s, Add) and s.place.anchor is not None]
    assert instruction.not_understood or not any(s.place.anchor.noun == "mug" for s in placed if s.place.anchor)


@pytest.mark.parametrize(
    "text",
    [
        "Put a new plate on the dining table in the kitchen and remove the old one.",
        "Put a plate on the dining table in the kitchen, the old one must go.",
        "Add a plate to the dining table in the kitchen. Take the existing plate to the hall.",
        "Put a plate on the dining table in the kitchen and take the old one off it.",
    ],
)
def test_the_old_one_is_that_which_was_there_before(furnished_state: SceneState, text: str) -> None:
    statements = [s for s in read_instruction(text, furnished_state).statements if isinstance(s, Add | Remove | Move)]
    gone, new = statements
    assert isinstance(gone, Remove | Move) and isinstance(new, Add)
    assert gone.things.place == new.place


def test_another_one_goes_where_it_is_told(furnished_state: SceneState) -> None:
    text = "Put a plate on the dining table in the kitchen and remove the old mug upstairs."
    new, gone = read_instruction(text, furnished_state).statements
    assert isinstance(new, Add) and isinstance(gone, Remove)


@pytest.mark.parametrize("verb", ["insists on", "suggests"])
def test_what_somebody_insists_on_is_no_aside(furnished_state: SceneState, verb: str) -> None:
    text = f"Turn off the lights in the kitchen. My boss {verb} a new sofa in the hall."
    assert read_instruction(text, furnished_state).not_understood


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("Replace the chairs in the hall with an armchair.", 1),
        ("Replace all chairs in the hall with an armchair.", 3),
        ("Replace the chairs in the hall with armchairs.", 3),
    ],
)
def test_several_things_make_way_for_one_together(editor: SceneEditor, text: str, number: int) -> None:
    assert instruct(editor, text).done
    came = [item for _, item in editor.state.objects() if item.category == "armchair"]
    assert len(came) == number


def test_another_one_is_not_the_one_that_just_went(editor: SceneEditor) -> None:
    assert instruct(editor, "Move one of the chairs in the hall to the kitchen and another to the corridor.").done
    rooms = [item.room for _, item in editor.state.objects() if item.category == "chair"]
    assert {room: rooms.count(room) for room in rooms} == {"F1/hall": 1, "F1/kitchen": 1, "F2/corridor": 1}


def test_one_thing_does_not_go_to_each_of_several_rooms(editor: SceneEditor) -> None:
    assert not instruct(editor, "Bring the sofa to every room upstairs.").done
    assert not instruct(editor, "Bring a chair from the hall to each room upstairs.").done


def test_one_goes_while_others_stay(editor: SceneEditor) -> None:
    text = "The chairs in the hall: {stay} stay, one goes to the corridor."
    assert not instruct(editor, text.format(stay="three")).done
    assert instruct(editor, text.format(stay="two")).done
    rooms = [item.room for _, item in editor.state.objects() if item.category == "chair"]
    assert {room: rooms.count(room) for room in rooms} == {"F1/hall": 2, "F2/corridor": 1}


def test_a_further_one_that_goes_is_not_the_same_further_on(furnished_state: SceneState) -> None:
    text = "The chairs in the hall: one stays, one goes to the kitchen, one goes to the corridor."
    assert read_instruction(text, furnished_state).not_understood


def test_those_counted_are_counted_before_any_goes(editor: SceneEditor) -> None:
    assert instruct(editor, "Remove the second chair in the hall and the third one.").done
    left = [item.id for _, item in editor.state.objects() if item.category == "chair"]
    assert left == ["F1/hall/chair_1"]
