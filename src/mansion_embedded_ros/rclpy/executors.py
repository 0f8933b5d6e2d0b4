"""Executors run the callbacks of nodes: one at a time, or several in threads."""

from __future__ import annotations

import os
import threading
from collections import deque
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any, TypeVar

from rclpy._executor_base import Executor
from rclpy._executor_signals import (
    ConditionReachedException,
    ExternalShutdownException,
    ShutdownException,
    TimeoutException,
    TimeoutObject,
    await_or_execute,
)
from rclpy._missing import missing_attribute
from rclpy.context import Context
from rclpy.task import Future, Task

if TYPE_CHECKING:
    pass

__all__ = [
    "ConditionReachedException",
    "Executor",
    "ExternalShutdownException",
    "MultiThreadedExecutor",
    "ShutdownException",
    "SingleThreadedExecutor",
    "TimeoutException",
    "TimeoutObject",
    "await_or_execute",
]

_T = TypeVar("_T")
_SLICE = 100_000_000
"""Nanoseconds that a wait lasts at most: signal handlers of Python run between two waits."""


class SingleThreadedExecutor(Executor[Any]):
    """Runs callbacks in the thread that calls :meth:`Executor.spin`."""

    def __init__(self, *, context: Context | None = None) -> None:
        super().__init__(context=context)

    def _spin_once_impl(
        self,
        timeout_sec: float | TimeoutObject | None = None,
        wait_condition: Callable[[], bool] = lambda: False,
    ) -> None:
        try:
            task, _, _ = self.wait_for_ready_callbacks(timeout_sec, None, wait_condition)
        except (ShutdownException, TimeoutException, ConditionReachedException):
            return
        task()
        if task.done():
            task.result()

    def spin_once(self, timeout_sec: float | None = None) -> None:
        self._spin_once_impl(timeout_sec)

    def spin_once_until_future_complete(
        self, future: Future, timeout_sec: float | TimeoutObject | None = None
    ) -> None:
        self._spin_once_impl(timeout_sec, future.done)


class MultiThreadedExecutor(Executor[Any]):
    """Runs callbacks in a pool of threads.

    Parameters
    ----------
    num_threads
        Threads in the pool; by default as many as CPUs, at least 2.
    """

    def __init__(self, num_threads: int | None = None, *, context: Context | None = None) -> None:
        super().__init__(context=context)
        if num_threads is None:
            num_threads = len(os.sched_getaffinity(0))
            if num_threads == 1:
                num_threads = 2
        self._num_threads = num_threads
        self._running: set[Task] = set()
        self._failed: deque[Task] = deque()
        self._idle = threading.Condition()
        self._executor = ThreadPoolExecutor(num_threads, thread_name_prefix="rclpy")

    def _has_room(self) -> bool:
        return len(self._running) < self._num_threads

    def _work(self, task: Task) -> None:
        try:
            task()
        finally:
            with self._idle:
                self._running.discard(task)
                if task.done() and task._exception is not None:
                    self._failed.append(task)
                self._idle.notify_all()
            self._dispatcher.unblock()

    def _hand_out(self, task: Task) -> None:
        # Ctrl-C may raise KeyboardInterrupt anywhere in here: no lock is taken, which would stay taken, and a task that
        # may not have reached the pool is not counted, since shutdown would wait for it without end.
        try:
            self._running.add(task)
            self._executor.submit(self._work, task)
        except RuntimeError:
            self._work(task)
        except BaseException:
            self._running.discard(task)
            raise

    def _spin_once_impl(
        self,
        timeout_sec: float | TimeoutObject | None = None,
        wait_condition: Callable[[], bool] = lambda: False,
    ) -> None:
        def reached() -> bool:
            return bool(self._failed) or wait_condition()

        try:
            task, _, _ = self.wait_for_ready_callbacks(timeout_sec, None, reached)
        except (ShutdownException, TimeoutException, ConditionReachedException):
            pass
        else:
            self._hand_out(task)
        if self._failed:
            self._failed.popleft().result()

    def spin_once(self, timeout_sec: float | None = None) -> None:
        self._spin_once_impl(timeout_sec)

    def spin_once_until_future_complete(
        self, future: Future, timeout_sec: float | TimeoutObject | None = None
    ) -> None:
        self._spin_once_impl(timeout_sec, future.done)

    def _wait_for_running(self, timeout_sec: float | None) -> bool:
        me = threading.current_thread().name
        inside = me.startswith("rclpy")
        limit = None if timeout_sec is None or timeout_sec < 0 else timeout_sec
        with self._idle:
            finished = self._idle.wait_for(lambda: len(self._running) <= inside, limit)
        self._executor.shutdown(wait=False)
        return finished


__getattr__ = missing_attribute(__name__)
