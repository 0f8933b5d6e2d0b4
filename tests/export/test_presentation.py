"""Titles say what a building is and which floor a plan shows."""

from typing import Any

import msgspec
import pytest

from mansion_export.presentation import building_title, floor_title, main_door
from mansion_msgs_py.scene import Door, FloorScene


def scene(floor: int, floors: int, **more: Any) -> FloorScene:
    return FloorScene(
        building_id="b",
        floor=floor,
        floors=floors,
        label=more.pop("label", str(floor)),
        elevation=0.0,
        height=3.0,
        outline=[],
        rooms=[],
        walls=[],
        doors=[],
        **more,
    )


@pytest.mark.parametrize(
    ("kind", "numbers", "title"),
    [
        ("office", [1, 2, 3, 4], "Office, four floors"),
        ("fire_station", [1], "Fire station, one floor"),
        ("gym_building", [0, 1, 2], "Gym, two floors and a basement"),
        ("hotel", list(range(-1, 13)), "Hotel, 12 floors and two basements"),
    ],
)
def test_buildings_are_named_by_type_and_floors(kind, numbers, title):
    assert building_title([scene(n, len(numbers), building_type=kind) for n in numbers]) == title


def test_floors_are_named_as_people_do():
    assert floor_title(scene(1, 3, building_type="villa", label="G")) == "Villa: ground floor"
    assert floor_title(scene(2, 3, building_type="villa")) == "Villa: floor 2"
    assert floor_title(scene(0, 3, building_type="villa", label="B1")) == "Villa: basement 1"
    assert floor_title(scene(1, 1, building_type="flat")) == "Flat"


def test_the_main_door_is_the_widest_entrance_whatever_other_doors_come_first() -> None:
    def door(name: str, kind: str, room: str, width: float, x: float, y: float) -> Door:
        segment = ((x, y), (x + width, y))
        return Door(id=name, kind=kind, rooms=(room, None), width=width, height=2.1, segment=segment)  # type: ignore[arg-type]

    escape, side = door("d1", "single", "stair_1", 1.0, 0.0, 0.0), door("d2", "entrance", "hall", 1.0, 5.0, 0.0)
    main, garage = door("d3", "entrance", "hall", 1.8, 3.0, 9.0), door("d4", "garage", "garage", 3.0, 7.0, 0.0)
    ground = msgspec.structs.replace(scene(1, 1), doors=[escape, side, main, garage])
    assert main_door(ground) == main
    assert main_door(msgspec.structs.replace(ground, doors=[garage])) is None
