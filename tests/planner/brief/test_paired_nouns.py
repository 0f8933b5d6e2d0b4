"""Nouns that are told in pairs are counted: flats left and right, changing rooms for home and away."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    "words",
    ["one flat left and one flat right", "a flat on the left and one on the right", "a left flat and a right flat"],
)
def test_flats_by_side_are_two_of_a_kind(words: str) -> None:
    facts = read(f"A block of flats on three floors, on every floor {words}, each with two bedrooms.")
    assert [(room.name, room.count, room.each) for room in facts.rooms] == [("flat", 2, True)]
    assert [(room.name, room.count) for room in facts.rooms[0].suite] == [("bedroom", 2)]


@pytest.mark.parametrize(
    "words", ["home and away changing rooms", "changing rooms (home, away)", "changing rooms for home and away teams"]
)
def test_teams_have_a_changing_room_each(words: str) -> None:
    facts = read(f"A sports hall with {words} and a cafe.")
    assert [(room.name, room.count) for room in facts.rooms] == [("changing_room", 2), ("cafe", 1)]
