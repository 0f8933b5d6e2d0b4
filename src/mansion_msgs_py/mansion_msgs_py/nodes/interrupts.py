"""What SIGINT and SIGTERM do to a node process."""

import os
import signal
import threading
import time
from collections.abc import Callable
from types import FrameType
from typing import Final

__all__ = ["GRACE", "PATIENCE", "Interrupts"]

PATIENCE: Final = 1.0
"""Seconds in which several SIGINT are one: a launcher and its terminal both send theirs."""

GRACE: Final = 2.5
"""Seconds after which a process that was told to end does so whatever it is at; files are written atomically."""

SIGNALS: Final = (signal.SIGINT, signal.SIGTERM)


class Interrupts:
    """A signal stops a node that is being made at once, and lets one that spins end by its context.

    `KeyboardInterrupt` may be raised between any two steps of the main thread. Inside of an executor it would leave
    locks taken and callbacks half handed out, though rclpy's own handler, which calls this one, has shut the context
    down already. A second SIGINT after a while is obeyed.

    Parameters
    ----------
    clock : callable
        Seconds of a steady clock.
    kill : callable
        Ends the process without further ado; called `GRACE` seconds after the first signal.
    """

    def __init__(
        self, clock: Callable[[], float] = time.monotonic, kill: Callable[[], None] = lambda: os._exit(0)
    ) -> None:
        self.spinning = False
        self._clock = clock
        self._kill = kill
        self._first: float | None = None
        self._ended = False

    def install(self) -> None:
        """Handle the signals; before ``rclpy.init``, in the main thread: elsewhere Python allows no handlers."""
        if threading.current_thread() is threading.main_thread():
            for number in SIGNALS:
                signal.signal(number, self.handle)

    def handle(self, number: int, frame: FrameType | None) -> None:
        """Handle a signal.

        Raises
        ------
        KeyboardInterrupt
            While the node is being made, and at a second SIGINT that comes `PATIENCE` seconds after the first signal.
        """
        if self._ended:
            return
        now = self._clock()
        again = self._first is not None and number == signal.SIGINT and now - self._first > PATIENCE
        if self._first is None:
            self._first = now
            deadline = threading.Timer(GRACE, self._kill)
            deadline.daemon = True
            deadline.start()
        if again or not self.spinning:
            raise KeyboardInterrupt

    def ignore(self) -> None:
        """Take no notice of further signals: the process is ending, with a status of its own."""
        self._ended = True
        if threading.current_thread() is threading.main_thread():
            for number in SIGNALS:
                signal.signal(number, signal.SIG_IGN)
