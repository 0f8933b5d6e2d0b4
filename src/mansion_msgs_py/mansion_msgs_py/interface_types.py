"""The rows of the interface table and the QoS profiles that they use, without a ROS import."""

from dataclasses import dataclass
from typing import Any, Final, Literal

__all__ = [
    "CAMERA",
    "DEFAULT_NAMESPACE",
    "JSON_CALL",
    "LATCHED",
    "LATEST",
    "SENSOR",
    "STREAM",
    "STRING",
    "TRIGGER",
    "Qos",
    "ServiceInterface",
    "TopicInterface",
]

DEFAULT_NAMESPACE: Final = "/mansion"

STRING: Final = "std_msgs/msg/String"
TRIGGER: Final = "std_srvs/srv/Trigger"
JSON_CALL: Final = "diagnostic_msgs/srv/AddDiagnostics"


@dataclass(frozen=True)
class Qos:
    """Quality of service, without a ROS import: all interfaces keep the last `depth` samples."""

    depth: int = 10
    reliability: Literal["reliable", "best_effort"] = "reliable"
    durability: Literal["volatile", "transient_local"] = "volatile"

    def __str__(self) -> str:
        return f"{self.reliability}, {self.durability.replace('_', ' ')}, depth {self.depth}"


LATCHED: Final = Qos(depth=64, durability="transient_local")
"""For results that a late joiner must get: one sample a floor, 64 floors."""

STREAM: Final = Qos(depth=10)

LATEST: Final = Qos(depth=1, durability="transient_local")
"""For states of which a late joiner needs the last one only, ``/map`` among them (as Nav2's map_server does it)."""

SENSOR: Final = Qos(depth=5, reliability="best_effort")
"""rclpy's ``qos_profile_sensor_data``."""

CAMERA: Final = Qos(depth=2)
"""Reliable, so that RViz and others with default settings get the images; few, because they are large."""


@dataclass(frozen=True)
class TopicInterface:
    """A topic: `name` below the namespace, or absolute when it starts with a slash."""

    name: str
    node: str
    description: str
    payload: Any = None
    type: str = STRING
    qos: Qos = STREAM


@dataclass(frozen=True)
class ServiceInterface:
    """A service.

    Attributes
    ----------
    arguments : type, optional
        ``None`` for a Trigger.
    repeatable : bool
        Whether a call that was made twice does no more than one: a client calls again where the node has ended.
    """

    name: str
    node: str
    description: str
    arguments: Any
    reply: Any
    example: str = ""
    repeatable: bool = False

    @property
    def type(self) -> str:
        """The ROS service type."""
        return TRIGGER if self.arguments is None else JSON_CALL
