"""Why an edge of the room graph cannot be realised, found before any search."""

from dataclasses import dataclass

import networkx as nx

from mansion_geometry.shared_walls import edge_array, shared_walls
from mansion_planner.solver.model import FloorModel
from mansion_planner.solver.verify import on_side
from mansion_planner.solver.zones import Link

__all__ = ["Relaxed", "relaxed_links"]


@dataclass(frozen=True)
class Relaxed:
    """A link that the search does not ask for, and why."""

    link: Link
    reason: str


def _core_without_wall(model: FloorModel, link: Link) -> str:
    """Return why a core cannot be entered at all, or an empty string."""
    if link.kind != "access":
        return ""
    for obstacle in model.obstacles:
        if obstacle.id not in (link.source, link.target):
            continue
        region = edge_array(model.region)
        walls = shared_walls(region, edge_array(obstacle.polygon), 1e-3)
        walls = [wall for wall in walls if on_side(wall, obstacle)]
        longest = max((wall.length for wall in walls), default=0.0)
        if longest < model.problem.min_access_wall - 1e-3:
            side = {0: "a", 1: "the north", 2: "the east", 3: "the south", 4: "the west"}
            return (
                f"{obstacle.id} has {longest:.2f} m of straight wall to the free region on "
                f"{side[obstacle.side]} side, {model.problem.min_access_wall:g} m are needed"
            )
    return ""


def _too_small(model: FloorModel, link: Link) -> str:
    """Return why a room is too small for a door wall, or an empty string."""
    if link.kind != "access":
        return ""
    for room, target in zip(model.rooms, model.targets.tolist()):
        need = model.problem.min_access_wall
        if room.id in (link.source, link.target) and target < 0.05 * need * need:
            return f"{room.id} has {target:.3g} m2, too little for a wall of {need:g} m"
    return ""


def relaxed_links(model: FloorModel) -> list[Relaxed]:
    """Return the links that no layout can realise together with the rest.

    Touching regions form a planar graph, so of a non-planar room graph some edges have to go: access edges are kept
    first, then adjacent ones, each as long as the graph stays planar.
    """
    relaxed: list[Relaxed] = []
    alive: list[Link] = []
    for link in model.links:
        reason = _core_without_wall(model, link) or _too_small(model, link)
        if reason:
            relaxed.append(Relaxed(link, reason))
        else:
            alive.append(link)
    graph: nx.Graph[str] = nx.Graph()
    graph.add_edges_from((link.source, link.target) for link in alive)
    if nx.check_planarity(graph)[0]:
        return relaxed
    kept: nx.Graph[str] = nx.Graph()
    for link in sorted(alive, key=lambda link: link.kind != "access"):
        kept.add_edge(link.source, link.target)
        if not nx.check_planarity(kept)[0]:
            kept.remove_edge(link.source, link.target)
            reason = "the room graph is not planar; regions of a floor cannot all touch like that"
            relaxed.append(Relaxed(link, reason))
    return relaxed
