"""Slivers and pinches are found; usable rooms are left alone."""

import pytest
import shapely

from mansion_planner.solver.verification import width_fault


def test_wide_rooms_have_no_fault() -> None:
    ell = shapely.Polygon([(0, 0), (4, 0), (4, 1.5), (1.5, 1.5), (1.5, 4), (0, 4)])
    assert width_fault(ell, 1.2) == ""


def test_a_strip_is_too_narrow() -> None:
    assert "wide" in width_fault(shapely.box(0, 0, 9, 1.0), 1.2)


@pytest.mark.parametrize("gap", [0.2, 1.0])
def test_a_neck_is_a_pinch(gap: float) -> None:
    left, right = shapely.box(0, 0, 3, 3), shapely.box(3.2, 0, 6, 3)
    room = shapely.union_all([left, right, shapely.box(2.9, 1, 3.3, 1 + gap)])
    assert "2 parts" in width_fault(room, 1.2)


def test_squares_that_overlap_at_a_corner_only_are_pinched() -> None:
    room = shapely.union(shapely.box(0, 0, 3, 3), shapely.box(2.5, 2.5, 5.5, 5.5))
    assert "2 parts" in width_fault(room, 1.2)
