"""Remove the shared memory that killed nodes leave behind, and nobody else's.

Fast DDS gives a participant a segment ``fastrtps_<16 hexadecimal digits>`` in /dev/shm, and each port that it reads a
segment ``fastrtps_port<number>`` with a semaphore. Beside each segment lies a lock file, ``_el`` (exclusive) or ``_sl``
(shared by the readers of a multicast port), which its owner holds with flock(2) while it lives. A process that is
killed leaves all of them.

A `SegmentLedger` notes what the processes of one supervisor own, and removes it once they are dead. Its file outlives
the supervisor: after a SIGKILL of them all, `remove_left_behind` follows it at the next start. The names of ports are
used again, so a file counts as noted only with the same device, inode and time of modification.
"""

import contextlib
import fcntl
import itertools
import os
import re
import stat
import tempfile
import time
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Annotated, Final

import msgspec

from mansion_msgs_py.codec import prepared

__all__ = ["FileId", "Segment", "SegmentLedger", "ledger_folders", "remove_left_behind"]

SHM: Final = Path("/dev/shm")
PREFIX: Final = "fastrtps_"
SUFFIXES: Final = ("_el", "_sl")

LOCK_FILE: Final = re.compile(r"(fastrtps_(?:[0-9a-f]{16}|port[0-9]+))(_el|_sl)")
PORT: Final = re.compile(r"fastrtps_port[0-9]+")
MAPPING: Final = re.compile(r"(?:\S+ +){4}(\d+) +.*/(fastrtps_\w+)(?: \(deleted\))?")
"""A line of /proc/PID/maps: the inode and the name of a segment."""

LEDGER: Final = re.compile(r"([0-9]+)-([0-9]+)-[0-9]+\.json(?:\.new)?")
"""Process id and start time of the supervisor, and the number of the ledger in it."""

SETTLING: Final = 2.0
"""Seconds after which a process that makes a port surely has it in its memory."""

_numbers = itertools.count()


class FileId(msgspec.Struct, frozen=True, array_like=True):
    """What tells a file from a later one of the same name; `modified` is in nanoseconds."""

    device: int
    inode: int
    modified: int


class Segment(msgspec.Struct, frozen=True):
    """A segment that a process owns, or a port that it writes to and nobody reads.

    Attributes
    ----------
    name : str
        In /dev/shm.
    memory : FileId, optional
        The segment itself; None before it is made.
    lock : FileId, optional
        Its lock file; None where there is none.
    suffix : str
        That of the lock file.
    """

    name: Annotated[str, msgspec.Meta(pattern=r"^fastrtps_([0-9a-f]{16}|port[0-9]+)\Z")]
    memory: FileId | None = None
    lock: FileId | None = None
    suffix: Annotated[str, msgspec.Meta(pattern=r"^_[es]l\Z")] = "_el"


class SegmentLedger:
    """The segments that the processes of this supervisor own, in memory and in a file.

    Parameters
    ----------
    shm : Path
        The folder of the segments.
    folders : sequence of Path, optional
        Where the file may lie: the first that is private to the user, or can be made so. `ledger_folders` when absent.
    """

    def __init__(self, shm: Path = SHM, folders: Sequence[Path] | None = None) -> None:
        self._shm = shm.resolve()
        self._folders = folders
        self._name = f"{os.getpid()}-{_start_time(os.getpid()) or 0}-{next(_numbers)}.json"
        self._file: Path | None = None
        self._noted: set[Segment] = set()
        self._seen: set[Segment] = set()
        self._looked = -float("inf")

    @property
    def names(self) -> frozenset[str]:
        """The noted segments."""
        return frozenset(segment.name for segment in self._noted)

    def note(self, pids: Iterable[int], interval: float = 0.0) -> None:
        """Note what these processes own now.

        Parameters
        ----------
        pids : iterable of int
            Running children that the caller has not waited for, so that no id is another's by now; the caller's own
            id, if it makes segments too.
        interval : float
            Seconds since the last look before which this does nothing.
        """
        now = time.monotonic()
        if now - self._looked < interval:
            return
        self._looked = now
        if not (names := _segment_files(self._shm)):
            return
        unread = _unread_ports(names, self._shm)
        found: set[Segment] = set()
        for pid in pids:
            found.update(_owned(pid, self._shm))
            if new := unread - self._seen:
                found.update(_written(pid, new))
        self._seen = {port for port in unread if _is_settled(port)}
        if not found <= self._noted or (found and not self._is_saved()):
            self._noted = {segment for segment in self._noted | found if _remains(segment, self._shm)}
            self._save()

    def remove_dead(self) -> list[str]:
        """Remove each noted segment that no process uses; delete the ledger when none is left in it.

        Returns
        -------
        list of str
            The names of the removed segments, sorted.
        """
        removed, self._noted = _remove_unused(self._noted, self._shm)
        self._save()
        return removed

    def _is_saved(self) -> bool:
        return self._file is not None and self._file.exists()

    def _save(self) -> None:
        if self._file is None and self._noted:
            folders = ledger_folders() if self._folders is None else self._folders
            folder = next((folder for folder in folders if _is_private(folder, make=True)), None)
            self._file = folder and folder / self._name
        if self._file is not None:
            _write(self._file, self._noted)


def remove_left_behind(shm: Path = SHM, folders: Sequence[Path] | None = None) -> list[str]:
    """Remove what is in the ledgers of supervisors that are dead, as `SegmentLedger.remove_dead` does.

    Parameters
    ----------
    shm : Path
        The folder of the segments.
    folders : sequence of Path, optional
        Those of the ledgers. `ledger_folders` when absent.

    Returns
    -------
    list of str
        The names of the removed segments, sorted within each ledger.
    """
    shm = shm.resolve()
    names: list[str] = []
    if _segment_files(shm):
        for folder in ledger_folders() if folders is None else folders:
            for file in _ledgers_of_the_dead(folder):
                removed, left = _remove_unused(_read(file), shm)
                _write(file, left)
                names += removed
    return names


def ledger_folders() -> tuple[Path, ...]:
    """Return where this user's ledgers may lie, the preferred folder first."""
    temporary = Path(tempfile.gettempdir()) / f"mansion-segments-{os.geteuid()}"
    runtime = os.environ.get("XDG_RUNTIME_DIR")
    return (Path(runtime) / "mansion-segments", temporary) if runtime else (temporary,)


def _segment_files(shm: Path) -> set[str]:
    """Return the names of all files of Fast DDS, whoever owns them."""
    try:
        return {name for name in os.listdir(shm) if name.startswith(PREFIX)}
    except OSError:
        return set()


def _file_id(status: os.stat_result) -> FileId | None:
    """Return the identity of a file; None for another user's, and for anything but a plain file."""
    if status.st_uid != os.geteuid() or not stat.S_ISREG(status.st_mode):
        return None
    return FileId(status.st_dev, status.st_ino, status.st_mtime_ns)


def _id_at(path: Path) -> FileId | None:
    try:
        return _file_id(path.lstat())
    except OSError:
        return None


def _owned(pid: int, shm: Path) -> Iterator[Segment]:
    """Yield the segments whose locks the process holds."""
    with contextlib.suppress(OSError):
        for descriptor in os.listdir(f"/proc/{pid}/fd"):
            if (segment := _locked_by(pid, descriptor, shm)) is not None:
                yield segment


def _locked_by(pid: int, descriptor: str, shm: Path) -> Segment | None:
    """Return the segment whose lock this descriptor holds; None for one that is merely open."""
    entry = f"/proc/{pid}/fd/{descriptor}"
    with contextlib.suppress(OSError):
        folder, _, name = os.readlink(entry).rpartition("/")
        match = LOCK_FILE.fullmatch(name)
        if match is None or folder != str(shm):
            return None
        # Linux lists the locks of this very open file, not all those of the inode.
        lines = Path(f"/proc/{pid}/fdinfo/{descriptor}").read_text().splitlines()
        lock = _file_id(os.stat(entry))
        if lock is not None and any(line.startswith("lock:") and " FLOCK " in line for line in lines):
            return Segment(match[1], _id_at(shm / match[1]), lock, match[2])
    return None


def _unread_ports(names: set[str], shm: Path) -> set[Segment]:
    """Return the ports among `names` that have no lock file.

    Fast DDS recreates the port of a peer that was killed, without a lock, while it still sends to that peer.
    """
    ports = [name for name in names if PORT.fullmatch(name) and not names & {name + suffix for suffix in SUFFIXES}]
    return {Segment(name, memory) for name in ports if (memory := _id_at(shm / name)) is not None}


def _is_settled(port: Segment) -> bool:
    return port.memory is not None and time.time() - port.memory.modified / 1e9 > SETTLING


def _written(pid: int, ports: set[Segment]) -> Iterator[Segment]:
    """Yield the ports that the process has in its memory."""
    mapped = _mapped(pid)
    return (port for port in ports if port.memory is not None and (port.name, port.memory.inode) in mapped)


def _mapped(pid: int) -> set[tuple[str, int]]:
    """Return name and inode of each segment in the memory of the process; none if it cannot be read."""
    try:
        with open(f"/proc/{pid}/maps", errors="replace") as lines:
            found = [MAPPING.fullmatch(line.rstrip("\n")) for line in lines if PREFIX in line]
    except OSError:
        return set()
    return {(match[2], int(match[1])) for match in found if match}


def _remains(segment: Segment, shm: Path) -> bool:
    """Whether the noted segment or its lock file is still there, rather than another of that name."""
    memory, lock = _id_at(shm / segment.name), _id_at(shm / (segment.name + segment.suffix))
    return (memory is not None and memory == segment.memory) or (lock is not None and lock == segment.lock)


def _remove_unused(segments: set[Segment], shm: Path) -> tuple[list[str], set[Segment]]:
    """Remove the segments that no process uses; return the names of these, and those that are left."""
    removed: set[str] = set()
    left: set[Segment] = set()
    for segment in segments:
        if _remains(segment, shm):
            if _remove(segment, shm):
                removed.add(segment.name)
            else:
                left.add(segment)
    return sorted(removed), {segment for segment in left if _remains(segment, shm)}


def _remove(segment: Segment, shm: Path) -> bool:
    """Remove the segment, its semaphore and its lock file while holding the lock; False if it is in use."""
    memory, lock = shm / segment.name, shm / (segment.name + segment.suffix)
    locks = [shm / (segment.name + suffix) for suffix in SUFFIXES]
    unlocked = not any(map(os.path.lexists, locks))
    if not _is_writable_by_owner_only(memory) if unlocked else segment.lock is None:
        return False
    descriptor = _take(lock, None if unlocked else segment.lock)
    if descriptor is None:
        return False
    try:
        noted = segment.memory
        changed = noted is not None and os.path.lexists(memory) and _id_at(memory) != noted
        if unlocked and (changed or _is_mapped(segment) or all(map(os.path.lexists, locks))):
            lock.unlink(missing_ok=True)
        elif not changed:
            # The lock file comes last: whoever finds none may recreate the port.
            for path in (memory, shm / f"sem.{segment.name}_mutex", lock):
                if _id_at(path) is not None:
                    path.unlink(missing_ok=True)
            return True
    except OSError:
        pass
    finally:
        os.close(descriptor)
    return False


def _take(lock: Path, known: FileId | None) -> int | None:
    """Lock the known lock file, or a new one if None; return its descriptor, or None where that cannot be done.

    A new one keeps readers from the segment, as Fast DDS itself does when it looks whether a port's reader is dead.
    """
    made = os.O_CREAT | os.O_EXCL if known is None else 0
    try:
        descriptor = os.open(lock, os.O_RDONLY | os.O_CLOEXEC | os.O_NOFOLLOW | made, 0o666)
    except OSError:
        return None
    with contextlib.suppress(OSError):
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        # Between open and lock, the file may have been removed or replaced.
        if _id_at(lock) == _file_id(os.fstat(descriptor)) and (made or _id_at(lock) == known):
            return descriptor
    os.close(descriptor)
    return None


def _is_writable_by_owner_only(memory: Path) -> bool:
    """Whether no other user's process, whose memory cannot be read, can have mapped the segment."""
    try:
        return not memory.lstat().st_mode & 0o022
    except OSError:
        return True


def _is_mapped(segment: Segment) -> bool:
    """Whether a process has the segment in its memory."""
    if segment.memory is None:
        return False
    wanted = (segment.name, segment.memory.inode)
    return any(wanted in _mapped(int(pid)) for pid in os.listdir("/proc") if pid.isdecimal())


def _start_time(pid: int) -> int | None:
    """Return when the process started, in clock ticks since boot; None if it is dead."""
    try:
        fields = Path(f"/proc/{pid}/stat").read_text(errors="replace").rpartition(")")[2].split()
    except OSError:
        return None
    return None if fields[0] in ("Z", "X") else int(fields[19])


def _is_private(folder: Path, *, make: bool = False) -> bool:
    """Whether only this user can read and write the folder."""
    if make:
        with contextlib.suppress(OSError):
            folder.mkdir(mode=0o700)
    try:
        status = folder.lstat()
    except OSError:
        return False
    return stat.S_ISDIR(status.st_mode) and status.st_uid == os.geteuid() and not status.st_mode & 0o077


def _ledgers_of_the_dead(folder: Path) -> list[Path]:
    """Return the ledgers in the folder whose supervisors no longer run."""
    files = sorted(folder.iterdir()) if _is_private(folder) else []
    matches = [(file, LEDGER.fullmatch(file.name)) for file in files]
    return [file for file, match in matches if match and _start_time(int(match[1])) != int(match[2])]


def _read(file: Path) -> set[Segment]:
    """Return the segments of a ledger; none if it is gone or not whole."""
    try:
        return msgspec.json.decode(file.read_bytes(), type=prepared(set[Segment]))
    except (OSError, msgspec.DecodeError):
        return set()


def _write(file: Path, segments: set[Segment]) -> None:
    """Replace the ledger in one step, or delete it if there are no segments. A full disk does not stop the graph."""
    new = file.with_name(file.name + ".new")
    with contextlib.suppress(OSError):
        if segments:
            new.write_bytes(msgspec.json.encode(sorted(segments, key=lambda segment: segment.name)))
            new.replace(file)
        else:
            new.unlink(missing_ok=True)
            file.unlink(missing_ok=True)
