"""What no input may make a process do: fail with an error of its own, run on, take much memory, or write elsewhere."""

import os
import resource
import signal
import sys
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import FrameType
from typing import Any, Final, Literal

from mansion_msgs_py.errors import SYSTEM_REFUSALS, ErrorCode, MansionError

__all__ = ["MOST_MEMORY", "MOST_SECONDS", "Outcome", "WriteGuard", "outcome_of"]

MOST_SECONDS: Final = 10.0
"""Of processor time."""

MOST_MEMORY: Final = 1_000_000_000
"""Bytes in memory at the worst moment; half as much above what a process had before, where that is more."""

Verdict = Literal["answered", "refused", "fault", "hang", "memory", "outside"]


@dataclass(frozen=True)
class Outcome:
    """What an input did.

    Attributes
    ----------
    what : str
        Of a fault: its kind and where it arose, the same for all inputs that meet it.
    detail : str
        Its whole text.
    """

    verdict: Verdict
    what: str = ""
    detail: str = ""
    seconds: float = 0.0

    @property
    def sound(self) -> bool:
        """Whether the input was answered or refused."""
        return self.verdict in ("answered", "refused")


class WriteGuard:
    """Records and prevents writing outside of a folder, whichever library does it (PEP 578); one for each process.

    Parameters
    ----------
    root : Path
    """

    def __init__(self, root: Path) -> None:
        self._root = root.resolve()
        self._watching = False
        self.outside: list[str] = []
        sys.addaudithook(self._hear)

    @contextmanager
    def watching(self) -> Iterator[None]:
        """Watch within the block."""
        self._watching = True
        self.outside.clear()
        try:
            yield
        finally:
            self._watching = False

    def _hear(self, event: str, arguments: tuple[Any, ...]) -> None:
        if not self._watching:
            return
        for path in _written(event, arguments):
            if not self._may_be_written(path):
                self._watching = False
                self.outside.append(f"{event} {path}")
                raise PermissionError(f"{event} outside of {self._root}: {path}")

    def _may_be_written(self, path: str) -> bool:
        if path.startswith(("/dev/", "/proc/self/")) or "/__pycache__" in path:
            return True
        try:
            return Path(os.path.realpath(path)).is_relative_to(self._root)
        except ValueError:
            return True  # a NUL in it: the system refuses it


_WRITING: Final = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC
_CHANGING: Final = frozenset(("os.mkdir", "os.remove", "os.rmdir", "os.truncate", "os.chmod", "os.chown", "os.utime"))
_LINKING: Final = frozenset(("os.rename", "os.link", "os.symlink"))


def _written(event: str, arguments: tuple[Any, ...]) -> Iterator[str]:
    if event == "open":
        path, mode, flags = arguments[:3]
        if (flags or 0) & _WRITING or (isinstance(mode, str) and set(mode) & set("wax+")):
            yield from _names(path)
    elif event in _CHANGING:
        yield from _names(arguments[0])
    elif event in _LINKING:
        yield from _names(arguments[1])


def _names(path: Any) -> Iterator[str]:
    if isinstance(path, str | bytes | os.PathLike):
        yield os.fsdecode(path)


class _Hang(BaseException):
    """An input took too long."""


def outcome_of(call: Callable[[], Any], guard: WriteGuard, seconds: float = MOST_SECONDS) -> Outcome:
    """Call something and return what became of it.

    Parameters
    ----------
    call : callable
    guard : WriteGuard
    seconds : float
        Processor time after which it is ended, where Python runs and not a call of C.
    """

    def end(number: int, frame: FrameType | None) -> None:
        raise _Hang

    former = signal.signal(signal.SIGPROF, end)
    peak, started = max(_peak(), MOST_MEMORY, _status("VmRSS") + MOST_MEMORY // 2), _processor_time()
    try:
        signal.setitimer(signal.ITIMER_PROF, seconds)
        try:
            with guard.watching():
                verdict, what, detail = _judged(call)
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0.0)
    except _Hang as hang:
        verdict, what, detail = "hang", _place(hang), traceback.format_exc()
    finally:
        signal.signal(signal.SIGPROF, former)
    if guard.outside:
        verdict, what = "outside", guard.outside[0]
    elif (most := _peak()) > peak:
        verdict, what = "memory", f"{most / 1e9:.1f} GB"
    return Outcome(verdict, what, detail, _processor_time() - started)


def _judged(call: Callable[[], Any]) -> tuple[Verdict, str, str]:
    try:
        call()
    except MansionError as error:
        if error.code != ErrorCode.INTERNAL:
            return "refused", error.code, ""
        return "fault", f"INTERNAL: {error.info.message[:120]}", str(error.info.details.get("traceback", ""))
    except OSError as error:
        if error.errno in SYSTEM_REFUSALS:
            return "refused", "OSError", ""
        return "fault", f"{type(error).__name__} in {_place(error)}", traceback.format_exc()
    except Exception as error:
        if _was_ended(error):
            raise _Hang from error
        return "fault", f"{type(error).__name__} in {_place(error)}", traceback.format_exc()
    return "answered", "", ""


def _was_ended(error: BaseException | None) -> bool:
    """Whether an error came of ending a call that took too long: compiled code makes another error of it."""
    while error is not None and not isinstance(error, _Hang):
        error = error.__cause__ or error.__context__
    return error is not None


def _place(error: BaseException) -> str:
    """Return the innermost function of Mansion's that an error passed."""
    frames = [frame for frame in traceback.extract_tb(error.__traceback__) if "/mansion" in frame.filename]
    inner = [frame for frame in frames if "/src/" in frame.filename] or frames
    return f"{Path(inner[-1].filename).name}:{inner[-1].name}" if inner else "?"


def _processor_time() -> float:
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


_STATUS: Final = Path("/proc/self/status")


def _peak() -> int:
    """Return the most bytes of this process that were in memory ever."""
    return _status("VmHWM")


def _status(name: str) -> int:
    """Return a figure of this process's memory, bytes (``/proc/self/status``); 0 where the system tells none."""
    for line in _STATUS.read_text().splitlines() if _STATUS.exists() else ():
        if line.startswith(name):
            return int(line.split()[1]) * 1024
    return 0
