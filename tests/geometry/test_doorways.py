"""Which doors let a robot through."""

import msgspec
import pytest

from mansion_geometry.doorways import depth_of_doors, is_passable, is_walkway
from mansion_msgs_py.scene import Door
from sample_building import scene

DOOR = Door(
    id="F1/door_1", kind="single", segment=((0.0, 0.0), (0.9, 0.0)), rooms=("F1/hall", "F1/office"), width=0.9,
    height=2.1,
)  # fmt: skip


@pytest.mark.parametrize(
    ("kind", "is_open", "expected"), [("single", True, True), ("single", False, False), ("doorway", False, True)]
)
def test_what_stands_open_or_has_no_leaf_is_passable(kind: str, is_open: bool, expected: bool) -> None:
    assert is_passable(msgspec.structs.replace(DOOR, kind=kind, is_open=is_open)) is expected


@pytest.mark.parametrize(
    ("rooms", "expected"),
    [(("F1/hall", "F1/office"), True), (("F1/hall", None), False), (("F1/hall", "elevator_1"), False)],
)
def test_robots_drive_from_room_to_room_not_outside_nor_into_shafts(rooms: tuple, expected: bool) -> None:
    assert is_walkway(msgspec.structs.replace(DOOR, rooms=rooms), ["elevator_1"]) is expected


def test_a_door_is_as_deep_as_its_wall() -> None:
    floor = scene(1, [1, 2])
    walls = {wall.id: wall.thickness for wall in floor.walls}
    depths = depth_of_doors(floor)
    assert set(depths) == {door.id for door in floor.doors}
    assert all(depths[door.id] == walls[door.wall] for door in floor.doors if door.wall in walls)
    lost = msgspec.structs.replace(floor, doors=[msgspec.structs.replace(DOOR, wall="")])
    assert depth_of_doors(lost) == {"F1/door_1": 0.12}
