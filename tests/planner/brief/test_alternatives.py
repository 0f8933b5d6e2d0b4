"""Of what a brief leaves open, the first is built."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def counts(text: str) -> dict[str, int | None]:
    """Return how many rooms of each name are told."""
    return {fact.name: fact.count for fact in read(text).rooms}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("House: either three bedrooms and a study or four bedrooms, you decide.", {"bedroom": 3, "study": 1}),
        ("Police station with five cells (either five or six, five is enough).", {"cell": 5}),
        ("House with either a sauna or a small gym in the cellar.", {"sauna": 1}),
    ],
)
def test_the_first_is_chosen(text: str, expected: dict[str, int]) -> None:
    assert counts(text) == expected


def test_where_both_would_be_stays() -> None:
    room = read("House with either a sauna or a gym in the cellar.").rooms[0]
    assert [ref.kind for ref in room.floors] == ["basement"]


def test_either_storey_is_no_choice_of_rooms() -> None:
    assert counts("House on two floors with toilets on either floor.")["toilet"] is None
