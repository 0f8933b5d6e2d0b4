"""The default context and the questions asked of it."""

from __future__ import annotations

import sys
import threading
from typing import List, Optional, Sequence, Set  # noqa: UP035

from rclpy._arguments import split_ros_arguments
from rclpy.constants import S_TO_NS
from rclpy.context import Context

__all__ = [
    "S_TO_NS",
    "get_available_rmw_implementations",
    "get_default_context",
    "get_rmw_implementation_identifier",
    "ok",
    "remove_ros_args",
    "shutdown",
    "timeout_sec_to_nsec",
    "try_shutdown",
]

_default_context: Context | None = None
_lock = threading.Lock()


def get_default_context(*, shutting_down=False) -> Context:  # type: ignore[no-untyped-def]
    """The context that everything uses unless told otherwise."""
    global _default_context
    with _lock:
        if _default_context is None:
            _default_context = Context()
        context = _default_context
        if shutting_down:
            _default_context = None
        return context


def remove_ros_args(args: Optional[Sequence[str]] = None) -> List[str]:  # noqa: UP006, UP045
    """The arguments without those of ROS; ``sys.argv`` by default."""
    return split_ros_arguments(sys.argv if args is None else args)[1]


def ok(*, context: Optional[Context] = None) -> bool:  # noqa: UP045
    """Whether the context is initialized and not shut down."""
    return (get_default_context() if context is None else context).ok()


def shutdown(*, context=None) -> None:  # type: ignore[no-untyped-def]
    """Shut the context down; the default one is then new."""
    if context is None:
        context = get_default_context(shutting_down=True)
    context.shutdown()


def try_shutdown(*, context=None) -> None:  # type: ignore[no-untyped-def]
    """Shut the context down if it has not been."""
    if context is None:
        context = get_default_context(shutting_down=True)
    context.try_shutdown()


def get_rmw_implementation_identifier() -> str:
    """The middleware whose conventions are followed."""
    return "rmw_cyclonedds_cpp"


def get_available_rmw_implementations() -> Set[str]:  # noqa: UP006
    """The only one here."""
    return {"rmw_cyclonedds_cpp"}


def timeout_sec_to_nsec(timeout_sec: Optional[float]) -> int:  # noqa: UP045
    """Seconds as nanoseconds: None and negative values are -1 (forever)."""
    if timeout_sec is None or timeout_sec < 0:
        return -1
    return int(float(timeout_sec) * S_TO_NS)
