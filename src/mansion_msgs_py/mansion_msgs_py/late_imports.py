"""Imports inside functions that several threads may be the first to call."""

import os
import threading
from typing import Final

__all__ = ["importing"]

importing: Final = threading.RLock()
"""Held while a function imports what it needs, so that one thread at a time does.

Two threads that enter a package from two sides, one by the package and one by a module of it, wait for each other;
Python then gives one of them a module that is not complete, and its import fails. Modules take the lock only inside
functions: a module that took it while being imported could wait for a thread that waits for that very import.
"""

# A worker that is forked while a thread imports would wait for ever for a lock whose owner it does not have.
os.register_at_fork(before=importing.acquire, after_in_parent=importing.release, after_in_child=importing.release)
