"""Seeds of a cut round: given, from a callback, or planned from graph and region (Algorithm 3, lines 2 to 4)."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from mansion_geometry.rings import rotated
from mansion_msgs_py.layout import LayoutRoom
from mansion_msgs_py.topology import SeedPlan
from mansion_planner.solver.model import FloorModel
from mansion_planner.solver.rounds import CutRound
from mansion_planner.solver.state import Floats

__all__ = ["SeedCallback", "SeedRequest", "plan_seeds", "seeds_from_plan"]

DRAWS = 64


@dataclass(frozen=True)
class SeedRequest:
    """What a seed callback is asked before a round.

    Attributes
    ----------
    parent : str
    children : tuple of str
    fractions : dict
        Wished share of the parent's area for each child, ``alpha_r``.
    x_range, y_range : (float, float)
        The parent's bounding box, metres.
    neighbours : tuple of str
        Rooms and cores that touch the parent's region.
    layout : list of LayoutRoom
        The layout so far.
    preview : bytes
        PNG image of it with the parent highlighted.
    """

    parent: str
    children: tuple[str, ...]
    fractions: dict[str, float]
    x_range: tuple[float, float]
    y_range: tuple[float, float]
    neighbours: tuple[str, ...]
    layout: list[LayoutRoom]
    preview: bytes


SeedCallback = Callable[[SeedRequest], SeedPlan | None]


def seeds_from_plan(plan: SeedPlan, cut: CutRound, angle: float) -> dict[str, tuple[float, float]]:
    """Return the centre of each child's box, in the model's frame; boxes of other rooms are ignored."""
    centres = {}
    for box in plan.boxes:
        if box.room_id in cut.children:
            centre = ((box.x[0] + box.x[1]) / 2, (box.y[0] + box.y[1]) / 2)
            if np.isfinite(centre).all():
                centres[box.room_id] = rotated([centre], angle)[0]
    return centres


def plan_seeds(
    model: FloorModel,
    cut: CutRound,
    cells: Floats,
    placed: dict[str, tuple[float, float]],
    known: dict[str, tuple[float, float]],
    rng: np.random.Generator,
) -> Floats:
    """Return a seed for each child: the known ones, and the best of some random draws for the others.

    A draw is good when its seeds are far apart, near the neighbours that are already `placed`, and near each other
    where the graph joins them.

    Parameters
    ----------
    cells : (n, 2) array
        Centres of the parent's cells.
    """
    fixed = np.array([name in known for name in cut.children])
    seeds = np.zeros((len(cut.children), 2))
    for k, name in enumerate(cut.children):
        if fixed[k]:
            seeds[k] = known[name]
    if fixed.all():
        return seeds
    spread = max(0.5, float(np.sqrt(np.prod(np.ptp(cells, axis=0) + 0.5) / len(seeds))))
    draws = cells[rng.integers(len(cells), size=(DRAWS, len(seeds)))]
    trials = np.where(fixed[None, :, None], seeds, draws)
    best: Floats = trials[int(np.argmin(_plan_costs(model, cut, trials, placed, spread)))]
    return best


def _plan_costs(
    model: FloorModel, cut: CutRound, trials: Floats, placed: dict[str, tuple[float, float]], spread: float
) -> Floats:
    """Return the cost of each trial, an array (draws, children, 2) of seeds."""
    a, b = np.triu_indices(trials.shape[1], 1)
    gap = np.linalg.norm(trials[:, a] - trials[:, b], axis=-1)
    cost: Floats = np.maximum(0.0, spread - gap).sum(axis=1)
    at = {name: trials[:, k] for k, name in enumerate(cut.children)}
    for name in cut.children:
        for other in model.graph[name]:
            where = at.get(other)
            if where is None and other in placed and other != cut.parent:
                where = np.array(placed[other])
            if where is not None:
                cost += 0.3 * np.linalg.norm(at[name] - where, axis=-1)
    return cost
