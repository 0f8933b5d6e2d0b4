"""Homes above a business, stacked flats and flats that lie on a storey of a building that is not built."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


def test_who_lives_above_has_a_flat() -> None:
    brief = "Barber's shop below, barber lives above. Shop: 4 barber chairs. Home: bedroom, kitchen, bathroom."
    flat = next(room for room in read_brief(brief, default_knowledge()).rooms if room.unit)
    assert (flat.label, flat.floors[0].kind) == ("flat", "upper")
    assert [room.room_type for room in flat.suite] == ["bedroom", "kitchen", "bathroom"]


def test_a_later_mention_tells_what_the_flat_holds() -> None:
    facts = read_brief("A shop and flat. Flat upstairs: living room, bedroom.", default_knowledge())
    flat = next(room for room in facts.rooms if room.unit)
    assert [room.room_type for room in flat.suite] == ["living_room", "bedroom"]


def test_a_maisonette_told_by_its_storeys_is_what_they_are_for() -> None:
    brief = (
        "A shop with a maisonette above. Ground floor: shop. First floor: kitchen and living room. "
        "Second floor: two bedrooms, bathroom."
    )
    facts = read_brief(brief, default_knowledge())
    assert not any(room.unit for room in facts.rooms)
    assert [(use.building_type, [ref.first for ref in use.floors]) for use in facts.uses] == [("flat", [2, 3])]


@pytest.mark.parametrize(
    "brief", ["City flat, third floor walk-up, 64 m2. One bedroom.", "Flat on the third floor, 64 m2: a bedroom"]
)
def test_nothing_is_built_below_a_single_flat(brief: str) -> None:
    facts = read_brief(brief, default_knowledge())
    assert [quantity.value for quantity in facts.area] == [64.0]
    assert all(not room.floors for room in facts.rooms)


def test_stacked_flats_hold_their_lists() -> None:
    brief = "Two flats one over the other. Lower flat: 1 bedroom, bath. Upper flat: 2 bedrooms, bath. 75 sqm each"
    facts = read_brief(brief, default_knowledge())
    assert [(flat.floors[0].kind, [room.count for room in flat.suite]) for flat in facts.rooms] == [
        ("number", [1, 1]),
        ("upper", [2, 1]),
    ]
    assert [quantity.value for quantity in facts.floor_area] == [75.0]


def test_what_the_building_stands_near_is_none_of_it() -> None:
    facts = read_brief("Sports club with a bar. The club is close to the station.", default_knowledge())
    assert [room.room_type for room in facts.rooms] == ["bar"]


@pytest.mark.parametrize("words", ["just 2 rooms: a lab and a store", "a lab and a store. Nothing more."])
def test_no_room_is_added_to_a_number_of_them(words: str) -> None:
    assert read_brief(f"I need {words}", default_knowledge()).only
