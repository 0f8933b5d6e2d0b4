"""What the runner of worlds costs and withstands.

    PYTHONPATH=tests/support python benchmarks/world/runner.py rate [--count 6] [--jobs 1 2]
    PYTHONPATH=tests/support python benchmarks/world/runner.py cost [--count 1000] [--jobs 2]
    PYTHONPATH=tests/support python benchmarks/world/runner.py kills [--count 60] [--kills 30] [--longest 10] [--real]

``rate`` makes worlds of small flats (examples/small_world.toml) in processes: buildings a minute and processor seconds.
``cost`` makes worlds of buildings that cost nothing: seconds of the command itself a building, in processes and by the
workers of a dask scheduler on this machine, and what is left when nothing is written either. ``kills`` ends one process
of a run after another with SIGKILL, a worker or the command, at random times, starts the command again where it ended,
and compares every byte with a run that nothing disturbed; exit status 1 where they differ. The buildings are stand-ins
of half a second each, or small flats with ``--real``.
"""

import argparse
import os
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any, Final

import psutil

from mansion_bringup.cluster import Cluster
from mansion_bringup.worlds import build_for_world, check_for_world, world_workers
from mansion_world.making import make_world
from mansion_world.mixture import load_mixture
from mansion_world.requests import Sampled
from mansion_world.world_folder import WorldFolder
from stand_in_buildings import build_slowly, build_stand_in, no_faults

FLATS: Final = Path(__file__).parents[2] / "examples" / "small_world.toml"
SEED: Final = 7

_SHOWN: Final = 20
"""Differing files that are named."""


def load() -> str:
    """Return the load of the machine."""
    return "load " + " ".join(f"{part:.1f}" for part in os.getloadavg())


def rate(options: argparse.Namespace, root: Path) -> bool:
    """Say how many buildings a minute a number of workers makes."""
    make_flats = partial(make_world, requests=Sampled(SEED, load_mixture(FLATS)), check=check_for_world)
    for jobs in options.jobs:
        before, started = processor(), time.monotonic()
        make_flats(root / str(jobs), options.count or 6, build=build_for_world, workers=world_workers(jobs), jobs=jobs)
        seconds, used = time.monotonic() - started, processor() - before
        count = options.count or 6
        print(
            f"{jobs} workers: {count / seconds * 60:.2f} buildings a minute, {used / count:.1f} processor s a building "
            f"({load()})",
            flush=True,
        )
    return True


def processor() -> float:
    """Return the processor seconds of this process and of its children that have ended."""
    both = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(usage.ru_utime + usage.ru_stime for usage in both)


def cost(options: argparse.Namespace, root: Path) -> bool:
    """Say what the command itself costs a building."""
    import distributed

    count, jobs = options.count or 1000, options.jobs[-1]
    with distributed.LocalCluster(
        n_workers=jobs, threads_per_worker=1, processes=True, dashboard_address="127.0.0.1:0", host="127.0.0.1"
    ) as local:
        cluster = Cluster(local.scheduler_address)
        one_cost("stand-ins, processes", count, root / "a", world_workers(jobs), jobs)
        one_cost("stand-ins, cluster", count, root / "b", cluster.workers, cluster.jobs)
        started = time.monotonic()
        with cluster.workers() as executor:
            client = executor._client  # type: ignore[attr-defined]
            client.gather(client.map(nothing, range(count), pure=False))
        print(f"tasks that do nothing, cluster: {(time.monotonic() - started) / count * 1000:.2f} ms each ({load()})")
    started = time.process_time()
    world = WorldFolder(root / "a")
    world.write_manifest()
    print(f"manifest: {(time.process_time() - started) / count * 1000:.2f} ms a building")
    return True


def nothing(number: int) -> int:
    """Do nothing."""
    return number


def one_cost(name: str, count: int, folder: Path, workers: Any, jobs: Any) -> None:
    """Make a world of stand-ins and print what it took."""
    started, used = time.monotonic(), time.process_time()
    make_world(
        folder,
        count,
        requests=Sampled(SEED, load_mixture()),
        build=build_stand_in,
        check=no_faults,
        workers=workers,
        jobs=jobs,
    )
    seconds, used = time.monotonic() - started, time.process_time() - used
    print(
        f"{name}: {seconds / count * 1000:.1f} ms a building, of it {used / count * 1000:.1f} ms processor time of the "
        f"command ({load()})",
        flush=True,
    )


def kills(options: argparse.Namespace, root: Path) -> bool:
    """Kill workers and commands at random; say whether the world is the same."""
    count = options.count or 60
    command = [sys.executable, __file__, "make", "--count", str(count), *(["--real"] if options.real else [])]
    rng = random.Random(options.seed)
    ended = {"worker": 0, "command": 0}
    started = time.monotonic()
    while True:
        run = subprocess.Popen([*command, "--output", str(root / "killed")])
        while run.poll() is None and sum(ended.values()) < options.kills:
            try:
                run.wait(rng.uniform(0.5, options.longest))
            except subprocess.TimeoutExpired:
                with suppress(ProcessLookupError, psutil.Error):  # it ended by itself just now
                    ended[kill_one(run.pid, rng)] += 1
        if run.wait() == 0:
            break
        if run.returncode != -signal.SIGKILL:
            print(f"the command ended with status {run.returncode}")
            return False
    subprocess.run([*command, "--output", str(root / "whole")], check=True)
    killed, whole = contents(root / "killed"), contents(root / "whole")
    same = killed == whole
    for name in sorted(name for name in killed.keys() | whole.keys() if killed.get(name) != whole.get(name))[:_SHOWN]:
        print(f"differs: {name}")
    print(
        f"{count} buildings, SIGKILL to {ended['worker']} workers and {ended['command']} commands in "
        f"{time.monotonic() - started:.0f} s: {'the same bytes' if same else 'OTHER BYTES'} ({load()})"
    )
    return same and sum(ended.values()) == options.kills


def make(options: argparse.Namespace, root: Path) -> bool:
    """Make the world of `kills`."""
    world = partial(make_world, options.output, options.count, workers=world_workers(2), jobs=2)
    if options.real:
        world(requests=Sampled(SEED, load_mixture(FLATS)), build=build_for_world, check=check_for_world)
    else:
        world(requests=Sampled(SEED, load_mixture()), build=build_slowly, check=no_faults)
    return True


def kill_one(command: int, rng: random.Random) -> str:
    """Kill a process of a run: one of its children more often than the command itself."""
    children = psutil.Process(command).children()
    workers = [child.pid for child in children if any("spawn_main" in word for word in child.cmdline())]
    victim = rng.choice([command, *workers, *workers])
    os.kill(victim, signal.SIGKILL)
    return "command" if victim == command else "worker"


def contents(world: Path) -> dict[str, bytes]:
    """Every file but those that hold times, and locks."""
    files = (path for path in world.rglob("*") if path.is_file() and path.name not in (".lock", "report.json"))
    return {path.relative_to(world).as_posix(): path.read_bytes() for path in files}


Measure = Callable[[argparse.Namespace, Path], bool]

MEASURES: Final[dict[str, Measure]] = {"rate": rate, "cost": cost, "kills": kills, "make": make}


def main() -> None:
    """Measure what is asked for."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("measure", choices=MEASURES, metavar="rate|cost|kills")
    parser.add_argument("--count", type=int, help="buildings")
    parser.add_argument("--jobs", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--kills", type=int, default=10)
    parser.add_argument("--longest", type=float, default=10.0, help="seconds between two kills, at most")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--real", action="store_true", help="small flats rather than stand-ins")
    parser.add_argument("--output", type=Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="world-") as root:
        sys.exit(0 if MEASURES[options.measure](options, Path(root)) else 1)


if __name__ == "__main__":
    main()
