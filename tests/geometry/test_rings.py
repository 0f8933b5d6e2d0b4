"""Rings: orientation, corners, main direction."""

import math

import numpy as np
import pytest
from shapely.geometry import MultiPolygon, box

from mansion_geometry.rings import (
    as_polygon,
    corner_points,
    dominant_angle,
    largest_polygon,
    oriented,
    points_inside_ring,
    rotated,
    signed_area,
)

SQUARE = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]


def test_area_is_positive_counter_clockwise_and_negative_clockwise() -> None:
    assert signed_area(SQUARE) == 4.0
    assert signed_area(SQUARE[::-1]) == -4.0


def test_oriented_turns_a_clockwise_ring_round() -> None:
    assert signed_area(oriented(SQUARE[::-1])) == 4.0
    assert signed_area(oriented(SQUARE, ccw=False)) == -4.0


def test_points_on_straight_lines_are_no_corners() -> None:
    ring = [(0, 0), (1, 0), (2, 0), (2, 2), (0, 2), (0, 1)]
    assert len(corner_points(ring)) == 4


def test_a_self_crossing_ring_is_repaired() -> None:
    shape = as_polygon([(0, 0), (2, 2), (2, 0), (0, 2)])
    assert shape.is_valid
    assert shape.area > 0


def test_a_degenerate_ring_is_empty() -> None:
    assert as_polygon([(0, 0), (1, 1)]).is_empty


def test_largest_polygon_of_several() -> None:
    assert largest_polygon(MultiPolygon([box(0, 0, 1, 1), box(2, 0, 5, 5)])).area == 15.0


@pytest.mark.parametrize("degrees", [-40.0, -10.0, 17.0, 44.0])
def test_dominant_angle_finds_the_turn_of_a_box(degrees: float) -> None:
    ring = rotated([(0, 0), (9, 0), (9, 4), (0, 4)], math.radians(degrees))
    assert dominant_angle([ring]) == pytest.approx(math.radians(degrees), abs=1e-9)


def test_axis_parallel_outlines_are_not_turned() -> None:
    assert dominant_angle([[(0, 0), (5, 0), (6, 1), (6, 4), (0, 4)]]) == 0.0


def test_rotation_by_zero_keeps_every_bit() -> None:
    ring = [(0.1, 0.2), (1 / 3, 0.7), (2.0, 9.9)]
    assert rotated(ring, 0.0) == ring
    back = rotated(rotated(ring, 0.7), -0.7)
    assert np.allclose(back, ring)


def test_points_in_a_ring_are_told_apart_at_once() -> None:
    notched = [(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (1.0, 1.0), (1.0, 4.0), (0.0, 4.0)]
    xs, ys = np.array([0.5, 3.0, 3.0, 0.5, -1.0]), np.array([0.5, 0.5, 3.0, 3.0, 0.5])
    assert points_inside_ring(notched, xs, ys).tolist() == [True, True, False, True, False]
