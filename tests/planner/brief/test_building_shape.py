"""What a brief says of a building's form."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief


@pytest.mark.parametrize("what", ["house", "dwelling", "home", "cottage"])
def test_a_terraced_home_stands_in_a_row_and_does_not_step_back(what: str) -> None:
    assert read_brief(f"A terraced {what} with three storeys.", default_knowledge()).setback == []


def test_a_terraced_office_steps_back() -> None:
    assert read_brief("A terraced office building of six storeys.", default_knowledge()).setback != []
