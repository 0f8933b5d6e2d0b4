"""Two sleep in the main bedroom of a home, one in each smaller one."""

import pytest

from mansion_msgs_py.scene import SceneRoom
from mansion_scene.bedrooms import slept_in_as


def bedroom(number: int, area: float, *, room_type: str = "bedroom", name: str = "") -> SceneRoom:
    side = area**0.5
    square = [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)]
    return SceneRoom(
        id=f"F1/{room_type}_{number}",
        room_type=room_type,
        name=name or f"Bedroom {number}",
        polygon=square,
        net_polygon=square,
        area=area,
        kind="area",
    )


@pytest.mark.parametrize("building", ["house", "flat", "some_new_kind_of_home"])
def test_the_largest_bedroom_of_a_home_is_for_two(building: str) -> None:
    rooms = [bedroom(1, 10.0), bedroom(2, 14.0), bedroom(3, 9.0)]
    assert [slept_in_as(room, rooms, building) for room in rooms] == [
        "smaller_bedroom",
        "master_bedroom",
        "smaller_bedroom",
    ]


def test_a_home_with_a_master_bedroom_has_no_other() -> None:
    rooms = [bedroom(1, 12.0), bedroom(2, 11.0, room_type="master_bedroom")]
    assert [slept_in_as(room, rooms, "house") for room in rooms] == ["smaller_bedroom", "master_bedroom"]


def test_names_that_say_who_sleeps_there_and_other_buildings_are_left_alone() -> None:
    rooms = [bedroom(1, 10.0, name="Double bedroom"), bedroom(2, 14.0)]
    assert slept_in_as(rooms[0], rooms, "house") == "bedroom"
    assert slept_in_as(rooms[1], rooms, "hostel") == "bedroom"


def test_bedrooms_of_several_homes_on_a_floor_stay_as_they_are() -> None:
    rooms = [bedroom(1, 10.0), *(bedroom(n, 8.0, room_type="kitchen") for n in (2, 3))]
    assert slept_in_as(rooms[0], rooms, "apartment_building") == "bedroom"
