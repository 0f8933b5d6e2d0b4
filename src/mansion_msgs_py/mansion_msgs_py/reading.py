"""Payloads from files, with errors that name the file."""

from pathlib import Path
from typing import TypeVar

from mansion_msgs_py.codec import decode
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["decode_from", "read_bytes", "read_payload"]

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
