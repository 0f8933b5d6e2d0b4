"""A finished world is verified, described and read from Python."""

import json
import shutil
from pathlib import Path
from typing import cast

import pytest
from typer.testing import CliRunner

import mansion
from mansion_bringup.cli.app import app
from mansion_bringup.worlds import check_for_world, redo_tasks
from mansion_world.building_measures import difficulty_of
from mansion_world.mixture import load_mixture
from mansion_world.records import RoomRow
from mansion_world.sampling import sample
from mansion_world.statistics import world_statistics
from mansion_world.verification import verify_world
from mansion_world.world_folder import WorldFolder


@pytest.fixture
def copied(small_world: Path, tmp_path: Path) -> Path:
    """A copy of the world to damage."""
    return Path(shutil.copytree(small_world, tmp_path / "copied"))


def no_faults(folder: Path) -> list[str]:
    return []


def test_buildings_are_those_of_their_requests(small_world: Path, flats_mix: Path) -> None:
    mix = load_mixture(flats_mix)
    for entry in mansion.World(small_world):
        asked = sample(entry.row.index, 7, mix, attempt=entry.row.attempt)
        building = entry.open()
        assert building.description == asked.request.description == entry.row.description
        assert len(building.rooms) == entry.row.rooms and len(building.objects) == entry.row.objects
        row = entry.row
        assert row.difficulty == difficulty_of(row.floors, row.rooms, row.objects, row.task_metres)


def test_a_world_is_filtered_lazily(small_world: Path) -> None:
    world = mansion.World(small_world)
    rows = [entry.row for entry in world]
    assert [row.index for row in rows] == [0, 1, 2] and len(world) == 3
    parts = [len(world.filter(split=split)) for split in ("train", "val", "test")]
    assert sum(parts) == 3
    assert len(world.filter(difficulty="expert")) == 0
    studios = [entry.row.index for entry in world.filter(kind="studio")]
    assert studios == [row.index for row in rows if row.sub_kind == "studio"]
    train = world.filter(split="train")
    assert {entry.row.split for entry in train.filter(kind="residential")} <= {"train"}


def test_an_unknown_split_and_a_folder_without_a_world_are_refused(small_world: Path, tmp_path: Path) -> None:
    with pytest.raises(mansion.MansionError, match="unknown split 'dev'; use train, val, test"):
        mansion.World(small_world, split="dev")
    with pytest.raises(mansion.MansionError, match=r"world\.json"):
        mansion.World(tmp_path)


def test_the_table_of_rooms_agrees_with_that_of_buildings(small_world: Path) -> None:
    rooms = [cast(RoomRow, row) for row in WorldFolder(small_world).rows("rooms")]
    for row in WorldFolder(small_world).manifest():
        own = [room for room in rooms if room.index == row.index]
        assert len(own) == row.rooms and sum(room.objects for room in own) == row.objects
        assert {room.split for room in own} == {row.split}


def test_a_sound_world_has_no_fault(small_world: Path) -> None:
    done = CliRunner().invoke(app, ["world", "check", str(small_world)])
    assert done.exit_code == 0 and done.stdout == ""
    assert list(verify_world(small_world, check_for_world, redo=redo_tasks)) == []


def test_damage_is_found_and_named(copied: Path) -> None:
    first, second, third = (entry.row for entry in mansion.World(copied))
    index = copied / first.path / "building.json"
    index.write_text(index.read_text().replace(first.id, "another", 1))
    shutil.rmtree(copied / second.path)
    manifest = copied / "manifest" / "buildings.jsonl"
    lines = manifest.read_text().splitlines()
    lines[2] = json.dumps({**json.loads(lines[2]), "rooms": 99})
    manifest.write_text("\n".join(lines) + "\n")
    found = dict(verify_world(copied, no_faults))
    assert set(found) == {"manifest/buildings.jsonl", first.path, second.path}
    assert "line 3" in found["manifest/buildings.jsonl"] and "another hash" in found[first.path]
    assert third.path not in found


def test_statistics_count_what_is_there(small_world: Path) -> None:
    statistics = world_statistics(WorldFolder(small_world))
    rows = [entry.row for entry in mansion.World(small_world)]
    assert statistics.buildings == 3
    assert statistics.rooms.total == statistics.rooms_by_type.total() == sum(row.rooms for row in rows)
    assert statistics.floor_area.most == max(area for row in rows for area in row.floor_areas) <= 500
    assert statistics.asked == {("residential", "studio"): 0.5, ("residential", "small_flat"): 0.5}


def test_distributions_count_floors_buildings_and_tasks(small_world: Path) -> None:
    statistics = world_statistics(WorldFolder(small_world))
    records = list(WorldFolder(small_world).records())
    counts = statistics.distributions()
    assert sum(counts["Floor areas, m2"].values()) == sum(record.building.floors for record in records)
    assert sum(counts["Objects a building"].values()) == sum(counts["Split"].values()) == 3
    tasks = [task for record in records for task in record.tasks]
    for title in ("Tasks", "Path lengths of the oracle, m", "Floors of a task", "Difficulty of tasks"):
        assert sum(counts[title].values()) == statistics.tasks == len(tasks) == 9
    short = sum(task.metres < 10 for task in tasks)
    assert counts["Path lengths of the oracle, m"].get("0 to 10", 0) == short
    assert statistics.way.most == max(task.metres for task in tasks)


def test_the_page_shows_the_mixture_and_each_building(copied: Path) -> None:
    done = CliRunner().invoke(app, ["world", "stats", str(copied)])
    assert done.exit_code == 0 and "residential, studio" in done.stdout and "asked 50.0%" in done.stdout
    page = (copied / "statistics.html").read_text()
    assert "<h2>Path lengths of the oracle, m</h2>" in page and "<h2>Tasks</h2>" in page
    for entry in mansion.World(copied):
        assert f'src="{entry.row.path}/building.png"' in page
        assert (copied / entry.row.path / "building.png").is_file()
