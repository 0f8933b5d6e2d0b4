"""The entities that an executor waits for, in one wait set that is kept up to date."""

from __future__ import annotations

import threading
from collections import deque
from typing import Any

from rclpy._dds.library import INFINITY
from rclpy._dds.waitset import Guard, WaitSet

__all__ = ["Dispatcher"]

_GUARD = 0


class Dispatcher:
    """Waits for entities and keeps those that are ready in order of arrival.

    Cyclone's wait sets stay triggered while data is there. What is ready but may not run now is
    therefore taken out (:meth:`block`) until something ends (:meth:`unblock`).
    """

    def __init__(self) -> None:
        self._waitset = WaitSet()
        self._guard = Guard()
        self._waitset.attach(self._guard.entity, _GUARD)
        self._lock = threading.RLock()
        self._wait_lock = threading.Lock()
        self._members: dict[int, list[Any]] = {}
        self._tokens: dict[int, int] = {}
        self._places: dict[Any, int] = {}
        self._next_token = 1
        self._blocked: set[int] = set()
        self._waiting = False
        self._woken = False
        self.ready: deque[Any] = deque()
        self.timers: tuple[Any, ...] = ()
        self.closed = False

    def add(self, item: Any) -> None:
        """Wait for an entity: anything with ``_wait_entity``, ``_take`` and ``_execute``, or a timer."""
        with self._lock:
            if self.closed or item in self._places or item in self.timers:
                return
            if hasattr(item, "_wall_wait"):
                self.timers = (*self.timers, item)
                item._wake = self.wake
                item._clock._state.wakes.add(self)
                self.wake()
                return
            entity = item._wait_entity()
            if entity <= 0:
                return
            token = self._tokens.get(entity)
            if token is None:
                token = self._next_token
                self._next_token += 1
                self._members[token] = []
                self._tokens[entity] = token
                self._waitset.attach(entity, token)
            self._members[token].append(item)
            self._places[item] = entity

    def discard(self, item: Any) -> None:
        """No longer wait for an entity."""
        with self._lock:
            if item in self.timers:
                self.timers = tuple(t for t in self.timers if t is not item)
                return
            entity = self._places.pop(item, None)
            if entity is None:
                return
            token = self._tokens[entity]
            members = self._members[token]
            members.remove(item)
            if not members:
                del self._members[token], self._tokens[entity]
                self._blocked.discard(entity)
                if not self.closed:
                    self._waitset.detach(entity)

    def knows(self, item: Any) -> bool:
        """Whether the entity is still waited for."""
        return item in self._places or item in self.timers

    def block(self, item: Any) -> None:
        """Leave an entity out of the waiting until :meth:`unblock`."""
        with self._lock:
            entity = self._places.get(item)
            if entity is not None and entity not in self._blocked and not self.closed:
                self._blocked.add(entity)
                self._waitset.detach(entity)

    def unblock(self) -> None:
        """Wait again for all that was left out, and look at timers anew."""
        with self._lock:
            if self._blocked and not self.closed:
                for entity in self._blocked:
                    self._waitset.attach(entity, self._tokens[entity])
                self._blocked.clear()
        self.wake()

    def wake(self) -> None:
        """End the waiting of another thread, or of this one's next :meth:`wait`."""
        self._woken = True
        if self._waiting and not self.closed:
            self._guard.trigger()

    def begin_round(self) -> None:
        """Before the queues are looked at: what wakes from here on is not lost."""
        self._woken = False

    def wait(self, nanoseconds: int) -> None:
        """Wait at most so long for anything, and put what is triggered into ``ready``."""
        if not self._wait_lock.acquire(timeout=min(nanoseconds * 1e-9, 0.1)):
            return
        try:
            if self.closed:
                return
            self._waiting = True
            if self._woken:
                nanoseconds = 0
            tokens = self._waitset.wait(min(nanoseconds, INFINITY))
            self._waiting = False
            for token in tokens:
                if token == _GUARD:
                    self._guard.clear()
                    continue
                with self._lock:
                    self.ready.extend(self._members.get(token, ()))
        finally:
            self._waiting = False
            self._wait_lock.release()

    def close(self) -> None:
        """End the wait set; a thread that waits is woken first."""
        with self._lock:
            if self.closed:
                return
            self.closed = True
        self._guard.trigger()
        acquired = self._wait_lock.acquire(timeout=2.0)
        try:
            self._waitset.close()
            self._guard.close()
        finally:
            if acquired:
                self._wait_lock.release()
        with self._lock:
            self._members.clear()
            self._tokens.clear()
            self._places.clear()
            self._blocked.clear()
            self.ready.clear()
            self.timers = ()
