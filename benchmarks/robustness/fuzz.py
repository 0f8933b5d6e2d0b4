"""Give every service, payload, building file and command hostile input, and say what did harm.

    PYTHONPATH=tests/support python benchmarks/robustness/fuzz.py [--inputs 20000] [--seed 0] [-o FOLDER]

Harm is an error of Mansion's own, more than 10 s of processor time, more than 1 GB of memory, a process that ends or
works on an input for a minute, and anything written outside of the folder that may be. Exit status 1 where there was
any; each kind is printed once, with an input that caused it in FOLDER.
"""

import argparse
import json
import os
import selectors
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

from fuzzing import Fuzzer, make_stock

LOOK = 5.0
"""Seconds between two looks at a worker that says nothing."""

BUSY, IDLE = 60.0, 600.0
"""Seconds of processor time, and on the wall, after which a worker that says nothing is ended."""


def work(options: argparse.Namespace) -> None:
    """Run the cases from one number on, and print a line for each."""
    reports = os.fdopen(os.dup(1), "w", buffering=1)
    quiet = os.open(os.devnull, os.O_WRONLY)
    os.dup2(quiet, 1)
    fuzzer = Fuzzer(make_stock(options.output / "stock"), options.output / "run", options.seed)
    for number in range(options.first, options.inputs):
        case = fuzzer.case(number)
        if not case.target.startswith(options.only):
            continue
        print(json.dumps({"number": number, "target": case.target}), file=reports)
        outcome = fuzzer.run(case)
        print(json.dumps({"number": number, "target": case.target, **asdict(outcome)}), file=reports)
        if not outcome.sound:
            (options.output / f"input_{number}").write_bytes(case.data)
        if outcome.verdict == "memory":
            return  # the peak stays where it is: another process goes on


def lines_of(worker: "subprocess.Popen[bytes]") -> Iterator[dict[str, Any] | None]:
    """Yield the reports of a worker as they come, and ``None`` where there is none for too long."""
    assert worker.stdout is not None
    selector = selectors.DefaultSelector()
    selector.register(worker.stdout, selectors.EVENT_READ)
    rest, used, heard = b"", processor_time(worker.pid), time.monotonic()
    while True:
        if selector.select(LOOK):
            read = os.read(worker.stdout.fileno(), 65_536)
            if not read:
                return
            *lines, rest = (rest + read).split(b"\n")
            yield from map(json.loads, lines)
            used, heard = processor_time(worker.pid), time.monotonic()
        elif processor_time(worker.pid) - used > BUSY or time.monotonic() - heard > IDLE:
            yield None


def processor_time(pid: int) -> float:
    """Return the seconds of processor time that a process has used (proc(5), stat)."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def followed(first: int, options: argparse.Namespace) -> Iterator[dict[str, Any]]:
    """Run a worker from a number on; yield its outcomes, and how it ended if it did not get to the last."""
    command = [sys.executable, __file__, "--worker", "--first", str(first), "--inputs", str(options.inputs)]
    command += ["--seed", str(options.seed), "--only", options.only, "-o", str(options.output)]
    begun: dict[str, Any] | None = None
    with subprocess.Popen(command, stdout=subprocess.PIPE) as worker:
        for report in lines_of(worker):
            if report is None:
                worker.kill()
                break
            begun = None if "verdict" in report else report
            if begun is None:
                yield report
        worker.kill()
    if begun is not None:
        end = "said nothing" if worker.returncode == -9 else f"ended with status {worker.returncode}"
        yield {
            **begun,
            "verdict": "hang" if worker.returncode == -9 else "crash",
            "what": end,
            "detail": "",
            "seconds": 0.0,
        }


def main() -> None:
    """Run the cases in workers, each from where the last one ended, and print what came of them."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--inputs", type=int, default=20_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", default="", help="what the names of the targets begin with")
    parser.add_argument("-o", "--output", type=Path, default=None, help="where inputs that did harm are kept")
    parser.add_argument("--first", type=int, default=0, help="the number to begin with")
    parser.add_argument("--worker", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    options.output = (options.output or Path(tempfile.mkdtemp(prefix="fuzz-"))).resolve()
    options.output.mkdir(parents=True, exist_ok=True)
    if options.worker:
        work(options)
        return
    verdicts: Counter[str] = Counter()
    harm: Counter[tuple[str, str]] = Counter()
    slowest: dict[str, Any] = {"seconds": 0.0, "target": "", "number": 0}
    started, first = time.monotonic(), options.first
    while first < options.inputs:
        last = first
        for report in followed(first, options):
            last = report["number"] + 1
            verdicts[report["verdict"]] += 1
            slowest = max(slowest, report, key=lambda entry: entry["seconds"])
            if report["verdict"] not in ("answered", "refused"):
                kind = (report["verdict"], report["what"])
                harm[kind] += 1
                if harm[kind] == 1:
                    print(f"{report['number']} {report['target']}: {report['verdict']}: {report['what']}")
                    print(report["detail"][-3_000:], flush=True)
        if last == first:
            harm["crash", f"no worker begins with number {first}"] += 1
            break
        first = last
    total = sum(verdicts.values())
    print(f"{total} inputs, seed {options.seed}, in {time.monotonic() - started:.0f} s: {dict(verdicts.most_common())}")
    print(f"slowest: {slowest['seconds']:.1f} s, number {slowest['number']}, {slowest['target']}")
    for (verdict, what), count in harm.most_common():
        print(f"{count:6} {verdict}: {what}")
    sys.exit(1 if harm else 0)


if __name__ == "__main__":
    main()
