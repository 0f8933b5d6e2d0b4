"""How many rooms an advertisement counts, and the rooms that it names among them."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief

KNOWLEDGE = default_knowledge()


def rooms(brief: str, *kinds: str) -> list[tuple[str, int | None]]:
    return [(fact.room_type, fact.count) for fact in read_brief(brief, KNOWLEDGE).rooms if fact.room_type in kinds]


@pytest.mark.parametrize(
    "brief",
    [
        "A 3 BHK flat of 110 m2. Three bedrooms are there.",
        "A three-bedroom house. Upstairs three bedrooms, downstairs a kitchen.",
        "3BHK flat with bedrooms and one kitchen.",
    ],
)
def test_the_same_bedrooms_are_not_counted_twice(brief: str) -> None:
    assert rooms(brief, "bedroom") == [("bedroom", 3)]


def test_bedrooms_of_other_kinds_are_among_those_counted() -> None:
    brief = "A three-bedroom house with a master bedroom and two children's bedrooms."
    assert rooms(brief, "bedroom", "master_bedroom", "childrens_room") == [("master_bedroom", 1), ("childrens_room", 2)]


def test_what_is_left_of_the_number_stays() -> None:
    assert rooms("A three-bedroom house with a bedroom downstairs.", "bedroom") == [("bedroom", 2), ("bedroom", 1)]


def test_bathrooms_of_bedrooms_are_among_those_counted() -> None:
    brief = "A 3 bed / 2 bath house: master bedroom with its own bathroom, two bedrooms, family bathroom."
    assert rooms(brief, "bathroom") == [("bathroom", 1)]


def test_more_bedrooms_than_advertised_are_kept_and_told_of() -> None:
    facts = read_brief("A two-bedroom flat with three bedrooms.", KNOWLEDGE)
    assert [(fact.room_type, fact.count) for fact in facts.rooms] == [("bedroom", 3)]
    assert [span.words for span in facts.unheeded] == ["two-bedroom"]
