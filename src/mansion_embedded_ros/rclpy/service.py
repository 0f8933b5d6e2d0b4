"""Answer the requests of a service."""

from __future__ import annotations

from typing import Any, Callable  # noqa: UP035

from rclpy import _rclpy_pybind11
from rclpy.callback_groups import CallbackGroup
from rclpy.clock import Clock
from rclpy.qos import QoSProfile

__all__ = ["Service"]

SrvType = Any
SrvTypeRequest = Any
SrvTypeResponse = Any


class Service:
    """Made by ``Node.create_service``."""

    def __init__(
        self,
        service_impl: _rclpy_pybind11.Service,
        srv_type: SrvType,
        srv_name: str,
        callback: Callable[[SrvTypeRequest, SrvTypeResponse], SrvTypeResponse],
        callback_group: CallbackGroup,
        qos_profile: QoSProfile,
    ) -> None:
        self.__service = service_impl
        self.srv_type: Any = srv_type
        self.srv_name = srv_name
        self.callback = callback
        self.callback_group: CallbackGroup | None = callback_group
        self._executor_event = False
        self._destroyed = False
        self.qos_profile = qos_profile
        self._name = service_impl.reader.topic_name.removeprefix("rq").removesuffix("Request")

    def send_response(self, response: SrvTypeResponse, header) -> None:  # type: ignore[no-untyped-def]
        """Answer the request with the header that its callback's executor got.

        Raises
        ------
        TypeError
            If the response is of another type.
        """
        if not isinstance(response, self.srv_type.Response):
            raise TypeError(
                f"the callback of service '{self.srv_name}' gave a {type(response).__name__} "
                f"instead of a {self.srv_type.__name__}.Response"
            )
        self.__service.send_response(response, header)

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
        return self.__service

    @property
    def service_name(self) -> str:
        with self.handle:
            return self._name

    def _wait_entity(self) -> int:
        return int(self.__service.reader.condition) if not self._destroyed else 0

    def _take(self) -> Any:
        return self.__service.take_request()

    def _execute(self, taken: Any) -> Any:
        request, header = taken
        response = self.callback(request, self.srv_type.Response())
        if hasattr(response, "__await__"):
            return self._answer_later(response, header)
        self._answer(response, header)
        return None

    async def _answer_later(self, pending: Any, header: Any) -> None:
        self._answer(await pending, header)

    def _answer(self, response: Any, header: Any) -> None:
        if not self._destroyed:
            self.send_response(response, header)

    def destroy(self):  # type: ignore[no-untyped-def]
        """End the service; ``Node.destroy_service`` is what programs call."""
        self._destroyed = True
        self.__service.destroy()

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *_: object) -> None:
        self.destroy()
