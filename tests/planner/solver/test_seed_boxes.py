"""Seed boxes that tile the floor are the layout; boxes that nearly do are moved until every edge holds."""

import msgspec
import pytest

from mansion_msgs_py.layout import FloorLayout, FloorProblem, ProblemCore, ProblemNode, SeedRange
from mansion_msgs_py.topology import Edge
from mansion_planner.solver import solve_floor

OUTLINE = [(0.0, 0.0), (10.0, 0.0), (10.0, 8.0), (0.0, 8.0)]


def node(name: str, area: float, x: tuple[float, float], y: tuple[float, float]) -> ProblemNode:
    kind = "main" if name == "hall" else "Entities"
    return ProblemNode(id=name, type=kind, area=area, seed_box=SeedRange(x=x, y=y))


def office(hall_top: float) -> FloorProblem:
    """A hall below two rooms, and a lift in a corner of the hall."""
    return FloorProblem(
        boundary=OUTLINE,
        cores=[ProblemCore(id="lift", type="elevator", polygon=[(8, 0), (10, 0), (10, 2), (8, 2)])],
        nodes=[
            node("hall", 10.0 * hall_top - 4.0, (0.0, 10.0), (0.0, hall_top)),
            node("west", 6.0 * (8.0 - hall_top), (0.0, 6.0), (hall_top, 8.0)),
            node("east", 4.0 * (8.0 - hall_top), (6.0, 10.0), (hall_top, 8.0)),
            ProblemNode(id="lift", type="elevator"),
        ],
        edges=[Edge(source="hall", target=name) for name in ("west", "east", "lift")],
        min_access_wall=1.2,
    )


def corners(layout: FloorLayout, name: str) -> set[tuple[float, float]]:
    room = next(room for room in layout.rooms if room.id == name)
    return {(x, y) for x, y in room.polygon}


def test_boxes_that_tile_are_taken_as_they_are() -> None:
    layout = solve_floor(office(3.0))
    assert {record.method for record in layout.rounds} == {"planned"}
    assert corners(layout, "west") == {(0, 3), (6, 3), (6, 8), (0, 8)}
    assert corners(layout, "hall") == {(0, 0), (8, 0), (8, 2), (10, 2), (10, 3), (0, 3)}
    assert layout.topology_satisfied


def test_a_loose_box_gets_what_tighter_ones_leave() -> None:
    problem = office(3.0)
    problem.nodes[1] = node("west", 26.0, (0.0, 6.0), (3.0, 8.0))
    problem.nodes.insert(3, node("closet", 4.0, (0.0, 2.0), (6.0, 8.0)))
    problem.edges.append(Edge(source="west", target="closet"))
    layout = solve_floor(problem)
    assert corners(layout, "closet") == {(0, 6), (2, 6), (2, 8), (0, 8)}
    assert layout.topology_satisfied


def test_boxes_that_miss_an_edge_are_moved_until_it_holds() -> None:
    problem = office(3.0)
    problem.nodes[0] = node("hall", 10.0, (0.0, 5.0), (0.0, 2.0))
    problem.nodes[1] = node("west", 36.0, (0.0, 6.0), (2.0, 8.0))
    problem.nodes[2] = node("east", 30.0, (5.0, 10.0), (0.0, 8.0))
    pairs = (("hall", "west"), ("hall", "east"), ("west", "east"), ("east", "lift"))
    edges = [Edge(source=source, target=target) for source, target in pairs]
    layout = solve_floor(msgspec.structs.replace(problem, edges=edges))
    assert layout.topology_satisfied


@pytest.mark.parametrize("wrong", [(0.0, 4.0), (0.0, 12.0)])
def test_boxes_that_do_not_tile_are_seeds_only(wrong: tuple[float, float]) -> None:
    problem = office(3.0)
    problem.nodes[1] = node("west", 30.0, wrong, (4.0, 8.0))
    layout = solve_floor(problem)
    assert all(record.method != "planned" for record in layout.rounds)
    assert layout.checks["coverage"] == pytest.approx(1.0, abs=1e-6)
