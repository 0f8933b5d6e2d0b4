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
        ("an office with 500 m2 on each of two floors", True),
        ("a two-storey office, 500 m2 on each of its floors", True),
        ("a two-storey office, 500 m2 for each of the two storeys", True),
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
        ("drone_room", "laboratory", 2),
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


def test_an_area_of_one_floor_is_not_that_of_the_room_before_it() -> None:
    facts = read("A library under one roof with the post office: one floor of 310 m2, with a book hall of 120 m2")
    assert [quantity.value for quantity in facts.area + facts.floor_area] == [310.0]
    assert {fact.name: fact.area for fact in facts.rooms} == {"post_office": None, "book_hall": 120.0}


def test_sides_make_an_area() -> None:
    assert [quantity.value for quantity in read("an office of 20 x 15 metres").floor_area] == [300.0]


def test_a_storey_that_is_the_same_as_another_is_a_copy() -> None:
    facts = read("Floor 2: open-plan office. Floor 3: same as floor 2. Floor 4: boardroom.")
    assert [(copy.first.first, copy.first.last) for copy in facts.copies] == [(2, 3)]


def test_typical_floors_with_numbers_are_those_floors() -> None:
    facts = read("a 12-storey tower, typical floors 3-11 identical")
    assert [(copy.first.first, copy.first.last) for copy in facts.copies] == [(3, 11)]


def test_what_is_not_needed_is_not_wanted() -> None:
    facts = read("An office with an open office. We do not need private offices.")
    assert [name for name, _ in facts.excluded] == ["private_office"]


@pytest.mark.parametrize(
    ("text", "name", "area"),
    [
        ("A mosque. On the ground floor the prayer hall for men, 180 m2, and an ablution room.", "prayer_hall", 180.0),
        ("A cabin of 45 m2 with a kitchen and a sleeping loft above of maybe 15 m2.", "sleeping_loft", 15.0),
        ("An abbey with the church, which should be the largest room, 300 m2 or so, and a library.", "church", 300.0),
    ],
)
def test_an_area_belongs_to_the_room_that_is_described_before_it(text: str, name: str, area: float) -> None:
    assert {fact.name: fact.area for fact in read(text).rooms}[name] == area


def test_storeys_joined_with_a_preposition_each_are_one_place() -> None:
    facts = read("A care home on three floors. On floor 2 and on floor 3: twelve bedrooms and a nurse station.")
    assert {fact.name: [ref.first for ref in fact.floors] for fact in facts.rooms} == {
        "bedroom": [2, 3], "nurse_station": [2, 3],
    }  # fmt: skip


def test_people_upstairs_have_their_rooms_upstairs() -> None:
    facts = read(
        "A home, 2 floors. Grandparents on the ground floor: own kitchen. Family upstairs with 3 bedrooms, kitchen."
    )
    assert [(fact.name, fact.floors[0].kind) for fact in facts.rooms] == [
        ("kitchen", "number"), ("bedroom", "upper"), ("kitchen", "upper"),
    ]  # fmt: skip


def test_a_second_room_of_a_kind_is_another_one() -> None:
    facts = read("A house. The bath and the toilet must be two rooms. Upstairs: three bedrooms and a second toilet.")
    assert sum(fact.count or 0 for fact in facts.rooms if fact.room_type == "toilet") == 2


@pytest.mark.parametrize(
    ("text", "shape"),
    [
        ("A house bent in a U around a patio", "U"),
        ("A monastery whose buildings form a closed quadrangle", "courtyard"),
        ("A house about an open garth", "courtyard"),
        ("A faculty with four floors, plan in shape of letter L", "L"),
        ('A school in the form of the letter "U", two floors', "U"),
        ("A house, plan as letter H", "H"),
        ("An office. The shape of building is like letter T", "T"),
        ("An office, shape L", "L"),
        ("A library of 2 floors, the building shape is square", "square"),
        ("A lodge. Please make the outline a square", "square"),
    ],
)
def test_outlines_are_told_in_many_ways(text: str, shape: str) -> None:
    assert [name for name, _ in read(text).shapes] == [shape]


@pytest.mark.parametrize(
    "text", ["A flat. The kitchen has the shape of the letter L", "A house with a square shaped kitchen"]
)
def test_the_outline_of_a_room_is_not_that_of_the_building(text: str) -> None:
    assert not read(text).shapes


def test_what_is_next_to_it_is_next_to_the_room_before() -> None:
    facts = read("A town hall with the archive, the mayor's office, next to it the secretary's office, and a lobby.")
    assert [(a.first_name, a.second_name) for a in facts.adjacent] == [("secretary_office", "mayor_office")]


def test_both_rooms_that_touch_another_are_beside_it() -> None:
    facts = read("A bath with a pool hall; the showers and the guards' room both touch the pool hall")
    assert {a.first_name for a in facts.adjacent} == {"shower", "guard_room"}


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("We are moving to a 7-level building. L1 lobby, L2 canteen, L3 three meeting rooms, L4 eight offices", ""),
        ("Film post-production house over three floors", "media_house"),
        ("police post: 4 holding cells", "police_station"),
        ("A new public swimming bath with a sauna", "swimming_center"),
        ("A test bed, please: a single-level apartment of 70 m2", "flat"),
    ],
)
def test_kinds_of_buildings(text: str, kind: str) -> None:
    facts = read(text)
    assert [name for name, _ in facts.building] == ([kind] if kind else [])
    assert not facts.building_name or kind
