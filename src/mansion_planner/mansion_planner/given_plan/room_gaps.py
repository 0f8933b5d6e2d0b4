"""Overlaps of rooms, gaps between them, and rooms too narrow to enter, on a storey that is drawn."""

from collections.abc import Sequence

import shapely
from shapely.geometry import Polygon
from shapely.geometry.polygon import orient
from shapely.ops import nearest_points

from mansion_geometry.rings import polygon_parts
from mansion_geometry.robot_body import PASSAGE_WIDTH
from mansion_geometry.wall_sizes import INTERIOR_THICKNESS
from mansion_msgs_py.wording import counted
from mansion_planner.given_plan.faults import Findings
from mansion_planner.given_plan.storeys import PlanStorey
from mansion_planner.given_plan.wall_lines import THICKEST_WALL, on_centre_lines

__all__ = ["joined_rooms", "outline_of"]

_OVERLAP = 0.03
"""Half the depth, metres, up to which rooms may overlap: so much is drawn inexactly."""

_MOVED = 2e-3


def joined_rooms(storey: PlanStorey, findings: Findings) -> PlanStorey:
    """Return a drawn storey whose rooms share their boundaries, with its faults told.

    Gaps up to the thickness of a wall are closed on centre lines.
    """
    shapes = [room.shape for room in storey.rooms if room.shape is not None]
    _report_overlaps(storey, shapes, findings)
    joined = on_centre_lines(shapes)
    moved = [room.name for room, a, b in zip(storey.rooms, shapes, joined) if a.symmetric_difference(b).area > _MOVED]
    if moved:
        got = f"{counted(len(moved), 'room')} moved on to wall centre lines"
        findings.note(storey.index, "rooms drawn between wall faces", got, "rooms share the middle of their walls here")
    storey = storey.with_shapes(joined)
    _report_parts(storey, findings)
    _report_narrow(storey, findings)
    return storey


def _report_overlaps(storey: PlanStorey, shapes: Sequence[Polygon], findings: Findings) -> None:
    first, second = shapely.STRtree(list(shapes)).query(list(shapes), predicate="intersects")
    for i, j in sorted(zip(first.tolist(), second.tolist())):
        if i >= j:
            continue
        shared = shapes[i].intersection(shapes[j])
        deep = shared.buffer(-_OVERLAP)
        if not deep.is_empty:
            point = deep.representative_point()
            names = f"{storey.rooms[i].name} and {storey.rooms[j].name}"
            findings.fault(storey.index, names, f"overlap by {shared.area:.2f} m2", (point.x, point.y))


def outline_of(storey: PlanStorey) -> Polygon:
    """Return the outline of a drawn storey: its largest part, courtyards as holes."""
    union = shapely.union_all([room.shape for room in storey.rooms], grid_size=1e-4)
    return orient(max(polygon_parts(union), key=lambda part: part.area))


def _report_parts(storey: PlanStorey, findings: Findings) -> None:
    """Tell of rooms that touch no other, or only at a corner."""
    main = outline_of(storey)
    inside = [room for room in storey.rooms if room.shape is not None and room.shape.intersection(main).area > 0.01]
    for room in storey.rooms:
        if room.shape is None or room in inside:
            continue
        shape = room.shape
        gap, other = min(
            ((float(shape.distance(each.shape)), each) for each in inside if each.shape is not None),
            key=lambda entry: entry[0],
        )
        place = nearest_points(shape, other.shape)[0]
        message = f"touches no room: {gap:.2f} m lie between it and {other.name}; a wall has {THICKEST_WALL} m at most"
        findings.fault(storey.index, room.name, message, (place.x, place.y))


def _report_narrow(storey: PlanStorey, findings: Findings) -> None:
    least = PASSAGE_WIDTH + INTERIOR_THICKNESS
    for room in storey.rooms:
        if not room.core and room.shape is not None and room.shape.buffer(-least / 2 + 2e-3).is_empty:
            findings.fault(
                storey.index, room.name, f"is too narrow to enter; {least:.2f} m between wall centre lines are needed",
                room.place,
            )  # fmt: skip
