"""Verification of a finished layout on its polygons: edges, connected rooms, usable shapes, structural walls."""

from collections.abc import Container
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import MultiPolygon, Polygon
from shapely.geometry.base import BaseGeometry

from mansion_geometry.rings import corner_points, polygon_parts
from mansion_geometry.shared_walls import SharedWall, edge_array, longest_wall, shared_walls, total_length
from mansion_geometry.wall_sizes import INTERIOR_THICKNESS
from mansion_msgs_py.layout import RealisedEdge
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.partition import Partition
from mansion_planner.solver.polygons import room_shapes, with_loose_pieces_joined
from mansion_planner.solver.problem import FloorModel, Obstacle

__all__ = ["MOST_STRADDLED", "MeasuredPartition", "Verdict", "corner_count", "layout_checks", "measure", "width_fault"]


KEPT = 0.9
"""Share of a room's area that must be at least as wide as its minimum width."""

LOBE = 0.04
"""Share of a room's area that may lie behind a pinch."""

WIDTH_SLACK = 4e-3
"""Tolerance of half a width, metres, for rounded coordinates."""

STRADDLE = INTERIOR_THICKNESS / 2
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
    inset = width / 2 - WIDTH_SLACK
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
        if whole and min(x1 - x0, y1 - y0) >= width - 2 * WIDTH_SLACK:
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


SLACK = 1e-3
"""Length, metres, by which a wall may be too short for its edge."""

GAP = 1e-3
"""Distance, metres, up to which two rooms touch."""

MOST_STRADDLED = 0.05
"""Metres of a structural wall that may lie inside rooms."""


@dataclass(frozen=True)
class Verdict:
    """What a layout realises and what is wrong with it.

    Attributes
    ----------
    broken : int
        Rooms that are not one piece.
    shape_faults : dict
        Rooms that are too narrow or pinched, and why.
    straddled : list of float
        Metres of each structural wall that lie inside rooms.
    """

    edges: list[RealisedEdge]
    broken: int
    shape_faults: dict[str, str]
    straddled: list[float]

    def violations(self, required: Container[tuple[str, str]]) -> tuple[int, int]:
        """Return the number of hard violations (open links among `required`, broken rooms, straddled walls) and of soft
        ones (unusable shapes)."""
        links = sum(not e.satisfied and (e.source, e.target) in required for e in self.edges)
        walls = sum(length > MOST_STRADDLED for length in self.straddled)
        return links + self.broken + walls, len(self.shape_faults)


def _walls(
    edges: dict[str, NDArray[np.float64]], obstacles: dict[str, Obstacle], a: str, b: str, kind: str
) -> list[SharedWall]:
    """Return the walls between `a` and `b` that count for an edge of `kind`."""
    walls = shared_walls(edges[a], edges[b], GAP)
    if kind == "access":
        if b in obstacles:
            walls = [w for w in walls if obstacles[b].is_entered_through(w)]
        if a in obstacles:
            walls = [w for w in walls if obstacles[a].is_entered_through(SharedWall(w.end, w.start))]
    return walls


def realise_edges(
    model: FloorModel, shapes: list[Polygon | MultiPolygon], options: SolverOptions
) -> list[RealisedEdge]:
    """Measure every link of the room graph on the shapes (in any frame, sides as in the model's)."""
    obstacles = {o.id: o for o in model.obstacles}
    edges = {room.id: edge_array(shape) for room, shape in zip(model.rooms, shapes)}
    edges |= {o.id: edge_array(o.polygon) for o in model.obstacles}
    found = []
    for link in model.links:
        walls = _walls(edges, obstacles, link.source, link.target, link.kind)
        longest = longest_wall(walls)
        if link.kind == "access":
            length = longest.length if longest else 0.0
            need = model.problem.min_access_wall
        else:
            length, need = total_length(walls), options.adjacent_wall
        found.append(
            RealisedEdge(
                source=link.source,
                target=link.target,
                kind="access" if link.kind == "access" else "adjacent",
                satisfied=length >= need - SLACK,
                wall=None if longest is None else (longest.start, longest.end),
                length=length,
            )
        )
    return found


def verify(model: FloorModel, shapes: list[Polygon | MultiPolygon], options: SolverOptions) -> Verdict:
    """Measure a layout given in the model's frame."""
    return Verdict(
        realise_edges(model, shapes, options),
        sum(len(polygon_parts(shape)) != 1 for shape in shapes),
        shape_faults(model, shapes),
        straddled_lengths(model, shapes),
    )


def corner_count(shape: BaseGeometry) -> int:
    """Return the number of corners of a shape and its holes."""
    return sum(
        len(corner_points(shapely.get_coordinates(line)[:-1]))
        for part in polygon_parts(shape)
        for line in (part.exterior, *part.interiors)
    )


def layout_checks(model: FloorModel, shapes: list[Polygon | MultiPolygon], verdict: Verdict) -> dict[str, float]:
    """Return the figures of ``FloorLayout.checks``."""
    edges = verdict.edges
    free = float(model.region.area)
    areas = np.array([shape.area for shape in shapes])
    whole: BaseGeometry = shapely.union_all(shapes)
    access = [e.satisfied for e in edges if e.kind == "access"]
    adjacent = [e.satisfied for e in edges if e.kind == "adjacent"]
    return {
        "rooms": float(len(shapes)),
        "one_piece": float(len(shapes) - verdict.broken),
        "usable": float(len(shapes) - len(verdict.shape_faults)),
        "straddled": sum(verdict.straddled),
        "area_error": float(np.mean(np.abs(areas - model.targets) / model.targets)),
        "coverage": float(whole.intersection(model.region).area) / free,
        "overlap": max(0.0, float(areas.sum() - whole.area)) / free,
        "outside": float(whole.difference(model.region).area) / free,
        "access": float(np.mean(access)) if access else 1.0,
        "adjacent": float(np.mean(adjacent)) if adjacent else 1.0,
        "corners": sum(corner_count(shape) for shape in shapes) / len(shapes),
    }


@dataclass(frozen=True)
class MeasuredPartition:
    """A partition with its rooms' shapes in the model's frame and the verdict on them."""

    partition: Partition
    shapes: list[Polygon | MultiPolygon]
    verdict: Verdict

    @property
    def valid(self) -> bool:
        """Every room is one piece and of a usable shape, and none straddles a structural wall."""
        return self.verdict.violations(()) == (0, 0)


def measure(model: FloorModel, partition: Partition, options: SolverOptions) -> MeasuredPartition:
    """Trace the rooms of a partition and verify them."""
    shapes = room_shapes(model, partition.grid, partition.labels)
    return MeasuredPartition(partition, shapes, verify(model, shapes, options))


def whole_rooms(model: FloorModel, measured: MeasuredPartition, options: SolverOptions) -> MeasuredPartition:
    """Return a partition whose rooms are one piece each, measured again where some were not."""
    if not measured.verdict.broken:
        return measured
    shapes = with_loose_pieces_joined(measured.shapes)
    return MeasuredPartition(measured.partition, shapes, verify(model, shapes, options))
