"""Poses as ROS messages (REP-103, REP-105), and frames on /tf and /tf_static."""

from collections.abc import Sequence
from math import cos, radians, sin
from typing import Any

from builtin_interfaces.msg import Time
from geometry_msgs.msg import Pose, Quaternion, TransformStamped
from rclpy.node import Node

from mansion_msgs_py.interfaces import TopicInterface
from mansion_msgs_py.nodes.shell import qos_profile
from mansion_msgs_py.world import Pose2D

__all__ = ["MISSING", "TransformPublisher", "between", "heading", "pose", "transform"]

MISSING = (
    "tf2_msgs is not installed: /tf and /tf_static are left out; `mansion up --with-tf` builds it where a C++ "
    "compiler is available"
)


def heading(degrees: float) -> Quaternion:
    """Return a rotation about z."""
    half = radians(degrees) / 2
    return Quaternion(x=0.0, y=0.0, z=sin(half), w=cos(half))


def pose(where: Pose2D, z: float = 0.0) -> Pose:
    """Return a planar pose at a height."""
    message = Pose()
    message.position.x, message.position.y, message.position.z = where.x, where.y, z
    message.orientation = heading(where.yaw)
    return message


def transform(parent: str, child: str, where: Pose2D, z: float, stamp: Time) -> TransformStamped:
    """Return the pose of frame `child` in frame `parent`."""
    message = TransformStamped()
    message.header.frame_id, message.header.stamp = parent, stamp
    message.child_frame_id = child
    translation = message.transform.translation
    translation.x, translation.y, translation.z = where.x, where.y, z
    message.transform.rotation = heading(where.yaw)
    return message


def between(outer: Pose2D, inner: Pose2D) -> Pose2D:
    """Return the pose of a frame in which the robot has pose `inner`, where it has pose `outer` outside."""
    turn = outer.yaw - inner.yaw
    c, s = cos(radians(turn)), sin(radians(turn))
    return Pose2D(x=outer.x - (c * inner.x - s * inner.y), y=outer.y - (s * inner.x + c * inner.y), yaw=turn)


try:
    from tf2_msgs.msg import TFMessage
except ModuleNotFoundError:
    TFMessage = None


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
