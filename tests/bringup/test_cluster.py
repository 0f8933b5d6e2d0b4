"""A world built by the workers of a scheduler has the same bytes, whatever becomes of workers and scheduler."""

import socket
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from mansion_bringup.cluster import Cluster, attempt_on_worker
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_world.attempts import Assignment
from mansion_world.making import WorldProgress, make_world
from mansion_world.mixture import load_mixture
from mansion_world.requests import Requests, Sampled
from mansion_world.sampling import sample
from mansion_world.world_folder import WorldFolder
from stand_in_buildings import build_killed, build_slowly, build_stand_in, no_faults

distributed = pytest.importorskip("distributed", reason="the extra `cluster` is not installed")

Build = Callable[[BuildRequest, Path], None]

MIX = load_mixture()


@contextmanager
def local_cluster(workers: int = 2) -> Iterator[Any]:
    with distributed.LocalCluster(
        n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None, host="127.0.0.1"
    ) as cluster:
        yield cluster


def make(folder: Path, count: int, build: Build, cluster: Cluster | None = None, **options: Any) -> WorldProgress:
    requests: Requests = Sampled(7, MIX)
    where: dict[str, Any] = {"workers": partial(ThreadPoolExecutor, 1)}
    if cluster is not None:
        where = {"workers": cluster.workers, "jobs": cluster.jobs}
    return make_world(folder, count, requests=requests, build=build, check=no_faults, **where, **options)


def contents(world: Path) -> dict[str, bytes]:
    """Every file but those that hold times, locks and marks of the tests."""
    files = (path for path in world.rglob("*") if path.is_file() and path.name not in (".lock", "report.json"))
    return {path.relative_to(world).as_posix(): path.read_bytes() for path in files}


def test_a_lost_worker_costs_no_building_and_changes_no_byte(tmp_path: Path) -> None:
    (tmp_path / "marks").mkdir()
    with local_cluster() as local:
        found = Cluster(local.scheduler_address)
        made = make(tmp_path / "cluster", 6, partial(build_killed, 2, 2, tmp_path / "marks"), found)
    make(tmp_path / "here", 6, build_stand_in)
    assert (made.done, made.set_aside, len(list((tmp_path / "marks").iterdir()))) == (6, 0, 2)
    assert contents(tmp_path / "cluster") == contents(tmp_path / "here")


def test_a_scheduler_that_goes_away_ends_the_command_and_the_same_command_goes_on(tmp_path: Path) -> None:
    with local_cluster() as local:

        def away(progress: WorldProgress) -> None:
            if progress.done == 2:
                local.close()

        with pytest.raises(MansionError, match=r"scheduler at tcp://127\S+ no longer answers; \d of 5") as gone:
            make(tmp_path / "w", 5, build_slowly, Cluster(local.scheduler_address), report=away)
    assert gone.value.code == ErrorCode.UNAVAILABLE
    assert "\n" not in str(gone.value)
    with local_cluster() as local:
        made = make(tmp_path / "w", 5, build_slowly, Cluster(local.scheduler_address))
    assert (made.done, made.set_aside) == (5, 0)
    assert made.kept >= 2
    make(tmp_path / "here", 5, build_stand_in)
    assert contents(tmp_path / "w") == contents(tmp_path / "here")


def test_no_scheduler_is_told_in_one_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mansion_bringup.cluster._CONNECT", 0.5)
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        address = f"tcp://127.0.0.1:{taken.getsockname()[1]}"
        with pytest.raises(MansionError, match=rf"no dask scheduler answers at {address} \(.*`dask scheduler`") as none:
            make(tmp_path / "w", 1, build_stand_in, Cluster(address))
    assert "\n" not in str(none.value)


def test_a_worker_waits_for_one_that_was_given_up_and_takes_what_it_leaves(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("mansion_bringup.cluster._BUSY", 0.05)
    given_up, tries = threading.Event(), list[int]()

    def locked_at_first(request: BuildRequest, folder: Path) -> None:
        tries.append(1)
        if len(tries) == 1:
            build_stand_in(request, folder)
            given_up.set()
            raise MansionError(ErrorCode.CONFLICT, "another build is writing here")
        build_stand_in(request, folder)

    assignment = Assignment(WorldFolder(tmp_path), 7, 500.0, locked_at_first, no_faults)
    outcome = attempt_on_worker(mansion_version(), assignment, sample(0, 7, MIX))
    assert given_up.is_set() and outcome.record is not None
    assert len(tries) == 1


def mansion_version() -> str:
    from mansion_msgs_py import __version__

    return __version__


@pytest.mark.parametrize(
    ("version", "folder", "message"),
    [("0.0", ".", "has Mansion .*, the command 0.0; use the same"), (None, "nowhere", "does not see .*nowhere; name")],
)
def test_a_worker_that_does_not_fit_is_told(tmp_path: Path, version: str | None, folder: str, message: str) -> None:
    assignment = Assignment(WorldFolder(tmp_path / folder), 7, 500.0, build_stand_in, no_faults)
    with pytest.raises(MansionError, match=message):
        attempt_on_worker(version or mansion_version(), assignment, sample(0, 7, MIX))
    assert encode_bytes(sorted(tmp_path.iterdir())) == b"[]"
