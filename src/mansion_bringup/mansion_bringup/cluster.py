"""Buildings of a world built by the workers of a dask scheduler, on as many machines as it has.

Workers write into the world's folder, which all of them and the command see at the same path. An attempt is known by
the files that it leaves, so that it does not matter which worker made it, nor how many were lost over it.
"""

import logging
import socket
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future
from contextlib import contextmanager
from typing import Any, Final, TypeVar

from mansion_msgs_py import __version__
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_world.attempts import Assignment, Outcome, WorkerLost, WorkersGone, attempt_building
from mansion_world.sampling import WorldRequest

__all__ = ["Cluster", "attempt_on_worker"]

T = TypeVar("T")

_CONNECT: Final = 10.0
"""Seconds in which a scheduler must answer."""

_CLOSE: Final = 3.0

_BUSY: Final = 5.0
"""Seconds before a worker looks again whether another one is still at the same attempt."""

_MOST_WAITS: Final = 120

_IN_SOURCES: Final = ("ModuleNotFoundError", "ImportError", "AttributeError")


class Cluster:
    """The workers of a scheduler: `workers` and `jobs` are those of `mansion_world.making.make_world`.

    Parameters
    ----------
    address : str
        Address of the scheduler, such as ``tcp://127.0.0.1:8786``.
    most : int
        Attempts that run at once; 0: as many as the workers have threads.
    say : callable
        Gets what the user may want to know.
    """

    def __init__(self, address: str, most: int = 0, say: Callable[[str], None] = lambda text: None) -> None:
        self.address = address
        self._most = most
        self._say = say
        self._client: Any = None

    @contextmanager
    def workers(self) -> Iterator[Executor]:
        """Connect to the scheduler for a while.

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` where none answers.
        """
        self._client = client = _connected(self.address)
        try:
            if not client.nthreads():
                self._say(f"the scheduler at {self.address} has no workers yet; waiting for them")
            yield _ClusterExecutor(client, self.address)
        finally:
            client.close(timeout=_CLOSE)

    def jobs(self) -> int:
        """Return how many attempts the workers of this moment can do at once, at least one."""
        if self._client.status != "running":
            raise _scheduler_gone(self.address)
        try:
            threads = int(sum(self._client.nthreads().values()))
        except (OSError, RuntimeError):
            raise _scheduler_gone(self.address) from None
        return max(1, min(threads, self._most or threads))


def _connected(address: str) -> Any:
    import distributed

    # What goes wrong is told in one line by the command.
    for name in [name for name in logging.root.manager.loggerDict if name.split(".")[0] in ("distributed", "tornado")]:
        logging.getLogger(name).setLevel(logging.CRITICAL + 1)
    try:
        return distributed.Client(address, timeout=_CONNECT, set_as_default=False)
    except (OSError, ValueError) as error:
        why = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            f"no dask scheduler answers at {address} ({why}); `dask scheduler` starts one and prints its address",
        ) from None


def _scheduler_gone(address: str) -> WorkersGone:
    return WorkersGone(f"the dask scheduler at {address} no longer answers")


class _ClusterExecutor(Executor):
    """Attempts sent to the scheduler; those of low indices first, for which others may wait."""

    def __init__(self, client: Any, address: str) -> None:
        self._client = client
        self._address = address
        self._asked: dict[str, Any] = {}

    def submit(self, fn: Callable[..., T], /, *arguments: Any, **named: Any) -> "Future[T]":
        """Send a call to a worker; `fn` is `attempt_building`."""
        assert fn is attempt_building and not named
        assignment, request = arguments
        answer: Future[T] = Future()
        asked = self._client.submit(
            attempt_on_worker, __version__, assignment, request, pure=False, priority=-request.index
        )
        self._asked[asked.key] = asked  # The scheduler forgets what nobody holds.
        asked.add_done_callback(lambda done: self._answered(done, answer))
        return answer

    def _answered(self, done: Any, answer: "Future[Any]") -> None:
        self._asked.pop(done.key, None)
        if done.status == "finished":
            answer.set_result(done.result())
        elif done.status == "error":
            answer.set_exception(self._told(done.exception()))
        else:
            answer.set_exception(_scheduler_gone(self._address))

    def _told(self, error: BaseException) -> BaseException:
        from distributed.scheduler import KilledWorker

        if isinstance(error, KilledWorker):
            return WorkerLost()
        causes = [type(cause).__name__ for cause in (error, error.__cause__) if cause is not None]
        if any(name in _IN_SOURCES for name in causes):
            why = str(error.__cause__ or error).splitlines()[0]
            return WorkersGone(f"the workers of {self._address} do not run the Mansion of this command ({why})")
        return error


def attempt_on_worker(version: str, assignment: Assignment, request: WorldRequest) -> Outcome:
    """Run an attempt on a worker.

    A worker that the scheduler gave up may be alive and at the same attempt: it holds the lock of the building's
    folder, and what it leaves is taken.

    Raises
    ------
    MansionError
        ``CONFLICT`` for another version of Mansion than the command has, ``UNAVAILABLE`` where the worker does not see
        the folder of the world.
    WorkerLost
        When the other one does not end.
    """
    where = socket.gethostname()
    if version != __version__:
        raise MansionError(
            ErrorCode.CONFLICT,
            f"the worker on {where} has Mansion {__version__}, the command {version}; use the same version",
        )
    if not assignment.world.path.is_dir():
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            f"the worker on {where} does not see {assignment.world.path}; name a folder that all machines share",
        )
    for _ in range(_MOST_WAITS):
        try:
            return attempt_building(assignment, request)
        except MansionError as error:
            if error.code != ErrorCode.CONFLICT:
                raise
        time.sleep(_BUSY)
    raise WorkerLost
