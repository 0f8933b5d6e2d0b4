"""A folder that appears whole or not at all."""

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["atomic_folder"]


@contextmanager
def atomic_folder(output: Path) -> Iterator[Path]:
    """Give a folder beside `output` to write into; it takes its name at the end, and is removed after an error.

    Raises
    ------
    MansionError
        ``CONFLICT`` when `output` is a file or a folder that holds something.
    """
    if output.exists() and (not output.is_dir() or any(output.iterdir())):
        raise MansionError(ErrorCode.CONFLICT, f"{output} holds files; name a new or empty folder")
    partial = output.absolute().with_name(f".{output.absolute().name}.partial")
    shutil.rmtree(partial, ignore_errors=True)
    partial.mkdir(parents=True)
    try:
        yield partial
        if output.exists():
            output.rmdir()
        partial.rename(output)
    finally:
        shutil.rmtree(partial, ignore_errors=True)
