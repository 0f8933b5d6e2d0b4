"""Places that stand apart from the rest of a clause, and what is told of a thing before "it"."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, SetState
from mansion_editing.state import SceneState


@pytest.mark.parametrize(
    "limit",
    ["not further than 1 metre from", "no more than 1 m away from", "not more than 100 cm from", "within 1 m of"],
)
@pytest.mark.parametrize("joint", [" ", ", "])
def test_the_greatest_distance_is_read(state: SceneState, limit: str, joint: str) -> None:
    instruction = read_instruction(f"add a chair in the kitchen{joint}{limit} the dining table", state)
    assert instruction.not_understood == []
    (statement,) = instruction.statements
    assert isinstance(statement, Add)
    place = statement.place
    assert (place.relation, place.within) == ("near", 1.0) and place.rooms is not None
    assert place.anchor is not None and place.anchor.noun == "dining table"


def test_the_least_distance_is_not_the_greatest(state: SceneState) -> None:
    assert read_instruction("add a chair in the kitchen, not less than 1 m from the dining table", state).not_understood


def test_what_something_faces_may_stand_apart(state: SceneState) -> None:
    instruction = read_instruction("Could we get a chair in the kitchen, facing the fridge?", state)
    assert instruction.not_understood == []
    (statement,) = instruction.statements
    assert isinstance(statement, Add | Ensure) and statement.place.facing is not None
    assert statement.place.facing.noun == "fridge" and statement.place.rooms is not None


def test_the_place_of_it_is_told_once(furnished_state: SceneState) -> None:
    statements = read_instruction("The mug is on the dining table. Open it.", furnished_state).statements
    statement = statements[-1]
    assert isinstance(statement, SetState) and statement.things.place is not None
    assert statement.things.place.anchor is not None and statement.things.place.anchor.place is None


def test_it_is_found_where_it_was_told_to_be(editor: SceneEditor) -> None:
    report = instruct(editor, "The plate is on the dining table. Remove it and open the fridge.")
    assert report.done and report.object_ids == ["F1/kitchen/plate_1", "F1/kitchen/fridge_1"]
