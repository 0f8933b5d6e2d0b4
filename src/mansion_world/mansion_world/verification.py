"""A whole world verified from its files."""

from collections.abc import Callable, Iterator
from pathlib import Path

from mansion_msgs_py.codec import encode_bytes
from mansion_world.attempts import Check
from mansion_world.measures import folder_digest
from mansion_world.world_folder import WorldFolder

__all__ = ["verify_world"]


def verify_world(
    folder: Path, check: Check, report: Callable[[int], None] = lambda buildings: None
) -> Iterator[tuple[str, str]]:
    """Yield every fault of a world, as the file or building and what is wrong with it.

    Verified are the manifest against the records, the files of each building against its hash, and each building by
    `check`.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when `folder` holds no world.
    """
    world = WorldFolder(folder)
    world.index()
    yield from _manifest_faults(world)
    for count, row in enumerate(world.buildings(), start=1):
        building = folder / row.path
        if not building.is_dir():
            yield row.path, "is missing"
        elif folder_digest(building)[0] != row.sha256:
            yield row.path, "is not as it was written: its files have another hash"
        else:
            yield from ((row.path, str(fault)) for fault in check(building))
        report(count)


def _manifest_faults(world: WorldFolder) -> Iterator[tuple[str, str]]:
    rows = (encode_bytes(row) for row in world.buildings())
    yield from _differences(world.path / "manifest" / "buildings.jsonl", rows)
    rooms = (encode_bytes(room) for record in world.records() for room in record.rooms)
    yield from _differences(world.path / "manifest" / "rooms.jsonl", rooms)


def _differences(file: Path, rows: Iterator[bytes]) -> Iterator[tuple[str, str]]:
    """Yield one fault where a table is missing or is not that of the records."""
    name = f"manifest/{file.name}"
    if not file.is_file():
        yield name, "is missing; `mansion world make` writes it"
        return
    with file.open("rb") as lines:
        for number, row in enumerate(rows, start=1):
            if lines.readline() != row + b"\n":
                yield name, f"line {number} is not what the records say"
                return
        if lines.readline():
            yield name, "has more rows than there are records"
