"""Rooms, stairs and lifts of a building as a graph, joined by doors."""

from collections.abc import Sequence

import networkx as nx

from mansion_msgs_py.scene import FloorScene

__all__ = ["room_graph"]


def room_graph(scenes: Sequence[FloorScene]) -> "nx.Graph[str]":
    """Return the graph of `Building.graph`."""
    graph: nx.Graph[str] = nx.Graph()
    for scene in scenes:
        cores = {core.id for core in scene.cores}
        for room in scene.rooms:
            if room.kind not in ("stair", "elevator"):
                graph.add_node(room.id, kind=room.kind, type=room.room_type, floor=scene.floor, area=room.area)
        for core in scene.cores:
            graph.add_node(core.id, kind=core.type, type=core.type, floor=None, area=None)
        for door in scene.doors:
            one, other = (_node(name, cores) for name in door.rooms)
            if one and other:
                graph.add_edge(one, other, door=door.id, kind=door.kind, width=door.width)
    return graph


def _node(room: str | None, cores: set[str]) -> str:
    """Return the node of what a door joins; a core is one node on all floors, the outside is none."""
    name = room or ""
    last = name.rpartition("/")[2]
    return last if last in cores else name
