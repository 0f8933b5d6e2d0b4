"""Agents at generated tasks of many buildings: python benchmarks/agents/many_buildings.py OUT DIR... [--tasks 12].

Makes a task set for each building folder (kept in OUT/tasks), then runs `mansion bench agents` on all of them and, with
--repeat N, repeats every N-th logged episode and counts those that differ. An interrupted run goes on where it ended.
"""

import argparse
import os
import sys
from pathlib import Path

from mansion_bringup.cli.console import progress_bar
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.files import write_atomic
from mansion_msgs_py.task import TaskSet
from mansion_tasks.episodes.bench import Bench, local_port, run_bench
from mansion_tasks.episodes.log import read_log
from mansion_tasks.episodes.replaying import replay
from mansion_tasks.episodes.results import BenchResult, render
from mansion_tasks.tasks.generate import generate
from mansion_tasks.tasks.sandbox import Sandbox


def task_file(building: Path, output: Path, count: int, seed: int) -> Path:
    """Return the task set of a building, made when it is not there yet."""
    file = output / "tasks" / f"{building.name}.json"
    if not file.exists():
        sandbox = Sandbox(building)
        tasks = generate(sandbox, count, seed=seed)
        relative = os.path.relpath(building.resolve(), file.parent.resolve())
        found = TaskSet(building=relative, building_id=sandbox.building.building_id, tasks=list(tasks))
        write_atomic(file, encode_bytes(found, indent=1))
    return file


def differing(result: BenchResult, output: Path, every: int) -> tuple[int, int]:
    """Return how many episodes were repeated, and how many of them came out otherwise."""
    repeated = different = 0
    for row in result.episodes[::every]:
        log = read_log(output / row.log)
        with local_port() as port:
            faults = replay(log, Path(log.start.building), port)
        repeated += 1
        different += bool(faults)
        for fault in faults:
            print(f"{row.log}: {fault}", file=sys.stderr)
    return repeated, different


def main() -> None:
    """Run the benchmark and print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=Path)
    parser.add_argument("buildings", type=Path, nargs="+")
    parser.add_argument("--tasks", type=int, default=12)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--agents", default="oracle,explorer,random")
    parser.add_argument("--repeat", type=int, default=0)
    options = parser.parse_args()
    files = [
        task_file(building, options.output, options.tasks, options.seed)
        for building in options.buildings
        if (building / "building.json").exists()
    ]
    bench = Bench(tuple(files), tuple(options.agents.split(",")), options.output, seed=options.seed)
    with progress_bar() as report:
        result = run_bench(bench, jobs=options.jobs, progress=report)
    print(f"{len(files)} buildings")
    print(render(result.summary))
    if options.repeat:
        repeated, different = differing(result, options.output, options.repeat)
        print(f"{repeated} episodes repeated, {different} came out otherwise")


if __name__ == "__main__":
    main()
