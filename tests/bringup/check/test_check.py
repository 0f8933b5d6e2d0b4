"""``mansion check`` finds nothing in a sound building and each kind of planted fault."""

import math
import shutil
from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest

from mansion_bringup.check.rooms import GAP, REACH, check_walls
from mansion_bringup.exporting import format_named, write_export
from mansion_bringup.pipeline.build import build_building
from mansion_bringup.verify import verify_building
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest
from planted_faults import PLANTED, Json, Plant, change, plant_in, standing

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


def scene(building: Path, floor: int = 2) -> Path:
    return building / f"floors/floor_{floor}/scene.json"


def kinds(building: Path) -> set[str]:
    return {fault.kind for fault in verify_building(building)}


def test_a_sound_building_has_no_fault(sound: Path) -> None:
    assert verify_building(sound) == []


@pytest.mark.parametrize(("plant", "kind"), PLANTED, ids=[f"{plant.__name__}-{kind}" for plant, kind in PLANTED])
def test_a_planted_fault_is_found(building: Path, plant: Plant, kind: str) -> None:
    plant_in(building, plant)
    assert kind in kinds(building)


def test_each_wall_that_is_taken_away_leaves_a_gap(sound: Path) -> None:
    storey = BuildingFolder(sound).scene(2)
    cores = {core.id for core in storey.cores}
    assert any(wall.exterior and cores & {wall.left, wall.right} for wall in storey.walls)
    for wall in storey.walls:
        # What is left of a shorter one lies within reach of the walls at its ends.
        if math.dist(*wall.segment) > 2 * REACH + GAP:
            others = [other for other in storey.walls if other is not wall]
            found = {fault.kind for fault in check_walls(msgspec.structs.replace(storey, walls=others))}
            assert found == {"WALL_GAP"}, wall


def test_sixty_kinds_of_faults_are_planted() -> None:
    assert len({plant for plant, _ in PLANTED}) >= 60


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
