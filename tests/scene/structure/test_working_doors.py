"""Doors between rooms that people pass from one into the other."""

import msgspec

from mansion_msgs_py.program import RoomProgram
from mansion_scene.structure import build_structure


def box(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def joined(sample_floors, kinds, building_type):
    """The pairs of rooms that have a door, on a corridor with three rooms side by side."""
    rooms = {"hall": ("corridor", box(0, 0, 18, 2.4))}
    rooms |= {name: (kind, box(6 * n, 2.4, 6 * n + 6, 8)) for n, (name, kind) in enumerate(kinds.items())}
    edges = [("hall", name) for name in kinds]
    structure = build_structure(sample_floors.request(rooms, edges, building_type=building_type))
    return {frozenset(room.split("/")[-1] for room in door.rooms if room) for door in structure.doors}


def test_a_kitchen_opens_to_the_room_that_it_cooks_for(sample_floors):
    doors = joined(sample_floors, {"a": "cafeteria", "b": "commercial_kitchen", "c": "private_office"}, "office")
    assert frozenset({"a", "b"}) in doors and frozenset({"b", "c"}) not in doors


def test_a_room_is_reached_from_one_other_of_each_use(sample_floors):
    doors = joined(sample_floors, {"a": "operating_room", "b": "scrub_room", "c": "operating_room"}, "hospital")
    assert len({frozenset({"a", "b"}), frozenset({"b", "c"})} & doors) == 1


def test_visitors_go_from_gallery_to_gallery_in_museums_alone(sample_floors):
    kinds = dict.fromkeys("abc", "gallery")
    through = {frozenset("ab"), frozenset("bc")}
    assert through <= joined(sample_floors, kinds, "museum")
    assert not through & joined(sample_floors, kinds, "office")


def test_every_room_keeps_its_door_to_the_corridor(sample_floors):
    kinds = {"a": "changing_room", "b": "shower_area", "c": "indoor_pool"}
    doors = joined(sample_floors, kinds, "swimming_center")
    assert {frozenset({"hall", name}) for name in kinds} <= doors
    assert {frozenset("ab"), frozenset("bc")} <= doors


def test_a_door_of_an_operating_room_lets_a_bed_pass(sample_floors):
    rooms = {"hall": ("corridor", box(0, 0, 12, 2.4)), "a": ("operating_room", box(0, 2.4, 6, 9))}
    rooms["b"] = ("scrub_room", box(6, 2.4, 12, 9))
    request = sample_floors.request(rooms, [("hall", "a"), ("hall", "b")], building_type="hospital")
    (door,) = [door for door in build_structure(request).doors if set(door.rooms) == {"F1/a", "F1/b"}]
    assert door.width >= 1.054


def test_a_store_that_the_brief_wants_beside_a_room_opens_to_it(sample_floors):
    rooms = {"hall": ("corridor", box(0, 0, 12, 2.4)), "a": ("workshop", box(0, 2.4, 6, 9))}
    rooms["b"] = ("storage", box(6, 2.4, 12, 9))
    request = sample_floors.request(rooms, [("hall", "a"), ("hall", "b")], building_type="car_workshop_building")
    beside = RoomProgram(id="b", area_estimate=39.0, room_type="storage", adjacent_to=["a"])
    wished = msgspec.structs.replace(request, floor=msgspec.structs.replace(request.floor, rooms=[beside]))
    for asked, expected in ((request, 0), (wished, 1)):
        doors = [door for door in build_structure(asked).doors if set(door.rooms) == {"F1/a", "F1/b"}]
        assert len(doors) == expected
