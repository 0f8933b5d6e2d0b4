"""The logger objects: severities, and filters by place (once, throttle, skip first)."""

from __future__ import annotations

import sys
import time
from collections import OrderedDict, namedtuple
from types import FrameType
from typing import Any, ClassVar

from rclpy._log_sink import emit, levels
from rclpy.impl.logging_severity import LoggingSeverity

__all__ = [
    "CallerId",
    "LoggingFilter",
    "Once",
    "RcutilsLogger",
    "SkipFirst",
    "Throttle",
    "get_filters_from_kwargs",
]

_INTERNAL = (__file__.removesuffix("c"),)


class CallerId(namedtuple("CallerId", ["function_name", "file_path", "line_number", "last_index"])):
    """Where a message was logged from."""

    def __new__(cls, frame: FrameType | None = None) -> CallerId:
        if frame is None:
            frame = _find_caller(sys._getframe(1))
        return super().__new__(
            cls,
            function_name=frame.f_code.co_name,
            file_path=frame.f_code.co_filename,
            line_number=frame.f_lineno,
            last_index=frame.f_lasti,
        )


def _find_caller(frame: FrameType) -> FrameType:
    while frame.f_code.co_filename in _INTERNAL and frame.f_back is not None:
        frame = frame.f_back
    return frame


class LoggingFilter:
    """Decides for each message of one place; what it needs is in ``context``."""

    params: ClassVar[dict[str, Any]] = {}
    """The arguments of a log call that choose the filter: name and default (None: required)."""

    @classmethod
    def initialize_context(cls, context, **kwargs):  # type: ignore[no-untyped-def]
        """Note the arguments of the first call at a place."""
        for param, default in cls.params.items():
            value = kwargs.get(param, default)
            if value is None:
                raise TypeError(
                    f'Required parameter "{param}" was not specified for logging filter '
                    f'"{cls.__name__}"'
                )
            context[param] = value

    @staticmethod
    def should_log(context):  # type: ignore[no-untyped-def]
        """Whether the message is to be logged."""
        return True


class Once(LoggingFilter):
    """Ignore all messages of a place but the first."""

    params: ClassVar[dict[str, Any]] = {"once": None}

    @classmethod
    def initialize_context(cls, context, **kwargs):  # type: ignore[no-untyped-def]
        super().initialize_context(context, **kwargs)
        context["has_been_logged_once"] = False

    @staticmethod
    def should_log(context):  # type: ignore[no-untyped-def]
        logging = not context["has_been_logged_once"]
        context["has_been_logged_once"] = True
        return logging


class Throttle(LoggingFilter):
    """Ignore messages of a place until a duration has passed since the last one."""

    params: ClassVar[dict[str, Any]] = {
        "throttle_duration_sec": None,
        "throttle_time_source_type": "SYSTEM_TIME",
    }

    @classmethod
    def initialize_context(cls, context, **kwargs):  # type: ignore[no-untyped-def]
        super().initialize_context(context, **kwargs)
        source = context["throttle_time_source_type"]
        if isinstance(source, str) and source not in (
            "SYSTEM_TIME",
            "STEADY_TIME",
            "RCUTILS_STEADY_TIME",
        ):
            raise ValueError(
                f'Received invalid expression "{source}" for time source type. Expected a clock, '
                "SYSTEM_TIME or STEADY_TIME"
            )
        context["throttle_last_logged"] = None

    @staticmethod
    def should_log(context):  # type: ignore[no-untyped-def]
        source = context["throttle_time_source_type"]
        now = time.monotonic_ns() if isinstance(source, str) else source.now().nanoseconds
        last = context["throttle_last_logged"]
        logging = last is None or now >= last + context["throttle_duration_sec"] * 1e9
        if logging:
            context["throttle_last_logged"] = now
        return logging


class SkipFirst(LoggingFilter):
    """Ignore the first message of a place."""

    params: ClassVar[dict[str, Any]] = {"skip_first": None}

    @classmethod
    def initialize_context(cls, context, **kwargs):  # type: ignore[no-untyped-def]
        super().initialize_context(context, **kwargs)
        context["first_has_been_skipped"] = False

    @staticmethod
    def should_log(context):  # type: ignore[no-untyped-def]
        logging = context["first_has_been_skipped"]
        context["first_has_been_skipped"] = True
        return logging


# Throttle comes before skip_first, so that a skipped message counts as the last one.
supported_filters: OrderedDict[str, type[LoggingFilter]] = OrderedDict(
    throttle=Throttle, skip_first=SkipFirst, once=Once
)


def get_filters_from_kwargs(**kwargs):  # type: ignore[no-untyped-def]
    """The filters that the arguments of a log call ask for.

    Raises
    ------
    TypeError
        For an argument that belongs to no filter.
    """
    detected = []
    allowed: set[str] = {"name"}
    for name, cls in supported_filters.items():
        if any(kwargs.get(param) for param in cls.params if param in kwargs):
            detected.append(name)
        if name in detected:
            allowed.update(cls.params)
        else:
            allowed.update(param for param in cls.params if not kwargs.get(param, True))
    for kwarg in kwargs:
        if kwarg not in allowed:
            raise TypeError(
                f'parameter "{kwarg}" is not one of the recognized logging options '
                f'"{sorted(allowed)}"'
            )
    return detected


class RcutilsLogger:
    """Log messages under a name."""

    def __init__(self, name=""):  # type: ignore[no-untyped-def]
        self.name = name
        self.contexts: dict[Any, dict[str, Any]] = {}

    def get_child(self, name):  # type: ignore[no-untyped-def]
        """The logger ``self.name.name``."""
        if not name:
            raise ValueError("Need at least one character for child name")
        return RcutilsLogger(f"{self.name}.{name}" if self.name else name)

    def set_level(self, level):  # type: ignore[no-untyped-def]
        """Log only messages of this severity and above."""
        levels.set(self.name, LoggingSeverity(level))

    def get_effective_level(self):  # type: ignore[no-untyped-def]
        return levels.effective(self.name)

    def is_enabled_for(self, severity):  # type: ignore[no-untyped-def]
        return LoggingSeverity(severity) >= levels.effective(self.name)

    def log(self, message, severity, **kwargs):  # type: ignore[no-untyped-def]
        """Log a message.

        Parameters
        ----------
        once, skip_first, throttle_duration_sec, throttle_time_source_type
            Filters, each for the place of the call.

        Returns
        -------
        bool
            Whether it was logged.
        """
        severity = LoggingSeverity(severity)
        name = kwargs.pop("name", self.name)
        if not kwargs and severity < levels.effective(self.name):
            return False
        caller = CallerId()
        if kwargs and not self._passes(caller, severity, kwargs):
            return False
        if severity < levels.effective(self.name):
            return False
        emit(
            name, severity, str(message), caller.file_path, caller.function_name, caller.line_number
        )
        return True

    def _passes(self, caller: CallerId, severity: LoggingSeverity, kwargs: dict[str, Any]) -> bool:
        context = self.contexts.get(caller)
        if context is None:
            context = {"name": self.name, "severity": severity}
            filters = get_filters_from_kwargs(**kwargs)
            context["filters"] = filters
            for item in filters:
                supported_filters[item].initialize_context(context, **kwargs)
            self.contexts[caller] = context
        elif severity != context["severity"]:
            raise ValueError("Logger severity cannot be changed between calls.")
        return all(supported_filters[item].should_log(context) for item in context["filters"])

    def debug(self, message, **kwargs):  # type: ignore[no-untyped-def]
        """Log a message of severity DEBUG."""
        return self.log(message, LoggingSeverity.DEBUG, **kwargs)

    def info(self, message, **kwargs):  # type: ignore[no-untyped-def]
        """Log a message of severity INFO."""
        return self.log(message, LoggingSeverity.INFO, **kwargs)

    def warning(self, message, **kwargs):  # type: ignore[no-untyped-def]
        """Log a message of severity WARN."""
        return self.log(message, LoggingSeverity.WARN, **kwargs)

    def warn(self, message, **kwargs):  # type: ignore[no-untyped-def]
        """Log a message of severity WARN."""
        return self.warning(message, **kwargs)

    def error(self, message, **kwargs):  # type: ignore[no-untyped-def]
        """Log a message of severity ERROR."""
        return self.log(message, LoggingSeverity.ERROR, **kwargs)

    def fatal(self, message, **kwargs):  # type: ignore[no-untyped-def]
        """Log a message of severity FATAL."""
        return self.log(message, LoggingSeverity.FATAL, **kwargs)
