"""Checks that all files are there and readable, ids unique and named by their floor, and numbers finite."""

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from mansion_bringup.check.fault import Fault
from mansion_msgs_py.building import Building, BuildingReport
from mansion_msgs_py.building_folder import floor_file
from mansion_msgs_py.codec import decode, to_builtins
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene

__all__ = ["check_counts", "check_files", "check_identity", "check_maps"]

_AREA_SLACK = 0.5
"""Square metres by which a stated area of a floor may differ, from the rounding of its rooms."""


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


def check_counts(building: Building, scenes: Sequence[FloorScene]) -> Iterator[Fault]:
    """Yield statements of ``building.json`` about its floors that are not true."""
    rooms = {s.floor: sum(room.kind not in ("stair", "elevator") for room in s.rooms) for s in scenes}
    objects = {scene.floor: len(scene.objects) for scene in scenes}
    for entry, scene in zip(building.floors, scenes):
        stated = (entry.floor, entry.rooms, entry.objects, entry.label)
        if stated != (scene.floor, rooms[scene.floor], objects[scene.floor], scene.label):
            what = f"{scene.label!r} has {rooms[scene.floor]} rooms and {objects[scene.floor]} objects"
            yield Fault("COUNT", f"floor {entry.floor}", f"building.json states others: {what}")
        for name in ("elevation", "height"):
            if abs(getattr(entry, name) - getattr(scene, name)) > 1e-3:
                yield Fault("COUNT", f"floor {entry.floor}", f"building.json states another {name}")
        area = sum(room.area for room in scene.rooms)
        if abs(entry.area - area) > _AREA_SLACK:
            yield Fault("COUNT", f"floor {entry.floor}", f"building.json states {entry.area:.2f} m2 of {area:.2f} m2")
    for name, number in (("rooms", sum(rooms.values())), ("objects", sum(objects.values()))):
        if building.checks.get(name, number) != number:
            yield Fault("COUNT", "building", f"states {building.checks[name]} {name}, but has {number}")


def check_maps(folder: Path, building: Building, scenes: list[FloorScene]) -> Iterator[Fault]:
    """Yield floors whose occupancy image does not span the outline at 0.05 m a pixel; one need not be there."""
    for entry, scene in zip(building.floors, scenes):
        name = floor_file(entry, "map_image", "map.pgm")
        if not (folder / name).exists():
            continue
        try:
            header = (folder / name).read_bytes()[:64].split()
            width, height = int(header[1]) * 0.05, int(header[2]) * 0.05
        except (OSError, IndexError, ValueError):
            yield Fault("FILE", name, "is not a PGM image")
            continue
        xs = [point[0] for point in scene.outline]
        ys = [point[1] for point in scene.outline]
        if width + 0.1 < max(xs) - min(xs) or height + 0.1 < max(ys) - min(ys):
            yield Fault("FILE", name, "is smaller than the floor")


def check_identity(building_id: str, scenes: Sequence[FloorScene]) -> Iterator[Fault]:
    """Yield faults of names and numbers."""
    ids: Counter[str] = Counter()
    for scene in scenes:
        if scene.building_id != building_id:
            yield Fault("BUILDING_ID", f"floor {scene.floor}", f"belongs to {scene.building_id!r}")
        prefix = f"F{scene.floor}/"
        names = [room.id for room in scene.rooms] + [wall.id for wall in scene.walls]
        names += [door.id for door in scene.doors] + [window.id for window in scene.windows]
        names += [item.id for item in scene.objects]
        ids.update(names)
        for name in names:
            if not name.startswith(prefix):
                yield Fault("ID", name, f"does not begin with {prefix}")
        for path in _not_finite(to_builtins(scene), "$"):
            yield Fault("NUMBER", f"floor {scene.floor}", f"{path} is not finite")
    for name, count in sorted(ids.items()):
        if count > 1:
            yield Fault("ID", name, f"is used {count} times")


def _not_finite(value: Any, path: str) -> Iterator[str]:
    if isinstance(value, float):
        if not math.isfinite(value):
            yield path
    elif isinstance(value, dict):
        for key, entry in value.items():
            yield from _not_finite(entry, f"{path}.{key}")
    elif isinstance(value, list | tuple):
        for index, entry in enumerate(value):
            yield from _not_finite(entry, f"{path}[{index}]")
