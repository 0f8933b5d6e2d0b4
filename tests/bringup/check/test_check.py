"""``mansion check`` finds nothing in a sound building and each kind of planted fault."""

import itertools
import json
import math
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from shapely import Polygon

from mansion_bringup.exporting import format_named, write_export
from mansion_bringup.pipeline.build import build_building
from mansion_bringup.verify import verify_building
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest

Json = dict[str, Any]
BRIEF = "a three-storey office with an elevator"


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> Path:
    request = BuildRequest(description=BRIEF, floors=3, floor_area=200.0, seed=4)
    return build_building(request, tmp_path_factory.mktemp("check") / "office", jobs=2).path


@pytest.fixture
def building(sound: Path, tmp_path: Path) -> Iterator[Path]:
    copy = tmp_path / "office"
    shutil.copytree(sound, copy)
    yield copy


def change(file: Path, edit: Callable[[Json], None]) -> None:
    value = json.loads(file.read_text())
    edit(value)
    file.write_text(json.dumps(value))


def scene(building: Path, floor: int = 2) -> Path:
    return building / f"floors/floor_{floor}/scene.json"


def kinds(building: Path) -> set[str]:
    return {fault.kind for fault in verify_building(building)}


def standing(value: Json) -> Json:
    """A thing on the floor of a room that is no passage, and that carries nothing."""
    carriers = {thing.get("parent") for thing in value["objects"]}
    ends = {room["id"] for room in value["rooms"] if "corridor" not in room["id"]}
    ends -= {room["id"] for room in value["rooms"] if room["kind"] == "main"}
    return next(
        thing
        for thing in value["objects"]
        if thing.get("mount", "floor") == "floor"
        and thing["size"][2] > 0.4
        and thing["id"] not in carriers
        and thing["room"] in ends
    )


def first_door(value: Json) -> Json:
    return next(door for door in value["doors"] if door["kind"] in ("single", "glazed", "doorway"))


def move(thing: Json, dx: float, dy: float, dz: float = 0.0) -> None:
    x, y, z = thing["position"]
    thing["position"] = [x + dx, y + dy, z + dz]


def outside(value: Json) -> None:
    move(standing(value), 400.0, 0.0)


def floating(value: Json) -> None:
    move(standing(value), 0.0, 0.0, 0.5)


def doubled_id(value: Json) -> None:
    value["objects"][1]["id"] = value["objects"][0]["id"]


def foreign_id(value: Json) -> None:
    value["walls"][0]["id"] = "wall_without_floor"


def overlapping(value: Json) -> None:
    one = standing(value)
    other = dict(one, id=one["id"] + "_again")
    value["objects"].append(other)


def blocked_door(value: Json) -> None:
    thing, door = standing(value), first_door(value)
    (x0, y0), (x1, y1) = door["segment"]
    thing["position"] = [(x0 + x1) / 2, (y0 + y1) / 2, thing["position"][2]]
    thing["room"] = door["rooms"][0]


def lost_parent(value: Json) -> None:
    small = next(thing for thing in value["objects"] if thing.get("parent"))
    small["parent"] = "F2/nowhere/table_1"


def off_the_table(value: Json) -> None:
    small = next(thing for thing in value["objects"] if thing.get("mount") == "surface")
    move(small, 0.0, 0.0, 0.4)


def door_off_its_wall(value: Json) -> None:
    door = first_door(value)
    door["segment"] = [[x + 0.7, y + 0.7] for x, y in door["segment"]]


def narrow_door(value: Json) -> None:
    door = first_door(value)
    (x0, y0), (x1, y1) = door["segment"]
    door["segment"] = [[x0, y0], [(x0 + x1) / 2, (y0 + y1) / 2]]
    door["width"] = math.dist(*door["segment"])


def missing_door(value: Json) -> None:
    value["doors"].remove(first_door(value))


def window_inside(value: Json) -> None:
    inner = next(wall for wall in value["walls"] if not wall.get("exterior"))
    value["windows"][0]["wall"] = inner["id"]


def shifted_core(value: Json) -> None:
    core = value["cores"][0]
    core["polygon"] = [[x + 0.5, y] for x, y in core["polygon"]]


def core_without_door(value: Json) -> None:
    value["cores"][0]["door"] = "F2/door_none"


def steep_stair(value: Json) -> None:
    stair = next(core for core in value["cores"] if core["type"] == "stair")
    stair["details"]["riser"] = 0.24


def missing_room(value: Json) -> None:
    room = next(room for room in value["rooms"] if room["kind"] == "Entities")
    value["rooms"].remove(room)


def swollen(room: Json) -> list[list[float]]:
    """The outline of a room with its right side a metre further out."""
    right = max(x for x, _ in room["polygon"])
    return [[x + 1.0 if x == right else x, y] for x, y in room["polygon"]]


def swollen_room(value: Json) -> None:
    room, polygon = next(
        (room, swollen(room))
        for room, other in itertools.permutations(value["rooms"], 2)
        if room["kind"] == "Entities" and Polygon(swollen(room)).intersection(Polygon(other["polygon"])).area > 0.5
    )
    room["polygon"] = polygon


def gap_in_walls(value: Json) -> None:
    longest = max(value["walls"], key=lambda wall: math.dist(*wall["segment"]))
    value["walls"].remove(longest)


def buried_spawn(value: Json) -> None:
    value["spawn"].update(x=-50.0, y=-50.0)


def wrong_elevation(value: Json) -> None:
    value["elevation"] += 1.0


def other_building(value: Json) -> None:
    value["building_id"] = "somebody-elses"


def stair(value: Json) -> Json:
    return next(core["details"] for core in value["cores"] if core["type"] == "stair")


def lift(value: Json) -> Json:
    return next(core["details"] for core in value["cores"] if core["type"] == "elevator")


def removed_tread(value: Json) -> None:
    del stair(value)["treads"][3]


def removed_flights(value: Json) -> None:
    stair(value).update(treads=[], landings=[])


def narrow_flights(value: Json) -> None:
    for low, high in stair(value)["treads"]:
        across = max((0, 1), key=lambda axis: high[axis] - low[axis])
        high[across] = low[across] + 0.3


def landing_elsewhere(value: Json) -> None:
    for corner in stair(value)["landings"][0]:
        corner[0] += 8.0


def scattered_treads(value: Json) -> None:
    low, high = stair(value)["treads"][2]
    across = max((0, 1), key=lambda axis: high[axis] - low[axis])
    for corner in (low, high):
        corner[across] += 1.2


def no_opening_above(value: Json) -> None:
    stair(value)["ceiling_opening"] = []


def no_opening_below(value: Json) -> None:
    stair(value)["floor_opening"] = []


def closed_shaft(value: Json) -> None:
    lift(value)["ceiling_opening"] = []


def cabin_elsewhere(value: Json) -> None:
    for corner in lift(value)["cabin"]:
        corner[0] += 40.0


def lost_button(value: Json) -> None:
    del lift(value)["buttons"][0]


def sill_below_the_floor(value: Json) -> None:
    value["windows"][0]["sill"] = -0.4


def unknown_asset(value: Json) -> None:
    standing(value)["asset"] = "flying_saucer_1"


def light_elsewhere(value: Json) -> None:
    next(light for light in value["lights"] if light["kind"] != "directional")["position"][0] = 300.0


PLANTED: list[tuple[Callable[[Json], None], str]] = [
    (outside, "OBJECT_OUTSIDE"),
    (floating, "OBJECT_FLOATS"),
    (doubled_id, "ID"),
    (foreign_id, "ID"),
    (overlapping, "OBJECT_OVERLAP"),
    (blocked_door, "DOOR_BLOCKED"),
    (lost_parent, "OBJECT_PARENT"),
    (off_the_table, "OBJECT_FLOATS"),
    (door_off_its_wall, "DOOR_WALL"),
    (narrow_door, "DOOR_NARROW"),
    (missing_door, "DOOR_MISSING"),
    (missing_door, "ROOM_UNREACHABLE"),
    (window_inside, "WINDOW_WALL"),
    (shifted_core, "CORE_SHIFTED"),
    (core_without_door, "CORE_DOOR"),
    (steep_stair, "STAIR_RISER"),
    (missing_room, "ROOM_MISSING"),
    (missing_room, "COVERAGE"),
    (swollen_room, "ROOM_OVERLAP"),
    (gap_in_walls, "WALL_GAP"),
    (buried_spawn, "SPAWN"),
    (wrong_elevation, "ELEVATION"),
    (other_building, "BUILDING_ID"),
    (removed_tread, "STAIR_STEPS"),
    (removed_flights, "STAIR_STEPS"),
    (narrow_flights, "STAIR_NARROW"),
    (landing_elsewhere, "STAIR_OUTSIDE"),
    (scattered_treads, "STAIR_STEPS"),
    (no_opening_above, "CORE_OPENING"),
    (no_opening_below, "CORE_OPENING"),
    (closed_shaft, "CORE_OPENING"),
    (cabin_elsewhere, "LIFT_CABIN"),
    (lost_button, "LIFT_BUTTONS"),
    (sill_below_the_floor, "WINDOW_SILL"),
    (unknown_asset, "OBJECT_ASSET"),
    (light_elsewhere, "LIGHT_OUTSIDE"),
]


def test_a_sound_building_has_no_fault(sound: Path) -> None:
    assert verify_building(sound) == []


@pytest.mark.parametrize(("plant", "kind"), PLANTED, ids=[f"{plant.__name__}-{kind}" for plant, kind in PLANTED])
def test_a_planted_fault_in_a_scene_is_found(building: Path, plant: Callable[[Json], None], kind: str) -> None:
    change(scene(building), plant)
    assert kind in kinds(building)


def test_a_furnished_door_way_cuts_off_what_lies_behind(building: Path) -> None:
    def wall_in(value: Json) -> None:
        thing = standing(value)
        for room in value["rooms"]:
            if room["id"] == thing["room"]:
                xs = [x for x, _ in room["net_polygon"]]
                ys = [y for _, y in room["net_polygon"]]
                thing["size"] = [max(xs) - min(xs), max(ys) - min(ys), 1.0]
                thing["rotation"] = 0.0
                thing["position"] = [(max(xs) + min(xs)) / 2, (max(ys) + min(ys)) / 2, 0.5]

    change(scene(building), wall_in)
    assert {"ROOM_UNREACHABLE", "OBJECT_UNREACHABLE"} & kinds(building)


def test_a_number_that_is_not_finite_is_found(building: Path) -> None:
    text = scene(building).read_text()
    scene(building).write_text(text.replace('"elevation": ', '"elevation": 1e999, "was": ', 1))
    assert "FILE" in kinds(building)


def test_a_missing_file_is_named(building: Path) -> None:
    (building / "floors/floor_1/plan.svg").unlink()
    assert [(f.kind, f.where) for f in verify_building(building)] == [("FILE", "floors/floor_1/plan.svg")]


def test_files_that_a_build_was_not_asked_for_are_judged_where_they_are_there(building: Path) -> None:
    assert not (building / "floors/floor_1/house.json").exists()
    write_export(building, format_named("thor"))
    write_export(building, format_named("nav2"))
    assert verify_building(building) == []
    change(building / "floors/floor_2/house.json", lambda house: house["rooms"][0].pop("floorPolygon"))
    image = building / "floors/floor_3/map.pgm"
    image.write_bytes(image.read_bytes().replace(image.read_bytes().split()[1], b"1", 1))
    faults = [(fault.kind, fault.where) for fault in verify_building(building)]
    assert faults[0] == ("FILE", "floors/floor_3/map.pgm")
    assert set(faults[1:]) == {("HOUSE", "floors/floor_2/house.json")}


def test_a_file_that_the_index_names_must_be_there(building: Path) -> None:
    named = "floors/floor_2/house.json"
    change(building / "building.json", lambda index: index["floors"][1]["files"].update(house=named))
    assert [(f.kind, f.where) for f in verify_building(building)] == [("FILE", named)]


def test_a_cut_scene_file_is_named(building: Path) -> None:
    scene(building).write_text(scene(building).read_text()[:1000])
    faults = verify_building(building)
    assert [fault.kind for fault in faults] == ["FILE"]
    assert "floor_2/scene.json" in str(faults[0])


def test_another_number_of_floors_than_asked_is_found(building: Path) -> None:
    change(building / "building.json", lambda value: value["request"].update(floors=5))
    assert "FLOOR_COUNT" in kinds(building)


def test_another_area_than_asked_is_found(building: Path) -> None:
    change(building / "building.json", lambda value: value["request"].update(floor_area=900.0))
    assert "AREA" in kinds(building)


def test_no_way_in_from_outside_is_found(building: Path) -> None:
    def without_entrance(value: Json) -> None:
        value["doors"] = [door for door in value["doors"] if None not in door["rooms"]]

    change(scene(building, 1), without_entrance)
    assert "ENTRANCE" in kinds(building)


def test_a_folder_that_is_no_building_is_refused(tmp_path: Path) -> None:
    with pytest.raises(MansionError, match="mansion build"):
        verify_building(tmp_path)


@pytest.mark.parametrize("name", ["rooms", "objects", "area", "elevation", "height"])
def test_an_index_that_counts_wrongly_is_found(building: Path, name: str) -> None:
    change(building / "building.json", lambda value: value["floors"][1].update({name: value["floors"][1][name] + 1}))
    assert "COUNT" in kinds(building)


@pytest.mark.parametrize("name", ["rooms", "objects"])
def test_a_total_that_is_wrong_is_found(building: Path, name: str) -> None:
    change(building / "building.json", lambda value: value["checks"].update({name: value["checks"][name] + 1}))
    assert kinds(building) == {"COUNT"}
