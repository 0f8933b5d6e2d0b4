"""Storeys of which some lie below ground are counted above it and below."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    ("text", "above", "below"),
    [
        ("A research station with three floors, one of them underground.", 2, 1),
        ("An office of six storeys, two of which are below ground.", 4, 2),
        ("A research station with two floors and one basement.", 2, 1),
        ("A research station with two floors, one basement.", 2, 1),
    ],
)
def test_storeys_below_ground_are_basements(text: str, above: int, below: int) -> None:
    facts = read_brief(text, default_knowledge())
    assert [quantity.value for quantity in facts.floors] == [above]
    assert [quantity.value for quantity in facts.basements] == [below]
    assert facts.unread == []


def test_a_heading_underground_is_a_basement() -> None:
    facts = read_brief("An office of two floors. Underground: two archives. Ground: a lobby.", default_knowledge())
    assert [[ref.kind for ref in room.floors] for room in facts.rooms] == [["basement"], ["number"]]
