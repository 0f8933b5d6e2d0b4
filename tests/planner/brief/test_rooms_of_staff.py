"""Rooms of staff whom a list of rooms names in their place."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    "words",
    [
        "ten offices plus the director",
        "ten offices and additionally the director",
        "ten offices and the director",
        "ten offices + the director",
    ],
)
def test_who_is_added_to_rooms_has_one(words: str) -> None:
    facts = read(f"An office on two floors. Second floor: {words}.")
    assert [(fact.name, fact.count) for fact in facts.rooms] == [("office", 10), ("director", 1)]


def test_two_may_be_joined_and_lie_side_by_side() -> None:
    facts = read("Second floor: two labs plus the director and her assistant, whose offices must adjoin.")
    assert [fact.name for fact in facts.rooms] == ["lab", "director", "assistant"]
    assert [(fact.first_name, fact.second_name) for fact in facts.adjacent] == [("director", "assistant")]


def test_what_is_said_later_is_of_the_same_room() -> None:
    facts = read("Offices: ten offices plus the dean, and the dean sits next to the dean's secretariat.")
    assert [(fact.first_name, fact.second_name) for fact in facts.adjacent] == [("dean", "dean_secretariat")]


@pytest.mark.parametrize(
    "text", ["An office for the manager and the secretary", "The director wants two meeting rooms"]
)
def test_who_works_there_asks_for_no_room(text: str) -> None:
    assert not {"manager", "secretary", "director"} & {fact.name for fact in read(text).rooms}


def test_who_opens_the_list_of_a_storey_has_an_office() -> None:
    facts = read_brief("Job centre, 3 floors; 3rd level director, secretary, 12 offices, archive.", default_knowledge())
    assert [(room.name, room.count) for room in facts.rooms[:2]] == [("director", 1), ("secretary", 1)]
