"""What all executors share: their nodes, their tasks, and spinning."""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable, Coroutine
from contextlib import AbstractContextManager
from types import TracebackType
from typing import TYPE_CHECKING, Any, TypeVar

from rclpy._dispatch import Dispatcher
from rclpy._executor_signals import TimeoutObject
from rclpy._ready_work import ReadyWork
from rclpy.context import Context
from rclpy.task import Future, Task
from rclpy.utilities import get_default_context, timeout_sec_to_nsec

if TYPE_CHECKING:
    from rclpy.node import Node

__all__ = ["Executor"]

_T = TypeVar("_T")


class Executor(ReadyWork[_T], AbstractContextManager["Executor"]):
    """Base of the executors: waits for what nodes have to do."""

    def __init__(self, *, context: Context | None = None) -> None:
        super().__init__()
        self._context = get_default_context() if context is None else context
        self._nodes: list[Node] = []
        self._nodes_lock = threading.RLock()
        self._tasks: deque[Task] = deque()
        self._is_shutdown = False
        self._dispatcher = Dispatcher()
        self._context.on_shutdown(self.wake)

    @property
    def context(self) -> Context:
        """The context of its nodes."""
        return self._context

    def __enter__(self) -> Executor[_T]:
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_val: BaseException | None,
        exc_tb: TracebackType | None,
    ) -> None:
        self.shutdown()

    def __del__(self) -> None:
        dispatcher = getattr(self, "_dispatcher", None)
        if dispatcher is not None:
            dispatcher.close()

    def create_task(
        self,
        callback: Callable[..., Any] | Coroutine[Any, Any, Any],
        *args,
        **kwargs,
    ) -> Task:
        """Have a callback or coroutine run while spinning."""
        task = Task(callback, args, kwargs, executor=self)
        self._queue_task(task)
        return task

    def _queue_task(self, task: Task) -> None:
        self._tasks.append(task)
        self._dispatcher.wake()

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Stop executing; waits for the callbacks that are running.

        Returns
        -------
        bool
            False if some still run at the timeout.
        """
        self._is_shutdown = True
        self._dispatcher.wake()
        finished = self._wait_for_running(timeout_sec)
        if finished:
            with self._nodes_lock:
                for node in self._nodes:
                    node._forget_executor(self)
                self._nodes = []
            self._dispatcher.close()
        return finished

    def _wait_for_running(self, timeout_sec: float | None) -> bool:
        return True

    def add_node(self, node: Node) -> bool:
        """Execute the callbacks of a node; False if it was added before."""
        with self._nodes_lock:
            if self._is_shutdown or node in self._nodes:
                return False
            self._nodes.append(node)
            node.executor = self
        for item in node._waitables_of_all_kinds():
            self._dispatcher.add(item)
        self.wake()
        return True

    def remove_node(self, node: Node) -> None:
        """No longer execute the callbacks of a node."""
        with self._nodes_lock:
            if node not in self._nodes:
                return
            self._nodes.remove(node)
        for item in node._waitables_of_all_kinds():
            self._dispatcher.discard(item)
        node._forget_executor(self)
        self.wake()

    def wake(self) -> None:
        """Have the executor look at its work anew."""
        self._dispatcher.wake()

    def get_nodes(self) -> list[Node]:
        """The nodes that were added."""
        with self._nodes_lock:
            return list(self._nodes)

    def spin(self) -> None:
        """Execute callbacks until shutdown.

        Raises
        ------
        ExternalShutdownException
            If the context is shut down by a signal or another thread.
        """
        while self._context.ok() and not self._is_shutdown:
            self.spin_once()

    def spin_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        """Execute callbacks until the future is done, the timeout, or shutdown."""
        future.add_done_callback(self._wake_for_future)
        try:
            if timeout_sec is None or timeout_sec < 0:
                while self._context.ok() and not future.done() and not self._is_shutdown:
                    self.spin_once_until_future_complete(future, timeout_sec)
                return
            end = time.monotonic() + timeout_sec
            left = float(timeout_sec)
            while self._context.ok() and not future.done() and not self._is_shutdown:
                self.spin_once_until_future_complete(future, left)
                left = end - time.monotonic()
                if left < 0:
                    return
        finally:
            future.remove_done_callback(self._wake_for_future)

    def _wake_for_future(self, _: Future) -> None:
        self.wake()

    _wake_for_future._runs_anywhere = True  # type: ignore[attr-defined]

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Wait for and execute a single callback."""
        raise NotImplementedError

    def spin_once_until_future_complete(
        self, future: Future, timeout_sec: float | TimeoutObject | None = None
    ) -> None:
        """Wait for and execute a single callback, or return when the future is done."""
        raise NotImplementedError

    def wait_for_ready_callbacks(self, *args, **kwargs) -> tuple[Task, _T, Node]:
        """Wait for a callback that is ready: its task, entity and node.

        Parameters
        ----------
        timeout_sec, nodes, condition
            Seconds (None: forever), nodes that are looked at (None: all), and a function that ends
            the waiting.

        Raises
        ------
        TimeoutException, ShutdownException, ExternalShutdownException, ConditionReachedException
        """
        return self._wait_for_ready_callbacks(*args, **kwargs)

    def _wait_for_ready_callbacks(
        self,
        timeout_sec: float | TimeoutObject | None = None,
        nodes: list[Node] | None = None,
        condition: Callable[[], bool] = lambda: False,
    ) -> tuple[Any, Any, Any]:
        if isinstance(timeout_sec, TimeoutObject):
            timeout_sec = timeout_sec.timeout
        timeout = timeout_sec_to_nsec(timeout_sec)
        deadline = None if timeout < 0 else time.monotonic_ns() + timeout
        task, entity = self._next_task(deadline, condition, nodes)
        if task is None:
            task = Task(_nothing, executor=self)
        return task, entity, None


def _nothing() -> None:
    """The work of a task that was done while waiting."""


Executor.__module__ = "rclpy.executors"
