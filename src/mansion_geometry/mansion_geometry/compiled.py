"""Functions compiled to machine code with numba."""

from collections.abc import Callable
from typing import ParamSpec, TypeVar

import numba

__all__ = ["kernel"]

P = ParamSpec("P")
R = TypeVar("R")


def kernel(function: Callable[P, R]) -> Callable[P, R]:
    """Compile `function` on its first call and keep the machine code on disk for later processes.

    Arithmetic is strict IEEE 754 (no ``fastmath``), so that results are the same on every run; dividing by zero gives
    an infinity or NaN, as in numpy. A kernel runs without the interpreter lock. numba compiles no keyword-only
    parameters, so kernels take their flags positionally and callers name them.
    """
    compiled: Callable[P, R] = numba.njit(cache=True, nogil=True, error_model="numpy")(function)
    return compiled
