"""Points in time of a clock type, with nanosecond precision."""

from __future__ import annotations

from typing import Protocol, Tuple, Union  # noqa: UP035

import builtin_interfaces.msg
from rclpy.clock_type import ClockType
from rclpy.constants import S_TO_NS
from rclpy.duration import Duration

__all__ = ["S_TO_NS", "Time", "TimeHandle"]

_LIMIT = 2**63


class TimeHandle(Protocol):
    """A time as the middleware holds it."""

    nanoseconds: int
    clock_type: ClockType


class Time:
    """A point in time of one clock type; different types cannot be compared."""

    def __init__(
        self,
        *,
        seconds: Union[int, float] = 0,  # noqa: UP007
        nanoseconds: int = 0,
        clock_type: ClockType = ClockType.SYSTEM_TIME,
    ):
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        if seconds < 0:
            raise ValueError("Seconds value must not be negative")
        if nanoseconds < 0:
            raise ValueError("Nanoseconds value must not be negative")
        total = int(seconds * S_TO_NS) + int(nanoseconds)
        if total >= _LIMIT:
            raise OverflowError("Total nanoseconds value is too large to store in C time point.")
        self._nanoseconds = total
        self._clock_type = clock_type

    @property
    def nanoseconds(self) -> int:
        return self._nanoseconds

    @property
    def clock_type(self) -> ClockType:
        return self._clock_type

    def seconds_nanoseconds(self) -> Tuple[int, int]:  # noqa: UP006
        """Whole seconds and the nanoseconds beyond them."""
        return divmod(self._nanoseconds, S_TO_NS)

    def __repr__(self) -> str:
        return f"Time(nanoseconds={self.nanoseconds}, clock_type={self.clock_type.name})"

    def __add__(self, other: Duration) -> Time:
        if not isinstance(other, Duration):
            return NotImplemented
        total = self.nanoseconds + other.nanoseconds
        if total < 0 or total >= _LIMIT:
            raise OverflowError("Addition leads to overflow in C storage.")
        return Time(nanoseconds=total, clock_type=self.clock_type)

    def __radd__(self, other: Duration) -> Time:
        return self.__add__(other)

    def __sub__(self, other: Time | Duration) -> Time | Duration:
        if isinstance(other, Time):
            self._require_same_clock(other, "subtract times")
            return Duration(nanoseconds=self.nanoseconds - other.nanoseconds)
        if isinstance(other, Duration):
            total = self.nanoseconds - other.nanoseconds
            if total < 0:
                raise ValueError("Subtraction leads to negative time.")
            return Time(nanoseconds=total, clock_type=self.clock_type)
        return NotImplemented

    def _require_same_clock(self, other: Time, action: str) -> None:
        if self.clock_type != other.clock_type:
            raise TypeError(f"Can't {action} with different clock types")

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Time):
            self._require_same_clock(other, "compare times")
            return self.nanoseconds == other.nanoseconds
        return NotImplemented

    def __ne__(self, other: object) -> bool:
        return not self == other if isinstance(other, Time) else NotImplemented

    def __lt__(self, other: object) -> bool:
        if isinstance(other, Time):
            self._require_same_clock(other, "compare times")
            return self.nanoseconds < other.nanoseconds
        return NotImplemented

    def __le__(self, other: object) -> bool:
        if isinstance(other, Time):
            self._require_same_clock(other, "compare times")
            return self.nanoseconds <= other.nanoseconds
        return NotImplemented

    def __gt__(self, other: object) -> bool:
        if isinstance(other, Time):
            self._require_same_clock(other, "compare times")
            return self.nanoseconds > other.nanoseconds
        return NotImplemented

    def __ge__(self, other: object) -> bool:
        if isinstance(other, Time):
            self._require_same_clock(other, "compare times")
            return self.nanoseconds >= other.nanoseconds
        return NotImplemented

    def __hash__(self) -> int:
        return hash((self._nanoseconds, self._clock_type))

    def to_msg(self) -> builtin_interfaces.msg.Time:
        """The time as ``builtin_interfaces/Time``."""
        seconds, nanoseconds = self.seconds_nanoseconds()
        return builtin_interfaces.msg.Time(sec=seconds, nanosec=nanoseconds)

    @classmethod
    def from_msg(
        cls, msg: builtin_interfaces.msg.Time, clock_type: ClockType = ClockType.ROS_TIME
    ) -> Time:
        if not isinstance(msg, builtin_interfaces.msg.Time):
            raise TypeError("Must pass a builtin_interfaces.msg.Time object")
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec, clock_type=clock_type)
