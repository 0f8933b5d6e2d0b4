"""How fast the world's clock runs: as fast as skills need, or with the wall's."""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

__all__ = ["Pace"]


@dataclass(frozen=True)
class Pace:
    """The pace of motion.

    Attributes
    ----------
    realtime : bool
        Whether skills take the time that they need; else they complete at once and only the world's clock goes on.
    factor : float
        Seconds of the world for one second on the wall.
    clock : callable
        The wall's clock, seconds.
    """

    realtime: bool = False
    factor: float = 1.0
    clock: Callable[[], float] = time.monotonic

    def now(self) -> float:
        """Return the time by which worlds go, seconds."""
        return self.clock() * self.factor

    def wait(self, seconds: float, stop: threading.Event) -> None:
        """Wait for seconds of the world, or until `stop` is set."""
        stop.wait(seconds / self.factor)
