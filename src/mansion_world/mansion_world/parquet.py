"""The manifest of a world in Parquet: the tables of its JSON lines, typed and compressed; needs the extra ``world``."""

from collections.abc import Iterator, Mapping
from itertools import chain, islice, zip_longest
from typing import Any, Final, Literal, get_origin, get_type_hints

import msgspec
import pyarrow as pa
from pyarrow import parquet

from mansion_msgs_py.codec import encode
from mansion_world.building_measures import LICENCE
from mansion_world.world_folder import TABLES, WorldFolder

__all__ = ["parquet_differences", "schema_of", "write_parquet"]

_ROWS: Final = 10_000
"""Rows of a group, and most in memory at a time."""

_TYPES: Final[Mapping[object, Any]] = {
    str: pa.string(),
    int: pa.int64(),
    float: pa.float64(),
    list[float]: pa.list_(pa.float64()),
    dict[str, str]: pa.map_(pa.string(), pa.string()),
}


def schema_of(row: type[msgspec.Struct]) -> Any:
    """Return the Arrow schema of a kind of rows: a column for each field, none of them null."""
    return pa.schema([pa.field(name, _type(hint), nullable=False) for name, hint in get_type_hints(row).items()])


def _type(hint: object) -> Any:
    return pa.string() if get_origin(hint) is Literal else _TYPES[hint]


def write_parquet(world: WorldFolder) -> None:
    """Write ``manifest/NAME.parquet`` beside each table of JSON lines.

    The metadata of each file names the licence, and the seed and the versions of the world.
    """
    for name, row in TABLES.items():
        file = world.table(name).with_suffix(".parquet")
        fresh = file.with_name(f".{file.name}")
        schema = schema_of(row).with_metadata(_metadata(world))
        with parquet.ParquetWriter(fresh, schema, compression="zstd") as writer:
            rows = _rows(world, name)
            while batch := list(islice(rows, _ROWS)):
                writer.write_table(pa.Table.from_pylist(batch, schema=schema))
        fresh.rename(file)


def _metadata(world: WorldFolder) -> dict[str, str]:
    index = world.index()
    return {"licence": LICENCE, "seed": str(index.seed), "versions": encode(index.versions)}


def _rows(world: WorldFolder, name: str) -> Iterator[dict[str, Any]]:
    for row in world.rows(name):
        yield msgspec.to_builtins(row)


def parquet_differences(world: WorldFolder) -> Iterator[tuple[str, str]]:
    """Yield one fault for each Parquet table that is there and does not hold what its JSON lines do."""
    for name in TABLES:
        file = world.table(name).with_suffix(".parquet")
        if file.is_file() and (fault := _difference(world, name)):
            yield f"manifest/{file.name}", fault


def _difference(world: WorldFolder, name: str) -> str:
    try:
        found = parquet.ParquetFile(world.table(name).with_suffix(".parquet"))
        batches = (batch.to_pylist(maps_as_pydicts="strict") for batch in found.iter_batches(_ROWS))
        pairs = zip_longest(chain.from_iterable(batches), _rows(world, name))
        for number, (row, wanted) in enumerate(pairs, start=1):
            if row != wanted:
                return f"row {number} differs from {name}.jsonl"
    except (pa.ArrowException, OSError) as error:
        return f"cannot be read: {error}"
    return ""
