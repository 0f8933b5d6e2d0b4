"""Room graphs that no floor should have are told apart, whoever wrote them."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.topology import Edge, FloorTopology, TopologyNode
from mansion_planner.llm.graph_rules import access_promoted, graph_faults

NODES = ["hallway", "kitchen", "toilet", "bedroom_1", "bedroom_2", "stair_1"]


def graph(*edges: str, names: list[str] = NODES) -> FloorTopology:
    """Return a graph from edges such as ``hallway-kitchen`` (access) and ``kitchen~toilet`` (adjacent)."""
    nodes = [
        TopologyNode(
            id=name,
            type="main" if name == "hallway" else "stair" if name.startswith("stair") else "Entities",
            area=9.0,
            room_type=name.rsplit("_", 1)[0] if name[-1].isdigit() else name,
        )
        for name in names
    ]
    made = []
    for edge in edges:
        kind = "~" if "~" in edge else "-"
        source, target = edge.split(kind)
        made.append(Edge(source=source, target=target, kind="adjacent" if kind == "~" else "access"))
    return FloorTopology(nodes=nodes, edges=made)


STAR = [f"hallway-{name}" for name in NODES[1:]]


def without(*names: str) -> list[str]:
    return [edge for edge in STAR if not edge.endswith(names)]


def test_a_star_is_fine() -> None:
    assert graph_faults(graph(*STAR), default_knowledge()) == []


@pytest.mark.parametrize(
    ("edges", "word"),
    [
        (without("kitchen"), "not connected"),
        ([*STAR, "hallway-attic"], "not a node"),
        ([*STAR, "kitchen-kitchen"], "itself"),
        ([*STAR, "kitchen-toilet"], "toilet may open into a kitchen"),
        ([*without("bedroom_2"), "bedroom_1-bedroom_2"], "another bedroom"),
        ([*without("bedroom_2"), "toilet-bedroom_2"], "through a toilet"),
        ([*without("bedroom_2"), "stair_1-bedroom_2"], "not reached"),
        ([*without("stair_1"), "bedroom_1-stair_1"], "open to the hub"),
        ([*without("kitchen"), "hallway~kitchen"], "not reached"),
    ],
)
def test_faults_are_named(edges: list[str], word: str) -> None:
    assert any(word in fault for fault in graph_faults(graph(*edges), default_knowledge()))


def test_a_graph_that_no_plan_has_is_refused() -> None:
    names = ["hallway", "kitchen", "lounge", "study_room", "storage"]
    every = [f"{a}-{b}" for k, a in enumerate(names) for b in names[k + 1 :]]
    assert any("planar" in f for f in graph_faults(graph(*every, names=names), default_knowledge()))


def test_a_crowded_hub_is_refused() -> None:
    names = ["hallway", *(f"storage_{k}" for k in range(30))]
    star = [f"hallway-{name}" for name in names[1:]]
    assert any("sub-hubs" in f for f in graph_faults(graph(*star, names=names), default_knowledge()))


def test_adjacent_edges_are_promoted_towards_the_hub_alone() -> None:
    promoted = access_promoted(graph(*(edge.replace("-", "~") for edge in STAR), "kitchen~toilet"))
    kinds = {(edge.source, edge.target): edge.kind for edge in promoted.edges}
    assert all(kinds[("hallway", name)] == "access" for name in NODES[1:])
    assert kinds[("kitchen", "toilet")] == "adjacent"
    assert graph_faults(promoted, default_knowledge()) == []


def test_no_promotion_leads_through_a_core() -> None:
    promoted = access_promoted(graph("hallway~stair_1", "stair_1~kitchen", names=["hallway", "stair_1", "kitchen"]))
    assert [edge.kind for edge in promoted.edges] == ["access", "adjacent"]
