"""Timers that an executor runs, and rates that sleep by them."""

from __future__ import annotations

import threading
from collections.abc import Callable as _Callable
from typing import Any, Callable, Optional  # noqa: UP035

from rclpy._rclpy_pybind11 import InvalidHandle, TimerCancelledError
from rclpy.callback_groups import CallbackGroup
from rclpy.clock import Clock
from rclpy.clock_type import ClockType
from rclpy.context import Context
from rclpy.exceptions import ROSInterruptException
from rclpy.utilities import get_default_context

__all__ = ["Rate", "Timer"]


class Timer:
    """Call a callback once a period of its clock.

    A late timer keeps its phase: calls that were missed are left out.
    """

    def __init__(
        self,
        callback: Callable,  # type: ignore[type-arg]
        callback_group: CallbackGroup,
        timer_period_ns: int,
        clock: Clock,
        *,
        context: Optional[Context] = None,  # noqa: UP045
        autostart: bool = True,
    ):
        self._context = get_default_context() if context is None else context
        if timer_period_ns < 0:
            raise ValueError(f"timer period is {timer_period_ns} ns; it cannot be negative")
        self._clock = clock
        self._period = int(timer_period_ns)
        self.callback: Any = callback
        self.callback_group: CallbackGroup | None = callback_group
        self._lock = threading.Lock()
        self._canceled = not autostart
        self._last = clock._state.now()
        self._next = self._last + self._period
        self._wake: _Callable[[], None] = _nobody
        self._destroyed = False

    @property
    def handle(self) -> Timer:
        return self

    def __enter__(self) -> Timer:
        return self

    def __exit__(self, *_: object) -> None:
        return None

    def _require_alive(self) -> None:
        if self._destroyed:
            raise InvalidHandle("cannot use Destroyable because destruction was requested")

    def destroy(self):  # type: ignore[no-untyped-def]
        """End the timer."""
        self._destroyed = True
        self._wake()

    @property
    def clock(self) -> Clock:
        return self._clock

    @property
    def timer_period_ns(self) -> int:
        return self._period

    @timer_period_ns.setter
    def timer_period_ns(self, value: int) -> None:
        value = int(value)
        if value < 0:
            raise ValueError(f"timer period is {value} ns; it cannot be negative")
        with self._lock:
            self._period = value
            self._next = self._last + value
        self._wake()

    def is_ready(self):  # type: ignore[no-untyped-def]
        """Whether the callback is due."""
        self._require_alive()
        return not self._canceled and self._clock._state.now() >= self._next

    def is_canceled(self):  # type: ignore[no-untyped-def]
        self._require_alive()
        return self._canceled

    def cancel(self):  # type: ignore[no-untyped-def]
        """Stop calling until :meth:`reset`."""
        self._require_alive()
        self._canceled = True

    def reset(self):  # type: ignore[no-untyped-def]
        """Start a new period now."""
        self._require_alive()
        with self._lock:
            self._last = self._clock._state.now()
            self._next = self._last + self._period
            self._canceled = False
        self._wake()

    def time_since_last_call(self):  # type: ignore[no-untyped-def]
        """Nanoseconds since the last call."""
        self._require_alive()
        return self._clock._state.now() - self._last

    def time_until_next_call(self):  # type: ignore[no-untyped-def]
        """Nanoseconds until the next call, None if the timer is cancelled."""
        self._require_alive()
        if self._canceled:
            return None
        return self._next - self._clock._state.now()

    def _wall_wait(self) -> int | None:
        """Nanoseconds that an executor may sleep; None if only a wake-up can make it due."""
        if self._canceled or self._destroyed:
            return None
        state = self._clock._state
        left = self._next - state.now()
        if left > self._period:
            left = self._follow_backward_jump()
        if left > 0 and state.clock_type == ClockType.ROS_TIME and state.enabled:
            return None
        return max(left, 0)

    def _follow_backward_jump(self) -> int:
        """A clock set back leaves the next call one period away at most."""
        with self._lock:
            now = self._clock._state.now()
            self._next = min(self._next, now + self._period)
            return self._next - now

    def _take(self) -> Any:
        """Begin a call if it is due: move on to the next period."""
        with self._lock:
            now = self._clock._state.now()
            if self._canceled or self._destroyed or now < self._next:
                return None
            self._last = now
            self._next += self._period
            if self._next < now:
                missed = (now - self._next) // self._period + 1 if self._period else 0
                self._next = self._next + missed * self._period if self._period else now
            return ()

    def _execute(self, _: Any) -> Any:
        return self.callback() if self.callback is not None else None


def _nobody() -> None:
    """Nobody waits for this timer yet."""


class Rate:
    """Sleep in a loop at a rate, while another thread spins the node."""

    def __init__(self, timer: Timer, *, context):  # type: ignore[no-untyped-def]
        self._clock = timer.clock
        self._timer = timer
        self._timer.callback = self._on_timer
        self._event = threading.Event()
        self._lock = threading.Lock()
        self._sleeping = 0
        self._is_shutdown = False
        self._is_destroyed = False
        context.on_shutdown(self._on_shutdown)

    def _on_timer(self) -> None:
        self._event.set()

    def _on_shutdown(self) -> None:
        self._is_shutdown = True
        self.destroy()

    def destroy(self):  # type: ignore[no-untyped-def]
        """End the rate; sleepers raise."""
        self._is_destroyed = True
        self._event.set()

    def _raise_if_ended(self) -> None:
        if self._is_shutdown:
            raise ROSInterruptException()
        if self._is_destroyed:
            raise RuntimeError("Rate cannot sleep because it has been destroyed")
        if self._timer.is_canceled():
            raise TimerCancelledError("Rate cannot sleep because the timer has been canceled")

    def sleep(self):  # type: ignore[no-untyped-def]
        """Block until the timer's next call.

        Raises
        ------
        ROSInterruptException
            If the context is shut down.
        """
        self._raise_if_ended()
        with self._lock:
            self._sleeping += 1
        try:
            while not self._event.wait(0.5):
                if self._timer.is_canceled():
                    break
            self._raise_if_ended()
        finally:
            with self._lock:
                self._sleeping -= 1
                if self._sleeping == 0 and not self._is_destroyed:
                    self._event.clear()
