"""Poses as ROS messages (REP-103, REP-105)."""

from math import cos, radians, sin

from builtin_interfaces.msg import Time
from geometry_msgs.msg import Pose, Quaternion, TransformStamped

from mansion_msgs_py.world import Pose2D

__all__ = ["between", "heading", "pose", "transform"]


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
