"""Files in the user's cache that save making something again: found by a hash of all that determines them."""

import os
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import TypeVar

import msgspec

from mansion_msgs_py.files import write_atomic

__all__ = ["cache_folder", "kept"]

T = TypeVar("T")


def cache_folder(name: str, variable: str) -> Path:
    """Return the folder that an environment variable names, else ``mansion/NAME`` of the user's cache."""
    home = Path(os.environ.get("XDG_CACHE_HOME") or "~/.cache") / "mansion" / name
    return Path(os.environ.get(variable) or home).expanduser()


def kept(file: Path, kind: type[T], make: Callable[[], T]) -> T:
    """Return what a file holds, or make it and keep it there where it can be written.

    Parameters
    ----------
    file : Path
        MessagePack of `kind`. One that is broken, or cannot be read, is made again.
    kind : type
        Type of the value.
    make : callable
    """
    try:
        return msgspec.msgpack.decode(file.read_bytes(), type=kind)
    except (OSError, msgspec.MsgspecError):
        made = make()
    with suppress(OSError):  # a cache that cannot be written costs time only
        write_atomic(file, msgspec.msgpack.encode(made))
    return made
