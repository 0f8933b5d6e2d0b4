"""Rooms that a brief gives a number each."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    "words",
    [
        "three halls with 120, 80 and 60 seats",
        "3 halls (120, 80 and 60 seats)",
        "three halls for 120, 80 and 60 people",
        "three halls seating 120, 80 and 60 people",
        "three halls of 120, 80 and 60 seats",
    ],
)
def test_each_hall_has_its_seats(words: str) -> None:
    facts = read(f"A cinema with {words}, and a bar.")
    assert {wanted.room: wanted.count for wanted in facts.objects} == {"hall_1": 120, "hall_2": 80, "hall_3": 60}
    assert [fact.name for fact in facts.rooms if fact.name != "bar"] == ["hall_1", "hall_2", "hall_3"]


def test_as_many_numbers_as_rooms_are_needed() -> None:
    facts = read("A cinema with three halls with 120 and 80 seats")
    assert [(fact.name, fact.count) for fact in facts.rooms] == [("hall", 3)]


@pytest.mark.parametrize("words", ["bays for three engines", "bays for three vehicles", "bays for three trucks"])
def test_there_is_a_bay_for_each(words: str) -> None:
    facts = read(f"A fire station with {words} and a dormitory")
    assert next((fact.room_type, fact.count) for fact in facts.rooms) == ("apparatus_bay", 3)
