"""A random generator for each item, from the building's seed and the item's id.

Items then do not depend on each other's draws, so results stay the same in any order and for any number of processes.
"""

import hashlib

import numpy as np

__all__ = ["item_generator", "item_seed"]


def item_seed(seed: int, *ids: object) -> int:
    """Return a 64-bit seed for the item named by `ids`.

    Examples
    --------
    >>> item_seed(0, "F1/lobby") == item_seed(0, "F1/lobby")
    True
    >>> item_seed(0, "F1/lobby") == item_seed(1, "F1/lobby")
    False
    """
    text = "\x1f".join([str(seed), *(str(part) for part in ids)])
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:8], "little")


def item_generator(seed: int, *ids: object) -> np.random.Generator:
    """Return the generator of the item named by `ids` (see `item_seed`)."""
    return np.random.Generator(np.random.PCG64(item_seed(seed, *ids)))
