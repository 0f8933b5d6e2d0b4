"""Units of a bench in processes: each episode is reported when it ends, and all processes end with the bench."""

import os
import queue
import signal
from collections.abc import Callable, Generator, Iterator, Sequence
from concurrent.futures import Future
from functools import partial
from multiprocessing import active_children, get_context
from typing import Any, Final, TypeVar

from mansion_msgs_py.workers import worker_pool

__all__ = ["in_processes"]

U = TypeVar("U")
R = TypeVar("R")

POLL_INTERVAL: Final = 0.2
"""Seconds between looks at whether a process has failed."""

_reports: Any = None
"""In a worker: where its episodes go."""

_terminating = False


def in_processes(work: Callable[[U], Iterator[R]], units: Sequence[U], jobs: int) -> Generator[tuple[int, R]]:
    """Run units in `jobs` processes and yield (number of the unit, result), each as it comes.

    Parameters
    ----------
    work : callable
        A function of a module: from a unit to its results, in their order.
    units : sequence

    Raises
    ------
    Exception
        What the first unit that fails raises. Then, and when the caller stops listening, the processes are told to
        end and clean up what they had open.
    """
    context = get_context("spawn")
    reports: Any = context.Queue()
    pool = worker_pool(jobs, "spawn", partial(_initialise_worker, reports), ending=signal.SIGTERM)
    finished = False
    try:
        futures = [pool.submit(_run, work, number, unit) for number, unit in enumerate(units)]
        yield from _collect(reports, futures)
        finished = True
    finally:
        if not finished:
            for child in active_children():
                child.terminate()
        pool.shutdown(wait=True, cancel_futures=not finished)
        reports.close()


def _collect(reports: Any, futures: Sequence["Future[None]"]) -> Iterator[tuple[int, Any]]:
    """Yield what workers report until every unit said that it is done."""
    left = len(futures)
    while left:
        try:
            number, row = reports.get(timeout=POLL_INTERVAL)
        except queue.Empty:
            for future in futures:
                if future.done():
                    future.result()
            continue
        if row is None:
            left -= 1
        else:
            yield number, row


def _initialise_worker(reports: Any) -> None:
    """Make a worker of this process, which its parent ends by SIGTERM."""
    global _reports
    _reports = reports
    signal.signal(signal.SIGTERM, _terminate)


def _terminate(number: int, frame: object) -> None:
    global _terminating
    if _terminating:
        os._exit(128 + number)
    _terminating = True
    raise SystemExit(128 + number)


def _run(work: Callable[[U], Iterator[R]], number: int, unit: U) -> None:
    if _terminating:
        return
    for row in work(unit):
        _reports.put((number, row))
    _reports.put((number, None))
