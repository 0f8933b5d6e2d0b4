"""Measure processor time and size of every export of a building folder.

Usage: ``python benchmarks/export/export_time.py DIR``
"""

import argparse
import json
import time
from collections.abc import Callable
from pathlib import Path

import msgspec

from mansion_export.glb import building_glb
from mansion_export.html import view_page
from mansion_export.mjcf import floor_mjcf
from mansion_export.nav2 import map_pgm
from mansion_export.pictures.overview import overview_png
from mansion_export.plan import plan_png, plan_svg
from mansion_export.sdf import world_sdf
from mansion_export.thor import house, validate_house
from mansion_msgs_py.scene import FloorScene

FLOOR: dict[str, Callable[[FloorScene], int]] = {
    "plan.svg": lambda scene: len(plan_svg(scene)),
    "plan.png": lambda scene: len(plan_png(scene)),
    "map.pgm": lambda scene: len(map_pgm(scene)),
    "house.json": lambda scene: len(json.dumps(house(scene))),
    "validate_house": lambda scene: len(validate_house(house(scene))),
    "model.xml": lambda scene: len(floor_mjcf(scene).xml),
}
BUILDING: dict[str, Callable[[list[FloorScene]], int]] = {
    "building.glb": lambda scenes: len(building_glb(scenes)),
    "overview.png": lambda scenes: len(overview_png(scenes)),
    "page.html": lambda scenes: len(view_page(scenes)),
    "world.sdf": lambda scenes: len(world_sdf(scenes).xml),
}


def main() -> None:
    """Print a line for each export: mean seconds, worst seconds, mean size in kB."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("directory", type=Path)
    folder = parser.parse_args().directory
    scenes = [
        msgspec.json.decode(path.read_bytes(), type=FloorScene) for path in sorted(folder.glob("floors/*/scene.json"))
    ]
    objects = sum(len(scene.objects) for scene in scenes)
    print(f"{len(scenes)} floors, {objects} objects")
    building_glb(scenes[:1])
    overview_png(scenes[:1], width=400)
    for name, export in FLOOR.items():
        runs = [measured(export, scene) for scene in scenes]
        times = [seconds for seconds, _ in runs]
        size = sum(count for _, count in runs) / len(runs) / 1000
        mean = sum(times) / len(times)
        print(f"{name:16} {mean:7.3f} s a floor, worst {max(times):7.3f} s, {size:9.1f} kB")
    for name, whole in BUILDING.items():
        seconds, count = measured(whole, scenes)
        print(f"{name:16} {seconds:7.3f} s {'':23} {count / 1000:9.1f} kB")


def measured(export: Callable[..., int], argument: object) -> tuple[float, int]:
    """Return processor seconds and the size of a result."""
    start = time.process_time()
    count = export(argument)
    return time.process_time() - start, count


if __name__ == "__main__":
    main()
