"""Set-up from nothing: seconds, megabytes, and what the launcher costs afterwards.

    python benchmarks/setup_time.py [--python python3.12] [--runs 50] [--against REVISION]

Clones this checkout's HEAD into a temporary folder, runs ``./mansion --help`` there for the first time, then measures
the launcher alone (with the environment's Python replaced by ``true``) and the whole command. With ``--against``, sets
another revision up right before and after, and prints the difference.
"""

import argparse
import os
import statistics
import subprocess
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def seconds(command: Sequence[str], environment: dict[str, str]) -> float:
    """Wall time of a command that must succeed; its output is dropped."""
    start = time.perf_counter()
    subprocess.run(command, env=environment, stdout=subprocess.DEVNULL, check=True)
    return time.perf_counter() - start


def median_ms(command: Sequence[str], environment: dict[str, str], runs: int) -> float:
    """Median wall time of a command in milliseconds."""
    return 1000 * statistics.median(seconds(command, environment) for _ in range(runs))


def megabytes(folder: Path) -> float:
    """Disk usage of a folder in MB (10^6 bytes), each file once."""
    blocks = {
        (status.st_dev, status.st_ino): status.st_blocks for path in folder.rglob("*") for status in [path.lstat()]
    }
    return sum(blocks.values()) * 512 / 1e6


def set_up(revision: str, folder: Path, environment: dict[str, str]) -> tuple[float, float]:
    """Seconds of the first use of a revision in an empty folder, and megabytes of its environment."""
    subprocess.run(["git", "clone", "--quiet", str(ROOT), str(folder)], check=True)
    subprocess.run(["git", "checkout", "--quiet", revision], cwd=folder, check=True)
    first = seconds([str(folder / "mansion"), "--help"], environment)
    return first, megabytes(folder / ".venv")


def launcher_ms(checkout: Path, environment: dict[str, str], runs: int) -> tuple[float, float]:
    """Medians of the launcher with a command that does nothing, and of that command alone."""
    python = checkout / ".venv" / "bin" / "python"
    kept = python.with_name("python.kept")
    python.rename(kept)
    try:
        python.symlink_to("/bin/true")
        launched = median_ms([str(checkout / "mansion")], environment, runs)
        alone = median_ms([str(python)], environment, runs)
    finally:
        python.unlink()
        kept.rename(python)
    return launched, alone


def main() -> None:
    """Measure and print a table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--python", help="the Python to make the environment with")
    parser.add_argument("--runs", type=int, default=50, help="repetitions of the quick commands")
    parser.add_argument("--against", metavar="REVISION", help="a revision to compare with")
    options = parser.parse_args()
    environment = {
        name: value
        for name, value in os.environ.items()
        if name not in ("PYTHONPATH", "PYTHONDONTWRITEBYTECODE", "MANSION_VENV", "ROS_DISTRO")
    }
    if options.python:
        environment["MANSION_PYTHON"] = options.python
    with tempfile.TemporaryDirectory() as folder:
        others = []
        if options.against:
            others.append(set_up(options.against, Path(folder) / "before", environment))
        checkout = Path(folder) / "mansion"
        first, size = set_up("HEAD", checkout, environment)
        if options.against:
            others.append(set_up(options.against, Path(folder) / "after", environment))
        launched, alone = launcher_ms(checkout, environment, options.runs)
        whole = median_ms([str(checkout / "mansion"), "--help"], environment, max(5, options.runs // 5))
    print(f"first use (set-up and --help)    {first:8.1f} s")
    print(f".venv                            {size:8.0f} MB")
    for number, (other, other_size) in enumerate(others, 1):
        print(
            f"{options.against}, run {number}: {other:8.1f} s, {other_size:8.0f} MB; "
            f"HEAD takes {first - other:+.1f} s and {size - other_size:+.0f} MB"
        )
    print(f"launcher's own overhead          {launched - alone:8.1f} ms   budget 50 ms")
    print(f"mansion --help afterwards        {whole:8.1f} ms")


if __name__ == "__main__":
    main()
