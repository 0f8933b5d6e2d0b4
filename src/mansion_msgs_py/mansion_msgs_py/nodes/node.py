"""The base class of Mansion's nodes: timers on a steady clock, and diagnostics of the calls that they serve."""

import threading
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from time import monotonic
from typing import Any, Final

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.clock import Clock, ClockType
from rclpy.node import Node

__all__ = ["CallCounts", "MansionNode", "wake_regularly"]

WAKE: Final = 0.5
"""Seconds after which an executor with nothing to do looks whether its context has ended."""

PERIOD: Final = 1.0
"""Seconds between two diagnostics, as ``diagnostic_updater`` sends them."""

RECENT: Final = 60.0
"""Seconds for which an internal failure makes the diagnostics a warning."""


class CallCounts:
    """How many calls a node has served; safe to use from several threads.

    Parameters
    ----------
    clock : callable
        Seconds of a steady clock.
    """

    def __init__(self, clock: Callable[[], float] = monotonic) -> None:
        self._clock = clock
        self._guard = threading.Lock()
        self.served = self.running = self.refused = self.failed = 0
        self._fault, self._fault_at = "", float("-inf")

    @contextmanager
    def one(self) -> Iterator[None]:
        """Count a call as running within the block, and as served after it."""
        with self._guard:
            self.running += 1
        try:
            yield
        finally:
            with self._guard:
                self.running -= 1
                self.served += 1

    def refuse(self) -> None:
        """Count a call that was answered with an error of the caller's."""
        with self._guard:
            self.refused += 1

    def fail(self, reason: str) -> None:
        """Count a call that failed inside of the node."""
        with self._guard:
            self.failed += 1
            self._fault, self._fault_at = reason, self._clock()

    def recent_fault(self) -> str:
        """Return why the last call of the past minute failed inside of the node; empty when none did."""
        with self._guard:
            return self._fault if self._clock() - self._fault_at < RECENT else ""


def wake_regularly(node: Node) -> None:
    """Wake the executor of a node twice a second.

    rclpy can miss the wake-up of a context that is shut down, by a signal for one; the next one of a timer ends the
    wait then.
    """
    node.create_timer(WAKE, lambda: None, clock=Clock(clock_type=ClockType.STEADY_TIME))


class MansionNode(Node):
    """A node that publishes ``/diagnostics`` once a second.

    Parameters
    ----------
    name : str
    **options
        Passed to `rclpy.node.Node`.

    Attributes
    ----------
    calls : CallCounts
        Counts of the calls to its JSON services.
    """

    def __init__(self, name: str, **options: Any) -> None:
        super().__init__(name, **options)
        self.calls = CallCounts()
        self._steady = Clock(clock_type=ClockType.STEADY_TIME)
        self._diagnostics = self.create_publisher(DiagnosticArray, "/diagnostics", 10)
        self.repeat(PERIOD, self._publish_diagnostics)

    def repeat(self, period: float, callback: Callable[[], None]) -> None:
        """Call back every `period` seconds of the wall's clock, one call after the other.

        Not by the node's own clock: with ``use_sim_time`` that one stands still until somebody publishes ``/clock``,
        which may be this node.
        """
        self.create_timer(period, callback, MutuallyExclusiveCallbackGroup(), self._steady)

    def facts(self) -> Iterable[tuple[str, object]]:
        """Return further keys and values of the diagnostics."""
        return ()

    def _publish_diagnostics(self) -> None:
        calls, fault = self.calls, self.calls.recent_fault()
        values = (
            ("calls running", calls.running),
            ("calls served", calls.served),
            ("calls refused", calls.refused),
            ("calls failed", calls.failed),
            *self.facts(),
        )
        message = DiagnosticArray()
        message.header.stamp = self.get_clock().now().to_msg()
        message.status = [
            DiagnosticStatus(
                level=DiagnosticStatus.WARN if fault else DiagnosticStatus.OK,
                name=f"mansion: {self.get_fully_qualified_name()}",
                message=fault or ("busy" if calls.running else "idle"),
                hardware_id="mansion",
                values=[KeyValue(key=key, value=str(value)) for key, value in values],
            )
        ]
        self._diagnostics.publish(message)
