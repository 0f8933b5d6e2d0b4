"""Clauses that ask for nothing are no wishes; those that may ask for something are told."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def _facts(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def _unread(text: str) -> list[str]:
    return [span.words for span in _facts(text).unread]


@pytest.mark.parametrize(
    "text",
    [
        "A clinic for a group of doctors.",
        "A library with an office for the librarian and a toilet.",
        "My aunt lives alone and wants a studio flat of 64 m2.",
        "Grandparents, parents and a baby share this flat: three bedrooms and two bathrooms.",
        "A house. Lunch is brought over from town every day.",
        "A flat with a study, as I'm on calls all day.",
        "A rowing club with a bar upstairs. Stairs only, members are fit.",
        "A gym with two studios. The studio must not touch the office, it's too noisy.",
        "A motel for our horror game with ten guest rooms.",
        "Delivery robots will be evaluated in an office of two floors.",
        "A house with five bedrooms where the robot can train the climbing of stairs.",
        "A supermarket to evaluate the transport of goods by a robot.",
        "A bus station for a small town.",
        "Our town needs a school with a music room.",
        "One-person studio flat, nothing fancy.",
        "Programme: an office with a reception.",
        "We are letting a studio flat, a modern one, with one bathroom.",
    ],
)
def test_what_asks_for_nothing_is_not_told(text: str) -> None:
    assert [words for words in _unread(text) if words != "only"] == []


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("A school where robots need wide doors.", "wide doors"),
        ("A house. It has a sea view.", "sea view"),
        ("A flat with a bedroom. We want silence.", "silence"),
        ("A laboratory with four labs. Each lab gets two fume hoods and an eye wash.", "eye wash"),
        ("An office for five partners.", "five partners"),
        ("Our cricket pavilion burnt down. The new one has a bar.", "cricket pavilion burnt"),
        ("A house. The windows should be large.", "windows should be large"),
    ],
)
def test_what_may_ask_for_something_is_told(text: str, left: str) -> None:
    assert left in _unread(text)


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("Our team of twenty wants an office with a server room.", 20),
        ("An office for a company of twelve.", 12),
        ("We are five and need a flat with four bedrooms.", 5),
        ("A flat for two flatmates, each with a bedroom of their own.", 2),
        ("A one-person studio flat with a bathroom.", 1),
    ],
)
def test_how_many_people_there_are_is_a_wish(text: str, count: int) -> None:
    assert [fact.count for fact in _facts(text).occupants] == [count]
    assert _unread(text) == []
