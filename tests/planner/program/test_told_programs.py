"""Public buildings hold what their brief tells, and beside it what they cannot do without."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.program import RoomProgram
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief.reader import read_brief
from mansion_planner.plan import plan_building
from mansion_planner.program.told_programs import tells_program

KNOWLEDGE = default_knowledge()


def storeys(brief: str) -> list[list[RoomProgram]]:
    return [list(floor.rooms) for floor in plan_building(BuildRequest(description=brief, seed=5)).program.floors]


def types(brief: str) -> set[str]:
    return {room.room_type for rooms in storeys(brief) for room in rooms}


@pytest.mark.parametrize(
    ("brief", "kind", "expected"),
    [
        ("A cinema with two screening rooms and a bar", "cinema", True),
        ("A gym with a weights area and a yoga studio", "gym_building", True),
        ("A hotel with twelve rooms", "hotel", True),
        ("A hotel with a restaurant and a bar", "hotel", False),
        ("A hospital with a waiting room and an operating room", "hospital", False),
        ("A house with three bedrooms and a study", "house", False),
        ("An office with a reception, a meeting room, a library, a print room and a kitchen", "office", True),
        ("An office of 900 m2 with a reception, meeting room, library, print room and kitchen", "office", False),
        ("An office with a reception, a meeting room and a kitchen", "office", False),
    ],
)
def test_a_brief_tells_a_program_that_names_what_the_building_is_there_for(
    brief: str, kind: str, *, expected: bool
) -> None:
    assert tells_program(read_brief(brief, KNOWLEDGE), KNOWLEDGE.buildings[kind], KNOWLEDGE) is expected


@pytest.mark.parametrize(
    ("brief", "absent"),
    [
        ("a hospital ward with eight patient rooms and a nurse station", "emergency_room"),
        ("a car repair workshop with three service bays and a waiting area", "production_hall"),
        ("a restaurant with seating for 40 people and a kitchen", "vip_room"),
        ("a kindergarten with two playrooms and a nap room", "playroom"),
        ("a small grocery store with a storage room at the back", "bakery"),
        ("a primary school with six classrooms and a gym hall", "commercial_kitchen"),
    ],
)
def test_no_large_rooms_that_nobody_asked_for(brief: str, absent: str) -> None:
    assert absent not in types(brief)


@pytest.mark.parametrize(
    ("brief", "kind"),
    [
        ("a dental clinic with a waiting room and three treatment rooms", "sterilization_room"),
        ("a three-storey hotel with ten rooms on each upper floor", "housekeeping_room"),
        ("a hospital ward with eight patient rooms", "sterilization_room"),
        ("a primary school with six classrooms and a gym hall", "school_office"),
    ],
)
def test_a_building_has_the_rooms_that_it_cannot_do_without(brief: str, kind: str) -> None:
    assert kind in types(brief)


def test_told_rooms_are_the_largest() -> None:
    rooms = [
        room for floor in storeys("a robotics lab with a large test area and a small meeting room") for room in floor
    ]
    test_area = max(rooms, key=lambda room: room.area_estimate)
    assert test_area.id == "test_area"
    assert all(2.0 * room.area_estimate <= test_area.area_estimate for room in rooms if room is not test_area)


def test_stores_in_a_basement_are_no_measure_for_those_above() -> None:
    (rooms,) = storeys("a hospital ward with eight patient rooms and a medicine storage room")
    assert next(room.area_estimate for room in rooms if room.id == "medicine_storage_room") < 20.0


def test_rooms_told_for_one_storey_do_not_fill_others() -> None:
    ground, upper = storeys(
        "a town hall with a council chamber, a public service counter and offices on the second floor"
    )
    assert any(room.room_type == "service_counter" for room in ground)
    assert sum(room.room_type == "private_office" for room in ground) == 0
    assert any(room.room_type in ("private_office", "open_office") for room in upper)


def test_beds_that_are_counted_size_the_rooms_that_they_stand_in() -> None:
    brief = "a fire station with a garage for two trucks and sleeping quarters for {} firefighters upstairs"
    eight, twenty = (
        sum(room.area_estimate for room in storeys(brief.format(number))[1] if room.room_type == "bunk_room")
        for number in ("eight", "twenty")
    )
    assert eight < 70.0 and eight + 20.0 < twenty


def test_a_corridor_that_is_told_is_the_one_along_which_the_rooms_lie() -> None:
    ground = storeys("a primary school with six classrooms along a corridor")[0]
    assert not any(room.id == "corridor_area" for room in ground)


def test_a_hall_for_sport_has_changing_rooms() -> None:
    ground = storeys("a primary school with six classrooms and a gym hall")[0]
    assert sum(room.room_type == "changing_room" for room in ground) == 2
