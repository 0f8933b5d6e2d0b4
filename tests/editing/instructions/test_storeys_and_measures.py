"""Storeys told from another place or counted as in Britain, lengths, halves, and rooms joined by "and"."""

import math

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.phrases.storeys import counts_above_ground
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Move
from mansion_editing.state import SceneState


def _rooms_of(editor: SceneEditor, category: str) -> list[str]:
    return sorted(item.room for _, item in editor.state.objects() if item.category == category)


@pytest.mark.parametrize(
    "words",
    [
        "the private office one floor above the kitchen",
        "the room above the kitchen",
        "the private office one flight up",
    ],
)
def test_storeys_are_told_from_another_place(editor: SceneEditor, words: str) -> None:
    report = instruct(editor, f"put an apple on the dining table in {words}")
    assert report.done and _rooms_of(editor, "apple") == ["F2/private_office_1"]


def test_a_thing_goes_up_from_where_it_is(editor: SceneEditor) -> None:
    report = instruct(editor, "Bring the sofa up one floor, into the private office")
    assert report.done and _rooms_of(editor, "sofa") == ["F2/private_office_1"]


def test_the_first_floor_is_above_the_ground_floor_where_a_brief_has_both(furnished_state: SceneState) -> None:
    text = "put an apple on the dining table on the first floor"
    floors = []
    for brief in ("", "Ground floor: hall. First floor: offices."):
        (statement,) = read_instruction(text, furnished_state, brief).statements
        assert isinstance(statement, Add) and statement.place.rooms is not None
        floors.append(statement.place.rooms.floors)
    assert floors == [(1,), (2,)]
    assert not counts_above_ground(text, "Ground floor: hall. Second floor: offices.")


@pytest.mark.parametrize(
    ("text", "metres"),
    [
        ("Move the sofa 40 cm to the left.", 0.4),
        ("move the sofa half a metre to the left", 0.5),
        ("Push the sofa 30 cm closer to the chairs in the hall", 0.3),
        ("slide the sofa to the left by 0.2 m", 0.2),
    ],
)
def test_things_move_by_a_length(editor: SceneEditor, text: str, metres: float) -> None:
    before = editor.state.get("F1/hall/sofa_1")[1]
    report = instruct(editor, text)
    after = editor.state.get("F1/hall/sofa_1")[1]
    assert report.done
    assert math.dist(before.position, after.position) == pytest.approx(metres, abs=0.05)
    assert after.position[0] <= before.position[0]


def test_half_of_the_things_go(editor: SceneEditor) -> None:
    assert instruct(editor, "Remove half of the mugs from the private office.").done
    assert _rooms_of(editor, "mug") == ["F1/kitchen", "F2/private_office_1"]
    alone = instruct(editor, "Remove half of the mugs from the private office.")
    assert not alone.done and "only 1 mug" in alone.message


def test_rooms_joined_by_and_are_all_meant(editor: SceneEditor) -> None:
    assert instruct(editor, "Put a waste bin in the hall and the kitchen").done
    assert _rooms_of(editor, "waste_bin") == ["F1/hall", "F1/kitchen"]


def test_some_of_those_that_are_there_move(editor: SceneEditor) -> None:
    assert instruct(editor, "Two of the three chairs in the hall should be in the kitchen.").done
    assert _rooms_of(editor, "chair") == ["F1/hall", "F1/kitchen", "F1/kitchen"]


def test_what_is_removed_and_put_elsewhere_moves(editor: SceneEditor) -> None:
    assert instruct(editor, "Remove the sofa from the hall and put it in the private office.").done
    assert _rooms_of(editor, "sofa") == ["F2/private_office_1"]


def test_one_that_is_there_already_is_not_fetched_from_elsewhere(editor: SceneEditor) -> None:
    report = instruct(editor, "Put the dining table in the kitchen")
    assert report.done and not report.edits and "already" in report.message


def test_all_but_what_may_stay_goes(editor: SceneEditor) -> None:
    report = instruct(editor, "Clear the dining table in the kitchen: only the plate may stay.")
    assert report.done and _rooms_of(editor, "plate") == ["F1/kitchen"] and "F1/kitchen" not in _rooms_of(editor, "mug")


def test_so_many_are_kept_and_the_others_go(editor: SceneEditor) -> None:
    assert instruct(editor, "Keep one chair in the hall and remove the others").done
    assert _rooms_of(editor, "chair") == ["F1/hall"]


@pytest.mark.parametrize(
    ("text", "material"), [("Lay oak parquet in the kitchen", "parquet"), ("The kitchen gets a grey carpet", "carpet")]
)
def test_floors_are_covered(editor: SceneEditor, text: str, material: str) -> None:
    assert instruct(editor, text).done
    room = editor.state.room("F1/kitchen")
    assert room is not None and (material in room[1].floor_material or "herringbone" in room[1].floor_material)


@pytest.mark.parametrize(
    "words",
    [
        "on the first floor up (level 2)",
        "on the first floor (level 2)",
        "on the first floor up",
        "on the second floor (floor 2)",
        "on the second floor",
    ],
)
def test_a_storey_is_one_that_the_building_has(state: SceneState, words: str) -> None:
    read = read_instruction(
        f"Put an apple on the desk in private office 1 {words}.", state, "Ground floor: hall. First floor: an office."
    )
    (added,) = read.statements
    assert read.not_understood == [] and isinstance(added, Add)
    assert added.place.rooms is not None and added.place.rooms.floors == (2,)


def test_the_way_up_from_a_storey_is_none_of_its_name(state: SceneState) -> None:
    (moved,) = read_instruction("Carry the sofa from the hall on the first floor up to the office.", state).statements
    assert isinstance(moved, Move) and moved.things.place is not None and moved.things.place.rooms is not None
    assert moved.things.place.rooms.floors == (1,)
