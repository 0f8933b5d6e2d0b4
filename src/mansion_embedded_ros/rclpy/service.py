"""Answer the requests of a service."""

from __future__ import annotations

from typing import Any, Callable  # noqa: UP035

from rclpy import _rclpy_pybind11
from rclpy._service_end import ServiceEnd
from rclpy.callback_groups import CallbackGroup
from rclpy.qos import QoSProfile

__all__ = ["Service"]

SrvType = Any
SrvTypeRequest = Any
SrvTypeResponse = Any


class Service(ServiceEnd):
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
        name = service_impl.reader.topic_name.removeprefix("rq").removesuffix("Request")
        super().__init__(service_impl, srv_type, srv_name, name, qos_profile, callback_group)
        self.__service = service_impl
        self.callback = callback

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
