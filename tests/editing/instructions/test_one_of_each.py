"""Numbers that hold for each of several things, and moves within each of several rooms."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Keep, Move, Remove, Statement
from mansion_editing.state import SceneState


def _on_tables(editor: SceneEditor) -> list[int]:
    """Return how many mugs stand on each dining table."""
    parents = [item.parent for _, item in editor.state.objects() if item.category == "mug"]
    return [parents.count(item.id) for _, item in editor.state.objects() if item.category == "dining_table"]


def test_all_but_one_of_each_leaves_one_on_each(editor: SceneEditor) -> None:
    assert instruct(editor, "Put two mugs on each dining table.").done
    assert min(_on_tables(editor)) >= 2
    assert instruct(editor, "Remove all but one mug from each dining table.").done
    assert _on_tables(editor) == [1, 1]


@pytest.mark.parametrize("text", ["Take one mug away from each dining table.", "Remove a mug from every dining table."])
def test_one_of_each_is_one_from_each(editor: SceneEditor, text: str) -> None:
    assert instruct(editor, "Put two mugs on each dining table.").done
    before = _on_tables(editor)
    assert instruct(editor, text).done
    assert _on_tables(editor) == [count - 1 for count in before]


def test_what_comes_from_several_rooms_stays_in_each(editor: SceneEditor) -> None:
    moved = next(
        s for s in _read("Private office 1: mugs from the dining table onto the desk.", editor) if isinstance(s, Move)
    )
    assert moved.things.place is not None and moved.things.place.rooms is not None
    assert moved.things.place.rooms == moved.place.rooms
    assert moved.place.rooms is not None and moved.place.rooms.words == "private office 1"


def _read(text: str, editor: SceneEditor) -> list[Statement]:
    return read_instruction(text, editor.state).statements


def test_what_is_left_in_there_stays(state: SceneState) -> None:
    removed, kept = read_instruction(
        "Remove the red mug from the cabinet, but leave the blue one in there.", state
    ).statements
    assert isinstance(removed, Remove) and isinstance(kept, Keep)


def test_one_in_each_of_several_rooms_stands_in_all_of_them(editor: SceneEditor) -> None:
    tables = {item.id for _, item in editor.state.objects() if item.category == "dining_table"}
    report = instruct(editor, "Put a bowl on a dining table in the kitchen and the hall.")
    assert report.done
    bowls = [item for _, item in editor.state.objects() if item.category == "bowl"]
    assert sorted(item.room for item in bowls) == ["F1/hall", "F1/kitchen"]
    (new,) = {item.id for _, item in editor.state.objects() if item.category == "dining_table"} - tables
    assert new in report.message


@pytest.mark.parametrize(
    "text",
    [
        "Put a bowl on the dining table in every room.",
        "Each room needs a bowl on the dining table.",
        "A bowl on the dining table in each of the rooms, please.",
    ],
)
def test_rooms_without_such_a_thing_are_told(editor: SceneEditor, text: str) -> None:
    report = instruct(editor, text)
    assert report.done, report.message
    assert "F1/hall" in report.message and "have no dining table" in report.message
    assert sum(item.category == "bowl" for _, item in editor.state.objects()) == 2


@pytest.mark.parametrize(
    ("text", "without"),
    [
        ("Put a bowl on the dining table in the kitchen and the hall.", "F1/hall"),
        ("There should be a bowl on the dining table in the private office and the corridor.", "corridor"),
    ],
)
def test_a_room_that_is_named_must_have_it(editor: SceneEditor, text: str, without: str) -> None:
    before = len([*editor.state.objects()])
    report = instruct(editor, text)
    assert not report.done and "there is no dining table in" in report.message and without in report.message
    assert len([*editor.state.objects()]) == before


def test_one_of_several_in_a_room_is_given_it(editor: SceneEditor) -> None:
    assert instruct(editor, "Add a second dining table to the private office.").done
    report = instruct(editor, "Put a bowl on the dining table in each room.")
    assert report.done, report.message
    assert sum(item.category == "bowl" for _, item in editor.state.objects()) == 2


def test_a_room_called_by_half_its_name_is_not_switched(state: SceneState) -> None:
    assert read_instruction("Switch on the private.", state).not_understood
    assert not read_instruction("Switch on the private office.", state).not_understood


def test_a_side_table_in_a_bedroom_is_its_bedside_table(editor: SceneEditor) -> None:
    assert instruct(editor, "Put a single bed and a side table in private office 1.").done
    assert instruct(editor, "Put a side table in the hall.").done
    assert instruct(editor, "Put a mug on the bedside table.").done
    (mug,) = [item for _, item in editor.state.objects() if item.category == "mug" and "side_table" in str(item.parent)]
    assert mug.room == "F2/private_office_1"


def test_what_is_shared_out_is_so_many_in_all(editor: SceneEditor) -> None:
    assert instruct(editor, "Put two bowls on the dining tables, one each.").done
    assert sum(item.category == "bowl" for _, item in editor.state.objects()) == 2


@pytest.mark.parametrize(
    "text", ["Put three bowls on the dining tables, one each.", "Put two bowls on the sofa, one each."]
)
def test_numbers_that_do_not_fit_each_other_are_refused(editor: SceneEditor, text: str) -> None:
    assert not instruct(editor, text).done
