"""Whatever the problem: a partition of the free region or a reasoned refusal."""

import shapely
from hypothesis import HealthCheck, given, settings

from mansion_geometry.rings import as_polygon, signed_area
from mansion_msgs_py.codec import encode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorProblem
from mansion_planner.solver import SolverOptions, solve_floor
from problem_floors import parts_for_rooms, problems

QUICK = SolverOptions(candidates=3000, attempts=2, round_candidates=200)


def free_region(problem: FloorProblem) -> shapely.Geometry:
    """Return the boundary less holes, cores and fixed rooms, and less what they leave of no use."""
    free = as_polygon(problem.boundary)
    taken = [*problem.holes, *(c.polygon for c in problem.cores)]
    taken += [room.polygon for room in problem.fixed_rooms]
    for ring in taken:
        free = free.difference(as_polygon(ring))
    return parts_for_rooms(free)


@settings(max_examples=40, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
@given(problems())
def test_a_partition_or_a_reasoned_refusal(problem: FloorProblem) -> None:
    try:
        layout = solve_floor(problem, options=QUICK)
    except MansionError as error:
        assert error.code == ErrorCode.INFEASIBLE
        assert len(str(error)) > 20
        return
    free = free_region(problem)
    fixed = {room.id for room in problem.fixed_rooms}
    shapes = [as_polygon(r.polygon, r.holes) for r in layout.rooms if r.id not in fixed]
    whole = shapely.union_all(shapes)
    assert whole.intersection(free).area >= free.area * (1 - 1e-4) - 2e-3
    assert whole.difference(free).area <= free.area * 1e-4
    assert sum(shape.area for shape in shapes) - whole.area <= free.area * 1e-4
    assert all(shape.geom_type == "Polygon" for shape in shapes)
    assert all(signed_area(r.polygon) > 0 for r in layout.rooms if r.id not in fixed)
    assert layout.checks["candidates"] <= QUICK.candidates
    assert layout.topology_satisfied == (not layout.unmet_edges)
    assert all(edge.reason for edge in layout.unmet_edges)


@settings(max_examples=8, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
@given(problems())
def test_the_same_problem_gives_the_same_bytes(problem: FloorProblem) -> None:
    def answer() -> str:
        try:
            return encode(solve_floor(problem, options=QUICK))
        except MansionError as error:
            return str(error)

    assert answer() == answer()
