"""What a clock's jump callbacks and sleepers share: its time source and its override."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Any
from weakref import WeakSet

from rclpy.clock_type import ClockType

__all__ = ["ClockState"]


class ClockState:
    """The time of one clock; ROS time follows ``override`` while it is enabled."""

    def __init__(self, clock_type: ClockType) -> None:
        self.clock_type = clock_type
        self.enabled = False
        self.override = 0
        self.changed = threading.Condition()
        self.jump_handles: list[Any] = []
        self.wakes: WeakSet[Any] = WeakSet()

    def now(self) -> int:
        """Nanoseconds."""
        if self.clock_type == ClockType.STEADY_TIME:
            return time.monotonic_ns()
        if self.enabled:
            return self.override
        return time.time_ns()

    def set_override(self, nanoseconds: int) -> None:
        before = self.override
        self._jump(nanoseconds - before if self.enabled else 0, None, nanoseconds)

    def enable_override(self, enabled: bool) -> None:
        if enabled == self.enabled:
            return
        before = self.now()
        after = self.override if enabled else time.time_ns()
        self._jump(after - before, enabled, None)

    def _jump(self, delta: int, enabled: bool | None, override: int | None) -> None:
        change = enabled is not None
        handles = [h for h in self.jump_handles if h._exceeded(delta, change)]
        for handle in handles:
            handle._before()
        with self.changed:
            if override is not None:
                self.override = override
            if enabled is not None:
                self.enabled = enabled
            self.changed.notify_all()
        kind = 1 if enabled is None else 2 if enabled else 3
        for handle in handles:
            handle._after(kind, delta)
        for executor in list(self.wakes):
            executor.wake()

    def wait_until(self, nanoseconds: int, keep_waiting: Callable[[], bool]) -> bool:
        """Sleep until the clock shows so much; False if ``keep_waiting`` said no, or ROS time was
        switched on or off meanwhile."""
        enabled = self.enabled
        while True:
            with self.changed:
                if not keep_waiting() or self.enabled != enabled:
                    return False
                left = nanoseconds - self.now()
                if left <= 0:
                    return True
                # Slices: signals and the end of a context are looked at in between.
                self.changed.wait(0.1 if self.enabled else min(left * 1e-9, 0.1))
