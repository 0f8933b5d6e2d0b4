"""Objects before who shall do something with them, several subjects after a modal verb, and parts that open."""

import pytest

from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Clear, Keep, Mention, Move, Remove, Rooms, SetState, Statement, Swap
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == []
    return [statement for statement in read.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("The mugs she may keep", Keep),
        ("The mugs we still need", Keep),
        ("the mugs we dont need no more", Remove),
        ("The mugs you can take away", Remove),
        ("The mugs you may move to the study", Move),
    ],
)
def test_an_object_may_stand_before_its_clause(furnished_state: SceneState, text: str, kind: type[Statement]) -> None:
    (fridge, told) = _asked(f"Open the fridge. {text}.", furnished_state)
    assert isinstance(fridge, SetState) and isinstance(told, kind)
    assert isinstance(told, Keep | Remove | Move) and told.things.noun == "mug" and told.quote == text


def test_a_thing_that_is_named_first_is_what_the_pronoun_means(furnished_state: SceneState) -> None:
    (move,) = _asked("the chair from the hall, bring it to the study", furnished_state)
    assert isinstance(move, Move) and move.things.noun == "chair" and move.place.rooms == Rooms(words="study")


def test_what_you_cannot_do_with_an_object_is_no_request(furnished_state: SceneState) -> None:
    assert read_instruction("Open the fridge. The mugs you cannot take away.", furnished_state).not_understood


def test_several_subjects_follow_a_modal_verb(furnished_state: SceneState) -> None:
    text = "Could the mug and the plate from the table please stand on the desk?"
    moves = _asked(text, furnished_state)
    assert [move.things.noun for move in moves if isinstance(move, Move)] == ["mug", "plate"]
    sources = [move.things.place.anchor for move in moves if isinstance(move, Move) and move.things.place is not None]
    assert [source.noun for source in sources if source is not None] == ["table", "table"]


def test_its_door_is_the_furniture_itself(furnished_state: SceneState) -> None:
    (emptied, opened) = _asked("empty the fridge and leave its door open", furnished_state)
    assert isinstance(emptied, Clear) and isinstance(opened, SetState) and opened.things.refers == "last"


@pytest.mark.parametrize("tail", ["without touching what is on it", "without moving the lamp"])
def test_what_is_not_to_be_touched_stays(furnished_state: SceneState, tail: str) -> None:
    (move, keep) = _asked(f"put the mug on the desk in the study {tail}", furnished_state)
    assert isinstance(move, Move) and isinstance(keep, Keep)


def test_one_on_another_storey_is_of_the_furniture_named_before(furnished_state: SceneState) -> None:
    (swap,) = _asked("swap the mug on the upstairs desk with the plate on the downstairs one", furnished_state)
    assert isinstance(swap, Swap) and not isinstance(swap.other, Rooms) and swap.other.place is not None
    anchor = swap.other.place.anchor
    assert anchor is not None and anchor.noun == "desk"


def test_none_but_those_of_a_room_go(furnished_state: SceneState) -> None:
    (gone,) = _asked("no chairs upstairs except the one in the study", furnished_state)
    assert isinstance(gone, Remove) and [spared.noun for spared in gone.things.beside] == ["chair"]


def test_what_comes_out_of_one_room_and_into_another_moves(furnished_state: SceneState) -> None:
    (move,) = _asked("the chair must come out of the hall and into the study", furnished_state)
    assert isinstance(move, Move) and move.place.rooms == Rooms(words="study")
