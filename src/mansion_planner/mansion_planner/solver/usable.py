"""Whether rooms are usable: wide enough, without pinches, and not astride a structural wall."""

import numpy as np
import shapely
from shapely.geometry import MultiPolygon, Polygon

from mansion_geometry.rings import polygon_parts
from mansion_planner.solver.model import FloorModel

__all__ = ["shape_faults", "straddled_lengths", "width_fault"]

KEPT = 0.9
"""Share of a room's area that must be at least as wide as its minimum width."""

LOBE = 0.04
"""Share of a room's area that may lie behind a pinch."""

SLACK = 4e-3
STRADDLE = 0.06
"""Metres by which a structural wall may reach into a room (half an interior wall)."""


def width_fault(shape: Polygon | MultiPolygon, width: float) -> str:
    """Return what is wrong with a room's shape, or an empty string.

    The room is opened with a square of its minimum width (eroded by half of it, then dilated): what vanishes is too
    narrow, and what falls apart is pinched.

    Examples
    --------
    >>> width_fault(shapely.box(0, 0, 4, 3), 1.2), width_fault(shapely.box(0, 0, 9, 1), 1.2)
    ('', '0% of its area is at least 1.2 m wide')
    """
    inset = width / 2 - SLACK
    if inset <= 0.0:
        return ""
    pieces = [
        shapely.buffer(part, inset, join_style="mitre")
        for part in polygon_parts(shapely.buffer(shape, -inset, join_style="mitre"))
    ]
    kept = float(shapely.intersection(shapely.union_all(pieces), shape).area) if pieces else 0.0
    if kept < KEPT * shape.area:
        return f"{kept / shape.area:.0%} of its area is at least {width:g} m wide"
    lobes = [piece for piece in pieces if piece.area > LOBE * shape.area]
    if len(lobes) > 1:
        return f"places narrower than {width:g} m cut it into {len(lobes)} parts"
    return ""


def shape_faults(model: FloorModel, shapes: list[Polygon | MultiPolygon]) -> dict[str, str]:
    """Return the rooms that are too narrow or pinched, and why."""
    found: dict[str, str] = {}
    widths = model.min_widths.tolist()
    for room, shape, width in zip(model.rooms, shapes, widths):
        x0, y0, x1, y1 = shape.bounds
        whole = shape.area > 0.999 * (x1 - x0) * (y1 - y0)
        if whole and min(x1 - x0, y1 - y0) >= width - 2 * SLACK:
            continue
        reason = width_fault(shape, round(width, 3))
        if reason:
            found[room.id] = reason
    return found


def straddled_lengths(model: FloorModel, shapes: list[Polygon | MultiPolygon]) -> list[float]:
    """Return, for each structural wall, how many metres of it lie inside rooms."""
    if not model.walls:
        return []
    inner = shapely.buffer(np.array(shapes, dtype=object), -STRADDLE, join_style="mitre")
    return [float(shapely.length(shapely.intersection(inner, wall)).sum()) for wall in model.walls]
