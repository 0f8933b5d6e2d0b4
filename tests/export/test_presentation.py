"""Titles say what a building is and which floor a plan shows."""

from typing import Any

import pytest

from mansion_export.presentation import building_title, floor_title
from mansion_msgs_py.scene import FloorScene


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
