"""Rings, segments and turns in the plane."""

from itertools import product

import numpy as np
import pytest
from shapely import LineString, Point, Polygon

from mansion_geometry.plane import inside_ring, segment_distance, turned

ELL = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)]


def test_points_are_inside_a_ring_as_shapely_has_it() -> None:
    shape = Polygon(ELL)
    for x, y in product(np.arange(-0.25, 5.5, 0.5).tolist(), repeat=2):
        assert inside_ring(ELL, x, y) == shape.contains(Point(x, y))


@pytest.mark.parametrize("point", [(1.0, 1.0), (-3.0, 0.5), (9.0, -2.0)])
def test_the_distance_to_a_segment_is_that_to_its_nearest_point(point: tuple[float, float]) -> None:
    segment = ((0.0, 0.0), (4.0, 1.0))
    assert segment_distance(point, segment) == pytest.approx(LineString(segment).distance(Point(point)))


def test_a_segment_of_no_length_is_a_point() -> None:
    assert segment_distance((3.0, 4.0), ((0.0, 0.0), (0.0, 0.0))) == 5.0


def test_a_quarter_turn_is_counter_clockwise() -> None:
    assert turned(1.0, 0.0, 90.0) == pytest.approx((0.0, 1.0))
