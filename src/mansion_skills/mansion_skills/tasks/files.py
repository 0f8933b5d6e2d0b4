"""Files of tasks."""

from pathlib import Path
from typing import Any

from mansion_msgs_py.codec import decode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.task import TaskSet

__all__ = ["read_task_set"]


def read_task_set(file: Path) -> TaskSet:
    """Read a task set.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a file that cannot be read, ``INVALID_PAYLOAD`` for one that is no task set; both name it.
    """
    try:
        data = file.read_bytes()
    except IsADirectoryError:
        raise MansionError(
            ErrorCode.NOT_FOUND, f"{file} is a folder; name a file of `mansion task generate`"
        ) from None
    except OSError as error:
        raise MansionError(ErrorCode.NOT_FOUND, f"{file}: {error.strerror}") from None
    head = decode(dict[str, Any], data)
    if "instruction" in head and "tasks" not in head:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"{file} is a task in words; `mansion task ground {file} BUILDING -o FILE` makes a task set of it",
        )
    return decode(TaskSet, data)
