"""What the two ends of a service, clients and servers, have in common."""

from __future__ import annotations

from typing import Any

from rclpy import _rclpy_pybind11
from rclpy.callback_groups import CallbackGroup
from rclpy.clock import Clock
from rclpy.qos import QoSProfile

__all__ = ["ServiceEnd"]


class ServiceEnd:
    """A handle with its type, name, quality of service and callback group."""

    def __init__(
        self,
        handle: Any,
        srv_type: Any,
        srv_name: str,
        name: str,
        qos_profile: QoSProfile,
        callback_group: CallbackGroup,
    ) -> None:
        self.__handle = handle
        self._name = name
        self.srv_type: Any = srv_type
        self.srv_name = srv_name
        self.qos_profile = qos_profile
        self.callback_group: CallbackGroup | None = callback_group
        self._executor_event = False
        self._destroyed = False

    def configure_introspection(
        self,
        clock: Clock,
        service_event_qos_profile: QoSProfile,
        introspection_state: _rclpy_pybind11.ServiceIntrospectionState,
    ) -> None:
        """Not here: only the state OFF is accepted."""
        if int(introspection_state) != 0:
            raise NotImplementedError("the embedded ROS has no service introspection")

    @property
    def handle(self) -> Any:
        return self.__handle

    @property
    def service_name(self) -> str:
        with self.handle:
            return self._name

    def _wait_entity(self) -> int:
        return int(self.__handle.reader.condition) if not self._destroyed else 0

    def destroy(self):  # type: ignore[no-untyped-def]
        """End it; ``Node.destroy_client`` and ``Node.destroy_service`` are what programs call."""
        self._destroyed = True
        self.__handle.destroy()

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *_: object) -> None:
        self.destroy()
