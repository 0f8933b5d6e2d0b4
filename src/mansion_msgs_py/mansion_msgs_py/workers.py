"""Processes that end with their parent, however it ends: pools of workers, and children of a supervisor."""

import ctypes
import os
import signal
import sys
import threading
from collections.abc import Callable
from concurrent.futures import Future, ProcessPoolExecutor
from multiprocessing import connection, get_context, parent_process
from typing import Final, Literal, ParamSpec, TypeVar

__all__ = ["end_with_parent", "release_memory", "worker_pool"]

P = ParamSpec("P")
T = TypeVar("T")

PR_SET_PDEATHSIG: Final = 1
"""Option of prctl(2)."""


def end_with_parent(parent: int, number: signal.Signals = signal.SIGTERM) -> None:
    """Ask Linux for a signal when the thread that made this process ends; take it now if that has happened already.

    Parameters
    ----------
    parent : int
        Process id.
    number : signal.Signals
    """
    if sys.platform != "linux":
        return
    _ask_for_signal(number)
    if os.getppid() != parent:
        os.kill(os.getpid(), number)


def worker_pool(
    workers: int,
    method: Literal["fork", "forkserver", "spawn"],
    prepare: Callable[[], None] | None = None,
    *,
    preload: tuple[str, ...] = (),
    ending: signal.Signals = signal.SIGKILL,
) -> ProcessPoolExecutor:
    """Return a pool whose processes end with this one, a kill included, and leave Ctrl-C to it.

    Parameters
    ----------
    workers : int
    method : {"fork", "forkserver", "spawn"}
        How a worker is made. A process that has threads must not fork.
    prepare : callable, optional
        Run first in each worker; a function of a module.
    preload : tuple of str
        Modules that a fork server imports once for all workers.
    ending : signal.Signals
        What a worker gets when this process is gone. SIGKILL fits work that only returns values.
    """
    context = get_context(method)
    if preload:
        context.set_forkserver_preload(list(preload))
    return _Pool(workers, mp_context=context, initializer=_begin, initargs=(ending, prepare))


class _Pool(ProcessPoolExecutor):
    """A pool whose workers ignore Ctrl-C from their first instruction on.

    A worker inherits the signals that are blocked where it is made, and takes an interrupt no sooner than `_begin` has
    chosen to ignore it. Otherwise one that comes while its interpreter starts ends it with a traceback.
    """

    def submit(self, fn: Callable[P, T], /, *args: P.args, **kwargs: P.kwargs) -> Future[T]:
        blocked = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
        try:
            return super().submit(fn, *args, **kwargs)
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, blocked)


def release_memory() -> None:
    """Give the memory that this process has freed back to the system, where its C library can (glibc).

    Freed arrays lie scattered among those that stay, so that a process which works for hours keeps its peak otherwise.
    """
    trim = getattr(ctypes.CDLL(None), "malloc_trim", None)
    if trim is not None:
        trim(0)


def _begin(ending: signal.Signals, prepare: Callable[[], None] | None) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGINT])
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    threading.Thread(target=_follow_parent, args=(ending,), daemon=True).start()
    if sys.platform == "linux":
        _ask_for_signal(ending)
    if prepare is not None:
        prepare()


def _follow_parent(ending: signal.Signals) -> None:
    """Wait until the process that owns the pool is gone: the parent in Linux's eyes may be a fork server."""
    parent = parent_process()
    if parent is not None:
        connection.wait([parent.sentinel])
        os.kill(os.getpid(), ending)


def _ask_for_signal(number: signal.Signals) -> None:
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, number)
