"""Homes that stand side by side, each over all storeys."""

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
    "text",
    [
        "Two semi-detached houses, two storeys. Each house has a kitchen downstairs and three bedrooms upstairs.",
        "Two mirrored homes under one roof, two storeys. Each home has a kitchen below, three bedrooms above.",
        "Two identical houses side by side, two floors: each with a kitchen downstairs, three bedrooms upstairs.",
        "Two attached villas on two levels, each with kitchen downstairs, 3 bedrooms upstairs.",
        "Two terraced houses with two storeys. Both have one kitchen downstairs and three bedrooms upstairs.",
    ],
)
def test_the_rooms_are_counted_for_each_home(text: str) -> None:
    facts = read(text)
    assert counts(text) == {"kitchen": 2, "bedroom": 6}
    assert facts.building[0][0] == "house"


@pytest.mark.parametrize("size", ["2 x 110 m2", "110 m2 each", "110 m2 per home"])
def test_the_area_is_that_of_all(size: str) -> None:
    text = f"Two semi-detached homes, two storeys, {size}. Each home has a kitchen below, three bedrooms above."
    assert [area.value for area in read(text).area] == [220.0]


def test_flats_of_a_storey_are_no_homes_side_by_side() -> None:
    text = "Three storeys with two identical flats on each floor. Each flat has a kitchen and three bedrooms."
    assert counts(text) == {"flat": 2}


def test_storeys_are_those_of_all_homes() -> None:
    facts = read("Two semi-detached houses, each with two floors, a kitchen downstairs and three bedrooms upstairs.")
    assert [quantity.value for quantity in facts.floors] == [2.0]
    assert {fact.name: fact.count for fact in facts.rooms} == {"kitchen": 2, "bedroom": 6}


def test_both_halves_of_a_duplex_are_counted() -> None:
    text = (
        "Side-by-side duplex, both halves the same: downstairs kitchen and a half bath, upstairs 2 bedrooms. "
        "So 4 bedrooms in sum."
    )
    assert counts(text) == {"kitchen": 2, "half_bath": 2, "bedroom": 4}


def test_names_of_several_words_stay_whole() -> None:
    facts = read(
        "Two semi-detached houses, each with two floors, kitchen and living room downstairs, two bedrooms upstairs."
    )
    assert [fact.label for fact in facts.rooms] == ["kitchen", "living room", "bedrooms"]


@pytest.mark.parametrize(
    "text",
    [
        "Two-family house, side by side, two storeys, each unit 110 m2. Each: downstairs kitchen; upstairs 3 bedrooms.",
        "2-family home (mirrored), two storeys. Each unit 110 m2. Each unit: downstairs kitchen; upstairs 3 bedrooms.",
    ],
)
def test_a_house_for_two_families_side_by_side_has_the_rooms_of_both(text: str) -> None:
    assert counts(text) == {"kitchen": 2, "bedroom": 6}
    assert [quantity.value for quantity in read(text).area] == [220.0]
