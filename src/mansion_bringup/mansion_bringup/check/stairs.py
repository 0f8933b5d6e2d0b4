"""Checks that stairs can be walked from storey to storey, and that lifts run in their shafts."""

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Final

from shapely import MultiPolygon, Polygon, box, unary_union
from shapely.geometry.base import BaseGeometry

from mansion_bringup.check.fault import Fault
from mansion_geometry.dog_legs import MAX_RISER
from mansion_msgs_py.scene import Box3, FloorScene, LiftDetails, SceneCore, StairDetails
from mansion_msgs_py.shapes import Ring

__all__ = ["check_ways_up"]

NARROWEST_FLIGHT: Final = 0.75
SHORTEST_GOING: Final = 0.22
HEADROOM: Final = 1.9
"""Metres that who walks or rides needs."""

SMALLEST_CABIN: Final = 0.8
"""Metres along each side."""

ROUNDING: Final = 0.01
AREA_SLACK: Final = 0.01
"""Square metres."""


def check_ways_up(scenes: Sequence[FloorScene]) -> Iterator[Fault]:
    """Yield faults of flights, landings, cabins and the openings that they need."""
    for scene in scenes:
        for core in scene.cores:
            if isinstance(core.details, StairDetails):
                yield from _stair(scene, core, core.details)
            elif isinstance(core.details, LiftDetails):
                yield from _lift(scene, core, core.details)
    for below, above in pairwise(scenes):
        yield from _aligned(below, above)


def _stair(scene: FloorScene, core: SceneCore, stair: StairDetails) -> Iterator[Fault]:
    where = f"{core.id} on floor {scene.floor}"
    inside = Polygon(core.polygon).buffer(ROUNDING)
    for name, shapes in (("tread", stair.treads), ("landing", stair.landings)):
        if any(not inside.covers(_plan(shape)) for shape in shapes):
            yield Fault("STAIR_OUTSIDE", where, f"a {name} lies outside the core")
    landing = _area(stair.floor_landing)
    if landing.area < NARROWEST_FLIGHT**2 or not inside.covers(landing):
        yield Fault("STAIR_OUTSIDE", where, "its floor landing is not in the core")
    yield from _openings(core, scene.floor, where, stair.floor_opening, stair.ceiling_opening)
    if scene.floor >= max(core.floors):
        return
    yield from _steps(scene, where, stair, landing)
    yield from _sizes(where, stair)
    high = [_plan(tread) for tread in stair.treads if tread[1][2] > scene.height - HEADROOM]
    if unary_union(high).difference(_area(stair.ceiling_opening).buffer(ROUNDING)).area > AREA_SLACK:
        yield Fault("STAIR_HEADROOM", where, "the slab above closes a flight")


def _steps(scene: FloorScene, where: str, stair: StairDetails, landing: Polygon) -> Iterator[Fault]:
    """Yield steps that are too high, and steps that do not follow one another in plan."""
    steps = sorted([*stair.treads, *stair.landings], key=lambda step: (step[1][2], step[0]))
    levels = [0.0, *(step[1][2] for step in steps), scene.height]
    for low, high in pairwise(levels):
        if high - low > MAX_RISER + ROUNDING:
            yield Fault("STAIR_STEPS", where, f"rises {high - low:.2f} m in one step at {low:.2f} m")
    places = [landing, *map(_plan, steps), landing]
    for (first, second), level in zip(pairwise(places), levels[1:]):
        if _shared_edge(first, second) < NARROWEST_FLIGHT / 2:
            yield Fault("STAIR_STEPS", where, f"the step at {level:.2f} m does not follow the one below it")
    if stair.risers != len(steps) + 1:
        yield Fault("STAIR_STEPS", where, f"states {stair.risers} risers, but has {len(steps) + 1}")


def _shared_edge(first: BaseGeometry, second: BaseGeometry) -> float:
    """Return about how long the edge is that two steps have in common, metres."""
    shared = first.buffer(ROUNDING).intersection(second.buffer(ROUNDING))
    if shared.is_empty:
        return 0.0
    x0, y0, x1, y1 = shared.bounds
    return float(max(x1 - x0, y1 - y0))


def _sizes(where: str, stair: StairDetails) -> Iterator[Fault]:
    sides = [sorted((high[0] - low[0], high[1] - low[1])) for low, high in stair.treads]
    width = min([stair.width, *(long for _, long in sides)])
    if width < NARROWEST_FLIGHT - ROUNDING:
        yield Fault("STAIR_NARROW", where, f"a flight is {width:.2f} m wide; at least {NARROWEST_FLIGHT} m are needed")
    going = min([stair.going, *(short for short, _ in sides)])
    if going < SHORTEST_GOING - ROUNDING:
        yield Fault("STAIR_GOING", where, f"a tread is {going:.2f} m deep; at least {SHORTEST_GOING} m are needed")
    for low, high in stair.landings:
        if min(high[0] - low[0], high[1] - low[1]) < NARROWEST_FLIGHT - 0.06:
            yield Fault("STAIR_NARROW", where, "its landing is narrower than a flight")


def _lift(scene: FloorScene, core: SceneCore, lift: LiftDetails) -> Iterator[Fault]:
    where = f"{core.id} on floor {scene.floor}"
    low, high = lift.cabin
    if not Polygon(core.polygon).buffer(ROUNDING).covers(_plan(lift.cabin)):
        yield Fault("LIFT_CABIN", where, "its cabin is not in the shaft")
    if min(high[0] - low[0], high[1] - low[1]) < SMALLEST_CABIN or high[2] - low[2] < HEADROOM:
        yield Fault("LIFT_CABIN", where, "its cabin is too small to ride in")
    if abs(low[2]) > 0.05:
        yield Fault("LIFT_CABIN", where, f"its cabin stands {low[2]:.2f} m from the floor")
    if sorted(button.floor for button in lift.buttons) != sorted(core.floors):
        yield Fault("LIFT_BUTTONS", where, "its buttons are not those of the floors that it serves")
    yield from _openings(core, scene.floor, where, lift.floor_opening, lift.ceiling_opening)


def _openings(core: SceneCore, floor: int, where: str, below: Ring, above: Ring) -> Iterator[Fault]:
    """Yield slabs that close a core, and openings where there is nothing to go to."""
    inside = Polygon(core.polygon).buffer(ROUNDING)
    for ring, needed, side in (
        (below, floor > min(core.floors), "its own floor"),
        (above, floor < max(core.floors), "the floor above"),
    ):
        area = _area(ring)
        if needed and area.area < AREA_SLACK:
            yield Fault("CORE_OPENING", where, f"has no opening in {side}")
        elif not needed and area.area > AREA_SLACK:
            yield Fault("CORE_OPENING", where, f"has an opening in {side}, where it does not go")
        elif not area.is_empty and not inside.covers(area):
            yield Fault("CORE_OPENING", where, f"its opening in {side} reaches beyond the core")


def _aligned(below: FloorScene, above: FloorScene) -> Iterator[Fault]:
    """Yield openings of a slab that its two floors describe differently."""
    upper = {core.id: core.details for core in above.cores}
    for core in below.cores:
        other = upper.get(core.id)
        if core.details is None or other is None:
            continue
        first, second = _area(core.details.ceiling_opening), _area(other.floor_opening)
        if first.symmetric_difference(second).area > AREA_SLACK:
            where = f"{core.id} on floor {above.floor}"
            yield Fault("CORE_OPENING", where, "the opening in its floor is not the one that the floor below has above")


def _plan(shape: Box3) -> Polygon:
    (x0, y0, _), (x1, y1, _) = shape
    return box(min(x0, x1), min(y0, y1), max(x0, x1), max(y0, y1))


def _area(ring: Ring) -> Polygon | MultiPolygon:
    """Return a ring as an area, which is empty for one that encloses nothing."""
    shape = Polygon(ring) if len(ring) > 2 else Polygon()
    return shape if shape.is_valid and math.isfinite(shape.area) else Polygon()
