"""The room graph of a floor problem: its hub, the parent of each room, and zones that vanish into their members.

A node of type ``area`` is a zone: it is split completely and vanishes. Its children open onto the zone's parent unless
they have another access edge, and an edge from elsewhere to the zone goes to its largest member.
"""

from dataclasses import dataclass

import networkx as nx

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorProblem, ProblemNode
from mansion_msgs_py.wording import with_article

__all__ = ["Link", "breadth_first_parents", "resolve_zones"]


@dataclass(frozen=True)
class Link:
    """An edge between two surviving ids; `kind` is ``access`` or ``adjacent``."""

    source: str
    target: str
    kind: str


def select_hub(nodes: list[ProblemNode], graph: "nx.Graph[str]", cores: set[str]) -> str:
    """Return the hub (Algorithm 2, line 1): the largest ``main``, else the room with most access edges."""
    rooms = [node for node in nodes if node.id not in cores]
    if not rooms:
        return ""

    def rank(node: ProblemNode) -> tuple[int, int, float]:
        degree = sum(1 for _, _, data in graph.edges(node.id, data=True) if data["kind"] == "access")
        main = node.type == "main"
        return int(main) + int(node.type != "area"), 0 if main else degree, node.area or 0.0

    return max(rooms, key=rank).id


def room_graph(problem: FloorProblem) -> "nx.Graph[str]":
    """Return the undirected room graph; an access edge outranks an adjacent one of the same pair."""
    graph: nx.Graph[str] = nx.Graph()
    graph.add_nodes_from(node.id for node in problem.nodes)
    for k, edge in enumerate(problem.edges):
        for end in (edge.source, edge.target):
            if end not in graph:
                known = {c.id for c in problem.cores} | {r.id for r in problem.fixed_rooms}
                if end not in known:
                    raise MansionError(
                        ErrorCode.INFEASIBLE,
                        f"the edge names {end!r}, which is not a node, core or fixed room",
                        path=f"$.edges[{k}]",
                    )
                graph.add_node(end)
        if edge.source == edge.target:
            continue
        if graph.has_edge(edge.source, edge.target) and edge.kind != "access":
            continue
        graph.add_edge(edge.source, edge.target, kind=edge.kind)
    return graph


def breadth_first_parents(graph: "nx.Graph[str]", hub: str, order: list[str], barred: set[str]) -> dict[str, str]:
    """Return each room's parent, nearest to the hub first.

    Access edges are followed before adjacent ones; what neither reaches joins the hub. `barred` ids (vertical cores)
    are neither parents nor children.
    """
    parent: dict[str, str] = {}
    place = {name: k for k, name in enumerate(order)}
    for kinds in (("access",), ("access", "adjacent")):
        queue = [hub, *parent]
        while queue:
            current = queue.pop(0)
            near = sorted(
                (n for n in graph[current] if graph[current][n]["kind"] in kinds and n in place), key=place.__getitem__
            )
            for name in near:
                if name != hub and name not in parent and name not in barred:
                    parent[name] = current
                    queue.append(name)
    for name in order:
        if name != hub and name not in parent and name not in barred:
            parent[name] = hub
    return parent


def _living_parent(zone: str, parent: dict[str, str], zones: set[str], hub: str) -> str:
    name = parent.get(zone, hub)
    while name in zones:
        name = parent.get(name, hub)
    return name


def _refuse_unknown_cores(problem: FloorProblem, obstacles: set[str]) -> None:
    """Raise where a ``stair`` or ``elevator`` node has the id of no core."""
    for k, node in enumerate(problem.nodes):
        if node.type in ("stair", "elevator") and node.id not in obstacles:
            raise MansionError(
                ErrorCode.INFEASIBLE,
                f"{node.id!r} is {with_article(node.type)} but no core has that id",
                path=f"$.nodes[{k}]",
            )


def resolve_zones(
    problem: FloorProblem, obstacles: set[str]
) -> tuple[list[ProblemNode], list[str], list[Link], "nx.Graph[str]", list[str]]:
    """Return the rooms to lay out (hub first), the vanishing zones, the links between survivors, the graph and notes.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when a ``stair`` or ``elevator`` node or an edge names nothing that exists.
    """
    _refuse_unknown_cores(problem, obstacles)
    graph = room_graph(problem)
    nodes = [node for node in problem.nodes if node.id not in obstacles]
    hub = select_hub(nodes, graph, obstacles)
    order = [node.id for node in nodes]
    parent = breadth_first_parents(graph, hub, order, obstacles) if nodes else {}
    children: dict[str, list[str]] = {}
    for child, above in parent.items():
        children.setdefault(above, []).append(child)
    zones = {node.id for node in nodes if node.type == "area" and children.get(node.id) and node.id != hub}
    rooms = [node for node in nodes if node.id == hub]
    rooms += [node for node in nodes if node.id != hub and node.id not in zones]
    areas = {node.id: node.area or 0.0 for node in nodes}
    links: dict[frozenset[str], Link] = {}

    def add(a: str, b: str, kind: str) -> None:
        key = frozenset((a, b))
        if a != b and (key not in links or kind == "access"):
            links[key] = Link(a, b, kind)

    for a, b, data in graph.edges(data=True):
        if a not in zones and b not in zones:
            add(a, b, data["kind"])
    notes = []
    for zone in (name for name in order if name in zones):
        above = _living_parent(zone, parent, zones, hub)
        members = _members(zone, children, zones)
        for child in children[zone]:
            has_door = any(data["kind"] == "access" and n not in zones for n, data in graph[child].items())
            if child not in zones and not has_door:
                add(above, child, "access")
        for name, data in graph[zone].items():
            if name not in members and name not in zones and name != above and members:
                add(name, max(members, key=lambda m: areas.get(m, 0.0)), data["kind"])
        notes.append(f"zone {zone} was split into {', '.join(members)}; its rooms open onto {above}")
    return rooms, sorted(zones, key=order.index), list(links.values()), graph, notes


def _members(zone: str, children: dict[str, list[str]], zones: set[str]) -> list[str]:
    """Return the rooms below `zone` that its region is split into."""
    found = []
    for child in children.get(zone, []):
        found.extend(_members(child, children, zones) if child in zones else [child])
    return found
