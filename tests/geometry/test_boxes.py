"""Oriented boxes agree with exact polygons."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import Polygon

from mansion_geometry.boxes import box_corners, box_inside, boxes_overlap, compose, gap_matrix, rotation_of, unit_vector
from mansion_geometry.fitting import feasible_poses, front_clearance

ROOM = np.array([(0, 0, 4, 0), (4, 0, 4, 3), (4, 3, 0, 3), (0, 3, 0, 0)], dtype=float)
L_ROOM = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 4.0), (0.0, 4.0)]
L_EDGES = np.array([(*a, *b) for a, b in zip(L_ROOM, L_ROOM[1:] + L_ROOM[:1])])

numbers = st.floats(-1.0, 5.0).map(lambda v: round(v, 3))
halves = st.floats(0.05, 1.5).map(lambda v: round(v, 3))
angles = st.sampled_from([0.0, 90.0, 180.0, 270.0, 30.0, 45.0, 123.4])


@st.composite
def boxes(draw: st.DrawFn) -> np.ndarray:
    ux, uy = unit_vector(draw(angles))
    return np.array([draw(numbers), draw(numbers), ux, uy, draw(halves), draw(halves)])


@given(boxes(), boxes())
@settings(deadline=None, max_examples=150)
def test_overlap_and_gap_agree_with_polygons(a: np.ndarray, b: np.ndarray) -> None:
    first, second = Polygon(box_corners(a)), Polygon(box_corners(b))
    gap = gap_matrix(a[None, :4], a[4], a[5], b[None])[0, 0]
    assert gap == pytest.approx(first.distance(second), abs=1e-5)
    if first.intersection(second).area > 1e-4:
        assert boxes_overlap(a, b, 0.0)
    if first.distance(second) > 1e-4:
        assert not boxes_overlap(a, b, 0.0)


@pytest.mark.parametrize(("x", "y"), [(1.9, 1.9), (-1.9, 1.9), (-1.9, -1.9), (1.9, -1.9)])
def test_only_the_axes_of_the_turned_box_keep_a_corner_from_its_side(x: float, y: float) -> None:
    plain = np.array([0.0, 0.0, 1.0, 0.0, 1.0, 1.0])
    turned = np.array([x, y, *unit_vector(45.0), 1.0, 1.0])
    apart = np.hypot(x, y) - 1.0 - np.sqrt(2.0)
    for a, b in ((plain, turned), (turned, plain)):
        assert not boxes_overlap(a, b, 0.0)
        assert not boxes_overlap(a, b, apart - 0.01)
        assert boxes_overlap(a, b, apart + 0.01)


@given(boxes())
@settings(deadline=None, max_examples=150)
def test_containment_agrees_with_polygons(box: np.ndarray) -> None:
    outside = Polygon(box_corners(box)).difference(Polygon(L_ROOM)).area
    if box_inside(box, L_EDGES):
        assert outside < 1e-4
    else:
        assert outside > 0.0


def test_touching_boxes_do_not_overlap() -> None:
    a = np.array([1.0, 1.0, 1.0, 0.0, 0.5, 0.5])
    b = np.array([2.0, 1.0, 1.0, 0.0, 0.5, 0.5])
    assert not boxes_overlap(a, b, 0.0)
    assert boxes_overlap(a, b, 0.02)


@pytest.mark.parametrize("degrees", [0.0, 90.0, 180.0, 270.0, 33.0])
def test_rotation_survives_the_unit_vector(degrees: float) -> None:
    assert rotation_of(*unit_vector(degrees)) == pytest.approx(degrees)


def test_quarter_turns_are_exact() -> None:
    assert unit_vector(270.0) == (0.0, -1.0)


def test_parts_turn_with_their_pose() -> None:
    parts = np.array([[0.0, 1.0, -1.0, 0.0, 0.2, 0.3, 0.9]])
    moved = compose(np.array([2.0, 2.0, 0.0, 1.0]), parts)
    assert moved[0] == pytest.approx([1.0, 2.0, 0.0, -1.0, 0.2, 0.3])


def test_a_low_part_may_stand_before_a_window_and_a_tall_one_not() -> None:
    window = np.array([[2.0, 2.85, -1.0, 0.0, 1.0, 0.15, 0.9]])
    pose = np.array([[2.0, 2.7, -1.0, 0.0]])
    none = np.zeros((0, 6))
    for height, fits in ((0.8, True), (1.8, False)):
        part = np.array([[0.0, 0.0, 1.0, 0.0, 0.4, 0.2, height, 0.0]])
        assert feasible_poses(pose, part, ROOM, none, window, 0.02)[0] == fits


def test_clearances_end_at_walls_and_boxes() -> None:
    other = np.array([[2.0, 2.5, 1.0, 0.0, 0.5, 0.2]])
    clear = front_clearance(np.array([[2.0, 1.0, 1.0, 0.0]]), 0.5, 0.25, ROOM, other, 5.0)[0]
    assert clear == pytest.approx([1.05, 0.75, 1.5, 1.5], abs=1e-5)
