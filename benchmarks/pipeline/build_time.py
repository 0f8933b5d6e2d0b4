"""Seconds of ``mansion build`` as a command, and of the same build through a running graph.

python benchmarks/pipeline/build_time.py [--brief TEXT] [--repeat 3]
"""

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

from mansion_bringup.graph.build_timing import compare_builds

BRIEF = "A four-storey office with a cafeteria on the ground floor"


def command_seconds(brief: str, output: Path) -> float:
    """Seconds of the whole command, the interpreter's start included."""
    start = time.perf_counter()
    command = [sys.executable, "-m", "mansion_bringup", "build", brief, "-o", str(output)]
    subprocess.run(command, check=True, capture_output=True)
    return time.perf_counter() - start


def main() -> None:
    """Print medians, their ratio and whether all buildings are the same bytes."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--brief", default=BRIEF)
    parser.add_argument("--repeat", type=int, default=3)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        runs = [command_seconds(options.brief, Path(folder) / str(i)) for i in range(options.repeat)]
    print(f"mansion build     {median(runs):.2f} s, {min(runs):.2f} s at best")
    print(compare_builds(options.brief, options.repeat))


if __name__ == "__main__":
    main()
