"""A floor whose rooms are all given is its own layout, with its edges measured."""

import pytest

from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.layout import FixedRoom, FloorProblem, ProblemNode
from mansion_msgs_py.topology import Edge
from mansion_planner.solver import solve_floor

NODES = [
    ProblemNode(id="hall", type="main", area=16.0),
    ProblemNode(id="den", type="Entities", area=16.0),
    ProblemNode(id="court", type="Entities", area=4.0),
]
HALL = FixedRoom(id="hall", polygon=[(0, 0), (5, 0), (5, 4), (0, 4)], holes=[[(1, 1), (1, 3), (3, 3), (3, 1)]])
DEN = FixedRoom(id="den", polygon=[(5, 0), (9, 0), (9, 4), (5, 4)])
COURT = FixedRoom(id="court", polygon=[(1, 1), (3, 1), (3, 3), (1, 3)])
BOUNDARY = [(0.0, 0.0), (9.0, 0.0), (9.0, 4.0), (0.0, 4.0)]


def problem(*edges: Edge) -> FloorProblem:
    return FloorProblem(boundary=BOUNDARY, nodes=NODES, fixed_rooms=[HALL, DEN, COURT], edges=list(edges))


def test_given_rooms_come_back_as_they_are_with_their_holes() -> None:
    layout = solve_floor(problem(Edge(source="hall", target="den"), Edge(source="hall", target="court")))
    assert [room.id for room in layout.rooms] == ["hall", "den", "court"]
    assert sorted(layout.rooms[0].holes[0]) == [(1.0, 1.0), (1.0, 3.0), (3.0, 1.0), (3.0, 3.0)]
    assert layout.topology_satisfied
    assert [edge.length for edge in layout.edges] == [4.0, 2.0]
    assert layout.hub == "hall"


def test_an_edge_without_a_wall_is_unmet() -> None:
    layout = solve_floor(problem(Edge(source="den", target="court")))
    assert not layout.topology_satisfied
    assert layout.unmet_edges[0].reason == "they share 0.00 m of wall"


def test_faults_are_refused_with_their_place() -> None:
    with pytest.raises(MansionError, match="names 'attic'"):
        solve_floor(problem(Edge(source="den", target="attic")))
    crossed = FixedRoom(id="den", polygon=[(5, 0), (9, 4), (9, 0), (5, 4)])
    with pytest.raises(MansionError, match="den is not a simple polygon") as refusal:
        solve_floor(FloorProblem(boundary=BOUNDARY, nodes=NODES[:2], fixed_rooms=[HALL, crossed]))
    assert refusal.value.info.path == "$.fixed_rooms[1].polygon"


def test_a_room_within_a_given_one_is_drawn_around_it() -> None:
    nodes = [ProblemNode(id="hall", type="main", area=16.0), ProblemNode(id="court", type="Entities", area=4.0)]
    layout = solve_floor(FloorProblem(boundary=HALL.polygon, nodes=nodes, fixed_rooms=[HALL]))
    court = next(room for room in layout.rooms if room.id == "court")
    assert sorted(court.polygon) == [(1.0, 1.0), (1.0, 3.0), (3.0, 1.0), (3.0, 3.0)]
