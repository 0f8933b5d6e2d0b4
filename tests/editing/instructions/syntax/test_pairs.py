"""Clauses that ask for one thing only together."""

import pytest

from mansion_editing.instructions.paraphrases.reading import read_in_other_words
from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.statements import Move, Remove, SetState
from mansion_editing.instructions.syntax.pairs.joining import with_pairs_joined
from mansion_editing.state import SceneState


@pytest.mark.parametrize(
    ("text", "joined"),
    [
        ("Wheel the chairs out of the hall and put them in the bar.", "move the chairs from the hall to the bar."),
        ("Is there a lamp in every room? Add one where it is missing.", "there should be a lamp in every room."),
        ("Are all fridges closed? If one of them is not, close it.", "all fridges should be closed."),
        ("Sofa where the table is now and the other way round.", "swap the Sofa and the table."),
        ("Five chairs in the hall are too many, leave three.", "there should be exactly three chairs in the hall."),
        ("There are four mugs on the table. One broke, so three.", "there should be exactly three mugs on the table."),
        ("Hall, eight chairs: too many. Halve them.", "there should be exactly 4 chairs in the hall."),
        ("Line the hall with two benches along the wall.", "put two benches along the wall in the hall."),
        ("We do not need the second lamp.", "remove the second lamp."),
        ("Leave only the sofa in the hall.", "remove everything from the hall except the sofa."),
        ("Red mug on the table: swap places with the plate.", "swap the Red mug on the table with the plate."),
        ("There is a desk in the hall but no lamp. Fix that.", "put a lamp on the desk in the hall."),
        ("Two mugs, spread over the tables.", "put Two mugs on the tables."),
        (
            "Give the hall a wooden floor and white walls.",
            "change the floor of the hall to wooden and paint the walls of the hall white.",
        ),
        ("Take the mug off the table.", "Take the mug off the table."),
        ("The hall has five chairs. Take one away.", "The hall has five chairs. Take one away."),
    ],
)  # fmt: skip
def test_clauses_are_put_as_one_order(furnished_state: SceneState, text: str, joined: str) -> None:
    assert with_pairs_joined(text, Lexicon(furnished_state)) == joined


@pytest.mark.parametrize(
    "text", ["No lights on in the kitchen.", "There should be no light on in the kitchen.", "Not a single light on."]
)
def test_lights_that_shall_not_be_on_are_switched_off(furnished_state: SceneState, text: str) -> None:
    (statement,) = read_in_other_words(text, furnished_state).statements
    assert isinstance(statement, SetState) and not statement.value


def test_what_is_told_of_before_is_no_second_request(furnished_state: SceneState) -> None:
    read = read_in_other_words(
        "The chairs in the hall were painted last year. Move one of them to the kitchen.", furnished_state
    )
    moves = [one for one in read.statements if isinstance(one, Move)]
    assert len(moves) == 1 and moves[0].things.amount.number == 1


def test_things_of_rooms_told_by_number_only(furnished_state: SceneState) -> None:
    read = read_in_other_words("Who put mugs in the hall? Remove them.", furnished_state)
    assert [one.things.noun for one in read.statements if isinstance(one, Remove)] == ["mug"]
