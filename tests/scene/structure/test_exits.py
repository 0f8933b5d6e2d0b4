"""Exits of ground floors and second doors of rooms, as many as the occupants ask for."""

import math

import pytest

from mansion_scene.structure import build_structure


def box(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def built(sample_floors, rooms, edges, building_type="school", floor=1):
    return build_structure(sample_floors.request(rooms, edges, building_type=building_type, floor=floor))


def doors_of(structure, room):
    return [door for door in structure.doors if room in door.rooms]


def outer_doors(structure):
    return [door for door in structure.doors if None in door.rooms]


def middle(door):
    (ax, ay), (bx, by) = door.segment
    return (ax + bx) / 2, (ay + by) / 2


def hall(width, kind="lecture_hall"):
    rooms = {"hall": ("corridor", box(0, 0, width, 3)), "room": (kind, box(0, 3, width, 11))}
    return rooms, [("hall", "room")]


@pytest.mark.parametrize(
    ("kind", "width", "least"), [("archive", 8, 1), ("lecture_hall", 12, 2), ("lecture_hall", 90, 3)]
)
def test_a_ground_floor_has_an_exit_for_so_many_occupants(sample_floors, kind, width, least):
    doors = outer_doors(built(sample_floors, *hall(width, kind)))
    assert len(doors) >= least
    if least == 1:
        assert len(doors) == 1


def test_two_exits_are_apart_by_a_third_of_the_diagonal(sample_floors):
    doors = outer_doors(built(sample_floors, *hall(30)))
    apart = max(math.dist(middle(one), middle(other)) for one in doors for other in doors)
    assert apart >= math.hypot(30, 11) / 3


def test_no_exit_leads_over_the_parapet_of_a_terrace(sample_floors):
    rooms = {
        "hall": ("corridor", box(0, 0, 4, 4)),
        "dining": ("restaurant", box(0, 4, 30, 11)),
        "terrace": ("roof_terrace", box(0, 11, 34, 15)),
    }
    edges = [("hall", "dining"), ("dining", "terrace")]
    doors = outer_doors(built(sample_floors, rooms, edges, building_type="restaurant_building"))
    assert len(doors) >= 2
    assert not any("F1/terrace" in door.rooms for door in doors)


def test_a_way_around_a_corner_counts_in_full(sample_floors):
    rooms = {"hall": ("corridor", box(0, 0, 20, 3)), "store": ("archive", box(0, 3, 20, 17))}
    assert len(outer_doors(built(sample_floors, rooms, [("hall", "store")]))) == 2


@pytest.mark.parametrize("floor", [1, 2])
def test_a_crowded_room_has_two_doors_apart(sample_floors, floor):
    structure = built(sample_floors, *hall(12), floor=floor)
    doors = doors_of(structure, f"F{floor}/room")
    assert len(doors) >= 2
    apart = max(math.dist(middle(one), middle(other)) for one in doors for other in doors)
    assert apart >= math.hypot(12, 8) / 3 - 0.1


def test_a_room_for_few_has_one_door(sample_floors):
    assert len(doors_of(built(sample_floors, *hall(12, "archive")), "F1/room")) == 1


def test_no_second_door_leads_through_a_store(sample_floors):
    rooms = {
        "hall": ("corridor", box(0, 0, 2, 10)),
        "room": ("lecture_hall", box(2, 0, 12, 10)),
        "store": ("storage", box(12, 0, 16, 10)),
    }
    structure = built(sample_floors, rooms, [("hall", "room"), ("room", "store")], floor=2)
    assert [set(door.rooms) for door in doors_of(structure, "F2/store")] == [{"F2/room", "F2/store"}]


def test_a_dwelling_keeps_its_one_door(sample_floors):
    assert len(outer_doors(built(sample_floors, *hall(30), building_type="house"))) == 1
