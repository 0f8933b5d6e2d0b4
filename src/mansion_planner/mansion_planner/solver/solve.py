"""`solve_floor`: from a FloorProblem to a FloorLayout (Algorithm 2)."""

import numpy as np

from mansion_geometry.randomness import item_seed
from mansion_geometry.rings import polygon_parts
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_planner.solver.annealing import Annealing
from mansion_planner.solver.budget import Budget
from mansion_planner.solver.cutting import RoundsResult, run_rounds
from mansion_planner.solver.feasibility import relaxed_links
from mansion_planner.solver.finish import finish
from mansion_planner.solver.grid import Grid, major_lines, make_grid, spaced_lines
from mansion_planner.solver.measured import Measured, measure
from mansion_planner.solver.model import FloorModel, make_model
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.planned import planned_partition, planned_rounds
from mansion_planner.solver.refine import Partition, make_goal, mostly_seeded
from mansion_planner.solver.seeding import SeedCallback
from mansion_planner.solver.starts import flood
from mansion_planner.solver.state import SEED_X, SEED_Y, Floats, Goal
from mansion_planner.solver.wall_search import WallSearch

__all__ = ["coarse_grid", "solve_floor"]


def coarse_grid(model: FloorModel, major: tuple[Floats, Floats], options: SolverOptions) -> Grid:
    """Return the first grid: about `options.cells` cells, up to four times as many for the smallest room."""
    area = float(model.region.area)
    finest = options.spacing if mostly_seeded(model) else options.unseeded_spacing
    spacing = max(finest, (area / options.cells) ** 0.5)
    smallest = 0.5 * float(np.sqrt(model.targets.min()))
    spacing = max(min(spacing, smallest), (area / (4.0 * options.cells)) ** 0.5)
    return make_grid(model, spaced_lines(major[0], spacing), spaced_lines(major[1], spacing))


def _without_search(
    model: FloorModel, goal: Goal, grid: Grid, rounds: RoundsResult, options: SolverOptions
) -> Measured | None:
    """Return the cut rounds' own layout, what they left open filled."""
    labels = rounds.labels.copy()
    if not flood(labels, grid.cells, goal, goal.rooms[:, SEED_X : SEED_Y + 1].copy()):
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
    model = make_model(problem, options)
    _refuse_more_pieces_than_rooms(model)
    relaxed = relaxed_links(model)
    goal = make_goal(model, options, [entry.link for entry in relaxed])
    major = major_lines(model)
    planned = planned_partition(model, major) if options.wall_search else None
    if planned is not None:
        measured = measure(model, planned, options)
        if all(edge.satisfied for edge in measured.verdict.edges) and measured.faultless:
            return finish(model, measured, options, planned_rounds(model, planned), relaxed, 1)
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
        best = _without_search(model, goal, grid, rounds, options)
    if best is None:
        raise _too_small(model)
    return finish(model, best, options, rounds, relaxed, budget.used)
