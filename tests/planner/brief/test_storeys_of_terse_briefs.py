"""Storeys as terse lists and writers of other mother tongues name them, and how many people rooms are for."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building


def storeys_of(brief: str) -> dict[str, list[int]]:
    """Return the storeys that a plan puts the rooms of the brief on, by their names without numbers."""
    found: dict[str, set[int]] = {}
    for floor in plan_building(BuildRequest(description=brief)).program.floors:
        for room in floor.rooms:
            found.setdefault(room.id.rstrip("_0123456789"), set()).add(floor.index)
    return {name: sorted(floors) for name, floors in found.items()}


def count_of(brief: str) -> list[int]:
    """Return the storeys of a plan."""
    return [floor.index for floor in plan_building(BuildRequest(description=brief)).program.floors]


@pytest.mark.parametrize(
    ("brief", "expected"),
    [
        ("A courthouse with two courtrooms and a library. Ground and first floor only.", [1, 2]),
        ("A community centre with a hall and a kitchen. No second floor!", [1]),
        ("EG: shop, WC. OG: living room, kitchen, bath. DG: studio.", [1, 2, 3]),
        ("Three floors of offices above a shop.", [1, 2, 3, 4]),
        ("An office building with three floors of offices and a canteen.", [1, 2, 3]),
        ("Hotel: lobby and bar on ground; then four storeys of rooms, ten per storey.", [1, 2, 3, 4, 5]),
    ],
)
def test_storeys_told_by_what_they_hold_are_counted(brief: str, expected: list[int]) -> None:
    assert count_of(brief) == expected


@pytest.mark.parametrize(
    ("brief", "expected"),
    [
        (
            "Library, 3 floors. Foyer on the ground floor. A gallery on the first. Second: archive.",
            {"gallery": [2], "archive": [3]},
        ),
        ("B1 boiler room; L1 foyer, shop; L2 two offices.", {"boiler_room": [0], "shop": [1], "office": [2]}),
        ("Post office. G: parcel store. 1: office. 2: archive.", {"parcel_store": [1], "office": [2], "archive": [3]}),
        ("A courthouse with two courtrooms, holding cells in the cellar: 5 of them.", {"holding_cell": [0]}),
        (
            "Monastery with a courtyard in the middle: church, refectory on the ground; dormitory above.",
            {"church": [1], "refectory": [1], "dormitory": [2]},
        ),
        ("Farm house, ground floor: parlour. In the attic two bedrooms and a hay store.", {"hay_store": [2]}),
        ("A garage and a watch room, above two flats.", {"flat": [2]}),
        ("Lab, two storeys. Ground only: cold room. First floor only: library.", {"cold_room": [1], "library": [2]}),
        (
            "Office, three levels. Level 0 - cafe. Level 1 - six offices. Level 2 - attic.",
            {"office": [2], "attic": [3]},
        ),
        (
            "Town hall, 2 storeys. Level 0 citizens' service: a bank hall, register office. Level 1: an archive.",
            {"bank_hall": [1], "register_office": [1], "archive": [2]},
        ),
        (
            "Villa, two floors. In down floor: a majlis, dining room. In up floor there is four bedrooms; they are up.",
            {"dining_room": [1], "bedroom": [2]},
        ),
        ("School, two floors. The library is down, the staff room is up.", {"library": [1], "staff_room": [2]}),
        (
            "School, three floors. On first floor is a canteen, on second is a library, on third is only an archive.",
            {"canteen": [1], "library": [2], "archive": [3]},
        ),
        (
            "Hotel with three storey. At the most upper storey a restaurant; at the most low floor a bar.",
            {"restaurant": [3], "bar": [1]},
        ),
        ("Clinic. St. 0: reception. St. 1: a pharmacy. 2 st. in all, 200 m2 per st.", {"pharmacy": [2]}),
        ("House of four storeys: ground floor two shops; each other floor 2 flats.", {"shop": [1], "flat": [2, 3, 4]}),
    ],
)
def test_rooms_go_where_terse_words_put_them(brief: str, expected: dict[str, list[int]]) -> None:
    assert storeys_of(brief).items() >= expected.items()


def test_a_number_per_storey_after_rooms_counts_them() -> None:
    brief = "University, 4 floors. Floors 2 to 3: lecture rooms - three per floor - and 10 offices per floor."
    rooms = {room.name: (room.count, room.each) for room in read_brief(brief, default_knowledge()).rooms}
    assert rooms == {"lecture_room": (3, True), "office": (10, True)}


@pytest.mark.parametrize("words", ["2x storage", "storage 2x", "storage (2x)"])
def test_times_before_or_after_a_room_counts_it(words: str) -> None:
    facts = read_brief(f"A house with {words}, and a study", default_knowledge())
    assert [(room.name, room.count) for room in facts.rooms] == [("storage", 2), ("study", 1)]


@pytest.mark.parametrize(
    ("words", "count", "noun"),
    [
        ("a cafeteria seats 30", 30, "seats"),
        ("a cafeteria (150 children)", 150, "seats"),
        ("a cafeteria for 40 people", 40, "seats"),
        ("a dormitory for 8", 8, "beds"),
    ],
)
def test_people_that_a_room_is_for_get_seats_or_beds(words: str, count: int, noun: str) -> None:
    facts = read_brief(f"A lodge with {words}.", default_knowledge())
    assert [(wish.count, wish.noun) for wish in facts.objects] == [(count, noun)]
    assert len(facts.rooms) == 1


def test_entries_without_a_head_are_the_rooms_they_are_short_for() -> None:
    facts = read_brief("Clinic: reception, waiting, recovery, security, delivery.", default_knowledge())
    types = {room.name: room.room_type for room in facts.rooms}
    assert types["waiting"] == "waiting_room"
    assert types["recovery"] == "recovery_room"
    assert types["security"] == "security_room"
    assert types.get("delivery") != "maternity_room"


def test_a_list_after_rooms_names_them() -> None:
    facts = read_brief("House has 5 rooms: kitchen, bath, living, bed, kid.", default_knowledge())
    types = ["kitchen", "bathroom", "living_room", "bedroom", "childrens_room"]
    assert [room.room_type for room in facts.rooms] == types


def test_the_area_of_each_of_several_flats_is_not_that_of_the_storey() -> None:
    brief = "Upper floors 1-3: six apartments of 70 m2 per floor. Ground floor: a shop."
    facts = read_brief(brief, default_knowledge())
    assert not facts.floor_area
    assert [(ref.first, ref.last) for ref in facts.rooms[0].floors] == [(2, 4)]


def test_a_room_named_in_a_finish_is_the_one_listed_later() -> None:
    facts = read_brief("Villa, oak floor in the living room. Ground: living, dining.", default_knowledge())
    assert [room.room_type for room in facts.rooms] == ["living_room", "dining_room"]


def test_only_the_last_of_a_list_that_goes_on_lies_on_the_storey_named_after_it() -> None:
    brief = "Parliament: plenary hall, press room, library, 40 member offices on the upper two floors, 3 floors in all."
    placed = {room.name: bool(room.floors) for room in read_brief(brief, default_knowledge()).rooms}
    assert placed == {"plenary_hall": False, "press_room": False, "library": False, "member_office": True}


def test_a_list_of_rooms_may_name_who_has_them() -> None:
    facts = read_brief("School: eight classrooms, nurse, head teacher, staff, a kitchen.", default_knowledge())
    types = {room.name: (room.room_type, room.known) for room in facts.rooms}
    assert types["staff"] == ("break_room", True)
    assert types["nurse"] == ("nurse_office", True)
    assert types["head_teacher"] == ("private_office", False)


def test_rooms_for_children_are_childrens_rooms() -> None:
    facts = read_brief("A house with 3 rooms for children and a kitchen", default_knowledge())
    assert [(room.room_type, room.count) for room in facts.rooms] == [("childrens_room", 3), ("kitchen", 1)]


@pytest.mark.parametrize(
    "brief",
    [
        "A flat for robot vacuum tests with living room and kitchen",
        "A flat for a computer game with living room and kitchen",
        "Table of rooms: living room, kitchen",
    ],
)
def test_furniture_that_only_tells_what_something_is_about_is_not_wanted(brief: str) -> None:
    facts = read_brief(brief, default_knowledge())
    assert not facts.objects


@pytest.mark.parametrize(
    ("brief", "areas"),
    [
        ("Retirement home; 2 floors, 18 apartments per floor (1 bed, 40 m2), a restaurant.", [40.0, None]),
        ("A courthouse with 2 courtrooms (one large 120 m2, one small 60), a lobby", [120.0, 60.0, None]),
    ],
)
def test_brackets_after_rooms_say_how_large_each_is(brief: str, areas: list[float | None]) -> None:
    facts = read_brief(brief, default_knowledge())
    assert [room.area for room in facts.rooms] == areas
    assert not facts.floor_area


@pytest.mark.parametrize(
    ("brief", "expected"),
    [
        ("School, three floors. Classrooms are on all the floors, five on each.", {"classroom": (5, None)}),
        ("School, 2 floors. Four offices per floor, area of one office is 14 m2.", {"office": (4, 14.0)}),
        ("School, 2 floors. Four offices per floor. The size of an office should be 14 m2.", {"office": (4, 14.0)}),
        ("Museum, 3 floors. Galleries are on every storey, two on each.", {"gallery": (2, None)}),
        ("A laboratory of two floors. The bars hold the labs: per storey four wet labs.", {"wet_lab": (4, None)}),
    ],
)
def test_rooms_are_counted_and_measured_behind_their_storeys(
    brief: str, expected: dict[str, tuple[int, float]]
) -> None:
    rooms = read_brief(brief, default_knowledge()).rooms
    assert {room.name: (room.count, room.area) for room in rooms if room.each} == expected
    assert sum(room.name in expected for room in rooms) == len(expected)


@pytest.mark.parametrize(
    ("brief", "area"),
    [
        ("Student residence, 6 st., 270 m2 per st.", 270.0),
        ("Inpatient wing, three levels, approx. 620 sqm each.", 620.0),
        ("A day centre: ground floor and cellar, both circa 200 m2.", 200.0),
    ],
)
def test_areas_of_each_storey_are_read_from_short_forms(brief: str, area: float) -> None:
    facts = read_brief(brief, default_knowledge())
    assert ([quantity.value for quantity in facts.floor_area], facts.area) == ([area], [])


@pytest.mark.parametrize(
    "brief",
    ["School of St. Mary, a chapel of 40 m2", "A shop in St. Paul's street", "A lab, one flight up, floor 2: a gym"],
)
def test_saints_and_flights_name_no_storeys_of_their_own(brief: str) -> None:
    assert read_brief(brief, default_knowledge()).floors == []


@pytest.mark.parametrize(
    "text",
    [
        "Museum. It has three galleries, one on each of its three storeys and each 110 m2 in size; a foyer.",
        "Museum with three galleries, one per floor, each 110 m2, and a foyer.",
        "Museum of three storeys with three galleries, one on every storey and each about 110 m2.",
    ],
)
def test_an_area_behind_rooms_that_are_shared_out_is_of_each_room(text: str) -> None:
    facts = read_brief(text, default_knowledge())
    assert [(room.count, room.area) for room in facts.rooms if room.name == "gallery"] == [(3, 110.0)]
    assert facts.floor_area == []


def test_an_area_of_each_storey_behind_rooms_stays_the_storeys() -> None:
    facts = read_brief("An office on three floors, a lobby on one of them, each 300 m2.", default_knowledge())
    assert all(room.area is None for room in facts.rooms)
