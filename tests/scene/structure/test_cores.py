"""Cores on a floor: doors, poses, lifts."""

import math
from types import ModuleType

import pytest
from shapely.geometry import Point, Polygon

from mansion_msgs_py.scene import LiftDetails
from mansion_scene.structure import build_structure


@pytest.mark.parametrize("floor", [1, 2, 3])
def test_each_core_has_a_door_to_a_room_and_a_pose_before_it_facing_away(sample_floors: ModuleType, floor: int) -> None:
    structure = build_structure(sample_floors.office(floor))
    rooms = {room.id: Polygon(room.net_polygon) for room in structure.rooms}
    assert [core.id for core in structure.cores] == ["stair_1", "elevator_1"]
    for core in structure.cores:
        door = next(door for door in structure.doors if door.id == core.door)
        room = next(r for r in door.rooms if r != core.id)
        x, y, yaw = core.entrance
        assert rooms[room].buffer(-0.3).contains(Point(x, y))
        middle = [(a + b) / 2 for a, b in zip(*door.segment, strict=True)]
        away = math.degrees(math.atan2(y - middle[1], x - middle[0]))
        assert math.isclose((yaw - away + 180) % 360 - 180, 0.0, abs_tol=0.1)
        assert core.floors == [1, 2, 3]


def lift(structure) -> LiftDetails:
    details = next(core.details for core in structure.cores if core.type == "elevator")
    assert isinstance(details, LiftDetails)
    return details


def test_the_cabin_stands_in_its_shaft_behind_a_centred_door(sample_floors: ModuleType) -> None:
    structure = build_structure(sample_floors.office(2))
    core = structure.cores[1]
    (x0, y0, _), (x1, y1, top) = lift(structure).cabin
    shaft = Polygon(core.polygon)
    assert shaft.buffer(-0.05).covers(Polygon([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]))
    assert top > 2.1
    door = next(door for door in structure.doors if door.id == core.door)
    assert (door.segment[0][0] + door.segment[1][0]) / 2 == pytest.approx(shaft.centroid.x)
    assert lift(structure).facing == pytest.approx(90.0)


def test_the_button_panel_lists_every_floor_of_the_building_once(sample_floors: ModuleType) -> None:
    floors = tuple(range(-1, 31))
    request = sample_floors.office(1, floors=floors)
    request.labels[:] = ["B1", "G"] + [str(number) for number in floors[2:]]
    details = lift(build_structure(request))
    assert [button.floor for button in details.buttons] == list(floors)
    assert [button.label for button in details.buttons[:3]] == ["B1", "G", "1"]
    positions = [button.position for button in details.buttons]
    assert len(set(positions)) == len(positions)
    (x0, y0, z0), (x1, y1, z1) = details.cabin
    assert all(x0 < x < x1 and y0 < y < y1 and z0 < z < z1 for x, y, z in positions)


def test_the_call_panel_is_on_the_rooms_side_beside_the_door(sample_floors: ModuleType) -> None:
    structure = build_structure(sample_floors.office(2))
    door = next(d for d in structure.doors if d.kind == "sliding")
    panel = lift(structure).call_panel
    assert panel[1] > door.segment[0][1]
    nearest = min(math.dist(panel[:2], end) for end in door.segment)
    assert 0.1 < nearest < 0.5


def test_shaft_openings_are_only_where_the_lift_goes_on(sample_floors: ModuleType) -> None:
    found = {floor: lift(build_structure(sample_floors.office(floor))) for floor in (1, 2, 3)}
    assert [bool(found[f].floor_opening) for f in (1, 2, 3)] == [False, True, True]
    assert [bool(found[f].ceiling_opening) for f in (1, 2, 3)] == [True, True, False]
