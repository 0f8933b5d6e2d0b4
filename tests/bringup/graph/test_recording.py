"""A session of the graph, read back with the reader of the library."""

import json
import os
import subprocess
import sys
import threading
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import CameraInfo
from std_msgs.msg import String

from mansion_bringup.client import MansionClient
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses
from mansion_bringup.graph.recording import GraphRecording, definition_of
from mansion_bringup.graph.skill_port import SERVER
from mansion_msgs_py.interfaces import LATCHED, STREAM
from mansion_msgs_py.nodes.shell import qos_profile
from mansion_tasks.recordings.mcap_file import message_definition
from sample_building import write_building

pytest.importorskip("mcap_ros2")


def read(file: Path) -> list[Any]:
    from mcap.reader import make_reader
    from mcap_ros2.decoder import DecoderFactory

    with file.open("rb") as stream:
        return list(make_reader(stream, decoder_factories=[DecoderFactory()]).iter_decoded_messages())


@pytest.mark.parametrize("kind", [PoseStamped, OccupancyGrid, String], ids=lambda kind: kind.__name__)
def test_what_a_class_says_of_itself_is_the_definition_that_episodes_have(kind: Any) -> None:
    assert definition_of(kind) == message_definition(f"{kind.__module__.split('.')[0]}/{kind.__name__}")


def test_arrays_of_fixed_length_and_types_in_types_are_spelt_as_in_msg_files() -> None:
    assert "float64[9] k" in definition_of(CameraInfo)
    text = definition_of(DiagnosticArray)
    assert "diagnostic_msgs/DiagnosticStatus[] status" in text and "byte level" in text
    assert "MSG: diagnostic_msgs/KeyValue" in text


def test_messages_are_kept_as_they_came_with_ascending_times(tmp_path: Path) -> None:
    file, domain = tmp_path / "some.mcap", free_domain()
    ticks = iter([5, 9, 7, 12, 13, 14, 15, 16])
    with MansionClient(domain_id=domain) as talker, MansionClient(domain_id=domain) as listener:
        poses = talker.node.create_publisher(PoseStamped, "poses", qos_profile(LATCHED))
        texts = talker.node.create_publisher(String, "texts", qos_profile(STREAM))
        pose = PoseStamped()
        pose.header.frame_id, pose.pose.position.x = "map", 1.5
        poses.publish(pose)
        with GraphRecording(listener, file, ["poses", "texts"], clock=lambda: next(ticks)) as recording:
            _until(lambda: _look(recording) and texts.get_subscription_count() > 0)
            _until(lambda: recording.counts.get("/mansion/poses") == 1)
            for k in range(3):
                texts.publish(String(data=f"number {k}"))
            _until(lambda: recording.counts.get("/mansion/texts") == 3)
            assert not file.exists()
    messages = read(file)
    assert [entry.message.log_time for entry in messages] == [5, 9, 9, 12]
    assert [entry.channel.topic for entry in messages] == ["/mansion/poses", *["/mansion/texts"] * 3]
    assert messages[0].schema.name == "geometry_msgs/msg/PoseStamped"
    assert (messages[0].decoded_message.header.frame_id, messages[0].decoded_message.pose.position.x) == ("map", 1.5)
    assert [entry.decoded_message.data for entry in messages[1:]] == ["number 0", "number 1", "number 2"]
    assert list(tmp_path.iterdir()) == [file]


def _look(recording: GraphRecording) -> bool:
    recording.look()
    return True


def _until(holds: Any) -> None:
    for _ in range(300):
        if holds():
            return
        threading.Event().wait(0.1)
    pytest.fail("it did not come to hold in 30 s")


@pytest.mark.graph
def test_the_command_records_a_robot_at_work(tmp_path: Path) -> None:
    building = write_building(tmp_path / "building")
    options = GraphOptions(domain_id=free_domain(), allow=(tmp_path,), quiet=True)
    environment = {**os.environ, "ROS_DOMAIN_ID": str(options.domain_id)}
    command = [sys.executable, "-m", "mansion_bringup", "record", "graph", "-o", "session.mcap", "--json"]
    with GraphProcesses(options, [SERVER]) as graph, MansionClient(domain_id=options.domain_id) as client:
        graph.wait_ready(180.0)
        client.call("load_building", {"path": str(building)})
        recorder = subprocess.Popen(
            [*command, "--seconds", "12"], cwd=tmp_path, env=environment, text=True, stdout=subprocess.PIPE
        )
        _until(lambda: client.node.count_subscribers("/mansion/world_events") > 0)
        client.call("skills/go_to_landmark", {"landmark": "elevator"})
        said, _ = recorder.communicate(timeout=120)
    assert recorder.returncode == 0
    messages = read(tmp_path / "session.mcap")
    topics = {entry.channel.topic: entry.schema.name for entry in messages}
    assert topics["/map"] == "nav_msgs/msg/OccupancyGrid"
    assert topics["/mansion/robot_pose"] == "geometry_msgs/msg/PoseStamped"
    assert not any("/camera/" in topic for topic in topics)
    times = [entry.message.log_time for entry in messages]
    assert all(a <= b for a, b in pairwise(times))
    events = [json.loads(e.decoded_message.data) for e in messages if e.channel.topic == "/mansion/world_events"]
    assert any("GoToLandmark" in json.dumps(event) for event in events)
    counted = json.loads(said)["messages"]
    assert counted == {topic: sum(e.channel.topic == topic for e in messages) for topic in counted}
