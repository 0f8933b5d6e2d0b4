"""The card of a packed world: what it holds, from what, under which licence, and how to read it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from mansion_world.building_measures import LICENCE
from mansion_world.records import SPLITS, Split
from mansion_world.statistics import WorldStatistics, world_statistics
from mansion_world.world_folder import WorldFolder

__all__ = ["Shard", "data_card"]


@dataclass
class Shard:
    """A tar file of a packed world.

    Attributes
    ----------
    samples, bytes : int
        Buildings in it, and its size.
    sha256 : str
        Hash of the finished file.
    """

    name: str
    split: Split
    samples: int = 0
    bytes: int = 0
    sha256: str = ""


_READING: Final = """## Reading

A sample is a building. `json` holds its rows of the manifest, and in `files` the path of each other field in the
building's folder:

```python
import json, tarfile

with tarfile.open("{shard}") as shard:
    for member in shard:
        key, _, field = member.name.partition(".")
        if field == "json":
            sample = json.load(shard.extractfile(member))
            print(key, sample["building"]["description"], len(sample["tasks"]))
```

The `webdataset` package reads the same files. `mansion_world.packing.unpack_building(shard, index, folder)` writes the
folder of a building, which `mansion` opens. `manifest/` holds the tables of all buildings, rooms and tasks.
"""


def data_card(world: WorldFolder, shards: Sequence[Shard]) -> str:
    """Return the card as Markdown, its head in YAML as data hubs read it."""
    statistics = world_statistics(world)
    index = world.index()
    versions = ", ".join(f"{name} {version}" for name, version in sorted(index.versions.items()))
    counts = ", ".join(f"{statistics.splits[split]} {split}" for split in SPLITS)
    name = world.path.resolve().name
    head = {"license": LICENCE.lower(), "pretty_name": name, "tags": "[buildings, embodied-ai, robotics]"}
    made = f"{statistics.buildings} furnished buildings with {statistics.tasks} tasks for a robot, made by Mansion"
    parts = [
        "\n".join(["---", *(f"{key}: {value}" for key, value in head.items()), "---"]),
        f"# {name}",
        f"{made}: {counts}. Each building was checked, and the plan of each task was run.",
        f"Licence: {LICENCE}. Versions: {versions}. {_origin(world)}",
        "## Shards",
        _table(("shard", "buildings", "bytes", "SHA-256"), _shard_rows(shards)),
        _READING.format(shard=shards[0].name if shards else "train-000000.tar").rstrip(),
        *_statistics(statistics),
    ]
    return "\n\n".join(parts) + "\n"


def _origin(world: WorldFolder) -> str:
    index = world.index()
    if not index.sources:
        return f"Seed {index.seed}."
    return f"Joined from worlds of seeds {', '.join(str(source.seed) for source in index.sources)}."


def _shard_rows(shards: Sequence[Shard]) -> Iterator[tuple[str, ...]]:
    for shard in shards:
        yield shard.name, str(shard.samples), str(shard.bytes), f"`{shard.sha256}`"


def _statistics(statistics: WorldStatistics) -> Iterator[str]:
    for title, rows in statistics.tables().items():
        if rows:
            yield f"## {title}"
            yield _table(("", ""), rows)


def _table(head: Sequence[str], rows: Iterator[tuple[str, ...]] | Sequence[tuple[str, ...]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(cell.replace('|', '/') for cell in line)} |" for line in lines)
