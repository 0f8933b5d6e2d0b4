"""Seed boxes that tile the floor are the layout; boxes that nearly do are moved until every edge holds."""

import msgspec
import pytest
from shapely.geometry import Polygon

from mansion_msgs_py.layout import FloorLayout, FloorProblem, ProblemCore, ProblemNode, SeedRange
from mansion_msgs_py.topology import Edge, SeedBox, SeedPlan
from mansion_planner.solver import SolverOptions, solve_floor

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


def hall_and_rooms(share: float, *, areas: bool) -> FloorProblem:
    """A hall with two rooms on it, and a plan that gives `west` a share of the floor."""
    boxes = [
        SeedBox(room_id="west", x=(0.0, 5.0), y=(3.0, 8.0), area=share),
        SeedBox(room_id="east", x=(5.0, 10.0), y=(3.0, 8.0), area=0.2),
    ]
    sizes = {"hall": 32.0, "west": 24.0, "east": 24.0} if areas else dict.fromkeys(("hall", "west", "east"))
    nodes = [ProblemNode(id=n, type="main" if n == "hall" else "Entities", area=area) for n, area in sizes.items()]
    edges = [Edge(source="hall", target=name) for name in ("west", "east")]
    return FloorProblem(boundary=OUTLINE, nodes=nodes, edges=edges, seeds=SeedPlan(boxes=boxes))


def area_of(layout: FloorLayout, name: str) -> float:
    return float(Polygon(next(room for room in layout.rooms if room.id == name).polygon).area)


def test_a_round_grows_rooms_to_the_fraction_that_the_plan_gives_them() -> None:
    rounds_only = SolverOptions(wall_search=False)
    grown = [
        area_of(solve_floor(hall_and_rooms(share, areas=True), options=rounds_only), "west")
        for share in (0.2, 0.3, 0.4)
    ]
    assert grown == pytest.approx([16.0, 24.0, 32.0], rel=0.15)


def test_a_fraction_far_from_the_wished_area_changes_it_within_bounds() -> None:
    layout = solve_floor(hall_and_rooms(0.9, areas=True), options=SolverOptions(wall_search=False))
    assert 24.0 < area_of(layout, "west") < 50.0


@pytest.mark.parametrize("share", [0.1, 0.3, 0.6])
def test_the_fraction_is_the_area_of_a_room_that_has_none(share: float) -> None:
    layout = solve_floor(hall_and_rooms(share, areas=False))
    assert area_of(layout, "west") == pytest.approx(80.0 * share, rel=0.1)
