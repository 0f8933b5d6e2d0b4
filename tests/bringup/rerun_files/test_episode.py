"""An episode recorded for Rerun, read back with the reader of its library."""

from pathlib import Path

import msgspec
import pytest

from episode_tasks import mug_task
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.errors import MansionError
from mansion_tasks.agents.baselines import OracleAgent
from mansion_tasks.episodes.log import EpisodeLog
from mansion_tasks.episodes.port import LocalPort
from mansion_tasks.episodes.running import run_episode
from mansion_tasks.recordings.episode import RecordedEpisode
from read_rerun import TIME, Rows, read_rerun
from sample_building import write_building

pytest.importorskip("rerun")
pytest.importorskip("mcap_ros2")

MUG = "F1/office/mug_1"


@pytest.fixture(scope="module")
def building(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_building(tmp_path_factory.mktemp("building") / "sample")


@pytest.fixture(scope="module")
def log(building: Path) -> EpisodeLog:
    return run_episode(mug_task(), building, OracleAgent(), LocalPort())


@pytest.fixture(scope="module")
def recorded(log: EpisodeLog, building: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Rows, RecordedEpisode]:
    from mansion_bringup.rerun_files.episode import record_episode_for_rerun

    file = tmp_path_factory.mktemp("recorded") / "episode.rrd"
    made = record_episode_for_rerun(log, building, LocalPort(), file)
    assert [each.name for each in file.parent.iterdir()] == [file.name]
    return read_rerun(file), made


def test_the_messages_of_the_mcap_file_are_there_on_the_clock_of_the_world(
    recorded: tuple[Rows, RecordedEpisode], log: EpisodeLog
) -> None:
    rows, made = recorded
    poses = [row for row in rows["/mansion/robot_pose"] if "InstancePoses3D:translations" in row]
    assert len(poses) == made.messages["/mansion/robot_pose"] == len(log.steps) + 1
    for pose, step in zip(poses[1:], log.steps, strict=True):
        assert pose["InstancePoses3D:translations"][0][:2] == pytest.approx((step.pose.x, step.pose.y), abs=1e-5)
        assert pose[TIME] == pytest.approx(step.time * 1e9, abs=1e4)
    assert sum("GridMap:data" in row for row in rows["/map"]) == made.messages["/map"]
    assert poses[-1][TIME] == round(made.seconds * 1e9)


def test_every_floor_has_its_structure_and_stands_at_its_height(
    recorded: tuple[Rows, RecordedEpisode], building: Path
) -> None:
    rows, _ = recorded
    for scene in BuildingFolder(building).scenes():
        root = f"/building/floor_{scene.floor}"
        (place,) = rows[root]
        assert place["Transform3D:translation"][0] == pytest.approx((0.0, 0.0, scene.elevation))
        (mesh,) = rows[f"{root}/structure"]
        assert bytes(mesh["Asset3D:blob"][0])[:4] == b"glTF"
        (rooms,) = rows[f"{root}/rooms"]
        assert len(rooms["LineStrips3D:strips"]) == len(scene.rooms)


def test_objects_are_boxes_where_the_scene_has_them(recorded: tuple[Rows, RecordedEpisode], building: Path) -> None:
    rows, _ = recorded
    for scene in BuildingFolder(building).scenes():
        drawn = {}
        for entity, found in rows.items():
            if entity.startswith(f"/building/floor_{scene.floor}/objects/"):
                first = found[0]
                assert first[TIME] == 0
                drawn |= dict(zip(first["Boxes3D:labels"], first["Boxes3D:centers"], strict=True))
        assert set(drawn) == {item.id for item in scene.objects}
        for item in scene.objects:
            assert drawn[item.id] == pytest.approx(item.position, abs=1e-5)


def test_what_is_carried_leaves_one_room_and_comes_to_another(recorded: tuple[Rows, RecordedEpisode]) -> None:
    rows, _ = recorded
    office = rows["/building/floor_1/objects/office"]
    assert [MUG in row["Boxes3D:labels"] for row in office] == [True, False]
    rooms = [name for name, found in rows.items() if "/objects/" in name and MUG in found[-1]["Boxes3D:labels"]]
    assert len(rooms) == 1 and rooms[0].startswith("/building/floor_2/")
    held = rows["/held"]
    assert held[0]["Points3D:labels"] == [MUG] and held[0][TIME] == office[1][TIME]
    assert "Points3D:labels" not in held[-1]


def test_skills_and_changes_are_texts_and_the_way_grows(
    recorded: tuple[Rows, RecordedEpisode], log: EpisodeLog
) -> None:
    rows, _ = recorded
    texts = [row["TextLog:text"][0] for row in rows["/events"]]
    assert texts[0] == log.start.task.instruction
    for step in log.steps:
        assert any(text.startswith(f"{step.call.skill}(") and text.endswith(step.message) for text in texts)
    told = [text.removeprefix(f"{MUG}: ") for text in texts if text.startswith(MUG)]
    assert told[0].startswith("in the hand of ") and told[-1] == "in F2/kitchen"
    ways = [row for name in rows if name.startswith("/path/") for row in rows[name]]
    assert ways and all(len(row["LineStrips3D:strips"]) == 1 for row in ways)


def test_an_episode_of_another_building_leaves_no_file(log: EpisodeLog, building: Path, tmp_path: Path) -> None:
    from mansion_bringup.rerun_files.episode import record_episode_for_rerun

    elsewhere = msgspec.structs.replace(log.steps[0], floor=3)
    other = msgspec.structs.replace(log, steps=[elsewhere, *log.steps[1:]])
    with pytest.raises(MansionError, match="cannot be reproduced"):
        record_episode_for_rerun(other, building, LocalPort(), tmp_path / "episode.rrd")
    assert list(tmp_path.iterdir()) == []
