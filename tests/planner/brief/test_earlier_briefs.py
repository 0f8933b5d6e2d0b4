"""What is said of earlier briefs and wishes is not built."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    "first",
    [
        "Scratch what I sent on Monday (the five-bedroom thing with the pool).",
        "Forget my last mail, the one with the pool.",
        "Please ignore everything we sent yesterday.",
        "Disregard the earlier version with a pool and a gym.",
        "Scrap my first draft (pool, gym).",
        "A villa with a pool and five bedrooms. Forget all of the above.",
    ],
)
def test_an_earlier_brief_asks_for_nothing(first: str) -> None:
    facts = read(f"{first} New version: a house with two bedrooms.")
    assert [(fact.name, fact.count) for fact in facts.rooms] == [("bedroom", 2)]
    assert facts.unread == []


@pytest.mark.parametrize(
    "text",
    [
        "Please ignore my last mail, we now want a house with two bedrooms.",
        "Forget my email: a house with two bedrooms.",
    ],
)
def test_what_follows_in_the_same_sentence_counts(text: str) -> None:
    assert [(fact.name, fact.count) for fact in read(text).rooms] == [("bedroom", 2)]


def test_a_room_is_withdrawn_on_its_own() -> None:
    facts = read("A house with two bedrooms and a sauna. Forget the sauna.")
    assert [fact.name for fact in facts.rooms] == ["bedroom"]


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
