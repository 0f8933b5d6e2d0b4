"""The folder of a world.

``world.json``              what all follows from: seed, mixture, versions
``buildings/000/000012/``   a building folder
``records/000/000012.json`` its record, written last: without it a building is not there
``set_aside/``              requests that came to nothing, with the reason
``manifest/``               ``buildings.jsonl``, ``rooms.jsonl`` and ``tasks.jsonl``, made from the records
``work/``                   what is being built
"""

import fcntl
import shutil
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Final, TypeAlias, TypeVar, cast

import msgspec

from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import decode_from, read_payload, write_atomic
from mansion_world.records import BuildingRow, Record, RoomRow, SetAside, TaskRow, WorldIndex

Row: TypeAlias = BuildingRow | RoomRow | TaskRow

__all__ = ["TABLES", "WorldFolder", "building_path", "table_rows"]

TABLES: Final[Mapping[str, type[Row]]] = {"buildings": BuildingRow, "rooms": RoomRow, "tasks": TaskRow}
"""The tables of the manifest."""

_INDEX: Final = "world.json"
_SHARD: Final = 1000

T = TypeVar("T")


def building_path(index: int, name: str = "") -> str:
    """Return the folder of a building, relative to the world's.

    Examples
    --------
    >>> building_path(1234), building_path(2, "office")
    ('buildings/001/001234', 'buildings/office')
    """
    return f"buildings/{name or _shard(index)}"


def _shard(index: int) -> str:
    return f"{index // _SHARD:03d}/{index:06d}"


class WorldFolder:
    """The files of a world.

    Parameters
    ----------
    path : Path or str
    """

    def __init__(self, path: Path | str) -> None:
        self.path = Path(path)

    def index(self) -> WorldIndex:
        """Return what the world follows from; ``NOT_FOUND`` where there is no world."""
        return read_payload(WorldIndex, self.path / _INDEX, "a folder that `mansion world make` wrote")

    def adopt(self, index: WorldIndex) -> None:
        """Begin a world, or continue one.

        Raises
        ------
        MansionError
            ``CONFLICT`` for a folder that holds another world or something else.
        """
        if (self.path / _INDEX).exists():
            if self.index() != index:
                raise MansionError(
                    ErrorCode.CONFLICT,
                    f"{self.path} holds a world of another seed, mixture, number of tasks or version; "
                    "name another folder",
                )
            return
        if {entry.name for entry in self.path.iterdir()} - {".lock"}:
            raise MansionError(ErrorCode.CONFLICT, f"{self.path} holds other files; name a new or empty folder")
        write_atomic(self.path / _INDEX, encode_bytes(index, indent=1))

    @contextmanager
    def locked(self) -> Iterator[None]:
        """Make the folder and keep others from writing to it; ``CONFLICT`` where another does."""
        self.path.mkdir(parents=True, exist_ok=True)
        with (self.path / ".lock").open("w") as lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                raise MansionError(ErrorCode.CONFLICT, f"another command is making {self.path}") from None
            yield

    def building(self, index: int) -> Path:
        """Return the folder of a building."""
        return self.path / building_path(index)

    def work(self, index: int, attempt: int) -> Path:
        """Return the folder in which an attempt is built."""
        return self.path / "work" / f"{index:06d}-{attempt}"

    def record(self, index: int) -> Record | None:
        """Return the record of a building, ``None`` where it is not finished or the record is damaged."""
        return _read(Record, self._record_file(index))

    def records(self) -> Iterator[Record]:
        """Yield the records by ascending index, one in memory at a time."""
        for file in sorted((self.path / "records").glob("*/*.json")):
            yield read_payload(Record, file)

    def built(self, index: int, attempt: int) -> Record | None:
        """Return the record of an attempt that is built but has no place in the world yet."""
        return _read(Record, self._built_file(index, attempt))

    def save_built(self, record: Record) -> None:
        """Say that an attempt is built, checked and measured."""
        row = record.building
        write_atomic(self._built_file(row.index, row.attempt), encode_bytes(record))

    def settle(self, record: Record) -> None:
        """Give an attempt its place in the world."""
        row = record.building
        target = self.path / row.path
        shutil.rmtree(target, ignore_errors=True)
        target.parent.mkdir(parents=True, exist_ok=True)
        self.work(row.index, row.attempt).rename(target)
        write_atomic(self._record_file(row.index), encode_bytes(record))
        self._built_file(row.index, row.attempt).unlink(missing_ok=True)

    def take_over(self, record: Record, folder: Path) -> None:
        """Copy a building of another world to its place in this one."""
        shutil.copytree(folder, self.building(record.building.index))
        write_atomic(self._record_file(record.building.index), encode_bytes(record))

    def discard(self, index: int, attempt: int) -> None:
        """Remove what is left of an attempt."""
        self._built_file(index, attempt).unlink(missing_ok=True)
        work = self.work(index, attempt)
        shutil.rmtree(work, ignore_errors=True)
        shutil.rmtree(work.with_name(f".{work.name}.partial"), ignore_errors=True)

    def forget(self, record: Record) -> None:
        """Take a building out of the world, to build it again."""
        self._record_file(record.building.index).unlink(missing_ok=True)
        shutil.rmtree(self.path / record.building.path, ignore_errors=True)

    def set_aside(self, entry: SetAside) -> None:
        """Record a request that was given up, and remove what is left of it."""
        request = entry.request
        write_atomic(self._aside_file(request.index, request.attempt), encode_bytes(entry, indent=1))
        self.discard(request.index, request.attempt)

    def set_aside_at(self, index: int, attempt: int) -> SetAside | None:
        """Return the record of an attempt that was given up, ``None`` where it was not."""
        return _read(SetAside, self._aside_file(index, attempt))

    def move_records(self, indices: Mapping[str, int]) -> None:
        """Give the records of buildings the indices that are stated for their paths, and drop all others."""
        found = list(self.records())
        moved = [record for record in found if indices.get(record.building.path) != record.building.index]
        for record in moved:
            self._record_file(record.building.index).unlink()
        for record in moved:
            index = indices.get(record.building.path)
            if index is not None:
                write_atomic(self._record_file(index), encode_bytes(_at_index(record, index)))

    def aside(self) -> Iterator[SetAside]:
        """Yield what was set aside, by index and attempt."""
        for file in sorted((self.path / "set_aside").glob("*.json")):
            yield read_payload(SetAside, file)

    def buildings(self) -> Iterator[BuildingRow]:
        """Yield the rows of the buildings by ascending index."""
        for record in self.records():
            yield record.building

    def write_manifest(self) -> None:
        """Write the tables of the manifest from the records as JSON lines; other forms of it are out of date then."""
        folder = self.path / "manifest"
        folder.mkdir(exist_ok=True)
        fresh = {name: self.table(name).with_name(f".{name}.jsonl") for name in TABLES}
        with ExitStack() as stack:
            files = {name: stack.enter_context(file.open("wb")) for name, file in fresh.items()}
            for record in self.records():
                for name, rows in table_rows(record).items():
                    files[name].writelines(encode_bytes(row) + b"\n" for row in rows)
        for name, file in fresh.items():
            self.table(name).with_suffix(".parquet").unlink(missing_ok=True)
            file.rename(self.table(name))

    def table(self, name: str) -> Path:
        """Return the file of a table of the manifest."""
        return self.path / "manifest" / f"{name}.jsonl"

    def rows(self, name: str) -> Iterator[Row]:
        """Yield the rows of a table of the manifest, one in memory at a time.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` where there is none.
        """
        file = self.table(name)
        if not file.is_file():
            raise MansionError(ErrorCode.NOT_FOUND, f"{file} is missing; `mansion world make` writes it at its end")
        with file.open("rb") as lines:
            for line in lines:
                yield decode_from(TABLES[name], line, file)

    def manifest(self) -> Iterator[BuildingRow]:
        """Yield the rows of the manifest's table of buildings; raises as `rows` does."""
        return cast(Iterator[BuildingRow], self.rows("buildings"))

    def _record_file(self, index: int) -> Path:
        return self.path / "records" / f"{_shard(index)}.json"

    def _built_file(self, index: int, attempt: int) -> Path:
        return self.path / "work" / f"{index:06d}-{attempt}.json"

    def _aside_file(self, index: int, attempt: int) -> Path:
        return self.path / "set_aside" / f"{index:06d}-{attempt}.json"


def table_rows(record: Record) -> dict[str, Sequence[Row]]:
    """Return the rows that a record adds to each table."""
    return {"buildings": [record.building], "rooms": record.rooms, "tasks": record.tasks}


def _at_index(record: Record, index: int) -> Record:
    return msgspec.structs.replace(
        record,
        building=msgspec.structs.replace(record.building, index=index),
        rooms=[msgspec.structs.replace(room, index=index) for room in record.rooms],
        tasks=[msgspec.structs.replace(task, index=index) for task in record.tasks],
    )


def _read(kind: type[T], file: Path) -> T | None:
    """Return what a file holds, ``None`` where it is missing or holds something else: it is then made again."""
    try:
        return read_payload(kind, file)
    except MansionError:
        return None
