"""``mansion echo`` finds a topic, shows any type of message, and does not wait in silence."""

import os
import subprocess
import sys
from collections.abc import Iterator

import pytest
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav_msgs.msg import OccupancyGrid
from std_msgs.msg import String

from mansion_bringup.client import MansionClient
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.tf2_build import has_tf2
from mansion_bringup.graph.topic_echo import FoundTopic, find_topic, full_name, message_class, message_yaml, silence
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.interfaces import LATCHED, SENSOR, TOPICS
from mansion_msgs_py.nodes.shell import qos_profile


@pytest.fixture(scope="module")
def client() -> Iterator[MansionClient]:
    with MansionClient(domain_id=free_domain()) as made:
        yield made


def test_every_topic_of_the_table_has_a_type_that_is_here() -> None:
    for entry in TOPICS:
        if entry.type.startswith("tf2_msgs/") and not has_tf2():
            continue  # the wheels of ROS 2 have none
        assert message_class(FoundTopic(entry.name, entry.type, entry.qos)) is not None
    with pytest.raises(MansionError, match="ros2 topic echo /laser"):
        message_class(FoundTopic("/laser", "laser_msgs/msg/Beam", SENSOR))


def test_a_name_is_below_the_namespace_or_of_the_robot_stack() -> None:
    assert full_name("progress", "/site/mansion") == "/site/mansion/progress"
    assert full_name("map", "/mansion") == "/map"
    assert full_name("/odom", "/mansion") == "/odom"


def test_a_topic_takes_the_type_and_quality_of_its_publishers(client: MansionClient) -> None:
    node = client.node
    assert find_topic(node, "poses") is None
    node.create_publisher(PoseWithCovarianceStamped, "poses", qos_profile(SENSOR))
    found = find_topic(node, "poses")
    assert found is not None
    assert (found.name, found.type) == ("/mansion/poses", "geometry_msgs/msg/PoseWithCovarianceStamped")
    assert (found.qos.reliability, found.qos.durability) == ("best_effort", "volatile")
    node.create_publisher(String, "notes", qos_profile(LATCHED))
    found = find_topic(node, "notes")
    assert found is not None and found.qos.durability == "transient_local"
    assert "1 publisher; nothing has come yet" in silence(node, "notes")
    assert "no node publishes /mansion/note; did you mean /mansion/notes?" in silence(node, "note")


def test_nobody_publishes_anything_where_no_graph_is() -> None:
    with MansionClient(domain_id=free_domain()) as alone:
        assert "is the graph running (`mansion up`)?" in silence(alone.node, "progress")


def test_messages_are_yaml_with_long_arrays_cut() -> None:
    grid = OccupancyGrid()
    grid.header.frame_id = "map"
    grid.info.width, grid.info.height, grid.info.resolution = 20, 10, 0.5
    grid.data = [0] * 199 + [100]
    text = message_yaml(grid)
    assert "  frame_id: map\n" in text
    assert "  width: 20\n" in text and "  resolution: 0.5\n" in text
    assert "    position:\n      x: 0.0\n" in text
    assert text.count("- 0\n") == 128 and text.endswith("- '...'\n")
    assert message_yaml(String(data="")) == 'data: ""\n'
    assert message_yaml(String(data="yes")) == 'data: "yes"\n'
    assert message_yaml(String(data='{"a": 1}')) == 'data: "{\\"a\\": 1}"\n'


def test_the_command_says_that_nobody_publishes_and_ends_at_its_timeout() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "mansion_bringup", "echo", "nothing", "--timeout", "3"],
        env={**os.environ, "ROS_DOMAIN_ID": str(free_domain())},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 1 and done.stdout == ""
    first, last = done.stderr.splitlines()
    assert first.startswith("no node publishes /mansion/nothing") and first.endswith("; waiting")
    assert last.startswith("error: TIMEOUT: no message on nothing in 3 s")


def test_a_service_that_is_not_served_is_answered_with_the_nearest(client: MansionClient) -> None:
    with pytest.raises(MansionError, match="is the graph running"):
        client.call("skills/teleport", wait=0.1)
