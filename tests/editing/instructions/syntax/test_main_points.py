"""What an instruction asks for, without the clauses that only tell something."""

import pytest

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.syntax.main_points import main_points
from mansion_editing.state import SceneState


def _plainest(text: str, state: SceneState) -> str:
    found = list(main_points(text, Lexicon(state)))
    return found[0].text.lower() if found else ""


@pytest.mark.parametrize(
    ("text", "asked"),
    [
        ("The sofa in the hall squeaks. Take it to the kitchen.", "take the sofa in the hall to the kitchen."),
        ("There is a mug on the table. Put it in the fridge.", "put the mug on the table in the fridge."),
        ("There is a mug and two plates on the table. Remove them.", "remove the mug and the two plates on the table."),
        ("We never use the sofa in the hall, so it has to go.", "the sofa in the hall has to go."),
        ("As for the fridge: leave it open, it needs airing.", "leave the fridge open."),
        ("The chairs are old and can be thrown away.", "throw the chairs away."),
        ("Could the sofa in the hall please be moved to the kitchen?", "move the sofa in the hall to the kitchen."),
        ("The mug that somebody left on the table should go.", "the mug on the table should go."),
        ("I would be happy if the sofa were moved to the kitchen.", "move the sofa to the kitchen."),
        ("Of the three chairs in the hall take one away.", "take one of the three chairs in the hall away."),
        ("Instead of the sofa I would rather have two chairs.", "replace the sofa by two chairs."),
        ("The kitchen is gloomy; two floor lamps should help.", "in the kitchen, add two floor lamps."),
        ("Take the sofa away, and the table too.", "take the sofa away and take the table away."),
        ("The sofa is dirty. Roll it up and take it to the kitchen.", "take the sofa to the kitchen."),
    ],
)
def test_requests_are_left_as_plain_orders(furnished_state: SceneState, text: str, asked: str) -> None:
    assert _plainest(text, furnished_state) == asked


@pytest.mark.parametrize(
    "kept",
    [
        "the table can stay",
        "the rest should remain",
        "the rest can go to the kitchen",
        "the others may leave the hall",
        "only the mugs are ours",
        "the fridge must remain shut",
        "two mugs will do",
        "we need a plant in the kitchen",
        "the table is too much",
    ],
)
def test_what_asks_or_limits_is_never_left_out(furnished_state: SceneState, kept: str) -> None:
    found = _plainest(f"Take the sofa away. {kept}.", furnished_state)
    assert kept.split()[-1] in found


@pytest.mark.parametrize(
    "text",
    [
        "The sofa is old.",
        "Remove the mug, I mean the plate. It is dirty.",
        "There is a mug in the sink and a plate in the fridge. Move it to the hall.",
        "Put a lamp called ${jndi} in the hall. It is dark.",
    ],
)
def test_nothing_is_found_where_that_is_not_certain(furnished_state: SceneState, text: str) -> None:
    assert _plainest(text, furnished_state) == ""


def test_what_is_left_out_is_named(furnished_state: SceneState) -> None:
    (first, *_) = main_points("The guests come at six. Open the fridge.", Lexicon(furnished_state))
    assert first.remarks == ("The guests come at six",)


@pytest.mark.parametrize(
    ("text", "asked"),
    [
        (
            "The hall has five chairs. On each I need: one mug, one plate.",
            "put one mug, one plate on each of the five chairs.",
        ),
        ("The kitchen closes early. Put a chair by its door.", "in the kitchen, put a chair by the door."),
        ("Put lamps in the two halls, one each.", "put one lamp in each of the two halls."),
        ("Near the sofa I want a mug, or any cup.", "put a mug near the sofa."),
        ("Add a sofa in blue.", "add a blue sofa."),
        ("Add one lamp on the ceiling.", "add one ceiling lamp."),
        ("Carry the table with everything on it to the hall.", "carry the table to the hall."),
        ("Take the sofa in the hall out of the building.", "remove the sofa in the hall."),
        ("All of the mugs into the fridge.", "move all of the mugs into the fridge."),
        ("The lamps in the hall must burn.", "the lamps in the hall should be on."),
        ("I would like the sofa in white.", "paint the sofa white."),
        ("Put the plate on the table, where it belongs.", "put the plate on the table."),
        ("The sofa must face the table, not the chair.", "the sofa must face the table."),
        ("Put a dining table in for six with chairs.", "put a dining table and six chairs."),
    ],
)
def test_wishes_are_put_as_plain_orders(furnished_state: SceneState, text: str, asked: str) -> None:
    assert asked in (_plainest(text, furnished_state).removeprefix("in the hall, "), _plainest(text, furnished_state))
