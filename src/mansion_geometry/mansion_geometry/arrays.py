"""Types of numpy arrays by their numbers."""

import numpy as np
from numpy.typing import NDArray

__all__ = ["Bools", "Counts", "Floats", "Ints", "Labels"]

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

Labels = NDArray[np.int32]
"""Numbers of regions, of a grid's cells for one."""

Counts = NDArray[np.int16]
"""Small numbers, as many as a grid has cells."""
