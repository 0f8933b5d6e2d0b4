"""Whether a command can write where it is told to, asked before it works for minutes."""

import os
from pathlib import Path

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["check_output_file", "check_output_folder"]


def check_output_folder(folder: Path) -> None:
    """Refuse a folder that is a file, or that cannot be made or written.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` naming the folder that is in the way.
    """
    nearest = folder.absolute()
    while not nearest.exists() and nearest != nearest.parent:
        nearest = nearest.parent
    if not nearest.is_dir():
        raise _refusal(folder, f"{nearest} is a file, no folder")
    if not os.access(nearest, os.W_OK | os.X_OK):
        raise _refusal(folder, f"{nearest} is read-only for you")


def check_output_file(file: Path) -> None:
    """Refuse a file that is a folder, or whose folder cannot be made or written."""
    if file.is_dir():
        raise _refusal(file, "it is a folder; name a file in it")
    check_output_folder(file.parent)


def _refusal(path: Path, why: str) -> MansionError:
    return MansionError(
        ErrorCode.UNAVAILABLE,
        f"cannot write {path}: {why}; name another place with --output",
        path="$.output",
        details={"file": str(path)},
    )
