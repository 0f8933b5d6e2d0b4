"""The events of publishers and subscriptions, and how Cyclone DDS reports each."""

from __future__ import annotations

import ctypes as ct
from collections.abc import Callable
from enum import IntEnum
from typing import Any, NamedTuple

from rclpy import _rclpy_pybind11
from rclpy._dds import library
from rclpy._rclpy_pybind11 import UnsupportedEventTypeError
from rclpy.qos import QoSPolicyKind

__all__ = ["EventSource", "QoSPublisherEventType", "QoSSubscriptionEventType", "source_of"]


class QoSPublisherEventType(IntEnum):
    """Events of a publisher."""

    RCL_PUBLISHER_OFFERED_DEADLINE_MISSED = 0
    RCL_PUBLISHER_LIVELINESS_LOST = 1
    RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS = 2
    RCL_PUBLISHER_INCOMPATIBLE_TYPE = 3
    RCL_PUBLISHER_MATCHED = 4


class QoSSubscriptionEventType(IntEnum):
    """Events of a subscription."""

    RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED = 0
    RCL_SUBSCRIPTION_LIVELINESS_CHANGED = 1
    RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS = 2
    RCL_SUBSCRIPTION_MESSAGE_LOST = 3
    RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE = 4
    RCL_SUBSCRIPTION_MATCHED = 5


# The number of a DDS policy: the kind of the ROS policy.
_POLICY = {
    2: QoSPolicyKind.DURABILITY,
    4: QoSPolicyKind.DEADLINE,
    8: QoSPolicyKind.LIVELINESS,
    11: QoSPolicyKind.RELIABILITY,
    13: QoSPolicyKind.HISTORY,
    21: QoSPolicyKind.LIFESPAN,
}


def _matched(status: Any) -> Any:
    return _rclpy_pybind11.rmw_matched_status_t(
        status.total_count,
        status.total_count_change,
        status.current_count,
        status.current_count_change,
    )


def _incompatible(status: Any) -> Any:
    kind = _POLICY.get(status.last_policy_id, QoSPolicyKind.INVALID)
    return _rclpy_pybind11.rmw_qos_incompatible_event_status_t(
        status.total_count, status.total_count_change, int(kind)
    )


def _counted(make: Callable[[int, int], Any]) -> Callable[[Any], Any]:
    return lambda status: make(status.total_count, status.total_count_change)


def _liveliness(status: Any) -> Any:
    return _rclpy_pybind11.rmw_liveliness_changed_status_t(
        status.alive_count,
        status.not_alive_count,
        status.alive_count_change,
        status.not_alive_count_change,
    )


class EventSource(NamedTuple):
    """Where an event comes from: the bit of the DDS status, what reads it, its structure, its conversion."""

    mask: int
    function: str
    status: type[ct.Structure]
    convert: Callable[[Any], Any]


_PUBLISHER_EVENTS: dict[IntEnum, EventSource] = {
    QoSPublisherEventType.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED: EventSource(
        1 << 1,
        "dds_get_offered_deadline_missed_status",
        library.CountStatus,
        _counted(_rclpy_pybind11.rmw_deadline_missed_status_t),
    ),
    QoSPublisherEventType.RCL_PUBLISHER_LIVELINESS_LOST: EventSource(
        1 << 9,
        "dds_get_liveliness_lost_status",
        library.CountStatus,
        _counted(_rclpy_pybind11.rmw_liveliness_lost_status_t),
    ),
    QoSPublisherEventType.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS: EventSource(
        1 << 3,
        "dds_get_offered_incompatible_qos_status",
        library.IncompatibleQosStatus,
        _incompatible,
    ),
    QoSPublisherEventType.RCL_PUBLISHER_MATCHED: EventSource(
        1 << 11,
        "dds_get_publication_matched_status",
        library.MatchedStatus,
        _matched,
    ),
}
_SUBSCRIPTION_EVENTS: dict[IntEnum, EventSource] = {
    QoSSubscriptionEventType.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED: EventSource(
        1 << 2,
        "dds_get_requested_deadline_missed_status",
        library.CountStatus,
        _counted(_rclpy_pybind11.rmw_deadline_missed_status_t),
    ),
    QoSSubscriptionEventType.RCL_SUBSCRIPTION_LIVELINESS_CHANGED: EventSource(
        1 << 10,
        "dds_get_liveliness_changed_status",
        library.LivelinessChangedStatus,
        _liveliness,
    ),
    QoSSubscriptionEventType.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS: EventSource(
        1 << 4,
        "dds_get_requested_incompatible_qos_status",
        library.IncompatibleQosStatus,
        _incompatible,
    ),
    QoSSubscriptionEventType.RCL_SUBSCRIPTION_MESSAGE_LOST: EventSource(
        1 << 5,
        "dds_get_sample_lost_status",
        library.CountStatus,
        _counted(_rclpy_pybind11.rmw_message_lost_status_t),
    ),
    QoSSubscriptionEventType.RCL_SUBSCRIPTION_MATCHED: EventSource(
        1 << 12,
        "dds_get_subscription_matched_status",
        library.MatchedStatus,
        _matched,
    ),
}


def source_of(event_type: IntEnum) -> EventSource:
    """Return what reports an event.

    Raises
    ------
    UnsupportedEventTypeError
        If Cyclone DDS does not report it.
    """
    publishers = isinstance(event_type, QoSPublisherEventType)
    found = (_PUBLISHER_EVENTS if publishers else _SUBSCRIPTION_EVENTS).get(event_type)
    if found is None:
        raise UnsupportedEventTypeError(f"Cyclone DDS reports no event {event_type!r}")
    return found


for _cls in (QoSPublisherEventType, QoSSubscriptionEventType):
    _cls.__module__ = "rclpy.event_handler"
