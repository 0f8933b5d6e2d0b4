"""Groups of furniture that are told part by part."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Mention, Rooms, SetState, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == [], read.not_understood
    return [statement for statement in read.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize(
    ("text", "nouns"),
    [
        ("Make a reading corner in the hall: rug, armchair and a floor lamp.", ["rug", "armchair", "floor lamp"]),
        ("We need a waiting area for visitors in the hall: two chairs and a side table.", ["chair", "side table"]),
        ("Create a quiet nook in the hall with an armchair and a rug.", ["armchair", "rug"]),
        ("A small play corner in the hall: a table and two stools, please.", ["table", "stool"]),
        ("In the hall set up one more workstation: desk, office chair.", ["desk", "office chair"]),
    ],
)
def test_each_part_comes_into_the_room(furnished_state: SceneState, text: str, nouns: list[str]) -> None:
    parts = _asked(text, furnished_state)
    assert all(isinstance(part, Add) and part.place.rooms == Rooms(words="hall") for part in parts)
    assert [part.things.noun for part in parts if isinstance(part, Add)] == nouns


def test_parts_are_at_each_other_and_in_a_state(editor: SceneEditor) -> None:
    text = "Make us a reading corner in the hall: an armchair, and a floor lamp beside the armchair, lamp on."
    report = instruct(editor, text)
    assert report.done, report.message
    (lamp,) = [item for _, item in editor.state.objects() if item.category == "floor_lamp" and item.room == "F1/hall"]
    assert lamp.states["on"]


def test_a_part_carries_what_is_told_to_be_on_it(editor: SceneEditor) -> None:
    text = (
        "We need one additional workplace in the private office: an office desk with a laptop and a mouse on it,"
        " and an office chair to it."
    )
    report = instruct(editor, text)
    assert report.done, report.message
    (new,) = [item.id for _, item in editor.state.objects() if item.id.endswith("office_desk_2")]
    carried = {item.category for _, item in editor.state.objects() if item.parent == new}
    assert carried == {"laptop", "mouse"}


def test_small_parts_share_the_place_that_the_last_of_them_has(furnished_state: SceneState) -> None:
    bowl, mugs = _asked("Set up a tea station in the kitchen: a bowl and four mugs on the table.", furnished_state)
    assert isinstance(bowl, Add) and isinstance(mugs, Add) and bowl.place == mugs.place


def test_a_set_is_one_thing(furnished_state: SceneState) -> None:
    added = _asked("Put crayons on the dining table in the kitchen.", furnished_state)
    assert [part.things.amount.number for part in added if isinstance(part, Add)] == [1]
    assert not any(isinstance(part, SetState) for part in added)


@pytest.mark.parametrize(
    "text",
    [
        "Make a reading corner in the hall.",
        "We need two additional workplaces in the hall: a desk and a chair.",
        "Make a corner in the hall for the sofa.",
        "Set up a tea station: a kettle and four mugs.",
    ],
)
def test_what_belongs_to_it_must_be_told(editor: SceneEditor, text: str) -> None:
    before = len([*editor.state.objects()])
    assert not instruct(editor, text).done
    assert len([*editor.state.objects()]) == before
