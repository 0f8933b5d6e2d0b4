"""The notice of slow commands that show no progress: what they are doing, and about how long it takes."""

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import wraps
from typing import Any, Final

from mansion_bringup.cli.console import err

__all__ = ["ANNOUNCED_AFTER", "WORK", "announced_when_slow", "announced"]

ANNOUNCED_AFTER: Final = 2.0
"""Seconds after which a command says what it does."""

# Seconds of one core for the four-storey office of the README, in round figures.
WORK: Final[dict[str, tuple[str, str]]] = {
    "plan": ("reading the sentence and planning the rooms", "about 3 s"),
    "check": ("deriving every promise from the geometry again", "about 3 s for a four-storey office"),
    "view": ("making the page with its 3D model", "about 7 s for a four-storey office"),
    "export": ("writing the files", "3 to 20 s for a four-storey office, by format"),
    "look": ("loading the building into the renderer", "about 9 s for a four-storey office without a GPU"),
    "edit": (
        "carrying out the instruction, checking the building and updating its files",
        "about 10 s for a four-storey office",
    ),
    "skill": ("loading the building and running the skill", "about 2 s for a four-storey office"),
    "task generate": ("sampling tasks and doing each", "about half a second a task"),
    "task run": ("doing the tasks", "about half a second a task"),
    "world check": ("checking every building", "about a second each"),
    "world show": ("drawing a picture of each building", "about a second each"),
    "world pack": ("writing the shards", "about a second for each building"),
    "assets sheet": ("drawing the assets", "some tenths of a second each"),
    "assets check": ("checking the assets", "some tenths of a second each"),
    "assets add": ("reading and measuring the models", "about a second each"),
    "record episode": ("running the skills again and recording them", "about half a second a skill"),
    "record task": ("letting the agent do the task, and recording it", "about a second a skill"),
}
"""By command: what it does, and how long that takes where the machine has nothing else to do."""


@contextmanager
def announced_when_slow(command: str) -> Iterator[None]:
    """Say what a command of `WORK` is doing if the block takes longer than `ANNOUNCED_AFTER`.

    By a signal rather than a thread, so that commands may fork; only in the main thread, where signals come, and where
    nobody else has set the process's alarm.
    """
    work = WORK.get(command)
    taken = threading.current_thread() is not threading.main_thread() or signal.getitimer(signal.ITIMER_REAL)[0] > 0
    if work is None or taken:
        yield
        return
    what, long = work

    def say(number: int, frame: object) -> None:
        # Written as it is: a console imports modules when it prints, and a signal that comes in the midst of another
        # import would break that one (CPython gh-91351).
        with suppress(RuntimeError):  # if it interrupts another line
            if not err.quiet:
                err.file.write(f"{what}: {long}, longer on a busy machine\n")
                err.file.flush()

    before = signal.signal(signal.SIGALRM, say)
    signal.setitimer(signal.ITIMER_REAL, ANNOUNCED_AFTER)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)


def announced(command: str, callback: Callable[..., Any]) -> Callable[..., Any]:
    """Return the callback of a command under `announced_when_slow`."""

    @wraps(callback)
    def run(*arguments: Any, **options: Any) -> Any:
        with announced_when_slow(command):
            return callback(*arguments, **options)

    return run
