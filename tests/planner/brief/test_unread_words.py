"""Words that ask for a building, and say nothing of it, are not told as ones that were not understood."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def read(brief: str) -> BriefFacts:
    return read_brief(brief, default_knowledge())


@pytest.mark.parametrize(
    "brief",
    [
        "Plan a modern clinic with a reception.",
        "Draw up a studio flat of 60 m2.",
        "Show me a duplex with three bedrooms.",
        "I am looking for an office on one floor.",
        "We bought a duplex: kitchen and living room.",
        "I have a studio flat with one bathroom in mind.",
        "A software company moves into an office building with 2 floors.",
        "Please furnish a flat for a young couple: bedroom, living room, kitchen, bathroom.",
        "We dream of a flat with a study.",
        "My nan needs a bungalow with a kitchen.",
        "A vet's practice with a lab.",
        "Retail: a bookshop with a cafe, high ceilings of 4 m.",
        "A loft on a mezzanine-free single level.",
        "A nursery with a small round table.",
    ],
)
def test_words_that_ask_for_a_building_are_no_wish(brief: str) -> None:
    assert [span.words for span in read(brief).unread] == []


@pytest.mark.parametrize(
    ("brief", "left"),
    [
        ("A flat with a bedroom looking onto the garden.", "looking"),
        ("A gym with a wall that moves.", "moves"),
        ("A school with a young oak in the yard.", "young"),
    ],
)
def test_the_same_words_are_told_where_they_say_how_something_is(brief: str, left: str) -> None:
    assert any(left in span.words for span in read(brief).unread)


@pytest.mark.parametrize(
    "brief",
    [
        "The insurance company wants one floor of offices with 452 m2 on each.",
        "A law firm needs two floors of offices with 452 m2 on each.",
    ],
)
def test_an_area_on_each_of_the_floors_of_rooms_is_that_of_a_storey(brief: str) -> None:
    facts = read(brief)
    assert [quantity.value for quantity in facts.floor_area] == [452.0]
    assert all(room.area is None for room in facts.rooms)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("A bungalow, all doors at least 1 metre wide", "doors at least 1 metre wide"),
        ("A living room with view to the garden", "view to the garden"),
        ("A house with two flats. Both flats have the same plan.", "plan"),
    ],
)
def test_words_that_only_small_words_part_are_told_of_together(text: str, words: str) -> None:
    assert [span.words for span in read_brief(text, default_knowledge()).unread] == [words]
