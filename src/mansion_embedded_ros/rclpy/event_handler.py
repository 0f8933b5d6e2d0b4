"""Events of publishers and subscriptions: deadlines, liveliness, incompatible QoS, matches."""

from __future__ import annotations

import ctypes as ct
from collections.abc import Callable as _Callable
from enum import IntEnum
from typing import Any, Callable  # noqa: UP035

import rclpy
from rclpy import _rclpy_pybind11
from rclpy._dds import library
from rclpy._dds.endpoints import Endpoint
from rclpy._dds.library import dds
from rclpy._rclpy_pybind11 import UnsupportedEventTypeError
from rclpy.callback_groups import CallbackGroup
from rclpy.logging import get_logger
from rclpy.qos import QoSPolicyKind, qos_policy_name_from_kind
from rclpy.waitable import NumberOfEntities, Waitable

__all__ = [
    "EventHandler",
    "PublisherEventCallbacks",
    "QoSEventHandler",
    "QoSPublisherEventType",
    "QoSSubscriptionEventType",
    "SubscriptionEventCallbacks",
    "UnsupportedEventTypeError",
]


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


def _counted(make: _Callable[[int, int], Any]) -> _Callable[[Any], Any]:
    return lambda status: make(status.total_count, status.total_count_change)


def _liveliness(status: Any) -> Any:
    return _rclpy_pybind11.rmw_liveliness_changed_status_t(
        status.alive_count,
        status.not_alive_count,
        status.alive_count_change,
        status.not_alive_count_change,
    )


_Event = tuple[int, str, type[ct.Structure], _Callable[[Any], Any]]
# Event: bit of the DDS status, function that reads it, its structure, conversion
_EVENTS: dict[IntEnum, _Event] = {
    QoSPublisherEventType.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED: (
        1 << 1,
        "dds_get_offered_deadline_missed_status",
        library.CountStatus,
        _counted(_rclpy_pybind11.rmw_deadline_missed_status_t),
    ),
    QoSPublisherEventType.RCL_PUBLISHER_LIVELINESS_LOST: (
        1 << 9,
        "dds_get_liveliness_lost_status",
        library.CountStatus,
        _counted(_rclpy_pybind11.rmw_liveliness_lost_status_t),
    ),
    QoSPublisherEventType.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS: (
        1 << 3,
        "dds_get_offered_incompatible_qos_status",
        library.IncompatibleQosStatus,
        _incompatible,
    ),
    QoSPublisherEventType.RCL_PUBLISHER_MATCHED: (
        1 << 11,
        "dds_get_publication_matched_status",
        library.MatchedStatus,
        _matched,
    ),
}
_SUBSCRIPTION_EVENTS: dict[IntEnum, _Event] = {
    QoSSubscriptionEventType.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED: (
        1 << 2,
        "dds_get_requested_deadline_missed_status",
        library.CountStatus,
        _counted(_rclpy_pybind11.rmw_deadline_missed_status_t),
    ),
    QoSSubscriptionEventType.RCL_SUBSCRIPTION_LIVELINESS_CHANGED: (
        1 << 10,
        "dds_get_liveliness_changed_status",
        library.LivelinessChangedStatus,
        _liveliness,
    ),
    QoSSubscriptionEventType.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS: (
        1 << 4,
        "dds_get_requested_incompatible_qos_status",
        library.IncompatibleQosStatus,
        _incompatible,
    ),
    QoSSubscriptionEventType.RCL_SUBSCRIPTION_MESSAGE_LOST: (
        1 << 5,
        "dds_get_sample_lost_status",
        library.CountStatus,
        _counted(_rclpy_pybind11.rmw_message_lost_status_t),
    ),
    QoSSubscriptionEventType.RCL_SUBSCRIPTION_MATCHED: (
        1 << 12,
        "dds_get_subscription_matched_status",
        library.MatchedStatus,
        _matched,
    ),
}


class EventHandler(Waitable):
    """Call a callback with the status of one event of one endpoint."""

    def __init__(  # type: ignore[no-untyped-def]
        self,
        *,
        callback_group: CallbackGroup,
        callback: Callable,  # type: ignore[type-arg]
        event_type: IntEnum,
        parent_impl,
    ):
        super().__init__(callback_group)
        table = _EVENTS if isinstance(event_type, QoSPublisherEventType) else _SUBSCRIPTION_EVENTS
        found = table.get(event_type)
        if found is None:
            raise UnsupportedEventTypeError(f"Cyclone DDS reports no event {event_type!r}")
        self.mask, self._function, self._status, self._convert = found
        self.callback: Any = callback
        self.event_type = event_type
        self._parent = parent_impl
        self._executor_event = False
        self._destroyed = False
        endpoint = self._endpoint()
        endpoint_mask = getattr(endpoint, "event_mask", 0) | self.mask
        endpoint.event_mask = endpoint_mask  # type: ignore[attr-defined]
        dds.dds_set_status_mask(endpoint.entity, endpoint_mask)

    def _endpoint(self) -> Endpoint:
        parent = self._parent
        return parent.writer if hasattr(parent, "writer") else parent.reader  # type: ignore[no-any-return]

    def _wait_entity(self) -> int:
        """The endpoint itself triggers; handlers of one endpoint share it."""
        return self._endpoint().entity

    def _take(self) -> Any:
        endpoint = self._endpoint()
        changed = ct.c_uint32()
        if endpoint.closed or dds.dds_get_status_changes(endpoint.entity, ct.byref(changed)) < 0:
            return None
        if not changed.value & self.mask:
            return None
        status = self._status()
        if getattr(dds, self._function)(endpoint.entity, ct.byref(status)) < 0:
            return None
        return self._convert(status)

    def _execute(self, status: Any) -> Any:
        return self.callback(status)

    def is_ready(self, wait_set):  # type: ignore[no-untyped-def]
        """Whether the event has happened; there is no wait set of rcl here."""
        changed = ct.c_uint32()
        dds.dds_get_status_changes(self._endpoint().entity, ct.byref(changed))
        return bool(changed.value & self.mask)

    def take_data(self):  # type: ignore[no-untyped-def]
        """The status of the event."""
        return self._take()

    async def execute(self, taken_data):  # type: ignore[no-untyped-def]
        """Run the callback."""
        if taken_data is not None:
            await rclpy.executors.await_or_execute(self.callback, taken_data)

    def get_num_entities(self):  # type: ignore[no-untyped-def]
        return NumberOfEntities(num_events=1)

    def add_to_wait_set(self, wait_set):  # type: ignore[no-untyped-def]
        """Nothing to do: executors find the endpoint through the node."""

    def __enter__(self):  # type: ignore[no-untyped-def]
        return self

    def __exit__(self, t, v, tb):  # type: ignore[no-untyped-def]
        return None

    def destroy(self):  # type: ignore[no-untyped-def]
        self._destroyed = True


class QoSEventHandler(EventHandler):
    """The former name of :class:`EventHandler`."""

    def __init_subclass__(cls, **kwargs: Any) -> None:
        raise TypeError("QoSEventHandler is deprecated, derive from EventHandler instead")

    def __init__(self, *args, **kwargs):  # type: ignore[no-untyped-def]
        import warnings

        warnings.warn("QoSEventHandler is deprecated, use EventHandler instead.", stacklevel=2)
        super().__init__(*args, **kwargs)


def _handlers(
    wanted: list[tuple[Any, IntEnum]], group: CallbackGroup, parent: Any
) -> list[EventHandler]:
    return [
        EventHandler(callback_group=group, callback=callback, event_type=event, parent_impl=parent)
        for callback, event in wanted
        if callback is not None
    ]


class SubscriptionEventCallbacks:
    """Callbacks for the events of a subscription; the default one warns of incompatible QoS."""

    def __init__(
        self,
        *,
        deadline: Callable[[_rclpy_pybind11.rmw_requested_deadline_missed_status_t], None]
        | None = None,
        incompatible_qos: Callable[
            [_rclpy_pybind11.rmw_requested_qos_incompatible_event_status_t], None
        ]
        | None = None,
        liveliness: Callable[[_rclpy_pybind11.rmw_liveliness_changed_status_t], None] | None = None,
        message_lost: Callable[[_rclpy_pybind11.rmw_message_lost_status_t], None] | None = None,
        incompatible_type: Callable[[_rclpy_pybind11.rmw_incompatible_type_status_t], None]
        | None = None,
        matched: Callable[[_rclpy_pybind11.rmw_matched_status_t], None] | None = None,
        use_default_callbacks: bool = True,
    ) -> None:
        self.deadline = deadline
        self.incompatible_qos = incompatible_qos
        self.liveliness = liveliness
        self.message_lost = message_lost
        self.incompatible_type = incompatible_type
        self.matched = matched
        self.use_default_callbacks = use_default_callbacks

    def create_event_handlers(
        self,
        callback_group: CallbackGroup,
        subscription: _rclpy_pybind11.Subscription,
        topic_name: str,
    ) -> list[EventHandler]:
        """The handlers of the events that have a callback."""
        incompatible = self.incompatible_qos
        if incompatible is None and self.use_default_callbacks:

            def incompatible(status: Any) -> None:
                policy = qos_policy_name_from_kind(status.last_policy_kind)
                get_logger("rclpy.subscription").warning(
                    f"New publisher discovered on topic '{topic_name}', offering incompatible QoS. "
                    f"No messages will be received from it. Last incompatible policy: {policy}"
                )

        kind = QoSSubscriptionEventType
        if self.incompatible_type is not None:
            _warn_about_types(topic_name)
        wanted: list[tuple[Any, IntEnum]] = [
            (self.deadline, kind.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED),
            (incompatible, kind.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS),
            (self.liveliness, kind.RCL_SUBSCRIPTION_LIVELINESS_CHANGED),
            (self.message_lost, kind.RCL_SUBSCRIPTION_MESSAGE_LOST),
            (self.matched, kind.RCL_SUBSCRIPTION_MATCHED),
        ]
        return _handlers(wanted, callback_group, subscription)


class PublisherEventCallbacks:
    """Callbacks for the events of a publisher; the default one warns of incompatible QoS."""

    def __init__(
        self,
        *,
        deadline: Callable[[_rclpy_pybind11.rmw_offered_deadline_missed_status_t], None]
        | None = None,
        liveliness: Callable[[_rclpy_pybind11.rmw_liveliness_lost_status_t], None] | None = None,
        incompatible_qos: Callable[
            [_rclpy_pybind11.rmw_requested_qos_incompatible_event_status_t], None
        ]
        | None = None,
        incompatible_type: Callable[[_rclpy_pybind11.rmw_incompatible_type_status_t], None]
        | None = None,
        matched: Callable[[_rclpy_pybind11.rmw_matched_status_t], None] | None = None,
        use_default_callbacks: bool = True,
    ) -> None:
        self.deadline = deadline
        self.liveliness = liveliness
        self.incompatible_qos = incompatible_qos
        self.incompatible_type = incompatible_type
        self.matched = matched
        self.use_default_callbacks = use_default_callbacks

    def create_event_handlers(
        self,
        callback_group: CallbackGroup,
        publisher: _rclpy_pybind11.Publisher,
        topic_name: str,
    ) -> list[EventHandler]:
        """The handlers of the events that have a callback."""
        incompatible = self.incompatible_qos
        if incompatible is None and self.use_default_callbacks:

            def incompatible(status: Any) -> None:
                policy = qos_policy_name_from_kind(status.last_policy_kind)
                get_logger("rclpy.publisher").warning(
                    f"New subscription discovered on topic '{topic_name}', requesting incompatible "
                    f"QoS. No messages will be sent to it. Last incompatible policy: {policy}"
                )

        kind = QoSPublisherEventType
        if self.incompatible_type is not None:
            _warn_about_types(topic_name)
        wanted: list[tuple[Any, IntEnum]] = [
            (self.deadline, kind.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED),
            (self.liveliness, kind.RCL_PUBLISHER_LIVELINESS_LOST),
            (incompatible, kind.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS),
            (self.matched, kind.RCL_PUBLISHER_MATCHED),
        ]
        return _handlers(wanted, callback_group, publisher)


def _warn_about_types(topic_name: str) -> None:
    get_logger("rclpy").warning(
        f"the callback for incompatible types of '{topic_name}' will not be called: the embedded "
        "ROS announces no type information that could be found incompatible"
    )
