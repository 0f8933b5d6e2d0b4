"""What a building is converted from."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    "words",
    [
        "Conversion of one bay of a former textile mill into",
        "Converting an old barn into",
        "Transformation of a school into",
        "Refurbishment of a church hall into",
    ],
)
def test_the_old_building_is_none_of_the_new(words: str) -> None:
    facts = read(f"{words} a home with two bathrooms.")
    assert facts.building[0][0] == "house"
    assert [fact.name for fact in facts.rooms] == ["bathroom"]


def test_what_is_done_in_a_hall_is_no_room() -> None:
    facts = read("A loft. Everything happens in one hall of 100 m2 - cooking, sleeping, a table with six chairs.")
    assert [fact.name for fact in facts.rooms] == ["hall"]
