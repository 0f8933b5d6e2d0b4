"""Files that are whole or not there."""

import os
import secrets
from pathlib import Path

__all__ = ["write_atomic"]


def write_atomic(path: Path, data: bytes, *, durable: bool = False, mode: int | None = None) -> None:
    """Write a file through a temporary one beside it, so that a reader sees all or nothing.

    Parameters
    ----------
    path : Path
        Its folder is made where it is missing. The temporary file is called ``.NAME.`` and a random ending.
    data : bytes
    durable : bool
        Sync to the disk before the file takes its name, so that it also outlives a loss of power.
    mode : int, optional
        Permission bits; by default those of the file replaced, and of a new file what the process grants to any.

    Raises
    ------
    OSError
        When the folder cannot be written; `path` is then as it was.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    if mode is None and path.exists():
        mode = path.stat().st_mode & 0o777
    fresh = path.with_name(f".{path.name}.{secrets.token_hex(8)}")
    handle = os.open(fresh, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666 if mode is None else mode)
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
            if durable:
                stream.flush()
                os.fsync(stream.fileno())
        if mode is not None:
            fresh.chmod(mode)
        fresh.replace(path)
    except BaseException:
        fresh.unlink(missing_ok=True)
        raise
