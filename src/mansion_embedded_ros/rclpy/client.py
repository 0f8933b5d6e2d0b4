"""Call a service."""

from __future__ import annotations

import threading
import time
from typing import Any, Optional

from rclpy import _rclpy_pybind11
from rclpy._dds.library import dds
from rclpy._dds.waitset import Guard, WaitSet
from rclpy._rclpy_pybind11 import InvalidHandle
from rclpy._service_end import ServiceEnd
from rclpy.callback_groups import CallbackGroup
from rclpy.context import Context
from rclpy.qos import QoSProfile
from rclpy.task import Future

__all__ = ["Client"]

SrvType = Any
SrvTypeRequest = Any
SrvTypeResponse = Any

_SLICE = 100_000_000
"""Nanoseconds between two looks at signals and the context while a thread waits in C."""
_MATCHED = 1 << 11 | 1 << 12


class Client(ServiceEnd):
    """Made by ``Node.create_client``."""

    def __init__(
        self,
        context: Context,
        client_impl: _rclpy_pybind11.Client,
        srv_type: SrvType,
        srv_name: str,
        qos_profile: QoSProfile,
        callback_group: CallbackGroup,
    ) -> None:
        name = client_impl.reader.topic_name.removeprefix("rr").removesuffix("Reply")
        super().__init__(client_impl, srv_type, srv_name, name, qos_profile, callback_group)
        self.context = context
        self.__client = client_impl
        self._pending_requests: dict[int, Future] = {}
        self._lock = threading.Lock()

    def call(
        self,
        request: SrvTypeRequest,
        timeout_sec: Optional[float] = None,  # noqa: UP045
    ) -> Optional[SrvTypeResponse]:  # noqa: UP045
        """Make a request and wait for the reply.

        The calling thread takes the reply itself, so that this also works inside of a callback.

        Returns
        -------
        SrvTypeResponse or None
            None at the timeout, or if the context is shut down meanwhile.

        Raises
        ------
        TypeError
            If the request is of another type.
        """
        future = self.call_async(request)
        guard, waitset = Guard(), WaitSet()

        def wake(_: Future) -> None:
            guard.trigger()

        wake._runs_anywhere = True  # type: ignore[attr-defined]
        try:
            waitset.attach(guard.entity, 0)
            waitset.attach(self.__client.reader.condition, 1)
            future.add_done_callback(wake)
            deadline = None if timeout_sec is None else time.monotonic_ns() + int(timeout_sec * 1e9)
            while not future.done() and self.context.ok() and not self._destroyed:
                left = _SLICE if deadline is None else min(_SLICE, deadline - time.monotonic_ns())
                if left <= 0:
                    break
                waitset.wait(left)
                self._take_all()
        finally:
            future.remove_done_callback(wake)
            waitset.close()
            guard.close()
        if not future.done():
            self.remove_pending_request(future)
            return None
        if future.exception() is not None:
            raise future.exception()
        result: SrvTypeResponse = future.result()
        return result

    def call_async(self, request: SrvTypeRequest) -> Future:
        """Make a request; the future has the reply once an executor spins the node.

        Raises
        ------
        TypeError
            If the request is of another type.
        """
        if not isinstance(request, self.srv_type.Request):
            raise TypeError(f"expected a {self.srv_type.__name__}.Request, got {type(request)}")
        if self._destroyed:
            raise InvalidHandle("cannot use Destroyable because destruction was requested")
        future = Future()
        with self._lock:
            number = self.__client.next_sequence_number()
            future._request_number = number  # type: ignore[attr-defined]
            self._pending_requests[number] = future
        try:
            self.__client.send_request(request, number)
        except BaseException:
            self.remove_pending_request(future)
            raise
        future.add_done_callback(self._forget)
        return future

    def _forget(self, future: Future) -> None:
        self.remove_pending_request(future)

    _forget._runs_anywhere = True  # type: ignore[attr-defined]

    def get_pending_request(self, sequence_number: int) -> Future:
        """The future of a request without a reply; KeyError if there is none."""
        with self._lock:
            return self._pending_requests[sequence_number]

    def remove_pending_request(self, future: Future) -> None:
        """Forget a request: a reply to it is dropped."""
        number = getattr(future, "_request_number", None)
        with self._lock:
            if number is not None and self._pending_requests.get(number) is future:
                del self._pending_requests[number]

    def service_is_ready(self) -> bool:
        """Whether a server is there."""
        with self.handle:
            return bool(self.__client.is_server_available())

    def wait_for_service(self, timeout_sec: Optional[float] = None) -> bool:  # noqa: UP045
        """Wait until a server is there.

        Returns
        -------
        bool
            False at the timeout, or if the context is shut down meanwhile.
        """
        if self.service_is_ready():
            return True
        deadline = None if timeout_sec is None else time.monotonic_ns() + int(timeout_sec * 1e9)
        waitset = WaitSet()
        endpoints = (self.__client.writer, self.__client.reader)
        try:
            for endpoint in endpoints:
                dds.dds_set_status_mask(endpoint.entity, _MATCHED)
                waitset.attach(endpoint.entity, 1)
            while self.context.ok() and not self._destroyed:
                for endpoint in endpoints:
                    dds.dds_take_status(endpoint.entity, _status_buffer(), _MATCHED)
                if self.service_is_ready():
                    return True
                left = _SLICE if deadline is None else min(_SLICE, deadline - time.monotonic_ns())
                if left <= 0:
                    return False
                waitset.wait(left)
            return False
        finally:
            waitset.close()

    def _take_all(self, executor: Any = None) -> int:
        """Give every reply that is there to its future; how many there were."""
        count = 0
        while not self._destroyed and (taken := self.__client.take_response()) is not None:
            number, response = taken
            count += 1
            with self._lock:
                future = self._pending_requests.pop(number, None)
            if future is None:
                continue
            if executor is not None:
                future._set_executor(executor)
            if isinstance(response, Exception):
                future.set_exception(response)
            else:
                future.set_result(response)
        return count


def _status_buffer() -> Any:
    import ctypes

    return ctypes.byref(ctypes.c_uint32())
