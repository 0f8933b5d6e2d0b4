"""Sentences that only explain a word ask for nothing."""

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
        ("A monastery with twelve cells. Cell here means a bedroom, nobody gets locked in.", {"cell": 12}),
        ('Offices with five suites. "Suite" is no word for a bedroom.', {"suite": 5}),
        ('A retreat with 12 single rooms. The rooms are "cells" in the leaflet.', {"room": 12}),
        (
            "A bank with a safe room. The safe room is for people to shelter in, not a room for a safe.",
            {"safe_room": 1},
        ),
    ],
)
def test_explanations_build_nothing(text: str, expected: dict[str, int]) -> None:
    assert counts(text) == expected


def test_what_a_plain_room_holds_stays() -> None:
    facts = read('A lab with a visualisation cave. The "cave" is a room with projectors.')
    assert [fact.name for fact in facts.rooms] == ["visualisation_cave"]
    assert [thing.noun for thing in facts.objects] == ["projectors"]


def test_a_meaning_of_what_was_not_named_is_read() -> None:
    assert counts("A house with two bedrooms. That means we also need a study.") == {"bedroom": 2, "study": 1}
