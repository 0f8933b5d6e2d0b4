"""Where libraries are: plain folders that `load_catalogue` reads, by name or by path."""

import os
import re
from collections.abc import Iterable
from pathlib import Path
from typing import Final

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["LIBRARIES", "known_libraries", "libraries_root", "library_folder", "library_folders", "stated_libraries"]

LIBRARIES: Final = "MANSION_LIBRARIES"
"""Environment variable with the folder of all libraries that are called by name."""

_NAME: Final = re.compile(r"[A-Za-z0-9][A-Za-z0-9_\-]{0,63}")


def libraries_root() -> Path:
    """Return the folder of the libraries that have names: ``MANSION_LIBRARIES``, or in the user's data folder."""
    named = os.environ.get(LIBRARIES)
    if named:
        return Path(named)
    data = os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share"
    return Path(data) / "mansion" / "libraries"


def library_folder(name: str) -> Path:
    """Return the folder of a library, there or not: a name, or a path, which has a slash in it.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for what is neither.

    Examples
    --------
    >>> library_folder("./shop").name
    'shop'
    """
    if "/" in name:
        return Path(name).expanduser()
    if not _NAME.fullmatch(name):
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"{name[:80]!r} is not a library name; use letters, digits, - and _, or a path with a slash in it",
            path="$.library",
        )
    return libraries_root() / name


def known_libraries() -> list[str]:
    """Return the names of the user's libraries."""
    root = libraries_root()
    if not root.is_dir():
        return []
    return sorted(entry.name for entry in root.iterdir() if (entry / "assets").is_dir() and _NAME.fullmatch(entry.name))


def stated_libraries(names: Iterable[str]) -> list[str]:
    """Return libraries, all there, as a request states them: by name, or by a path from the root.

    Raises
    ------
    MansionError
        As `library_folders`.
    """
    listed = list(names)
    return [str(folder) if "/" in name else name for name, folder in zip(listed, library_folders(listed), strict=True)]


def library_folders(names: Iterable[str]) -> tuple[Path, ...]:
    """Return the folders of libraries, all there.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for one that is not there, with those that are.
    """
    found = []
    for name in names:
        folder = library_folder(name)
        if not folder.is_dir():
            there = ", ".join(known_libraries()) or "none yet; `mansion assets add` makes one"
            raise MansionError(
                ErrorCode.NOT_FOUND,
                f"there is no library {name[:200]!r} at {folder}; libraries: {there}",
                path="$.assets",
                details={"library": name[:200]},
            )
        found.append(folder.resolve())
    return tuple(found)
