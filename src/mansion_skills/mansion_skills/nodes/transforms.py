"""Frames on /tf and /tf_static, where tf2_msgs is installed: the wheels of ROS 2 have none."""

from collections.abc import Sequence
from typing import Any

from geometry_msgs.msg import TransformStamped
from rclpy.node import Node

from mansion_msgs_py.interfaces import TopicInterface
from mansion_msgs_py.nodes.shell import qos_profile

try:
    from tf2_msgs.msg import TFMessage
except ModuleNotFoundError:
    TFMessage = None

__all__ = ["MISSING", "TransformPublisher"]

MISSING = (
    "tf2_msgs is not installed: /tf and /tf_static are left out; `mansion up --with-tf` builds it where a C++ "
    "compiler is available"
)


class TransformPublisher:
    """Publishes transforms, or nothing where their message type is missing."""

    def __init__(self, node: Node, interface: TopicInterface) -> None:
        self._publisher: Any = None
        if TFMessage is not None:
            self._publisher = node.create_publisher(TFMessage, interface.name, qos_profile(interface.qos))

    @staticmethod
    def is_possible() -> bool:
        """Whether the message type is installed."""
        return TFMessage is not None

    def publish(self, transforms: Sequence[TransformStamped]) -> None:
        """Publish transforms in one message."""
        if self._publisher is not None:
            self._publisher.publish(TFMessage(transforms=list(transforms)))
