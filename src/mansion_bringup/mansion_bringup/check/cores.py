"""Checks that stairs and lifts lie over one another with a door on each floor, that risers are within bounds, and that
floors rest on one another.
"""

import itertools
import math
from collections import defaultdict
from collections.abc import Iterator, Sequence

from shapely import Point as ShapelyPoint
from shapely import Polygon

from mansion_bringup.check.fault import Fault
from mansion_geometry.dog_legs import MAX_RISER, MIN_RISER
from mansion_msgs_py.scene import FloorScene, SceneCore

__all__ = ["check_cores"]

ROUNDING = 2e-3


def check_cores(scenes: Sequence[FloorScene]) -> Iterator[Fault]:
    """Yield faults of the vertical cores."""
    stacks: dict[str, list[tuple[FloorScene, SceneCore]]] = defaultdict(list)
    for scene in scenes:
        for core in scene.cores:
            stacks[core.id].append((scene, core))
            yield from _on_floor(scene, core)
    for name in sorted(stacks):
        yield from _stack(name, stacks[name])
    yield from _elevations(scenes)


def _on_floor(scene: FloorScene, core: SceneCore) -> Iterator[Fault]:
    where = f"{core.id} on floor {scene.floor}"
    shape = Polygon(core.polygon)
    outline = Polygon(scene.outline, scene.holes)
    if shape.difference(outline.buffer(ROUNDING)).area > ROUNDING:
        yield Fault("CORE_OUTSIDE", where, "is not inside the outline")
    doors = {door.id: door for door in scene.doors}
    door = doors.get(core.door)
    if door is None or core.id not in door.rooms:
        yield Fault("CORE_DOOR", where, f"has no door {core.door!r}")
    x, y, _ = core.entrance
    if shape.contains(ShapelyPoint(x, y)):
        yield Fault("CORE_ENTRANCE", where, "its entrance pose lies inside the shaft")
    if scene.floor not in core.floors:
        yield Fault("CORE_FLOORS", where, f"states that it serves only {core.floors}")
    details = core.details
    riser = getattr(details, "riser", None)
    if core.type == "stair" and riser is not None and not (MIN_RISER - 1e-6 <= riser <= MAX_RISER + 1e-6):
        yield Fault("STAIR_RISER", where, f"{riser * 100:.1f} cm; 15 to 19 cm are allowed")


def _stack(name: str, stack: list[tuple[FloorScene, SceneCore]]) -> Iterator[Fault]:
    first = Polygon(stack[0][1].polygon)
    for scene, core in stack[1:]:
        if first.symmetric_difference(Polygon(core.polygon)).area > ROUNDING:
            where = f"{name} on floor {scene.floor}"
            yield Fault("CORE_SHIFTED", where, "is not aligned with the one below")
    served = sorted({floor for _, core in stack for floor in core.floors})
    there = sorted(scene.floor for scene, _ in stack)
    if served != there:
        yield Fault("CORE_FLOORS", name, f"serves {served} but exists on {there}")


def _elevations(scenes: Sequence[FloorScene]) -> Iterator[Fault]:
    for below, above in itertools.pairwise(scenes):
        if not math.isclose(below.elevation + below.height, above.elevation, abs_tol=1e-3):
            where = f"floor {above.floor}"
            yield Fault("ELEVATION", where, f"{above.elevation:.2f} m is not the top of the floor below")
