"""The manifest in Parquet holds what its JSON lines do."""

import json
import shutil
from pathlib import Path

import msgspec
import pytest
from pyarrow import parquet
from typer.testing import CliRunner

from mansion_bringup.cli.app import app
from mansion_world.parquet import parquet_differences, schema_of, write_parquet
from mansion_world.records import BuildingRow
from mansion_world.world_folder import TABLES, WorldFolder


@pytest.fixture
def world(small_world: Path, tmp_path: Path) -> WorldFolder:
    """A copy of the world to damage."""
    return WorldFolder(shutil.copytree(small_world, tmp_path / "world"))


@pytest.mark.parametrize("name", list(TABLES))
def test_each_table_is_there_row_by_row_and_typed(small_world: Path, name: str) -> None:
    world = WorldFolder(small_world)
    table = parquet.read_table(world.table(name).with_suffix(".parquet"))
    rows = [msgspec.to_builtins(row) for row in world.rows(name)]
    assert table.to_pylist(maps_as_pydicts="strict") == rows and len(rows) >= 3
    assert table.schema.equals(schema_of(TABLES[name]))
    metadata = table.schema.metadata
    assert metadata[b"licence"] == b"Apache-2.0" and metadata[b"seed"] == b"7"
    assert json.loads(metadata[b"versions"]) == world.index().versions


def test_rows_of_buildings_carry_hash_licence_and_versions() -> None:
    assert {"sha256", "licence", "versions"} <= set(schema_of(BuildingRow).names)


def test_the_same_world_gives_the_same_bytes(world: WorldFolder) -> None:
    before = {name: world.table(name).with_suffix(".parquet").read_bytes() for name in TABLES}
    write_parquet(world)
    assert {name: world.table(name).with_suffix(".parquet").read_bytes() for name in TABLES} == before


def test_a_table_of_other_rows_and_a_damaged_one_are_found(world: WorldFolder) -> None:
    rooms, tasks = (world.table(name).with_suffix(".parquet") for name in ("rooms", "tasks"))
    found = parquet.read_table(rooms)
    parquet.write_table(found.slice(1), rooms)
    tasks.write_bytes(tasks.read_bytes()[:-20])
    faults = dict(parquet_differences(world))
    assert set(faults) == {"manifest/rooms.parquet", "manifest/tasks.parquet"}
    assert faults["manifest/rooms.parquet"] == "row 1 differs from rooms.jsonl"
    assert faults["manifest/tasks.parquet"].startswith("cannot be read: ")


def test_what_is_out_of_date_goes_with_a_new_manifest(world: WorldFolder) -> None:
    world.write_manifest()
    assert list(world.path.glob("manifest/*.parquet")) == []
    assert list(parquet_differences(world)) == []


def test_check_reads_it_too(world: WorldFolder) -> None:
    file = world.table("tasks").with_suffix(".parquet")
    parquet.write_table(parquet.read_table(file).slice(0, 1), file)
    done = CliRunner().invoke(app, ["world", "check", str(world.path)])
    assert done.exit_code == 1
    assert done.stdout == "manifest/tasks.parquet: row 2 differs from tasks.jsonl\n"
