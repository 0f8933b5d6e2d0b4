"""An offscreen OpenGL context in a thread of its own, so that a camera may be used from any thread."""

import os
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from ctypes.util import find_library
from importlib import import_module
from importlib.util import find_spec
from typing import Any, TypeVar

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["BACKENDS", "GlThread", "backend", "rendering_fault"]

BACKENDS = {"egl": "EGL", "osmesa": "OSMesa"}
"""Backends that render without a display, and the library that each needs."""

LIBRARIES = "install libegl1, libgl1 and libgl1-mesa-dri (EGL; MUJOCO_GL=egl), or libosmesa6 (MUJOCO_GL=osmesa)"
MUJOCO = "MuJoCo is not installed; install the extra `sim`, or: python3 -m pip install mujoco"

T = TypeVar("T")


def backend() -> str:
    """Return the backend that ``MUJOCO_GL`` names, else the first whose library is installed.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` when there is none.
    """
    named = os.environ.get("MUJOCO_GL", "").strip().lower()
    for name in [named] if named in BACKENDS else list(BACKENDS):
        if find_library(BACKENDS[name]) is not None:
            return name
    raise MansionError(ErrorCode.UNAVAILABLE, f"no OpenGL library here can render offscreen; {LIBRARIES}")


def rendering_fault(patience: float = 60.0) -> str:
    """Return why pictures cannot be rendered here, or an empty string if they can.

    A process of its own opens a small OpenGL context, so that this one need not load what it may never use.
    """
    program = "from mansion_skills.vision.offscreen import GlThread; GlThread(16, 16).close()"
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    try:
        done = subprocess.run(
            [sys.executable, "-P", "-c", program],
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=patience,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return f"opening an OpenGL context took more than {patience:g} s"
    lines = done.stderr.strip().splitlines() or [f"status {done.returncode}"]
    return "" if done.returncode == 0 else lines[-1].rpartition("MansionError: ")[2]


def _open_context(width: int, height: int) -> Any:
    if find_spec("mujoco") is None:
        raise MansionError(ErrorCode.UNAVAILABLE, MUJOCO)
    name = backend()
    try:
        # Bound before MuJoCo's own choice of a backend, which is made once for the process, can matter.
        context = import_module(f"mujoco.{name}").GLContext(width, height)
        context.make_current()
    except Exception as error:  # what a missing library or driver raises differs by version
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            f"MuJoCo cannot render with {BACKENDS[name]} ({type(error).__name__}: {error}); {LIBRARIES}",
        ) from error
    return context


class GlThread:
    """A thread with a current OpenGL context, in which everything that draws is called.

    Parameters
    ----------
    width, height : int
        Size of the largest picture, pixels.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` where MuJoCo or OpenGL is missing, with which of them.
    """

    def __init__(self, width: int, height: int) -> None:
        self._pool: ThreadPoolExecutor | None = ThreadPoolExecutor(max_workers=1, thread_name_prefix="camera")
        try:
            self._context = self.run(_open_context, width, height)
        except MansionError:
            self._pool.shutdown()
            raise

    def run(self, call: Callable[..., T], *arguments: Any) -> T:
        """Call something in the thread and return what it returns.

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` after `close`.
        """
        if self._pool is None:
            raise MansionError(ErrorCode.UNAVAILABLE, "the camera is closed")
        return self._pool.submit(call, *arguments).result()

    def close(self) -> None:
        """Free the context and end the thread."""
        if self._pool is not None:
            self.run(self._context.free)
            self._pool.shutdown()
            self._pool = None
