"""Shops, warehouses and restaurants lie on one storey where the brief says nothing of storeys."""

import pytest

from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


def plan(text: str) -> BuildingProgram:
    return plan_building(BuildRequest(description=text)).program


@pytest.mark.parametrize(
    "text",
    ["A supermarket of 1,000 m2", "A warehouse of 1,500 m2 with pallet racks", "A trattoria with sixty seats, 250 m2"],
)
def test_what_lies_on_the_ground_has_one_storey(text: str) -> None:
    assert len(plan(text).floors) == 1


def test_stated_storeys_stay() -> None:
    assert len(plan("A supermarket of two storeys, 1,000 m2").floors) == 2


def test_the_sales_area_takes_what_the_other_rooms_of_a_shop_leave() -> None:
    floor = plan("A supermarket of 1,000 m2 with four checkouts and a cold store").floors[0]
    areas = {room.id: room.area_estimate for room in floor.rooms}
    assert max(areas, key=lambda name: areas[name]) == "sales_area"
    assert areas["sales_area"] > 0.4 * floor.gross_floor_area
    assert not any("checkout" in name for name in areas)


def test_a_pet_gets_no_room() -> None:
    rooms = plan("A bungalow for two retired people with a cat, 120 m2, two bedrooms").floors[0].rooms
    assert not any("cat" in room.id.split("_") for room in rooms)


def test_the_library_of_a_home_is_a_room_and_stands_once() -> None:
    program = plan("A villa on two floors, about 380 m2, with a library and five bedrooms")
    libraries = [room.room_type for floor in program.floors for room in floor.rooms if "library" in room.room_type]
    assert libraries == ["library_room"]
