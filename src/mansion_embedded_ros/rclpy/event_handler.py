"""Events of publishers and subscriptions: deadlines, liveliness, incompatible QoS, matches."""

from __future__ import annotations

import ctypes as ct
from enum import IntEnum
from typing import Any, Callable, ClassVar  # noqa: UP035

import rclpy
from rclpy import _rclpy_pybind11
from rclpy._dds.endpoints import Endpoint
from rclpy._dds.library import dds
from rclpy._dds_events import QoSPublisherEventType, QoSSubscriptionEventType, source_of
from rclpy._rclpy_pybind11 import UnsupportedEventTypeError
from rclpy.callback_groups import CallbackGroup
from rclpy.logging import get_logger
from rclpy.qos import qos_policy_name_from_kind
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
        self._source = source_of(event_type)
        self.mask = self._source.mask
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
        status = self._source.status()
        if getattr(dds, self._source.function)(endpoint.entity, ct.byref(status)) < 0:
            return None
        return self._source.convert(status)

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


class _EventCallbacks:
    """The callbacks for the events of an endpoint, each in the attribute that `_EVENTS` names."""

    _EVENTS: ClassVar[dict[str, IntEnum]]
    _LOGGER: str
    _INCOMPATIBLE: str

    incompatible_qos: Any
    incompatible_type: Any
    use_default_callbacks: bool

    def _create(self, group: CallbackGroup, endpoint: Any, topic: str) -> list[EventHandler]:
        if self.incompatible_type is not None:
            get_logger("rclpy").warning(
                f"the callback for incompatible types of '{topic}' will not be called: the "
                "embedded ROS announces no type information that could be found incompatible"
            )
        callbacks = {name: getattr(self, name) for name in self._EVENTS}
        if self.incompatible_qos is None and self.use_default_callbacks:
            callbacks["incompatible_qos"] = self._warner(topic)
        return [
            EventHandler(
                callback_group=group,
                callback=callbacks[name],
                event_type=event,
                parent_impl=endpoint,
            )
            for name, event in self._EVENTS.items()
            if callbacks[name] is not None
        ]

    def _warner(self, topic: str) -> Callable[[Any], None]:
        def warn(status: Any) -> None:
            policy = qos_policy_name_from_kind(status.last_policy_kind)
            get_logger(self._LOGGER).warning(self._INCOMPATIBLE.format(topic=topic, policy=policy))

        return warn


class SubscriptionEventCallbacks(_EventCallbacks):
    """Callbacks for the events of a subscription; the default one warns of incompatible QoS."""

    _EVENTS: ClassVar[dict[str, IntEnum]] = {
        "deadline": QoSSubscriptionEventType.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED,
        "incompatible_qos": QoSSubscriptionEventType.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS,
        "liveliness": QoSSubscriptionEventType.RCL_SUBSCRIPTION_LIVELINESS_CHANGED,
        "message_lost": QoSSubscriptionEventType.RCL_SUBSCRIPTION_MESSAGE_LOST,
        "matched": QoSSubscriptionEventType.RCL_SUBSCRIPTION_MATCHED,
    }
    _LOGGER = "rclpy.subscription"
    _INCOMPATIBLE = (
        "New publisher discovered on topic '{topic}', offering incompatible QoS. "
        "No messages will be received from it. Last incompatible policy: {policy}"
    )

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
        return self._create(callback_group, subscription, topic_name)


class PublisherEventCallbacks(_EventCallbacks):
    """Callbacks for the events of a publisher; the default one warns of incompatible QoS."""

    _EVENTS: ClassVar[dict[str, IntEnum]] = {
        "deadline": QoSPublisherEventType.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED,
        "liveliness": QoSPublisherEventType.RCL_PUBLISHER_LIVELINESS_LOST,
        "incompatible_qos": QoSPublisherEventType.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS,
        "matched": QoSPublisherEventType.RCL_PUBLISHER_MATCHED,
    }
    _LOGGER = "rclpy.publisher"
    _INCOMPATIBLE = (
        "New subscription discovered on topic '{topic}', requesting incompatible QoS. "
        "No messages will be sent to it. Last incompatible policy: {policy}"
    )

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
        return self._create(callback_group, publisher, topic_name)
