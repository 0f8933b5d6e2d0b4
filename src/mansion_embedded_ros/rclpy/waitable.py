"""What an executor can wait for beyond topics, services, timers and guard conditions."""

from __future__ import annotations

from typing import Any

__all__ = ["NumberOfEntities", "Waitable"]


class NumberOfEntities:
    """Counts of the entities behind a waitable."""

    __slots__ = [
        "num_clients",
        "num_events",
        "num_guard_conditions",
        "num_services",
        "num_subscriptions",
        "num_timers",
    ]

    def __init__(
        self,
        num_subs: int = 0,
        num_gcs: int = 0,
        num_timers: int = 0,
        num_clients: int = 0,
        num_services: int = 0,
        num_events: int = 0,
    ) -> None:
        self.num_subscriptions = num_subs
        self.num_guard_conditions = num_gcs
        self.num_timers = num_timers
        self.num_clients = num_clients
        self.num_services = num_services
        self.num_events = num_events


class Waitable:
    """Base of the event handlers. Waitables of a program's own need rcl's wait set, which is not
    here: ``Node.add_waitable`` refuses them."""

    def __init__(self, callback_group: Any) -> None:
        self.callback_group = callback_group
        self.callback_group.add_entity(self)
        self._futures: list[Any] = []

    def __enter__(self) -> Waitable:
        return self

    def __exit__(self, *_: object) -> None:
        return None

    def add_future(self, future: Any) -> None:
        self._futures.append(future)

    def remove_future(self, future: Any) -> None:
        self._futures.remove(future)
