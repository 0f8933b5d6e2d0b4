"""A recorded episode, read back with the reader of the library."""

from itertools import pairwise
from pathlib import Path
from typing import Any

import msgspec
import pytest

from episode_tasks import mug_task
from mansion_msgs_py.codec import decode
from mansion_msgs_py.errors import MansionError
from mansion_tasks.agents.baselines import OracleAgent
from mansion_tasks.episodes.log import EpisodeEnd, EpisodeLog, EpisodeStart, EpisodeStep
from mansion_tasks.episodes.port import LocalPort
from mansion_tasks.episodes.running import run_episode
from mansion_tasks.recordings.episode import CAMERA, EPISODE_TOPICS, RecordedEpisode, record_episode

pytest.importorskip("mcap_ros2")


@pytest.fixture
def log(building: Path) -> EpisodeLog:
    return run_episode(mug_task(), building, OracleAgent(), LocalPort())


def read(file: Path) -> list[Any]:
    """Return every message of a file with its channel and schema, decoded, as it lies in the file."""
    from mcap.reader import make_reader
    from mcap_ros2.decoder import DecoderFactory

    with file.open("rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()])
        return list(reader.iter_decoded_messages(log_time_order=False))


def by_topic(file: Path) -> dict[str, list[Any]]:
    found: dict[str, list[Any]] = {}
    for entry in read(file):
        found.setdefault(entry.channel.topic, []).append(entry.decoded_message)
    return found


@pytest.fixture
def recorded(log: EpisodeLog, building: Path, tmp_path: Path) -> tuple[Path, RecordedEpisode]:
    file = tmp_path / "episode.mcap"
    return file, record_episode(log, building, LocalPort(), file)


def test_topics_have_their_types_and_times_never_go_back(recorded: tuple[Path, RecordedEpisode]) -> None:
    file, summary = recorded
    entries = read(file)
    kinds = {entry.channel.topic: entry.schema.name.replace("/msg/", "/") for entry in entries}
    assert kinds == {topic: kind for topic, kind in EPISODE_TOPICS.items() if topic != CAMERA}
    assert {entry.schema.encoding for entry in entries} == {"ros2msg"}
    assert {entry.channel.message_encoding for entry in entries} == {"cdr"}
    times = [entry.message.log_time for entry in entries]
    assert all(a <= b for a, b in pairwise(times))
    assert times[-1] == round(summary.seconds * 1e9) > 0
    counts = {topic: sum(entry.channel.topic == topic for entry in entries) for topic in kinds}
    assert counts == summary.messages


def test_there_is_a_pose_for_the_start_and_for_each_step(
    recorded: tuple[Path, RecordedEpisode], log: EpisodeLog
) -> None:
    topics = by_topic(recorded[0])
    poses = topics["/mansion/robot_pose"]
    assert len(poses) == len(topics["/clock"]) == len(topics["/tf"]) == len(log.steps) + 1
    for pose, step in zip(poses[1:], log.steps, strict=True):
        assert (pose.pose.position.x, pose.pose.position.y) == (step.pose.x, step.pose.y)
        assert pose.header.frame_id == "map"
        stamp = pose.header.stamp
        assert stamp.sec + stamp.nanosec / 1e9 == pytest.approx(step.time)
    heights = {pose.pose.position.z for pose in poses}
    assert len(heights) == len({1, *(step.floor for step in log.steps)}) == 2


def test_skill_events_and_the_frame_of_the_episode_are_payloads(
    recorded: tuple[Path, RecordedEpisode], log: EpisodeLog
) -> None:
    topics = by_topic(recorded[0])
    assert [decode(EpisodeStep, message.data) for message in topics["/mansion/skill_events"]] == log.steps
    start, end = topics["/mansion/episode"]
    assert decode(EpisodeStart, start.data) == log.start
    assert decode(EpisodeEnd, end.data) == log.end


def test_maps_are_whole_and_come_with_each_floor(recorded: tuple[Path, RecordedEpisode]) -> None:
    maps = by_topic(recorded[0])["/map"]
    assert len({grid.info.origin.position.z for grid in maps}) == 2
    for grid in maps:
        assert len(grid.data) == grid.info.width * grid.info.height
        assert {0, 100} <= set(grid.data) <= {-1, 0, 100}


def test_the_same_episode_gives_the_same_bytes(
    recorded: tuple[Path, RecordedEpisode], log: EpisodeLog, building: Path, tmp_path: Path
) -> None:
    record_episode(log, building, LocalPort(), tmp_path / "again.mcap")
    assert (tmp_path / "again.mcap").read_bytes() == recorded[0].read_bytes()


def test_an_episode_of_another_building_is_refused(log: EpisodeLog, building: Path, tmp_path: Path) -> None:
    elsewhere = msgspec.structs.replace(log.steps[0], floor=3)
    other = msgspec.structs.replace(log, steps=[elsewhere, *log.steps[1:]])
    with pytest.raises(MansionError, match="cannot be reproduced"):
        record_episode(other, building, LocalPort(), tmp_path / "episode.mcap")
    assert not (tmp_path / "episode.mcap").exists()


def test_pictures_are_jpeg_of_every_moment(log: EpisodeLog, building: Path, tmp_path: Path) -> None:
    pytest.importorskip("mujoco")
    file = tmp_path / "seen.mcap"
    try:
        record_episode(log, building, LocalPort(), file, pictures=True)
    except MansionError as error:
        pytest.skip(f"nothing renders here: {error}")
    pictures = by_topic(file)[CAMERA]
    assert len(pictures) == len(log.steps) + 1
    assert all(picture.format == "jpeg" and bytes(picture.data)[:2] == b"\xff\xd8" for picture in pictures)
