"""Rooms drawn between wall faces meet on the centre lines of their walls; those that meet already stay as they are."""

import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import Polygon, box

from mansion_planner.given_plan.wall_lines import on_centre_lines


def test_rooms_with_a_wall_between_them_meet_in_its_middle() -> None:
    left, right = on_centre_lines([box(0, 0, 3.9, 3), box(4.1, 0, 8, 3)])
    assert left.bounds == (0.0, 0.0, 4.0, 3.0)
    assert right.bounds == (4.0, 0.0, 8.0, 3.0)


def test_walls_of_two_thicknesses_on_one_line_become_one_wall() -> None:
    long, low, high = on_centre_lines([box(0, 0, 4, 6), box(4.1, 0, 8, 2.9), box(4.2, 3.1, 8, 6)])
    assert long.bounds[2] == low.bounds[0] == high.bounds[0] == pytest.approx(4.1)
    assert low.bounds[3] == high.bounds[1] == pytest.approx(3.0)


def test_a_narrow_room_between_two_others_is_not_taken_for_a_wall() -> None:
    rooms = on_centre_lines([box(0, 0, 4, 3), box(4.05, 0, 4.4, 3), box(4.45, 0, 8, 3)])
    assert rooms[1].area == pytest.approx(0.4 * 3.0)


def test_a_slanted_wall_is_closed_along_its_middle() -> None:
    left = Polygon([(0, 0), (4, 0), (5, 4), (0, 4)])
    right = Polygon([(4.2, 0), (9, 0), (9, 4), (5.2, 4)])
    joined = on_centre_lines([left, right])
    assert joined[0].intersection(joined[1]).length == pytest.approx(17**0.5, abs=0.01)
    assert shapely.union_all(joined).area == pytest.approx(36.0, abs=0.01)


def test_a_strip_too_thin_for_anything_goes_to_what_lies_beside_it() -> None:
    around = Polygon([(0, 0), (4, 0), (4, 3), (7.97, 3), (7.97, 0), (8, 0), (8, 6), (0, 6)])
    living, kitchen = on_centre_lines([around, box(4, 0, 7.97, 3)])
    assert living.area == pytest.approx(48.0 - 12.0)
    assert kitchen.bounds == (4.0, 0.0, 7.97, 3.0)


def test_rooms_farther_apart_than_a_wall_stay_apart() -> None:
    rooms = [box(0, 0, 4, 3), box(4.8, 0, 8, 3)]
    assert [room.bounds for room in on_centre_lines(rooms)] == [room.bounds for room in rooms]


@settings(max_examples=40, deadline=None)
@given(
    st.lists(st.floats(1.5, 5.0), min_size=1, max_size=4),
    st.lists(st.floats(1.5, 5.0), min_size=1, max_size=3),
    st.floats(0.0, 0.4),
)
def test_a_grid_of_rooms_becomes_a_partition(widths: list[float], depths: list[float], wall: float) -> None:
    rooms, x = [], 0.0
    for width in widths:
        y = 0.0
        for depth in depths:
            rooms.append(box(x, y, x + width, y + depth))
            y += depth + wall
        x += width + wall
    joined = on_centre_lines(rooms)
    whole = box(*shapely.total_bounds(rooms))
    assert shapely.union_all(joined).symmetric_difference(whole).area < 1e-2
    assert sum(room.area for room in joined) == pytest.approx(whole.area, abs=1e-2)
    for before, after in zip(rooms, joined):
        assert after.buffer(1e-3).covers(before)
        if wall == 0.0:
            assert after.normalize().equals_exact(before.normalize(), 1e-9)
