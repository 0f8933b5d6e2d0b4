"""How many of what is there stay, go or are enough."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Move, Remove, SetState
from mansion_editing.state import SceneState


def _left(editor: SceneEditor, category: str, room: str) -> int:
    return sum(item.category == category and item.room == room for _, item in editor.state.objects())


@pytest.mark.parametrize(
    "text",
    [
        "All but two chairs out of the hall.",
        "Every chair but two has to leave the hall.",
        "Every chair except two must go from the hall.",
        "Remove all chairs but two from the hall.",
        "Only two chairs should remain in the hall.",
        "Only two chairs may stay in the hall.",
        "Two chairs are enough in the hall.",
        "In the hall two chairs will do.",
        "Remove every second chair from the hall.",
        "Remove every other chair from the hall.",
    ],
)
def test_two_of_three_chairs_are_left(editor: SceneEditor, text: str) -> None:
    report = instruct(editor, text)
    assert report.done and _left(editor, "chair", "F1/hall") == 2


@pytest.mark.parametrize(
    "text",
    [
        "Two chairs are not enough in the hall.",
        "Four chairs should stay in the hall.",
        "All chairs but two are in the hall.",
        "Two chairs should remain in the hall.",
    ],
)
def test_no_chair_goes_where_none_is_too_many(editor: SceneEditor, text: str) -> None:
    instruct(editor, text)
    assert _left(editor, "chair", "F1/hall") >= 3


def test_only_what_is_named_is_left_out(editor: SceneEditor) -> None:
    report = instruct(editor, "Remove all mugs but the one in the kitchen.")
    assert report.done and report.object_ids == ["F2/private_office_1/mug_1", "F2/private_office_1/mug_2"]


def test_things_taken_out_go_and_things_carried_over_move(state: SceneState) -> None:
    (gone,) = read_instruction("All chairs out of the hall!", state).statements
    (moved,) = read_instruction("Two chairs out of the hall and into the kitchen.", state).statements
    assert isinstance(gone, Remove) and isinstance(moved, Move)
    assert moved.place.rooms is not None and moved.place.rooms.words == "kitchen"


def test_what_stays_is_the_thing_itself(editor: SceneEditor) -> None:
    report = instruct(editor, "Empty the fridge. Leave the fridge itself.")
    assert report.done and editor.state.find("F1/kitchen/fridge_1") is not None


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("There should be no more than two chairs in the hall.", 2),
        ("There should not be more than two chairs in the hall.", 2),
        ("There must not be fewer than four chairs in the hall.", 4),
        ("There should be no fewer than four chairs in the hall.", 4),
        ("There should be no chair in the hall.", 0),
        ("There are too many chairs in the hall. Two would be enough.", 2),
        ("In the hall there are three chairs. Remove one of them.", 2),
        ("A chair is missing in the hall, add one.", 4),
        ("The hall has no plant. Put one there.", 3),
    ],
)
def test_limits_and_what_is_told_of_numbers(editor: SceneEditor, text: str, number: int) -> None:
    report = instruct(editor, text)
    assert report.done and _left(editor, "chair", "F1/hall") == number


def test_what_a_room_lacks_is_not_asked_for_by_that_alone(state: SceneState) -> None:
    assert read_instruction("The hall has no plant.", state).not_understood
    assert read_instruction("A chair is missing in the hall.", state).not_understood


def test_one_elsewhere_is_another_one(editor: SceneEditor) -> None:
    report = instruct(editor, "Put a plant in the hall and one in the kitchen.")
    assert report.done and {name.rsplit("/", 1)[0] for name in report.object_ids} == {"F1/hall", "F1/kitchen"}


def test_two_go_to_one_room_and_one_to_another(editor: SceneEditor) -> None:
    report = instruct(editor, "Bring two chairs from the hall to the kitchen and one to the private office.")
    rooms = [item.room for _, item in editor.state.objects() if item.category == "chair"]
    assert report.done and rooms.count("F1/kitchen") == 2 and rooms.count("F2/private_office_1") >= 1
    assert _left(editor, "chair", "F1/hall") == 0


def test_what_is_not_there_is_not_taken_from_elsewhere(editor: SceneEditor) -> None:
    report = instruct(editor, "Move a mug from the hall to the private office.")
    assert not report.done


@pytest.mark.parametrize(("words", "number"), [("for four", 4), ("for four more people", 5)])
def test_a_table_is_set_for_so_many(editor: SceneEditor, words: str, number: int) -> None:
    report = instruct(editor, f"Set the dining table in the kitchen {words}: four plates and four forks.")
    assert report.done and _left(editor, "plate", "F1/kitchen") == number


def test_what_comes_in_the_place_of_another_stands_there(editor: SceneEditor) -> None:
    report = instruct(editor, "Remove the fridge and put a plant in its place.")
    before = "F1/kitchen/fridge_1"
    assert report.done and before in report.object_ids and editor.state.find(before) is None


def test_one_that_stays_off_is_off(state: SceneState) -> None:
    statements = read_instruction("Switch on the lamp in the hall, the one in the kitchen stays off.", state).statements
    assert [(s.state, s.value) for s in statements if isinstance(s, SetState)] == [("on", True), ("on", False)]


@pytest.mark.parametrize(
    "text",
    [
        "There should only be two chairs in the hall, at the moment there are three.",
        "There should only be two chairs in the hall, right now it's three.",
        "Three chairs in the hall is one too many.",
        "Three chairs in the hall are one too many: take one away.",
        "Three chairs in the hall is a trip hazard, two are plenty.",
    ],
)
def test_what_is_there_is_told_beside_what_shall_be(editor: SceneEditor, text: str) -> None:
    assert instruct(editor, text).done and _left(editor, "chair", "F1/hall") == 2


def test_the_spare_ones_are_those_beyond_the_number(state: SceneState) -> None:
    said = read_instruction("Two chairs are enough in the hall; put the spare ones in the kitchen.", state).statements
    (moved,) = [statement for statement in said if isinstance(statement, Move)]
    assert moved.things.amount.kind == "all_but" and moved.things.amount.number == 2
    assert read_instruction("Put the spare ones in the kitchen.", state).not_understood


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("Put a mug on the dining table in the kitchen for each of the four people who sit there.", 4),
        ("Put two mugs for each of three guests on the dining table in the kitchen.", 6),
    ],
)
def test_so_many_for_each_person(state: SceneState, text: str, number: int) -> None:
    instruction = read_instruction(text, state)
    (added,) = [statement for statement in instruction.statements if isinstance(statement, Add)]
    assert not instruction.not_understood and added.things.amount.number == number and not added.each


@pytest.mark.parametrize("total", [", two in all", " (two in total)", ", two altogether"])
def test_a_total_is_the_number_of_places(state: SceneState, total: str) -> None:
    (added,) = read_instruction(f"Put a candle on each dining table{total}.", state).statements
    assert isinstance(added, Add) and added.each and added.place.anchor is not None
    assert added.place.anchor.amount.of == 2


def test_what_a_room_has_nothing_for_is_needed_there(state: SceneState) -> None:
    said = read_instruction("The hall has nowhere to hang coats, it needs a coat rack.", state).statements
    (added,) = [statement for statement in said if isinstance(statement, Add)]
    assert added.place.rooms is not None and added.place.rooms.words == "hall"


def test_out_with_a_list_and_what_alone_stays(state: SceneState) -> None:
    text = "Out with the chairs, the mugs and the sofa; only the fridge may stay."
    instruction = read_instruction(text, state)
    assert not instruction.not_understood
    assert [type(statement).__name__ for statement in instruction.statements] == ["Remove"] * 3 + ["Keep"]


def test_exactly_holds_for_all_of_a_list(state: SceneState) -> None:
    text = "On the dining table in the kitchen there should be exactly two plates, two forks and a mug."
    said = read_instruction(text, state).statements
    amounts = [(s.things.amount.kind, s.things.amount.number) for s in said if isinstance(s, Ensure)]
    assert amounts == [("exactly", 2), ("exactly", 2), ("exactly", 1)]


@pytest.mark.parametrize(
    "text",
    [
        "Set the dining table in the kitchen for six people: one plate and one glass each.",
        "Lay the dining table in the kitchen for six with a plate and a glass per person.",
        "Set the dining table in the kitchen for six guests: a plate and a glass for each guest.",
    ],
)
def test_each_of_so_many_people_gets_one(furnished_state: SceneState, text: str) -> None:
    read = read_instruction(text, furnished_state)
    there = [s for s in read.statements if isinstance(s, Ensure)]
    assert read.not_understood == []
    assert [(s.things.noun, s.things.amount.number) for s in there] == [("plate", 6), ("glass", 6)]


@pytest.mark.parametrize("text", ["Prepare the kitchen: one chair each.", "Equip the kitchen with a chair each."])
def test_each_of_nobody_told_is_not_passed_over(furnished_state: SceneState, text: str) -> None:
    assert read_instruction(text, furnished_state).not_understood


@pytest.mark.parametrize(
    "text",
    [
        "The hall needs five chairs rather than three.",
        "I want five chairs in the hall instead of three.",
        "Put five chairs rather than three in the hall.",
        "There should be five chairs rather than the three in the hall.",
    ],
)
def test_so_many_rather_than_another_number_are_there_afterwards(editor: SceneEditor, text: str) -> None:
    assert instruct(editor, text).done
    assert _left(editor, "chair", "F1/hall") == 5


def test_fewer_rather_than_more_are_left(editor: SceneEditor) -> None:
    assert instruct(editor, "The hall needs two chairs instead of three.").done
    assert _left(editor, "chair", "F1/hall") == 2


def test_in_place_of_another_number_each_has_so_many(furnished_state: SceneState) -> None:
    read = read_instruction("Put two mugs instead of one on every dining table.", furnished_state)
    (there,) = [s for s in read.statements if isinstance(s, Ensure)]
    assert read.not_understood == []
    assert there.place.anchor is not None and there.place.anchor.each
    assert (there.things.amount.kind, there.things.amount.number) == ("exactly", 2)


def test_more_of_a_general_name_are_of_the_kind_that_is_there(editor: SceneEditor) -> None:
    assert instruct(editor, "Put a yoga mat in the hall.").done
    assert instruct(editor, "Add two more mats to the hall.").done
    assert _left(editor, "yoga_mat", "F1/hall") == 3
