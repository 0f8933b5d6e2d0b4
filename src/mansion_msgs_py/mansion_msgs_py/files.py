"""Payloads from files, with errors that name the file, and files that are written whole or not at all."""

import fcntl
import os
import re
import secrets
from contextlib import suppress
from pathlib import Path
from typing import TypeVar

from mansion_msgs_py.codec import decode
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["decode_from", "read_bytes", "read_payload", "remove_remains", "write_atomic"]

T = TypeVar("T")


def read_bytes(file: Path, expected: str = "") -> bytes:
    """Return what a file holds.

    Parameters
    ----------
    file : Path
    expected : str
        What would be accepted, for the message.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for what cannot be read.
    """
    try:
        return file.read_bytes()
    except OSError as error:
        wish = f"; expected {expected}" if expected else ""
        raise MansionError(
            ErrorCode.NOT_FOUND, f"{file}: {error.strerror or error}{wish}", details={"file": str(file)}
        ) from None


def decode_from(kind: type[T], data: str | bytes, source: object) -> T:
    """Decode JSON that came from `source`, which the error names before the fault (see `decode`)."""
    try:
        return decode(kind, data)
    except MansionError as error:
        raise error.with_message(f"{source}: {error.info.message}") from None


def read_payload(kind: type[T], file: Path, expected: str = "") -> T:
    """Return the payload that a file holds.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a file that cannot be read, ``INVALID_PAYLOAD`` for one that holds something else; both name
        it.
    """
    return decode_from(kind, read_bytes(file, expected), file)


def write_atomic(path: Path, data: bytes, *, durable: bool = False, mode: int | None = None) -> None:
    """Write a file through a temporary one beside it, so that readers never see half of it.

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
    fresh, handle = _begin(path, 0o666 if mode is None else mode)
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
            stream.flush()  # a disk that is full says so here, before the file takes its name
            if durable:
                os.fsync(stream.fileno())
            if mode is not None:
                fresh.chmod(mode)
            fresh.replace(path)
    except BaseException as error:
        fresh.unlink(missing_ok=True)
        if isinstance(error, OSError) and error.errno is not None and error.filename is None:
            error.filename = str(path)
        raise


def _begin(path: Path, mode: int) -> tuple[Path, int]:
    """Open a temporary file beside `path` whose lock says that somebody writes it (see `remove_remains`)."""
    while True:
        fresh = path.with_name(f".{path.name}.{secrets.token_hex(8)}")
        handle = os.open(fresh, os.O_WRONLY | os.O_CREAT | os.O_EXCL, mode)
        with suppress(OSError):  # a file system without locks: its remains are kept
            fcntl.flock(handle, fcntl.LOCK_EX)
        if os.fstat(handle).st_nlink:
            return fresh, handle
        os.close(handle)


_REMAINS = re.compile(r"\..+\.[0-9a-f]{16}")
"""Names of the temporary files of `write_atomic`."""


def remove_remains(folder: Path) -> None:
    """Remove what killed processes left of files that they were writing into a folder; what is being written stays."""
    try:
        found = [entry for entry in sorted(folder.iterdir()) if _REMAINS.fullmatch(entry.name)]
    except OSError:
        return
    for path in found:
        with suppress(OSError):  # locked by its writer, gone already, or not ours to remove
            _remove_unless_locked(path)


def _remove_unless_locked(path: Path) -> None:
    handle = os.open(path, os.O_WRONLY | os.O_NOFOLLOW)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        path.unlink()
    finally:
        os.close(handle)
