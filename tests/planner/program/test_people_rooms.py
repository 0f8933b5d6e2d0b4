"""Rooms, work places and seats for as many people as a brief says."""

import pytest

from mansion_msgs_py.program import BuildingProgram, RoomProgram
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


def planned(brief: str, seed: int = 1) -> BuildingProgram:
    return plan_building(BuildRequest(description=brief, seed=seed)).program


def rooms(program: BuildingProgram) -> list[RoomProgram]:
    return [room for floor in program.floors for room in floor.rooms]


@pytest.mark.parametrize(
    ("brief", "kind", "count"),
    [
        ("A medical practice for four doctors on one floor", "consultation_room", 4),
        ("A clinic for six doctors", "consultation_room", 6),
        ("A clinic for six doctors with two consulting rooms", "consultation_room", 2),
    ],
)
def test_professionals_have_a_room_each(brief: str, kind: str, count: int) -> None:
    assert [room.room_type for room in rooms(planned(brief))].count(kind) == count


@pytest.mark.parametrize("people", [30, 80])
def test_those_who_work_in_an_office_have_a_desk_each(people: int) -> None:
    found = rooms(planned(f"A three-storey office for {people} people"))
    desks = [wanted.count for room in found for wanted in room.objects if wanted.category == "office_desk"]
    assert sum(desks) == people
    area = sum(room.area_estimate for room in found if room.room_type == "open_office")
    assert area / people >= 4.5


def test_guests_of_an_office_have_no_desks() -> None:
    found = rooms(planned("A two-storey office with a waiting room for 20 visitors"))
    assert not [wanted for room in found for wanted in room.objects if wanted.category == "office_desk"]


def test_the_seats_of_a_restaurant_are_in_its_dining_room() -> None:
    found = {room.id: room for room in rooms(planned("An Italian restaurant with 60 seats and an open pizza kitchen"))}
    assert [wanted.count for wanted in found["restaurant"].objects] == [60]
    assert not found["pizza_kitchen"].objects
    assert 15.0 <= found["pizza_kitchen"].area_estimate <= 40.0
    assert "commercial_kitchen" not in found


def test_a_fire_station_has_its_rooms_at_the_hall_of_its_engines() -> None:
    program = planned("A fire station for three engines with sleeping quarters upstairs")
    bay = next(room for room in program.floors[0].rooms if room.room_type == "apparatus_bay")
    assert [(wanted.category, wanted.count) for wanted in bay.objects] == [("fire_engine", 3)]
    assert bay.area_estimate >= 100.0


def test_small_children_have_washrooms_of_their_own() -> None:
    found = [room for room in rooms(planned("A kindergarten for 60 children")) if "washroom" in room.id]
    assert len(found) == 2
    assert all(room.area_estimate >= 14.0 for room in found)


@pytest.mark.parametrize(
    ("brief", "unwanted"),
    [
        ("A cinema with three screens", {"training_room", "study_room"}),
        ("A supermarket with a bakery", {"shop", "lounge"}),
        ("A gym with a weights area and a yoga studio", {"training_room", "meeting_room", "private_office"}),
    ],
)
def test_what_fills_a_building_belongs_there(brief: str, unwanted: set[str]) -> None:
    assert not unwanted & {room.room_type for room in rooms(planned(brief, seed=3))}


def test_a_storey_of_a_hotel_is_filled_with_one_lounge_at_most() -> None:
    program = planned("A boutique hotel of four storeys with 24 rooms, a restaurant and a small spa", seed=3)
    assert all([room.room_type for room in floor.rooms].count("lounge") <= 1 for floor in program.floors)


@pytest.mark.parametrize(("brief", "storeys"), [("an office for 12 people", 1), ("an office for 40 people", 2)])
def test_a_building_for_few_people_has_few_storeys(brief: str, storeys: int) -> None:
    program = plan_building(BuildRequest(description=brief, seed=3)).program
    assert len(program.floors) == storeys


@pytest.mark.parametrize(
    "brief", ["a flat with a guest room", "a house for a couple with a home cinema and a guest room"]
)
def test_those_who_live_in_a_home_with_a_guest_room_have_a_bedroom(brief: str) -> None:
    kinds = [room.room_type for room in rooms(planned(brief))]
    assert kinds.count("guest_room") == 1
    assert {"bedroom", "master_bedroom"} & set(kinds)


def test_a_kitchen_diner_is_the_place_to_dine_unless_a_dining_room_is_asked_for() -> None:
    without = [room.room_type for room in rooms(planned("a house with a kitchen diner"))]
    both = [room.room_type for room in rooms(planned("a house with a kitchen diner and a dining room"))]
    assert ("dining_room" in without, "dining_room" in both) == (False, True)


@pytest.mark.parametrize(
    ("brief", "count"),
    [("a house for six students", 6), ("a flat for two roommates", 2), ("a house for a family of four", 3)],
)
def test_people_who_share_a_home_have_a_bedroom_each_and_parents_one_together(brief: str, count: int) -> None:
    kinds = [room.room_type for room in rooms(planned(brief))]
    assert sum(kind in ("bedroom", "master_bedroom") for kind in kinds) == count


def test_a_home_with_a_shared_kitchen_has_no_other_beside_it() -> None:
    kinds = [room.room_type for room in rooms(planned("a house for six students with a shared kitchen"))]
    assert [kind for kind in kinds if "kitchen" in kind] == ["shared_kitchen"]


def test_an_office_is_as_large_as_its_desks_need() -> None:
    small = planned("an office with 20 workstations and a meeting room")
    assert len(small.floors) == 1
    assert small.floors[0].gross_floor_area < 450.0
    assert len(planned("an office with 50 desks").floors) == 2
