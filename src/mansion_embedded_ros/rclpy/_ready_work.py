"""What an executor's nodes have to do now: which callback is ready, and the task that runs it."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from rclpy._dispatch import Dispatcher
from rclpy._executor_signals import (
    ConditionReachedException,
    ExternalShutdownException,
    ShutdownException,
    TimeoutException,
)
from rclpy.client import Client
from rclpy.context import Context
from rclpy.logging import get_logger
from rclpy.task import Task

if TYPE_CHECKING:
    from rclpy.node import Node

__all__ = ["ReadyWork"]

_T = TypeVar("_T")
_SLICE = 100_000_000
"""Nanoseconds that a wait lasts at most: signal handlers of Python run between two waits."""


class ReadyWork(Generic[_T]):
    """Mixed into ``Executor``."""

    _context: Context
    _dispatcher: Dispatcher
    _is_shutdown: bool
    _tasks: deque[Task]

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
