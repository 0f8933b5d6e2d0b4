"""A numeral for each of several flats is what one flat has, and then the next."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


def bedrooms(text: str) -> list[tuple[int | None, int | None]]:
    """Return of each kind of flat how many there are and how many bedrooms each has."""
    flats = [fact for fact in read_brief(text, default_knowledge()).rooms if fact.unit or fact.suite]
    return [(flat.count, next((r.count for r in flat.suite if r.room_type == "bedroom"), 0)) for flat in flats]


@pytest.mark.parametrize(
    "words",
    [
        "The three flats have 1, 2 and 3 bedrooms.",
        "The three flats have one, two and three bedrooms respectively.",
        "Three apartments with 1, 2 and 3 bedrooms.",
        "On every floor three flats (1, 2 and 3 bedrooms).",
    ],
)
def test_each_numeral_is_of_one_flat(words: str) -> None:
    assert sorted(bedrooms(f"A block of two storeys. {words}"), key=str) == [(1, 1), (1, 2), (1, 3)]


def test_numerals_that_are_not_one_for_each_flat_are_left() -> None:
    assert (1, 1) not in bedrooms("A block of four flats with 2 or 3 bedrooms.")


@pytest.mark.parametrize("parts", ["one with two bedrooms and one studio", "a studio and one with two bedrooms"])
def test_a_studio_among_flats_is_told_by_its_own_name(parts: str) -> None:
    facts = read_brief(f"Four storeys. 2nd and 3rd floors: two apartments each, {parts}.", default_knowledge())
    assert {room.room_type: room.count for room in facts.rooms} == {"apartment": 1, "studio_apartment": 1}


@pytest.mark.parametrize(
    "words",
    [
        "ground floor flats 2 bedrooms each, top floor flats 3 bedrooms each.",
        "ground floor flats have two bedrooms, and top floor flats have three bedrooms.",
    ],
)
def test_the_flats_of_each_storey_have_their_own_number(words: str) -> None:
    assert bedrooms(f"A villa with two flats per floor on two floors, {words}") == [(2, 2), (2, 3)]
