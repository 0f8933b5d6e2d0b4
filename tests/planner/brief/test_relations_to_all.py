"""One room beside all others, doors that are asked for, and the words of relations that ask for more than a wall."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def _facts(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("text", "first", "others", "door"),
    [
        ("A flat with a kitchen, a bedroom and a hallway that touches all of them", "hallway", 2, False),
        ("A flat: a kitchen, a bath, a bedroom and a corridor which connects all the rooms", "corridor", 3, True),
    ],
)
def test_a_room_that_reaches_all_others_lies_beside_each(text: str, first: str, others: int, door: bool) -> None:
    facts = _facts(text)
    assert [(fact.first, fact.door) for fact in facts.adjacent] == [(first, door)] * others
    assert len({fact.second for fact in facts.adjacent}) == others


def test_all_rooms_of_a_list_lie_beside_another() -> None:
    facts = _facts("A house. The bedroom, the bathroom and the kitchen all open directly off the hall.")
    assert {fact.first for fact in facts.adjacent} == {"bedroom", "bathroom", "kitchen"}
    assert all(fact.door and fact.second == "hallway" for fact in facts.adjacent)


@pytest.mark.parametrize(
    "text",
    ["A cottage. The kitchen has a stove and a door to the utility room.", "The garage leads directly to the kitchen."],
)
def test_a_way_from_room_to_room_is_a_door(text: str) -> None:
    assert [fact.door for fact in _facts(text).adjacent] == [True]


def test_what_a_relation_asks_beyond_a_wall_is_kept() -> None:
    assert [fact.beyond for fact in _facts("A hotel with a lobby and a bar opposite the lobby").adjacent] == [
        ("opposite",)
    ]


def test_the_rooms_of_one_phrase_are_kept_apart() -> None:
    (fact,) = _facts("A flat. The two bedrooms must not share a wall.").apart
    assert (fact.first, fact.second) == ("bedroom", "bedroom")


_LABS = (
    "A laboratory. Two levels. Ground level: reception, a microbiology lab of 50 m² and a chemistry lab of 60 m²."
    " Those two labs must not share a wall."
)


def test_those_two_labs_are_the_two_named_before() -> None:
    facts = _facts(_LABS)
    assert [(fact.first_name, fact.second_name) for fact in facts.apart] == [("microbiology_lab", "chemistry_lab")]


def test_that_office_is_the_one_named_before() -> None:
    facts = _facts(
        "A home with a caregivers' office, a dining room, a medication room next to that office, and a laundry"
    )
    assert [fact.second_name for fact in facts.adjacent] == ["caregiver_office"]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("Police station with a front desk, three cells. Cells must not share a wall with the front desk.", "wall"),
        ("University with four seminar rooms. Seminar rooms must not be adjacent to the lifts.", "adjacent"),
        ("A flat. Kitchen and living is one space.", "one space"),
        ("An attic with one bed and nothing else", "nothing else"),
    ],
)
def test_what_no_relation_was_made_of_is_told(text: str, words: str) -> None:
    assert any(words in span.words for span in _facts(text).unread)


def test_a_room_between_two_that_are_named_lies_beside_both() -> None:
    rooms = "men's dormitory, women's dormitory, warden's room between the two dormitories"
    facts = _facts(f"Shelter, 2 levels. Upstairs {rooms}.")
    assert {fact.second_name for fact in facts.adjacent} == {"man_dormitory", "woman_dormitory"}
