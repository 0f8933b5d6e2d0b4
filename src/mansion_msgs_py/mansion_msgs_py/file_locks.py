"""Locks between processes: a file that one process holds, released when the process ends, however it ends."""

import fcntl
import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["hold_lock"]

LOOK: Final = 0.02
"""Seconds between two tries."""

_held: set[int] = set()
"""Descriptors of the locks of this process; a forked child closes them, or it would hold the locks too."""


def _leave_locks_to_parent() -> None:
    for descriptor in _held:
        os.close(descriptor)
    _held.clear()


os.register_at_fork(after_in_child=_leave_locks_to_parent)


@contextmanager
def hold_lock(path: Path, refusal: str, *, patience: float = 0.0, remove: bool = False) -> Iterator[None]:
    """Hold a lock file within the block.

    Parameters
    ----------
    path : Path
        Made where it is missing, with its folder.
    refusal : str
        What the error says where another holds it.
    patience : float
        Seconds to wait for the holder.
    remove : bool
        Remove the file at the end.

    Raises
    ------
    MansionError
        ``CONFLICT`` when another keeps the lock for longer than `patience`.
    OSError
        When the file cannot be made.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    deadline = time.monotonic() + patience
    while (descriptor := _try_lock(path)) is None:
        if time.monotonic() >= deadline:
            raise MansionError(ErrorCode.CONFLICT, refusal)
        time.sleep(LOOK)
    try:
        yield
    finally:
        if descriptor in _held:
            if remove and _is_at(descriptor, path):
                path.unlink(missing_ok=True)
            _held.discard(descriptor)
            os.close(descriptor)


def _try_lock(path: Path) -> int | None:
    """Return the descriptor of the locked file; ``None`` while another holds it, or has just removed it."""
    descriptor = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o666)
    _held.add(descriptor)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        if _is_at(descriptor, path):
            return descriptor
    except BlockingIOError:
        pass
    _held.discard(descriptor)
    os.close(descriptor)
    return None


def _is_at(descriptor: int, path: Path) -> bool:
    """Whether an open file is still the one of that name."""
    try:
        return os.path.samestat(os.fstat(descriptor), path.stat())
    except FileNotFoundError:
        return False
