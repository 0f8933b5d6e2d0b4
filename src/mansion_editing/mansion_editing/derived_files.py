"""The process that writes what is made from scenes after edits, so that no call has to share a processor with it."""

import os
import threading
import time
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, ProcessPoolExecutor
from importlib import import_module
from pathlib import Path
from typing import Final

from mansion_editing.storage import BuildingStore
from mansion_msgs_py.allowed_folders import AllowedFolders
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.workers import worker_pool

__all__ = ["DerivedFiles"]

IDLE: Final = 60.0
"""Seconds without an edit after which the process ends: drawing a building leaves it with some hundred megabytes."""

NICENESS: Final = 5
"""By how much its priority is lower than that of the process that answers calls."""


REST: Final = 3.0
"""How much longer the process rests than it has worked: while edits follow each other, it takes a quarter of a core."""


class DerivedFiles:
    """Brings plans, pictures and models of edited buildings up to date, one building after the other.

    Parameters
    ----------
    hooks : str
        Module whose `kept_files` makes the files.
    allowed : AllowedFolders
        Where may be written.
    written : callable
        Told the folder and the floors whose files were written.
    failed : callable
        Told the folder and what went wrong; the next edit of the building tries again.
    clock : callable
        Seconds, by which the process rests after work; edits that come meanwhile are brought up to date together.
    """

    def __init__(
        self,
        hooks: str,
        allowed: AllowedFolders,
        written: Callable[[Path, list[int]], None],
        failed: Callable[[Path, Exception], None],
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._hooks, self._allowed, self._written, self._failed = hooks, allowed, written, failed
        self._behind: dict[Path, None] = {}
        self._wake = threading.Event()
        self._clock = clock
        self._closed = threading.Event()
        self._pool: ProcessPoolExecutor | None = None
        threading.Thread(target=self._work, name="derive", daemon=True).start()

    def update(self, folder: Path) -> None:
        """Have the files of a building written soon."""
        self._behind[folder.resolve()] = None
        self._wake.set()

    def close(self) -> None:
        """End the process; files that it has not written are behind until the building is opened again."""
        self._closed.set()
        self._wake.set()
        self._end_process()

    def _work(self) -> None:
        while not self._closed.is_set():
            if not self._wake.wait(IDLE):
                self._end_process()
                self._wake.wait()
            self._wake.clear()
            begin = self._clock()
            for folder in list(self._behind):
                del self._behind[folder]
                self._update(folder)
            self._rest(REST * (self._clock() - begin))

    def _rest(self, seconds: float) -> None:
        self._closed.wait(seconds)

    def _update(self, folder: Path) -> None:
        try:
            if self._pool is None:
                self._pool = worker_pool(1, "forkserver", _stand_back)
            floors = self._pool.submit(_refresh, folder, self._hooks, self._allowed).result()
        except (MansionError, OSError, RuntimeError) as error:
            if isinstance(error, BrokenExecutor):
                self._end_process()
            if not self._closed.is_set():
                self._failed(folder, error)
        else:
            if floors:
                self._written(folder, floors)

    def _end_process(self) -> None:
        pool, self._pool = self._pool, None
        if pool is not None:
            pool.shutdown(wait=False, cancel_futures=True)


def _stand_back() -> None:
    os.nice(NICENESS)


def _refresh(folder: Path, hooks: str, allowed: AllowedFolders) -> list[int]:
    with importing:
        kept_files = import_module(hooks).kept_files
    return BuildingStore(folder, allowed=allowed).refresh(kept_files)
