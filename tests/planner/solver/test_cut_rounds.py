"""The pieces of Algorithms 2 and 3: rounds, radii, batches, growth, clean-up, energy."""

import numpy as np
import pytest

from mansion_msgs_py.layout import FloorProblem, ProblemNode
from mansion_msgs_py.topology import Edge
from mansion_planner.solver import SolverOptions
from mansion_planner.solver.candidates import FREE, OTHER, candidate_energy, clean, grow
from mansion_planner.solver.cut_rounds import base_radii, build_cut_rounds, sample_batch, subtree_areas
from mansion_planner.solver.polygons import trace
from mansion_planner.solver.problem import make_model
from problem_floors import box, flat, office


def geometry(rows: int, columns: int) -> np.ndarray:
    """Return unit cells."""
    cells = np.zeros((rows, columns, 8))
    cells[..., 0] = 1.0
    cells[..., 1], cells[..., 2] = np.meshgrid(np.arange(columns) + 0.5, np.arange(rows) + 0.5)
    cells[..., 3:5] = 1.0
    return cells


def region(rows: int, columns: int) -> np.ndarray:
    """Return a free rectangle framed by other ground."""
    work = np.full((rows + 2, columns + 2), OTHER, np.int64)
    work[1:-1, 1:-1] = FREE
    return work


def test_rounds_go_breadth_first_and_leave_cores_out() -> None:
    rounds = build_cut_rounds(make_model(office(3), SolverOptions()))
    assert [(r.parent, r.children) for r in rounds] == [("corridor", ("office_0", "office_1", "office_2"))]


def test_access_is_followed_before_adjacency_and_strays_join_the_hub() -> None:
    nodes = [ProblemNode(id=n, type="main" if n == "a" else "Entities", area=9.0) for n in "abcd"]
    edges = [Edge(source="a", target="c", kind="adjacent"), Edge(source="a", target="b"), Edge(source="b", target="c")]
    problem = FloorProblem(boundary=box(0, 0, 6, 6), nodes=nodes, edges=edges)
    rounds = build_cut_rounds(make_model(problem, SolverOptions()))
    assert [(r.parent, r.children) for r in rounds] == [("a", ("b", "d")), ("b", ("c",))]


def test_a_subtree_area_holds_all_rooms_cut_from_it() -> None:
    model = make_model(flat(), SolverOptions())
    areas = subtree_areas(model, build_cut_rounds(model))
    assert areas["living"] == pytest.approx(64.0)
    assert areas["bed"] == pytest.approx(19.0)


def test_base_radii_follow_the_formula() -> None:
    options = SolverOptions()
    assert options.base_radius == 2.0
    assert (options.retries, options.batch) == (10, 100)
    radii = base_radii(np.array([0.25, 0.5]), options)
    assert radii.tolist() == [2.0 + 4.0 * 0.25, 2.0 + 4.0 * 0.5]


def test_a_batch_stays_in_the_discs_and_keeps_seeds_apart() -> None:
    seeds = np.array([[2.0, 2.0], [3.0, 2.0]])
    radii = np.array([1.0, 0.5])
    batch = sample_batch(seeds, radii, 100, 0.5, np.random.default_rng(0))
    assert batch.shape == (100, 2, 2)
    assert np.array_equal(batch[0], seeds)
    assert (np.linalg.norm(batch - seeds, axis=-1) <= radii + 1e-12).all()
    gap = np.linalg.norm(batch[:, 0] - batch[:, 1], axis=-1)
    assert (gap >= 0.5).mean() > 0.98


def test_growth_reaches_the_areas_with_rectangles() -> None:
    work = region(6, 10)
    lines = np.arange(13.0)
    seeds = np.array([[2.0, 2.0], [9.0, 5.0]])
    assert grow(lines, lines, geometry(8, 12), work, seeds, np.array([12.0, 12.0]), vanishes=False)
    for child in (0, 1):
        cells = np.argwhere(work == child)
        span = cells.max(axis=0) - cells.min(axis=0) + 1
        assert len(cells) == 12 == span.prod()
    assert (work == FREE).sum() == 36


def test_a_vanishing_parent_keeps_nothing() -> None:
    work = region(5, 7)
    lines = np.arange(10.0)
    seeds = np.array([[1.5, 1.5], [6.5, 4.5]])
    assert grow(lines, lines, geometry(7, 9), work, seeds, np.array([10.0, 10.0]), vanishes=True)
    assert (work == FREE).sum() == 0


def test_growth_fails_where_there_are_fewer_cells_than_children() -> None:
    lines = np.arange(5.0)
    seeds, targets = np.ones((3, 2)), np.ones(3)
    assert not grow(lines, lines, geometry(3, 4), region(1, 2), seeds, targets, vanishes=True)


def test_spurs_are_removed_and_holes_filled() -> None:
    work = region(5, 8)
    work[1:-1, 1:5] = 0
    work[1:-1, 5:-1] = 1
    work[3, 5:7] = 0
    work[2, 2] = FREE
    clean(work, geometry(7, 10), 2, keep_largest=False)
    assert (work[3, 5:7] == 1).all()
    assert work[2, 2] == 0


def test_energy_is_that_of_the_formula() -> None:
    features = np.array([[0.1, 2.0, 3.0, 1.0], [0.2, 4.0, 0.25, 0.0]])
    weights = np.array([0.5, 0.2, 0.2, 0.1])
    first = 0.5 * 0.1 + 0.2 * 0.0 + 0.2 * 1.0 - 0.1 * 1.0
    second = 0.5 * 0.2 + 0.2 * 1.0 + 0.2 * 0.0 - 0.1 * 0.25
    assert candidate_energy(features, weights) == pytest.approx(first + second, abs=1e-6)


def test_traced_rings_run_around_cells_and_holes() -> None:
    mask = np.ones((3, 3), bool)
    mask[1, 1] = False
    rings = trace(mask)
    assert sorted(len(ring) for ring in rings) == [4, 4]


def test_a_room_around_a_corner_that_touches_its_own_outline_is_traced_as_outline_and_hole() -> None:
    mask = np.array([[True, True, True], [True, False, True], [False, True, True]])
    assert sorted(len(set(ring)) for ring in trace(mask)) == [4, 6]
    assert all(len(set(ring)) == len(ring) for ring in trace(mask))


def test_cells_that_meet_at_a_corner_are_traced_apart() -> None:
    rings = trace(np.array([[True, False], [False, True]]))
    assert len(rings) == 2
