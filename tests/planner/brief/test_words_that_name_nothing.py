"""Nouns that name neither a room nor furniture where they stand."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def read(brief: str) -> BriefFacts:
    return read_brief(brief, default_knowledge())


@pytest.mark.parametrize(
    "brief",
    [
        "A house with a kitchen. No garage, they sold the car.",
        "An office with a kitchen, see table.",
        "A fire station with a kitchen. They slide down a pole.",
    ],
)
def test_an_aside_asks_for_no_furniture(brief: str) -> None:
    facts = read(brief)
    assert facts.objects == []
    assert [room.name for room in facts.rooms] == ["kitchen"]


def test_a_display_is_a_thing_and_on_display_is_not() -> None:
    assert [fact.category for fact in read("A shop with ten sofas on display.").objects] == ["sofa"]
    assert len(read("A shop with a sofa and a display.").objects) == 2


def test_book_stacks_that_are_counted_are_shelves() -> None:
    facts = read("A library with 30 book stacks.")
    assert [(fact.category, fact.count) for fact in facts.objects] == [("bookshelf", 30)]


def test_room_for_people_is_a_number_of_seats() -> None:
    facts = read("A school. A canteen with room for 150.")
    assert [room.name for room in facts.rooms] == ["canteen"]
    assert [(fact.noun, fact.count, fact.room) for fact in facts.objects] == [("seats", 150, "canteen")]


@pytest.mark.parametrize(
    "brief",
    [
        "A start-up. Nobody gets a private office.",
        "A start-up. We don't want any private offices.",
        "A start-up with a cafe. They do not want any private office.",
    ],
)
def test_what_nobody_gets_is_not_wanted(brief: str) -> None:
    facts = read(brief)
    assert [name for name, _ in facts.excluded] == ["private_office"]
    assert "private_office" not in [room.name for room in facts.rooms]


@pytest.mark.parametrize("brief", ["An office of two floors.", "An office of about 200 m2 with a cafe."])
def test_an_office_of_a_size_is_the_building(brief: str) -> None:
    assert [name for name, _ in read(brief).building] == ["office"]


def test_the_office_of_somebody_is_a_room() -> None:
    assert [room.name for room in read("A school with the office of the director.").rooms] == ["director_office"]


def test_a_relative_clause_may_stand_before_an_area() -> None:
    rooms = {room.name: room.area for room in read("A house. The kitchen where we all eat, about 25 m2.").rooms}
    assert rooms == {"kitchen": 25.0}
