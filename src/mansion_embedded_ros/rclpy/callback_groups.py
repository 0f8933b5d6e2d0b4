"""Which callbacks of a node may run at the same time."""

from __future__ import annotations

import threading
from typing import Any
from weakref import WeakSet

__all__ = ["CallbackGroup", "MutuallyExclusiveCallbackGroup", "ReentrantCallbackGroup"]


class CallbackGroup:
    """Base of the callback groups: they say when an entity may be executed."""

    def __init__(self) -> None:
        super().__init__()
        self.entities: WeakSet[Any] = WeakSet()

    def add_entity(self, entity) -> None:  # type: ignore[no-untyped-def]
        """Make the entity a member of this group."""
        self.entities.add(entity)

    def has_entity(self, entity) -> bool:  # type: ignore[no-untyped-def]
        """Whether the entity is a member."""
        return entity in self.entities

    def can_execute(self, entity) -> bool:  # type: ignore[no-untyped-def]
        """Whether the entity may be executed now."""
        raise NotImplementedError

    def beginning_execution(self, entity) -> bool:  # type: ignore[no-untyped-def]
        """Reserve the execution of the entity; False if it may not run now."""
        raise NotImplementedError

    def ending_execution(self, entity) -> None:  # type: ignore[no-untyped-def]
        """Tell that the execution has ended."""
        raise NotImplementedError


class ReentrantCallbackGroup(CallbackGroup):
    """Allow callbacks to be executed in parallel without restriction."""

    def can_execute(self, entity):  # type: ignore[no-untyped-def]
        return True

    def beginning_execution(self, entity):  # type: ignore[no-untyped-def]
        return True

    def ending_execution(self, entity):  # type: ignore[no-untyped-def]
        pass


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """Allow only one callback to be executing at a time."""

    def __init__(self):  # type: ignore[no-untyped-def]
        super().__init__()
        self._active_entity: Any = None
        self._lock = threading.Lock()

    def can_execute(self, entity):  # type: ignore[no-untyped-def]
        return self._active_entity is None

    def beginning_execution(self, entity):  # type: ignore[no-untyped-def]
        with self._lock:
            if self._active_entity is None:
                self._active_entity = entity
                return True
        return False

    def ending_execution(self, entity):  # type: ignore[no-untyped-def]
        with self._lock:
            self._active_entity = None
