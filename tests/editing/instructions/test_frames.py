"""Frames around requests, which are read as the plain requests that they stand for."""

import msgspec
import pytest

from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Mention, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == [], read.not_understood
    asked = [statement for statement in read.statements if not isinstance(statement, Mention)]
    return [msgspec.structs.replace(statement, quote="") for statement in asked]


@pytest.mark.parametrize(
    ("framed", "plain"),
    [
        ("It is the kitchen that needs a clock.", "The kitchen needs a clock."),
        ("All I want is one more chair in the hall.", "I want one more chair in the hall."),
        ("What the hall needs is a rug.", "The hall needs a rug."),
        ("What's missing in the hall is a rug.", "There should be a rug in the hall."),
        ("A plate is all that should be on the dining table.", "The only thing on the dining table should be a plate."),
        (
            "The only thing that should stay on the dining table is the plate.",
            "The only thing on the dining table should be the plate.",
        ),
        ("How about moving a chair from the hall to the kitchen?", "Move a chair from the hall to the kitchen."),
        ("What about a plant in the kitchen?", "I would like a plant in the kitchen."),
        ("Why don't we put a plant in the kitchen?", "Put a plant in the kitchen."),
        ("Would it be ok to put a plant in the kitchen?", "Put a plant in the kitchen."),
        ("I was wondering if you could put a plant in the kitchen.", "Put a plant in the kitchen."),
        ("The plate would look better on the shelf.", "The plate should be on the shelf."),
        ("No office should be without a clock.", "Every office should have a clock."),
        ("Turn on the lamp, not the radio, in the kitchen.", "Turn on the lamp in the kitchen."),
        ("Instead of the plate put a mug.", "Put a mug instead of the plate."),
        ("I'm missing a rug in the hall.", "I want a rug in the hall."),
        (
            "There is a plate in the kitchen that nobody likes. Remove it.",
            "There is a plate in the kitchen. Remove it.",
        ),
        ("Turn the sofa so that it faces the TV.", "The sofa should face the TV."),
        ("Of course, put a plant in the kitchen.", "Put a plant in the kitchen."),
        ("Put a plant in the kitchen, as discussed.", "Put a plant in the kitchen."),
        ("Put a plant, preferably next to the table, in the kitchen.", "Put a plant next to the table in the kitchen."),
        ("Move the chairs form the hall to the kitchen.", "Move the chairs from the hall to the kitchen."),
        ("Call the hall 'Foyer'.", 'Call the hall "Foyer".'),
        ("Kitchen: plates -1, mugs +1", "Kitchen: 1 plate less, 1 mug more"),
        ("Bring the number of chairs in the hall up to six.", "Increase the number of chairs in the hall to six."),
    ],
)
def test_a_frame_asks_for_what_the_plain_request_does(furnished_state: SceneState, framed: str, plain: str) -> None:
    assert _asked(framed, furnished_state) == _asked(plain, furnished_state)


def test_what_several_things_are_like_is_not_left_out(furnished_state: SceneState) -> None:
    assert read_instruction("Remove the chairs that nobody likes.", furnished_state).not_understood


def test_so_many_as_are_missing_are_a_number_in_all(furnished_state: SceneState) -> None:
    text = "If the hall has fewer than five chairs, add as many as are missing so there are five."
    (when,) = _asked(text, furnished_state)
    then = getattr(when, "then", when)
    assert isinstance(then, Ensure) and then.things.amount.number == 5


def test_each_of_its_own_is_a_new_one(furnished_state: SceneState) -> None:
    (one,) = _asked("Give every dining table its own plant.", furnished_state)
    assert isinstance(one, Add) and one.each and one.place.relation == "on" and not one.things.definite


@pytest.mark.parametrize(
    ("framed", "plain"),
    [
        ("Kitchen: minus one plate, plus one mug", "Kitchen: 1 plate less, 1 more mug"),
        (
            "For each of the chairs in the hall add a plant next to it.",
            "Add a plant next to each of the chairs in the hall.",
        ),
        ("The kitchen needs the following: two mugs on the table.", "The kitchen: two mugs on the table."),
        (
            "Put two mugs on the dining table and a plate beside them. Actually, forget the plate.",
            "Put two mugs on the dining table.",
        ),
        ("Turn the sofa by 180 degrees so it faces the other way.", "Turn the sofa by 180 degrees."),
        ("Put a plate in the kitchen and dont touch anything else in there.", "Put a plate in the kitchen."),
    ],
)
def test_notes_and_afterthoughts_ask_for_the_same(furnished_state: SceneState, framed: str, plain: str) -> None:
    assert _asked(framed, furnished_state) == _asked(plain, furnished_state)


def test_a_list_after_all_rooms_tells_which(furnished_state: SceneState) -> None:
    (bins,) = _asked("Make sure that every room has a bin: the hall and the kitchen.", furnished_state)
    assert isinstance(bins, Ensure) and bins.place.rooms is not None and bins.place.rooms.number == 2
