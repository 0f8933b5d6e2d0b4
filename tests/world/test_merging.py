"""Worlds are joined without losing, doubling or changing a building."""

from collections.abc import Callable
from concurrent.futures import Executor
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

import msgspec
import pytest
from typer.testing import CliRunner

from mansion_bringup.cli.app import app
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_world.building_measures import split_of
from mansion_world.making import make_world
from mansion_world.merging import merge_worlds
from mansion_world.mixture import load_mixture
from mansion_world.requests import Sampled
from mansion_world.statistics import world_statistics
from mansion_world.verification import verify_world
from mansion_world.world_folder import WorldFolder

Build = Callable[[BuildRequest, Path], None]
Threads = Callable[[int], Callable[[], AbstractContextManager[Executor]]]


def no_faults(folder: Path) -> list[str]:
    return []


@pytest.fixture
def make(build: Build, threads: Threads, tmp_path: Path) -> Callable[..., Path]:
    """Makes a world of a name, in no time."""

    def make(name: str, count: int, seed: int, **options: Any) -> Path:
        mix = options.pop("mix", load_mixture())
        given = {"check": no_faults, "build": build, "workers": threads(1), **options}
        make_world(tmp_path / name, count, requests=Sampled(seed, mix), **given)
        return tmp_path / name

    return make


def test_worlds_of_other_seeds_follow_each_other(make: Callable[..., Path], tmp_path: Path) -> None:
    one, two = make("one", 3, 7), make("two", 4, 8)
    merged = merge_worlds([one, two], tmp_path / "both")
    world = WorldFolder(tmp_path / "both")
    rows = list(world.buildings())
    assert (merged.buildings, merged.dropped, [row.index for row in rows]) == (7, [], list(range(7)))
    parts = [row for part in (one, two) for row in WorldFolder(part).buildings()]
    assert [(row.id, row.sha256) for row in rows] == [(row.id, row.sha256) for row in parts]
    assert [row.split for row in rows] == [split_of(7, row.description) for row in parts]
    assert list(verify_world(tmp_path / "both", no_faults)) == []
    assert [(source.seed, source.buildings) for source in world.index().sources] == [(7, 3), (8, 4)]


def test_a_joined_world_can_be_joined_again(make: Callable[..., Path], tmp_path: Path) -> None:
    merge_worlds([make("one", 1, 7), make("two", 1, 8)], tmp_path / "both")
    merge_worlds([tmp_path / "both", make("three", 2, 9)], tmp_path / "all")
    world = WorldFolder(tmp_path / "all")
    assert [source.seed for source in world.index().sources] == [7, 8, 9]
    assert [row.id for row in world.buildings()] == [
        "world-7-000000",
        "world-8-000000",
        "world-9-000000",
        "world-9-000001",
    ]


def test_what_two_worlds_share_stays_once_and_keeps_its_place(make: Callable[..., Path], tmp_path: Path) -> None:
    small, large = make("small", 2, 7), make("large", 4, 7)
    merged = merge_worlds([small, large], tmp_path / "both")
    assert merged.buildings == 4
    assert [line.rpartition(": ")[2] for line in merged.dropped] == [
        "world-7-000000 is there already",
        "world-7-000001 is there already",
    ]
    assert list(WorldFolder(tmp_path / "both").buildings()) == list(WorldFolder(large).buildings())


def test_a_near_duplicate_of_another_world_is_left_out(make: Callable[..., Path], build: Build, tmp_path: Path) -> None:
    from mansion_world.sampling import sample

    first = sample(0, 7, load_mixture()).request

    def first_again(request: BuildRequest, folder: Path) -> None:
        build(msgspec.structs.replace(first, building_id=request.building_id), folder)

    merged = merge_worlds([make("one", 1, 7), make("two", 1, 8, build=first_again)], tmp_path / "both")
    assert merged.buildings == 1
    assert merged.dropped == [f"{tmp_path / 'two/buildings/000/000000'}: nearly the same as world-7-000000"]


def test_what_was_set_aside_comes_along_once(make: Callable[..., Path], tmp_path: Path) -> None:
    checks = 0

    def first_has_a_fault(folder: Path) -> list[str]:
        nonlocal checks
        checks += 1
        return ["DOOR"] if checks == 1 else []

    one, two = make("one", 2, 7, check=first_has_a_fault), make("two", 1, 8)
    merge_worlds([two, one, one], tmp_path / "both")
    (aside,) = WorldFolder(tmp_path / "both").aside()
    assert (aside.request.index, aside.request.attempt, aside.details) == (1, 0, ["DOOR"])


def test_other_buildings_of_the_same_seed_are_refused(make: Callable[..., Path], build: Build, tmp_path: Path) -> None:
    def with_a_note(request: BuildRequest, folder: Path) -> None:
        build(request, folder)
        (folder / "note.txt").write_text("of another mixture")

    one, two = make("one", 1, 7), make("two", 1, 7, build=with_a_note)
    with pytest.raises(MansionError, match="another building is called world-7-000000"):
        merge_worlds([one, two], tmp_path / "both")
    assert not (tmp_path / "both").exists()


def test_shares_are_the_mean_of_those_of_the_worlds(make: Callable[..., Path], flats_mix: Path, tmp_path: Path) -> None:
    merge_worlds([make("one", 1, 7), make("two", 3, 8, mix=load_mixture(flats_mix))], tmp_path / "both")
    asked = world_statistics(WorldFolder(tmp_path / "both")).asked
    assert sum(asked.values()) == pytest.approx(1.0)
    own = load_mixture().shares()[("residential", "studio")]
    assert asked[("residential", "studio")] == pytest.approx(0.25 * own + 0.75 * 0.5)


def test_the_command_tells_what_it_leaves_out(small_world: Path, tmp_path: Path) -> None:
    done = CliRunner().invoke(app, ["world", "merge", str(small_world), str(small_world), "-o", str(tmp_path / "both")])
    assert done.exit_code == 0, done.output
    assert done.stdout.count("left out: ") == 3 and "3 buildings of 2 worlds, 3 left out" in done.stdout
    assert (tmp_path / "both/manifest/tasks.parquet").is_file()
    assert CliRunner().invoke(app, ["world", "check", str(tmp_path / "both")]).exit_code == 0
