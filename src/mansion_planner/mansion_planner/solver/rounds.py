"""Cut rounds: who is split into whom, breadth first from the hub (Algorithm 2, lines 1 and 2)."""

from dataclasses import dataclass

from mansion_planner.solver.model import FloorModel
from mansion_planner.solver.zones import breadth_first_parents

__all__ = ["CutRound", "build_cut_rounds", "subtree_areas"]


@dataclass(frozen=True)
class CutRound:
    """One round ``(p_t, C_t)``; a vanishing parent (a zone) keeps no ground."""

    parent: str
    children: tuple[str, ...]
    vanishes: bool


def _order(model: FloorModel) -> list[str]:
    return [room.id for room in model.rooms] + list(model.zones)


def build_cut_rounds(model: FloorModel, root: str | None = None) -> list[CutRound]:
    """Return the rounds, grouped by depth and parent; vertical cores and fixed rooms take no part.

    No child comes before its parent. Rooms that no edge reaches join the first room's round.

    Parameters
    ----------
    root : str, optional
        Room to start from instead of the hub.
    """
    root = root or model.hub
    barred = {o.id for o in model.obstacles}
    order = _order(model)
    parent = breadth_first_parents(model.graph, root, order, barred)
    rounds: list[CutRound] = []
    queue = [root]
    while queue:
        current = queue.pop(0)
        children = tuple(name for name in order if parent.get(name) == current)
        if children:
            rounds.append(CutRound(current, children, current in model.zones))
            queue.extend(children)
    return rounds


def subtree_areas(model: FloorModel, rounds: list[CutRound]) -> dict[str, float]:
    """Return, for each room and zone, the area of all rooms cut from it, its own included."""
    areas = {room.id: float(target) for room, target in zip(model.rooms, model.targets)}
    areas.update(dict.fromkeys(model.zones, 0.0))
    for cut in reversed(rounds):
        areas[cut.parent] += sum(areas[child] for child in cut.children)
    return areas
