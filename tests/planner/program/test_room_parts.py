"""Corners and nooks of a home are furniture of a room, not rooms."""

import pytest

from mansion_msgs_py.program import FloorProgram
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


def floors(brief: str) -> list[FloorProgram]:
    return plan_building(BuildRequest(description=brief)).program.floors


@pytest.mark.parametrize(
    ("brief", "host", "category"),
    [
        ("A bungalow with a living room with a TV corner, a kitchen and two bedrooms", "living_room", "television"),
        ("A house with a living room with a reading nook, a kitchen and two bedrooms", "living_room", "armchair"),
        ("A flat with two bedrooms, a living room and a kitchen with a breakfast corner", "kitchen", "dining_table"),
        ("A cabin with a fireplace nook, a kitchen, a bedroom and a shower room", "living_room", "fireplace"),
    ],
)  # fmt: skip
def test_a_corner_is_furniture_of_the_room_that_it_is_part_of(brief: str, host: str, category: str) -> None:
    rooms = [room for floor in floors(brief) for room in floor.rooms]
    assert not any(part in room.id for room in rooms for part in ("corner", "nook"))
    wanted = {(room.room_type, item.category) for room in rooms for item in room.objects}
    assert (host, category) in wanted


def test_a_nook_of_a_stated_area_and_a_corner_of_a_public_building_are_rooms() -> None:
    house = floors("A house with a reading nook of 6 m2, a living room, a kitchen and two bedrooms")
    assert any(room.id == "reading_nook" for floor in house for room in floor.rooms)
    library = floors("A public library of 600 m2 with a children's corner")
    assert any(room.room_type == "childrens_area" for floor in library for room in floor.rooms)


def test_a_nook_to_sleep_in_is_a_bedroom_where_people_do_not_live_in_one_room() -> None:
    [cabin] = floors("A cabin of 60 m2 with a fireplace nook, a sleeping nook, a small kitchen and a shower room")
    kinds = [room.room_type for room in cabin.rooms]
    assert "bedroom" in kinds
    assert "living_room" in kinds
