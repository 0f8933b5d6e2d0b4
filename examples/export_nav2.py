"""Write the map of a floor for the map server of Nav2: an image and the YAML file that describes it.

.venv/bin/python examples/export_nav2.py --output out/examples    # after examples/build.py
"""

import argparse
from pathlib import Path

from mansion_export.nav2 import FREE, map_pgm, map_yaml, occupancy
from mansion_msgs_py.building_folder import BuildingFolder

FLOOR = 2
RESOLUTION = 0.1
"""Metres a cell."""


def main() -> None:
    """Write DIR/nav2/floor_2.pgm and DIR/nav2/floor_2.yaml."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=Path("out/examples"), metavar="DIR")
    output = parser.parse_args().output

    scene = BuildingFolder(output / "clinic").scene(FLOOR)
    folder = output / "nav2"
    folder.mkdir(parents=True, exist_ok=True)
    image = folder / f"floor_{FLOOR}.pgm"
    image.write_bytes(map_pgm(scene, RESOLUTION))
    image.with_suffix(".yaml").write_text(map_yaml(scene, RESOLUTION, image=image.name))

    cells = occupancy(scene, RESOLUTION).data
    print(f"{image}: {cells.shape[1]} x {cells.shape[0]} cells")
    print(f"free for the robot: {(cells == FREE).sum() * RESOLUTION**2:.0f} m2")


if __name__ == "__main__":
    main()
