"""FINDFEASIBLEPLACEMENT of Algorithm 4: candidate poses, hard filters, a score, then incremental reachability."""

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from mansion_geometry.boxes import compose, gap_matrix
from mansion_geometry.compiled import Floats
from mansion_geometry.fitting import front_clearance
from mansion_scene.placement.candidates import floor_poses, opposite_poses, ring_poses, wall_poses
from mansion_scene.placement.floor import Floor, Placed
from mansion_scene.placement.groups import Spec
from mansion_scene.placement.relations import LIMITS, related_boxes, relation_holds
from mansion_scene.placement.scoring import WORKED_AT, hob_before_window, pose_scores, screen_of, view, with_way_around
from mansion_scene.placement.units import Unit

__all__ = ["examine", "find_placement", "needs_floor_before", "relation_mask", "worked_at"]


_RELATED, _SCORED = 900, 200
"""Feasible poses whose relations are tested, and of these how many are scored; more are thinned out at random."""


_VIEW = 0.5
"""Least score of a view that a sofa is free in the room for."""


def find_placement(
    floor: Floor, spec: Spec, unit: Unit, rng: np.random.Generator, *, strict: bool = True, clear_hob: bool = False
) -> list[Placed] | None:
    """Place a unit at its best feasible pose.

    Parameters
    ----------
    strict : bool
        Whether all of the anchor's relations must hold; else as many as can. An edge object keeps to a wall
        either way.
    clear_hob : bool
        Whether a hob must not stand before a window.

    Returns
    -------
    The new copies, or None where no examined pose is feasible.
    """
    for way, poses, at_wall in _ways(floor, spec, unit, rng):
        if not len(poses):
            continue
        poses = _thinned(poses[floor.fits(poses, way.array())], _RELATED, rng)
        if not at_wall:
            poses = poses[with_way_around(floor, spec, way, poses)]
        if needs_floor_before(floor, spec, strict=strict):
            poses = poses[worked_at(floor, way, poses)]
        if clear_hob:
            poses = poses[~hob_before_window(floor, way, poses)]
        held, asked = relation_mask(floor, spec, way, poses)
        if strict:
            poses, held = poses[held == asked], held[held == asked]
        if not len(poses):
            continue
        if len(poses) > _SCORED:
            chosen = np.sort(rng.choice(len(poses), _SCORED, replace=False))
            poses, held = poses[chosen], held[chosen]
        scores = pose_scores(floor, spec, way, poses, rng, at_wall=at_wall)
        scores += 2.0 * held + _belonging(floor, spec, way, poses)
        placed = examine(floor, way, poses, scores, host=spec.host)
        if placed is not None:
            return placed
    return None


def needs_floor_before(floor: Floor, spec: Spec, *, strict: bool = True) -> bool:
    """Whether a copy is better left out than put where nobody can work: one more worktop, not the only one."""
    return spec.role.fitment == "worktop" and not spec.first and (strict or floor.count(spec.index) > 0)


def worked_at(floor: Floor, unit: Unit, poses: Floats) -> npt.NDArray[np.bool_]:
    """Tell at which poses there is floor to work on before every worktop and appliance of a unit."""
    fine = np.ones(len(poses), dtype=np.bool_)
    for x, y, ux, uy, half_width, half_depth in (part[:6] for part in unit.parts):
        placed = np.column_stack(
            [
                poses[:, 0] + x * poses[:, 2] - y * poses[:, 3],
                poses[:, 1] + x * poses[:, 3] + y * poses[:, 2],
                ux * poses[:, 2] - uy * poses[:, 3],
                ux * poses[:, 3] + uy * poses[:, 2],
            ]
        )
        clear = front_clearance(placed, half_width, half_depth, floor.room.edges, floor.boxes, WORKED_AT)
        fine &= clear[:, 0] > WORKED_AT - 0.05
    return fine


def _thinned(poses: Floats, most: int, rng: np.random.Generator) -> Floats:
    if len(poses) <= most:
        return poses
    return np.asarray(poses[np.sort(rng.choice(len(poses), most, replace=False))])


def examine(
    floor: Floor, unit: Unit, poses: Floats, scores: Floats, *, host: int = -1, most: int = 0
) -> list[Placed] | None:
    """Try poses from the best score down; close neighbours of a failure are skipped.

    Parameters
    ----------
    host : int
        Index of the object that the unit's anchor belongs to, -1 for none.
    most : int
        Most poses to examine, 0 for the options' number.
    """
    order = np.argsort(-scores, kind="stable")
    tried: list[Floats] = []
    radius = 0.08
    for i in order:
        pose = poses[i]
        if any(abs(pose[0] - t[0]) + abs(pose[1] - t[1]) < radius and pose[2:] @ t[2:] > 0.9 for t in tried):
            continue
        placed = floor.put(compose(pose, unit.array()), unit.specs, _hosts(floor, unit, pose, host), unit.sizes)
        if placed is not None:
            return placed
        tried.append(pose)
        radius = 0.08 + 0.02 * len(tried)
        if len(tried) >= (most or floor.options.candidates):
            break
    return None


def _hosts(floor: Floor, unit: Unit, pose: Floats, host: int) -> list[int]:
    """Return host keys for `Floor.put`: within the unit, or the nearest copy that the anchor belongs to."""
    hosts = floor.copies(host) if host >= 0 else []
    if not hosts:
        first = -1
    else:
        box = np.array([pose[:4]])
        gaps = gap_matrix(box, unit.sizes[0][0] / 2, unit.sizes[0][1] / 2, np.array([h.box for h in hosts]))
        first = hosts[int(gaps[0].argmin())].key
    return [-2 - at if at >= 0 else first for at in unit.hosts]


def relation_mask(floor: Floor, spec: Spec, unit: Unit, poses: Floats) -> tuple[npt.NDArray[np.int64], int]:
    """Count at each pose the relations of the unit's anchor that hold, and the "far" relations to it of placed objects.

    Returns
    -------
    held : (n,) int array
    asked : int
        How many could hold at most.
    """
    hw, hd = unit.sizes[0][0] / 2, unit.sizes[0][1] / 2
    held = np.zeros(len(poses), dtype=np.int64)
    asked = 0
    for kind, target in spec.relations:
        boxes = related_boxes(floor, spec, kind, target)
        if len(boxes):
            asked += 1
            held += relation_holds(kind, poses, hw, hd, boxes)
    if spec.link == "paired":
        boxes = _free_hosts(floor, spec)
        if len(boxes):
            asked += 1
            held += relation_holds("sat_at" if spec.role.seat else "around", poses, hw, hd, boxes)
    for other in floor.specs:
        if ("far", spec.index) in other.relations:
            boxes = floor.boxes_of(other.index)
            if len(boxes):
                asked += 1
                held += relation_holds("far", poses, hw, hd, boxes)
    return held, asked


def _free_hosts(floor: Floor, spec: Spec) -> Floats:
    """Return the boxes of host copies that have the fewest members of this kind."""
    hosts = floor.copies(spec.host)
    load = {host.key: 0 for host in hosts}
    for copy in floor.copies(spec.index):
        if copy.host in load:
            load[copy.host] += 1
    least = min(load.values(), default=0)
    return np.array([h.box for h in hosts if load[h.key] == least]).reshape(-1, 6)


def _ways(floor: Floor, spec: Spec, unit: Unit, rng: np.random.Generator) -> Iterator[tuple[Unit, Floats, bool]]:
    """Yield the candidates of a unit; for a sofa those with a view of its screen first, at a wall or free."""
    ways = [(unit, poses, at_wall) for poses, at_wall in _candidates(floor, spec, unit, rng)]
    screen = screen_of(floor, spec)
    if screen is None:
        yield from ways
        return
    if spec.where == "edge":
        ways.append((unit.freed(), floor_poses(floor, rng), False))
    for way, poses, at_wall in ways:
        yield way, poses[view(floor, screen, poses) > _VIEW], at_wall
    yield from ways


def _candidates(floor: Floor, spec: Spec, unit: Unit, rng: np.random.Generator) -> list[tuple[Floats, bool]]:
    """Return candidate sets in order of preference, each with whether its poses are backed by a wall."""
    walls = wall_poses(floor, unit.extent(), unit.sizes[0][1] / 2, rng)
    if spec.where == "edge":
        viewed = [floor.boxes_of(target) for kind, target in spec.relations if kind == "opposite"]
        facing = [opposite_poses(floor, unit.sizes[0][1] / 2, boxes) for boxes in viewed]
        return [(np.concatenate([*facing, walls]), True)]
    grid = floor_poses(floor, rng)
    rings = _rings(floor, spec, unit)
    if spec.where == "middle":
        return [(np.concatenate([rings, grid]), False), (walls, True)]
    free = np.concatenate([rings, walls, grid])
    return [(free, False)]


def _rings(floor: Floor, spec: Spec, unit: Unit) -> Floats:
    """Return poses around the copies that the unit's anchor belongs to."""
    if spec.host < 0 or spec.link is None:
        return np.zeros((0, 4))
    targets = _free_hosts(floor, spec)[:6]
    hw, hd = unit.sizes[0][0] / 2, unit.sizes[0][1] / 2
    limit = LIMITS.get(spec.link, 0.5)
    loose = spec.link == "near" and (spec.role.seat or spec.role.sofa)
    gaps = tuple(g for g in ((0.1, 0.3, 0.45, 0.7) if loose else (0.03, 0.08, 0.3, 0.6)) if g <= limit - 0.05)
    turned = (0,) if spec.role.seat else (0, 1)
    return ring_poses(targets, hw, hd, gaps, turned=turned)


_ONE_SEAT = 1.15
"""Length of a table's side below which one seat is at it, in its middle, metres."""

_OFF_MIDDLE = 2.0
"""What each metre costs by which such a seat is away from the middle."""


def _off_middle(poses: Floats, hosts: Floats) -> Floats:
    """Return how far each pose is from the middle of the side of its host that it is at, metres; 0 at long sides."""
    q = poses[:, :2] - hosts[:, :2]
    right = np.abs(q[:, 0] * hosts[:, 2] + q[:, 1] * hosts[:, 3])
    ahead = np.abs(-q[:, 0] * hosts[:, 3] + q[:, 1] * hosts[:, 2])
    beside = right - hosts[:, 4] > ahead - hosts[:, 5]
    length = 2.0 * np.where(beside, hosts[:, 5], hosts[:, 4])
    return np.asarray(np.where(length < _ONE_SEAT, np.where(beside, ahead, right), 0.0))


_BEHIND = 1.2
"""What a seat counts for behind a counter with staff, rather than before it."""


def _belonging(floor: Floor, spec: Spec, unit: Unit, poses: Floats) -> Floats:
    """Members like to be close to a host copy without one yet; seats like to face it."""
    if spec.host < 0:
        return np.zeros(len(poses))
    targets = _free_hosts(floor, spec)
    if not len(targets):
        return np.zeros(len(poses))
    gaps = gap_matrix(poses, unit.sizes[0][0] / 2, unit.sizes[0][1] / 2, targets)
    nearest = gaps.argmin(axis=1)
    # Legs need room between an armchair and its table; the rest belongs close.
    seat = spec.role.seat or spec.role.sofa
    wanted = 0.35 if spec.link == "near" and seat else 0.0
    score = 1.0 - np.minimum(np.abs(gaps.min(axis=1) - wanted), 2.0) / 2.0
    if seat:
        q = targets[nearest, :2] - poses[:, :2]
        q /= np.maximum(np.hypot(q[:, 0], q[:, 1]), 1e-6)[:, None]
        score += 0.6 * (-poses[:, 3] * q[:, 0] + poses[:, 2] * q[:, 1])
        host = targets[nearest]
        if spec.link == "around":
            score -= _OFF_MIDDLE * _off_middle(poses, host)
        if floor.specs[spec.host].role.staffed:
            score += _BEHIND * (-host[:, 3] * q[:, 0] + host[:, 2] * q[:, 1])
    return np.asarray(score)
