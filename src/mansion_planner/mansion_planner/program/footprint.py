"""Plan on a footprint that the user gives: check it, and place the cores of an outline that is no rectangle."""

import math
from dataclasses import replace
from typing import Literal

import numpy as np
import shapely
from shapely.geometry import Polygon

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.limits import MAX_EXTENT
from mansion_msgs_py.request import Footprint
from mansion_msgs_py.wording import with_article
from mansion_planner.program.model import (
    LIFT,
    CoreBox,
    CoreWish,
    Corridor,
    Massing,
    Placement,
    PlannedRoom,
    Sketch,
    Storey,
)

__all__ = ["check_footprint", "free_cores", "free_massing", "is_rectangle", "sketch_free"]

LEAST_AREA = 12.0
_Sizes = tuple[Literal["stair", "elevator"], list[tuple[int, int]]]
CHILDREN = 8


def _fault(what: str, path: str) -> MansionError:
    return MansionError(
        ErrorCode.INVALID_PAYLOAD,
        f"{what}; a footprint is a simple polygon in metres of at least {LEAST_AREA:g} m2, "
        "with courtyards as holes inside it",
        path=path,
    )


def check_footprint(footprint: Footprint) -> Polygon:
    """Return the footprint as a counter-clockwise polygon.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` at the ring that is at fault.
    """
    rings = [(footprint.boundary, "$.footprint.boundary")]
    rings += [(hole, f"$.footprint.holes[{k}]") for k, hole in enumerate(footprint.holes)]
    for ring, path in rings:
        if len(ring) < 3 or not np.isfinite(np.asarray(ring, dtype=float)).all():
            raise _fault("the ring needs three or more finite points", path)
        shape = Polygon(ring)
        if not shape.is_valid:
            raise _fault(f"the ring is not simple ({shapely.is_valid_reason(shape)})", path)
    outer = Polygon(footprint.boundary)
    extent = max(outer.bounds[2] - outer.bounds[0], outer.bounds[3] - outer.bounds[1])
    if outer.area < LEAST_AREA or extent > MAX_EXTENT:
        raise _fault(
            f"it covers {outer.area:.1f} m2 and is {extent:.0f} m long (at most {MAX_EXTENT:.0f})", rings[0][1]
        )
    for hole, path in rings[1:]:
        if not outer.contains(Polygon(hole)):
            raise _fault("the hole is not inside the boundary", path)
    shape = Polygon(footprint.boundary, footprint.holes)
    if not shape.is_valid or shape.area < LEAST_AREA:
        raise _fault("the holes touch each other or leave too little", "$.footprint.holes")
    shape = shapely.remove_repeated_points(shape, 1e-6).simplify(1e-6)
    return shapely.geometry.polygon.orient(shape)


def is_rectangle(shape: Polygon) -> bool:
    """Whether the footprint is one axis-aligned rectangle."""
    return not shape.interiors and bool(abs(shape.area - shapely.box(*shape.bounds).area) < 1e-6)


def free_cores(shape: Polygon, wish: CoreWish) -> tuple[CoreBox, ...]:
    """Place the cores at integer coordinates against as much outer wall as possible, in the tightest pocket.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when the outline has no place for a core.
    """
    cores: list[CoreBox] = []
    free = shape
    stair: _Sizes = ("stair", [wish.stair, (wish.stair[1], wish.stair[0])])
    lift: _Sizes = ("elevator", [(LIFT, LIFT)])
    wishes = [stair] * wish.stairs + [lift] * wish.lifts
    counts: dict[str, int] = {}
    for kind, sizes in wishes:
        found = _best_place(shape, free, sizes)
        if found is None:
            wide, high = sizes[0]
            raise MansionError(
                ErrorCode.INFEASIBLE,
                f"the footprint has no place for {with_article(kind)} of {wide} x {high} m beside its rooms",
                path="$.footprint",
                details={"stage": "program"},
            )
        counts[kind] = counts.get(kind, 0) + 1
        box = shapely.box(*found)
        free = free.difference(box)
        cores.append(CoreBox(f"{kind}_{counts[kind]}", kind, found))
    return tuple(cores)


def _best_place(
    shape: Polygon, free: Polygon, sizes: list[tuple[int, int]]
) -> tuple[float, float, float, float] | None:
    x0, y0, x1, y1 = (math.floor(v) for v in free.bounds)
    step = max(1, int(max(x1 - x0, y1 - y0) // 60))
    xs, ys = np.meshgrid(np.arange(x0, x1 + 1, step), np.arange(y0, y1 + 1, step))
    shapely.prepare(free)
    ranked: list[tuple[float, float, float, tuple[float, float, float, float]]] = []
    for wide, high in sizes:
        boxes = shapely.box(xs.ravel(), ys.ravel(), xs.ravel() + wide, ys.ravel() + high)
        boxes = boxes[shapely.covers(free, boxes)]
        if not len(boxes):
            continue
        contact = shapely.length(shapely.intersection(shapely.boundary(boxes), shape.boundary))
        around = shapely.area(shapely.intersection(shapely.buffer(boxes, 3.0, join_style="mitre"), free))
        ranked += [
            (-round(float(contact[k]), 3), float(around[k]), float(k), tuple(boxes[k].bounds))
            for k in np.lexsort((around, -np.round(contact, 3)))[:12]
        ]
    for _, _, _, bounds in sorted(ranked):
        rest = free.difference(shapely.box(*bounds)).buffer(-0.7)
        if isinstance(rest, Polygon) and rest.area > 0.5 * free.area - 40:
            return bounds
    return None


def free_massing(shape: Polygon, cores: tuple[CoreBox, ...]) -> Massing:
    """Return a massing that only carries cores, for an outline without bars."""
    x0, y0, x1, y1 = shape.bounds
    base = Massing(length=x1 - x0, north=0.0, corridor=y1 - y0, south=0.0)
    return replace(base, cores=cores)


def sketch_free(storey: Storey, hub_id: str, free_area: float) -> Sketch:
    """Give areas and a room graph without places: corridors share the rooms when the hub would serve too many."""
    rooms = storey.rooms
    circulation = max(free_area - sum(room.gross for room in rooms), 0.06 * free_area)
    scale = (free_area - circulation) / max(sum(room.gross for room in rooms), 1e-9)
    pieces = 0 if len(rooms) <= CHILDREN + 2 else -(-len(rooms) // CHILDREN)
    hub_share = circulation * (1.0 if not pieces else 0.4)
    corridors = [Corridor(hub_id, [], given=hub_share)]
    corridors += [
        Corridor(f"corridor_{number}", [], hub_id, given=circulation * 0.6 / pieces) for number in range(1, pieces + 1)
    ]
    placements: list[Placement] = []
    for number, room in enumerate(rooms):
        parent = hub_id if not pieces else corridors[1 + number * pieces // len(rooms)].id
        placements += _given(room, parent, scale)
    return Sketch(corridors, placements)


def _given(room: PlannedRoom, parent: str, scale: float) -> list[Placement]:
    """Return the room and its suite with areas and without places."""
    inner = [placement for child in room.suite for placement in _given(child, room.id, scale)]
    return [Placement(room, [], parent, given=room.area * scale), *inner]
