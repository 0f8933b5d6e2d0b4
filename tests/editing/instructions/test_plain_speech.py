"""Everyday wordings are read as plain requests, and what only looks like them is not."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Keep, Mention, Remove, SetState, Statement
from mansion_editing.state import SceneState


def _bare(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == []
    return [type(s)(**{f: getattr(s, f) for f in s.__struct_fields__ if f != "quote"}) for s in read.statements]


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("In the kitchen, a mug on the dining table would be handy.", "In the kitchen, a mug on the dining table."),
        ("One mug per dining table in the kitchen.", "One mug for each dining table in the kitchen."),
        ("Move the dining table with its plate to the hall.", "Move the dining table and its plate to the hall."),
        ("Keep two of the three chairs in the hall.", "Remove all but two of the three chairs in the hall."),
        (
            "Keep two of the three chairs in the hall, the other one can go to charity.",
            "Remove all but two of the three chairs in the hall.",
        ),
        (
            "Put a mug on the dining table in the kitchen and, next to the mug, a plate.",
            "Put a mug on the dining table in the kitchen and a plate next to the mug.",
        ),
        ("Could the sofa stand next to the fridge?", "The sofa should stand next to the fridge."),
        (
            "We need two more chairs in the kitchen; take them from the hall.",
            "Move two chairs from the hall to the kitchen.",
        ),
        (
            "I don't want any chairs in the hall any more, bring them to the kitchen.",
            "Bring all the chairs in the hall to the kitchen.",
        ),
        (
            "On the dining table in the kitchen belong a vase and a tray.",
            "On the dining table in the kitchen put a vase and a tray.",
        ),
        (
            "The sofa should stand in the kitchen instead, by the window.",
            "The sofa should stand in the kitchen by the window.",
        ),
        (
            "Switch off every ceiling light in the kitchen except one.",
            "Switch off all but one of the ceiling lights in the kitchen.",
        ),
        (
            "In the kitchen lay out two plates on the dining table.",
            "In the kitchen lay two plates on the dining table.",
        ),
        ("Put a mug on the office desk, a plate to its left.", "Put a mug on the office desk, a plate left of it."),
        ("Chairs: only two of them please.", "There should be exactly two chairs."),
        (
            "Two chairs are plenty. Remove the other one in the hall.",
            "Two chairs in the hall are plenty. Remove the other one.",
        ),
        ("I'd put a bin in the hall.", "Put a bin in the hall."),
        ("We would also hang a clock in the kitchen.", "Hang a clock in the kitchen."),
        ("Of the three chairs in the hall only two should remain.", "There should be at most two chairs in the hall."),
        ("I want the sofa out of the hall and into the kitchen.", "Move the sofa from the hall into the kitchen."),
        (
            "Remove the sofa in the hall and put a shelf along the wall in its place.",
            "Remove the sofa in the hall and put a shelf along the wall instead.",
        ),
        (
            "Remove the sofa in the hall. Two armchairs please, in its stead.",
            "Remove the sofa in the hall. Put two armchairs in its place.",
        ),
        ("Clocks missing: 1x kitchen, 2x hall.", "Put 1 clock in the kitchen, 2 clocks in the hall."),
        (
            "Take the chairs out of the hall and furnish it with a bench.",
            "Remove the chairs from the hall and furnish the hall with a bench.",
        ),
        ("chairs from 3 down to 2", "there should be exactly 2 chairs"),
    ],
)
def test_an_everyday_wording_is_read_as_the_plain_one(furnished_state: SceneState, said: str, meant: str) -> None:
    assert _bare(said, furnished_state) == _bare(meant, furnished_state)


@pytest.mark.parametrize(
    "text",
    [
        "Keep two of the three chairs in the hall, the other two can go.",  # one is left
        "Keep two of the three chairs in the hall and paint the other one red.",
    ],
)
def test_other_numbers_than_are_left_remove_nothing(furnished_state: SceneState, text: str) -> None:
    read = read_instruction(text, furnished_state)
    assert read.not_understood or not any(isinstance(s, Remove) for s in read.statements)


@pytest.mark.parametrize(
    "text",
    [
        "Put two office desks into the kitchen, each with its own chair.",
        "Put a mug with its saucer on the dining table in the kitchen.",
        "On Monday comes a visitor.",
    ],
)
def test_new_things_and_visitors_are_not_taken_along(furnished_state: SceneState, text: str) -> None:
    words = [word.text for word in Progress(text, furnished_state).words]
    assert "with" in words or "comes" in words or "come" in words


def test_what_goes_too_is_not_brought_along(furnished_state: SceneState) -> None:
    read = read_instruction("Remove the sofa in the hall. Its cushion can go too.", furnished_state)
    assert read.not_understood or all(isinstance(s, Remove) for s in read.statements)


def test_things_that_are_praised_are_not_asked_for(furnished_state: SceneState) -> None:
    read = read_instruction("The sofa in the hall would be handy.", furnished_state)
    asked = [s for s in read.statements if not isinstance(s, Mention)]
    assert read.not_understood or not asked


def test_an_order_after_what_is_not_to_be_done_stands_by_itself(furnished_state: SceneState) -> None:
    first, second = _bare("Don't remove the fridge, only open it.", furnished_state)
    assert isinstance(first, Keep) and isinstance(second, SetState)


def test_the_one_that_is_left_out_is_the_other_one(furnished_state: SceneState) -> None:
    first = "Switch off every ceiling light in the kitchen except one."
    assert _bare(f"{first} That one should be on.", furnished_state) == _bare(
        f"{first} The other one should be on.", furnished_state
    )


def test_a_sum_of_new_things_is_that_of_all_notes(furnished_state: SceneState) -> None:
    statements = _bare("kitchen: +2 mugs, +1 plate", furnished_state)
    assert [(s.things.noun, s.things.amount.number) for s in statements if isinstance(s, Add)] == [
        ("mug", 2),
        ("plate", 1),
    ]


@pytest.mark.parametrize("reason", ["they need airing", "it needs airing", "we need the floor for the show"])
def test_what_things_need_is_a_reason(editor: SceneEditor, reason: str) -> None:
    report = instruct(editor, f"Open the fridge in the kitchen, {reason}.")
    assert report.done and editor.state.get("F1/kitchen/fridge_1")[1].states["open"]


@pytest.mark.parametrize(
    ("purpose", "told"),
    [
        ("the doctor on night duty can rest there", True),
        ("the doctor can use a lamp", False),
        ("the lamp can be on", False),
    ],
)
def test_what_people_can_do_then_is_a_purpose(furnished_state: SceneState, purpose: str, told: bool) -> None:
    read = read_instruction(f"Put a chair in the kitchen, so that {purpose}.", furnished_state)
    assert (read.not_understood == []) is told


@pytest.mark.parametrize("wish", ["it needs cleaning", "they need emptying"])
def test_what_the_editor_could_do_is_no_reason(editor: SceneEditor, wish: str) -> None:
    assert not instruct(editor, f"Open the fridge in the kitchen, {wish}.").done


def test_what_stays_behind_is_where_things_were_taken_from(furnished_state: SceneState) -> None:
    said = "Move the sofa out of the hall into the kitchen, and put a mug on the chair that stays behind."
    meant = "Move the sofa out of the hall into the kitchen, and put a mug on the chair in the hall."
    assert _bare(said, furnished_state) == _bare(meant, furnished_state)


def test_computers_are_shut_down_and_not_closed(furnished_state: SceneState) -> None:
    (statement,) = _bare("Shut down the computers.", furnished_state)
    assert isinstance(statement, SetState) and (statement.state, statement.value) == ("on", False)


@pytest.mark.parametrize(
    "told",
    [
        "I'd put the bin in the hall.",
        "I'd put a bin in the hall yesterday.",
        "I would put a bin in the hall if there were space.",
        "I'd never put a bin in the hall.",
    ],
)
def test_what_one_would_do_otherwise_or_did_before_is_no_wish(furnished_state: SceneState, told: str) -> None:
    assert not any(isinstance(s, Add) for s in read_instruction(told, furnished_state).statements)


def test_advice_is_taken_though_an_order_follows(furnished_state: SceneState) -> None:
    read = read_instruction("I'd put a bin in the hall. On the office desk lay a book.", furnished_state)
    assert read.not_understood == []
    assert [s.things.noun for s in read.statements if isinstance(s, Add)] == ["bin", "book"]


def test_so_many_remain_of_those_in_the_room_of_the_sentence_before(furnished_state: SceneState) -> None:
    said = "Put a mug on the dining table in the kitchen. And of the six chairs only four should remain."
    meant = "Put a mug on the dining table in the kitchen. And there should be at most four chairs in that room."
    assert _bare(said, furnished_state) == _bare(meant, furnished_state)


@pytest.mark.parametrize("told", ["A vase is missing there.", "A vase is also needed in it."])
def test_what_is_missing_in_a_room_told_before_is_a_wish(furnished_state: SceneState, told: str) -> None:
    read = read_instruction(f"Put a chair in the hall. {told}", furnished_state)
    assert read.not_understood == []
    assert [s.things.noun for s in read.statements if isinstance(s, Add)] == ["chair", "vase"]


@pytest.mark.parametrize(
    "other", ["Remove the other plate in the kitchen.", "Move the rest in the hall to the kitchen."]
)
def test_where_other_things_are_is_not_where_so_many_are_enough(furnished_state: SceneState, other: str) -> None:
    said = Progress(f"Two chairs are plenty. {other}", furnished_state).words
    assert [word.text for word in said[:4]] == ["two", "chair", "are", "plenty"]
