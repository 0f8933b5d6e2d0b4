"""A world as WebDataset shards: plain tar files in which the files of a building follow each other under one key.

A sample is a building. Its key is the building's index in six digits, and what follows the first dot of a file's name
is its field: ``000012.json`` says everything that the manifest does of the building, and which field is which file of
its folder.
"""

import hashlib
import io
import tarfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final

import msgspec

from mansion_msgs_py.building_folder import file_in
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import decode_from, write_atomic
from mansion_world.atomic_folder import atomic_folder
from mansion_world.building_measures import folder_digest, is_hashed
from mansion_world.data_card import Shard, data_card
from mansion_world.records import BuildingRow, Record, RoomRow, Split, TaskRow
from mansion_world.world_folder import WorldFolder

__all__ = ["Sample", "pack_world", "unpack_building"]

_BLOCK: Final = 512
"""Bytes to which tar fills up a header and a file."""


class Sample(msgspec.Struct, frozen=True, kw_only=True):
    """The content of a sample's ``json``.

    Attributes
    ----------
    building, rooms, tasks : BuildingRow, list of RoomRow, list of TaskRow
        Its rows of the manifest.
    files : dict of str to str
        Field of the sample -> path in the building's folder.
    """

    building: BuildingRow
    rooms: list[RoomRow]
    tasks: list[TaskRow]
    files: dict[str, str]


def pack_world(
    world: WorldFolder, output: Path, *, shard_bytes: int, report: Callable[[int], None] = lambda buildings: None
) -> list[Shard]:
    """Write the shards of a world, its manifest and a data card into a folder, which appears whole or not at all.

    Parameters
    ----------
    shard_bytes : int
        No shard is greater, but for one of a single building that is.
    report : callable
        Gets the number of buildings after each.

    Raises
    ------
    MansionError
        ``CONFLICT`` for a folder that holds something, ``NOT_FOUND`` without a world, ``INVALID_PAYLOAD`` for a
        building that is not as it was written.
    """
    world.index()
    with atomic_folder(output) as folder:
        shards = _write_shards(world, folder, shard_bytes, report)
        for file in sorted((world.path / "manifest").iterdir()):
            write_atomic(folder / "manifest" / file.name, file.read_bytes())
        write_atomic(folder / "README.md", data_card(world, shards).encode())
    return shards


def _write_shards(world: WorldFolder, output: Path, shard_bytes: int, report: Callable[[int], None]) -> list[Shard]:
    shards: list[Shard] = []
    latest: dict[Split, Shard] = {}
    for count, record in enumerate(world.records(), start=1):
        members = _members(world, record)
        size = sum(_padded(len(data)) for _, data in members)
        shard = latest.get(record.building.split)
        if shard is None or shard.bytes + size + 2 * _BLOCK > shard_bytes:
            shard = _begin(record.building.split, shards)
            latest[shard.split] = shard
        _append(output / shard.name, members)
        shard.samples, shard.bytes = shard.samples + 1, shard.bytes + size
        report(count)
    for shard in shards:
        _end(output / shard.name, shard)
    return shards


def _begin(split: Split, shards: list[Shard]) -> Shard:
    number = sum(shard.split == split for shard in shards)
    shards.append(Shard(f"{split}-{number:06d}.tar", split))
    return shards[-1]


def _members(world: WorldFolder, record: Record) -> list[tuple[str, bytes]]:
    """Return names and contents of the files of a sample."""
    row = record.building
    folder = world.path / row.path
    if not folder.is_dir() or folder_digest(folder)[0] != row.sha256:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, f"{folder} has changed since it was written; `mansion world check` shows where"
        )
    files = {name.replace("/", "."): name for name in _names(folder)}
    sample = Sample(building=row, rooms=record.rooms, tasks=record.tasks, files=files)
    key = f"{row.index:06d}"
    contents = [(f"{key}.{field}", (folder / name).read_bytes()) for field, name in files.items()]
    return [(f"{key}.json", encode_bytes(sample)), *contents]


def _names(folder: Path) -> Iterator[str]:
    for file in sorted(path for path in folder.rglob("*") if path.is_file()):
        name = file.relative_to(folder).as_posix()
        if is_hashed(name):
            yield name


def _padded(size: int) -> int:
    return _BLOCK + -(-size // _BLOCK) * _BLOCK


def _append(file: Path, members: list[tuple[str, bytes]]) -> None:
    """Append files to a tar file that has no end yet, all with the same owner and date."""
    with file.open("ab") as shard:
        for name, data in members:
            entry = tarfile.TarInfo(name)
            entry.size = len(data)
            shard.write(entry.tobuf(tarfile.USTAR_FORMAT))
            shard.write(data)
            shard.write(bytes(-len(data) % _BLOCK))


def _end(file: Path, shard: Shard) -> None:
    with file.open("ab") as tail:
        tail.write(bytes(2 * _BLOCK))
    shard.bytes += 2 * _BLOCK
    with file.open("rb") as whole:
        shard.sha256 = hashlib.file_digest(whole, "sha256").hexdigest()


def unpack_building(shard: Path, index: int, folder: Path) -> BuildingRow:
    """Write a building of a shard into a folder, as it was in its world.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when the shard does not hold it, ``CONFLICT`` when `folder` exists.
    """
    if folder.exists():
        raise MansionError(ErrorCode.CONFLICT, f"{folder} exists; name a new folder")
    key = f"{index:06d}"
    with tarfile.open(shard) as members:
        fields = {member.name.partition(".")[2]: member for member in members if member.name.partition(".")[0] == key}
        if "json" not in fields:
            raise MansionError(ErrorCode.NOT_FOUND, f"{shard} has no building {index}")
        sample = decode_from(Sample, _content(members, fields["json"]), f"{shard}:{key}.json")
        for name, path in sample.files.items():
            write_atomic(file_in(folder, path), _content(members, fields[name]))
    return sample.building


def _content(members: tarfile.TarFile, entry: tarfile.TarInfo) -> bytes:
    return (members.extractfile(entry) or io.BytesIO()).read()
