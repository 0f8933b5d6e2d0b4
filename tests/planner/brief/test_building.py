"""What the brief calls the building."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def read(brief: str) -> BriefFacts:
    return read_brief(brief, default_knowledge())


@pytest.mark.parametrize("kind", ["bakery", "theatre", "farm shop", "hostel"])
def test_building_after_a_kind_of_building_says_nothing_more(kind: str) -> None:
    facts = read(f"A {kind} building of 300 m2.")
    assert facts.building and not facts.unread


@pytest.mark.parametrize(("brief", "like"), [("A canteen building with a kitchen.", "restaurant_building"),
                                             ("An agency building with a print room.", "office")])  # fmt: skip
def test_an_unknown_kind_is_like_its_last_noun_but_building(brief: str, like: str) -> None:
    assert read(brief).building_like == like
