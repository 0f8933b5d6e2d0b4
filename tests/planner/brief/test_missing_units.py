"""Areas whose unit is left out, or written as metres."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    ("brief", "areas"),
    [
        (
            "Office. 4 meeting rooms: two small ones of 10 m², one of 18, one of 30. Kitchenette.",
            [(2, 10.0), (1, 18.0), (1, 30.0), (1, None)],
        ),
        ("Flat: 2 bedroom (one 14m, other 11m), 1 bathroom", [(1, 14.0), (1, 11.0), (1, None)]),
    ],
)
def test_every_area_of_a_list_has_the_unit_of_one(brief: str, areas: list[tuple[int, float | None]]) -> None:
    facts = read_brief(brief, default_knowledge())
    assert [(room.count, room.area) for room in facts.rooms] == areas


def test_an_area_in_metres_is_in_square_metres() -> None:
    facts = read_brief("A house on 2 levels. Area is 160 meters.", default_knowledge())
    assert [quantity.value for quantity in facts.area] == [160.0]


def test_numbers_without_any_unit_are_no_areas() -> None:
    facts = read_brief("Hostel with 3 dorms: two of 8, one of 12.", default_knowledge())
    assert all(room.area is None for room in facts.rooms)


def test_rooms_between_two_areas_have_the_one_in_the_middle() -> None:
    facts = read_brief("Flat share: 4 bedrooms between 14 and 18 sqm, kitchen.", default_knowledge())
    assert [(room.count, room.area) for room in facts.rooms] == [(4, 16.0), (1, None)]
    assert not facts.area


def test_one_more_room_for_a_purpose_has_an_area_of_its_own() -> None:
    facts = read_brief("Music school: 5 practice rooms (each 9 m2) + 1 for drums, bigger, 15 m2.", default_knowledge())
    assert [(room.count, room.area) for room in facts.rooms] == [(5, 9.0), (1, 15.0)]
    assert not facts.area


def test_a_bed_with_its_bath_is_a_bedroom() -> None:
    facts = read_brief("House. First floor: 2 bed attached bath each, study.", default_knowledge())
    bedrooms = facts.rooms[0]
    assert (bedrooms.room_type, bedrooms.count, len(bedrooms.suite)) == ("bedroom", 2, 1)


def test_the_age_of_children_is_no_room() -> None:
    facts = read_brief("Daycare 0-6 yrs with a kitchen.", default_knowledge())
    assert [room.room_type for room in facts.rooms] == ["kitchen"]
