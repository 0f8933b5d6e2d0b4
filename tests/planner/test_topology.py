"""Room graphs and problems: the schema, and that the floor solver can meet them."""

import pytest

from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest, Footprint
from mansion_planner.fact_score import score_building
from mansion_planner.plan import plan_building
from mansion_planner.plan_report import plan_table
from mansion_planner.solver import solve_floor

BRIEFS = [
    "a small flat",
    "a two-storey house with three bedrooms",
    "a library with a cafe",
    "a supermarket",
    "an L-shaped clinic",
]


@pytest.mark.parametrize("brief", BRIEFS)
def test_the_solver_meets_every_edge(brief: str) -> None:
    reply = plan_building(BuildRequest(description=brief))
    for problem in reply.problems:
        layout = solve_floor(problem)
        assert layout.topology_satisfied, layout.unmet_edges
        assert layout.area_scale == pytest.approx(1.0, abs=0.01)


def test_every_node_has_what_the_schema_asks() -> None:
    reply = plan_building(BuildRequest(description="a three-storey office with elevator"))
    for topology in reply.topologies:
        kinds = [node.type for node in topology.nodes]
        assert kinds.count("main") == 1 and kinds.count("stair") >= 1 and kinds.count("elevator") >= 1
        for node in topology.nodes:
            assert node.floor_material and node.wall_material and node.room_type
            if node.type == "main":
                assert node.open_relation == "open"
            if node.type in ("stair", "elevator"):
                assert node.open_relation == "door"


def test_problems_ask_for_a_door_width_and_carry_the_structural_walls() -> None:
    reply = plan_building(BuildRequest(description="a four-storey office"))
    walls = [problem.structural_walls for problem in reply.problems]
    assert walls[0] and all(other == walls[0] for other in walls)
    assert all(problem.min_access_wall == pytest.approx(1.2) for problem in reply.problems)


def test_suites_hang_on_their_room() -> None:
    reply = plan_building(BuildRequest(description="a three-storey hotel"))
    topology = reply.topologies[1]
    kinds = {node.id: node.room_type for node in topology.nodes}
    parents = {edge.target: edge.source for edge in topology.edges}
    baths = [name for name, kind in kinds.items() if kind == "bathroom"]
    assert baths and all(kinds[parents[name]].startswith("hotel_") for name in baths)


@pytest.mark.parametrize(
    "ring",
    [
        [(0, 0), (20.5, 0), (20.5, 13.3), (0, 13.3)],
        [(5, 5), (15, 5), (15, 30), (5, 30)],
        [(0, 8), (12, 8), (12, 0), (24, 0), (24, 18), (0, 18)],
    ],
)
def test_a_given_footprint_is_kept(ring: list[tuple[float, float]]) -> None:
    from shapely.geometry import Polygon

    reply = plan_building(BuildRequest(description="a two-storey clinic", footprint=Footprint(boundary=ring)))
    for floor in reply.program.floors:
        assert Polygon(floor.outline).symmetric_difference(Polygon(ring)).area < 1e-6


@pytest.mark.parametrize(
    "ring", [[(0, 0), (2, 2), (2, 0), (0, 2)], [(0, 0), (1, 0), (1, 1)], [(0, 0), (float("nan"), 1), (3, 3)]]
)
def test_a_footprint_that_is_no_polygon_is_refused(ring: list[tuple[float, float]]) -> None:
    with pytest.raises(MansionError) as caught:
        plan_building(BuildRequest(description="a house", footprint=Footprint(boundary=ring)))
    assert caught.value.code == "INVALID_PAYLOAD"
    assert caught.value.info.path == "$.footprint.boundary"


def test_an_area_of_the_text_gives_way_to_a_footprint_and_is_reported() -> None:
    footprint = Footprint(boundary=[(0, 0), (20, 0), (20, 10), (0, 10)])
    program = plan_building(BuildRequest(description="a shop of 500 m2", footprint=footprint)).program
    assert program.floors[0].gross_floor_area == pytest.approx(200.0)
    assert [downgrade.wish for downgrade in program.downgrades] == ["500 m2"]


def test_the_scorer_finds_what_is_missing() -> None:
    reply = plan_building(BuildRequest(description="a small flat"))
    layouts = [solve_floor(problem) for problem in reply.problems]
    results = score_building(
        ["floors=1", "floors=2", "room sauna", "room kitchen @1", "absent kitchen"], reply, layouts
    )
    assert [result.met for result in results] == [True, False, False, True, False]
    with pytest.raises(ValueError, match="not a fact"):
        score_building(["colour=red"], reply, layouts)


def test_the_table_has_a_row_for_each_node_and_the_trace_quotes_the_brief() -> None:
    reply = plan_building(BuildRequest(description="a two-storey house with a sauna upstairs"))
    table = plan_table(reply)
    assert len(table.rows) == sum(len(topology.nodes) for topology in reply.topologies)
    assert any(line.startswith('"two-storey" -> 2 storeys') for line in table.trace)
    assert any('"sauna"' in line for line in table.trace)


def test_a_floor_whose_wishes_the_sketch_misses_has_a_problem_to_fall_back_to() -> None:
    brief = (
        "A factory on one floor: a hall of 450 m2, and an office, a lab, a canteen, a workshop, a store and a wash "
        "room, all next to the hall."
    )
    reply = plan_building(BuildRequest(description=brief))
    fallbacks = [problem for problem in reply.fallbacks if problem is not None]
    assert fallbacks
    for problem in fallbacks:
        assert all(edge.kind != "access" for edge in solve_floor(problem).unmet_edges)
