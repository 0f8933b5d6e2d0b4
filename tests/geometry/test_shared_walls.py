"""Walls that two polygons share."""

import numpy as np
import pytest
from shapely.geometry import Polygon, box

from mansion_geometry.shared_walls import edge_array, longest_wall, shared_walls, total_length


def lengths(a: Polygon, b: Polygon, gap: float = 0.01) -> list[float]:
    return sorted(round(w.length, 6) for w in shared_walls(edge_array(a), edge_array(b), gap))


def test_boxes_side_by_side_share_the_overlap_of_their_sides() -> None:
    assert lengths(box(0, 0, 2, 2), box(2, 0.5, 4, 3)) == [1.5]


def test_touching_corners_share_no_wall() -> None:
    assert lengths(box(0, 0, 1, 1), box(1, 1, 2, 2)) == []


def test_overlapping_boxes_share_no_wall() -> None:
    assert lengths(box(0, 0, 2, 2), box(1, 0, 3, 2)) == []


def test_a_bent_wall_counts_as_two_straight_ones() -> None:
    ell = Polygon([(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (0, 1)])
    walls = shared_walls(edge_array(ell), edge_array(box(0, 1, 2, 3)))
    assert total_length(walls) == pytest.approx(4.0)
    longest = longest_wall(walls)
    assert longest is not None
    assert longest.length == pytest.approx(2.0)


def test_points_on_a_wall_do_not_split_it() -> None:
    noded = Polygon([(0, 0), (2, 0), (2, 0.7), (2, 1.1), (2, 2), (0, 2)])
    assert lengths(noded, box(2, 0, 4, 2)) == [2.0]


def test_the_gap_decides_whether_walls_meet() -> None:
    a, b = box(0, 0, 2, 2), box(2.1, 0, 4, 2)
    assert lengths(a, b) == []
    assert lengths(a, b, gap=0.12) == [2.0]


def test_holes_share_walls_with_what_fills_them() -> None:
    ring = Polygon([(0, 0), (4, 0), (4, 4), (0, 4)], [[(1, 1), (3, 1), (3, 3), (1, 3)]])
    assert lengths(ring, box(1, 1, 3, 3)) == [2.0, 2.0, 2.0, 2.0]


def test_nothing_in_common_gives_no_longest_wall() -> None:
    assert longest_wall([]) is None


def test_a_piece_beside_a_longer_one_does_not_shorten_it() -> None:
    long, short = edge_array(box(2, 0, 4, 2)), edge_array(box(2.005, 0.5, 3, 1))
    walls = shared_walls(edge_array(box(0, 0, 2, 2)), np.vstack([long, short]))
    assert [wall.length for wall in walls] == [2.0]


def test_a_slanting_edge_that_crosses_a_wall_is_not_shared() -> None:
    slanting = Polygon([(2.2, 0), (4, 0), (4, 2), (1.8, 2)])
    assert lengths(box(0, 0, 2, 2), slanting, gap=0.05) == []
