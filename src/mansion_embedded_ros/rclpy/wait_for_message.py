"""Wait for one message of a topic."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from rclpy._dds.waitset import WaitSet
from rclpy.qos import QoSProfile

if TYPE_CHECKING:
    from rclpy.node import Node

__all__ = ["wait_for_message"]


def wait_for_message(
    msg_type,
    node: Node,
    topic: str,
    *,
    qos_profile: QoSProfile | int = 1,
    time_to_wait=-1,
):
    """Wait for the next message of a topic, without spinning the node.

    Parameters
    ----------
    time_to_wait
        Seconds; negative waits forever.

    Returns
    -------
    tuple
        Whether there was one, and the message.
    """
    context = node.context
    deadline = None if time_to_wait < 0 else time.monotonic() + time_to_wait
    subscription = node.create_subscription(msg_type, topic, lambda _: None, qos_profile)
    node._detach(subscription)
    waitset = WaitSet()
    try:
        waitset.attach(subscription._wait_entity(), 1)
        while context.ok():
            taken = subscription._take()
            if taken is not None:
                return True, taken[0]
            left = 0.1 if deadline is None else min(0.1, deadline - time.monotonic())
            if left <= 0:
                return False, None
            waitset.wait(int(left * 1e9))
        return False, None
    finally:
        waitset.close()
        node.destroy_subscription(subscription)
