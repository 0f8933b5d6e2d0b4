"""Errors, enumerations and endpoint handles, under the name of rclpy's C++ module in Jazzy."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Any

__all__ = [
    "InvalidHandle",
    "NodeNameNonExistentError",
    "RCLError",
    "RCLInvalidROSArgsError",
    "SignalHandlerOptions",
    "TimerCancelledError",
    "UnknownROSArgsError",
    "UnsupportedEventTypeError",
]


class RCLError(RuntimeError):
    """An operation of the client library failed."""


class RCLInvalidROSArgsError(RCLError):
    """An argument behind ``--ros-args`` cannot be read."""


class UnknownROSArgsError(RuntimeError):
    """An argument behind ``--ros-args`` that nobody knows."""


class NodeNameNonExistentError(RCLError):
    """No node of that name is in the graph."""


class UnsupportedEventTypeError(RCLError):
    """The middleware has no such event."""


class InvalidHandle(RuntimeError):
    """The object has been destroyed."""


class TimerCancelledError(RuntimeError):
    """The timer has been cancelled."""


class SignalHandlerOptions(IntEnum):
    """Which signals end the contexts."""

    NO = 0
    SIGINT = 1
    SIGTERM = 2
    ALL = 3


class ServiceIntrospectionState(IntEnum):
    """How much of a service's traffic is published."""

    OFF = 0
    METADATA = 1
    CONTENTS = 2


@dataclass
class rmw_qos_incompatible_event_status_t:
    total_count: int
    total_count_change: int
    last_policy_kind: int


rmw_requested_qos_incompatible_event_status_t = rmw_qos_incompatible_event_status_t
rmw_offered_qos_incompatible_event_status_t = rmw_qos_incompatible_event_status_t


@dataclass
class rmw_deadline_missed_status_t:
    total_count: int
    total_count_change: int


rmw_requested_deadline_missed_status_t = rmw_deadline_missed_status_t
rmw_offered_deadline_missed_status_t = rmw_deadline_missed_status_t


@dataclass
class rmw_liveliness_lost_status_t:
    total_count: int
    total_count_change: int


@dataclass
class rmw_liveliness_changed_status_t:
    alive_count: int
    not_alive_count: int
    alive_count_change: int
    not_alive_count_change: int


@dataclass
class rmw_message_lost_status_t:
    total_count: int
    total_count_change: int


@dataclass
class rmw_incompatible_type_status_t:
    total_count: int
    total_count_change: int


@dataclass
class rmw_matched_status_t:
    total_count: int
    total_count_change: int
    current_count: int
    current_count_change: int


def __getattr__(name: str) -> Any:
    if name in ("Publisher", "Subscription"):
        from rclpy import _entities

        return getattr(_entities, name)
    if name in ("Client", "Service", "rmw_request_id_t"):
        from rclpy import _service_entities

        return getattr(_service_entities, name)
    raise AttributeError(
        f"rclpy._rclpy_pybind11 of the embedded ROS has no {name!r}: it holds Jazzy's errors, "
        "enumerations and endpoint handles only"
    )
