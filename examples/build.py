"""Build a two-storey clinic from one sentence, and say what was written.

.venv/bin/python examples/build.py --output out/examples
"""

import argparse
from pathlib import Path

from mansion_bringup.pipeline.build import build_building
from mansion_msgs_py.request import BuildRequest

BRIEF = "A two-storey clinic with an elevator"


def main() -> None:
    """Build the clinic that the other examples use."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=Path("out/examples"), metavar="DIR")
    output = parser.parse_args().output

    request = BuildRequest(description=BRIEF, floor_area=160.0, seed=1)
    # Plans and a picture are always written. drive.py leaves the state of its robot in the folder; `force` replaces the
    # building all the same.
    result = build_building(request, output / "clinic", formats=["mjcf", "nav2"], force=True)

    print(f"{result.building.building_id} in {result.path}")
    for floor in result.building.floors:
        print(f"floor {floor.floor}: {floor.area:.0f} m2, {floor.rooms} rooms, {floor.objects} objects")
        print(*(f"  {kind}: {file}" for kind, file in sorted(floor.files.items())), sep="\n")


if __name__ == "__main__":
    main()
