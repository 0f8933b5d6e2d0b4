"""How many people a room holds."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    "words",
    [
        "where 64 people eat",
        "where 64 can sit",
        "where up to 64 guests can be seated",
        "in which 64 people can sit",
        "where we can seat 64",
        "that seats 64",
        "to seat 64 people",
        "seating 64",
        "with seats for 64",
        "big enough to seat 64",
    ],
)
def test_so_many_seats_are_wanted(words: str) -> None:
    facts = read(f"A community centre with a dining hall {words}, and a kitchen.")
    assert [(wanted.count, wanted.room) for wanted in facts.objects] == [(64, "dining_hall")]
