"""Buckets over many boxes find what comparing one by one finds."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_geometry.box_index import box_buckets
from mansion_geometry.boxes import boxes_overlap
from mansion_geometry.fitting import feasible_poses

ROOM = np.array([(0, 0, 20, 0), (20, 0, 20, 20), (20, 20, 0, 20), (0, 20, 0, 0)], dtype=float)


def scattered(seed: int, count: int) -> np.ndarray:
    """Return boxes of all sizes and directions."""
    rng = np.random.default_rng(seed)
    angle = rng.uniform(0, 2 * np.pi, count)
    halves = rng.uniform(0.05, rng.choice([0.3, 3.0]), (count, 2))
    return np.column_stack([rng.uniform(0, 20, (count, 2)), np.cos(angle), np.sin(angle), halves])


@settings(deadline=None, max_examples=20)
@given(seed=st.integers(0, 10_000), count=st.integers(25, 120))
def test_many_boxes_hinder_the_poses_that_they_hinder_one_by_one(seed: int, count: int) -> None:
    boxes, poses = scattered(seed, count), scattered(seed + 1, 60)[:, :4]
    part = np.array([[0, 0, 1, 0, 0.3, 0.2, 1.0, 0.0]], dtype=float)
    none = np.zeros((0, 7))
    free = feasible_poses(poses, part, ROOM, np.zeros((0, 6)), none, 0.02)
    expected = [
        inside and not any(boxes_overlap(np.array([*pose, 0.3, 0.2]), b, 0.02) for b in boxes)
        for inside, pose in zip(free, poses)
    ]
    assert feasible_poses(poses, part, ROOM, boxes, none, 0.02).tolist() == expected


def test_every_box_is_in_the_bucket_of_its_centre() -> None:
    boxes = scattered(3, 40)
    x0, y0, size, across, starts, items = box_buckets(boxes, 0.8)
    for number, box in enumerate(boxes):
        bucket = int((box[1] - y0) // size) * across + int((box[0] - x0) // size)
        assert number in items[starts[bucket] : starts[bucket + 1]]
