"""Detect which processes behind a graph's endpoints have ended, without delay where they ran on this machine.

Discovery knows a killed process until its lease ends, and the lease must be long: where a busy machine lets a
participant miss the announcements of another for that time, Fast DDS drops it and may never match all of its endpoints
again. Fast DDS writes into the GUID of a participant which host (bytes 2 and 3) and which process (the lower 16 bits of
its id, bytes 4 and 5) it belongs to; other middlewares do not, and nothing is concluded there.
"""

from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Final, NamedTuple

__all__ = ["PeerProcesses"]

PROC: Final = Path("/proc")
LOW_BITS: Final = 1 << 16

HOST: Final = slice(0, 4)
"""The vendor and the host in a GUID."""

PROCESS: Final = slice(4, 6)

PARTICIPANT: Final = slice(0, 12)
"""What the GUIDs of all endpoints of a participant have in common."""


class Process(NamedTuple):
    """A process of this machine; its start tells it from a later one with the same id."""

    pid: int
    start: str


class PeerProcesses:
    """The processes of endpoints, noted while they run, so that their end is seen.

    An endpoint counts as ended only when a process that fits it ran when its participant was noted and none of those
    runs any more: a process in another container or on another machine is left to discovery.

    Parameters
    ----------
    own : callable
        Returns the GUID of an endpoint of this process, or None while there is none.
    pid : int
        Id of this process.
    proc : Path
        The process file system; where it is none, no process is noted.
    """

    def __init__(self, own: Callable[[], bytes | None], pid: int, proc: Path = PROC) -> None:
        self._own, self._pid, self._proc = own, pid, proc
        self._host: bytes | None = None
        self._noted: dict[bytes, frozenset[Process]] = {}

    def note(self, endpoints: Iterable[bytes]) -> None:
        """Remember which processes fit the participants that are seen for the first time."""
        for participant in {endpoint[PARTICIPANT] for endpoint in endpoints} - self._noted.keys():
            if (host := self._known_host()) is not None:
                self._noted[participant] = frozenset(self._fitting(participant) if participant[HOST] == host else ())

    def ended(self, endpoint: bytes) -> bool:
        """Whether a process that fitted this endpoint ran once, and none of them does now."""
        noted = self._noted.get(endpoint[PARTICIPANT], frozenset())
        return bool(noted) and not any(_running(process.pid, self._proc) == process for process in noted)

    def _known_host(self) -> bytes | None:
        """Return how the middleware writes this host, which is empty when it writes no process ids; None as yet."""
        if self._host is None and (own := self._own()) is not None:
            self._host = own[HOST] if own[PROCESS] == _low_bits(self._pid) else b""
        return self._host

    def _fitting(self, participant: bytes) -> Iterator[Process]:
        first = int.from_bytes(participant[PROCESS], "little")
        for pid in range(first, _last_pid(self._proc) + 1, LOW_BITS):
            if (process := _running(pid, self._proc)) is not None:
                yield process


def _low_bits(pid: int) -> bytes:
    return (pid % LOW_BITS).to_bytes(2, "little")


def _last_pid(proc: Path) -> int:
    try:
        return int((proc / "sys/kernel/pid_max").read_text())
    except (OSError, ValueError):
        return -1


def _running(pid: int, proc: Path) -> Process | None:
    """Return the process of this id; None when there is none, or it only waits for its parent."""
    try:
        fields = (proc / str(pid) / "stat").read_text(errors="replace").rpartition(")")[2].split()
    except OSError:
        return None
    # proc(5): the third field of the line, the first behind the name, is the state; the 22nd is the start.
    state, start = fields[0], fields[19]
    return None if state in "ZX" else Process(pid, start)
