"""What is known of a publisher or subscription of a topic."""

from __future__ import annotations

from enum import IntEnum

from rclpy.qos import HistoryPolicy, QoSPresetProfiles, QoSProfile
from rclpy.type_hash import TypeHash

__all__ = ["TopicEndpointInfo", "TopicEndpointTypeEnum"]


class TopicEndpointTypeEnum(IntEnum):
    """Kinds of endpoints."""

    INVALID = 0
    PUBLISHER = 1
    SUBSCRIPTION = 2


class TopicEndpointInfo:
    """One endpoint: its node, type, GID and QoS."""

    __slots__ = [
        "_endpoint_gid",
        "_endpoint_type",
        "_node_name",
        "_node_namespace",
        "_qos_profile",
        "_topic_type",
        "_topic_type_hash",
    ]

    def __init__(self, **kwargs):
        unknown = [key for key in kwargs if f"_{key}" not in self.__slots__]
        assert not unknown, f"Invalid arguments passed to constructor: {unknown}"
        self.node_name = kwargs.get("node_name", "")
        self.node_namespace = kwargs.get("node_namespace", "")
        self.topic_type = kwargs.get("topic_type", "")
        self.topic_type_hash = kwargs.get("topic_type_hash", TypeHash())
        self.endpoint_type = kwargs.get("endpoint_type", TopicEndpointTypeEnum.INVALID)
        self.endpoint_gid = kwargs.get("endpoint_gid", [])
        self.qos_profile = kwargs.get("qos_profile", QoSPresetProfiles.UNKNOWN.value)

    def _checked(name, kind):
        slot = f"_{name}"

        def get(self):
            return getattr(self, slot)

        def put(self, value):
            assert isinstance(value, kind), f"{name} must be a {kind}"
            setattr(self, slot, value)

        return property(get, put)

    node_name = _checked("node_name", str)
    node_namespace = _checked("node_namespace", str)
    topic_type = _checked("topic_type", str)
    topic_type_hash = _checked("topic_type_hash", TypeHash)
    endpoint_gid = _checked("endpoint_gid", list)
    qos_profile = _checked("qos_profile", QoSProfile)
    del _checked

    @property
    def endpoint_type(self):
        return self._endpoint_type

    @endpoint_type.setter
    def endpoint_type(self, value):
        self._endpoint_type = TopicEndpointTypeEnum(value)

    def __eq__(self, other):
        if not isinstance(other, TopicEndpointInfo):
            return False
        return all(getattr(self, slot) == getattr(other, slot) for slot in self.__slots__)

    __hash__ = None

    def __str__(self):
        gid = ".".join(f"{octet:02x}" for octet in self.endpoint_gid)
        qos = self.qos_profile
        if qos.history == HistoryPolicy.KEEP_LAST:
            history = f"{qos.history.name} ({qos.depth})"
        else:
            history = qos.history.name
        lines = [
            f"Node name: {self.node_name}",
            f"Node namespace: {self.node_namespace}",
            f"Topic type: {self.topic_type}",
            f"Topic type hash: {self.topic_type_hash}",
            f"Endpoint type: {self.endpoint_type.name}",
            f"GID: {gid}",
            "QoS profile:",
            f"  Reliability: {qos.reliability.name}",
            f"  History (Depth): {history}",
            f"  Durability: {qos.durability.name}",
            f"  Lifespan: {qos.lifespan}",
            f"  Deadline: {qos.deadline}",
            f"  Liveliness: {qos.liveliness.name}",
            f"  Liveliness lease duration: {qos.liveliness_lease_duration}",
        ]
        return "\n".join(lines)
