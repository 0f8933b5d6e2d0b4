"""Arrays that were computed once, as many as have room in memory."""

import threading
from collections.abc import Callable, Hashable

from mansion_geometry.compiled import Floats

__all__ = ["ArrayCache"]


class ArrayCache:
    """Arrays by what they were made from; beyond a number of bytes those go that were used longest ago.

    `functools.lru_cache` counts entries, which says little where one is a thousand times as large as another.

    Parameters
    ----------
    most : int
        Bytes of all arrays together; the latest one stays, however large it is.
    """

    def __init__(self, most: int) -> None:
        self._most = most
        self._guard = threading.Lock()
        self._arrays: dict[Hashable, Floats] = {}
        self._bytes = 0

    @property
    def size(self) -> int:
        """Bytes of what is kept."""
        return self._bytes

    def get(self, key: Hashable, make: Callable[[], Floats]) -> Floats:
        """Return the array of a key, which is made where it is not kept."""
        with self._guard:
            found = self._arrays.pop(key, None)
            if found is not None:
                self._arrays[key] = found
                return found
        made = make()
        with self._guard:
            if key not in self._arrays:
                self._arrays[key] = made
                self._bytes += made.nbytes
            while self._bytes > self._most and len(self._arrays) > 1:
                self._bytes -= self._arrays.pop(next(iter(self._arrays))).nbytes
        return made
