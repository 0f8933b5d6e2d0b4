"""Types of numpy arrays by their numbers, and functions on them compiled to machine code with numba."""

import logging
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, Final, ParamSpec, TypeVar

import numpy as np
from numpy.typing import NDArray

__all__ = ["Bools", "Counts", "Floats", "Ints", "Labels", "kernel"]

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

Labels = NDArray[np.int32]
"""Numbers of regions, such as those of a grid's cells."""

Counts = NDArray[np.int16]
"""Small numbers, as many as a grid has cells."""

TOLD: Final = "told.nbi"
"""File beside the first machine code that records that its compilation was announced; its ending goes with the code."""

_LOG = logging.getLogger("mansion")

P = ParamSpec("P")
R = TypeVar("R")


def kernel(function: Callable[P, R]) -> Callable[P, R]:
    """Compile `function` on its first call and keep the machine code on disk for later processes.

    Arithmetic is strict IEEE 754 (no ``fastmath``), so that results are the same on every run; dividing by zero gives
    an infinity or NaN, as in numpy. A kernel runs without the interpreter lock. numba compiles no keyword-only
    parameters, so kernels take their flags positionally and callers name them.
    """
    import numba  # modules that only name types start without it

    _announce_compilation()
    compiled = numba.njit(cache=True, nogil=True, error_model="numpy")(function)
    compiled._cache = _machine_code()(function)
    known: Callable[P, R] = compiled
    return known


@cache
def _machine_code() -> type[Any]:
    """Return numba's cache of machine code without what it loads for compiling."""
    from numba.core.caching import FunctionCache
    from numba.core.runtime import rtsys

    class MachineCode(FunctionCache):  # type: ignore[misc]
        """Machine code on the disk, which holds all that it calls but numba's allocation of memory.

        Numba's own cache first loads the types and implementations of all that can be compiled, which takes longer
        than the code of all kernels. They are loaded when something is compiled.
        """

        def load_overload(self, sig: Any, target_context: Any) -> Any:
            rtsys.initialize(target_context)
            with self._guard_against_spurious_io_errors():
                return self._load_overload(sig, target_context)

    return MachineCode


@cache
def _announce_compilation() -> None:
    """Announce the first compilation of an installation, once, by whichever process does it."""
    from numba.core import event

    class FirstCompilation(event.Listener):  # type: ignore[misc]
        """Notes when numba compiles; code that is loaded from the disk is not compiled."""

        def on_start(self, event: Any) -> None:
            folder = Path(event.data["dispatcher"].stats.cache_path or "")
            if folder.parts and _is_first(folder):
                _LOG.warning(
                    "mansion: first use: numba compiles the kernels, a minute or more in all; they are kept in the "
                    "folders __pycache__ beside their modules or, where those are read-only, in numba's cache (here: "
                    "%s); to remove them delete *.nbi and *.nbc there",
                    folder,
                )

        def on_end(self, event: Any) -> None:
            return

    event.register("numba:compile", FirstCompilation())


def _is_first(folder: Path) -> bool:
    """Whether nothing has been said yet where the machine code of this package is kept."""
    own = Path(__file__).parent / "__pycache__"
    for place in (own, folder):
        try:
            place.mkdir(parents=True, exist_ok=True)
            (place / TOLD).touch(exist_ok=False)
        except FileExistsError:
            return False
        except OSError:
            continue
        return True
    return False
