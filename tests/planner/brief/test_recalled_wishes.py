"""What a writer recalls of earlier wishes is not built."""

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
    "recalled",
    [
        "I had written two meeting rooms before, one is enough.",
        "First I said two meeting rooms.",
        "There was talk of a second meeting room but forget it.",
    ],
)
def test_the_present_wish_holds(recalled: str) -> None:
    assert counts(f"Parish hall with a kitchen and one meeting room. {recalled}") == {"kitchen": 1, "meeting_room": 1}


@pytest.mark.parametrize(
    "recalled", ["Before I asked for storage, now it is not needed.", "At first I wanted storage but forget it."]
)
def test_what_is_given_up_is_refused(recalled: str) -> None:
    facts = read(f"House with two bedrooms. {recalled}")
    assert [fact.name for fact in facts.rooms] == ["bedroom"]
    assert [name for name, _ in facts.excluded] == ["storage"]


def test_a_new_number_is_kept() -> None:
    assert counts("House. First I wanted three bedrooms, but now four bedrooms.")["bedroom"] == 4
