"""Where in a floor grid a disc robot cannot be, and what it reaches."""

from collections import deque
from math import dist

import numpy as np
import shapely
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from shapely.geometry import Point

from mansion_geometry.boxes import box_corners, unit_vector
from mansion_geometry.disc_cells import inflate, near_boxes, region_of, segment_boxes, stamp_disc
from mansion_geometry.floor_grid import GridFrame

FRAME = GridFrame(-1.0, 2.0, 0.1, 30, 40)

inside_x, inside_y = st.floats(-0.9, 2.9), st.floats(2.1, 4.9)


def centers() -> shapely.Geometry:
    """Return the centres of all cells, shape (rows, columns)."""
    return shapely.points(*np.meshgrid(*FRAME.centers()))


boxes = st.tuples(inside_x, inside_y, st.floats(0, 360), st.floats(0.01, 0.8), st.floats(0.01, 0.8))


@given(st.lists(boxes, max_size=4), st.floats(0.05, 0.6))
@settings(deadline=None)
def test_cells_near_boxes_are_those_nearer_than_the_radius(found, radius: float) -> None:
    rows = np.array([(x, y, *unit_vector(turn), a, b) for x, y, turn, a, b in found]).reshape(-1, 6)
    away = np.full(FRAME.shape, np.inf)
    for row in rows:
        away = np.minimum(away, shapely.distance(shapely.MultiPoint(box_corners(row)).convex_hull, centers()))
    near = near_boxes(FRAME, rows, radius)
    clear = abs(away - radius) > 1e-6
    assert np.array_equal(near[clear], (away < radius)[clear])


@given(st.lists(st.tuples(st.tuples(inside_x, inside_y), st.tuples(inside_x, inside_y)), min_size=1, max_size=4))
@settings(deadline=None)
def test_a_segment_is_a_box_without_depth(segments) -> None:
    assume(all(dist(*segment) > 0.01 for segment in segments))
    near = near_boxes(FRAME, segment_boxes(segments), 0.3)
    away = shapely.distance(shapely.MultiLineString(segments), centers())
    clear = abs(away - 0.3) > 1e-6
    assert np.array_equal(near[clear], (away < 0.3)[clear])


def test_a_segment_without_length_is_a_point() -> None:
    near = near_boxes(FRAME, segment_boxes([((1.0, 3.0), (1.0, 3.0))]), 0.33)
    assert np.array_equal(near, shapely.distance(Point(1.0, 3.0), centers()) < 0.33)


@given(st.integers(0, 2**32 - 1), st.floats(1.0, 6.0))
@settings(max_examples=25, deadline=None)
def test_inflation_is_the_set_of_cells_nearer_than_the_radius(seed: int, radius: float) -> None:
    occupied = np.random.default_rng(seed).random((30, 40)) < 0.02
    rows, columns = np.nonzero(occupied)
    r, c = np.indices(occupied.shape)
    away = np.full(occupied.shape, np.inf)
    for row, column in zip(rows, columns):
        away = np.minimum(away, np.hypot(r - row, c - column))
    assert np.array_equal(inflate(occupied, radius), away < radius - 1e-9)


def test_a_disc_at_the_border_has_its_cells_inside() -> None:
    mask = np.zeros((6, 6), dtype=bool)
    stamp_disc(mask, 0.0, 5.0, 1.5)
    assert set(map(tuple, np.argwhere(mask).tolist())) == {(0, 4), (0, 5), (1, 4), (1, 5)}


@given(st.integers(0, 2**32 - 1), st.floats(0.2, 0.7))
@settings(max_examples=40, deadline=None)
def test_a_region_is_what_steps_in_four_directions_reach(seed: int, share: float) -> None:
    rng = np.random.default_rng(seed)
    blocked = rng.random((15, 20)) < share
    start = (int(rng.integers(15)), int(rng.integers(20)))
    seen = np.zeros_like(blocked)
    queue = deque([] if blocked[start] else [start])
    while queue:
        row, column = queue.popleft()
        if 0 <= row < 15 and 0 <= column < 20 and not blocked[row, column] and not seen[row, column]:
            seen[row, column] = True
            queue += [(row + 1, column), (row - 1, column), (row, column + 1), (row, column - 1)]
    assert np.array_equal(region_of(blocked, *start), seen)
