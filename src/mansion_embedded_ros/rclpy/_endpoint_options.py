"""What the arguments of ``create_publisher`` and its like mean."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy._dds import graph
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy

if TYPE_CHECKING:
    from rclpy.node import Node

__all__ = ["best_available", "copy_profile", "require_definition", "to_profile"]


def require_definition(cls: Any, kind: type, what: str) -> None:
    """Refuse what is no message or service class.

    Raises
    ------
    AttributeError
        As rclpy does.
    """
    if not isinstance(getattr(cls, "_definition", None), kind):
        raise AttributeError(
            f"{cls!r} is no ROS 2 {what} class of the embedded ROS; import one from a package of "
            "messages, such as std_msgs.msg.String or std_srvs.srv.Trigger"
        )


def to_profile(qos_profile: QoSProfile | int) -> QoSProfile:
    """A profile, or the default one with the history depth that an integer gives.

    Raises
    ------
    TypeError, ValueError
    """
    if isinstance(qos_profile, QoSProfile):
        return qos_profile
    if not isinstance(qos_profile, int):
        raise TypeError(f"Expected QoSProfile or int, but received {type(qos_profile)!r}")
    if qos_profile < 0:
        raise ValueError("history depth must be greater than or equal to zero")
    return QoSProfile(depth=qos_profile)


def copy_profile(profile: QoSProfile) -> QoSProfile:
    """A profile of its own with the same values."""
    return QoSProfile(**{slot[1:]: getattr(profile, slot) for slot in QoSProfile.__slots__})


def best_available(node: Node, profile: QoSProfile, topic: str, kind: str) -> QoSProfile:
    """Replace policies BEST_AVAILABLE by the best that match all other endpoints of the topic."""
    undecided = (
        profile.reliability == ReliabilityPolicy.BEST_AVAILABLE
        or profile.durability == DurabilityPolicy.BEST_AVAILABLE
        or profile.liveliness == LivelinessPolicy.BEST_AVAILABLE
    )
    if not undecided:
        return profile
    result = copy_profile(profile)
    others = [
        e.profile
        for e in graph.endpoints(node._participant, kind == "subscription", f"rt{topic}")
        if e.profile is not None
    ]
    for_subscription = kind == "subscription"
    if result.reliability == ReliabilityPolicy.BEST_AVAILABLE:
        weak = for_subscription and any(
            o.reliability == ReliabilityPolicy.BEST_EFFORT for o in others
        )
        result.reliability = ReliabilityPolicy.BEST_EFFORT if weak else ReliabilityPolicy.RELIABLE
    if result.durability == DurabilityPolicy.BEST_AVAILABLE:
        weak = for_subscription and any(o.durability == DurabilityPolicy.VOLATILE for o in others)
        transient = DurabilityPolicy.TRANSIENT_LOCAL
        result.durability = DurabilityPolicy.VOLATILE if weak else transient
    if result.liveliness == LivelinessPolicy.BEST_AVAILABLE:
        result.liveliness = LivelinessPolicy.AUTOMATIC
    if result.deadline.nanoseconds >= 2**63 - 2:
        result.deadline = Duration()
    if result.liveliness_lease_duration.nanoseconds >= 2**63 - 2:
        result.liveliness_lease_duration = Duration()
    return result
