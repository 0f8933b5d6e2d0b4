"""The life of a program's connection to ROS: from ``init`` to ``shutdown``."""

from __future__ import annotations

import atexit
import sys
import threading
import weakref
from contextlib import AbstractContextManager
from types import TracebackType
from typing import Any, Callable, Generic, List, Optional, Protocol, Type, TypeVar  # noqa: UP035

from rclpy._arguments import RosArguments, parse_arguments
from rclpy._dds.domain import domain_id_from_environment
from rclpy._dds.library import DDSError
from rclpy._dds.participant import Participant
from rclpy._log_sink import apply_arguments
from rclpy._rclpy_pybind11 import RCLError

__all__ = ["Context", "ContextHandle"]

g_logging_ref_count: int = 0
_T = TypeVar("_T", bound="Context")
_contexts: weakref.WeakSet[Any] = weakref.WeakSet()


class DestroyableType(Protocol):
    """What can be destroyed."""

    def destroy_when_not_in_use(self) -> None: ...


class ContextHandle(DestroyableType, Protocol):
    """The inside of a context."""

    def ok(self) -> bool: ...

    def get_domain_id(self) -> int: ...

    def shutdown(self) -> None: ...


class _State:
    """A context between ``init`` and the end: domain, arguments and the participant."""

    def __init__(self, arguments: RosArguments, domain_id: int) -> None:
        self.arguments = arguments
        self.domain_id = domain_id
        self.valid = True
        self._participant: Participant | None = None
        self._nodes = 0
        self._lock = threading.RLock()

    def __enter__(self) -> _State:
        return self

    def __exit__(self, *_: object) -> None:
        return None

    def ok(self) -> bool:
        return self.valid

    def get_domain_id(self) -> int:
        return self.domain_id

    def shutdown(self) -> None:
        """Nothing new is done from here on; existing nodes are destroyed by their owners."""
        with self._lock:
            self.valid = False
            self._close_if_unused()

    def acquire_participant(self) -> Participant:
        """The participant, made for the first node."""
        with self._lock:
            if not self.valid:
                raise RCLError("the context is shut down")
            if self._participant is None:
                try:
                    self._participant = Participant(self.domain_id)
                except DDSError as problem:
                    raise RCLError(str(problem)) from problem
            self._nodes += 1
            return self._participant

    def release_participant(self) -> None:
        with self._lock:
            self._nodes -= 1
            self._close_if_unused()

    def _close_if_unused(self) -> None:
        if self._nodes <= 0 and not self.valid:
            self.close()

    def close(self) -> None:
        with self._lock:
            self.valid = False
            participant, self._participant = self._participant, None
        if participant is not None:
            participant.close()


class Context(AbstractContextManager["Context"], Generic[_T]):
    """Everything that belongs to one ``init``; usable in a ``with`` block."""

    def __init__(self) -> None:
        self._lock = threading.RLock()
        self._callbacks: list[Callable[[], None]] = []
        self._logging_initialized = False
        self.__context: _State | None = None
        self._ended_by_signal = False

    @property
    def handle(self) -> Optional[Any]:  # noqa: UP045
        return self.__context

    def destroy(self) -> None:
        """End the context and everything in it."""
        if self.__context is not None:
            self.__context.close()

    def init(
        self,
        args: Optional[List[str]] = None,  # noqa: UP006, UP045
        *,
        initialize_logging: bool = True,
        domain_id: Optional[int] = None,  # noqa: UP045
    ) -> None:
        """Initialize the context.

        Parameters
        ----------
        args
            Command line; None takes ``sys.argv``.
        domain_id
            DDS domain; None takes ``ROS_DOMAIN_ID``.
        """
        if domain_id is not None and domain_id < 0:
            raise RuntimeError(f"Domain id ({domain_id}) should not be lower than zero.")
        with self._lock:
            if self.__context is not None:
                raise RuntimeError("Context.init() must only be called once")
            arguments = parse_arguments(sys.argv if args is None else args)
            try:
                number = domain_id_from_environment() if domain_id is None else domain_id
            except ValueError as problem:
                raise RCLError(str(problem)) from None
            if initialize_logging and not self._logging_initialized:
                apply_arguments(arguments)
                self._logging_initialized = True
            self.__context = _State(arguments, number)
            self._ended_by_signal = False
            _contexts.add(self)

    def ok(self) -> bool:
        """Whether the context is initialized and not shut down."""
        state = self.__context
        return state is not None and state.valid and not self._ended_by_signal

    def _call_on_shutdown_callbacks(self) -> None:
        with self._lock:
            callbacks, self._callbacks = self._callbacks, []
        for weak_method in callbacks:
            callback = weak_method() if isinstance(weak_method, weakref.WeakMethod) else weak_method
            if callback is not None:
                callback()

    def shutdown(self) -> None:
        """Shut the context down.

        Raises
        ------
        RuntimeError
            If it was not initialized; RCLError if it is shut down already.
        """
        if self.__context is None:
            raise RuntimeError("Context must be initialized before it can be shutdown")
        with self._lock:
            if not self.__context.valid:
                raise RCLError(
                    "failed to shutdown: rcl_shutdown already called on the given context"
                )
            self.__context.valid = False
        self._call_on_shutdown_callbacks()
        self.__context.shutdown()

    def try_shutdown(self) -> None:
        """Shut the context down if it is not already."""
        with self._lock:
            if self.__context is None or not self.__context.valid:
                return
            self.__context.valid = False
        self._call_on_shutdown_callbacks()
        self.__context.shutdown()

    def _shut_down_by_signal(self) -> None:
        """End ``ok()`` at once; a thread then does the rest, with :meth:`try_shutdown`."""
        self._ended_by_signal = True

    def on_shutdown(self, callback: Callable[[], None]) -> None:
        """Have the callback called once at shutdown."""
        if not callable(callback):
            raise TypeError("callback should be a callable, got {}", type(callback))
        with self._lock:
            if self.__context is not None and not self.__context.valid:
                callback()
                return
            if hasattr(callback, "__self__"):
                self._callbacks.append(weakref.WeakMethod(callback))
            else:
                self._callbacks.append(callback)

    def get_domain_id(self) -> int:
        """The DDS domain of this context."""
        if self.__context is None:
            raise RuntimeError("Context must be initialized before it can have a domain id")
        return self.__context.domain_id

    def __enter__(self) -> Context:
        # The default arguments are for programs; a with block that was not initialized takes them.
        if self.__context is None:
            self.init()
        return self

    def __exit__(
        self,
        exc_type: Optional[Type[BaseException]],  # noqa: UP006, UP045
        exc_val: Optional[BaseException],  # noqa: UP045
        exc_tb: Optional[TracebackType],  # noqa: UP045
    ) -> None:
        self.try_shutdown()


@atexit.register
def _leave_domains() -> None:
    for context in list(_contexts):
        context.try_shutdown()
        context.destroy()
