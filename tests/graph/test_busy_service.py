"""A busy service answers every call that waits, and a client gets its reply however many others get theirs."""

import threading
import time
from collections.abc import Iterator

import pytest

rclpy = pytest.importorskip("rclpy")

from mansion_bringup.client import MansionClient  # noqa: E402
from mansion_bringup.graph.domains import free_domain  # noqa: E402
from mansion_msgs_py.interfaces import ServiceInterface  # noqa: E402
from mansion_msgs_py.nodes.node import MansionNode  # noqa: E402
from mansion_msgs_py.nodes.shell import add_json_service  # noqa: E402
from spinning import spinning  # noqa: E402

pytestmark = pytest.mark.graph

CALLS = 30
ECHO = ServiceInterface("echo", "slow", "Say the same again.", dict, dict)


@pytest.fixture
def slow() -> Iterator[MansionNode]:
    """A node with one thread that takes its time for each call."""
    context = rclpy.context.Context()
    rclpy.init(context=context, args=[], domain_id=free_domain())
    node = MansionNode("slow", namespace="/mansion", context=context)

    def answer(arguments: dict[str, int]) -> dict[str, int]:
        time.sleep(0.05)
        return arguments

    add_json_service(node, ECHO, answer)
    with spinning(node):
        yield node


def test_every_call_that_waits_is_answered(slow: MansionNode) -> None:
    answers: list[int] = []
    with MansionClient(domain_id=slow.context.get_domain_id(), timeout=60.0) as client:
        assert client.wait_served("echo", 20.0)

        def call(number: int) -> None:
            answers.append(client.call("echo", {"number": number})["number"])

        threads = [threading.Thread(target=call, args=(number,)) for number in range(CALLS)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    assert sorted(answers) == list(range(CALLS))
    assert (slow.calls.served, slow.calls.running, slow.calls.failed) == (CALLS, 0, 0)
