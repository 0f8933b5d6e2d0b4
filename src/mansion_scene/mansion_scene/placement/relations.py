"""Relative constraints as tests on many poses at once: near, far, in_front_of, around, side_of, center_aligned."""

import numpy as np
import numpy.typing as npt

from mansion_geometry.boxes import gap_matrix

__all__ = ["LIMITS", "relation_holds"]

Floats = npt.NDArray[np.float64]
Bools = npt.NDArray[np.bool_]

LIMITS = {"near": 1.0, "far": 1.5, "in_front_of": 1.5, "around": 0.5, "side_of": 1.0}
"""Largest gap between footprints (``far``: the least), metres."""

_ALIGNED = 0.10
_INSET = 0.005
"""Kept from each limit, so that rounding never crosses it, metres."""


def relation_holds(kind: str, poses: Floats, hw: float, hd: float, targets: Floats) -> Bools:
    """Tell at which poses a box stands in a relation to a target's copies.

    Parameters
    ----------
    kind : str
        A relation kind; "far" must hold to every copy, the others to one.
    poses : (n, 4) array
    hw, hd : float
        Half width and half depth of the box.
    targets : (m, 6) array

    Returns
    -------
    (n,) bool array; all False without targets.
    """
    if not len(targets):
        return np.zeros(len(poses), dtype=np.bool_)
    gaps = gap_matrix(poses, hw, hd, targets)
    if kind == "far":
        return np.asarray((gaps >= LIMITS["far"] + _INSET).all(axis=1))
    q = poses[:, None, :2] - targets[None, :, :2]
    aside = np.abs(q[..., 0] * targets[:, 2] + q[..., 1] * targets[:, 3])
    ahead = -q[..., 0] * targets[:, 3] + q[..., 1] * targets[:, 2]
    half_width, half_depth = targets[:, 4], targets[:, 5]
    if kind == "center_aligned":
        held = np.minimum(aside, np.abs(ahead)) <= _ALIGNED - _INSET
    else:
        held = gaps <= LIMITS[kind] - _INSET
        if kind == "in_front_of":
            held &= (ahead > half_depth) & (aside <= np.maximum(half_width, 0.3) - _INSET)
        elif kind == "side_of":
            held &= (aside > half_width) & (np.abs(ahead) <= half_depth - _INSET)
    return np.asarray(held.any(axis=1))
