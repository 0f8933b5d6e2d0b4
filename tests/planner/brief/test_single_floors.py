"""Parts of a building that a brief is about are one storey, and nothing is built around them."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    "text",
    [
        "A cafe in a ground-floor unit of 90 m2 with a kitchen.",
        "Physio clinic. Ground floor unit, 90 m2. A kitchen.",
        "A barbershop, street level premises of 90 m2, with a kitchen.",
    ],
)
def test_a_unit_is_one_storey_of_its_area(text: str) -> None:
    facts = read_brief(text, default_knowledge())
    assert [quantity.value for quantity in facts.floors] == [1.0]
    assert [quantity.value for quantity in facts.area] == [90.0]
    assert [room.room_type for room in facts.rooms] == ["kitchen"]


def test_a_unit_below_others_stays_a_part() -> None:
    facts = read_brief("A shop in the ground floor unit and a flat upstairs.", default_knowledge())
    assert facts.floors == []
