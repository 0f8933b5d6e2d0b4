"""Compounds that count what a building has, or for whom it is: "a 20-room hotel", "a 60-place nursery"."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("text", "kind", "count"),
    [
        ("a 20-room hotel", "hotel_room", 20),
        ("a 20-room boutique hotel with rooftop bar and spa", "hotel_room", 20),
        ("a three-storey 24-room motel", "hotel_room", 24),
        ("an 80-key business hotel", "hotel_room", 80),
        ("a six-classroom school", "classroom", 6),
        ("a three-bay fire station", "apparatus_bay", 3),
        ("an eight-screen cinema", "cinema_hall", 8),
    ],
)
def test_what_a_building_has_is_counted(text: str, kind: str, count: int) -> None:
    assert (kind, count) in [(room.room_type, room.count) for room in read(text).rooms]


@pytest.mark.parametrize(
    ("text", "noun", "count"),
    [
        ("a 60-place kindergarten", "child", 60),
        ("a 40-pupil village school with a library", "pupil", 40),
        ("a 50-person office", "person", 50),
    ],
)
def test_those_whom_it_serves_are_counted(text: str, noun: str, count: int) -> None:
    assert [(people.noun, people.count) for people in read(text).occupants] == [(noun, count)]


def test_things_are_counted_and_called_as_they_are() -> None:
    thing = read("a 200-seat theatre").objects[0]
    assert (thing.noun, thing.count, thing.span.words) == ("seat", 200, "200-seat")


@pytest.mark.parametrize("text", ["a two-bedroom flat", "a five-room house", "a hotel with 20 rooms"])
def test_homes_and_plain_counts_stay(text: str) -> None:
    facts = read(text)
    assert facts.building
    assert not any(span.words.startswith("20-") for _, span in facts.building)
