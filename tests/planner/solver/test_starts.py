"""Starts of later attempts: rounds rooted at another room, and open access edges carved through other rooms."""

import numpy as np
import pytest

from mansion_msgs_py.layout import FloorProblem, ProblemNode, SeedRange
from mansion_msgs_py.topology import Edge
from mansion_planner.solver import SolverOptions
from mansion_planner.solver.annealing import Annealing
from mansion_planner.solver.cut_rounds import RoundsResult, build_cut_rounds, run_rounds
from mansion_planner.solver.grid import AREA, Grid, major_lines, make_grid, spaced_lines
from mansion_planner.solver.options import Budget
from mansion_planner.solver.partition import Partition, State, make_state
from mansion_planner.solver.problem import FloorModel, Goal, make_goal, make_model
from mansion_planner.solver.starts import carve_open_links, flood, planned_partition
from mansion_planner.solver.wall_search import AttemptStarts
from problem_floors import box, flat

OPTIONS = SolverOptions()


def prepared(problem: FloorProblem, spacing: float) -> tuple[FloorModel, Goal, Grid]:
    """Return the model, the goal and a grid of a problem."""
    model = make_model(problem, OPTIONS)
    xs, ys = major_lines(model)
    grid = make_grid(model, spaced_lines(xs, spacing), spaced_lines(ys, spacing))
    return model, make_goal(model, OPTIONS), grid


def rooted(root: str | None, candidates: int) -> tuple[FloorModel, RoundsResult]:
    """Return the rounds of the small flat from `root`."""
    model, goal, grid = prepared(flat(), 0.5)
    rng = np.random.default_rng(0)
    return model, run_rounds(model, goal, grid, OPTIONS, Budget(candidates), rng, root=root)


def three_in_a_row() -> tuple[Goal, Grid, State]:
    """Return a left, a middle and a right room side by side, of which the outer two want a door."""
    nodes = [
        ProblemNode(id="left", type="main", area=16.0),
        ProblemNode(id="middle", type="Entities", area=16.0),
        ProblemNode(id="right", type="Entities", area=8.0),
    ]
    edges = [Edge(source="left", target="right")]
    problem = FloorProblem(boundary=box(0, 0, 10, 4), nodes=nodes, edges=edges)
    _, goal, grid = prepared(problem, 0.5)
    labels = grid.base.copy()
    x = grid.cells.geometry[..., 1]
    for label, (low, high) in enumerate([(0, 4), (4, 8), (8, 10)]):
        labels[grid.cells.free & (x > low) & (x < high)] = label
    return goal, grid, make_state(grid.cells, goal, labels)


@pytest.mark.parametrize("root", ["bed", "kitchen"])
def test_rounds_may_start_at_any_room(root: str) -> None:
    model, found = rooted(root, 1000)
    assert found.records[0].parent == root == build_cut_rounds(model, root)[0].parent
    children = [child for record in found.records for child in record.children]
    assert sorted([root, *children]) == sorted(room.id for room in model.rooms)
    assert set(range(len(model.rooms))) <= set(np.unique(found.labels).tolist())


def test_rounds_from_another_room_are_another_start() -> None:
    from_hub, from_bed = rooted(None, 400)[1], rooted("bed", 400)[1]
    assert (from_hub.labels != from_bed.labels).any()


def test_a_small_budget_is_shared_by_all_rounds() -> None:
    found = rooted(None, 30)[1]
    assert [record.candidates for record in found.records] == [15, 15]


def test_an_open_access_edge_is_carved_through_the_room_between() -> None:
    goal, grid, state = three_in_a_row()
    assert state.straight[0, 2] == 0.0
    carved = carve_open_links(grid.cells, goal, state)
    assert (state.labels == three_in_a_row()[2].labels).all()
    filled = flood(carved, grid.cells, goal, np.array([[2.0, 2.0], [6.0, 2.0], [9.0, 2.0]]))
    assert filled is not None
    after = make_state(grid.cells, goal, filled)
    assert after.straight[0, 2] >= goal.need[0]
    assert set(np.unique(filled).tolist()) == {0, 1, 2, 3}


def test_what_is_met_is_not_carved() -> None:
    goal, grid, state = three_in_a_row()
    met = goal._replace(links=np.array([[0, 1, 0]]))
    assert (carve_open_links(grid.cells, met, state) == state.labels).all()


@pytest.mark.parametrize(("rooms", "carved"), [(16, [1, 3]), (6, [3])])
def test_large_floors_carve_what_each_other_search_leaves_open(rooms: int, carved: list[int]) -> None:
    """Rooms lie in a row, and the first wants a door to the last."""
    nodes = [ProblemNode(id="hub", type="main", area=8.0)]
    nodes += [ProblemNode(id=f"room_{k}", type="Entities", area=8.0) for k in range(1, rooms)]
    edges = [Edge(source="hub", target=f"room_{rooms - 1}")]
    problem = FloorProblem(boundary=box(0, 0, 2 * rooms, 4), nodes=nodes, edges=edges)
    model, goal, grid = prepared(problem, 0.5)
    options = SolverOptions(round_candidates=0)
    rng = np.random.default_rng(0)
    annealing = Annealing(model, goal, grid, major_lines(model), options, Budget(1000), rng)
    rounds = run_rounds(model, goal, grid, options, Budget(100), rng)
    labels = grid.base.copy()
    column = np.minimum(grid.cells.geometry[..., 1] // 2, rooms - 1).astype(int)
    labels[grid.cells.free] = column[grid.cells.free]
    latest = Partition(grid, labels, 0.0)
    expected = carve_open_links(grid.cells, goal, annealing.state(latest))
    assert (expected != labels).any()
    starts = AttemptStarts(annealing)
    for attempt in range(4):
        start = starts.labels(rounds, attempt, latest)
        assert start is not None
        kept = (expected == 0) & (labels != 0)
        assert bool((start[kept] == 0).all()) == (attempt in carved)


def test_boxes_are_painted_in_the_order_that_gives_each_room_its_area() -> None:
    # The strip has more floor beside it in its box than the hall has, and yet lies over the hall's box.
    places = {
        "hall": (20.0, (0, 6), (0, 4)),
        "strip": (6.0, (4, 10), (0, 2)),
        "closet": (2.0, (4, 6), (1, 2)),
        "store": (4.0, (6, 10), (1, 2)),
    }
    nodes = [
        ProblemNode(id=name, type="main" if name == "hall" else "Entities", area=area, seed_box=SeedRange(x=x, y=y))
        for name, (area, x, y) in places.items()
    ]
    outline = [(0, 0), (10, 0), (10, 2), (6, 2), (6, 4), (0, 4)]
    model = make_model(FloorProblem(boundary=outline, nodes=nodes), OPTIONS)
    found = planned_partition(model, major_lines(model))
    assert found is not None
    rows, columns = found.labels.shape
    sizes = found.grid.cells.geometry[:rows, :columns, AREA]
    painted = {room.id: sizes[found.labels == k].sum() for k, room in enumerate(model.rooms)}
    assert painted == pytest.approx({name: place[0] for name, place in places.items()})
