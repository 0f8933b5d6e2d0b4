"""Names, remapping, time, logging, the graph, contexts and messages."""

from __future__ import annotations

import copy
import pickle
from typing import Any

import numpy as np
import pytest
from builtin_interfaces.msg import Time as TimeMsg
from geometry_msgs.msg import Point, Pose, PoseWithCovariance, Quaternion
from rcl_interfaces.msg import Log
from rclpy.clock import Clock, ClockType, JumpThreshold
from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.exceptions import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidTopicNameException,
    NotInitializedException,
)
from rclpy.expand_topic_name import expand_topic_name
from rclpy.parameter import Parameter
from rclpy.time import Time
from rosgraph_msgs.msg import Clock as ClockMsg
from sensor_msgs.msg import Image, LaserScan
from std_msgs.msg import ColorRGBA, String, UInt8

from type_description_interfaces.srv import GetTypeDescription


@pytest.mark.parametrize(
    ("name", "full"),
    [
        ("chatter", "/ns/chatter"),
        ("/chatter", "/chatter"),
        ("~/chatter", "/ns/node/chatter"),
        ("~", "/ns/node"),
        ("{node}/x", "/ns/node/x"),
    ],
)
def test_names_expand(name: str, full: str) -> None:
    assert expand_topic_name(name, "node", "/ns") == full


@pytest.mark.parametrize("name", ["", "a//b", "1a", "a/", "a b", "a~", "{unknown}", "{a", "~a"])
def test_wrong_topic_names_are_refused(name: str) -> None:
    with pytest.raises(InvalidTopicNameException):
        expand_topic_name(name, "node", "/ns")


def test_wrong_node_names_are_refused(ros: Any) -> None:
    with pytest.raises(InvalidNodeNameException, match="alphanumerics"):
        ros.create_node("a-b")
    with pytest.raises(InvalidNamespaceException):
        ros.create_node("a", namespace="x//y")


def test_remapping_follows_the_rules(ros: Any) -> None:
    args = ["--ros-args", "-r", "__node:=renamed", "-r", "__ns:=/robot", "-r", "chatter:=talk"]
    args += ["-r", "nobody:other:=never", "-r", "rosservice://ping:=pong", "-r", "/abs:=~/own"]
    node = ros.create_node("original", cli_args=args)
    assert node.get_fully_qualified_name() == "/robot/renamed"
    assert node.resolve_topic_name("chatter") == "/robot/talk"
    assert node.resolve_topic_name("chatter", only_expand=True) == "/robot/chatter"
    assert node.resolve_topic_name("other") == "/robot/other"
    assert node.resolve_topic_name("ping") == "/robot/ping"
    assert node.resolve_service_name("ping") == "/robot/pong"
    assert node.resolve_topic_name("/abs") == "/robot/renamed/own"
    node.destroy_node()


def test_unknown_ros_arguments_are_refused() -> None:
    from rclpy._rclpy_pybind11 import RCLInvalidROSArgsError, UnknownROSArgsError

    with pytest.raises(UnknownROSArgsError):
        Context().init(["--ros-args", "--nonsense"])
    with pytest.raises(RCLInvalidROSArgsError, match="remap rule"):
        Context().init(["--ros-args", "-r", "broken"])


def test_contexts_are_separate_and_end_once() -> None:
    import rclpy

    context = Context()
    with pytest.raises(NotInitializedException):
        rclpy.create_node("early", context=context)
    context.init([], domain_id=99)
    assert (context.ok(), context.get_domain_id()) == (True, 99)
    ended: list[int] = []
    context.on_shutdown(lambda: ended.append(1))
    node = rclpy.create_node("inside", context=context)
    context.shutdown()
    assert (context.ok(), ended) == (False, [1])
    with pytest.raises(RuntimeError, match="already called"):
        context.shutdown()
    node.destroy_node()
    context.try_shutdown()


def test_log_messages_go_to_the_console_and_rosout(ros: Any, node: Any, capfd: Any) -> None:
    got: list[Log] = []
    node.create_subscription(Log, "/rosout", got.append, 100)
    logger = node.get_logger()
    for _ in range(3):
        logger.info("three times")
        logger.warning("once", once=True)
        logger.error("throttled", throttle_duration_sec=60.0)
        logger.info("not the first", skip_first=True)
    logger.debug("hidden")
    for _ in range(50):
        ros.spin_once(node, timeout_sec=0.02)
    texts = [m.msg for m in got]
    counts = {t: texts.count(t) for t in set(texts)}
    assert counts == {"three times": 3, "once": 1, "throttled": 1, "not the first": 2}
    assert {(m.name, m.function) for m in got} == {
        ("tested", "test_log_messages_go_to_the_console_and_rosout")
    }
    errors = capfd.readouterr().err
    assert "] [tested]: three times" in errors
    assert errors.count("[WARN] [") == 1
    with pytest.raises(TypeError, match="not one of the recognized logging options"):
        logger.info("x", nonsense=1)


def test_levels_are_inherited() -> None:
    from rclpy.logging import LoggingSeverity, get_logger, set_logger_level

    set_logger_level("parent_of_levels", LoggingSeverity.ERROR)
    child = get_logger("parent_of_levels").get_child("child")
    assert child.get_effective_level() == LoggingSeverity.ERROR
    assert not child.warning("hidden")
    child.set_level(LoggingSeverity.DEBUG)
    assert child.is_enabled_for(LoggingSeverity.DEBUG)


def test_times_and_durations_calculate() -> None:
    time = Time(seconds=5, nanoseconds=1)
    assert (time + Duration(seconds=1)).nanoseconds == 6_000_000_001
    assert (time - Time(seconds=4)).nanoseconds == 1_000_000_001
    assert Time.from_msg(time.to_msg()).nanoseconds == time.nanoseconds
    assert Duration(seconds=-0.5).to_msg().sec == -1
    with pytest.raises(TypeError, match="different clock types"):
        time < Time(clock_type=ClockType.STEADY_TIME)  # noqa: B015
    assert Clock(clock_type=ClockType.STEADY_TIME).sleep_for is not None


def test_simulated_time_drives_clock_and_timers(ros: Any, node: Any) -> None:
    jumps: list[Any] = []
    threshold = JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=None)
    handle = node.get_clock().create_jump_callback(threshold, post_callback=jumps.append)
    calls: list[int] = []
    node.create_timer(1.0, lambda: calls.append(1))
    assert node.set_parameters([Parameter("use_sim_time", value=True)])[0].successful
    publisher = node.create_publisher(ClockMsg, "/clock", 10)
    for second in (100, 101, 102):
        publisher.publish(ClockMsg(clock=TimeMsg(sec=second)))
        for _ in range(20):
            ros.spin_once(node, timeout_sec=0.01)
    assert node.get_clock().now().nanoseconds == 102 * 10**9
    assert 1 <= len(calls) <= 3
    assert jumps
    handle.unregister()
    assert node.set_parameters([Parameter("use_sim_time", value=False)])[0].successful
    assert node.get_clock().now().nanoseconds > 10**18


def test_the_graph_shows_nodes_topics_and_services(ros: Any, node: Any) -> None:
    other = ros.create_node("second", namespace="/deep/er")
    publisher = other.create_publisher(String, "chatter", 7)
    assert set(node.get_fully_qualified_node_names()) == {"/tested", "/deep/er/second"}
    assert ("second", "/deep/er", "/") in node.get_node_names_and_namespaces_with_enclaves()
    topics = dict(node.get_topic_names_and_types())
    assert topics["/deep/er/chatter"] == ["std_msgs/msg/String"]
    by_node = dict(node.get_publisher_names_and_types_by_node("second", "/deep/er"))
    assert set(by_node) == {"/rosout", "/parameter_events", "/deep/er/chatter"}
    services = dict(node.get_service_names_and_types_by_node("second", "/deep/er"))
    assert services["/deep/er/second/get_type_description"] == [
        "type_description_interfaces/srv/GetTypeDescription"
    ]
    (info,) = node.get_publishers_info_by_topic("/deep/er/chatter")
    assert (info.node_name, info.node_namespace) == ("second", "/deep/er")
    assert (info.qos_profile.depth, len(info.endpoint_gid)) == (7, 16)
    assert str(info.topic_type_hash).startswith("RIHS01_df668c74")
    assert publisher.get_subscription_count() == 0
    other.destroy_node()
    assert node.get_node_names() == ["tested"]
    with pytest.raises(RuntimeError, match="Cannot find node"):
        node.get_publisher_names_and_types_by_node("second", "/deep/er")


def test_type_descriptions_are_served(ros: Any, node: Any) -> None:
    client = node.create_client(GetTypeDescription, "tested/get_type_description")
    request = GetTypeDescription.Request(type_name="geometry_msgs/msg/Pose")
    future = client.call_async(request)
    ros.spin_until_future_complete(node, future, timeout_sec=5.0)
    reply = future.result()
    assert reply.successful
    referenced = [t.type_name for t in reply.type_description.referenced_type_descriptions]
    assert referenced == ["geometry_msgs/msg/Point", "geometry_msgs/msg/Quaternion"]


def test_messages_check_what_is_assigned() -> None:
    for wrong in (lambda: String(data=3), lambda: UInt8(data=300), lambda: Point(x=1)):
        with pytest.raises(AssertionError):
            wrong()
    with pytest.raises(AssertionError, match="Invalid arguments passed to constructor: text"):
        String(text="x")
    with pytest.raises(AssertionError, match="sub message of type 'Point'"):
        Pose().position = Quaternion()
    with pytest.raises(AssertionError, match="36"):
        PoseWithCovariance(covariance=[0.0] * 35)
    with pytest.raises(AttributeError):
        String().text = "x"


def test_messages_hold_arrays_as_jazzy_does() -> None:
    scan = LaserScan(ranges=np.linspace(0.0, 1.0, 5))
    assert scan.ranges.typecode == "f"
    assert Image(data=b"\x01\x02").data.tolist() == [1, 2]
    assert PoseWithCovariance().covariance.shape == (36,)
    assert LaserScan(ranges=[1.0]) == LaserScan(ranges=[1.0]) != LaserScan()
    assert repr(ColorRGBA(a=1.0)) == "std_msgs.msg.ColorRGBA(r=0.0, g=0.0, b=0.0, a=1.0)"


def test_messages_copy_and_pickle() -> None:
    pose = PoseWithCovariance(pose=Pose(position=Point(x=1.0)))
    assert copy.deepcopy(pose) == pose
    assert pickle.loads(pickle.dumps(pose)) == pose
    assert type(pose).__module__ == "geometry_msgs.msg._pose_with_covariance"
