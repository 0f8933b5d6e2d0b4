"""Machine-code kernels: numba's ``njit`` with a disk cache, keeping the function's type."""

from collections.abc import Callable
from typing import Any, TypeVar, cast

import numba

__all__ = ["kernel"]

_Function = TypeVar("_Function", bound=Callable[..., Any])


def kernel(function: _Function) -> _Function:
    """Compile `function` on its first call and keep the machine code on disk.

    Strict IEEE arithmetic (no ``fastmath``), so that results are the same on every run.
    """
    return cast(_Function, numba.njit(cache=True, nogil=True)(function))
