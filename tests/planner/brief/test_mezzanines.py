"""What is on a mezzanine lies on the storey above the ground floor."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    "text",
    [
        "A shop with a mezzanine level holding the office.",
        "A shop. Mezzanine: office.",
        "A shop; the office is on a mezzanine.",
        "A shop with a mezzanine for the office.",
    ],
)
def test_rooms_of_a_mezzanine_are_on_the_second_storey(text: str) -> None:
    office = next(room for room in read_brief(text, default_knowledge()).rooms if room.name == "office")
    assert [(ref.kind, ref.first) for ref in office.floors] == [("number", 2)]


def test_a_mezzanine_that_is_not_wanted_is_no_storey() -> None:
    facts = read_brief("A warehouse with an office. No mezzanine.", default_knowledge())
    assert [room.floors for room in facts.rooms] == [()]
