"""The error that every service, command and client reports."""

import errno
from typing import Any, Final

import msgspec

from mansion_msgs_py.wording import shortened

__all__ = [
    "MOST_CHARACTERS",
    "MOST_IN_DETAILS",
    "SYSTEM_REFUSALS",
    "ErrorCode",
    "ErrorInfo",
    "ErrorReply",
    "MansionError",
    "refused_by_system",
]


MOST_CHARACTERS: Final = 2_000
"""Longest message: input that it quotes may have any length. A hint stands at its end, so the middle is left out."""

MOST_IN_DETAILS: Final = 8_000
"""Characters of a text among the details, and entries of a list."""


SYSTEM_REFUSALS: Final = frozenset(
    (
        errno.ENOSPC, errno.EDQUOT, errno.EROFS, errno.EACCES, errno.EPERM, errno.EFBIG, errno.EIO, errno.EMFILE,
        errno.ENFILE, errno.ENAMETOOLONG, errno.ENOTDIR, errno.EISDIR,
    )
)  # fmt: skip
"""Errors about the machine or a path, which are not faults of Mansion."""


class ErrorCode:
    """Codes of errors that are not skill statuses."""

    INVALID_PAYLOAD: Final = "INVALID_PAYLOAD"
    """The JSON does not fit the payload type; `path` is the fault's JSON path."""
    INFEASIBLE: Final = "INFEASIBLE"
    """The request is understood and cannot be met."""
    CONTRADICTION: Final = "CONTRADICTION"
    """Two statements of the request exclude each other; `details` names both."""
    NOT_FOUND: Final = "NOT_FOUND"
    """A named object (file, floor, room, service) does not exist."""
    NOT_LOADED: Final = "NOT_LOADED"
    """No building is loaded."""
    CONFLICT: Final = "CONFLICT"
    """Another job or session holds what this one needs."""
    FORBIDDEN: Final = "FORBIDDEN"
    """A service was asked to write where it may not."""
    UNAVAILABLE: Final = "UNAVAILABLE"
    """A node that the job needs does not answer."""
    TIMEOUT: Final = "TIMEOUT"
    """Aborted by a wall-clock limit; there is no result."""
    CANCELED: Final = "CANCELED"
    """Ended at the caller's wish."""
    INTERNAL: Final = "INTERNAL"
    """A fault of Mansion itself; the log has the traceback."""


class ErrorInfo(msgspec.Struct, frozen=True, kw_only=True):
    """What was wrong, where, and what would be accepted."""

    code: str
    message: str
    path: str = "$"
    details: dict[str, Any] = {}


class ErrorReply(msgspec.Struct, frozen=True, kw_only=True):
    """The body of a failed reply: ``{"error": {...}}``."""

    error: ErrorInfo


class MansionError(Exception):
    """An expected failure, with all that its reader needs.

    Parameters
    ----------
    code : str
        One of `ErrorCode`, or a skill status.
    message : str
        What was wrong and what would be accepted.
    path : str
        JSON path of the place in the input.
    details : dict, optional
        JSON-compatible facts for programs; ``stage`` names the stage that failed.

    Examples
    --------
    >>> str(MansionError("NOT_FOUND", "there is no floor 9; floors are 1 to 4", path="$.target_floor"))
    'NOT_FOUND at $.target_floor: there is no floor 9; floors are 1 to 4'
    """

    def __init__(self, code: str, message: str, *, path: str = "$", details: dict[str, Any] | None = None) -> None:
        message = shortened(message, MOST_CHARACTERS)
        super().__init__(message)
        self.info = ErrorInfo(
            code=code, message=message, path=shortened(path, MOST_CHARACTERS), details=_short(details or {})
        )

    @classmethod
    def from_info(cls, info: ErrorInfo) -> "MansionError":
        """Make the exception that `info` describes."""
        return cls(info.code, info.message, path=info.path, details=info.details)

    def with_message(self, message: str) -> "MansionError":
        """Return the same error with another message."""
        return MansionError.from_info(msgspec.structs.replace(self.info, message=message))

    def with_details(self, **details: Any) -> "MansionError":
        """Return the same error with further, or other, details."""
        return MansionError.from_info(msgspec.structs.replace(self.info, details={**self.info.details, **details}))

    @property
    def code(self) -> str:
        """The error's code."""
        return self.info.code

    @property
    def stage(self) -> str:
        """The stage that failed, or an empty string."""
        return str(self.info.details.get("stage", ""))

    def at_stage(self, stage: str) -> "MansionError":
        """Name the stage that failed, unless a deeper one is named already; return self."""
        self.info.details.setdefault("stage", stage)
        return self

    def reply(self) -> ErrorReply:
        """Return the body of the failed reply."""
        return ErrorReply(error=self.info)

    def __str__(self) -> str:
        place = f" at {self.info.path}" if self.info.path not in ("", "$") else ""
        stage = f" [{self.stage}]" if self.stage else ""
        return f"{self.info.code}{stage}{place}: {self.info.message}"

    def __reduce__(self) -> tuple[Any, ...]:
        return (MansionError.from_info, (self.info,))


def _short(value: Any) -> Any:
    """Return details with long texts and lists shortened."""
    if isinstance(value, str):
        return shortened(value, MOST_IN_DETAILS)
    if isinstance(value, dict):
        return {_short(key): _short(entry) for key, entry in list(value.items())[:MOST_IN_DETAILS]}
    if isinstance(value, list | tuple):
        return [_short(entry) for entry in value[:MOST_IN_DETAILS]]
    return value


def refused_by_system(error: OSError, outcome: str = "") -> MansionError:
    """Return what the system refused, such as to write to a full disk, as ``UNAVAILABLE`` in one line.

    Parameters
    ----------
    error : OSError
    outcome : str
        What became of the work, for the end of the message.

    Examples
    --------
    >>> str(refused_by_system(OSError(28, "No space left on device", "out/report.json"), "nothing was changed"))
    'UNAVAILABLE: out/report.json: No space left on device; nothing was changed'
    """
    parts = [str(part) for part in (error.filename, error.strerror or error) if part is not None]
    message = ": ".join(parts)
    return MansionError(ErrorCode.UNAVAILABLE, f"{message}; {outcome}" if outcome else message)
