"""Loggers by name, their levels, and where the log goes."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import rclpy.impl.rcutils_logger
from rclpy._log_sink import levels
from rclpy.impl.logging_severity import LoggingSeverity

__all__ = [
    "LoggingSeverity",
    "clear_config",
    "get_logger",
    "get_logger_effective_level",
    "get_logger_level",
    "get_logging_directory",
    "get_logging_severity_from_string",
    "initialize",
    "set_logger_level",
    "shutdown",
]

_root_logger = rclpy.impl.rcutils_logger.RcutilsLogger()


def get_logger(name: str) -> rclpy.impl.rcutils_logger.RcutilsLogger:
    """The logger of a name; dots make children."""
    if not name:
        raise ValueError("Logger name must not be empty.")
    return _root_logger.get_child(name)


def initialize() -> None:
    """Begin logging: there is nothing to do."""


def shutdown() -> None:
    """End logging: there is nothing to do."""


def clear_config() -> None:
    """Forget the levels that were set."""
    levels.clear()


def set_logger_level(name: str, level: int | LoggingSeverity, detailed_error: bool = False) -> None:
    """Set the level of a logger, and of its children that have none."""
    levels.set(name, LoggingSeverity(level))


def get_logger_effective_level(name: str) -> LoggingSeverity:
    """The level that decides for a logger: its own, its parents', or the default."""
    return levels.effective(name)


def get_logger_level(name: str) -> LoggingSeverity:
    """The level set for this very logger, UNSET if there is none."""
    return levels.own(name)


def get_logging_severity_from_string(log_severity: str) -> LoggingSeverity:
    """The severity of a name, in upper or lower case.

    Raises
    ------
    RuntimeError
        For no such name.
    """
    try:
        return LoggingSeverity[log_severity.upper()]
    except KeyError:
        raise RuntimeError(f"no log severity is called {log_severity!r}") from None


def get_logging_directory() -> Path:
    """Where ROS 2 writes log files: ``ROS_LOG_DIR``, ``ROS_HOME/log`` or ``~/.ros/log``."""
    directory = os.environ.get("ROS_LOG_DIR")
    if directory:
        return Path(directory).expanduser()
    home: Any = os.environ.get("ROS_HOME") or "~/.ros"
    return Path(home).expanduser() / "log"
