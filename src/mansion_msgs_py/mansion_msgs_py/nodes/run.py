"""The life of a node process: how it starts, spins, and ends on SIGINT or SIGTERM."""

import contextlib
import faulthandler
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Sequence
from types import FrameType
from typing import Final

import rclpy
from rclpy.exceptions import ParameterException
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.logging import get_logger
from rclpy.node import Node

from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.nodes.node import wake_regularly

__all__ = ["GRACE", "INTERRUPT_WINDOW", "Interrupts", "run_node"]

INTERRUPT_WINDOW: Final = 1.0
"""Seconds in which several SIGINT are one: a launcher and its terminal both send theirs."""

GRACE: Final = 2.5
"""Seconds after which a process that was told to end does so whatever it is doing; files are written atomically."""

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
            While the node is being made, and at a second SIGINT that comes `INTERRUPT_WINDOW` seconds after the
            first signal.
        """
        if self._ended:
            return
        now = self._clock()
        again = self._first is not None and number == signal.SIGINT and now - self._first > INTERRUPT_WINDOW
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


LAST_GRACE: Final = 0.3
"""Seconds beyond `GRACE` after which the process is killed, should it not have been able to end itself."""

_WATCH: Final = """
[ -n "$(head -c 1 | tr '\\000-\\377' x)" ] || exit 0
timeout "$2" cat >/dev/null
[ $? = 124 ] && kill -KILL "$1"
"""
"""Waits for the byte that Python's handler writes for a signal; then, unless this process closes the pipe in time by
ending, kills it."""


def watch_from_outside(grace: float = GRACE + LAST_GRACE) -> None:
    """Have this process killed `grace` seconds after a signal if it is still there.

    What ends it otherwise is Python, which does nothing while a call of C keeps the interpreter: a search of a regular
    expression, a kernel. The byte in the pipe is written by the signal's handler itself (`signal.set_wakeup_fd`).
    """
    if sys.platform != "linux" or threading.current_thread() is not threading.main_thread():
        return
    reading, writing = os.pipe()
    os.set_blocking(writing, False)
    command = ["/bin/sh", "-c", _WATCH, "watch", str(os.getpid()), f"{grace:g}"]
    quiet = subprocess.DEVNULL
    subprocess.Popen(command, stdin=reading, stdout=quiet, stderr=quiet, start_new_session=True)
    os.close(reading)
    signal.set_wakeup_fd(writing, warn_on_full_buffer=False)


CALLBACK_GRACE = 0.5
"""Seconds for which callbacks that still run are waited for at the end."""


def run_node(make: Callable[[], Node], args: Sequence[str] | None = None, *, threads: int = 4) -> None:
    """Make a node and spin it until the process is told to end, which leaves no traceback.

    Parameters
    ----------
    make : callable
        Makes the node once rclpy is initialised.
    args : sequence of str, optional
        Command line with ``--ros-args``; ``sys.argv`` when absent.
    threads : int
        Threads of the executor.

    Raises
    ------
    SystemExit
        With status 1 when `make` refuses, as it does for a parameter that it cannot use; the reason is logged.
    """
    # A crash in a compiled library leaves the stack of every thread in the log, not a bare exit status.
    # Where standard error is not a file, as in a test, there is no place for it.
    with contextlib.suppress(RuntimeError, AttributeError, OSError, ValueError):
        faulthandler.enable()
    interrupts = Interrupts()
    interrupts.install()
    watch_from_outside()
    rclpy.init(args=list(args) if args is not None else None)
    node: Node | None = None
    try:
        node = make()
        interrupts.spinning = True
        _spin(node, threads)
    except (MansionError, ParameterException) as error:
        get_logger("mansion").fatal(str(error))
        sys.exit(1)
    except (KeyboardInterrupt, ExternalShutdownException):
        return
    except Exception:
        # A signal shuts the context down between two calls of rclpy, which then fail in many ways.
        if rclpy.ok():
            raise
    finally:
        interrupts.ignore()
        if node is not None:
            node.destroy_node()
        rclpy.try_shutdown()
        # rclpy has put back the handlers that it found.
        interrupts.ignore()


def _spin(node: Node, threads: int) -> None:
    executor = MultiThreadedExecutor(num_threads=threads)
    executor.add_node(node)
    wake_regularly(node)
    try:
        executor.spin()
    finally:
        executor.shutdown(timeout_sec=CALLBACK_GRACE)
