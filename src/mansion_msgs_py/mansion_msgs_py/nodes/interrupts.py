"""What Ctrl-C does to a node process."""

import signal
import threading
import time
from collections.abc import Callable
from types import FrameType
from typing import Final

__all__ = ["PATIENCE", "Interrupts"]

PATIENCE: Final = 1.0
"""Seconds in which several SIGINT are one: a launcher and its terminal both send theirs."""


class Interrupts:
    """SIGINT stops a node that is being made at once, and lets one that spins end by its context.

    `KeyboardInterrupt` may be raised between any two steps of the main thread. Inside of an executor it would leave
    locks taken and callbacks half handed out, though rclpy's own handler, which calls this one, has shut the context
    down already. Who interrupts again, after a while, is obeyed.

    Parameters
    ----------
    clock : callable
        Seconds of a steady clock.
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self.spinning = False
        self._clock = clock
        self._first: float | None = None

    def install(self) -> None:
        """Handle SIGINT; before ``rclpy.init``, in the main thread: elsewhere Python allows no handlers."""
        if threading.current_thread() is threading.main_thread():
            signal.signal(signal.SIGINT, self.handle)

    def handle(self, number: int, frame: FrameType | None) -> None:
        """Be told of a signal.

        Raises
        ------
        KeyboardInterrupt
            Unless the node spins and this is the first time.
        """
        now = self._clock()
        if not self.spinning or (self._first is not None and now - self._first > PATIENCE):
            raise KeyboardInterrupt
        if self._first is None:
            self._first = now
