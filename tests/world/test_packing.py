"""Shards hold every file of every building, grouped by key, in bounded files that say what they are."""

import hashlib
import json
import shutil
import tarfile
from itertools import groupby
from pathlib import Path

import pytest
from typer.testing import CliRunner

from mansion_bringup.cli.app import app
from mansion_msgs_py.errors import MansionError
from mansion_world.building_measures import folder_digest
from mansion_world.packing import pack_world, unpack_building
from mansion_world.world_folder import WorldFolder

BIG = 10**9


def names(shard: Path) -> list[str]:
    with tarfile.open(shard) as members:
        return [member.name for member in members]


def key(name: str) -> str:
    return name.partition(".")[0]


def test_every_building_comes_back_as_it_was(small_world: Path, tmp_path: Path) -> None:
    world = WorldFolder(small_world)
    pack_world(world, tmp_path / "shards", shard_bytes=BIG)
    for row in world.buildings():
        shard = tmp_path / "shards" / f"{row.split}-000000.tar"
        folder = tmp_path / f"{row.index}"
        assert unpack_building(shard, row.index, folder) == row
        assert folder_digest(folder)[0] == row.sha256
    with pytest.raises(MansionError, match="exists"):
        unpack_building(shard, 0, folder)
    with pytest.raises(MansionError, match="no building 9"):
        unpack_building(shard, 9, tmp_path / "9")


def test_the_files_of_a_sample_follow_each_other_and_begin_with_what_it_is(small_world: Path, tmp_path: Path) -> None:
    shards = pack_world(WorldFolder(small_world), tmp_path / "shards", shard_bytes=BIG)
    for shard in shards:
        found = names(tmp_path / "shards" / shard.name)
        groups = [(name, list(members)) for name, members in groupby(found, key)]
        assert len(groups) == len({name for name, _ in groups}) == shard.samples
        with tarfile.open(tmp_path / "shards" / shard.name) as members:
            for name, group in groups:
                content = members.extractfile(group[0])
                assert content is not None
                sample = json.load(content)
                assert group[0] == f"{name}.json" and f"{sample['building']['index']:06d}" == name
                assert [f"{name}.{field}" for field in sample["files"]] == group[1:]
                assert len(sample["tasks"]) == sample["building"]["tasks"] == 3


def test_shards_are_bounded_and_the_same_world_gives_the_same_bytes(small_world: Path, tmp_path: Path) -> None:
    world = WorldFolder(small_world)
    whole = pack_world(world, tmp_path / "whole", shard_bytes=BIG)
    bound = max(shard.bytes for shard in whole) - 1
    parts = pack_world(world, tmp_path / "parts", shard_bytes=bound)
    again = pack_world(world, tmp_path / "again", shard_bytes=bound)
    assert len(parts) > len(whole) and all(shard.bytes <= bound for shard in parts)
    assert sum(shard.samples for shard in parts) == 3
    assert parts == again
    for shard in parts:
        data = (tmp_path / "parts" / shard.name).read_bytes()
        assert (len(data), hashlib.sha256(data).hexdigest()) == (shard.bytes, shard.sha256)
    alone = pack_world(world, tmp_path / "alone", shard_bytes=1)
    assert [shard.samples for shard in alone] == [1, 1, 1]


def test_the_command_writes_card_and_manifest(small_world: Path, tmp_path: Path) -> None:
    output = tmp_path / "shards"
    done = CliRunner().invoke(app, ["world", "pack", str(small_world), "-o", str(output)])
    assert done.exit_code == 0 and "3 buildings in" in done.stdout
    card = (output / "README.md").read_text()
    assert card.startswith("---\nlicense: apache-2.0\n") and "3 furnished buildings with 9 tasks" in card
    for shard in sorted(output.glob("*.tar")):
        assert f"| {shard.name} |" in card and hashlib.sha256(shard.read_bytes()).hexdigest() in card
    assert "residential, studio" in card and "Seed 7." in card and "mansion 0.1.0" in card
    manifest = {file.name: file.read_bytes() for file in (small_world / "manifest").iterdir()}
    assert {file.name: file.read_bytes() for file in (output / "manifest").iterdir()} == manifest


def test_a_damaged_building_leaves_no_folder(small_world: Path, tmp_path: Path) -> None:
    world = WorldFolder(shutil.copytree(small_world, tmp_path / "world"))
    (world.building(1) / "tasks.json").write_text("{}")
    with pytest.raises(MansionError, match="has changed since it was written"):
        pack_world(world, tmp_path / "shards", shard_bytes=BIG)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["world"]


def test_a_folder_that_holds_something_is_refused(small_world: Path, tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    done = CliRunner().invoke(app, ["world", "pack", str(small_world), "-o", str(tmp_path)])
    assert done.exit_code != 0 and (tmp_path / "notes.txt").read_text() == "mine"
    assert [path.name for path in tmp_path.iterdir()] == ["notes.txt"]
