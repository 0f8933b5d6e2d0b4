"""Plan random requests, build and check a share of them, and say which met an error of Mansion's own or a fault.

    python benchmarks/robustness/random_requests.py [--n 2000] [--seed 0] [--jobs 1] [-o FOLDER]
    python benchmarks/robustness/random_requests.py --one 117            # a single request, here and with its traceback

Each request runs in a process of its own that is ended at its limit of time or memory. FOLDER/results.jsonl gets a line
for each, and a later call with the same FOLDER goes on behind them. Exit status 1 where there was any error of
Mansion's own, fault that check finds, or process that had to be ended.
"""

import argparse
import json
import multiprocessing
import os
import resource
import shutil
import signal
import sys
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Iterator, Sequence
from multiprocessing.connection import Connection, wait
from pathlib import Path
from typing import Any

import msgspec
from request_drawing import DrawnRequest, draw

from mansion_bringup.building.report import building_index
from mansion_bringup.check import Fault, check_floors
from mansion_bringup.check.request import check_request
from mansion_bringup.check.wishes import check_wishes
from mansion_bringup.pipeline.build import build_building
from mansion_bringup.pipeline.floors import at_stage, distinct_floors, furnish, solve, source_floor
from mansion_bringup.pipeline.planning import plan_request
from mansion_bringup.pipeline.stages import LocalStages
from mansion_bringup.verify import check_houses, verify_building
from mansion_export.formats import Outputs
from mansion_export.thor import house
from mansion_msgs_py.building import Building
from mansion_msgs_py.codec import to_builtins
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.request import BuildRequest, identified
from mansion_msgs_py.workers import end_with_parent

FINE = ("planned", "built", "refused")

MOST_MEMORY = 6_000_000_000
"""Bytes of address space of a process that works on a request."""


def outcome(drawn: DrawnRequest, folder: Path, *, most_area: float, scenes: bool = False) -> dict[str, Any]:
    """Plan a request; build and check it where the plan has at most `most_area`; return what became of it.

    With `scenes` nothing is written, and what needs no file is checked.
    """
    started = time.process_time()
    entry: dict[str, Any] = {"end": "planned"}
    try:
        program = plan_request(drawn.request).program
        area = sum(floor.gross_floor_area for floor in program.floors)
        entry |= {"floors": len(program.floors), "type": program.building_type, "area": round(area)}
        if area <= most_area:
            if scenes:
                building, faults = furnished(drawn.request)
            else:
                building = build_building(drawn.request, folder).building
                faults = verify_building(folder)
            entry |= {"end": "faults" if faults else "built", "missed": _missed(building)}
            entry["faults"] = [str(fault) for fault in faults]
    except MansionError as error:
        internal = error.code == ErrorCode.INTERNAL
        trace = error.info.details.get("traceback", "") if internal else ""
        entry |= {"end": "INTERNAL" if internal else "refused", "what": str(error), "traceback": trace}
    except MemoryError:
        entry |= {"end": "memory"}
    except Exception as error:
        entry |= {"end": "traceback", "what": f"{type(error).__name__}: {error}", "traceback": traceback.format_exc()}
    return {**entry, "seconds": round(time.process_time() - started, 2)}


def furnished(request: BuildRequest) -> tuple[Building, list[Fault]]:
    """Run the stages alone; return the building and its faults."""
    request, stages = identified(request), LocalStages()
    plan = at_stage("plan_program", lambda: stages.plan(request))
    solved = {index: solve(stages, plan, index) for index in distinct_floors(plan)}
    layouts = [
        msgspec.structs.replace(solved[source_floor(plan, index)], floor=floor.index)
        for index, floor in enumerate(plan.program.floors)
    ]
    scenes = [furnish(stages, plan, layout, index) for index, layout in enumerate(layouts)]
    building = building_index(request, plan, scenes, Outputs((), ()))
    faults = [
        *check_request(building, layouts, scenes),
        *check_wishes(building, building.wishes, layouts, scenes),
        *check_floors(building.building_id, scenes, plan.topologies),
    ]
    for scene in scenes:
        faults += check_houses(f"floor {scene.floor}", house(scene))
    return building, faults


def _missed(building: Building) -> list[str]:
    return [f"{wish.text}: {wish.status}: {wish.reason}" for wish in building.wishes if wish.status != "met"]


def _work(drawn: DrawnRequest, folder: Path, most_area: float, scenes: bool, answer: Connection, parent: int) -> None:
    end_with_parent(parent, signal.SIGKILL)
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    quiet = os.open(os.devnull, os.O_WRONLY)
    os.dup2(quiet, 1)
    os.dup2(quiet, 2)
    answer.send(outcome(drawn, folder, most_area=most_area, scenes=scenes))


class _Task:
    """A request in a process of its own."""

    def __init__(self, drawn: DrawnRequest, built: bool, options: argparse.Namespace) -> None:
        self.drawn, self.built = drawn, built
        self.folder = options.output / "buildings" / f"{drawn.number:05d}"
        self.answer, theirs = multiprocessing.Pipe(duplex=False)
        context = multiprocessing.get_context("fork")
        most_area = options.most_area if built else 0.0
        arguments = (drawn, self.folder, most_area, options.scenes, theirs, os.getpid())
        self.process = context.Process(target=_work, args=arguments)
        self.process.start()
        theirs.close()
        self.ends = time.monotonic() + (options.build_limit if built else options.plan_limit)

    def result(self) -> dict[str, Any]:
        """Return what became of it, once it has answered, ended or run out of time."""
        try:
            entry: dict[str, Any] = self.answer.recv() if self.answer.poll() else {"end": "timeout"}
        except EOFError:
            entry = {"end": "ended"}
        self.process.kill()
        self.process.join()
        if entry["end"] == "ended":
            entry["what"] = f"status {self.process.exitcode}"
        request = {key: value for key, value in to_builtins(self.drawn.request).items() if value is not None}
        return {"number": self.drawn.number, "class": self.drawn.kind, **entry, "request": request}


def results(numbers: Sequence[int], options: argparse.Namespace) -> Iterator[dict[str, Any]]:
    """Run requests, `--jobs` at once, and yield what became of each."""
    waiting, running = list(reversed(numbers)), list[_Task]()
    while waiting or running:
        while waiting and len(running) < options.jobs:
            number = waiting.pop()
            running.append(_Task(draw(number, options.seed), is_built(number, options.build), options))
        wait([task.answer for task in running], timeout=0.5)
        now = time.monotonic()
        done = [task for task in running if task.answer.poll() or now > task.ends or not task.process.is_alive()]
        for task in done:
            running.remove(task)
            entry = task.result()
            yield entry
            if not options.keep and entry["end"] in FINE:
                shutil.rmtree(task.folder, ignore_errors=True)


def is_built(number: int, share: float) -> bool:
    """Tell whether a request is built and not only planned, so that any first requests hold the share."""
    return int((number + 1) * share) > int(number * share)


def warm() -> None:
    """Load kernels, knowledge and catalogue into this process, from which the others are forked."""
    with tempfile.TemporaryDirectory(prefix="random-requests-") as folder:
        drawn = DrawnRequest(-1, "plausible", BuildRequest(description="a small flat"))
        outcome(drawn, Path(folder) / "flat", most_area=1e3)


def main() -> None:
    """Run what is left of the requests, and print each that did harm and the counts."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--n", type=int, default=2_000, help="how many requests")
    parser.add_argument("--first", type=int, default=0, help="the number to begin with")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--build", type=float, default=0.25, help="share that is built and checked")
    parser.add_argument("--most-area", type=float, default=4_000.0, help="m2; larger buildings are planned only")
    parser.add_argument("--plan-limit", type=float, default=60.0, help="seconds for a plan")
    parser.add_argument("--build-limit", type=float, default=400.0, help="seconds for a building and its check")
    parser.add_argument("--scenes", action="store_true", help="write no files, and check what needs none")
    parser.add_argument("--keep", action="store_true", help="keep all buildings, not only those with a fault")
    parser.add_argument("--one", type=int, default=None, help="build this request alone, in this process")
    parser.add_argument("-o", "--output", type=Path, default=None, help="results, and buildings that have a fault")
    options = parser.parse_args()
    options.output = options.output or Path(tempfile.mkdtemp(prefix="random-requests-"))
    if options.one is not None:
        drawn = draw(options.one, options.seed)
        print(drawn.kind, drawn.request)
        entry = outcome(drawn, options.output / "buildings" / f"{options.one:05d}", most_area=1e9)
        print(entry.pop("traceback", ""), json.dumps(entry, indent=1), sep="\n")
        sys.exit(0 if entry["end"] in FINE else 1)
    options.output.mkdir(parents=True, exist_ok=True)
    log = options.output / "results.jsonl"
    entries = [json.loads(line) for line in log.read_text().splitlines()] if log.exists() else []
    done = {entry["number"] for entry in entries}
    warm()
    with log.open("a") as file:
        for entry in results([k for k in range(options.first, options.n) if k not in done], options):
            print(json.dumps(entry), file=file, flush=True)
            entries.append(entry)
            if entry["end"] not in FINE:
                _tell(entry)
    _count(entries)
    sys.exit(1 if any(entry["end"] not in FINE for entry in entries) else 0)


def _tell(entry: dict[str, Any]) -> None:
    what = "; ".join(entry.get("faults", [])) or entry.get("what", "")
    print(f"{entry['number']} {entry['class']}: {entry['end']}: {what}\n    {entry['request']}", flush=True)


def _count(entries: Sequence[dict[str, Any]]) -> None:
    print(f"{len(entries)} requests, {sum('faults' in entry for entry in entries)} of them built and checked")
    for kind in ("plausible", "odd", "absurd"):
        ends = Counter(entry["end"] for entry in entries if entry["class"] == kind)
        print(f"  {kind}: {', '.join(f'{end} {count}' for end, count in ends.most_common())}")
    slowest = max(entries, key=lambda entry: entry.get("seconds", 0.0), default=None)
    if slowest:
        print(f"slowest that ended: {slowest['number']}, {slowest.get('seconds', 0.0):.1f} s of processor time")


if __name__ == "__main__":
    main()
