"""Areas that each storey has, and areas that are the same without a plan that is."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    "text",
    [
        "An observatory of two storeys, 60 m2 on either.",
        "A language school / 2 fl / each 60 m2 / a lift",
        "A house of two storeys, 60 m2 on both.",
        "Housing on two levels with the same 60 m2 on each.",
    ],
)
def test_each_storey_has_the_area(text: str) -> None:
    facts = read_brief(text, default_knowledge())
    assert [quantity.value for quantity in facts.floor_area] == [60.0]
    assert facts.copies == []
