"""The joining of worlds that were made separately.

Buildings keep their folders' contents, their ids and, where no other world has it, their index; a world whose indices
are taken gets the next ones. Splits are drawn again with the seed of the first world, so that requests in the same
words are in one split, whichever world they come from.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from msgspec.structs import replace

from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic
from mansion_world.atomic_folder import atomic_folder
from mansion_world.building_measures import folder_digest, split_of
from mansion_world.near_duplicates import nearly_the_same
from mansion_world.records import BuildingRow, Record, SetAside, WorldSource
from mansion_world.world_folder import WorldFolder, building_path

__all__ = ["Merged", "merge_worlds"]


@dataclass
class Merged:
    """What came of a merge.

    Attributes
    ----------
    buildings : int
    dropped : list of str
        A line for each building that was left out.
    """

    buildings: int = 0
    dropped: list[str] = field(default_factory=list)


@dataclass
class _Merge:
    """The state of a merge: the world that is written, and what of its buildings later ones are compared with."""

    world: WorldFolder
    split_seed: int
    result: Merged
    hashes: dict[str, str] = field(default_factory=dict)
    graphs: dict[str, list[int]] = field(default_factory=dict)
    taken: set[int] = field(default_factory=set)
    asides: set[tuple[str, int]] = field(default_factory=set)


def merge_worlds(
    folders: Sequence[Path], output: Path, report: Callable[[int], None] = lambda buildings: None
) -> Merged:
    """Join worlds into a new folder, which appears whole or not at all.

    Parameters
    ----------
    folders : sequence of Path
        In this order; of two buildings that are the same, or nearly, the first one stays.
    report : callable
        Gets the number of buildings after each.

    Raises
    ------
    MansionError
        ``CONFLICT`` when two different buildings have the same id, as worlds of the same seed and different mixtures
        have, or when `output` holds something; ``INVALID_PAYLOAD`` for a building that is not as it was written.
    """
    worlds = [WorldFolder(folder) for folder in folders]
    sources = [source for world in worlds for source in _sources(world)]
    with atomic_folder(output) as folder:
        merge = _Merge(WorldFolder(folder), sources[0].seed, Merged())
        write_atomic(folder / "world.json", encode_bytes(replace(worlds[0].index(), sources=sources), indent=1))
        for world in worlds:
            _add_world(merge, world, report)
        merge.world.write_manifest()
    return merge.result


def _sources(world: WorldFolder) -> list[WorldSource]:
    index = world.index()
    count = sum(1 for _ in world.records())
    own = WorldSource(seed=index.seed, mix=index.mix, versions=index.versions, tasks=index.tasks, buildings=count)
    return index.sources or [own]


def _add_world(merge: _Merge, world: WorldFolder, report: Callable[[int], None]) -> None:
    asides = [entry for entry in world.aside() if _place(entry) not in merge.asides]
    new = {record.building.index for record in world.records() if not _is_there(merge, world, record.building)}
    new.update(entry.request.index for entry in asides)
    shift = 0 if merge.taken.isdisjoint(new) else max(merge.taken) + 1 - min(new)
    merge.taken.update(index + shift for index in new)
    for entry in asides:
        merge.asides.add(_place(entry))
        merge.world.set_aside(replace(entry, request=replace(entry.request, index=entry.request.index + shift)))
    for record in world.records():
        if reason := _why_dropped(merge, record):
            merge.result.dropped.append(f"{world.path / record.building.path}: {reason}")
            continue
        _add_building(merge, world, record, record.building.index + shift)
        merge.result.buildings += 1
        report(merge.result.buildings)


def _place(entry: SetAside) -> tuple[str, int]:
    return entry.request.request.building_id or "", entry.request.attempt


def _is_there(merge: _Merge, world: WorldFolder, row: BuildingRow) -> bool:
    found = merge.hashes.get(row.id)
    if found not in (None, row.sha256):
        raise MansionError(
            ErrorCode.CONFLICT,
            f"{world.path / row.path}: another building is called {row.id}; "
            "worlds of one seed can be joined only when they have the same mixture, tasks and version",
        )
    return found is not None


def _why_dropped(merge: _Merge, record: Record) -> str:
    if record.building.id in merge.hashes:
        return f"{record.building.id} is there already"
    for index in merge.graphs.get(record.graph, []):
        other = merge.world.record(index)
        if other is not None and nearly_the_same(record.likeness, other.likeness):
            return f"nearly the same as {other.building.id}"
    return ""


def _add_building(merge: _Merge, world: WorldFolder, record: Record, index: int) -> None:
    row = record.building
    source = world.path / row.path
    if not source.is_dir() or folder_digest(source)[0] != row.sha256:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, f"{source} has changed since it was written; `mansion world check` shows where"
        )
    split = split_of(merge.split_seed, row.description)
    moved = replace(
        record,
        building=replace(row, index=index, path=building_path(index), split=split),
        rooms=[replace(room, index=index, split=split) for room in record.rooms],
        tasks=[replace(task, index=index, split=split) for task in record.tasks],
    )
    merge.world.take_over(moved, source)
    merge.hashes[row.id] = row.sha256
    merge.graphs.setdefault(record.graph, []).append(index)
