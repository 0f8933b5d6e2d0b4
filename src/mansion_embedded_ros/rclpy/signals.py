"""Signals end the contexts: SIGINT and SIGTERM, then the handlers that were there before."""

from __future__ import annotations

import contextlib
import signal
import threading
import weakref
from types import FrameType
from typing import Any

from rclpy._rclpy_pybind11 import SignalHandlerOptions
from rclpy.guard_condition import GuardCondition

__all__ = [
    "SignalHandlerGuardCondition",
    "SignalHandlerOptions",
    "get_current_signal_handlers_options",
    "install_signal_handlers",
    "uninstall_signal_handlers",
]

_contexts: weakref.WeakSet[Any] = weakref.WeakSet()
_previous: dict[int, Any] = {}
_guards: weakref.WeakSet[GuardCondition] = weakref.WeakSet()


class SignalHandlerGuardCondition(GuardCondition):
    """A guard condition that a signal triggers."""

    def __init__(self, context=None):
        super().__init__(callback=None, callback_group=None, context=context)
        _guards.add(self)

    def destroy(self):
        _guards.discard(self)
        super().destroy()


def _register(context: Any) -> None:
    _contexts.add(context)


def _shut_down() -> None:
    for context in list(_contexts):
        context.try_shutdown()
    for guard in list(_guards):
        guard.trigger()


def _handle(number: int, frame: FrameType | None) -> None:
    # The interrupted code may hold any lock, so the work is done by another thread.
    for context in list(_contexts):
        if context.handle is not None:
            context._shut_down_by_signal()
    threading.Thread(target=_shut_down, name="rclpy_signal", daemon=True).start()
    previous = _previous.get(number)
    if callable(previous):
        previous(number, frame)


def install_signal_handlers(options: SignalHandlerOptions = SignalHandlerOptions.ALL):
    """Install handlers; outside of the main thread Python allows none, and nothing is done."""
    if threading.current_thread() is not threading.main_thread():
        return
    for number, bit in ((signal.SIGINT, 1), (signal.SIGTERM, 2)):
        if int(options) & bit and number not in _previous:
            _previous[number] = signal.signal(number, _handle)


def uninstall_signal_handlers():
    """Put the handlers back that were there before."""
    if threading.current_thread() is not threading.main_thread():
        return
    for number in list(_previous):
        previous = _previous.pop(number)
        if signal.getsignal(number) is _handle:
            with contextlib.suppress(TypeError):
                signal.signal(number, previous)


def get_current_signal_handlers_options():
    """Which handlers are installed."""
    options = 0
    if signal.SIGINT in _previous:
        options |= 1
    if signal.SIGTERM in _previous:
        options |= 2
    return SignalHandlerOptions(options)
