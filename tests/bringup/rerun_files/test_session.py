"""A session of the graph converted for Rerun, read back with the reader of its library."""

from pathlib import Path

import msgspec
import pytest

from mansion_msgs_py.codec import encode
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.world import ObjectState, Pose2D, SkillChange, WorldEvent
from mansion_skills.world.building import LoadedBuilding
from mansion_skills.world.overlay import overlay_path, save_overlay
from mansion_skills.world.world import World
from mansion_tasks.recordings.mcap_file import McapFile
from mansion_tasks.recordings.messages import path, pose_stamped
from read_rerun import TIME, Rows, read_rerun
from sample_building import write_building

pytest.importorskip("rerun")
pytest.importorskip("mcap_ros2")

START = 1_700_000_000_000_000_000
SECOND = 1_000_000_000
MUG = "F1/office/mug_1"


@pytest.fixture
def building(tmp_path: Path) -> Path:
    return write_building(tmp_path / "sample")


def scenes(building: Path) -> list[FloorScene]:
    return LoadedBuilding(building).scenes()


def some_door(building: Path) -> str:
    return next(door.id for door in scenes(building)[0].doors if door.kind not in ("open", "doorway", "frame"))


def event(step: int, skill: str, *changed: SkillChange) -> str:
    return encode(WorldEvent(step=step, time=float(step), session="default", skill=skill, changed=list(changed)))


def write_session(file: Path, building: Path, *, announced: bool) -> Path:
    """Write a session in which a robot takes the mug, drives, and closes a door."""
    held = ObjectState(id=MUG, held_by="default")
    door = some_door(building)
    events = [
        event(1, "PickUp", SkillChange(what=f"{MUG}.place", after=held)),
        event(2, "CallElevator", SkillChange(what="elevator_1.floor", before=2, after=1)),
        event(3, "CloseDoor", SkillChange(what=f"{door}.open", before=True, after=False)),
    ]
    with file.open("wb") as stream, McapFile(stream) as mcap:
        mcap.write("/mansion/robot_pose", "geometry_msgs/PoseStamped", pose_stamped(0.0, Pose2D(x=1, y=2), 0.0), START)
        if announced:
            for scene in scenes(building):
                mcap.write("/mansion/floor_scene", "std_msgs/String", {"data": encode(scene)}, START)
        for number, text in enumerate(events, start=1):
            mcap.write("/mansion/world_events", "std_msgs/String", {"data": text}, START + number * SECOND)
        way = path(4.0, [(1.0, 2.0), (3.0, 2.0)], 0.0)
        mcap.write("/mansion/path", "nav_msgs/Path", way, START + 4 * SECOND)
    return file


def texts(rows: Rows) -> list[str]:
    return [row["TextLog:text"][0] for row in rows["/events"]]


@pytest.mark.parametrize("announced", [True, False])
def test_the_building_follows_the_events_from_topic_or_folder(
    building: Path, tmp_path: Path, *, announced: bool
) -> None:
    from mansion_bringup.rerun_files.session import convert_session, starting_world

    messages = write_session(tmp_path / "session.mcap", building, announced=announced)
    convert_session(messages, tmp_path / "session.rrd", None if announced else starting_world(building))
    rows = read_rerun(tmp_path / "session.rrd")
    office = rows["/building/floor_1/objects/office"]
    assert [MUG in row["Boxes3D:labels"] for row in office] == [True, False]
    assert [row[TIME] for row in office] == [START, START + SECOND]
    door = some_door(building)
    closed = [door in row["Boxes3D:labels"] for row in rows["/building/floor_1/closed_doors"]]
    assert closed[-1] and len(closed) <= 2
    assert texts(rows) == [
        "PickUp of default",
        f"{MUG}: in the hand of default",
        "CallElevator of default",
        "elevator_1.floor: 2 -> 1",
        "CloseDoor of default",
        f"{door}: closed",
    ]
    (way,) = rows["/path/0"]
    assert way[TIME] == START + 4 * SECOND and len(way["LineStrips3D:strips"][0]) == 2
    assert any("InstancePoses3D:translations" in row for row in rows["/mansion/robot_pose"])


def test_a_session_without_a_known_building_has_messages_and_texts(building: Path, tmp_path: Path) -> None:
    from mansion_bringup.rerun_files.session import convert_session

    messages = write_session(tmp_path / "session.mcap", building, announced=False)
    convert_session(messages, tmp_path / "session.rrd")
    rows = read_rerun(tmp_path / "session.rrd")
    assert not any(entity.startswith("/building") for entity in rows)
    assert "elevator_1.floor: 2 -> 1" in texts(rows)
    assert "/mansion/robot_pose" in rows


def test_a_building_begins_as_robots_left_it(building: Path, tmp_path: Path) -> None:
    from mansion_bringup.rerun_files.session import starting_world

    world = World(LoadedBuilding(building))
    robot = world.add_robot("default")
    desk = world.objects.state(MUG)
    world.objects.put(msgspec.structs.replace(desk, states={**desk.states, "filled": True}))
    save_overlay(overlay_path(building, "default"), world.state(robot))
    assert starting_world(building).objects.state(MUG).states["filled"] is True


def test_a_folder_that_is_no_building_is_named(tmp_path: Path) -> None:
    from mansion_bringup.rerun_files.session import starting_world

    with pytest.raises(MansionError, match=r"holds no building\.json"):
        starting_world(tmp_path)
