"""The folder that a build grows in before it takes its name, and that an interrupted build resumes from.

Beside ``out/office`` a build writes ``out/.office.partial``: the plan first, then each floor as it is done. When all is
there the folder is renamed. A later run of the same request takes over what it finds. Who writes holds
``out/.office.lock``.
"""

import shutil
from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from pathlib import Path
from types import TracebackType
from typing import Any, TypeVar

from mansion_bringup import __version__
from mansion_msgs_py.building_folder import EDIT_LOG, INDEX, STATE, floor_directory
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.file_locks import hold_lock
from mansion_msgs_py.files import remove_remains, write_atomic
from mansion_msgs_py.request import BuildRequest

__all__ = ["Workspace", "require_free_target"]

T = TypeVar("T")


class Workspace:
    """A build in progress towards `target`.

    Parameters
    ----------
    target : Path
        The folder to be; may hold an older building, which is replaced at the end.
    request : BuildRequest
    formats : sequence of str
        Names of the formats that the build writes; one that writes others starts afresh.
    force : bool
        Replace a building even if it was edited or robots have state in it.

    Raises
    ------
    MansionError
        ``CONFLICT`` as of `require_free_target`, or when another build is writing `target`.
    """

    def __init__(
        self, target: Path, request: BuildRequest, *, formats: Sequence[str] = (), force: bool = False
    ) -> None:
        self.target = _followed(target.absolute())
        self.partial = self.target.parent / f".{self.target.name}.partial"
        self._key = encode_bytes({"version": __version__, "request": request, "formats": formats})
        require_free_target(self.target, force=force)

    def __enter__(self) -> "Workspace":
        lock = self.target.parent / f".{self.target.name}.lock"
        with ExitStack() as stack:
            try:
                stack.enter_context(hold_lock(lock, f"another build is writing {self.target}", remove=True))
                self.partial.mkdir(parents=True, exist_ok=True)
                self._adopt()
            except OSError as error:
                raise MansionError(ErrorCode.UNAVAILABLE, f"cannot write to {self.partial}: {error.strerror}") from None
            self._locked = stack.pop_all()
        return self

    def _adopt(self) -> None:
        key = self.partial / "key.json"
        if key.is_file() and key.read_bytes() == self._key:
            return
        for entry in self.partial.iterdir():
            shutil.rmtree(entry) if entry.is_dir() else entry.unlink()
        write_atomic(key, self._key)

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._locked.close()

    def load(self, kind: type[T], path: str) -> T | None:
        """Return a payload that an earlier run left, or ``None``."""
        file = self.partial / path
        try:
            return decode(kind, file.read_bytes())
        except (OSError, MansionError):
            return None

    def save(self, path: str, payload: Any) -> None:
        """Keep a payload for a later run."""
        write_atomic(self.partial / path, encode_bytes(payload, indent=1))

    def write(self, files: Mapping[str, bytes]) -> None:
        """Write files by path relative to the building's folder; equal files are left alone."""
        for path, data in files.items():
            file = self.partial / path
            if not (path.startswith("meshes/") and file.is_file()):
                write_atomic(file, data)

    def floor_done(self, floor: int) -> bool:
        """Whether an earlier run finished this floor."""
        return (self.partial / floor_directory(floor) / ".done").is_file()

    def mark_floor(self, floor: int) -> None:
        """Say that all files of the floor are there."""
        write_atomic(self.partial / floor_directory(floor) / ".done", b"")

    def read(self, path: str) -> bytes:
        """Return the bytes of a file of the building in progress."""
        return (self.partial / path).read_bytes()

    def commit(self) -> Path:
        """Take away what only a build in progress needs, give the folder its name, and return it."""
        for name in ("plan.json", "key.json"):
            (self.partial / name).unlink(missing_ok=True)
        for marker in self.partial.glob("floors/*/.done"):
            marker.unlink()
        for folder in (self.partial, *filter(Path.is_dir, self.partial.rglob("*"))):
            remove_remains(folder)
        old = self.target.parent / f".{self.target.name}.old"
        shutil.rmtree(old, ignore_errors=True)
        if self.target.exists():
            self.target.rename(old)
        self.partial.rename(self.target)
        shutil.rmtree(old, ignore_errors=True)
        return self.target


def _followed(target: Path) -> Path:
    """Return where a link leads, which is not itself replaced by a folder; other paths as they are."""
    if not target.is_symlink():
        return target
    try:
        return target.resolve()
    except (OSError, RuntimeError):
        raise MansionError(ErrorCode.CONFLICT, f"{target} is a broken link; name a folder") from None


def require_free_target(target: Path, *, force: bool) -> None:
    """Refuse a folder that a build may not replace.

    Raises
    ------
    MansionError
        ``CONFLICT`` when it holds something else, or, without `force`, a building with what people or robots did in it.
    """
    if not target.exists():
        return
    if not target.is_dir():
        raise MansionError(ErrorCode.CONFLICT, f"{target} is a file; name a folder")
    entries = {entry.name for entry in target.iterdir()}
    if entries and INDEX not in entries:
        raise MansionError(
            ErrorCode.CONFLICT, f"{target} holds other files; name a new or empty folder, or one that holds a building"
        )
    if not force and (work := _work_in(target)):
        raise MansionError(
            ErrorCode.CONFLICT,
            f"{target} holds a building with {work}, which would be lost; "
            "name another folder to keep it, or use --force to replace it",
        )


def _work_in(building: Path) -> str:
    """Name what was done in a building since it was built; empty where nothing was."""
    done = []
    log = building / EDIT_LOG
    if log.is_file() and log.stat().st_size:
        done.append("edits")
    if (building / STATE).exists():
        done.append("the state of robots")
    return " and ".join(done)
