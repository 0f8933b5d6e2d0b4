"""Ways that shall stay free, as they are said of the way itself."""

import pytest

from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Mention, Reach, Remove, Rooms, Things
from mansion_editing.state import SceneState


@pytest.mark.parametrize(
    "text",
    [
        "The way from the hall to the dining table must stay free.",
        "The way from the hall to the dining table must not be blocked.",
        "Constraint: the route from the hall to the dining table stays clear.",
        "Keep the path from the hall to the dining table clear.",
        "Make sure the way from the hall to the dining table remains unobstructed.",
        "The way between the hall and the dining table has to be kept free.",
    ],
)
def test_a_way_that_shall_stay_free_can_be_gone(furnished_state: SceneState, text: str) -> None:
    read = read_instruction(text, furnished_state)
    (way,) = [statement for statement in read.statements if not isinstance(statement, Mention)]
    assert read.not_understood == []
    assert isinstance(way, Reach) and isinstance(way.start, Rooms) and way.start.words == "hall"
    assert isinstance(way.end, Things) and way.end.noun == "dining table"


def test_it_may_follow_what_is_put_there(furnished_state: SceneState) -> None:
    text = "Put a plant next to the dining table in the kitchen, but the way from the hall to the table must stay free."
    read = read_instruction(text, furnished_state)
    assert read.not_understood == []
    assert [type(statement) for statement in read.statements] == [Add, Reach]


@pytest.mark.parametrize(
    "text",
    [
        "The way from the hall to the dining table is blocked.",
        "The way from the hall to the dining table must not be free.",
        "The way from the hall to the dining table must never stay free.",
        "The way from the hall to the dining table must stay free of plates.",
        "The way must stay free.",
    ],
)
def test_no_other_saying_of_a_way_is_read_so(furnished_state: SceneState, text: str) -> None:
    assert read_instruction(text, furnished_state).not_understood


@pytest.mark.parametrize(
    "freely",
    [
        "without anything blocking her",
        "without anything in the way",
        "without bumping into anything",
        "with nothing in the way",
        "without having to squeeze past anything",
        "unhindered",
    ],
)
def test_a_way_is_gone_without_hindrance(furnished_state: SceneState, freely: str) -> None:
    text = f"Check that she can get from the hall to the kitchen {freely}."
    read = read_instruction(text, furnished_state)
    (way,) = read.statements
    assert read.not_understood == [] and isinstance(way, Reach)
    assert isinstance(way.end, Rooms) and way.end.words == "kitchen"


def test_a_way_without_a_certain_thing_is_not_passed_over(furnished_state: SceneState) -> None:
    text = "Check that she can get from the hall to the kitchen without the sofa."
    assert read_instruction(text, furnished_state).not_understood


@pytest.mark.parametrize("check", ["check that she can get there", "see to it that the chairs stay"])
def test_a_check_takes_up_nothing(furnished_state: SceneState, check: str) -> None:
    read = read_instruction(f"Take the sofa out of the hall and {check}.", furnished_state)
    assert read.not_understood or any(isinstance(s, Remove) and s.things.noun == "sofa" for s in read.statements)
