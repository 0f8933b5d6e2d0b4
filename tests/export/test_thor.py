"""AI2-THOR houses follow schema 1.0.0, and the validator finds what breaks it."""

import copy
import json

import msgspec
import pytest
from shapely.geometry import Polygon

from mansion_export.thor import house, validate_house
from mansion_export.thor.layers import four_colours


@pytest.fixture
def made(ground):
    return house(ground)


def kinds(faults):
    return {fault.kind for fault in faults}


def test_a_house_is_sound_and_the_same_each_time(made, floor_of):
    assert validate_house(made) == []
    assert json.dumps(made) == json.dumps(house(floor_of(1)))


def test_top_level_and_metadata_are_those_of_the_schema(made):
    assert set(made) == {"rooms", "walls", "doors", "windows", "objects", "proceduralParameters", "metadata"}
    metadata = made["metadata"]
    assert metadata["schema"] == "1.0.0"
    assert metadata["agent"] == metadata["agentPoses"]["default"]
    assert "standing" not in metadata["agentPoses"]["locobot"]


def test_plan_y_becomes_z_and_floors_run_clockwise(made, ground):
    room = next(room for room in made["rooms"] if room["id"] == "F1/bedroom_1")
    points = [(p["x"], p["z"]) for p in room["floorPolygon"]]
    assert sorted(points) == sorted((float(x), float(y)) for x, y in ground.rooms[0].polygon)
    assert not Polygon(points).exterior.is_ccw
    assert {p["y"] for p in room["floorPolygon"]} == {0.0}


def test_rotations_change_their_sense(made):
    plant = next(item for item in made["objects"] if item["assetId"] == "HousePlant_1")
    assert plant["rotation"] == {"x": 0, "y": 330.0, "z": 0}
    assert made["metadata"]["agent"]["rotation"]["y"] == 90.0


def test_positions_are_centres_and_small_objects_nest_in_what_carries_them(made):
    table = next(item for item in made["objects"] if item["assetId"] == "Dining_Table_1")
    assert table["position"] == {"x": 6.8, "y": 0.375, "z": 7.9}
    assert [child["assetId"] for child in table["children"]] == ["Cup_1"]
    assert not table["children"][0]["kinematic"]
    assert table["kinematic"]


def test_objects_without_an_asset_are_listed_and_not_exported(made, ground):
    omitted = {entry["id"] for entry in made["metadata"]["mansion"]["omitted"]}
    assert omitted == {item.id for item in ground.objects if item.asset_id is None}
    assert "F1/living_room_1/rug_9" in omitted


def test_what_an_omitted_object_carries_is_omitted_with_the_reason(ground):
    index, table = next((i, item) for i, item in enumerate(ground.objects) if item.category == "dining_table")
    ground.objects[index] = msgspec.structs.replace(table, asset_id=None)
    omitted = {e["id"]: e["reason"] for e in house(ground)["metadata"]["mansion"]["omitted"]}
    assert table.id in omitted["F1/kitchen_1/cup_1"]


def test_holes_are_counted_along_the_first_wall(made):
    walls = {wall["id"]: wall for wall in made["walls"]}
    door = next(door for door in made["doors"] if door["id"] == "F1/door_1")
    wall = walls[door["wall0"]]
    a, b = wall["polygon"][0], wall["polygon"][1]
    low, high = (point["x"] for point in door["holePolygon"])
    length = abs(b["x"] - a["x"])
    ends = sorted(a["x"] + (b["x"] - a["x"]) * t / length for t in (low, high))
    assert ends == pytest.approx([2.0, 2.9])
    assert (door["room0"], door["room1"]) == ("F1/hub", "F1/bedroom_1"), "opens away from room0"


def test_an_open_boundary_is_an_empty_wall_and_shares_a_layer(made):
    empty = [wall for wall in made["walls"] if wall.get("empty")]
    assert {wall["roomId"] for wall in empty} == {"F1/hub", "F1/living_room_1"}
    layers = {room["id"]: room["layer"] for room in made["rooms"]}
    assert layers["F1/hub"] == layers["F1/living_room_1"]
    assert layers["F1/hub"] != layers["F1/bedroom_1"]


def test_doors_to_cores_stay_shut_and_their_poses_are_told(made):
    stair = next(door for door in made["doors"] if door["id"] == "F1/door_6")
    assert stair["openness"] == 0
    assert stair["openable"]
    cores = made["metadata"]["mansion"]["cores"]
    assert {core["type"] for core in cores} == {"stair", "elevator"}


def test_a_room_whose_hole_touches_its_outline_keeps_all_its_floor(ground):
    ring = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (2.0, 10.0), (2.0, 8.0), (0.0, 8.0)]
    hole = [(2.0, 8.0), (6.0, 8.0), (6.0, 4.0), (2.0, 4.0)]
    room = msgspec.structs.replace(ground.rooms[0], polygon=ring, holes=[hole])
    scene = msgspec.structs.replace(ground, rooms=[room], doors=[], windows=[], objects=[])
    floor = Polygon([(p["x"], p["z"]) for p in house(scene)["rooms"][0]["floorPolygon"]])
    assert floor.is_valid
    assert floor.area == pytest.approx(Polygon(ring, [hole]).area, abs=1e-3)


def test_a_room_with_a_hole_becomes_one_simple_polygon(ground):
    index, hub = next((i, room) for i, room in enumerate(ground.rooms) if room.id == "F1/hub")
    ground.rooms[index] = msgspec.structs.replace(hub, holes=[[(4.0, 4.5), (5.0, 4.5), (5.0, 5.5), (4.0, 5.5)]])
    room = next(room for room in house(ground)["rooms"] if room["id"] == "F1/hub")
    ring = Polygon([(p["x"], p["z"]) for p in room["floorPolygon"]])
    assert ring.is_valid
    assert ring.area == pytest.approx(21.0, abs=0.05)


def broken_schema(made):
    made["metadata"]["schema"] = "0.0.1"


def broken_orientation(made):
    made["rooms"][0]["floorPolygon"].reverse()


def broken_twin(made):
    made["walls"].pop(0)


def broken_hole(made):
    made["doors"][0]["holePolygon"].append({"x": 1, "y": 1, "z": 0})


def broken_wide_hole(made):
    made["windows"][0]["holePolygon"][1]["x"] = 90.0


def broken_two_holes(made):
    made["windows"][0]["wall0"] = made["windows"][1]["wall0"]


def broken_layer(made):
    for room in made["rooms"]:
        room["layer"] = "Procedural0"
    for wall in made["walls"]:
        wall["layer"] = "Procedural0"


def broken_id(made):
    made["objects"][1]["id"] = made["objects"][0]["id"]


def broken_place(made):
    made["objects"][0]["position"]["x"] = 40.0


def broken_number(made):
    made["objects"][0]["position"]["y"] = float("nan")


def broken_door(made):
    for door in made["doors"]:
        door["openness"] = 0


@pytest.mark.parametrize(
    ("damage", "kind"),
    [
        (broken_schema, "form"),
        (broken_orientation, "polygon"),
        (broken_twin, "wall"),
        (broken_hole, "opening"),
        (broken_wide_hole, "opening"),
        (broken_two_holes, "opening"),
        (broken_layer, "layer"),
        (broken_id, "id"),
        (broken_place, "object"),
        (broken_number, "number"),
        (broken_door, "reach"),
    ],
)
def test_the_validator_finds_damage(made, damage, kind):
    damaged = copy.deepcopy(made)
    damage(damaged)
    assert kind in kinds(validate_house(damaged))


@pytest.mark.parametrize("part", ["rooms", "walls", "doors", "windows", "objects", "proceduralParameters", "metadata"])
@pytest.mark.parametrize(
    "other", [None, 3.5, "x", [None], [[]], {"a": 1}, [{"id": {}, "floorPolygon": 2, "children": [1]}]]
)
def test_parts_of_other_types_are_faults_of_form(ground, part, other):
    faults = validate_house({**house(ground), part: other})
    assert any(fault.kind in ("form", "polygon", "reach") for fault in faults)


def test_unknown_assets_are_faults(made):
    known = {"Bed_1", "Dining_Table_1", "Sofa_1", "HousePlant_1"}
    faults = validate_house(made, known)
    assert [fault.where for fault in faults] == ["F1/kitchen_1/cup_1"]


def test_a_full_room_is_reported_as_unreachable(ground):
    block = msgspec.structs.replace(
        ground.objects[0], id="F1/block", position=(10.0, 9.0, 0.5), size=(1.5, 1.5, 1.0), room="F1/storage_1"
    )
    ground.objects.append(block)
    faults = validate_house(house(ground))
    assert [fault.where for fault in faults if fault.kind == "reach"] == ["F1/storage_1"]


def test_four_colours_need_backtracking_no_more_than_planar_graphs_do():
    ring = [f"r{i}" for i in range(9)]
    pairs = [(a, b) for a, b in zip(ring, ring[1:] + ring[:1])] + [("hub", r) for r in ring]
    colours = four_colours(["hub", *ring], pairs)
    assert all(colours[a] != colours[b] for a, b in pairs)
