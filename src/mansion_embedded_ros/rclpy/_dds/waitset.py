"""Wait sets and guard conditions, independent of any participant."""

from __future__ import annotations

import ctypes as ct

from rclpy._dds.library import CYCLONEDDS_HANDLE, check, dds

__all__ = ["Guard", "WaitSet"]


class Guard:
    """A condition that any thread may trigger."""

    def __init__(self) -> None:
        self.entity = check(dds.dds_create_guardcondition(CYCLONEDDS_HANDLE), "create a guard")

    def trigger(self) -> None:
        dds.dds_set_guardcondition(self.entity, True)

    def clear(self) -> bool:
        """Reset it; whether it had been triggered."""
        triggered = ct.c_bool()
        dds.dds_take_guardcondition(self.entity, ct.byref(triggered))
        return triggered.value

    def close(self) -> None:
        entity, self.entity = self.entity, 0
        if entity > 0:
            dds.dds_delete(entity)


class WaitSet:
    """Entities with integer tokens; :meth:`wait` gives the tokens of those that are triggered."""

    def __init__(self) -> None:
        self.entity = check(dds.dds_create_waitset(CYCLONEDDS_HANDLE), "create a wait set")
        self._size = 64
        self._tokens = (ct.c_ssize_t * self._size)()

    def attach(self, entity: int, token: int) -> bool:
        """Whether it could be attached (it may just have been deleted)."""
        return bool(dds.dds_waitset_attach(self.entity, entity, token) == 0)

    def detach(self, entity: int) -> None:
        dds.dds_waitset_detach(self.entity, entity)

    def wait(self, nanoseconds: int) -> list[int]:
        """Wait at most so long; one thread at a time."""
        count = dds.dds_waitset_wait(self.entity, self._tokens, self._size, nanoseconds)
        if count <= 0:
            return []
        found = self._tokens[: min(count, self._size)]
        if count > self._size:
            self._size = 2 * count
            self._tokens = (ct.c_ssize_t * self._size)()
        return found

    def close(self) -> None:
        entity, self.entity = self.entity, 0
        if entity > 0:
            dds.dds_delete(entity)
