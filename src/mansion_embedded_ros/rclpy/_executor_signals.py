"""How executors end a wait: exceptions of Jazzy, a timeout that others read, and awaiting what may be a coroutine."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Coroutine
from typing import Any

__all__ = [
    "ConditionReachedException",
    "ExternalShutdownException",
    "ShutdownException",
    "TimeoutException",
    "TimeoutObject",
    "await_or_execute",
]


async def await_or_execute(callback: Callable[..., Any] | Coroutine[Any, Any, Any], *args) -> Any:  # type: ignore[no-untyped-def]
    """Await a coroutine function, call any other."""
    if inspect.iscoroutinefunction(callback):
        return await callback(*args)
    return callback(*args)  # type: ignore[operator]


class TimeoutException(Exception):
    """Signal that a timeout occurred."""


class ShutdownException(Exception):
    """Signal that executor was shut down."""


class ExternalShutdownException(Exception):
    """Context has been shutdown."""

    def __init__(self, *args: object) -> None:
        super().__init__(*args)


class ConditionReachedException(Exception):
    """Future has been completed."""


class TimeoutObject:
    """A timeout that others read while it counts down."""

    def __init__(self, timeout: float) -> None:
        self._timeout = timeout

    @property
    def timeout(self) -> float:
        return self._timeout

    @timeout.setter
    def timeout(self, timeout: float) -> None:
        self._timeout = timeout


for _cls in (
    ConditionReachedException,
    ExternalShutdownException,
    ShutdownException,
    TimeoutException,
    TimeoutObject,
):
    _cls.__module__ = "rclpy.executors"
