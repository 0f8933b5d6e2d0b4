"""What a floor's room graph must keep, whoever wrote it: the rules of the topology planner as a check."""

import networkx as nx

from mansion_knowledge import KnowledgeBase
from mansion_msgs_py.topology import FloorTopology, TopologyNode

__all__ = ["MOST_CHILDREN", "access_promoted", "graph_faults"]

MOST_CHILDREN = 18
"""Most doors of one circulation space."""


def access_promoted(topology: FloorTopology) -> FloorTopology:
    """Return the graph with an access edge towards the hub for each node that only ``adjacent`` edges reach.

    The example of Fig. 24 has adjacent edges alone; each node's edge to its breadth-first parent is then promoted.
    """
    hub = _hub(topology)
    if hub is None:
        return topology
    cores = {node.id for node in topology.nodes if node.type in ("stair", "elevator")}
    reached = _reached(_graph(topology, access_only=True), hub.id, cores)
    edges = list(topology.edges)
    while True:
        step = next(
            (
                (k, edge)
                for k, edge in enumerate(edges)
                if edge.kind == "adjacent"
                and (edge.source in reached) != (edge.target in reached)
                and not {edge.source, edge.target} & reached & cores
            ),
            None,
        )
        if step is None:
            break
        k, edge = step
        inner, outer = (edge.source, edge.target) if edge.source in reached else (edge.target, edge.source)
        edges[k] = type(edge)(source=inner, target=outer, kind="access")
        graph = _graph(FloorTopology(nodes=topology.nodes, edges=edges), access_only=True)
        reached = _reached(graph, hub.id, cores)
    return FloorTopology(nodes=topology.nodes, edges=edges, building_id=topology.building_id, floor=topology.floor)


def _hub(topology: FloorTopology) -> TopologyNode | None:
    return next((node for node in topology.nodes if node.type == "main"), None)


def _graph(topology: FloorTopology, *, access_only: bool = False) -> "nx.Graph[str]":
    graph: nx.Graph[str] = nx.Graph()
    graph.add_nodes_from(node.id for node in topology.nodes)
    graph.add_edges_from(
        (edge.source, edge.target)
        for edge in topology.edges
        if edge.source != edge.target and (edge.kind == "access" or not access_only)
    )
    return graph


def _reached(graph: "nx.Graph[str]", hub: str, barred: set[str]) -> set[str]:
    """Return what can be walked to from the hub; `barred` nodes are ends, never ways."""
    found, queue = {hub}, [hub]
    while queue:
        for name in graph[queue.pop()]:
            if name not in found:
                found.add(name)
                if name not in barred:
                    queue.append(name)
    return found


def graph_faults(topology: FloorTopology, knowledge: KnowledgeBase) -> list[str]:
    """Return what is wrong with a room graph; an empty list for a good one.

    One hub; known ends; connected; planar; everything reached by access edges without walking through a core, a toilet
    or somebody's bedroom; no toilet that opens into a kitchen; not too many doors in one place.
    """
    nodes = {node.id: node for node in topology.nodes}
    faults = []
    repeated = sorted({n.id for n in topology.nodes if sum(m.id == n.id for m in topology.nodes) > 1})
    faults += [f"the node id {name} is used more than once" for name in repeated]
    mains = [node.id for node in topology.nodes if node.type == "main"]
    if len(mains) != 1:
        faults.append(f"there must be exactly one node of type main, not {len(mains)}")
    for edge in topology.edges:
        for end in (edge.source, edge.target):
            if end not in nodes:
                faults.append(f"an edge names {end}, which is not a node")
        if edge.source == edge.target:
            faults.append(f"{edge.source} has an edge to itself")
    if faults:
        return faults
    graph = _graph(topology)
    if not nx.is_connected(graph):
        apart = sorted(set(nodes) - nx.node_connected_component(graph, mains[0]))
        return [f"not connected to {mains[0]}: {', '.join(apart[:8])}"]
    if not nx.check_planarity(graph)[0]:
        faults.append("the graph is not planar: no floor plan has it; leave out edges that cross")
    return faults + _walking_faults(topology, nodes, mains[0], knowledge)


def _walking_faults(
    topology: FloorTopology, nodes: dict[str, TopologyNode], hub: str, knowledge: KnowledgeBase
) -> list[str]:
    access = _graph(topology, access_only=True)
    cores = {name for name, node in nodes.items() if node.type in ("stair", "elevator")}
    lost = sorted(set(nodes) - _reached(access, hub, cores))
    faults = [f"{name} is not reached by access edges" for name in lost]
    kinds = {name: knowledge.room(node.room_type) for name, node in nodes.items()}
    sleeping = {name for name, kind in kinds.items() if kind.sleeping and name != hub}
    toilets = {name for name, kind in kinds.items() if kind.toilet and name != hub}
    ways = _reached(access, hub, cores | toilets)
    faults += [f"{name} is reached only through a toilet or bathroom" for name in sorted(set(nodes) - ways - set(lost))]
    for name in sorted(sleeping & ways):
        if name not in _reached(access, hub, cores | toilets | (sleeping - {name})):
            faults.append(f"{name} is reached only through another bedroom")
    for edge in topology.edges:
        pair = (kinds[edge.source], kinds[edge.target])
        if edge.kind == "access" and any(kind.toilet for kind in pair) and any(kind.food for kind in pair):
            faults.append(f"no toilet may open into a kitchen ({edge.source}, {edge.target})")
    for name in access:
        doors = access.degree(name)
        if doors > MOST_CHILDREN:
            faults.append(f"{name} has {doors} access edges; at most {MOST_CHILDREN}: use sub-hubs or area zones")
    for core in sorted(cores):
        if not any(kinds[n].zone in ("circulation", "public") or n == hub or nodes[n].type == "area"
                   for n in access[core]):  # fmt: skip
            faults.append(f"{core} must open to the hub, a corridor or another public space")
    return faults
