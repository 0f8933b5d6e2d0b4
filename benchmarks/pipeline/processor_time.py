"""Processor time, bytes and files of ``mansion build`` as a command, by the formats that it writes.

python benchmarks/pipeline/processor_time.py [--against CHECKOUT] [--brief TEXT] [--formats LIST ...] [--repeat 3]

With another checkout of the sources, whose builds are run with its default formats, the two take turns.
"""

import argparse
import os
import resource
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from statistics import median

BRIEF = "A four-storey office with a cafeteria on the ground floor"
HERE = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Case:
    """A checkout and the options of its command."""

    name: str
    checkout: Path
    options: tuple[str, ...]


def run(case: Case, brief: str, output: Path) -> float:
    """Build once and return the seconds of processor time of the command and its processes."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [sys.executable, "-m", "mansion_bringup", "build", brief, "-o", str(output), *case.options]
    path = os.pathsep.join(str(package) for package in sorted((case.checkout / "src").iterdir()))
    # Users' interpreters keep what they compile; one that may not would compile the sources anew in each run.
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    subprocess.run(command, check=True, capture_output=True, env={**environment, "PYTHONPATH": path})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> None:
    """Print for each case the median and the least processor time, and what its folder holds."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--against", type=Path, help="another checkout")
    parser.add_argument("--brief", default=BRIEF)
    parser.add_argument("--formats", nargs="+", default=["", "all"])
    parser.add_argument("--repeat", type=int, default=3)
    options = parser.parse_args()
    cases = [Case("against", options.against.resolve(), ())] if options.against else []
    cases += [Case(f"formats {names or 'by default'}", HERE, ("--formats", names)) for names in options.formats]
    with tempfile.TemporaryDirectory() as name:
        folders = {case: Path(name) / str(number) for number, case in enumerate(cases)}
        for case in cases:
            run(case, options.brief, folders[case])  # compiles what is not compiled yet
        seconds: dict[Case, list[float]] = {case: [] for case in cases}
        for _ in range(options.repeat):
            for case in cases:
                seconds[case].append(run(case, options.brief, folders[case]))
        for case in cases:
            files = [file for file in folders[case].rglob("*") if file.is_file()]
            size = sum(file.stat().st_size for file in files) / 1e6
            mine, first = median(seconds[case]), median(seconds[cases[0]])
            print(
                f"{case.name:24} {mine:6.2f} s, {min(seconds[case]):6.2f} s at best, {mine / first:.2f} of the first; "
                f"{size:6.2f} MB in {len(files)} files"
            )


if __name__ == "__main__":
    main()
