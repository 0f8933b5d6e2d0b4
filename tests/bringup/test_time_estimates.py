"""Work that takes long is told of before it begins, and only that."""

from pathlib import Path

import msgspec

from mansion_bringup.time_estimates import LARGE, TOLD_FROM, check_seconds, model_seconds, notice
from mansion_msgs_py.building_folder import BuildingFolder, floor_directory
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.scene import FloorScene
from sample_building import write_building


def enlarged(scene: FloorScene, count: int) -> FloorScene:
    """The scene with copies of its first object, up to a number."""
    more = [msgspec.structs.replace(scene.objects[0], id=f"F1/office/copy_{k}") for k in range(count)]
    return msgspec.structs.replace(scene, objects=more)


def test_a_usual_building_is_worked_on_without_a_word(tmp_path: Path) -> None:
    folder = write_building(tmp_path / "house")
    scenes = BuildingFolder(folder).scenes()
    assert check_seconds(scenes) < TOLD_FROM and model_seconds(scenes) < TOLD_FROM
    assert notice(folder, "the check", check_seconds) == ""


def test_what_takes_long_is_told_with_its_time(tmp_path: Path) -> None:
    folder = write_building(tmp_path / "house")
    file = folder / floor_directory(1) / "scene.json"
    file.write_bytes(encode_bytes(enlarged(BuildingFolder(folder).scene(1), 20_000)))
    assert file.stat().st_size > LARGE
    told = notice(folder, "the check", check_seconds)
    assert told.startswith("the check of 20") and "takes about 14 s" in told


def test_many_corners_take_more_than_as_many_objects(tmp_path: Path) -> None:
    scene = BuildingFolder(write_building(tmp_path / "house")).scene(1)
    ring = [(0.001 * k, 0.0) for k in range(10_000)] + [(5.0, 4.0)]
    rooms = [msgspec.structs.replace(room, polygon=ring, net_polygon=ring) for room in scene.rooms]
    fine = msgspec.structs.replace(scene, rooms=rooms)
    assert model_seconds([fine]) > 10 * model_seconds([enlarged(scene, 10_000)])


def test_a_folder_that_cannot_be_read_is_left_to_the_work_itself(tmp_path: Path) -> None:
    folder = write_building(tmp_path / "house")
    (folder / floor_directory(1) / "scene.json").write_bytes(b" " * (LARGE + 1))
    assert notice(folder, "the check", check_seconds) == ""
    assert notice(tmp_path / "nowhere", "the check", check_seconds) == ""
