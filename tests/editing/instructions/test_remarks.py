"""Persons and times within a clause are left out; rooms are told by numbers, storeys and which they are not."""

import msgspec
import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Mention, Remove, SetState, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return [
        msgspec.structs.replace(statement, quote="")
        for statement in instruction.statements
        if not isinstance(statement, Mention)
    ]


@pytest.mark.parametrize(
    "text",
    [
        "From next week put a glass on the dining table in the kitchen.",
        "As of Monday put a glass on the dining table in the kitchen.",
        "Put a glass for him on the dining table in the kitchen.",
        "Put a glass for my husband on the dining table in the kitchen.",
        "Put a glass on the dining table in the kitchen until Friday evening.",
    ],
)
def test_persons_and_times_are_left_out(furnished_state: SceneState, text: str) -> None:
    plain = _asked("Put a glass on the dining table in the kitchen.", furnished_state)
    assert _asked(text, furnished_state) == plain


def test_a_room_that_somebody_is_named_in_is_no_person(furnished_state: SceneState) -> None:
    instruction = read_instruction("Put a mug for the guest room on the sofa.", furnished_state)
    assert "guest" in msgspec.json.encode(instruction).decode()


@pytest.mark.parametrize("named", ["private office no. 1", "private office number 1", "private office, no. 1"])
def test_a_number_may_be_called_so(furnished_state: SceneState, named: str) -> None:
    (statement,) = _asked(f"Put a mug on the desk in {named}.", furnished_state)
    assert isinstance(statement, Add) and statement.place.rooms is not None
    assert statement.place.rooms.words == "private office 1"


def test_the_other_room_of_a_kind(furnished_state: SceneState) -> None:
    (statement,) = _asked("Move the mug from private office 1 to the other private office.", furnished_state)
    rooms = getattr(statement, "place", None)
    assert rooms is not None and rooms.rooms.others and rooms.rooms.words == "private office"


def test_there_is_no_other_room_where_none_was_named(editor: SceneEditor) -> None:
    assert not instruct(editor, "Put a plant in the other kitchen.").done


@pytest.mark.parametrize("but", ["except the kitchen", "apart from the kitchen", "but not in the kitchen"])
def test_a_room_may_be_an_exception(editor: SceneEditor, but: str) -> None:
    before = {item.id for _, item in editor.state.objects() if item.category == "ceiling_light"}
    assert before
    report = instruct(editor, f"Remove the ceiling lights in every room {but}.")
    assert before == {item.id for _, item in editor.state.objects() if item.category == "ceiling_light"}
    assert not report.edits


def test_the_numbers_of_an_exception_are_those_of_its_kind(furnished_state: SceneState) -> None:
    text = "Switch on the floor lamp in every private office on the second floor apart from room 1."
    (statement,) = _asked(text, furnished_state)
    assert isinstance(statement, SetState) and statement.things.amount.kind == "all"
    (spared,) = statement.things.beside
    assert spared.place is not None and spared.place.rooms is not None
    assert spared.place.rooms.words == "private office 1" and spared.place.rooms.floors == (2,)


@pytest.mark.parametrize(
    "load", ["with everything on it", "with all that's on it", "along with everything that stands on it"]
)
def test_what_furniture_carries_goes_with_it(furnished_state: SceneState, load: str) -> None:
    asked = _asked(f"Get rid of the dining table in the kitchen, {load}.", furnished_state)
    (statement,) = asked
    assert isinstance(statement, Remove) and statement.things.noun == "dining table"


@pytest.mark.parametrize(
    "rest",
    [
        "Whatever else is on that table stays put.",
        "All the rest on the dining table stays.",
        "Leave whatever else is on it.",
    ],
)
def test_what_else_is_there_stays(furnished_state: SceneState, rest: str) -> None:
    asked = _asked(f"Remove the plate from the dining table in the kitchen. {rest}", furnished_state)
    (statement,) = asked
    assert isinstance(statement, Remove) and statement.things.noun == "plate"


@pytest.mark.parametrize("who", ["where someone is asleep", "where our guest reads", ""])
def test_who_is_in_a_spared_room_is_passed_over(furnished_state: SceneState, who: str) -> None:
    text = f"Remove the floor lamps in every private office on the second floor, apart from private office 1 {who}."
    (statement,) = _asked(text, furnished_state)
    assert isinstance(statement, Remove) and len(statement.things.beside) == 1


def test_what_is_emptied_goes_where_it_is_told(editor: SceneEditor) -> None:
    text = "Clear the dining table in the kitchen. Everything on it goes onto the sofa in the hall."
    assert instruct(editor, text).done
    moved = [item.parent for _, item in editor.state.objects() if item.category in ("plate", "mug")]
    assert moved.count("F1/hall/sofa_1") == 2


def test_one_elsewhere_is_one_of_the_kind_that_was_named(editor: SceneEditor) -> None:
    assert instruct(editor, "Add a chair to the private office, and one in the hall has to go.").done
    chairs = [item.room for _, item in editor.state.objects() if item.category.endswith("chair")]
    assert chairs.count("F1/hall") == 2
