"""Types of numpy arrays by their numbers, and functions on them compiled to machine code with numba."""

from collections.abc import Callable
from typing import ParamSpec, TypeVar

import numpy as np
from numpy.typing import NDArray

__all__ = ["Bools", "Counts", "Floats", "Ints", "Labels", "kernel"]

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

Labels = NDArray[np.int32]
"""Numbers of regions, of a grid's cells for one."""

Counts = NDArray[np.int16]
"""Small numbers, as many as a grid has cells."""

P = ParamSpec("P")
R = TypeVar("R")


def kernel(function: Callable[P, R]) -> Callable[P, R]:
    """Compile `function` on its first call and keep the machine code on disk for later processes.

    Arithmetic is strict IEEE 754 (no ``fastmath``), so that results are the same on every run; dividing by zero gives
    an infinity or NaN, as in numpy. A kernel runs without the interpreter lock. numba compiles no keyword-only
    parameters, so kernels take their flags positionally and callers name them.
    """
    import numba  # modules that only name types start without it

    compiled: Callable[P, R] = numba.njit(cache=True, nogil=True, error_model="numpy")(function)
    return compiled
