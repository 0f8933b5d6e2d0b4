"""Clocks: system, steady and ROS time, jumps of time, and sleeping."""

from __future__ import annotations

from enum import IntEnum
from types import TracebackType
from typing import TYPE_CHECKING, Callable, Dict, Optional, Protocol, Type  # noqa: UP035

from rclpy._clock_state import ClockState
from rclpy.clock_type import ClockType
from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.exceptions import NotInitializedException
from rclpy.time import Time, TimeHandle
from rclpy.utilities import get_default_context

if TYPE_CHECKING:
    from typing import Any

__all__ = [
    "Clock",
    "ClockChange",
    "ClockHandle",
    "ClockType",
    "JumpHandle",
    "JumpThreshold",
    "ROSClock",
    "TimeJump",
    "TimeJumpDictionary",
]


class ClockChange(IntEnum):
    """What happened to a clock in a jump."""

    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4


class TimeJumpDictionary(Dict[str, "Any"]):  # noqa: UP006
    """``clock_change`` and ``delta`` (nanoseconds) of a jump."""


class ClockHandle(Protocol):
    """A clock as the middleware holds it."""

    def get_now(self) -> TimeHandle: ...

    def get_ros_time_override_is_enabled(self) -> bool: ...

    def set_ros_time_override_is_enabled(self, enabled: bool) -> None: ...

    def set_ros_time_override(self, time_point: TimeHandle) -> None: ...

    def add_clock_callback(
        self, pyjump_handle: JumpHandle, on_clock_change: bool, min_forward: int, min_backward: int
    ) -> None: ...

    def remove_clock_callback(self, pyjump_handle: JumpHandle) -> None: ...


class JumpThreshold:
    """When a change of time counts as a jump."""

    def __init__(
        self,
        *,
        min_forward: Optional[Duration],  # noqa: UP045
        min_backward: Optional[Duration],  # noqa: UP045
        on_clock_change: bool = True,
    ):
        if min_forward is not None and min_forward.nanoseconds <= 0:
            raise ValueError("min_forward must be a positive non-zero duration")
        if min_backward is not None and min_backward.nanoseconds >= 0:
            raise ValueError("min_backward must be a negative non-zero duration")
        if min_forward is None and min_backward is None and not on_clock_change:
            raise ValueError("At least one jump threshold must be enabled")
        self.min_forward = min_forward
        self.min_backward = min_backward
        self.on_clock_change = on_clock_change


class TimeJump:
    """One jump of a clock."""

    def __init__(self, clock_change: ClockChange, delta: Duration):
        if not isinstance(clock_change, ClockChange | int):
            raise TypeError("clock_change must be an instance of rclpy.clock.ClockChange")
        self._clock_change = clock_change
        self._delta = delta

    @property
    def clock_change(self) -> ClockChange:
        return self._clock_change

    @property
    def delta(self) -> Duration:
        return self._delta


class JumpHandle:
    """A registered jump callback; leaving its ``with`` block unregisters it."""

    def __init__(
        self,
        *,
        clock: Clock,
        threshold: JumpThreshold,
        pre_callback: Optional[Callable[[], None]],  # noqa: UP045
        post_callback: Optional[Callable[[TimeJumpDictionary], None]],  # noqa: UP045
    ):
        if pre_callback is None and post_callback is None:
            raise ValueError("One of pre_callback or post_callback must be callable")
        if pre_callback is not None and not callable(pre_callback):
            raise ValueError("pre_callback must be callable if given")
        if post_callback is not None and not callable(post_callback):
            raise ValueError("post_callback must be callable if given")
        self._clock: Clock | None = clock
        self._threshold = threshold
        self._pre_callback = pre_callback
        self._post_callback = post_callback
        clock._state.jump_handles.append(self)

    def _exceeded(self, delta: int, clock_change: bool) -> bool:
        limit = self._threshold
        if clock_change and limit.on_clock_change:
            return True
        forward, backward = limit.min_forward, limit.min_backward
        return bool(
            (forward is not None and delta >= forward.nanoseconds)
            or (backward is not None and delta <= backward.nanoseconds)
        )

    def _before(self) -> None:
        if self._pre_callback is not None:
            self._pre_callback()

    def _after(self, kind: int, delta: int) -> None:
        if self._post_callback is not None:
            jump = TimeJump(ClockChange(kind), Duration(nanoseconds=delta))
            self._post_callback(jump)  # type: ignore[arg-type]

    def unregister(self) -> None:
        """Remove the callbacks from the clock."""
        if self._clock is not None:
            self._clock._state.jump_handles.remove(self)
            self._clock = None

    def __enter__(self) -> JumpHandle:
        return self

    def __exit__(
        self,
        t: Optional[Type[BaseException]],  # noqa: UP006, UP045
        v: Optional[BaseException],  # noqa: UP045
        tb: Optional[TracebackType],  # noqa: UP045
    ) -> None:
        self.unregister()


class Clock:
    """A clock of one type; ``Clock(clock_type=ClockType.ROS_TIME)`` is a :class:`ROSClock`."""

    _state: ClockState

    def __new__(cls, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> Clock:
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        chosen = ROSClock if clock_type is ClockType.ROS_TIME else cls
        self = object.__new__(chosen)
        self._state = ClockState(clock_type)
        return self

    @property
    def clock_type(self) -> ClockType:
        return self._state.clock_type

    @property
    def handle(self) -> ClockState:
        return self._state

    def __repr__(self) -> str:
        return f"Clock(clock_type={self.clock_type.name})"

    def now(self) -> Time:
        """The current time of this clock."""
        return Time(nanoseconds=self._state.now(), clock_type=self.clock_type)

    def create_jump_callback(
        self,
        threshold: JumpThreshold,
        *,
        pre_callback: Optional[Callable[[], None]] = None,  # noqa: UP045
        post_callback: Optional[Callable[[TimeJump], None]] = None,  # noqa: UP045
    ) -> JumpHandle:
        """Have callbacks called around a jump of this clock beyond the threshold."""
        return JumpHandle(
            clock=self, threshold=threshold, pre_callback=pre_callback, post_callback=post_callback
        )

    def sleep_until(self, until: Time, context: Optional[Context] = None) -> bool:  # noqa: UP045
        """Sleep until the time is reached.

        Returns
        -------
        bool
            False if it woke up early: the context was shut down, or ROS time switched on or off.
        """
        if context is None:
            context = get_default_context()
        if not context.ok():
            raise NotInitializedException()
        if until.clock_type != self.clock_type:
            raise ValueError("until's clock type does not match this clock's type")
        return self._state.wait_until(until.nanoseconds, context.ok)

    def sleep_for(self, rel_time: Duration, context: Optional[Context] = None) -> bool:  # noqa: UP045
        """Sleep for a duration of this clock; False as in :meth:`sleep_until`."""
        return self.sleep_until(self.now() + rel_time, context)


class ROSClock(Clock):
    """The time of ``/clock`` while it is active, else system time."""

    def __new__(cls) -> ROSClock:
        return super().__new__(Clock, clock_type=ClockType.ROS_TIME)  # type: ignore[return-value]

    @property
    def ros_time_is_active(self) -> bool:
        return self._state.enabled

    def _set_ros_time_is_active(self, enabled: bool) -> None:
        self._state.enable_override(enabled)

    def set_ros_time_override(self, time: Time) -> None:
        """Set the time that the clock shows while ROS time is active."""
        if not isinstance(time, Time):
            raise TypeError("Time must be specified as rclpy.time.Time")
        self._state.set_override(time.nanoseconds)
