"""Rooms of a storey, joined by doors: what is reached only through what."""

from collections.abc import Container
from typing import TypeAlias

import networkx as nx

from mansion_bringup.check.norms.premises import rooms_of
from mansion_msgs_py.scene import FloorScene

__all__ = ["OUT", "Doors", "behind", "door_graph", "gets_out", "exit_route"]

OUT = "the open, a stair or a lift"
"""The node that all ways out of a storey end in."""

Doors: TypeAlias = "nx.Graph[str]"
"""Rooms by id, with an edge for each door between two, and `OUT`."""


def door_graph(scene: FloorScene) -> Doors:
    """Return the rooms of a storey, joined by its doors."""
    rooms = {room.id for room in rooms_of(scene)}
    graph: Doors = nx.Graph()
    graph.add_node(OUT)
    for door in scene.doors:
        first, second = (name if name in rooms else OUT for name in door.rooms)
        if door.kind not in ("garage", "balcony") or OUT not in (first, second):
            graph.add_edge(first, second)
    return graph


def behind(doors: Doors, room: str) -> set[str]:
    """Return the rooms that are reached through a room alone, without itself."""
    if room not in doors:
        return set()
    others = doors.subgraph(name for name in doors if name != room)
    reached: set[str] = nx.node_connected_component(others, OUT)
    return set(others) - reached


def gets_out(doors: Doors, room: str, barred: Container[str]) -> bool:
    """Whether a way out of a room leads through none of the barred rooms."""
    return bool(nx.has_path(doors.subgraph([name for name in doors if name == room or name not in barred]), room, OUT))


def exit_route(doors: Doors, room: str) -> list[str]:
    """Return the rooms on the shortest way out of a room, itself left out; none where there is no way at all."""
    return list(nx.shortest_path(doors, room, OUT))[1:-1] if nx.has_path(doors, room, OUT) else []
