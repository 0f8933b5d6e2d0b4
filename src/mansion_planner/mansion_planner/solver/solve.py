"""`solve_floor`: from a FloorProblem to a FloorLayout (Algorithm 2, then the wall search)."""

import msgspec
import numpy as np
from shapely.geometry import MultiPolygon, Polygon

from mansion_geometry.compiled import Floats
from mansion_geometry.randomness import item_seed
from mansion_geometry.rings import polygon_parts
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import (
    FloorLayout,
    FloorProblem,
    LayoutRoom,
    ProblemCore,
    ProblemNode,
    RealisedEdge,
    UnmetEdge,
)
from mansion_msgs_py.topology import Edge
from mansion_planner.solver.annealing import Annealing
from mansion_planner.solver.cut_rounds import RoundsResult, SeedCallback, planned_rounds, run_rounds
from mansion_planner.solver.given_layout import given_layout, is_given
from mansion_planner.solver.grid import Grid, major_lines, make_grid, spaced_lines
from mansion_planner.solver.options import Budget, SolverOptions
from mansion_planner.solver.partition import Partition
from mansion_planner.solver.polygons import layout_room, to_problem_frame
from mansion_planner.solver.problem import (
    LEAST_AREA,
    SEED_X,
    SEED_Y,
    FloorModel,
    Goal,
    RelaxedLink,
    make_goal,
    make_model,
    mostly_seeded,
    relaxed_links,
)
from mansion_planner.solver.starts import flood, planned_partition
from mansion_planner.solver.verification import (
    MOST_STRADDLED,
    MeasuredPartition,
    Verdict,
    layout_checks,
    measure,
    whole_rooms,
)
from mansion_planner.solver.wall_search import WallSearch

__all__ = ["coarse_grid", "solve_floor", "warm"]


def _edge_in_problem_frame(edge: RealisedEdge, angle: float) -> RealisedEdge:
    """Return the edge with its wall in the problem's frame, rounded."""
    wall = edge.wall
    if wall is not None:
        start, end = (to_problem_frame([point], angle)[0] for point in wall)
        wall = (start, end)
    return msgspec.structs.replace(edge, length=round(edge.length, 4), wall=wall)


def _reason(
    model: FloorModel, edge: RealisedEdge, relaxed: list[RelaxedLink], options: SolverOptions, used: int
) -> str:
    """Return why an edge is not realised: found before the search, or what the search came to."""
    for entry in relaxed:
        if {entry.link.source, entry.link.target} == {edge.source, edge.target}:
            return entry.reason
    need = model.problem.min_access_wall if edge.kind == "access" else options.adjacent_wall
    shared = "they do not touch"
    if edge.length > 0.0:
        shared = f"they share {edge.length:.2f} m of wall"
    return f"{shared}, {need:g} m are needed; {used} candidate layouts were looked at"


def _messages(verdict: Verdict) -> list[str]:
    """Return what is wrong with shapes and structural walls, in words."""
    lines = [f"{name}: {reason}" for name, reason in verdict.shape_faults.items()]
    lines += [
        f"structural wall {k} lies inside rooms for {length:.2f} m"
        for k, length in enumerate(verdict.straddled)
        if length > MOST_STRADDLED
    ]
    return lines


def _assemble_layout(
    model: FloorModel,
    measured: MeasuredPartition,
    options: SolverOptions,
    rounds: RoundsResult,
    relaxed: list[RelaxedLink],
    used: int,
) -> FloorLayout:
    """Return the payload of the best partition, measured on its final polygons."""
    shapes, verdict = measured.shapes, measured.verdict
    rooms = [
        layout_room(room.id, max(polygon_parts(shape), key=lambda p: p.area), model.angle)
        for room, shape in zip(model.rooms, shapes)
    ]
    rooms += [LayoutRoom(id=r.id, polygon=r.polygon, holes=r.holes) for r in model.problem.fixed_rooms]
    edges = [_edge_in_problem_frame(edge, model.angle) for edge in verdict.edges]
    unmet = [
        UnmetEdge(source=e.source, target=e.target, kind=e.kind, reason=_reason(model, e, relaxed, options, used))
        for e in edges
        if not e.satisfied
    ]
    return FloorLayout(
        rooms=rooms,
        topology_satisfied=not unmet,
        unmet_edges=unmet,
        plan_id=model.problem.plan_id,
        edges=edges,
        rounds=rounds.records,
        hub=model.hub,
        area_scale=round(model.area_scale, 6),
        scores={"energy": round(measured.partition.energy, 6), "rounds": round(rounds.energy, 6)},
        checks={name: round(value, 9) for name, value in layout_checks(model, shapes, verdict).items()}
        | {"candidates": float(used)},
        messages=[*model.messages, *_messages(verdict)],
        building_id=model.problem.building_id,
        floor=model.problem.floor,
    )


def coarse_grid(model: FloorModel, major: tuple[Floats, Floats], options: SolverOptions) -> Grid:
    """Return the first grid: about `options.cells` cells, up to four times as many for the smallest room."""
    area = float(model.region.area)
    finest = options.spacing if mostly_seeded(model) else options.unseeded_spacing
    spacing = max(finest, (area / options.cells) ** 0.5)
    smallest = 0.5 * float(np.sqrt(model.targets.min()))
    spacing = max(min(spacing, smallest), (area / (4.0 * options.cells)) ** 0.5)
    return make_grid(model, spaced_lines(major[0], spacing), spaced_lines(major[1], spacing))


def _fill_rounds(
    model: FloorModel, goal: Goal, grid: Grid, rounds: RoundsResult, options: SolverOptions
) -> MeasuredPartition | None:
    """Return the layout of the cut rounds alone, with the cells that they left over given to rooms."""
    labels = flood(rounds.labels, grid.cells, goal, goal.rooms[:, SEED_X : SEED_Y + 1].copy())
    if labels is None:
        return None
    return measure(model, Partition(grid, labels, rounds.energy), options)


def _round_candidates(options: SolverOptions, rooms: int) -> int:
    """Return the most candidates of the cut rounds: all, or their share where the wall search follows."""
    if not options.wall_search:
        return options.candidates
    return min(options.candidates, max(1, options.round_candidates // rooms))


def _refuse_more_pieces_than_rooms(model: FloorModel) -> None:
    """Raise ``INFEASIBLE`` where the free region has more pieces than there are rooms."""
    pieces = len(polygon_parts(model.region))
    if pieces > len(model.rooms):
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"cores, holes and fixed rooms cut the free region into {pieces} pieces, but there are "
            f"{len(model.rooms)} rooms, and every room is one piece",
            path="$.boundary",
        )


def _too_small(model: FloorModel) -> MansionError:
    """Return the error of a floor on which no partition was found."""
    return MansionError(
        ErrorCode.INFEASIBLE,
        f"{len(model.rooms)} rooms do not fit into {model.region.area:.2f} m2 of free region",
        path="$.nodes",
        details={"free_area": round(float(model.region.area), 3)},
    )


def _loose_pieces(shape: Polygon | MultiPolygon) -> list[Polygon]:
    """Return all parts of a room but the largest and those too small to tell."""
    parts = sorted(polygon_parts(shape), key=lambda part: -part.area)
    return [part for part in parts[1:] if part.area > LEAST_AREA]


def _cut_off(model: FloorModel, part: Polygon) -> MansionError:
    """Return the error of a floor with a part that no room reaches."""
    inside = part.representative_point()
    ((x, y),) = to_problem_frame([(inside.x, inside.y)], model.angle)
    return MansionError(
        ErrorCode.INFEASIBLE,
        f"{part.area:.2f} m2 at ({x:.2f}, {y:.2f}) are cut off by cores, holes or fixed rooms, and no room fits there",
        path="$.boundary",
    )


def solve_floor(
    problem: FloorProblem, *, options: SolverOptions | None = None, seed_callback: SeedCallback | None = None
) -> FloorLayout:
    """Lay out one floor: cut rounds from the hub outwards, then a search that moves the walls.

    Parameters
    ----------
    problem : FloorProblem
        Free region, cores, room graph and areas; its `seed` decides every random draw.
    options : SolverOptions, optional
    seed_callback : callable, optional
        Asked for a SeedPlan before each cut round (Algorithm 3, lines 1 to 4).

    Returns
    -------
    FloorLayout
        A partition of the free region. Edges that could not be realised are in ``unmet_edges``, each with the reason.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with the place and the reason when no partition can exist.

    Examples
    --------
    >>> from mansion_msgs_py.layout import ProblemNode
    >>> nodes = [ProblemNode(id="hall", type="main", area=8.0), ProblemNode(id="den", type="Entities", area=16.0)]
    >>> ring = [(0.0, 0.0), (6.0, 0.0), (6.0, 4.0), (0.0, 4.0)]
    >>> sorted(room.id for room in solve_floor(FloorProblem(boundary=ring, nodes=nodes)).rooms)
    ['den', 'hall']
    """
    options = options or SolverOptions()
    if is_given(problem):
        return given_layout(problem)
    model = make_model(problem, options)
    _refuse_more_pieces_than_rooms(model)
    relaxed = relaxed_links(model)
    goal = make_goal(model, options, [entry.link for entry in relaxed])
    major = major_lines(model)
    planned = planned_partition(model, major) if options.wall_search else None
    if planned is not None:
        measured = measure(model, planned, options)
        if all(edge.satisfied for edge in measured.verdict.edges) and measured.valid:
            return _assemble_layout(model, measured, options, planned_rounds(model, planned), relaxed, 1)
    grid = coarse_grid(model, major, options)
    budget = Budget(options.candidates)
    rng = np.random.default_rng(item_seed(problem.seed, "floor", problem.plan_id))
    round_budget = Budget(_round_candidates(options, len(model.rooms)))
    rounds = run_rounds(model, goal, grid, options, round_budget, rng, seed_callback)
    budget.take(round_budget.used)
    if options.wall_search:
        annealing = Annealing(model, goal, grid, major, options, budget, rng)
        best, rounds = WallSearch(annealing).run(rounds, planned)
    else:
        best = _fill_rounds(model, goal, grid, rounds, options)
    if best is None:
        raise _too_small(model)
    whole = whole_rooms(model, best, options)
    if any(shape.is_empty for shape in whole.shapes):
        raise _too_small(model)
    if cut_off := [part for shape in whole.shapes for part in _loose_pieces(shape)]:
        raise _cut_off(model, cut_off[0])
    return _assemble_layout(model, whole, options, rounds, relaxed, budget.used)


def warm() -> None:
    """Load the kernels from the disk cache, or compile and cache them."""
    nodes = [
        ProblemNode(id="hub", type="main", area=20.0),
        ProblemNode(id="room", type="Entities", area=10.0, seed=(1.5, 2.5)),
        ProblemNode(id="bath", type="Entities", area=5.0, seed=(6.5, 1.0)),
    ]
    core = ProblemCore(id="lift", type="elevator", polygon=[(6, 3), (8, 3), (8, 5), (6, 5)])
    edges = [
        Edge(source="hub", target="room"),
        Edge(source="hub", target="bath"),
        Edge(source="room", target="bath", kind="adjacent"),
        Edge(source="hub", target="lift"),
    ]
    boundary = [(0.0, 0.0), (8.0, 0.0), (8.0, 5.0), (0.0, 5.0)]
    problem = FloorProblem(boundary=boundary, nodes=nodes, edges=edges, cores=[core])
    solve_floor(problem)
    # No wall of 4.9 m fits, so that every kind of start and repair is compiled as well.
    unsolvable = msgspec.structs.replace(problem, min_access_wall=4.9)
    solve_floor(unsolvable, options=SolverOptions(seeded_proposals=10, proposals=10, attempts=4))
