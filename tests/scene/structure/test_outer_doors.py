"""Garage doors: wide, to the outside, on the ground floor, and only where vehicles drive in."""

import math

import msgspec
import pytest

from mansion_scene.structure import build_structure
from mansion_scene.structure.dimensions import WALL_END

NARROWEST = 2.4


def with_garage(sample_floors, floor=1, seed=3):
    """A floor whose last room with outer walls is a garage, and that room's id."""
    request = sample_floors.random_floor(seed, floor)
    plain = build_structure(request)
    outer = {}
    for wall in plain.walls:
        if wall.exterior:
            length = math.dist(*wall.segment)
            outer[wall.left] = max(outer.get(wall.left, 0.0), length)
    entered = {door.rooms[0] for door in plain.doors if None in door.rooms}
    chosen = max((room for room in outer if room not in entered), key=lambda room: outer[room])
    nodes = [
        msgspec.structs.replace(node, room_type="garage") if f"F{floor}/{node.id}" == chosen else node
        for node in request.topology.nodes
    ]
    topology = msgspec.structs.replace(request.topology, nodes=nodes)
    return msgspec.structs.replace(request, topology=topology), chosen


def garage_doors(structure):
    return [door for door in structure.doors if door.kind == "garage"]


@pytest.mark.parametrize("seed", range(6))
def test_a_garage_has_one_wide_closed_door_to_the_outside(sample_floors, seed):
    request, garage = with_garage(sample_floors, seed=seed)
    structure = build_structure(request)
    (door,) = garage_doors(structure)
    wall = next(wall for wall in structure.walls if wall.id == door.wall)
    assert door.rooms == (garage, None)
    assert wall.exterior
    assert door.width >= NARROWEST - 1e-6
    assert math.dist(*wall.segment) >= door.width + 2 * WALL_END - 0.5
    assert not door.is_open
    assert door.hinge == "none"
    assert 2.1 < door.height < wall.height


def test_a_garage_with_two_metres_of_outer_wall_says_why_it_has_none(sample_floors):
    rooms = {
        "hall": ("hallway", [(0.0, 0.0), (4.0, 0.0), (4.0, 8.0), (0.0, 8.0)]),
        "garage": ("garage", [(4.0, 0.0), (6.0, 0.0), (6.0, 8.0), (4.0, 8.0)]),
        "study": ("study", [(6.0, 0.0), (9.0, 0.0), (9.0, 8.0), (6.0, 8.0)]),
    }
    request = sample_floors.request(rooms, [("hall", "garage"), ("garage", "study")])
    structure = build_structure(request)
    assert not garage_doors(structure)
    (note,) = structure.downgrades
    assert note.wish == "a garage door for F1/garage"
    assert "2.70 m" in note.reason


def test_upper_floors_and_other_rooms_have_none(sample_floors):
    request, _ = with_garage(sample_floors, floor=2)
    assert not garage_doors(build_structure(request))
    assert not garage_doors(build_structure(sample_floors.random_floor(3, 1)))


def test_the_entrance_stays_the_first_door_to_the_outside(sample_floors):
    request, _ = with_garage(sample_floors)
    outer = [door for door in build_structure(request).doors if None in door.rooms]
    assert outer[0].kind == "entrance"


def test_no_window_overlaps_a_garage_door(sample_floors):
    for seed in range(6):
        request, _ = with_garage(sample_floors, seed=seed)
        structure = build_structure(request)
        for door in garage_doors(structure):
            assert all(window.wall != door.wall for window in structure.windows)


def test_a_hall_of_fire_engines_has_a_tall_door_for_each_bay(sample_floors):
    rooms = {
        "bay": ("apparatus_bay", [(0.0, 0.0), (24.0, 0.0), (24.0, 9.0), (0.0, 9.0)]),
        "hall": ("hallway", [(0.0, 9.0), (24.0, 9.0), (24.0, 14.0), (0.0, 14.0)]),
    }
    structure = build_structure(sample_floors.request(rooms, [("hall", "bay")]))
    doors = garage_doors(structure)
    assert len(doors) == 3
    assert all(door.width >= 3.7 and door.height > 2.5 for door in doors)
