"""A condition that a program triggers itself."""

from __future__ import annotations

from typing import Any

from rclpy._dds.waitset import Guard
from rclpy.callback_groups import CallbackGroup
from rclpy.utilities import get_default_context

__all__ = ["GuardCondition"]


class GuardCondition:
    """Have an executor run the callback when :meth:`trigger` is called."""

    def __init__(self, callback, callback_group, context=None):  # type: ignore[no-untyped-def]
        self._context = get_default_context() if context is None else context
        if self._context.handle is None:
            raise RuntimeError("Context must be initialized before a GuardCondition can be created")
        self._guard = Guard()
        self.callback: Any = callback
        self.callback_group: CallbackGroup | None = callback_group
        self._executor_event = False
        self._destroyed = False

    def trigger(self):  # type: ignore[no-untyped-def]
        """Have the callback run once."""
        self._guard.trigger()

    @property
    def handle(self) -> Guard:
        return self._guard

    def _wait_entity(self) -> int:
        return self._guard.entity

    def _take(self) -> Any:
        return () if self._guard.clear() else None

    def _execute(self, _: Any) -> Any:
        return self.callback() if self.callback is not None else None

    def destroy(self):  # type: ignore[no-untyped-def]
        """End it; a second call does nothing."""
        self._destroyed = True
        self._guard.close()
