"""Nobody ends a node by publishing."""

import threading

import pytest

rclpy = pytest.importorskip("rclpy")

from mansion_msgs_py.interfaces import TopicInterface  # noqa: E402
from mansion_msgs_py.nodes.node import MansionNode  # noqa: E402
from mansion_msgs_py.nodes.shell import JsonPublisher, add_json_subscription  # noqa: E402
from spinning import spinning  # noqa: E402

pytestmark = pytest.mark.graph

NUMBERS = TopicInterface("numbers", "reader", "Numbers.", dict[str, int])


def test_a_handler_that_fails_gets_the_next_message_too(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
    context = rclpy.context.Context()
    rclpy.init(context=context, args=[], domain_id=61)
    node = MansionNode("reader", context=context)
    got, second = list[int](), threading.Event()

    def receive(payload: dict[str, int]) -> None:
        got.append(1 // payload["divisor"])
        second.set()

    add_json_subscription(node, NUMBERS, receive)
    publisher = JsonPublisher(node, NUMBERS)
    with spinning(node):
        while not publisher.publisher.get_subscription_count():
            second.wait(0.01)
        publisher.publish({"divisor": 0})
        publisher.publish({"divisor": 1})
        assert second.wait(10.0)
    assert got == [1]
