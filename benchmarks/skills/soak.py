"""Random skills for a long time: does the memory stay flat?

python benchmarks/skills/soak.py BUILDING... [--minutes 30 | --skills 100000] [--samples 12] [--seed 0]
"""

import argparse
import gc
import time
from collections.abc import Iterator
from pathlib import Path
from random import Random

from random_skills import step

from mansion_skills import Robot
from mansion_skills.engine import Engine

PAGE_MB = 4096 / 2**20


def resident() -> float:
    """Return the memory that this process has now, MB (``/proc/self/statm``)."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * PAGE_MB


def turns(minutes: float | None, skills: int) -> Iterator[float]:
    """Yield how much of the run is done, 0 to 1, before each skill."""
    begin, number = time.monotonic(), 0
    while True:
        done = number / skills if minutes is None else (time.monotonic() - begin) / (60 * minutes)
        if done >= 1.0:
            return
        yield done
        number += 1


def main() -> None:
    """Run and print."""
    parser = argparse.ArgumentParser()
    parser.add_argument("buildings", nargs="+")
    parser.add_argument("--minutes", type=float)
    parser.add_argument("--skills", type=int, default=100_000)
    parser.add_argument("--samples", type=int, default=12)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    rng = Random(options.seed)
    engine = Engine(durable=False)
    robots = [
        Robot(path, f"{name}{number}", world="soak", reset=name == "a", engine=engine)
        for number, path in enumerate(options.buildings)
        for name in ("a", "b")
    ]
    count, series = 0, list[float]()
    for done in turns(options.minutes, options.skills):
        step(rng.choice(robots), rng)
        count += 1
        if done * options.samples >= len(series):
            gc.collect()
            series.append(round(resident(), 1))
    hours = sum(shared.world.time for shared in engine.worlds) / 3600
    print(f"{count} skills, {hours:.1f} hours on the worlds' clocks")
    print(f"resident memory at each of {len(series)} samples, MB: {series}")


if __name__ == "__main__":
    main()
