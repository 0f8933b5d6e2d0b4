"""What a brief says of a building's form."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief


@pytest.mark.parametrize("what", ["house", "dwelling", "home", "cottage"])
def test_a_terraced_home_stands_in_a_row_and_does_not_step_back(what: str) -> None:
    assert read_brief(f"A terraced {what} with three storeys.", default_knowledge()).setback == []


def test_a_terraced_office_steps_back() -> None:
    assert read_brief("A terraced office building of six storeys.", default_knowledge()).setback != []


@pytest.mark.parametrize(
    "thing", ["an L-shaped sofa", "a rectangular table", "a U-shaped reception desk", "an L-shaped kitchen"]
)
def test_the_form_of_a_thing_or_a_room_is_no_outline(thing: str) -> None:
    assert read_brief(f"A cottage with {thing} in it.", default_knowledge()).shapes == []
    assert read_brief("An L-shaped cottage with a sofa in it.", default_knowledge()).shapes != []
