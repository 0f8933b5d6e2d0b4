"""What the reader finds in the words of a brief."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def rooms(text: str) -> dict[str, int | None]:
    return {fact.name: fact.count for fact in read(text).rooms}


@pytest.mark.parametrize(
    ("text", "floors"),
    [
        ("a four-storey office", 4),
        ("12 floors", 12),
        ("a building of twenty-one stories", 21),
        ("G+3 apartment block", 4),
        ("house on two levels", 2),
        ("single-story shop", 1),
        ("ground floor and three upper floors", 4),
    ],
)
def test_storeys_in_words_and_figures(text: str, floors: int) -> None:
    assert [quantity.value for quantity in read(text).floors] == [floors]


@pytest.mark.parametrize(
    ("text", "area"),
    [
        ("an office of 1,200 m2", 1200.0),
        ("a 75 sqm flat", 75.0),
        ("a house of 2000 sq ft", 185.8),
        ("a shop, 90 square metres", 90.0),
        ("about 300 m²", 300.0),
    ],
)
def test_areas_in_metres_and_feet(text: str, area: float) -> None:
    assert read(text).area[0].value == pytest.approx(area, abs=0.1)


def test_an_area_per_floor_is_told_from_a_total() -> None:
    facts = read("a hotel with 400 m2 per floor")
    assert [quantity.value for quantity in facts.floor_area] == [400.0]
    assert not facts.area


@pytest.mark.parametrize(
    ("text", "each"),
    [
        ("a two-storey office of 1000 m2", False),
        ("a two-storey office of 1000 m2 in total", False),
        ("a three-floor office, 900 m2 altogether", False),
        ("two storeys of 500 m2", True),
        ("an office of two floors of 500 m2 each", True),
    ],
)
def test_an_area_follows_the_building_or_its_storeys(text: str, each: bool) -> None:
    facts = read(text)
    assert (bool(facts.floor_area), bool(facts.area)) == (each, not each)


def test_an_area_of_a_room_is_not_the_buildings() -> None:
    facts = read("an office with a 40 m2 meeting room and a gym of 60 m2")
    assert not facts.area
    assert {fact.room_type: fact.area for fact in facts.rooms} == {"meeting_room": 40.0, "gym": 60.0}


def test_counts_and_plurals() -> None:
    found = rooms("a house with three bedrooms, a kitchen and several bathrooms")
    assert found == {"bedroom": 3, "kitchen": 1, "bathroom": None}


def test_the_head_noun_is_the_building_and_the_rest_are_rooms() -> None:
    facts = read("a library with a cafe and a gym")
    assert [name for name, _ in facts.building] == ["library_building"]
    assert [fact.room_type for fact in facts.rooms] == ["cafe", "gym"]


def test_a_place_after_a_list_belongs_to_the_list() -> None:
    facts = read("an office with a gym and a sauna on the top floor")
    assert [[ref.kind for ref in fact.floors] for fact in facts.rooms] == [["top"], ["top"]]


@pytest.mark.parametrize(
    ("text", "each"),
    [
        ("five meeting rooms on floors 1 and 2", True),
        ("five meeting rooms spread over floors 1 and 2", False),
        ("a total of six bedrooms across the upper floors", False),
        ("six bedrooms distributed across the upper floors", False),
    ],
)
def test_a_number_for_several_storeys_holds_for_each_unless_it_is_shared_out(text: str, each: bool) -> None:
    assert [fact.each for fact in read(text).rooms] == [each]


def test_a_place_before_a_room_is_that_rooms_alone() -> None:
    facts = read("a hotel with a ground-floor restaurant and a bar")
    assert [len(fact.floors) for fact in facts.rooms] == [1, 0]


@pytest.mark.parametrize(
    "words", ["per floor", "each floor", "on each floor", "for every storey", "on each of the 3 floors"]
)
def test_a_number_for_each_storey_holds_for_each(words: str) -> None:
    facts = read(f"A three-storey school with two classrooms {words} and a cafeteria")
    assert [(r.room_type, r.count, r.each) for r in facts.rooms] == [("classroom", 2, True), ("cafeteria", 1, False)]
    assert [ref.kind for ref in facts.rooms[0].floors] == ["every"]


def test_an_area_per_floor_is_not_a_place() -> None:
    facts = read("An office with 300 m2 per floor and a cafeteria")
    assert facts.rooms[0].floors == ()


def test_the_area_of_a_room_on_each_storey_is_not_the_storeys() -> None:
    facts = read("A three-storey office with a 20 m2 storage room per storey")
    assert facts.floor_area == []
    assert [(r.room_type, r.area, r.each) for r in facts.rooms] == [("storage", 20.0, True)]


def test_on_top_is_the_top_storey() -> None:
    facts = read("A three-storey school with a library on top")
    assert [ref.kind for ref in facts.rooms[0].floors] == ["top"]


def test_a_clause_about_a_storey_places_all_its_rooms() -> None:
    facts = read("The second floor has a gym, a library and two meeting rooms. There is a cafe.")
    assert [[ref.first for ref in fact.floors] for fact in facts.rooms] == [[2], [2], [2], []]


def test_first_floor_is_above_the_ground_floor_where_both_are_named() -> None:
    facts = read("a shop on the ground floor and a gym on the first floor of a library")
    assert {fact.room_type: fact.floors[0].first for fact in facts.rooms if fact.floors} == {"shop": 1, "gym": 2}


def test_exclusions_end_with_their_clause() -> None:
    facts = read("a house with no garage or basement, but with a sauna")
    assert [name for name, _ in facts.excluded] == ["garage", "basement"]
    assert [fact.room_type for fact in facts.rooms] == ["sauna"]


def test_wishes_are_read() -> None:
    facts = read(
        "An L-shaped modern hotel, floors 3 to 8 identical, without elevator, "
        "the kitchen next to the restaurant, oak floors"
    )
    assert [shape for shape, _ in facts.shapes] == ["L"]
    assert [style for style, _ in facts.styles] == ["modern"]
    assert [(copy.first.first, copy.first.last) for copy in facts.copies] == [(3, 8)]
    assert [name for name, _ in facts.vertical] == ["no_elevator"]
    assert [(fact.first, fact.second) for fact in facts.adjacent] == [("kitchen", "restaurant")]
    assert [(fact.surface, fact.material) for fact in facts.materials] == [("floor", "oak")]


def test_misspelt_words_are_understood() -> None:
    facts = read("a tree storey scool with ten clasrooms and a cafetaria")
    assert [name for name, _ in facts.building] == ["school"]
    assert rooms("a scool with ten clasrooms") == {"classroom": 10}


def test_common_words_are_not_taken_for_misspellings() -> None:
    assert not read("stone and horses and stories and plants and state").building


def test_unknown_rooms_become_rooms_like_known_ones() -> None:
    facts = read("an office with a quantum lab and two drone rooms")
    assert [(f.name, f.room_type, f.count) for f in facts.rooms] == [
        ("quantum_lab", "laboratory", 1),
        ("drone_room", "study_room", 2),
    ]


def test_spans_are_places_in_the_text() -> None:
    text = "Ein İmposing four-storey office with a Gym"
    facts = read(text)
    for span in [facts.floors[0].span, facts.building[0][1], facts.rooms[0].span]:
        assert text[span.start : span.end] == span.words


@given(st.text(max_size=300))
@settings(max_examples=150, deadline=None)
def test_any_text_is_read(text: str) -> None:
    facts = read(text)
    for fact in facts.rooms:
        assert fact.room_type in default_knowledge().rooms
        assert text[fact.span.start : fact.span.end] == fact.span.words


def test_a_negation_ends_with_its_sentence() -> None:
    assert [name for name, _ in read("Library. 3 floors. No elevator.").vertical] == ["no_elevator"]
    assert [name for name, _ in read("No basement. An elevator.").vertical] == ["elevator"]


def test_sides_make_an_area() -> None:
    assert [quantity.value for quantity in read("an office of 20 x 15 metres").floor_area] == [300.0]


def test_a_storey_that_is_the_same_as_another_is_a_copy() -> None:
    facts = read("Floor 2: open-plan office. Floor 3: same as floor 2. Floor 4: boardroom.")
    assert [(copy.first.first, copy.first.last) for copy in facts.copies] == [(2, 3)]


def test_typical_floors_with_numbers_are_those_floors() -> None:
    facts = read("a 12-storey tower, typical floors 3-11 identical")
    assert [(copy.first.first, copy.first.last) for copy in facts.copies] == [(3, 11)]
