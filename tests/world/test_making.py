"""A world does not depend on its workers, goes on where it was, loses nothing, and has no two buildings alike."""

import errno
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from mansion_bringup.cli.app import app
from mansion_bringup.worlds import build_for_world, check_for_world, tasks_for_world, world_workers
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_world.attempts import TaskStep
from mansion_world.making import WorldProgress, make_world
from mansion_world.mixture import load_mixture
from mansion_world.requests import MOST_ATTEMPTS, Sampled
from mansion_world.sampling import sample
from mansion_world.world_folder import WorldFolder

Build = Callable[[BuildRequest, Path], None]
Threads = Callable[[int], Callable[[], AbstractContextManager[Executor]]]

MIX = load_mixture()


def sound(folder: Path) -> list[str]:
    return []


def contents(world: Path) -> dict[str, bytes]:
    """Every file but those that hold times and the lock."""
    files = (path for path in world.rglob("*") if path.is_file() and path.name not in (".lock", "report.json"))
    return {path.relative_to(world).as_posix(): path.read_bytes() for path in files}


def buildings(world: Path, count: int) -> dict[str, bytes]:
    """Every file of the first buildings and their records."""
    starts = tuple(f"{part}/000/{index:06d}" for part in ("buildings", "records") for index in range(count))
    return {name: data for name, data in contents(world).items() if name.startswith(starts)}


def make(folder: Path, count: int, build: Build, threads: Threads, jobs: int = 1, **options: Any) -> WorldProgress:
    given = {"requests": Sampled(7, MIX), "check": sound, **options}
    return make_world(folder, count, build=build, workers=threads(jobs), jobs=jobs, **given)


def test_the_world_does_not_depend_on_the_number_of_workers(tmp_path: Path, build: Build, threads: Threads) -> None:
    def slow_for_some(request: BuildRequest, folder: Path) -> None:
        time.sleep(0.05 * (request.seed % 3))
        if request.seed % 4 == 0:
            raise MansionError(ErrorCode.INFEASIBLE, "does not fit")
        build(request, folder)

    one = make(tmp_path / "one", 8, slow_for_some, threads)
    four = make(tmp_path / "four", 8, slow_for_some, threads, jobs=4)
    assert one.done == four.done == 8
    assert one.set_aside == four.set_aside > 0
    assert contents(tmp_path / "one") == contents(tmp_path / "four")


def test_a_larger_world_begins_with_the_smaller_one(tmp_path: Path, build: Build, threads: Threads) -> None:
    make(tmp_path / "small", 3, build, threads)
    before = contents(tmp_path / "small" / "buildings")
    split = {row.index: row.split for row in WorldFolder(tmp_path / "small").buildings()}
    grown = make(tmp_path / "small", 6, build, threads, jobs=2)
    assert (grown.done, grown.kept) == (6, 3)
    after = contents(tmp_path / "small" / "buildings")
    assert {name: after[name] for name in before} == before
    rows = list(WorldFolder(tmp_path / "small").buildings())
    assert [row.index for row in rows] == list(range(6))
    assert {row.index: row.split for row in rows[:3]} == split


def test_what_fails_is_set_aside_with_request_and_reason(tmp_path: Path, build: Build, threads: Threads) -> None:
    checked: list[Path] = []

    def first_is_faulty(folder: Path) -> list[str]:
        checked.append(folder)
        return ["DOOR F1/door_1: leads nowhere"] if len(checked) == 1 else []

    made = make(tmp_path / "w", 2, build, threads, check=first_is_faulty)
    (aside,) = WorldFolder(tmp_path / "w").aside()
    assert (made.done, made.set_aside) == (2, 1)
    assert (aside.reason, aside.details) == ("faults", ["DOOR F1/door_1: leads nowhere"])
    assert aside.request == sample(0, 7, MIX)
    assert next(WorldFolder(tmp_path / "w").buildings()).attempt == 1
    assert list((tmp_path / "w" / "work").iterdir()) == []


def test_near_duplicates_are_replaced(tmp_path: Path, build: Build, threads: Threads) -> None:
    second = sample(1, 7, MIX).request.seed
    first = sample(0, 7, MIX).request

    def second_is_like_the_first(request: BuildRequest, folder: Path) -> None:
        build(first if request.seed == second else request, folder)

    make(tmp_path / "w", 2, second_is_like_the_first, threads, jobs=2)
    (aside,) = WorldFolder(tmp_path / "w").aside()
    assert (aside.reason, aside.details, aside.request.index) == ("near-duplicate", ["of 000000"], 1)
    assert [row.attempt for row in WorldFolder(tmp_path / "w").buildings()] == [0, 1]


def test_a_place_that_nothing_fills_is_left_empty_and_told(tmp_path: Path, build: Build, threads: Threads) -> None:
    never = {sample(1, 7, MIX, attempt=attempt).request.seed for attempt in range(MOST_ATTEMPTS)}

    def no_second(request: BuildRequest, folder: Path) -> None:
        if request.seed in never:
            raise MansionError(ErrorCode.INFEASIBLE, "does not fit")
        build(request, folder)

    made = make(tmp_path / "w", 3, no_second, threads)
    assert (made.done, made.missing, made.set_aside) == (2, 1, MOST_ATTEMPTS)
    assert [row.index for row in WorldFolder(tmp_path / "w").buildings()] == [0, 2]


def test_a_full_disk_stops_with_one_line_and_goes_on_later(tmp_path: Path, build: Build, threads: Threads) -> None:
    room = 2

    def fills_up(request: BuildRequest, folder: Path) -> None:
        nonlocal room
        if not room:
            raise OSError(errno.ENOSPC, "No space left on device", str(folder))
        room -= 1
        build(request, folder)

    with pytest.raises(MansionError, match=r"No space left on device; 2 of 4 buildings are done; .* again") as caught:
        make(tmp_path / "w", 4, fills_up, threads)
    assert "\n" not in str(caught.value)
    room = 10
    made = make(tmp_path / "w", 4, fills_up, threads)
    make(tmp_path / "whole", 4, build, threads)
    assert (made.done, made.kept, room) == (4, 2, 8)
    assert contents(tmp_path / "w") == contents(tmp_path / "whole")


def test_what_another_request_would_meet_too_stops_the_run(tmp_path: Path, build: Build, threads: Threads) -> None:
    def locked(request: BuildRequest, folder: Path) -> None:
        raise MansionError(ErrorCode.CONFLICT, "another build is writing here")

    with pytest.raises(MansionError, match="another build is writing here"):
        make(tmp_path / "w", 2, locked, threads)
    assert list(WorldFolder(tmp_path / "w").aside()) == []
    assert make(tmp_path / "w", 2, build, threads).done == 2


def test_damaged_and_unfinished_buildings_are_made_anew(tmp_path: Path, build: Build, threads: Threads) -> None:
    make(tmp_path / "w", 4, build, threads)
    sound_contents = contents(tmp_path / "w")
    world = WorldFolder(tmp_path / "w")
    (world.building(1) / "building.json").write_text("{}")
    (tmp_path / "w/records/000/000002.json").write_text("")
    shutil.copytree(world.building(3), world.work(3, 0))
    made = make(tmp_path / "w", 4, build, threads)
    assert made.kept == 2
    shutil.rmtree(world.work(3, 0))
    assert contents(tmp_path / "w") == sound_contents


def test_another_world_is_not_written_over(tmp_path: Path, build: Build, threads: Threads) -> None:
    make(tmp_path / "w", 1, build, threads)
    with pytest.raises(MansionError, match="another seed"):
        make(tmp_path / "w", 1, build, threads, requests=Sampled(8, MIX))
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "notes.txt").write_text("mine")
    with pytest.raises(MansionError, match="holds other files"):
        make(tmp_path / "other", 1, build, threads)


def test_a_killed_worker_costs_no_building(tmp_path: Path, flats_mix: Path, small_world: Path) -> None:
    mix = load_mixture(flats_mix)
    started: list[ProcessPoolExecutor] = []
    workers = world_workers(1)

    class Recorded:
        def __enter__(self) -> Executor:
            self.pool = workers()
            executor = self.pool.__enter__()
            assert isinstance(executor, ProcessPoolExecutor)
            started.append(executor)
            return executor

        def __exit__(self, *error: Any) -> None:
            self.pool.__exit__(*error)

    def kill_once(progress: WorldProgress) -> None:
        if len(started) == 1 and progress.done == 1:
            (pid,) = started[0]._processes
            os.kill(pid, signal.SIGKILL)

    made = make_world(
        tmp_path / "w",
        2,
        requests=Sampled(7, mix),
        build=build_for_world,
        check=check_for_world,
        workers=Recorded,
        tasks=TaskStep(3, tasks_for_world),
        report=kill_once,
    )
    assert (made.done, made.set_aside, len(started)) == (2, 0, 2)
    assert buildings(tmp_path / "w", 2) == buildings(small_world, 2)


def test_a_killed_command_goes_on_where_it_was(tmp_path: Path, flats_mix: Path, small_world: Path) -> None:
    command = [
        "world",
        "make",
        "-o",
        str(tmp_path / "w"),
        "-n",
        "2",
        "--seed",
        "7",
        "--mix",
        str(flats_mix),
        "--jobs",
        "1",
    ]
    first = subprocess.Popen([sys.executable, "-m", "mansion_bringup", *command], stderr=subprocess.DEVNULL)
    record = tmp_path / "w" / "records" / "000" / "000000.json"
    while not record.exists() and first.poll() is None:
        time.sleep(0.02)
    first.kill()
    assert first.wait() == -signal.SIGKILL
    done = CliRunner().invoke(app, command)
    assert done.exit_code == 0, done.output
    assert done.stderr.splitlines()[0] == "[1/2] buildings"
    assert buildings(tmp_path / "w", 2) == buildings(small_world, 2)
    assert list((tmp_path / "w" / "work").iterdir()) == []
