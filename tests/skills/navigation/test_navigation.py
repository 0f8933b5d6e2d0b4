"""Maps, paths, rays, lifts and routes."""

from itertools import pairwise
from math import dist, hypot, pi
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_geometry.floor_grid import FREE, OCCUPIED, UNKNOWN, GridFrame
from mansion_msgs_py.world import LiftCall, LiftDoor, LiftMotion
from mansion_skills import Robot
from mansion_skills.navigation.floor_map import FloorMap
from mansion_skills.navigation.grid_kernels import cast_rays
from mansion_skills.navigation.paths import find_path, free_run, is_clear, path_length
from mansion_skills.world.lift import DOOR_TIME, Lift
from sample_building import scene

FRAME = GridFrame(0.0, 0.0, 0.05, 80, 120)


def floor_map(**is_open: bool) -> FloorMap:
    made = scene(1, [1, 2])
    grid = FloorMap(made, 0.2)
    grid.update([], {d.id: is_open.get(d.id[3:], d.is_open) for d in made.doors})
    return grid


def test_the_map_is_free_in_rooms_occupied_in_walls_and_unknown_outside() -> None:
    grid = floor_map()
    data = grid.occupancy()

    def at(x: float, y: float) -> int:
        return int(data[grid.frame.cell(x, y)])

    assert (at(6.0, 1.5), at(5.0, 3.0), at(2.4, 3.0), at(-1.0, 5.0)) == (FREE, OCCUPIED, FREE, UNKNOWN)
    assert (at(13.0, 1.5), at(-1.0, 1.0)) == (OCCUPIED, FREE)
    assert not grid.is_free(-1.0, 1.0), "the cabin is free on the map, but no robot drives into it"
    assert (grid.frame.x0, grid.frame.y0) == (-2.6, -0.55) or grid.frame.resolution == 0.05


def test_a_closed_door_is_a_wall() -> None:
    assert floor_map().is_free(2.45, 3.0)
    assert not floor_map(door_1=False).is_free(2.45, 3.0)


@given(st.integers(0, 2**32 - 1))
@settings(max_examples=25, deadline=None)
def test_paths_are_clear_and_hardly_longer_than_the_straight_line_allows(seed: int) -> None:
    rng = np.random.default_rng(seed)
    blocked = np.zeros((FRAME.rows, FRAME.columns), dtype=bool)
    for _ in range(6):
        r, c = rng.integers(5, 60), rng.integers(5, 100)
        blocked[r : r + rng.integers(2, 18), c : c + rng.integers(2, 18)] = True
    start, goal = (0.1, 0.1), (5.9, 3.9)
    path = find_path(blocked, FRAME, start, goal)
    if path is None:
        return
    assert path[0] == start and path[-1] == goal
    assert all(is_clear(blocked, FRAME, a, b) for a, b in pairwise(path))
    assert path_length(path) >= dist(start, goal) - 1e-9


def test_a_path_around_one_corner_is_the_taut_one() -> None:
    blocked = np.zeros((FRAME.rows, FRAME.columns), dtype=bool)
    blocked[0:60, 58:62] = True
    path = find_path(blocked, FRAME, (1.0, 0.5), (5.0, 0.5))
    assert path is not None
    taut = 2 * hypot(1.9, 2.5) + 0.2
    assert taut * 0.97 < path_length(path) < taut * 1.04


def test_a_shut_in_goal_has_no_path() -> None:
    blocked = np.zeros((FRAME.rows, FRAME.columns), dtype=bool)
    blocked[:, 60] = True
    assert find_path(blocked, FRAME, (1.0, 1.0), (5.0, 1.0)) is None


def test_a_robot_in_an_inflated_cell_can_leave_it_but_not_go_deeper() -> None:
    blocked = np.zeros((FRAME.rows, FRAME.columns), dtype=bool)
    blocked[:, :8] = True
    assert free_run(blocked, FRAME, (0.3, 1.0), 0.0, 1.0) == pytest.approx(1.0)
    assert free_run(blocked, FRAME, (0.3, 1.0), pi, 1.0) == 0.0
    path = find_path(blocked, FRAME, (0.3, 1.0), (3.0, 1.0))
    assert path is not None and path[0] == (0.3, 1.0)


def test_rays_measure_the_distance_to_walls() -> None:
    occupied = np.zeros((100, 100), dtype=bool)
    occupied[:, 80] = True
    occupied[90, :] = True
    ranges = cast_rays(occupied, 50.0, 40.0, np.array([0.0, pi / 2, pi, pi / 4]), 60.0)
    assert ranges == pytest.approx([40.0, 40.0, 60.0, 40.0 * 2**0.5], abs=0.01)


def test_a_laser_in_the_hall_sees_its_walls(robot: Robot) -> None:
    grid = robot.engine.session("").world.view(1).map
    row, column = grid.frame.cell(6.0, 1.5)
    up, right = cast_rays(grid.occupied, row + 0.5, column + 0.5, np.array([pi / 2, 0.0]), 500.0)
    assert up * 0.05 == pytest.approx(1.44, abs=0.06)
    assert right * 0.05 == pytest.approx(5.94, abs=0.06)


def lift() -> Lift:
    return Lift("lift", {1: 0.0, 2: 3.0, 3: 6.0}, {1: "G", 2: "2", 3: "3"}, position=0.0)


def test_a_lift_closes_runs_and_opens_in_its_time() -> None:
    cabin = lift()
    cabin.call(LiftCall(session="a", floor=3))
    assert cabin.seconds_to_rest() == pytest.approx(6.0 + DOOR_TIME)
    states = list(cabin.advance(20.0, 100.0, "b"))
    assert [(s.motion_state, s.door_state) for s in states] == [
        (LiftMotion.UP, LiftDoor.CLOSED),
        (LiftMotion.STOPPED, LiftDoor.MOVING),
        (LiftMotion.STOPPED, LiftDoor.OPEN),
    ]
    assert [s.lift_time for s in states] == [100.0, 106.0, 108.0]
    assert cabin.is_open_at(3) and not cabin.is_open_at(1)


@given(st.lists(st.floats(0.01, 3.0), min_size=1, max_size=30))
@settings(max_examples=40, deadline=None)
def test_a_lift_moves_the_same_way_however_time_is_cut(parts: list[float]) -> None:
    whole, cut = lift(), lift()
    for cabin in (whole, cut):
        cabin.call(LiftCall(session="a", floor=2))
    list(whole.advance(sum(parts), 0.0, "b"))
    for part in parts:
        list(cut.advance(part, 0.0, "b"))
    assert cut.position == pytest.approx(whole.position, abs=1e-6)
    assert cut.opening == pytest.approx(whole.opening, abs=1e-6)


def test_calls_wait_in_order_behind_the_session_that_holds_the_lift() -> None:
    cabin = lift()
    assert [cabin.call(LiftCall(session=name, floor=2)) for name in "abc"] == [0, 1, 2]
    assert cabin.call(LiftCall(session="b", floor=3)) == 1
    cabin.release("a")
    assert (cabin.session, cabin.target) == ("b", 3)
    assert cabin.release("nobody") is False
    cabin.release("b")
    assert cabin.session == "c"


def test_a_route_prefers_the_quicker_of_lift_and_stairs(tmp_path: Path) -> None:
    from sample_building import write_building

    robot = Robot(write_building(tmp_path / "tower", list(range(1, 11))))
    high = robot.plan_route("F10/kitchen")
    assert [leg.kind for leg in high.legs] == ["walk", "elevator", "walk"]
    robot.go_to_landmark("stairs")
    near = robot.plan_route("F2/hall")
    assert "TakeStairs Up" in near.skills or "UseElevator 2" in near.skills
    assert near.seconds < high.seconds
