"""The skill server as a ROS node: its parameters, its clocks, and loading while its timers run."""

import os
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.errors import MansionError
from mansion_skills.world.overlay import DEFAULT_SESSION

rclpy = pytest.importorskip("rclpy")
pytestmark = pytest.mark.graph

os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")

Start = Callable[..., Any]


@pytest.fixture
def start() -> Iterator[Start]:
    """Make a server with parameters as on a command line, and an executor that does not spin yet."""
    from rclpy.executors import MultiThreadedExecutor

    from mansion_skills.nodes.skill_server import SkillServer

    made: list[Any] = []

    def make(*parameters: str, namespace: str = "/mansion") -> Any:
        options = [part for parameter in parameters for part in ("-p", parameter)]
        options += ["-r", f"__ns:={namespace}"]
        rclpy.init(args=["--ros-args", *options], domain_id=150 + os.getpid() % 50)
        node = SkillServer()
        executor = MultiThreadedExecutor(num_threads=4)
        executor.add_node(node)
        made.extend([executor, node])
        return node

    yield make
    if made:
        made[0].shutdown()
        made[1].destroy_node()
    rclpy.try_shutdown()


def test_what_is_read_once_cannot_be_set_later(start: Start) -> None:
    from rclpy.parameter import Parameter

    server = start("camera:=false")
    results = server.set_parameters([Parameter("motion", value="realtime")])
    assert not results[0].successful
    assert "read-only" in results[0].reason
    assert server.get_parameter("motion").value == "fast"


def test_ranges_and_descriptions_can_be_asked_for(start: Start) -> None:
    server = start("camera:=false")
    width = server.describe_parameter("camera_width")
    assert (width.integer_range[0].from_value, width.integer_range[0].to_value) == (16, 4096)
    rate = server.describe_parameter("camera_rate")
    assert rate.floating_point_range[0].from_value > 0
    assert server.describe_parameter("motion").description


@pytest.mark.parametrize(
    ("override", "named"), [("camera_rate:=0.0", "camera_rate"), ("robot_radius:=wide", "robot_radius")]
)
def test_a_value_out_of_range_or_of_another_type_is_refused(start: Start, override: str, named: str) -> None:
    from rclpy.exceptions import ParameterException

    with pytest.raises(ParameterException, match=named):
        start(override)


def test_a_motion_that_there_is_not_is_refused_with_those_there_are(start: Start) -> None:
    with pytest.raises(MansionError, match=r"'slow'; fast and realtime are accepted"):
        start("motion:=slow")


def test_another_building_swaps_what_the_topics_show(start: Start, building: Path) -> None:
    server = start("camera:=false")
    server.load(LoadBuilding(path=str(building)))
    stack = server._stacks[DEFAULT_SESSION]
    former = stack.session
    publishers = list(server.publishers)
    server.load(LoadBuilding(path=str(building), reset=True))
    assert server._stacks[DEFAULT_SESSION] is stack and stack.session is not former
    assert list(server.publishers) == publishers
    stack.session = former
    with server._shown(stack) as session:
        # What a timer sees that waited for the world while another building was loaded.
        stack.session = server.engine.session(DEFAULT_SESSION)
        assert session is former
    server._drive()
    server._publish_markers()


def test_names_are_global_in_the_default_namespace_and_the_namespaces_own_in_another(
    start: Start, building: Path
) -> None:
    server = start("camera:=false", "frame_prefix:=b/", namespace="/site_b")
    server.load(LoadBuilding(path=str(building)))
    server.load(LoadBuilding(path=str(building), session="r2", world="other"))
    topics = {publisher.topic_name for publisher in server.publishers}
    assert {"/site_b/map", "/site_b/odom", "/site_b/r2/odom", "/site_b/r2/robot_pose"} <= topics
    assert not {"/map", "/odom", "/r2/odom"} & topics
    assert server._names(DEFAULT_SESSION).frame("odom") == "b/odom"


def test_a_named_robot_namespace_wins(start: Start, building: Path) -> None:
    server = start("camera:=false", "robot_namespace:=/", namespace="/site_b")
    server.load(LoadBuilding(path=str(building)))
    assert {"/map", "/odom"} <= {publisher.topic_name for publisher in server.publishers}


def test_the_clock_that_it_publishes_starts_with_simulated_time(start: Start, building: Path) -> None:
    from rclpy.qos import qos_profile_sensor_data
    from rosgraph_msgs.msg import Clock

    server = start("camera:=false", "publish_clock:=true", "use_sim_time:=true")
    server.load(LoadBuilding(path=str(building)))
    ticked = threading.Event()
    server.create_subscription(Clock, "/clock", lambda message: ticked.set(), qos_profile_sensor_data)
    for _ in range(100):
        server.executor.spin_once(timeout_sec=0.1)
        if ticked.is_set():
            break
    assert ticked.is_set()
