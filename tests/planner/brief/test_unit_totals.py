"""Flats that are summed up, and groups that storeys are."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    "words",
    [
        "Six flats, three floors, two flats on every floor.",
        "Walk-up with six units: three floors, two flats per floor.",
        "Block of six apartments on three floors, two apartments on each floor.",
    ],
)
def test_a_total_is_no_further_flats(words: str) -> None:
    flats = [fact for fact in read(words).rooms if fact.unit]
    assert [(fact.count, fact.each) for fact in flats] == [(2, True)]


@pytest.mark.parametrize(
    "words", ["All three groups are identical", "The three groups are the same", "All groups are alike"]
)
def test_groups_are_the_storeys_that_they_fill(words: str) -> None:
    facts = read(f"Four storeys. Each of floors 2, 3 and 4 is one living group: a lounge and ten rooms. {words}.")
    assert [(copy.first.first, copy.first.last) for copy in facts.copies] == [(2, 4)]
    assert "group" not in [span.words for span in facts.unread]
