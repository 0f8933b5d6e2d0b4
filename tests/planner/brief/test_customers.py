"""Those that a building works for are no part of it."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief


def kinds(brief: str) -> set[str]:
    """Return the kinds of buildings and rooms that a brief is read to ask for."""
    facts = read_brief(brief, default_knowledge())
    return {name for name, _ in facts.building} | {room.room_type for room in facts.rooms}


@pytest.mark.parametrize(
    ("brief", "not_meant"),
    [
        ("A laundry for hotels with a sorting hall and a linen store.", {"hotel", "hotel_room"}),
        ("A central kitchen for schools with a cold store.", {"school", "classroom"}),
        ("An architects' office for hotels and restaurants.", {"hotel", "hotel_room", "restaurant"}),
        ("A consultancy for hospitals on two floors with eight offices.", {"hospital", "patient_room"}),
    ],
)
def test_a_building_does_not_hold_those_that_it_works_for(brief: str, not_meant: set[str]) -> None:
    assert not kinds(brief) & not_meant


@pytest.mark.parametrize(
    ("brief", "near"),
    [
        ("A hotel near the airport with 20 rooms.", {"airport", "departure_lounge"}),
        ("A small house close to the church with two bedrooms.", {"church", "prayer_hall"}),
    ],
)
def test_a_building_does_not_hold_what_it_stands_near(brief: str, near: set[str]) -> None:
    assert not kinds(brief) & near


def test_a_room_near_another_is_read() -> None:
    assert {"library", "cafe"} <= kinds("A school with a library near the cafe.")


@pytest.mark.parametrize(
    ("brief", "meant"),
    [
        ("A 3-storey building for offices.", "office"),
        ("A design for flats with two bedrooms each.", "apartment_building"),
    ],
)
def test_what_a_plain_building_is_for_is_what_it_holds(brief: str, meant: str) -> None:
    assert meant in kinds(brief)
