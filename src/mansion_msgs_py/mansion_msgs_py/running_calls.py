"""The calls that a node is serving, which others can cancel."""

import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Generic, TypeVar

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["RunningCalls"]

T = TypeVar("T")


class RunningCalls(Generic[T]):
    """Running calls, each described by a value; safe to use from several threads.

    Parameters
    ----------
    name : str
        What these calls are, in the plural.
    most : int
        How many may run at the same time.

    Examples
    --------
    >>> plans = RunningCalls[str]("plans")
    >>> with plans.begun("flat") as cancelled:
    ...     plans.cancel(lambda plan: plan == "flat"), cancelled.is_set()
    (['flat'], True)
    >>> plans.cancel(lambda plan: True)
    []
    """

    def __init__(self, name: str, most: int = sys.maxsize) -> None:
        self._name, self._most = name, most
        self._guard = threading.Lock()
        self._running: dict[threading.Event, T] = {}

    @contextmanager
    def begun(self, call: T) -> Iterator[threading.Event]:
        """Count a call as running during the block, which gets an event that is set when somebody cancels it.

        Raises
        ------
        MansionError
            ``CONFLICT`` where that many are running already.
        """
        cancelled = threading.Event()
        with self._guard:
            if len(self._running) >= self._most:
                reason = f"{self._most} {self._name} are running; ask again when one is done"
                raise MansionError(ErrorCode.CONFLICT, reason)
            self._running[cancelled] = call
        try:
            yield cancelled
        finally:
            with self._guard:
                del self._running[cancelled]

    def cancel(self, chosen: Callable[[T], bool]) -> list[T]:
        """Ask the chosen calls to end, and return them in the order in which they began."""
        with self._guard:
            found = {cancelled: call for cancelled, call in self._running.items() if chosen(call)}
        for cancelled in found:
            cancelled.set()
        return list(found.values())

    def any(self, chosen: Callable[[T], bool]) -> bool:
        """Whether a chosen call is running."""
        with self._guard:
            return any(chosen(call) for call in self._running.values())
