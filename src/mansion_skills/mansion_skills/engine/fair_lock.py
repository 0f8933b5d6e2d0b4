"""A lock that is given to waiting threads in the order in which they came."""

import threading
from collections import deque
from types import TracebackType

__all__ = ["FairLock"]


class FairLock:
    """First come, first served; a context manager.

    Attributes
    ----------
    waiting : int
        How many threads wait now.
    """

    def __init__(self) -> None:
        self._guard = threading.Lock()
        self._queue: deque[threading.Event] = deque()
        self._held = False

    @property
    def waiting(self) -> int:
        """How many threads wait now."""
        return len(self._queue)

    @property
    def held(self) -> bool:
        """Whether a thread has it."""
        return self._held

    def acquire(self) -> None:
        """Wait for all who came before, then take the lock."""
        with self._guard:
            if not self._held:
                self._held = True
                return
            turn = threading.Event()
            self._queue.append(turn)
        turn.wait()

    def release(self) -> None:
        """Hand the lock to the next in the queue."""
        with self._guard:
            if self._queue:
                self._queue.popleft().set()
            else:
                self._held = False

    def __enter__(self) -> "FairLock":
        self.acquire()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.release()
