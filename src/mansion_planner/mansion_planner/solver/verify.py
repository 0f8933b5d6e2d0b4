"""What a finished layout is worth, measured on its final polygons."""

from collections.abc import Container
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import MultiPolygon, Polygon
from shapely.geometry.base import BaseGeometry

from mansion_geometry.rings import corner_points, polygon_parts
from mansion_geometry.shared_walls import SharedWall, edge_array, longest_wall, shared_walls, total_length
from mansion_msgs_py.layout import RealisedEdge
from mansion_planner.solver.model import FloorModel, Obstacle
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.usable import shape_faults, straddled_lengths

__all__ = ["MOST_STRADDLED", "Verdict", "figures_of", "judge", "on_side", "realise_edges"]

SLACK = 1e-3
GAP = 1e-3

MOST_STRADDLED = 0.05
"""Metres of a structural wall that may lie inside rooms."""


@dataclass(frozen=True)
class Verdict:
    """Edges as realised, and what else is wrong with a layout.

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

    def faults(self, asked: Container[tuple[str, str]]) -> tuple[int, int]:
        """Return the number of open links among `asked`, broken rooms and straddled walls, and that of bad shapes."""
        links = sum(not e.satisfied and (e.source, e.target) in asked for e in self.edges)
        walls = sum(length > MOST_STRADDLED for length in self.straddled)
        return links + self.broken + walls, len(self.shape_faults)


def on_side(wall: SharedWall, obstacle: Obstacle) -> bool:
    """Tell whether a wall, running along the room's boundary, lies on the obstacle's door side.

    The room is on the wall's left, the obstacle on its right, so a room north of the core sees a wall running east.
    """
    if obstacle.side == 0:
        return True
    dx, dy = wall.end[0] - wall.start[0], wall.end[1] - wall.start[1]
    facing = {1: (dx, 0.0), 2: (-dy, 0.0), 3: (-dx, 0.0), 4: (dy, 0.0)}[obstacle.side][0]
    return facing > 0.7 * float(np.hypot(dx, dy))


def _walls(
    edges: dict[str, NDArray[np.float64]], obstacles: dict[str, Obstacle], a: str, b: str, kind: str
) -> list[SharedWall]:
    """Return the walls between `a` and `b` that count for an edge of `kind`."""
    walls = shared_walls(edges[a], edges[b], GAP)
    if kind == "access":
        if b in obstacles:
            walls = [w for w in walls if on_side(w, obstacles[b])]
        if a in obstacles:
            walls = [w for w in walls if on_side(SharedWall(w.end, w.start), obstacles[a])]
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


def judge(model: FloorModel, shapes: list[Polygon | MultiPolygon], options: SolverOptions) -> Verdict:
    """Measure a layout given in the model's frame."""
    return Verdict(
        realise_edges(model, shapes, options),
        sum(len(polygon_parts(shape)) != 1 for shape in shapes),
        shape_faults(model, shapes),
        straddled_lengths(model, shapes),
    )


def figures_of(model: FloorModel, shapes: list[Polygon | MultiPolygon], verdict: Verdict) -> dict[str, float]:
    """Return the figures of a judged layout."""
    edges = verdict.edges
    free = float(model.region.area)
    areas = np.array([shape.area for shape in shapes])
    whole: BaseGeometry = shapely.union_all(shapes)
    access = [e.satisfied for e in edges if e.kind == "access"]
    adjacent = [e.satisfied for e in edges if e.kind == "adjacent"]
    corners = 0
    for shape in shapes:
        for part in polygon_parts(shape):
            for line in (part.exterior, *part.interiors):
                corners += len(corner_points(shapely.get_coordinates(line)[:-1]))
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
        "corners": corners / len(shapes),
    }
