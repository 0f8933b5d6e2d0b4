"""The end of a stair core at which its floor landings lie."""

import msgspec
import shapely
from shapely.geometry import Polygon

from mansion_msgs_py.program import BuildingProgram, CorePlan
from mansion_msgs_py.shapes import CompassSide, Point

__all__ = ["landing_end", "with_landings"]


def landing_end(core: CorePlan, outline: shapely.Geometry) -> CompassSide:
    """Return the door's end if that is a short side of the core, else the end deeper in an outline.

    Examples
    --------
    >>> core = CorePlan(id="stair_1", type="stair", x=(0.0, 3.0), y=(0.0, 6.0), door_side="east")
    >>> landing_end(core, shapely.box(0.0, 0.0, 9.0, 9.0))
    'north'
    """
    (x0, x1), (y0, y1) = sorted(core.x), sorted(core.y)
    ends: tuple[CompassSide, CompassSide] = ("south", "north") if y1 - y0 >= x1 - x0 else ("west", "east")
    if core.door_side in ends:
        return core.door_side
    middles: dict[CompassSide, Point] = {
        "south": ((x0 + x1) / 2, y0),
        "north": ((x0 + x1) / 2, y1),
        "west": (x0, (y0 + y1) / 2),
        "east": (x1, (y0 + y1) / 2),
    }
    edge = outline.boundary
    from_edge = [round(float(shapely.distance(edge, shapely.Point(middles[end]))), 3) for end in ends]
    return ends[0] if from_edge[0] >= from_edge[1] else ends[1]


def with_landings(program: BuildingProgram) -> BuildingProgram:
    """Return a program whose stairs state the end of their landings, the same on every floor.

    Floors of other outlines would choose other ends, and the flights would not meet: the outline that counts is what
    all floors have in common.
    """
    rings = [Polygon(floor.outline) for floor in program.floors if floor.outline]
    if not rings:
        return program
    common = shapely.intersection_all(rings)
    vertical = program.vertical_connectivity
    cores = [_with_landing(core, common) for core in vertical.cores]
    return msgspec.structs.replace(program, vertical_connectivity=msgspec.structs.replace(vertical, cores=cores))


def _with_landing(core: CorePlan, outline: shapely.Geometry) -> CorePlan:
    if core.type != "stair" or core.landing is not None:
        return core
    return msgspec.structs.replace(core, landing=landing_end(core, outline))
