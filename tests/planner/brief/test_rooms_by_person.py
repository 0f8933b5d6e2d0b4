"""Rooms that people have each."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    "words",
    [
        "the parents and three children each have a bedroom of their own",
        "the parents and the three kids each get a bedroom of their own",
        "three children and the parents each have their own bedroom",
        "the couple and three kids have a bedroom each",
        "the parents, the two kids and a guest each have a bedroom of their own",
    ],
)
def test_there_is_one_for_each(words: str) -> None:
    assert [(fact.name, fact.count) for fact in read(f"A house. Upstairs {words}.").rooms] == [("bedroom", 4)]


def test_what_is_shared_is_one() -> None:
    facts = read("A house. The parents and three children have a kitchen.")
    assert [(fact.name, fact.count) for fact in facts.rooms] == [("kitchen", 1)]
