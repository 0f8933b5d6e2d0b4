"""The running statistics of the wall search agree with those counted anew; narrow places are found."""

import numpy as np
import pytest

from mansion_planner.solver import SolverOptions
from mansion_planner.solver.annealing import Schedule, anneal
from mansion_planner.solver.energy import total_energy
from mansion_planner.solver.grid import Grid, major_lines, make_grid, spaced_lines
from mansion_planner.solver.partition import State, make_state, paint
from mansion_planner.solver.problem import Goal, make_goal, make_model
from problem_floors import flat, office


def striped(spacing: float = 1.0) -> tuple[Goal, Grid, State]:
    """Return the office floor with its rooms as upright strips."""
    model = make_model(office(), SolverOptions())
    xs, ys = major_lines(model)
    grid = make_grid(model, spaced_lines(xs, spacing), spaced_lines(ys, spacing))
    rooms = len(model.rooms)
    strip = (np.arange(grid.base.shape[1]) * rooms // grid.base.shape[1])[None, :]
    labels = np.where(grid.base < 0, strip, grid.base)
    goal = make_goal(model, SolverOptions())
    return goal, grid, make_state(grid.cells, goal, labels)


def test_painting_keeps_the_statistics_of_a_recount() -> None:
    goal, grid, state = striped()
    rng = np.random.default_rng(0)
    free = np.argwhere(grid.cells.free)
    for j, i in free[rng.integers(len(free), size=400)]:
        new = (state.labels[j, i] + 1 + rng.integers(state.thin.size - 1)) % state.thin.size
        paint(
            grid.cells.geometry,
            grid.cells.near,
            state.labels,
            state.stats,
            state.contact,
            state.straddle,
            j,
            i,
            int(new),
        )
    again = make_state(grid.cells, goal, state.labels)
    assert state.stats == pytest.approx(again.stats, abs=1e-9)
    assert state.contact == pytest.approx(again.contact, abs=1e-9)
    assert state.straddle == pytest.approx(again.straddle, abs=1e-9)


@pytest.mark.parametrize("temperature", [0.0, 0.5])
def test_annealing_returns_the_energy_of_the_partition_that_it_returns_and_lowers_it(temperature: float) -> None:
    goal, grid, state = striped()
    before = total_energy(goal, state)
    boxes = np.zeros((0, 5), np.int64)
    schedule = Schedule(3000, temperature, temperature / 50, reach=4, swap_share=0.05, rectangle_share=0.2)
    labels, after = anneal(grid.cells, goal, state.labels, boxes, schedule, 7)
    again = make_state(grid.cells, goal, labels)
    assert total_energy(goal, again) == pytest.approx(after, abs=1e-9)
    assert after < before


def test_a_wall_is_as_long_as_its_straight_part_and_narrow_ground_is_counted() -> None:
    model = make_model(flat(), SolverOptions())
    xs, ys = major_lines(model)
    grid = make_grid(model, spaced_lines(xs, 0.5), spaced_lines(ys, 0.5))
    goal = make_goal(model, SolverOptions())
    x, y = grid.cells.geometry[..., 1], grid.cells.geometry[..., 2]
    labels = np.where(grid.base < 0, 0, grid.base)
    free = grid.cells.free
    labels[free & (x > 4)] = 1
    labels[free & (x > 4) & (y > 6)] = 2
    labels[free & (x < 4) & (y > 7)] = 3
    labels[free & (x < 0.5) & (y > 7)] = 4
    state = make_state(grid.cells, goal, labels)
    assert state.straight[0, 1] == pytest.approx(6.0)
    assert state.straight[1, 2] == pytest.approx(4.0)
    assert state.straight[0, 2] == pytest.approx(1.0)
    assert state.thin[[0, 1, 2]].tolist() == [0.0, 0.0, 0.0]
    assert state.thin[3] == pytest.approx(3.5 * (goal.rooms[3, 4] - 1.0) + 3.5)
    assert state.thin[4] > 0.5
