"""Topics and services between nodes of one process and between processes."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Any

import pytest
from diagnostic_msgs.srv import AddDiagnostics
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.serialization import deserialize_message, serialize_message
from rclpy.wait_for_message import wait_for_message
from std_msgs.msg import Int32, String
from std_srvs.srv import Trigger

LATCHED = QoSProfile(depth=3, durability=DurabilityPolicy.TRANSIENT_LOCAL)

SERVER = """
import rclpy
from diagnostic_msgs.srv import AddDiagnostics
rclpy.init(args=[])
node = rclpy.create_node("server")
def answer(request, response):
    response.success, response.message = True, request.load_namespace
    return response
node.create_service(AddDiagnostics, "echo", answer)
print("ready")
rclpy.spin(node)
"""


def spin_until(node: Any, condition: Callable[[], bool], seconds: float = 5.0) -> bool:
    import rclpy

    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=0.05)
    return condition()


def test_messages_arrive_in_order(node: Any) -> None:
    got: list[int] = []
    node.create_subscription(Int32, "numbers", lambda m: got.append(m.data), 100)
    publisher = node.create_publisher(Int32, "numbers", 100)
    for i in range(50):
        publisher.publish(Int32(data=i))
    assert spin_until(node, lambda: len(got) == 50)
    assert got == list(range(50))


def test_a_late_joiner_gets_the_last_latched_messages(node: Any) -> None:
    publisher = node.create_publisher(Int32, "latched", LATCHED)
    for i in range(10):
        publisher.publish(Int32(data=i))
    got: list[int] = []
    node.create_subscription(Int32, "latched", lambda m: got.append(m.data), LATCHED)
    assert spin_until(node, lambda: len(got) == 3)
    assert got == [7, 8, 9]


def test_a_slow_subscription_keeps_the_last_messages_of_its_depth(node: Any) -> None:
    got: list[int] = []
    node.create_subscription(Int32, "slow", lambda m: got.append(m.data), 5)
    publisher = node.create_publisher(Int32, "slow", 100)
    for i in range(100):
        publisher.publish(Int32(data=i))
    assert spin_until(node, lambda: len(got) == 5)
    rclpy_done = spin_until(node, lambda: len(got) > 5, 0.2)
    assert not rclpy_done
    assert got == [95, 96, 97, 98, 99]


def test_callbacks_may_take_message_info_and_raw_bytes(node: Any) -> None:
    infos: list[dict[str, Any]] = []
    raw: list[bytes] = []
    node.create_subscription(String, "info", lambda m, info: infos.append(info), 10)
    node.create_subscription(String, "info", raw.append, 10, raw=True)
    publisher = node.create_publisher(String, "info", 10)
    before = time.time_ns()
    publisher.publish(serialize_message(String(data="serialized")))
    assert spin_until(node, lambda: bool(infos and raw))
    assert deserialize_message(raw[0], String).data == "serialized"
    assert before <= infos[0]["source_timestamp"] <= infos[0]["received_timestamp"]


def test_publishing_another_type_raises(node: Any) -> None:
    publisher = node.create_publisher(String, "typed", 10)
    with pytest.raises(TypeError, match="Expected"):
        publisher.publish(Int32())


def test_incompatible_qos_is_warned_of(node: Any, capfd: Any) -> None:
    node.create_publisher(
        String, "qos", QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
    )
    node.create_subscription(String, "qos", print, 1)
    spin_until(node, lambda: False, 0.3)
    errors = capfd.readouterr().err
    assert "requesting incompatible QoS. No messages will be sent to it" in errors
    assert "offering incompatible QoS. No messages will be received from it" in errors
    assert "RELIABILITY_QOS_POLICY" in errors


def test_a_service_answers_every_way_of_calling(ros: Any, program: Callable[..., Any]) -> None:
    assert program(SERVER).line() == "ready"
    node = ros.create_node("caller")
    client = node.create_client(AddDiagnostics, "echo")
    assert client.wait_for_service(10.0)
    assert client.call(AddDiagnostics.Request(load_namespace="sync"), 5.0).message == "sync"
    futures = [client.call_async(AddDiagnostics.Request(load_namespace=str(i))) for i in range(10)]
    for i, future in enumerate(futures):
        ros.spin_until_future_complete(node, future, timeout_sec=5.0)
        assert future.result().message == str(i)
    large = "é" * 1_500_000
    assert client.call(AddDiagnostics.Request(load_namespace=large), 10.0).message == large
    assert not client._pending_requests
    node.destroy_node()


def test_a_first_call_right_after_discovery_is_answered(
    ros: Any, program: Callable[..., Any]
) -> None:
    assert program(SERVER).line() == "ready"
    for i in range(5):
        node = ros.create_node(f"fresh_{i}", start_parameter_services=False)
        client = node.create_client(AddDiagnostics, "echo")
        assert client.wait_for_service(10.0)
        assert client.call(AddDiagnostics.Request(load_namespace="x"), 5.0) is not None
        node.destroy_node()


def test_calls_without_a_server_time_out(node: Any) -> None:
    client = node.create_client(Trigger, "nobody")
    assert not client.service_is_ready()
    assert not client.wait_for_service(0.05)
    assert client.call(Trigger.Request(), timeout_sec=0.05) is None
    assert not client._pending_requests
    with pytest.raises(TypeError, match=r"expected a Trigger\.Request"):
        client.call_async(String())


def test_a_killed_server_is_noticed(ros: Any, program: Callable[..., Any]) -> None:
    server = program(SERVER)
    assert server.line() == "ready"
    node = ros.create_node("caller")
    client = node.create_client(AddDiagnostics, "echo")
    assert client.wait_for_service(10.0)
    server.process.kill()
    assert client.call(AddDiagnostics.Request(load_namespace="x"), 0.3) is None
    assert program(SERVER).line() == "ready"
    reply = None
    for _ in range(20):
        reply = client.call(AddDiagnostics.Request(load_namespace="back"), 1.0)
        if reply is not None:
            break
    assert reply is not None
    assert reply.message == "back"
    node.destroy_node()


def test_a_callback_may_call_another_service_of_the_same_process(node: Any) -> None:
    client = node.create_client(Trigger, "inner")

    def inner(request: Any, response: Any) -> Any:
        response.success, response.message = True, "inner"
        return response

    async def outer(request: Any, response: Any) -> Any:
        reply = await client.call_async(Trigger.Request())
        response.success, response.message = True, f"outer of {reply.message}"
        return response

    from rclpy.callback_groups import ReentrantCallbackGroup

    node.create_service(Trigger, "inner", inner, callback_group=ReentrantCallbackGroup())
    node.create_service(Trigger, "outer", outer)
    asker = node.create_client(Trigger, "outer")
    future = asker.call_async(Trigger.Request())
    assert spin_until(node, future.done)
    assert future.result().message == "outer of inner"


def test_a_synchronous_call_inside_a_callback_works_with_threads(ros: Any, node: Any) -> None:
    helper = ros.create_node("helper")

    def inner(request: Any, response: Any) -> Any:
        response.message = "inner"
        return response

    helper.create_service(Trigger, "inner", inner)
    client = node.create_client(Trigger, "inner")

    def outer(request: Any, response: Any) -> Any:
        response.message = client.call(Trigger.Request(), 3.0).message
        return response

    node.create_service(Trigger, "outer", outer)
    asker = helper.create_client(Trigger, "outer")
    executor = MultiThreadedExecutor(3)
    executor.add_node(node)
    executor.add_node(helper)
    thread = threading.Thread(target=executor.spin)
    thread.start()
    try:
        assert asker.call(Trigger.Request(), 5.0).message == "inner"
    finally:
        executor.shutdown()
        thread.join(5.0)
        helper.destroy_node()
    assert not thread.is_alive()


def test_a_service_that_returns_no_response_raises_and_the_node_lives_on(node: Any) -> None:
    node.create_service(Trigger, "broken", lambda request, response: None)
    client = node.create_client(Trigger, "broken")
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    client.call_async(Trigger.Request())
    with pytest.raises(TypeError, match=r"gave a NoneType instead of a Trigger\.Response"):
        for _ in range(20):
            executor.spin_once(0.1)
    assert executor.spin_once(0.0) is None
    executor.shutdown()


def test_wait_for_message_gets_one(node: Any) -> None:
    publisher = node.create_publisher(String, "awaited", LATCHED)
    publisher.publish(String(data="there"))
    found, message = wait_for_message(
        String, node, "awaited", qos_profile=LATCHED, time_to_wait=5.0
    )
    assert (found, message.data) == (True, "there")
    assert wait_for_message(String, node, "silent", time_to_wait=0.05) == (False, None)


def test_counts_and_matches_follow_creation_and_destruction(node: Any) -> None:
    publisher = node.create_publisher(String, "counted", 10)
    subscription = node.create_subscription(String, "counted", print, 10)
    assert (node.count_publishers("counted"), node.count_subscribers("counted")) == (1, 1)
    assert (publisher.get_subscription_count(), subscription.get_publisher_count()) == (1, 1)
    assert node.destroy_subscription(subscription)
    assert not node.destroy_subscription(subscription)
    assert (node.count_subscribers("counted"), publisher.get_subscription_count()) == (0, 0)
    assert publisher.topic_name == "/counted"


def test_using_what_is_destroyed_raises(node: Any) -> None:
    from rclpy._rclpy_pybind11 import InvalidHandle

    publisher = node.create_publisher(String, "gone", 10)
    client = node.create_client(Trigger, "gone")
    node.destroy_publisher(publisher)
    node.destroy_client(client)
    with pytest.raises(InvalidHandle):
        publisher.publish(String())
    with pytest.raises(InvalidHandle):
        client.call_async(Trigger.Request())
    node.destroy_node()
    with pytest.raises(InvalidHandle):
        node.create_publisher(String, "late", 10)
