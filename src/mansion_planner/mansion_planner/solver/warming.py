"""Compile the kernels once, so that a first user does not wait."""

from mansion_msgs_py.layout import FloorProblem, ProblemCore, ProblemNode
from mansion_msgs_py.topology import Edge
from mansion_planner.solver.options import SolverOptions

__all__ = ["warm"]


def warm() -> None:
    """Load the kernels from the disk cache, or compile and cache them."""
    from mansion_planner.solver.solve import solve_floor

    nodes = [
        ProblemNode(id="hub", type="main", area=20.0),
        ProblemNode(id="room", type="Entities", area=10.0, seed=(1.5, 2.5)),
        ProblemNode(id="bath", type="Entities", area=5.0, seed=(6.5, 1.0)),
    ]
    core = ProblemCore(id="lift", type="elevator", polygon=[(6, 3), (8, 3), (8, 5), (6, 5)])
    edges = [
        Edge(source="hub", target="room"),
        Edge(source="hub", target="bath"),
        Edge(source="room", target="bath", kind="adjacent"),
        Edge(source="hub", target="lift"),
    ]
    boundary = [(0.0, 0.0), (8.0, 0.0), (8.0, 5.0), (0.0, 5.0)]
    problem = FloorProblem(boundary=boundary, nodes=nodes, edges=edges, cores=[core])
    solve_floor(problem)
    problem.min_access_wall = 4.9
    solve_floor(problem, options=SolverOptions(seeded_proposals=10, proposals=10, attempts=4))
