"""Files of tasks."""

from pathlib import Path
from typing import Any

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import decode_from, read_bytes
from mansion_msgs_py.task import TaskSet

__all__ = ["read_task_set"]


def read_task_set(file: Path) -> TaskSet:
    """Read a task set.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a file that cannot be read, ``INVALID_PAYLOAD`` for one that is no task set; both name it.
    """
    if file.is_dir():
        raise MansionError(ErrorCode.NOT_FOUND, f"{file} is a folder; name a file of `mansion task generate`")
    data = read_bytes(file, "a file of `mansion task generate`")
    head = decode_from(dict[str, Any], data, file)
    if "instruction" in head and "tasks" not in head:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"{file} is a task in words; `mansion task ground {file} BUILDING -o FILE` makes a task set of it",
        )
    return decode_from(TaskSet, data, file)
