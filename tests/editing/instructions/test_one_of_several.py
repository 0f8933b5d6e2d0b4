"""Which of several things is meant: by distance, size, what it carries, the word before it."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.doing.gathering import are_together
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import things_of
from mansion_editing.instructions.meaning.measured import compares, told_by_size
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Ensure, Move, Place, Remove, Rooms, Statement, Things
from mansion_editing.state import SceneState
from mansion_editing.tools.relations import relation_holds


def _statement(text: str, state: SceneState) -> Statement:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return instruction.statements[-1]


def test_two_that_are_as_near_are_asked_about(editor: SceneEditor) -> None:
    report = instruct(editor, "Remove the chair in the hall nearest to the sofa.")
    assert not report.done
    assert report.candidates == ["F1/hall/chair_2", "F1/hall/chair_3"]


def test_the_farthest_from_a_thing_goes(editor: SceneEditor) -> None:
    assert instruct(editor, "Remove the chair furthest from the sofa.").done
    assert editor.state.find("F1/hall/chair_1") is None


def test_two_that_are_nearest_to_a_spot_go(editor: SceneEditor) -> None:
    assert instruct(editor, "Take the two chairs nearest the sofa out of the hall.").done
    assert editor.state.find("F1/hall/chair_1") is not None


def test_the_nearest_belongs_to_the_furniture_before_it(furnished_state: SceneState) -> None:
    statement = _statement("Put a mug on the table nearest the door.", furnished_state)
    place = statement.place  # type: ignore[union-attr]
    assert place.anchor.place == Place(relation="nearest", spot="door")


def test_a_room_of_several_words_may_lose_its_last_before_a_thing(furnished_state: SceneState) -> None:
    statement = _statement("Remove the private mugs.", furnished_state)
    assert isinstance(statement, Remove)
    assert [item.room for item in things_of(furnished_state, statement.things, Context())] == 2 * [
        "F2/private_office_1"
    ]


def test_what_carries_something_is_told_by_it(furnished_state: SceneState) -> None:
    statement = _statement("Remove the table with the plate on it.", furnished_state)
    assert isinstance(statement, Remove)
    assert [i.id for i in things_of(furnished_state, statement.things, Context())] == ["F1/kitchen/dining_table_1"]


def test_furniture_beside_other_furniture_is_called_by_it(furnished_state: SceneState) -> None:
    desk_lamp = Things(noun="lamp", owned="desk", definite=True)
    found = things_of(furnished_state, desk_lamp, Context())
    assert [item.id for item in found] == ["F2/private_office_1/floor_lamp_1"]


def test_an_adjective_of_size_tells_one_where_it_is_plain(furnished_state: SceneState) -> None:
    fridge, mug = (furnished_state.get(f"F1/kitchen/{name}_1")[1] for name in ("fridge", "mug"))
    assert told_by_size([mug, fridge], ("tall",)) == [fridge]
    assert told_by_size([mug, mug], ("tall",)) == [mug, mug]


@pytest.mark.parametrize(
    ("hints", "fits"),
    [(("larger",), True), (("smaller",), False), (("taller",), False), ((), True), (("small",), True)],
)
def test_comparatives_compare_with_what_was_there(hints: tuple[str, ...], fits: bool) -> None:
    assert compares(hints, (2.0, 2.0, 1.0), (1.0, 1.0, 1.0)) is fits


def test_one_on_either_side_is_two(furnished_state: SceneState) -> None:
    statements = read_instruction("There should be a chair on either side of the sofa.", furnished_state).statements
    assert [s.place.relation for s in statements if isinstance(s, Ensure)] == ["left", "right"]


def test_scattered_things_are_not_gathered_unasked(editor: SceneEditor) -> None:
    report = instruct(editor, "Move the mugs to the corridor.")
    assert not report.done
    assert {"F1/kitchen", "F2/private_office_1"} <= set(report.candidates)


def test_a_colour_that_the_thing_there_has_not_is_refused(editor: SceneEditor) -> None:
    report = instruct(editor, "Put the yellow sofa in a corner of the hall.")
    assert not report.done
    assert "F1/hall/sofa_1" in report.message


def test_a_second_one_that_is_not_there_is_not_gone_already(editor: SceneEditor) -> None:
    report = instruct(editor, "Remove the second fridge in the kitchen.")
    assert not report.done
    assert "F1/kitchen/fridge_1" in report.message


def test_the_room_that_was_told_of_is_the_one_of_the_next_request(editor: SceneEditor) -> None:
    report = instruct(editor, "We eat in the kitchen. Put a vase on the table.")
    assert report.done, report.message
    assert [name.rsplit("/", 1)[0] for name in report.object_ids] == ["F1/kitchen"]


def test_what_is_kept_inside_goes_into_it(furnished_state: SceneState) -> None:
    statement = _statement("Move the mug in the kitchen to the fridge.", furnished_state)
    assert isinstance(statement, Move) and statement.place.relation == "in"


def test_what_is_put_away_in_furniture_is_no_removal(furnished_state: SceneState) -> None:
    statement = _statement("Put away the mugs in the fridge.", furnished_state)
    assert isinstance(statement, Move) and statement.place.relation == "in"


def test_names_of_several_words_may_have_of(furnished_state: SceneState) -> None:
    statement = _statement("Put a chest of drawers in the hall.", furnished_state)
    assert statement.things.noun == "chest drawer"  # type: ignore[union-attr]
    assert statement.place == Place(rooms=Rooms(words="hall"))  # type: ignore[union-attr]


def test_what_has_no_room_to_turn_moves_a_little(editor: SceneEditor) -> None:
    report = instruct(editor, "Turn the fridge by a quarter.")
    assert report.done, report.message
    fridge = editor.state.get("F1/kitchen/fridge_1")[1]
    assert fridge.rotation in (90.0, 270.0)


def test_things_come_next_to_each_other(editor: SceneEditor) -> None:
    report = instruct(editor, "Put the chairs in the hall next to each other.")
    assert report.done, report.message
    chairs = [editor.state.get(f"F1/hall/chair_{n}")[1] for n in (1, 2, 3)]
    assert are_together(editor.state, chairs)


def test_one_thing_is_not_next_to_itself(editor: SceneEditor) -> None:
    assert not instruct(editor, "Put the sofas in the hall side by side.").done


def test_things_go_so_many_metres_from_others(editor: SceneEditor) -> None:
    report = instruct(editor, "Move the sofa two metres from the chair furthest from it.")
    assert not report.done or relation_holds(
        editor.state, editor.state.get("F1/hall/sofa_1")[1], near="F1/hall/chair_1", apart=1.8, within=2.2
    )


def test_only_so_many_that_stay_send_the_rest_away(editor: SceneEditor) -> None:
    report = instruct(editor, "The chairs in the hall are too many, only two should stay.")
    assert report.done, report.message
    assert [editor.state.find(f"F1/hall/chair_{n}") is not None for n in (1, 2, 3)] == [True, True, False]
