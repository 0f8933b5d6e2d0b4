"""Pictures are darker in corners, and nowhere else."""

import numpy as np

from mansion_skills.vision.contact_shading import contact_shaded

WHITE = np.full((120, 160, 3), 200, dtype=np.uint8)
FOCAL = 80.0


def rays() -> tuple[np.ndarray, np.ndarray]:
    """Return the directions of the pixels, right and down, for one metre along the axis."""
    x, y = np.arange(160) - 79.5, np.arange(120) - 59.5
    return np.meshgrid(x / FOCAL, y / FOCAL)


def test_a_floor_alone_stays_as_it_is() -> None:
    _, down = rays()
    depth = np.where(down > 0.05, 1.4 / np.maximum(down, 0.05), np.inf).astype(np.float32)
    shaded = contact_shaded(WHITE, depth, FOCAL)
    assert (shaded[70:] >= 199).all()
    assert (shaded[~np.isfinite(depth)] == 200).all()


def test_the_corner_of_two_walls_is_darker_than_their_middles() -> None:
    right, _ = rays()
    # Two walls at right angles that meet 4 m ahead.
    depth = (4.0 / (1.0 + np.abs(right))).astype(np.float32)
    shaded = contact_shaded(WHITE, depth, FOCAL).astype(int)
    assert shaded[60, 80, 0] < 185
    assert shaded[60, 20, 0] >= 199
    assert shaded[60, 140, 0] >= 199


def test_what_hangs_far_before_a_wall_leaves_no_ghosts_on_it() -> None:
    depth = np.full((120, 160), 5.0, dtype=np.float32)
    depth[50:70, 70:90] = 1.0
    shaded = contact_shaded(WHITE, depth, FOCAL)
    assert (shaded >= 199).all()
