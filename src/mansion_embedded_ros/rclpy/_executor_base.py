"""What all executors share: waiting for what nodes have to do, and making tasks of it."""

from __future__ import annotations

import inspect
import threading
import time
from collections import deque
from collections.abc import Callable, Coroutine
from contextlib import AbstractContextManager
from types import TracebackType
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from rclpy._dispatch import Dispatcher
from rclpy.client import Client
from rclpy.context import Context
from rclpy.logging import get_logger
from rclpy.task import Future, Task
from rclpy.utilities import get_default_context, timeout_sec_to_nsec

if TYPE_CHECKING:
    from rclpy.node import Node

__all__ = [
    "ConditionReachedException",
    "Executor",
    "ExternalShutdownException",
    "ShutdownException",
    "TimeoutException",
    "TimeoutObject",
    "await_or_execute",
]

_T = TypeVar("_T")
_SLICE = 100_000_000
"""Nanoseconds that a wait lasts at most: signal handlers of Python run between two waits."""


async def await_or_execute(callback: Callable[..., Any] | Coroutine[Any, Any, Any], *args) -> Any:  # type: ignore[no-untyped-def]
    """Await a coroutine function, call any other."""
    if inspect.iscoroutinefunction(callback):
        return await callback(*args)
    return callback(*args)  # type: ignore[operator]


class TimeoutException(Exception):
    """Signal that a timeout occurred."""


class ShutdownException(Exception):
    """Signal that executor was shut down."""


class ExternalShutdownException(Exception):
    """Context has been shutdown."""

    def __init__(self, *args: object) -> None:
        super().__init__(*args)


class ConditionReachedException(Exception):
    """Future has been completed."""


class TimeoutObject:
    """A timeout that others read while it counts down."""

    def __init__(self, timeout: float) -> None:
        self._timeout = timeout

    @property
    def timeout(self) -> float:
        return self._timeout

    @timeout.setter
    def timeout(self, timeout: float) -> None:
        self._timeout = timeout


class Executor(AbstractContextManager["Executor"], Generic[_T]):
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

    def can_execute(self, entity: _T) -> bool:
        """Whether the entity's callback group lets it run now."""
        group = getattr(entity, "callback_group", None)
        return group is None or bool(group.can_execute(entity))

    def _has_room(self) -> bool:
        """Whether another callback may be started."""
        return True

    def _begin(self, entity: Any) -> Task | None:
        """Take the data of a ready entity and make a task of its callback."""
        group = entity.callback_group
        if not self._has_room() or (group is not None and not group.beginning_execution(entity)):
            self._dispatcher.block(entity)
            # What was in the way may have ended before it was blocked; then nobody else unblocks it.
            if self._has_room() and self.can_execute(entity):
                self._dispatcher.unblock()
            return None
        taken = None
        try:
            taken = entity._take()
        except Exception as problem:
            get_logger("rclpy.executor").error(f"dropped data that cannot be read: {problem}")
        if taken is None:
            self._end(entity, group)
            return None
        return Task(self._run, (entity, group, taken), executor=self)

    async def _run(self, entity: Any, group: Any, taken: Any) -> None:
        try:
            pending = entity._execute(taken)
            if hasattr(pending, "__await__"):
                await pending
        finally:
            self._end(entity, group)

    def _end(self, entity: Any, group: Any) -> None:
        if group is not None:
            group.ending_execution(entity)
        if self._dispatcher._blocked:
            self._dispatcher.unblock()

    def _ready_timer(self) -> tuple[Task | None, int]:
        """A task of a timer that is due, or the nanoseconds until the next one is."""
        soonest = _SLICE
        if not self._has_room():
            return None, soonest
        for timer in self._dispatcher.timers:
            left = timer._wall_wait()
            if left is None or not self.can_execute(timer):
                continue
            if left == 0:
                task = self._begin(timer)
                if task is not None:
                    return task, 0
                left = timer._wall_wait() or 0
            soonest = min(soonest, max(left, 0))
        return None, soonest

    def _next_task(
        self, deadline: int | None, condition: Callable[[], bool], nodes: list[Node] | None
    ) -> tuple[Task | None, Any]:
        """The next task and its entity; the task is None if its work is done already.

        Raises
        ------
        TimeoutException, ShutdownException, ExternalShutdownException, ConditionReachedException
        """
        dispatcher = self._dispatcher
        first = True
        while True:
            if self._is_shutdown:
                raise ShutdownException()
            if not self._context.ok():
                raise ExternalShutdownException()
            if condition():
                raise ConditionReachedException()
            dispatcher.begin_round()
            found = self._ready_now(nodes)
            if found is not None:
                return found
            task, pause = self._ready_timer()
            if task is not None:
                return task, None
            if dispatcher._woken:
                continue
            if deadline is not None:
                left = deadline - time.monotonic_ns()
                if left <= 0 and not first:
                    raise TimeoutException()
                pause = max(min(pause, left), 0)
            dispatcher.wait(pause)
            first = False

    def _ready_now(self, nodes: list[Node] | None) -> tuple[Task | None, Any] | None:
        if self._tasks and self._has_room():
            try:
                return self._tasks.popleft(), None
            except IndexError:
                pass
        ready = self._dispatcher.ready
        while ready:
            try:
                entity = ready.popleft()
            except IndexError:
                return None
            if not self._dispatcher.knows(entity):
                continue
            if isinstance(entity, Client):
                # Replies wake whoever waits for them, whatever else is running.
                if entity._take_all(self):
                    return None, entity
                continue
            task = self._begin(entity)
            if task is not None:
                return task, entity
        return None

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


for _cls in (
    ConditionReachedException,
    Executor,
    ExternalShutdownException,
    ShutdownException,
    TimeoutException,
    TimeoutObject,
):
    _cls.__module__ = "rclpy.executors"
