"""Estimates of how long the check or the 3D model of a very large building takes, shown before it begins."""

from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Final

from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import Point

__all__ = ["check_seconds", "model_seconds", "notice"]

TOLD_FROM: Final = 10.0
"""Seconds of processor time from which an estimate is given."""

LARGE: Final = 2_000_000
"""Bytes of a storey's scene below which nothing takes that long."""

# Measured on the machine of docs/benchmarks.md: 20,000 objects; six rooms of 1,700 and of 8,300 corners.
OBJECT_CHECKED, CORNERS_CHECKED = 7e-4, 1.8e-8
OBJECT_SHOWN, CORNERS_SHOWN = 1.2e-4, 1.5e-7


def check_seconds(scenes: Iterable[FloorScene]) -> float:
    """Return about how long a check of these storeys takes, seconds of processor time."""
    return sum(OBJECT_CHECKED * len(scene.objects) + CORNERS_CHECKED * _pairs_of_corners(scene) for scene in scenes)


def model_seconds(scenes: Iterable[FloorScene]) -> float:
    """Return about how long the 3D model of these storeys takes, seconds of processor time."""
    return sum(OBJECT_SHOWN * len(scene.objects) + CORNERS_SHOWN * _pairs_of_corners(scene) for scene in scenes)


def _pairs_of_corners(scene: FloorScene) -> float:
    """Return how many pairs of corners the rooms have: what cutting a polygon into triangles takes."""
    rings: list[Sequence[Point]] = [ring for room in scene.rooms for ring in (room.polygon, room.net_polygon)]
    return float(sum(len(ring) ** 2 for ring in rings))


def notice(folder: Path, work: str, seconds: Callable[[Iterable[FloorScene]], float]) -> str:
    """Return a line about how long the work takes, empty where it is short.

    Parameters
    ----------
    folder : Path
        A building's folder; one that cannot be read is left to the work itself to report.
    work : str
        What is done.
    seconds : callable
        Estimates the seconds for some storeys.
    """
    try:
        if not any(file.stat().st_size > LARGE for file in folder.glob("floors/*/scene.json")):
            return ""
        scenes = BuildingFolder(folder).scenes()
    except (MansionError, OSError):
        return ""
    expected = seconds(scenes)
    if expected < TOLD_FROM:
        return ""
    objects = sum(len(scene.objects) for scene in scenes)
    return f"{work} of {objects} objects in {len(scenes)} storeys takes about {expected:.0f} s; Ctrl-C ends it"
