"""The policies of quality of service, their kinds, and how well two profiles go together."""

from __future__ import annotations

from enum import IntEnum
from typing import Union

__all__ = [
    "DurabilityPolicy",
    "HistoryPolicy",
    "LivelinessPolicy",
    "QoSCompatibility",
    "QoSPolicyEnum",
    "QoSPolicyKind",
    "ReliabilityPolicy",
    "qos_policy_name_from_kind",
]


class QoSPolicyKind(IntEnum):
    """Kinds of policies, as in ``rmw_qos_policy_kind_t``."""

    INVALID = 1 << 0
    DURABILITY = 1 << 1
    DEADLINE = 1 << 2
    LIVELINESS = 1 << 3
    RELIABILITY = 1 << 4
    HISTORY = 1 << 5
    LIFESPAN = 1 << 6
    DEPTH = 1 << 7
    LIVELINESS_LEASE_DURATION = 1 << 8
    AVOID_ROS_NAMESPACE_CONVENTIONS = 1 << 9


def qos_policy_name_from_kind(policy_kind: Union[QoSPolicyKind, int]):  # noqa: UP007
    """The name of a policy kind, ``RELIABILITY_QOS_POLICY``."""
    return f"{QoSPolicyKind(policy_kind).name}_QOS_POLICY"


class QoSCompatibility(IntEnum):
    """How well two profiles go together."""

    OK = 0
    WARNING = 1
    ERROR = 2


class QoSPolicyEnum(IntEnum):
    """Base of the policies: members also go by short keys on command lines."""

    @classmethod
    def short_keys(cls):
        """The values that a command line takes, ``["system_default", "reliable", ...]``."""
        return [key.lower() for key in cls.__members__ if not key.startswith("RMW")]

    @classmethod
    def get_from_short_key(cls, name):
        """The value of a short key."""
        return cls[name.upper()].value

    @property
    def short_key(self):
        return self.name.lower()


class HistoryPolicy(QoSPolicyEnum):
    """How many samples are kept."""

    SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    KEEP_ALL = 2
    UNKNOWN = 3


class ReliabilityPolicy(QoSPolicyEnum):
    """Whether lost samples are sent again."""

    SYSTEM_DEFAULT = 0
    RELIABLE = 1
    BEST_EFFORT = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class DurabilityPolicy(QoSPolicyEnum):
    """Whether late joiners get samples written before."""

    SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    VOLATILE = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class LivelinessPolicy(QoSPolicyEnum):
    """Who says that a publisher is alive."""

    SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    BEST_AVAILABLE = 5


for _public in (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSCompatibility,
    QoSPolicyEnum,
    QoSPolicyKind,
    ReliabilityPolicy,
    qos_policy_name_from_kind,
):
    _public.__module__ = "rclpy.qos"
