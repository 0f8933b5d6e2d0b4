"""The front door, `import mansion`: look into the clinic, find things, change a copy of it, and send a robot upstairs.

.venv/bin/python examples/front_door.py --output out/examples    # after examples/build.py
"""

import argparse
import shutil
from pathlib import Path

import mansion


def main() -> None:
    """Read DIR/clinic, and edit a copy of it, DIR/front_door."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=Path("out/examples"), metavar="DIR")
    output = parser.parse_args().output

    clinic = mansion.load(output / "clinic")
    print(f"{clinic.description}: {clinic.wishes.summary}")
    for floor in clinic.floors:
        print(f"floor {floor.number}: {floor.area:.0f} m2, {len(floor.rooms)} rooms, {len(floor.objects)} objects")
        print(f"  to sit on: {len(floor.objects.find('something to sit on'))}")

    shutil.rmtree(output / "front_door", ignore_errors=True)
    changed = clinic.save(output / "front_door")
    done = changed.edit("put a red mug on the reception desk", physics="static")  # without the extra `sim`
    print(f"{done}: {', '.join(done.added.ids)}")
    print(f"faults: {len(changed.check())}")
    print(changed.plan(1).save(output / "front_door" / "edited.svg"))

    robot = changed.robot()
    upper = changed.floors[2].rooms[0]
    print(robot.go_to(upper.id).message)
    print(f"on floor {robot.where_am_i().floor} in {robot.where_am_i().room}")


if __name__ == "__main__":
    main()
