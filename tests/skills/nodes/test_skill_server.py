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

Start = Callable[..., Any]


@pytest.fixture
def start(monkeypatch: pytest.MonkeyPatch) -> Iterator[Start]:
    """Make a server with parameters as on a command line, and an executor that does not spin yet."""
    from rclpy.executors import MultiThreadedExecutor

    from mansion_skills.nodes.skill_server import SkillServer

    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
    made: list[Any] = []

    def make(*parameters: str) -> Any:
        options = [part for parameter in parameters for part in ("-p", parameter)]
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
    ("override", "named"),
    [("camera_rate:=0.0", "camera_rate"), ("robot_radius:=wide", "robot_radius")],
)
def test_a_value_out_of_range_or_of_another_type_is_refused(
    start: Start, override: str, named: str
) -> None:
    from rclpy.exceptions import ParameterException

    with pytest.raises(ParameterException, match=named):
        start(override)


def test_a_motion_that_there_is_not_is_refused_with_those_there_are(start: Start) -> None:
    with pytest.raises(MansionError, match=r"'slow'; fast and realtime are accepted"):
        start("motion:=slow")


def test_a_stack_that_was_replaced_is_left_alone_by_the_timers(
    start: Start, building: Path
) -> None:
    server = start("camera:=false")
    server.load(LoadBuilding(path=str(building)))
    former = server._stacks[DEFAULT_SESSION]
    server.load(LoadBuilding(path=str(building), reset=True))
    assert former.closed and not server._stacks[DEFAULT_SESSION].closed
    # What a timer sees that began before the building was loaded anew.
    server._stacks["former"] = former
    server._drive()
    server._publish_markers()


def test_the_clock_that_it_publishes_starts_with_simulated_time(
    start: Start, building: Path
) -> None:
    from rclpy.qos import qos_profile_sensor_data
    from rosgraph_msgs.msg import Clock

    server = start("camera:=false", "publish_clock:=true", "use_sim_time:=true")
    server.load(LoadBuilding(path=str(building)))
    ticked = threading.Event()
    server.create_subscription(
        Clock, "/clock", lambda message: ticked.set(), qos_profile_sensor_data
    )
    for _ in range(100):
        server.executor.spin_once(timeout_sec=0.1)
        if ticked.is_set():
            break
    assert ticked.is_set()
