"""Get and set the parameters of another node."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import Parameter as ParameterMsg
from rcl_interfaces.msg import ParameterEvent
from rcl_interfaces.srv import (
    DescribeParameters,
    GetParameters,
    GetParameterTypes,
    ListParameters,
    SetParameters,
    SetParametersAtomically,
)
from rclpy.callback_groups import CallbackGroup
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.parameter import Parameter, parameter_dict_from_yaml_file
from rclpy.qos import QoSProfile, qos_profile_parameter_events, qos_profile_services_default
from rclpy.qos_overriding_options import QoSOverridingOptions
from rclpy.subscription import Subscription
from rclpy.task import Future

if TYPE_CHECKING:
    from rclpy.node import Node

__all__ = ["AsyncParameterClient"]

_KINDS: dict[str, Any] = {
    "get_parameters": GetParameters,
    "set_parameters": SetParameters,
    "get_parameter_types": GetParameterTypes,
    "list_parameters": ListParameters,
    "describe_parameters": DescribeParameters,
    "set_parameters_atomically": SetParametersAtomically,
}


class AsyncParameterClient:
    """Clients of the six parameter services of a node; each method gives a future."""

    def __init__(
        self,
        node: Node,
        remote_node_name: str,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ):
        self.remote_node_name = remote_node_name
        self.node = node
        self._clients: dict[str, Any] = {
            short: node.create_client(
                kind,
                f"{remote_node_name}/{short}",
                qos_profile=qos_profile,
                callback_group=callback_group,
            )
            for short, kind in _KINDS.items()
        }

    def services_are_ready(self) -> bool:
        """Whether all six services are there."""
        return all(client.service_is_ready() for client in self._clients.values())

    def wait_for_services(self, timeout_sec: float | None = None) -> bool:
        """Wait for all six services; False at the timeout."""
        end = None if timeout_sec is None else time.monotonic() + timeout_sec
        for client in self._clients.values():
            left = None if end is None else max(end - time.monotonic(), 0.0)
            if not client.wait_for_service(left):
                return False
        return True

    def _call(self, service: str, callback: Callable[..., Any] | None, **fields: Any) -> Future:
        future: Future = self._clients[service].call_async(_KINDS[service].Request(**fields))
        if callback is not None:
            future.add_done_callback(callback)
        return future

    def list_parameters(
        self,
        prefixes: list[str] | None = None,
        depth: int | None = None,
        callback: Callable | None = None,
    ) -> Future:
        """The names under the prefixes."""
        return self._call("list_parameters", callback, prefixes=prefixes or [], depth=depth or 0)

    def get_parameters(self, names: list[str], callback: Callable | None = None) -> Future:
        """The values of parameters."""
        return self._call("get_parameters", callback, names=names)

    def set_parameters(
        self,
        parameters: Sequence[Parameter | ParameterMsg],
        callback: Callable | None = None,
    ) -> Future:
        """Set parameters one by one."""
        return self._call("set_parameters", callback, parameters=_messages(parameters))

    def describe_parameters(self, names: list[str], callback: Callable | None = None) -> Future:
        """The descriptors of parameters."""
        return self._call("describe_parameters", callback, names=names)

    def get_parameter_types(self, names: list[str], callback: Callable | None = None) -> Future:
        """The types of parameters."""
        return self._call("get_parameter_types", callback, names=names)

    def set_parameters_atomically(
        self,
        parameters: Sequence[Parameter | ParameterMsg],
        callback: Callable | None = None,
    ) -> Future:
        """Set all parameters or none."""
        return self._call("set_parameters_atomically", callback, parameters=_messages(parameters))

    def delete_parameters(self, names: list[str], callback: Callable | None = None) -> Future:
        """Unset parameters; only dynamically typed ones can be."""
        messages = [Parameter(name=name).to_parameter_msg() for name in names]
        return self._call("set_parameters", callback, parameters=messages)

    def load_parameter_file(
        self, parameter_file: str, use_wildcard: bool = False, callback: Callable | None = None
    ) -> Future:
        """Set the parameters that a YAML file has for the node."""
        found = parameter_dict_from_yaml_file(
            parameter_file, use_wildcard, target_nodes=[self.remote_node_name]
        )
        return self.set_parameters(list(found.values()), callback=callback)

    def load_parameter_file_atomically(
        self, parameter_file: str, use_wildcard: bool = False, callback: Callable | None = None
    ) -> Future:
        """Set the parameters that a YAML file has for the node, all or none."""
        found = parameter_dict_from_yaml_file(
            parameter_file, use_wildcard, target_nodes=[self.remote_node_name]
        )
        return self.set_parameters_atomically(list(found.values()), callback=callback)

    def on_parameter_event(
        self,
        callback: Callable,
        qos_profile: QoSProfile = qos_profile_parameter_events,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool = False,
    ) -> Subscription:
        """Have a callback called with the parameter events of all nodes."""
        return self.node.create_subscription(
            ParameterEvent,
            "/parameter_events",
            callback,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
            raw=raw,
        )


def _messages(parameters: Sequence[Parameter | ParameterMsg]) -> list[ParameterMsg]:
    return [p.to_parameter_msg() if isinstance(p, Parameter) else p for p in parameters]
