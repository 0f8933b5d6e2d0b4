"""Are all files of a building folder there, and do they say the same."""

from collections.abc import Iterator
from pathlib import Path

from mansion_bringup.check.fault import Fault
from mansion_msgs_py.building import Building, BuildingReport
from mansion_msgs_py.codec import decode
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene

__all__ = ["check_files", "check_maps"]


def check_files(folder: Path, building: Building) -> Iterator[Fault]:
    """Yield files that are named and missing or empty, and a report that does not decode."""
    named = list(building.files.values())
    for floor in building.floors:
        named += floor.files.values()
    for name in named:
        file = folder / name
        if not file.is_file() or file.stat().st_size == 0:
            yield Fault("FILE", name, "is missing or empty")
    try:
        decode(BuildingReport, (folder / building.files["report"]).read_bytes())
    except (KeyError, OSError):
        return
    except MansionError as error:
        yield Fault("FILE", building.files["report"], str(error))


def check_maps(folder: Path, building: Building, scenes: list[FloorScene]) -> Iterator[Fault]:
    """Yield floors whose occupancy image does not span the outline at 0.05 m a pixel."""
    for entry, scene in zip(building.floors, scenes):
        name = entry.files.get("map_image", "")
        try:
            header = (folder / name).read_bytes()[:64].split()
            width, height = int(header[1]) * 0.05, int(header[2]) * 0.05
        except (OSError, IndexError, ValueError):
            yield Fault("FILE", name, "is no PGM image")
            continue
        xs = [point[0] for point in scene.outline]
        ys = [point[1] for point in scene.outline]
        if width + 0.1 < max(xs) - min(xs) or height + 0.1 < max(ys) - min(ys):
            yield Fault("FILE", name, "is smaller than the floor")
