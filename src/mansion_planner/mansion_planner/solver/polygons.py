"""Room polygons traced from cell labels, covering the free region exactly."""

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import MultiPolygon, Polygon

from mansion_geometry.compiled import Ints
from mansion_geometry.rings import oriented, polygon_parts, rotated, signed_area
from mansion_msgs_py.layout import LayoutRoom
from mansion_planner.solver.grid import Grid
from mansion_planner.solver.problem import FloorModel

__all__ = ["layout_room", "room_shapes", "shape_of_cells", "to_problem_frame", "trace", "with_loose_pieces_joined"]

Ring = list[tuple[float, float]]
Vertex = tuple[int, int]
Mask = NDArray[np.bool_]


def trace(mask: Mask) -> list[list[Vertex]]:
    """Return the rings of grid vertices (row, column) around the cells of `mask`, the cells on their left.

    Cells that meet at a corner only are kept apart. Points on straight lines are left out.
    """
    follow: dict[Vertex, list[Vertex]] = {}

    def edges(found: Mask, start: Vertex, end: Vertex) -> None:
        for j, i in np.argwhere(found).tolist():
            follow.setdefault((j + start[0], i + start[1]), []).append((j + end[0], i + end[1]))

    padded = np.pad(mask, 1)
    edges(mask & ~padded[:-2, 1:-1], (0, 0), (0, 1))
    edges(mask & ~padded[1:-1, 2:], (0, 1), (1, 1))
    edges(mask & ~padded[2:, 1:-1], (1, 1), (1, 0))
    edges(mask & ~padded[1:-1, :-2], (1, 0), (0, 0))

    def take(start: Vertex, end: Vertex) -> None:
        follow[start].remove(end)
        if not follow[start]:
            del follow[start]

    rings = []
    while follow:
        start = min(follow)
        ring = [start]
        before, here = start, follow[start][0]
        take(start, here)
        while here != start:
            ring.append(here)
            step = (here[0] - before[0], here[1] - before[1])
            options = follow[here]
            left = (here[0] + step[1], here[1] - step[0])
            right = (here[0] - step[1], here[1] + step[0])
            turn = options[0] if len(options) == 1 else (right if left not in options else left)
            take(here, turn)
            before, here = here, turn
        rings += [_straightened(simple) for simple in _simple_rings(ring)]
    return rings


def _simple_rings(ring: list[Vertex]) -> list[list[Vertex]]:
    """Return the rings that a ring consists of where it meets itself at a vertex: a room around another's corner."""
    rings: list[list[Vertex]] = []
    path: list[Vertex] = []
    place: dict[Vertex, int] = {}
    for vertex in ring:
        if vertex in place:
            loop = path[place[vertex] :]
            rings.append(loop)
            for passed in loop:
                del place[passed]
            del path[len(path) - len(loop) :]
        place[vertex] = len(path)
        path.append(vertex)
    return [*rings, path]


def _straightened(ring: list[Vertex]) -> list[Vertex]:
    """Drop the vertices at which the ring goes straight on."""
    kept = []
    for k, point in enumerate(ring):
        before, after = ring[k - 1], ring[(k + 1) % len(ring)]
        if not (before[0] == point[0] == after[0] or before[1] == point[1] == after[1]):
            kept.append(point)
    return kept


def _shape_of(xs: list[float], ys: list[float], mask: Mask) -> Polygon | MultiPolygon:
    """Return the shape of the masked cells between lines."""
    outer: list[Ring] = []
    inner: list[Ring] = []
    for vertices in trace(mask):
        ring = [(xs[i], ys[j]) for j, i in vertices]
        (outer if signed_area(ring) > 0 else inner).append(ring)
    if len(outer) == 1:
        return Polygon(outer[0], inner)
    shells = [Polygon(ring) for ring in outer]
    for ring in inner:
        hole = Polygon(ring)
        k = min((k for k, shell in enumerate(shells) if shell.covers(hole)), key=lambda k: shells[k].area)
        shells[k] = shells[k].difference(hole)
    return MultiPolygon(shells)


def _inside(model: FloorModel, grid: Grid, shape: Polygon | MultiPolygon) -> Polygon | MultiPolygon:
    """Return the part of a shape of cells that lies inside the free region."""
    if grid.exact:
        return shape
    parts = polygon_parts(shapely.intersection(shape, model.region))
    return parts[0] if len(parts) == 1 else MultiPolygon(parts)


def shape_of_cells(model: FloorModel, grid: Grid, mask: Mask) -> Polygon | MultiPolygon:
    """Return the part of the masked cells inside the free region, in the model's frame."""
    return _inside(model, grid, _shape_of(grid.cells.xs.tolist(), grid.cells.ys.tolist(), mask))


def room_shapes(model: FloorModel, grid: Grid, labels: Ints) -> list[Polygon | MultiPolygon]:
    """Return each room's shape in the model's frame; together they cover the free region without overlap.

    Lines along which no label changes are left out first, which leaves few cells to trace.
    """
    rows = np.flatnonzero(np.append(True, (labels[1:] != labels[:-1]).any(axis=1)))
    columns = np.flatnonzero(np.append(True, (labels[:, 1:] != labels[:, :-1]).any(axis=0)))
    few = labels[np.ix_(rows, columns)]
    xs = [*grid.cells.xs[columns].tolist(), float(grid.cells.xs[-1])]
    ys = [*grid.cells.ys[rows].tolist(), float(grid.cells.ys[-1])]
    return [_inside(model, grid, _shape_of(xs, ys, few == r)) for r in range(len(model.rooms))]


def with_loose_pieces_joined(shapes: list[Polygon | MultiPolygon]) -> list[Polygon | MultiPolygon]:
    """Return rooms of one piece each: a loose piece goes to the room with which it shares most wall.

    A loose piece is all of a room but its largest part, such as a tip that only touches the rest at a corner of a core.
    One without a neighbour stays where it was.
    """
    parts = [sorted(polygon_parts(shape), key=lambda part: -part.area) for shape in shapes]
    whole = [pieces[0] if pieces else Polygon() for pieces in parts]
    loose = [(part, owner) for owner, pieces in enumerate(parts) for part in pieces[1:]]
    while loose:
        placed = [(part, owner, _most_shared(part, whole)) for part, owner in loose]
        taken = next(((part, owner, host) for part, owner, host in placed if host is not None), None)
        if taken is None:
            break
        part, owner, host = taken
        whole[host] = polygon_parts(shapely.union(whole[host], part))[0]
        loose.remove((part, owner))
    return [
        MultiPolygon([whole[k], *left]) if (left := [p for p, o in loose if o == k]) else whole[k]
        for k in range(len(whole))
    ]


def _most_shared(part: Polygon, rooms: list[Polygon]) -> int | None:
    """Return the room that shares most wall with a piece and stays one piece with it."""
    shared = [float(shapely.intersection(room.boundary, part.boundary).length) for room in rooms]
    for k in sorted(range(len(rooms)), key=lambda k: -shared[k]):
        if shared[k] > 0.0 and len(polygon_parts(shapely.union(rooms[k], part))) == 1:
            return k
    return None


def to_problem_frame(ring: Ring, angle: float, *, ccw: bool = True, digits: int = 4) -> Ring:
    """Return `ring` in the problem's frame, in the wished order, rounded."""
    return [(round(x, digits), round(y, digits)) for x, y in oriented(rotated(ring, -angle), ccw=ccw)]


def layout_room(name: str, shape: Polygon, angle: float) -> LayoutRoom:
    """Return a room in the problem's frame."""
    shell = to_problem_frame(shapely.get_coordinates(shape.exterior)[:-1].tolist(), angle)
    holes = [
        to_problem_frame(shapely.get_coordinates(line)[:-1].tolist(), angle, ccw=False) for line in shape.interiors
    ]
    return LayoutRoom(id=name, polygon=shell, holes=holes)
