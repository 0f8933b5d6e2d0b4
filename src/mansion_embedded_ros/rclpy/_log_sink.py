"""Levels of loggers, and the console and ``/rosout`` that messages go to.

The environment variables are those of ``rcutils``: ``RCUTILS_CONSOLE_OUTPUT_FORMAT``,
``RCUTILS_COLORIZED_OUTPUT``, ``RCUTILS_LOGGING_USE_STDOUT``.
"""

from __future__ import annotations

import os
import re
import sys
import threading
import time
from collections.abc import Callable
from datetime import datetime
from typing import Any

from rclpy.impl.logging_severity import LoggingSeverity

__all__ = ["add_rosout", "apply_arguments", "emit", "levels", "remove_rosout", "switches"]

_COLORS = {10: "\033[32m", 20: "\033[0m", 30: "\033[33m", 40: "\033[31m", 50: "\033[31m"}
_FORMAT = "[{severity}] [{time}] [{name}]: {message}"
_TOKEN = re.compile(r"\{(\w+)\}")
_rosout: dict[str, Callable[[int, LoggingSeverity, str, str, str, str, int], None]] = {}
_lock = threading.Lock()
_publishing = threading.local()
switches = {"stdout": True, "rosout": True}


class _Levels:
    """The level of each logger; the empty name is the default of all."""

    def __init__(self) -> None:
        self._levels: dict[str, LoggingSeverity] = {}
        self._effective: dict[str, LoggingSeverity] = {}

    def set(self, name: str, level: LoggingSeverity) -> None:
        self._levels[name] = level
        self._effective.clear()

    def own(self, name: str) -> LoggingSeverity:
        return self._levels.get(name, LoggingSeverity.UNSET)

    def effective(self, name: str) -> LoggingSeverity:
        found = self._effective.get(name)
        if found is None:
            found = self._effective[name] = self._search(name)
        return found

    def _search(self, name: str) -> LoggingSeverity:
        while name:
            level = self._levels.get(name, LoggingSeverity.UNSET)
            if level != LoggingSeverity.UNSET:
                return level
            name = name.rpartition(".")[0]
        return self._levels.get("", LoggingSeverity.INFO) or LoggingSeverity.INFO

    def clear(self) -> None:
        self._levels.clear()
        self._effective.clear()


levels = _Levels()


def apply_arguments(arguments: Any) -> None:
    """Take over ``--log-level`` and the switches of a command line."""
    from rclpy._rclpy_pybind11 import RCLInvalidROSArgsError

    for name, text in arguments.log_levels:
        try:
            level = LoggingSeverity[text.upper()]
        except KeyError:
            raise RCLInvalidROSArgsError(
                f"Couldn't parse log level rule: '--log-level {text}'. Levels are "
                "DEBUG, INFO, WARN, ERROR and FATAL"
            ) from None
        levels.set(name, level)
    for key in ("stdout", "rosout"):
        switches[key] = arguments.switches.get(key, switches[key])


def add_rosout(
    name: str, publish: Callable[[int, LoggingSeverity, str, str, str, str, int], None]
) -> None:
    """Have the messages of a node's logger and its children published."""
    with _lock:
        _rosout.setdefault(name, publish)


def remove_rosout(
    name: str, publish: Callable[[int, LoggingSeverity, str, str, str, str, int], None]
) -> None:
    """Stop publishing the messages of a node's logger."""
    with _lock:
        if _rosout.get(name) == publish:
            del _rosout[name]


def _render(
    stamp: int,
    severity: LoggingSeverity,
    name: str,
    message: str,
    file: str,
    function: str,
    line: int,
) -> str:
    def value(match: re.Match[str]) -> str:
        key = match[1]
        seconds, nanoseconds = divmod(stamp, 1_000_000_000)
        known = {
            "severity": severity.name,
            "time": f"{seconds}.{nanoseconds:09d}",
            "time_as_nanoseconds": str(stamp),
            "name": name,
            "message": message,
            "file_name": file,
            "function_name": function,
            "line_number": str(line),
        }
        if key == "date_time_with_ms":
            moment = datetime.fromtimestamp(seconds)
            return f"{moment:%Y-%m-%d %H:%M:%S}.{nanoseconds // 1_000_000:03d}"
        return known.get(key, match[0])

    return _TOKEN.sub(value, os.environ.get("RCUTILS_CONSOLE_OUTPUT_FORMAT") or _FORMAT)


def _print(text: str, severity: LoggingSeverity) -> None:
    use_stdout = os.environ.get("RCUTILS_LOGGING_USE_STDOUT") == "1"
    stream = sys.stdout if use_stdout else sys.stderr
    if stream is None:
        return
    wanted = os.environ.get("RCUTILS_COLORIZED_OUTPUT", "")
    try:
        if wanted == "1" or (wanted != "0" and stream.isatty()):
            text = f"{_COLORS[int(severity)]}{text}\033[0m"
        stream.write(text + "\n")
        stream.flush()
    except (OSError, ValueError):
        return


def emit(
    name: str, severity: LoggingSeverity, message: str, file: str, function: str, line: int
) -> None:
    """Write one message to the console and to the ``/rosout`` of the node it belongs to."""
    stamp = time.time_ns()
    if switches["stdout"]:
        _print(_render(stamp, severity, name, message, file, function, line), severity)
    if not switches["rosout"] or getattr(_publishing, "active", False):
        return
    owner = name
    while owner and owner not in _rosout:
        owner = owner.rpartition(".")[0]
    publish = _rosout.get(owner)
    if publish is None:
        return
    # A message logged while publishing one is not published itself.
    _publishing.active = True
    try:
        publish(stamp, severity, name, message, file, function, line)
    except RuntimeError:
        return
    finally:
        _publishing.active = False
