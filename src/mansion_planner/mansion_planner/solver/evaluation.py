"""Scores of layouts against true plans: the raster-space protocol of the supplement's A.1, edges, areas and shapes.

Both plans are put on 64 x 64 squares aligned to the floor's bounding box, and rooms of the same id are compared.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import msgspec
import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from mansion_geometry.floor_grid import GridFrame
from mansion_geometry.rasters import cells_in, raster_over
from mansion_geometry.rings import as_polygon, polygon_parts
from mansion_geometry.shared_walls import edge_array, longest_wall, shared_walls, total_length
from mansion_msgs_py.layout import FloorLayout, FloorProblem, LayoutRoom
from mansion_planner.solver.batch import solve_timed
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.solve import warm
from mansion_planner.solver.verification import corner_count

__all__ = ["TrueProblem", "figures", "run_protocol", "score_plan", "table"]

SLACK = 1e-3


class TrueProblem(FloorProblem, frozen=True, kw_only=True):
    """A floor problem with the plan that it was taken from."""

    truth: list[LayoutRoom] = msgspec.field(default_factory=list)


@dataclass(frozen=True)
class PlanScore:
    """Counts of one plan; `figures` makes the shares of many plans from them."""

    plan_id: str
    rooms: int
    present: int
    one_piece: int
    intersection: int
    union: int
    macro: float
    area_error: float
    coverage: float
    overlap: float
    outside: float
    access: tuple[int, int]
    adjacent: tuple[int, int]
    corners: int
    seconds: float


@dataclass(frozen=True)
class Interval:
    """A figure and its 95% bootstrap interval over plans."""

    value: float
    low: float
    high: float


def _shapes(rooms: list[LayoutRoom]) -> dict[str, BaseGeometry]:
    """Return each id's shape; entries of the same id are joined."""
    shapes: dict[str, BaseGeometry] = {}
    for room in rooms:
        shape = as_polygon(room.polygon, room.holes)
        shapes[room.id] = shapes[room.id].union(shape) if room.id in shapes else shape
    return shapes


def _edge_counts(problem: FloorProblem, rooms: dict[str, BaseGeometry], touch: float) -> dict[str, list[int]]:
    """Return (met, asked) for access and adjacent edges."""
    shapes = dict(rooms)
    shapes.update((core.id, as_polygon(core.polygon)) for core in problem.cores)
    shapes.update((room.id, as_polygon(room.polygon)) for room in problem.fixed_rooms)
    arrays = {name: edge_array(shape) for name, shape in shapes.items()}
    kinds: dict[tuple[str, str], str] = {}
    for edge in problem.edges:
        pair = (min(edge.source, edge.target), max(edge.source, edge.target))
        if kinds.get(pair) != "access":
            kinds[pair] = edge.kind
    counts = {"access": [0, 0], "adjacent": [0, 0]}
    zones = {node.id for node in problem.nodes if node.type == "area"} - set(rooms)
    for (a, b), kind in sorted(kinds.items()):
        if a in zones or b in zones:
            continue
        walls = shared_walls(arrays[a], arrays[b]) if a in arrays and b in arrays else []
        longest = longest_wall(walls)
        if kind == "access":
            met = longest is not None and longest.length >= problem.min_access_wall - SLACK
        else:
            met = total_length(walls) >= touch - SLACK
        counts[kind][0] += met
        counts[kind][1] += 1
    return counts


def _shared_cells(
    names: Iterable[str], rooms: Mapping[str, BaseGeometry], truth: Mapping[str, BaseGeometry], frame: GridFrame
) -> tuple[int, int, list[float]]:
    """Return the cells that rooms share with their true shapes, those of either, and the quotient for each room."""
    both, either, shares = 0, 0, []
    for name in names:
        given = cells_in(rooms.get(name, shapely.Polygon()), frame)
        true = cells_in(truth.get(name, shapely.Polygon()), frame)
        inner, outer = int((given & true).sum()), int((given | true).sum())
        both, either = both + inner, either + outer
        if outer:
            shares.append(inner / outer)
    return both, either, shares


def score_plan(problem: TrueProblem, layout: FloorLayout, *, cells: int = 64, touch: float = 0.3) -> PlanScore:
    """Score one layout.

    Parameters
    ----------
    cells : int
        Squares along each side of the raster.
    touch : float
        Wall that an ``adjacent`` edge needs, metres.
    """
    outline = as_polygon(problem.boundary)
    free: BaseGeometry = outline
    for ring in [*problem.holes, *(core.polygon for core in problem.cores)]:
        free = free.difference(as_polygon(ring))
    truth = _shapes(problem.truth)
    cores = {core.id for core in problem.cores}
    want = {
        node.id: node.area or 0.0
        for node in problem.nodes
        if node.id not in cores and (node.type != "area" or node.id in truth)
    }
    rooms = {k: s for k, s in _shapes(layout.rooms).items() if k in want and not s.is_empty}
    both, either, shares = _shared_cells(want, rooms, truth, raster_over(outline, cells))
    errors = [
        abs(rooms[name].area - area) / area if name in rooms else 1.0 for name, area in want.items() if area > 0.0
    ]
    whole = shapely.union_all(list(rooms.values())) if rooms else shapely.Polygon()
    counts = _edge_counts(problem, rooms, touch)
    return PlanScore(
        plan_id=str(problem.plan_id),
        rooms=len(want),
        present=len(rooms),
        one_piece=sum(len(polygon_parts(shape)) == 1 for shape in rooms.values()),
        intersection=both,
        union=either,
        macro=float(np.mean(shares)) if shares else 0.0,
        area_error=float(np.sum(errors)),
        coverage=whole.intersection(free).area / free.area,
        overlap=max(0.0, sum(s.area for s in rooms.values()) - whole.area) / free.area,
        outside=whole.difference(free).area / free.area,
        access=(counts["access"][0], counts["access"][1]),
        adjacent=(counts["adjacent"][0], counts["adjacent"][1]),
        corners=sum(corner_count(shape) for shape in rooms.values()),
        seconds=layout.seconds,
    )


def _figures(scores: list[PlanScore]) -> dict[str, float]:
    def pooled(kind: str) -> float:
        met = sum(getattr(s, kind)[0] for s in scores)
        return float(met / max(1, sum(getattr(s, kind)[1] for s in scores)))

    rooms = max(1, sum(s.rooms for s in scores))
    seconds = [s.seconds for s in scores]
    return {
        "IoU micro": sum(s.intersection for s in scores) / max(1, sum(s.union for s in scores)),
        "IoU macro": float(np.mean([s.macro for s in scores])),
        "area error": sum(s.area_error for s in scores) / rooms,
        "access edges met": pooled("access"),
        "plans with all of them": float(np.mean([s.access[0] == s.access[1] for s in scores])),
        "adjacent edges met": pooled("adjacent"),
        "rooms in one piece": sum(s.one_piece for s in scores) / rooms,
        "coverage": float(np.mean([s.coverage for s in scores])),
        "overlap": float(np.mean([s.overlap for s in scores])),
        "outside": float(np.mean([s.outside for s in scores])),
        "corners a room": sum(s.corners for s in scores) / max(1, sum(s.present for s in scores)),
        "seconds, median": float(np.median(seconds)),
        "seconds, 95th percentile": float(np.percentile(seconds, 95)),
    }


def figures(scores: list[PlanScore], *, resamples: int = 1000, seed: int = 0) -> dict[str, Interval]:
    """Return the figures of a list of plans with 95% bootstrap intervals over plans.

    Parameters
    ----------
    resamples : int
        Bootstrap samples.
    seed : int
        Seed of the bootstrap's random draws.
    """
    point = _figures(scores)
    rng = np.random.default_rng(seed)
    drawn = [_figures([scores[k] for k in rng.integers(len(scores), size=len(scores))]) for _ in range(resamples)]
    return {
        name: Interval(
            value,
            float(np.percentile([d[name] for d in drawn], 2.5)),
            float(np.percentile([d[name] for d in drawn], 97.5)),
        )
        for name, value in point.items()
    }


def table(scores: list[PlanScore]) -> str:
    """Return the figures as a Markdown table."""
    lines = ["| figure | value | 95% interval |", "| --- | --- | --- |"]
    for name, entry in figures(scores).items():
        lines.append(f"| {name} | {entry.value:.3f} | {entry.low:.3f} to {entry.high:.3f} |")
    combined = sum(s.rooms for s in scores)
    return "\n".join([f"{len(scores)} plans, {combined} rooms", "", *lines])


def run_protocol(
    problems: list[TrueProblem], *, options: SolverOptions | None = None, seed: int = 0
) -> tuple[list[PlanScore], list[FloorLayout]]:
    """Solve and score every problem, one after the other, after the kernels are warm.

    Parameters
    ----------
    seed : int
        Added to each problem's own seed.
    """
    warm()
    layouts = [solve_timed(msgspec.structs.replace(problem, seed=problem.seed + seed), options) for problem in problems]
    return [score_plan(p, layout) for p, layout in zip(problems, layouts)], layouts
