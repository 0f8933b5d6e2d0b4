"""Call callbacks when parameters of this node or of others change."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from rcl_interfaces.msg import ParameterEvent
from rclpy.callback_groups import CallbackGroup
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.parameter import Parameter
from rclpy.qos import QoSProfile, qos_profile_parameter_events
from rclpy.qos_overriding_options import QoSOverridingOptions

if TYPE_CHECKING:
    from rclpy.node import Node

__all__ = ["ParameterCallbackHandle", "ParameterEventCallbackHandle", "ParameterEventHandler"]


class ParameterCallbackHandle:
    """A callback for one parameter."""

    def __init__(self, parameter_name: str, node_name: str, callback: Callable[[Parameter], None]):
        self.parameter_name = parameter_name
        self.node_name = node_name
        self.callback = callback


class ParameterEventCallbackHandle:
    """A callback for all parameter events."""

    def __init__(self, callback: Callable[[ParameterEvent], None]):
        self.callback = callback


class ParameterEventHandler:
    """Subscribes ``/parameter_events`` for a node."""

    class Callbacks:
        """The callbacks, the one added last first."""

        def __init__(self):
            self.parameter_callbacks: dict[tuple[str, str], list[ParameterCallbackHandle]] = {}
            self.event_callbacks: list[ParameterEventCallbackHandle] = []

        def event_callback(self, event: ParameterEvent) -> None:
            """Call what is registered for the event."""
            for (name, node), handles in list(self.parameter_callbacks.items()):
                parameter = ParameterEventHandler.get_parameter_from_event(event, name, node)
                if parameter is not None:
                    for handle in list(handles):
                        handle.callback(parameter)
            for event_handle in list(self.event_callbacks):
                event_handle.callback(event)

    def __init__(
        self,
        node: Node,
        qos_profile: QoSProfile = qos_profile_parameter_events,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool = False,
    ):
        self.node = node
        self.qos_profile = qos_profile
        self._callbacks = ParameterEventHandler.Callbacks()
        self.parameter_event_subscription = node.create_subscription(
            ParameterEvent,
            "/parameter_events",
            self._callbacks.event_callback,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
            raw=raw,
        )

    def destroy(self):
        """End the subscription."""
        self.node.destroy_subscription(self.parameter_event_subscription)

    @staticmethod
    def get_parameter_from_event(
        event: ParameterEvent, parameter_name: str, node_name: str
    ) -> Parameter | None:
        """The new or changed parameter of a node in an event, None if it is not in it."""
        if event.node != node_name:
            return None
        for message in (*event.new_parameters, *event.changed_parameters):
            if message.name == parameter_name:
                return Parameter.from_parameter_msg(message)
        return None

    @staticmethod
    def get_parameters_from_event(event: ParameterEvent) -> Iterable[Parameter]:
        """The new and changed parameters of an event."""
        for message in (*event.new_parameters, *event.changed_parameters):
            yield Parameter.from_parameter_msg(message)

    def _full_node_name(self, node_name: str) -> str:
        if not node_name:
            return self.node.get_fully_qualified_name()
        if node_name.startswith("/"):
            return node_name
        return f"{self.node.get_namespace().rstrip('/')}/{node_name}"

    def add_parameter_callback(
        self, parameter_name: str, node_name: str, callback: Callable[[Parameter], None]
    ) -> ParameterCallbackHandle:
        """Have a callback called when the parameter of a node changes."""
        full = self._full_node_name(node_name)
        handle = ParameterCallbackHandle(parameter_name, full, callback)
        handles = self._callbacks.parameter_callbacks.setdefault((parameter_name, full), [])
        handles.insert(0, handle)
        return handle

    def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
        """Take a callback back.

        Raises
        ------
        RuntimeError
            If it was not added here.
        """
        key = (handle.parameter_name, handle.node_name)
        handles = self._callbacks.parameter_callbacks.get(key, [])
        if handle not in handles:
            raise RuntimeError("Callback doesn't exist")
        handles.remove(handle)
        if not handles:
            del self._callbacks.parameter_callbacks[key]

    def add_parameter_event_callback(
        self, callback: Callable[[ParameterEvent], None]
    ) -> ParameterEventCallbackHandle:
        """Have a callback called with every parameter event."""
        handle = ParameterEventCallbackHandle(callback)
        self._callbacks.event_callbacks.insert(0, handle)
        return handle

    def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
        """Take a callback back.

        Raises
        ------
        RuntimeError
            If it was not added here.
        """
        if handle not in self._callbacks.event_callbacks:
            raise RuntimeError("Callback doesn't exist")
        self._callbacks.event_callbacks.remove(handle)
