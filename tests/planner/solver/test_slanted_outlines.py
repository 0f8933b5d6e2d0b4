"""Outlines with slanted sides: their grids stay as coarse as the rooms need, also where they cut cores off."""

import numpy as np
import shapely
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from mansion_geometry.rings import as_polygon
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorProblem, ProblemCore, ProblemNode
from mansion_msgs_py.topology import Edge
from mansion_planner.solver import SolverOptions, solve_floor
from mansion_planner.solver.grid import Grid, major_lines, make_grid, refined_grid, spaced_lines
from mansion_planner.solver.problem import make_model
from problem_floors import box, parts_for_rooms

LEVELS = ((0.22, 0.1), (0.07, 0.03), (0.3, 0.1))
"""Offsets of grids that refine one another."""

QUICK = SolverOptions(candidates=2000, attempts=2, round_candidates=200)


@st.composite
def problems(draw: st.DrawFn) -> FloorProblem:
    """Draw a house whose corners are moved, up to beyond the core in one of them."""
    wide, deep = draw(st.floats(6.0, 14.0)), draw(st.floats(6.0, 12.0))
    aside = st.floats(-0.45, 0.45)
    ring = [(x + wide * draw(aside), y + deep * draw(aside)) for x, y in box(0, 0, wide, deep)]
    if draw(st.booleans()):
        ring.pop(draw(st.integers(0, 3)))
    side = draw(st.sampled_from([None, "east"]))
    core = ProblemCore(id="stair", type="stair", polygon=box(0, 0, 2, 4), door_side=side)
    names = ["hall", *(f"room{k}" for k in range(draw(st.integers(1, 4))))]
    nodes = [ProblemNode(id=name, type="Entities" if k else "main") for k, name in enumerate(names)]
    edges = [Edge(source="hall", target=name) for name in (*names[1:], "stair")]
    return FloorProblem(boundary=ring, nodes=nodes, edges=edges, cores=[core], seed=draw(st.integers(0, 5)))


def in_columns(grid: Grid, rooms: int) -> np.ndarray:
    """Return labels that give each room the same number of the grid's columns."""
    column = np.arange(grid.base.shape[1]) * rooms // grid.base.shape[1]
    return np.where(grid.base >= 0, grid.base, column[None, :])


@settings(max_examples=60, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
@given(problems())
def test_a_finer_grid_has_lines_beside_walls_alone(problem: FloorProblem) -> None:
    try:
        model = make_model(problem, QUICK)
    except MansionError as error:
        assert error.code == ErrorCode.INFEASIBLE
        return
    major = major_lines(model)
    grid = make_grid(model, spaced_lines(major[0], 0.4), spaced_lines(major[1], 0.4))
    labels = in_columns(grid, len(model.rooms))
    walls, corners = len(model.rooms) - 1, len(shapely.get_coordinates(model.region))
    for offsets in LEVELS:
        finer, labels = refined_grid(model, major, grid, labels, offsets)
        added = (1 + 2 * len(offsets)) * (walls + corners)
        assert len(finer.cells.xs) <= len(grid.cells.xs) + added
        assert len(finer.cells.ys) <= len(grid.cells.ys) + added
        assert (labels[finer.cells.free] < len(model.rooms)).all()
        assert (labels[~finer.cells.free] >= len(model.rooms)).all()
        grid = finer


@settings(max_examples=25, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
@given(problems())
def test_an_outline_that_cuts_a_core_off_gives_a_partition_or_a_refusal(problem: FloorProblem) -> None:
    free = parts_for_rooms(as_polygon(problem.boundary).difference(as_polygon(problem.cores[0].polygon)))
    try:
        layout = solve_floor(problem, options=QUICK)
    except MansionError as error:
        assert error.code == ErrorCode.INFEASIBLE and len(str(error)) > 20
        return
    shapes = [as_polygon(room.polygon, room.holes) for room in layout.rooms]
    slack = max(1e-3 * free.area, 5e-4)  # corners are rounded to a tenth of a millimetre, and some parts are slivers
    assert sum(shape.area for shape in shapes) >= free.area - slack
    assert shapely.union_all(shapes).difference(free).area <= slack
    assert all(edge.reason for edge in layout.unmet_edges)


def test_a_core_outside_of_the_outline_is_named_with_what_is_left_of_its_walls() -> None:
    nodes = [ProblemNode(id="hall", type="main"), ProblemNode(id="room", type="Entities")]
    edges = [Edge(source="hall", target="room"), Edge(source="hall", target="stair")]
    core = ProblemCore(id="stair", type="stair", polygon=box(0, 0, 2, 4), door_side="east")
    problem = FloorProblem(boundary=[(8, 0), (8, 10), (4, 10)], nodes=nodes, edges=edges, cores=[core])
    layout = solve_floor(problem, options=QUICK)
    assert [(edge.target, "stair has 0.00 m" in edge.reason) for edge in layout.unmet_edges] == [("stair", True)]


def house_of_two_rooms(boundary: list[tuple[float, float]]) -> FloorProblem:
    nodes = [ProblemNode(id="hall", type="main"), ProblemNode(id="room", type="Entities")]
    edges = [Edge(source="hall", target="room"), Edge(source="hall", target="stair")]
    core = ProblemCore(id="stair", type="stair", polygon=box(0, 0, 2, 4))
    return FloorProblem(boundary=boundary, nodes=nodes, edges=edges, cores=[core])


def test_a_tip_behind_a_core_belongs_to_the_room_beside_it() -> None:
    problem = house_of_two_rooms([(0, 0), (6, -1.5), (7.5, 6), (-1.5, 7.5)])
    layout = solve_floor(problem, options=QUICK)
    tip = shapely.Point(-0.3, 2.5)
    assert [room.id for room in layout.rooms if as_polygon(room.polygon).contains(tip)] == ["room"]
    assert layout.checks["coverage"] > 0.999


def test_a_strip_that_a_core_cuts_off_stays_without_a_room_and_is_told() -> None:
    layout = solve_floor(house_of_two_rooms([(0, 0), (6, 1.5), (6.375, 6), (-0.375, 3.75)]), options=QUICK)
    assert any("0.73 m2 at (-0." in message and "stay without one" in message for message in layout.messages)
    assert layout.checks["coverage"] > 0.999


def test_a_side_that_is_nearly_straight_leaves_the_frame_of_the_grid_outside() -> None:
    problem = house_of_two_rooms([(0, 0), (6, 0), (6, 6), (1.5, 6 - 3e-9)])
    model = make_model(problem, QUICK)
    grid = make_grid(model, *major_lines(model))
    frame = np.concatenate([grid.base[0], grid.base[-1], grid.base[:, 0], grid.base[:, -1]])
    assert (frame >= len(model.rooms)).all()
    assert solve_floor(problem, options=QUICK).checks["coverage"] > 1 - 1e-6
