"""Lines appended whole, and the lock that editors of one building share."""

import fcntl
import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["append_line", "locked"]

PATIENCE = 30.0
"""Seconds to wait for another editor; one holds the lock for a single transaction."""


def append_line(path: Path, line: bytes) -> None:
    """Append one line, after dropping what an interrupted writer left of a former one."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("ab+") as stream:
        end = stream.seek(0, os.SEEK_END)
        stream.seek(0)
        whole = stream.read().rfind(b"\n") + 1 if end else 0
        stream.truncate(whole)
        stream.seek(0, os.SEEK_END)
        stream.write(line + b"\n")
        stream.flush()
        os.fsync(stream.fileno())


@contextmanager
def locked(path: Path, patience: float = PATIENCE) -> Iterator[None]:
    """Hold the lock file, waiting for its holder.

    Raises
    ------
    MansionError
        ``CONFLICT`` when another process keeps it for longer than `patience` seconds.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("a") as stream:
        deadline = time.monotonic() + patience
        while True:
            try:
                fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except OSError:
                if time.monotonic() >= deadline:
                    raise MansionError(ErrorCode.CONFLICT, f"another editor holds {path}; try again") from None
                time.sleep(0.02)
        try:
            yield
        finally:
            fcntl.flock(stream, fcntl.LOCK_UN)
