"""Relations between objects: which hold at a pose, and how many hold on a floor."""

from dataclasses import dataclass

import numpy as np

from mansion_geometry.boxes import gap_matrix
from mansion_geometry.compiled import Bools, Floats
from mansion_scene.placement.floor import Floor, Placed
from mansion_scene.placement.groups import Manner, Spec

__all__ = ["FIRST", "LIMITS", "Rating", "rate", "related_boxes", "relation_count", "relation_holds"]


LIMITS = {
    "near": 1.0,
    "far": 1.5,
    "in_front_of": 1.5,
    "around": 0.5,
    "side_of": 1.0,
    "at_head": 0.25,
    "opposite": 6.0,
    "in_run": 0.06,
    "sat_at": 0.2,
    "towards": 1.0,
}
"""Largest gap between footprints (``far``: the least), metres."""

_SAT_AT, _TOWARDS = 0.97, 0.5
"""Least cosine between where a seat at a table looks, or one near something, and the way to it."""

_HEAD = 0.2
"""How far a bedside table's back is from the line of the bed's at most, metres."""

_ASIDE, _VIEW = 0.3, 1.2
"""How far a screen is from the middle of the view at most, and ahead at least, metres."""

FIRST = 27.0
"""What a copy counts for beyond others where it comes first."""

_ALIGNED = 0.10
_INSET = 0.005
"""Margin kept from each limit, so that rounding never crosses it, metres."""


def relation_holds(kind: Manner, poses: Floats, hw: float, hd: float, targets: Floats) -> Bools:
    """Tell at which poses a box has a relation to a target's copies.

    Parameters
    ----------
    kind : Manner
        "far" must hold to every copy, the others to one.
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
        elif kind == "at_head":
            held &= (aside > half_width) & (np.abs(ahead + half_depth - hd) <= _HEAD) & (_turned(poses, targets) > 0.9)
        elif kind == "opposite":
            held &= (ahead > half_depth + _VIEW) & (aside <= _ASIDE) & (_turned(poses, targets) < -0.9)
        elif kind in ("sat_at", "towards"):
            held &= _looking(poses, targets) >= (_SAT_AT if kind == "sat_at" else _TOWARDS)
    return np.asarray(held.any(axis=1))


def _turned(poses: Floats, targets: Floats) -> Floats:
    """Return the cosine of the angle between each pose and each target, shape (n, m)."""
    return np.asarray(poses[:, None, 2] * targets[:, 2] + poses[:, None, 3] * targets[:, 3])


def _looking(poses: Floats, targets: Floats) -> Floats:
    """Return the cosine between a pose's front and the way to the nearest point of each target, shape (n, m)."""
    q = poses[:, None, :2] - targets[None, :, :2]
    right = q[..., 0] * targets[:, 2] + q[..., 1] * targets[:, 3]
    ahead = -q[..., 0] * targets[:, 3] + q[..., 1] * targets[:, 2]
    dx = np.clip(right, -targets[:, 4], targets[:, 4]) - right
    dy = np.clip(ahead, -targets[:, 5], targets[:, 5]) - ahead
    wx, wy = dx * targets[:, 2] - dy * targets[:, 3], dx * targets[:, 3] + dy * targets[:, 2]
    length = np.maximum(np.hypot(wx, wy), 1e-9)
    return np.asarray((-poses[:, None, 3] * wx + poses[:, None, 2] * wy) / length)


def related_boxes(floor: Floor, spec: Spec, kind: Manner, target: int) -> Floats:
    """Return the boxes to which an object may have a relation: of its target, or of all in the run of a kitchen."""
    if kind != "in_run":
        return floor.boxes_of(target)
    run = [other.index for other in floor.specs if other.role.fitment and other.index != spec.index]
    return np.concatenate([floor.boxes_of(index) for index in run])


@dataclass(frozen=True)
class Rating:
    """How complete a floor is.

    Attributes
    ----------
    placed : int
        Number of placed copies.
    held : int
        Number of relations and pairs that hold, over all copies.
    faulty : tuple of int
        Keys of copies with a relation that does not hold.
    first : int
        Placed copies of the objects that come first.
    """

    placed: int
    held: int
    faulty: tuple[int, ...]
    first: int = 0

    @property
    def value(self) -> float:
        """One number: a copy placed counts as much as three relations, one of what comes first as much as thirty."""
        return 3.0 * self.placed + self.held + FIRST * self.first


def relation_count(spec: Spec) -> int:
    """Return how many relations one copy is asked to hold, its pair among them."""
    return len(spec.relations) + (spec.link == "paired")


def rate(floor: Floor) -> Rating:
    """Count the placed copies and the relations that they hold."""
    held, faulty = 0, []
    for spec in floor.specs:
        if not relation_count(spec):
            continue
        paired = _paired(floor, spec)
        targets = [(kind, related_boxes(floor, spec, kind, target)) for kind, target in spec.relations]
        for copy in floor.copies(spec.index):
            box = np.array(copy.box)
            pose = box[None, :4]
            own = [bool(relation_holds(kind, pose, box[4], box[5], boxes)[0]) for kind, boxes in targets]
            if spec.link == "paired":
                own.append(copy.key in paired)
            held += sum(own)
            if not all(own):
                faulty.append(copy.key)
    first = sum(floor.specs[copy.spec].first for copy in floor.placed)
    return Rating(len(floor.placed), held, tuple(faulty), first)


def _paired(floor: Floor, spec: Spec) -> set[int]:
    """Return the keys of accessories that have an anchor of their own, matched from the nearest pair up."""
    if spec.link != "paired":
        return set()
    copies, hosts = floor.copies(spec.index), floor.boxes_of(spec.host)
    if not copies or not len(hosts):
        return set()

    def gaps(copy: Placed) -> list[float]:
        box = np.array(copy.box)
        return [float(g) for g in gap_matrix(box[None, :4], box[4], box[5], hosts)[0]]

    pairs = sorted((gap, i, j) for i, copy in enumerate(copies) for j, gap in enumerate(gaps(copy)))
    used: set[int] = set()
    taken: set[int] = set()
    for gap, i, j in pairs:
        if gap <= LIMITS["around"] and i not in used and j not in taken:
            used.add(i)
            taken.add(j)
    return {copies[i].key for i in used}
