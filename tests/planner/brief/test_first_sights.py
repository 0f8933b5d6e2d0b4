"""Classes of wordings that were misread at first sight, each with several members."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts, FloorRef
from mansion_planner.plan import plan_building


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def rooms(text: str) -> list[tuple[str, int | None]]:
    return [(room.name, room.count) for room in read(text).rooms]


def where(refs: tuple[FloorRef, ...]) -> list[tuple[str, int, int]]:
    return [(ref.kind, ref.first, ref.last) for ref in refs]


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("a school with classroom 2B and four classrooms", [("classroom_2b", 1), ("classroom", 4)]),
        ("a school with classroom 2B, classroom 2C and four more classrooms",
         [("classroom_2b", 1), ("classroom_2c", 1), ("classroom", 4)]),
        ("a clinic with exam rooms 1 to 6", [("exam_room", 6)]),
        ("a college with studio A and three seminar rooms", [("studio_a", 1), ("seminar_room", 3)]),
        ("a clinic with a freezer room -80", [("freezer_room", 1)]),
        ("Bungalow. Bed 1: 16 m2. Bed 2: 12 m2.", [("bedroom_1", 1), ("bedroom_2", 1)]),
        ("House. Bedrooms: 4. Bathrooms: 2.", [("bedroom", 4), ("bathroom", 2)]),
        ("an office building with half a dozen offices", [("office", 6)]),
        ("a clinic with toilets for ladies and gentlemen", [("lady_toilet", 1), ("gentleman_toilet", 1)]),
        ("a clinic with separate waiting rooms for cats and dogs", [("cat_waiting_room", 1), ("dog_waiting_room", 1)]),
        ("townhouse: L1 garage; L2 kitchen; L3 3 bed 2 bath",
         [("garage", 1), ("kitchen", 1), ("bedroom", 3), ("bath", 2)]),
    ],
)  # fmt: skip
def test_names_and_counts(text: str, found: list[tuple[str, int | None]]) -> None:
    assert rooms(text) == found


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("Ward with 12 beds", "ward"),
        ("Storage in the attic", "storage"),
        ("Courtroom, jury room and a lobby", "courtroom"),
        ("Kosher kitchen with two sinks", "kosher_kitchen"),
        ("A windowless server room in the basement", "windowless_server_room"),
        ("Tea room of 30 m2", "tea_room"),
    ],
)
def test_a_room_that_opens_a_brief_is_no_building(text: str, name: str) -> None:
    program = plan_building(BuildRequest(description=text)).program
    assert name in [wish.value.name for wish in program.wishes if wish.kind == "room"]
    assert not [wish for wish in program.wishes if wish.kind == "building_type"]


@pytest.mark.parametrize(
    ("text", "kept", "excluded"),
    [
        ("a house. The kitchen is open to the dining room, not to the living room", "living_room", []),
        ("a house. Put the washing machine in the bathroom, not in the kitchen", "kitchen", []),
        ("a house with no wall between the kitchen and the living room", "kitchen", []),
        ("a house. I don't need a dining room because we eat in the kitchen", "kitchen", ["dining_room"]),
        ("a house. Replace the garage by a workshop", "workshop", ["garage"]),
        ("a house. Change the dining room into a playroom", "playroom", ["dining_room"]),
    ],
)
def test_how_far_a_negation_reaches(text: str, kept: str, excluded: list[str]) -> None:
    facts = read(text)
    assert kept in [room.name for room in facts.rooms]
    assert [name for name, _ in facts.excluded] == excluded


def test_what_one_would_rather_not_have() -> None:
    found = read("a bathroom. I would rather have a shower than a bathtub").objects
    assert [(thing.category, thing.excluded) for thing in found] == [("bathtub", True)]


@pytest.mark.parametrize(
    ("text", "name", "refs"),
    [
        ("a school on three floors with two toilets (m/f) on each floor", "toilet", [("every", 0, 0)]),
        ("a house. Bakery downstairs, kitchen above", "kitchen", [("upper", 0, 0)]),
        ("a block of 4 floors with 3 apartments by floor from 2nd to 4th", "apartment", [("range", 2, 4)]),
        ("a tower of nine floors. Ground: shops. 2 and 3: a gym. 4 through 6: four apartments.", "gym",
         [("number", 2, 2), ("number", 3, 3)]),
        ("eight floors, every second floor has a lounge", "lounge", [("even", 0, 0)]),
        ("an inn of two floors. Down: a bar. Up: six guest rooms.", "bar", [("number", 1, 1)]),
        ("four floors. Third and fourth are the same, with two flats", "flat", [("number", 3, 3), ("number", 4, 4)]),
    ],
)  # fmt: skip
def test_storeys(text: str, name: str, refs: list[tuple[str, int, int]]) -> None:
    assert where(next(room for room in read(text).rooms if room.name == name).floors) == refs


def test_each_of_the_storeys_tells_how_many_there_are() -> None:
    assert [count.value for count in read("each of the three floors has two flats").floors] == [3.0]


def test_the_height_of_a_room_is_no_number_of_storeys() -> None:
    assert read("an office. The lobby is two storeys high").floors == []
    assert [height.height for height in read("10 ft ceilings").heights] == [pytest.approx(3.048)]
    assert read("a house with a ceiling height of 2.4 m in the bedrooms").heights[0].room_type == "bedroom"


def test_a_house_without_stairs_has_one_storey() -> None:
    assert len(plan_building(BuildRequest(description="a house without stairs")).program.floors) == 1


@pytest.mark.parametrize(
    ("text", "pair", "apart"),
    [
        ("a house with two bedrooms, bath in between", ("bath", "bedroom"), False),
        ("a store with a cold room next to the loading bay, away from the boiler room",
         ("cold_room", "boiler_room"), True),
        ("a house with a master bedroom. An ensuite to the master bedroom.", ("ensuite", "master_bedroom"), False),
        ("a market with a loading dock and a warehouse. The dock must be beside the warehouse",
         ("loading_dock", "warehouse"), False),
    ],
)  # fmt: skip
def test_relations(text: str, pair: tuple[str, str], apart: bool) -> None:
    facts = read(text)
    assert pair in [(fact.first_name, fact.second_name) for fact in (facts.apart if apart else facts.adjacent)]


def test_a_lake_is_no_veranda() -> None:
    assert read("a summer house by the lake with a big veranda and two bedrooms").adjacent == []


@pytest.mark.parametrize(
    ("text", "category", "count", "room"),
    [
        ("a hostel with three 6-bed dorms", "bed", 6, "dorm"),
        ("a music school with a concert hall seating 120", "chair", 120, "concert_hall"),
        ("a pharmacy with a staff room with lockers", "locker", None, "staff_room"),
        ("a house with one bathroom with a shower", "shower_cabin", 1, "bathroom"),
    ],
)
def test_things_in_rooms(text: str, category: str, count: int | None, room: str) -> None:
    assert (category, count, room) in [(thing.category, thing.count, thing.room) for thing in read(text).objects]


def test_the_rooms_of_a_list_are_not_those_of_each_room() -> None:
    facts = read("a tavern with six guest rooms, each one with a bed and a chest, and the innkeeper's room")
    assert [room.name for room in facts.rooms] == ["guest_room", "innkeeper_room"]
    assert facts.rooms[0].suite == ()


def test_rooms_of_their_own_names_are_not_counted_among_others() -> None:
    facts = read("four bedrooms with a bathroom for each")
    assert [(room.name, [child.name for child in room.suite]) for room in facts.rooms] == [("bedroom", ["bathroom"])]


@pytest.mark.parametrize("text", ["Salon: 6 styling stations", "Flower shop on street floor, two meeting rooms"])
def test_parts_do_not_name_the_building(text: str) -> None:
    assert "train_station" not in [name for name, _ in read(text).building]


def test_things_are_wanted_in_each_of_some_rooms() -> None:
    found = read("a house. In each of the five bedrooms a wardrobe and a desk").objects
    assert [(thing.category, thing.room, thing.each) for thing in found] == [
        ("wardrobe", "bedroom", True),
        ("desk", "bedroom", True),
    ]


@pytest.mark.parametrize(
    ("text", "name", "count", "each"),
    [
        ("an office of six floors with 40 offices on floors 2 to 5", "office", 40, False),
        ("a hotel of six floors with eight guest rooms on floors 2 to 5", "guest_room", 8, True),
        ("a nursing home, three floors, each with 12 bedrooms", "bedroom", 12, True),
    ],
)
def test_a_number_is_of_all_storeys_or_of_each(text: str, name: str, count: int, *, each: bool) -> None:
    assert [(room.count, room.each) for room in read(text).rooms if room.name == name] == [(count, each)]


def test_each_of_the_people_has_rooms() -> None:
    assert rooms("a practice of two doctors, each with a consulting room and an examination room") == [
        ("consulting_room", 2),
        ("examination_room", 2),
    ]


def test_both_of_two_rooms_are_placed() -> None:
    found = read("a hotel. Put the sauna next to the gym and both in the basement").rooms
    assert [(room.name, where(room.floors)) for room in found] == [
        ("sauna", [("basement", 0, 0)]),
        ("gym", [("basement", 0, 0)]),
    ]


def test_only_too_long_corridors_are_unwanted() -> None:
    facts = read("an office with two meeting rooms and no corridors longer than 10 m")
    assert facts.excluded == []
    assert "corridors longer than 10" in [span.words for span in facts.unread]


def test_nothing_but_some_rooms() -> None:
    assert [span.words for span in read("I want nothing but a living room, a bedroom and a bathroom").only] == [
        "nothing but"
    ]


def test_nobody_lives_in_the_studios_of_a_school() -> None:
    found = read("a dance school: large studio 90 m2, small studio 45 m2").rooms
    assert [(room.room_type, room.known) for room in found] == [("art_room", False), ("art_room", False)]


def test_furniture_of_the_building_is_looked_for_in_all_of_it() -> None:
    program = plan_building(BuildRequest(description="a farm shop with a cold counter and an office")).program
    assert [wish.scope.room for wish in program.wishes if wish.kind == "object"] == [""]


def test_areas_of_all_rooms_of_a_name_are_said_later() -> None:
    found = read("a school of two floors. Ground floor: four classrooms. Upper floor: six classrooms. "
                 "Classrooms around 50 m2.").rooms  # fmt: skip
    assert [(room.count, room.area) for room in found] == [(4, 50.0), (6, 50.0)]


def test_beds_of_each_room_are_not_rooms_of_each_room() -> None:
    assert rooms("a hostel with four dormitories with 6 beds each and two shower rooms") == [
        ("dormitory", 4),
        ("shower_room", 2),
    ]


@pytest.mark.parametrize(
    "text", ["a maisonette: two levels inside one flat, 90 m2", "a loft of 140 m2 in an old factory"]
)
def test_where_a_building_lies_is_no_room(text: str) -> None:
    assert read(text).rooms == []


def test_furniture_of_a_room_on_each_storey_is_for_each_such_room() -> None:
    found = read("an office of 8 floors. Floors 2 to 7: open office with 24 desks, two meeting rooms.").objects
    assert [(thing.count, thing.each) for thing in found] == [(24, True)]


def test_each_room_of_a_kind_means_several() -> None:
    assert rooms("a house. Every bedroom must be larger than 12 m2") == [("bedroom", None)]
    assert rooms("12 flats on 4 floors, each with a kitchen")[0] == ("flat", 12)


def test_a_number_that_a_hyphen_joins_is_no_count() -> None:
    assert [thing.count for thing in read("a house with a four-poster bed in the bedroom").objects] == [1]


@pytest.mark.parametrize(
    "text",
    [
        "Our flat is L-shaped: a living room, a kitchen, a bedroom and a bathroom in 87 square meters.",
        "A flat: a kitchen, a bedroom and a bathroom within about 87 m2",
        "a flat with a bedroom and a living room on 87 m2",
    ],
)
def test_an_area_that_a_list_of_rooms_lies_in_is_the_buildings(text: str) -> None:
    facts = read(text)
    assert [area.value for area in facts.area] == [87.0]
    assert [room.area for room in facts.rooms] == [None] * len(facts.rooms)


def test_rooms_that_have_their_own_areas_keep_them() -> None:
    assert [room.area for room in read("a house with a kitchen in 20 m2 and a living room in 30 m2").rooms] == [20, 30]


@pytest.mark.parametrize(
    ("text", "refs"),
    [
        ("A hotel of four storeys. On each of the two storeys in the middle, ten guest rooms.", [("middle", 0, 0)]),
        ("A hotel of four storeys. Each of levels 2 to 3 has ten guest rooms.", [("range", 2, 3)]),
        ("A hotel of four storeys. On each of floors 2 and 3, ten guest rooms.", [("number", 2, 2), ("number", 3, 3)]),
        ("A hotel of five storeys. Each of floors 2, 3 and 4 has ten guest rooms.",
         [("number", 2, 2), ("number", 3, 3), ("number", 4, 4)]),
    ],
)  # fmt: skip
def test_each_of_some_storeys_means_these_storeys(text: str, refs: list[tuple[str, int, int]]) -> None:
    (room,) = read(text).rooms
    assert (room.count, room.each, where(room.floors)) == (10, True, refs)


@pytest.mark.parametrize(
    "text",
    [
        "A clinic of four storeys. Levels 3 and 4 are equal: ten patient rooms and a nurses' station each.",
        "A clinic of four storeys. Floors 3 and 4: ten patient rooms and a nurse station each.",
        "A clinic of four storeys. The storeys 3 and 4 have ten patient rooms and one nurse station each.",
    ],
)
def test_each_at_the_end_of_what_several_storeys_have_shares_out_over_them(text: str) -> None:
    facts = read(text)
    station = next(room for room in facts.rooms if room.room_type == "nurse_station")
    assert station.count == 1 and station.each
    assert not any(room.suite for room in facts.rooms)


def test_each_at_the_end_of_a_room_with_another_gives_it_to_every_room() -> None:
    facts = read("A hotel of four storeys. Floors 3 and 4: ten guest rooms with a bathroom each.")
    (rooms,) = facts.rooms
    assert [part.room_type for part in rooms.suite] == ["bathroom"]
