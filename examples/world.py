"""A data set: 20 studios and small flats with a task each, checked, and read again by split and difficulty.

    .venv/bin/python examples/world.py --output out/examples

Run again, it goes on from the buildings that are done.
"""

import argparse
from pathlib import Path

import mansion
from mansion_bringup.worlds import build_for_world, check_for_world, redo_tasks, tasks_for_world, world_workers
from mansion_world.attempts import TaskStep
from mansion_world.making import make_world
from mansion_world.mixture import load_mixture
from mansion_world.requests import Sampled
from mansion_world.verification import verify_world


def main() -> None:
    """Make DIR/world, verify it, and open one of its buildings."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--output", type=Path, default=Path("out/examples"), metavar="DIR")
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()

    folder = options.output / "world"
    made = make_world(
        folder,
        20,
        requests=Sampled(7, load_mixture(Path(__file__).with_name("small_world.toml"))),
        build=build_for_world,
        check=check_for_world,
        workers=world_workers(options.jobs),
        jobs=options.jobs,
        tasks=TaskStep(1, tasks_for_world),
    )
    print(f"{made.done} buildings, {made.set_aside} set aside and replaced")
    faults = list(verify_world(folder, check_for_world, redo=redo_tasks))
    print(f"faults: {len(faults)}")

    world = mansion.World(folder)
    for split in ("train", "val", "test"):
        print(f"{split}: {len(world.filter(split=split))}")
    for level in ("easy", "medium", "hard", "expert"):
        print(f"{level}: {len(world.filter(difficulty=level))}")
    first = next(iter(world.filter(split="train")))
    print(f"{first.row.description}: {', '.join(first.open().rooms.ids)}")


if __name__ == "__main__":
    main()
