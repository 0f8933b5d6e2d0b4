"""Scores of feasible poses: clear fronts, storage without gaps, centred beds and desks, even use, aligned rows."""

import numpy as np

from mansion_geometry.boxes import gap_matrix
from mansion_geometry.compiled import Bools, Floats
from mansion_geometry.fitting import front_clearance
from mansion_scene.placement.floor import Floor
from mansion_scene.placement.groups import Spec
from mansion_scene.placement.units import Unit

__all__ = ["WORKED_AT", "hob_before_window", "looks_along", "pose_scores", "screen_of", "view", "with_way_around"]


_FAR = 1.5

_NEAREST, _USUAL = 2.0, 4.5
"""Least distance from the middle of a sofa to the wall with the screen, and the usual at most, metres."""

WORKED_AT = 0.9
"""Depth of the floor before a kitchen's counters where one works, metres."""

_WAY = 0.65
"""Free floor around a group of sofas in a public room, metres."""

_PASSED, _CROWDED = 0.45, 1.5
"""Free floor on each side of a group of furniture, metres, and what it costs to have less."""

_LONG, _AT_THE_END = 1.4, 1.2
"""Length of a room, in its widths, from which an audience looks along it, and what it is worth to face it there."""

_FOR_TWO, _ENTRY = 1.3, 0.5
"""Width of a bed from which two sleep in it, and of the floor on either side where they get in, metres."""


def pose_scores(
    floor: Floor, spec: Spec, unit: Unit, poses: Floats, rng: np.random.Generator, *, at_wall: bool
) -> Floats:
    """Return a score for each feasible pose of a unit, higher is better.

    Parameters
    ----------
    poses : (n, 4) array
        Poses of the unit's anchor.
    at_wall : bool
        Whether the anchor's back is at a wall at these poses.
    """
    x0, x1, y0, y1 = unit.extent()
    mx, my = (x0 + x1) / 2, (y0 + y1) / 2
    centres = poses.copy()
    centres[:, 0] += mx * poses[:, 2] - my * poses[:, 3]
    centres[:, 1] += mx * poses[:, 3] + my * poses[:, 2]
    room = floor.room
    aisle = room.aisle
    clear = front_clearance(centres, (x1 - x0) / 2, (y1 - y0) / 2, room.edges, floor.boxes, _FAR)
    screen = screen_of(floor, spec)
    # Sofas and desks dominate a room: more weight for chance there gives variety between seeds.
    score = rng.uniform(0.0, 0.5 if spec.role.sofa or spec.role.table else 0.25, len(poses))
    front = np.minimum(clear[:, 0], aisle) / aisle
    if at_wall:
        score += _at_wall(floor, spec, unit, poses, clear)
    else:
        around = np.minimum(clear, aisle).sum(axis=1) / (4 * aisle)
        uneven = np.abs(clear[:, 0] - clear[:, 1]) + np.abs(clear[:, 2] - clear[:, 3])
        narrow = ((clear > 0.12) & (clear < 0.5)).sum(axis=1)
        if spec.where == "middle" or len(unit.parts) > 1:
            score += 2.0 * around - 0.25 * narrow - 0.1 * uneven
            score -= _CROWDED * (clear.min(axis=1) < _PASSED) * (len(unit.parts) > 1)
        else:
            score += 0.5 * front + 0.5 * (1.0 - clear.min(axis=1) / _FAR) - 0.1 * narrow
    if screen is not None:
        score += view(floor, screen, poses)
    score -= _beside_beds(floor, centres, (x1 - x0) / 2, (y1 - y0) / 2)
    if spec.role.fitment is None:
        score -= _before_runs(floor, centres, (x1 - x0) / 2, (y1 - y0) / 2)
    if spec.role.staffed:
        score += _towards_entrance(floor, poses)
    score += _away_from_doors(floor, poses, spec)
    score += _spread_out(floor, spec, centres)
    score += _aligned(floor, spec, poses)
    return np.asarray(score)


def _at_wall(floor: Floor, spec: Spec, unit: Unit, poses: Floats, clear: Floats) -> Floats:
    """Return a score for poses with the back to a wall, given the free floor on each side."""
    beside = np.minimum(clear[:, 2], clear[:, 3])
    score = 1.2 * np.minimum(clear[:, 0], floor.room.aisle) / floor.room.aisle
    if spec.role.screen:
        score += _opposite_sofa(floor, poses)
    if spec.role.fitment:
        score -= 1.5 * hob_before_window(floor, unit, poses)
    if spec.role.centred or spec.role.bed:
        score += 0.8 * np.minimum(beside, 0.9) / 0.9
        score -= 0.15 * np.abs(clear[:, 2] - clear[:, 3])
        if spec.role.focal:
            score -= _window_behind(floor, poses)
            score += _same_wall(floor, spec, poses)
            score += _AT_THE_END * looks_along(floor, poses)
    else:
        score += 0.5 * (1.0 - beside / _FAR)
        # Either touching its neighbour or leaving room to pass: no unusable gap.
        score -= 0.4 * ((beside > 0.06) & (beside < 0.35))
    return np.asarray(score)


def looks_along(floor: Floor, poses: Floats) -> Bools:
    """Tell which poses look along a long room, either way; none in a room that is not long."""
    sides = floor.room.bounds[2:] - floor.room.bounds[:2]
    if float(sides.max()) < _LONG * float(sides.min()):
        return np.zeros(len(poses), dtype=np.bool_)
    return np.asarray(np.abs((-poses[:, 3], poses[:, 2])[int(np.argmax(sides))]) > 0.9)


def _window_behind(floor: Floor, poses: Floats) -> Floats:
    """Return a penalty for a board on a wall with windows or doors."""
    penalty = np.zeros(len(poses))
    for zones, weight in ((floor.room.window_zones, 0.6), (floor.room.door_zones, 0.3)):
        for zone in zones:
            same = (-poses[:, 3] * -zone[3] + poses[:, 2] * zone[2]) > 0.99
            back = (poses[:, 0] - zone[0]) * -zone[3] + (poses[:, 1] - zone[1]) * zone[2]
            penalty = np.maximum(penalty, weight * (same & (np.abs(back) < 1.0)))
    return penalty


def _opposite_sofa(floor: Floor, poses: Floats) -> Floats:
    """Return a score for a screen that faces the sofa, straight ahead of it."""
    for copy in floor.placed:
        if floor.specs[copy.spec].role.sofa:
            u = np.array(copy.box[2:4])
            aside = np.abs((poses[:, :2] - np.array(copy.box[:2])) @ u)
            return np.asarray(-(poses[:, 2:] @ u) - 0.3 * np.minimum(aside, 3.0))
    return np.zeros(len(poses))


def screen_of(floor: Floor, spec: Spec) -> Spec | None:
    """Return the screen that is to stand opposite of a sofa, and does not yet."""
    if not spec.role.sofa:
        return None
    screens = [other for other in floor.specs if ("opposite", spec.index) in other.relations]
    return next((screen for screen in screens if not floor.count(screen.index)), None)


def view(floor: Floor, screen: Spec, poses: Floats) -> Floats:
    """Return a score for sofas that a screen fits opposite of, against the nearest wall ahead, at a usual distance."""
    front = np.column_stack([-poses[:, 3], poses[:, 2]])
    nearest, found = np.full(len(poses), np.inf), np.zeros((len(poses), 4))
    half_depth = screen.size[1] / 2 + floor.options.wall_gap
    for wall in floor.room.walls:
        q = poses[:, :2] - wall.start
        at, ahead = q @ wall.along, q @ wall.inward
        seen = (front @ wall.inward < -0.99) & (at > 0.0) & (at < wall.length) & (ahead > 0.0) & (ahead < nearest)
        centres = wall.start + at[:, None] * wall.along + half_depth * wall.inward
        found[seen] = np.column_stack([centres, np.tile(wall.along, (len(poses), 1))])[seen]
        nearest[seen] = ahead[seen]
    part = np.array([[0.0, 0.0, 1.0, 0.0, screen.size[0] / 2, screen.size[1] / 2, screen.size[2], 0.0]])
    usual = np.clip((nearest - _NEAREST) / 0.6, 0.0, 1.0) - np.maximum(np.minimum(nearest, 9.0) - _USUAL, 0.0) / 4.0
    possible = np.isfinite(nearest)
    possible[possible] = floor.fits(found[possible], part)
    return np.asarray(np.where(possible, 1.5 * usual, 0.0))


def with_way_around(floor: Floor, spec: Spec, unit: Unit, poses: Floats) -> Bools:
    """Tell at which poses people pass on every side of a group of sofas on the floor of a public room."""
    if not (spec.role.sofa and spec.where == "middle" and floor.room.public) or spec.first:
        return np.ones(len(poses), dtype=np.bool_)
    x0, x1, y0, y1 = unit.extent()
    mx, my = (x0 + x1) / 2, (y0 + y1) / 2
    centres = poses.copy()
    centres[:, 0] += mx * poses[:, 2] - my * poses[:, 3]
    centres[:, 1] += mx * poses[:, 3] + my * poses[:, 2]
    clear = front_clearance(centres, (x1 - x0) / 2, (y1 - y0) / 2, floor.room.edges, floor.boxes, _WAY)
    return np.asarray(clear.min(axis=1) >= _WAY - 0.05)


def hob_before_window(floor: Floor, unit: Unit, poses: Floats) -> Bools:
    """Tell at which poses the hob of a unit stands before a window."""
    hobs = [i for i, index in enumerate(unit.specs) if floor.specs[index].role.fitment == "hob"]
    windows = floor.room.window_zones
    if not hobs or not len(windows):
        return np.zeros(len(poses), dtype=np.bool_)
    x, y, ux, uy, half_width, half_depth = unit.parts[hobs[0]][:6]
    placed = poses.copy()
    placed[:, 0] += x * poses[:, 2] - y * poses[:, 3]
    placed[:, 1] += x * poses[:, 3] + y * poses[:, 2]
    placed[:, 2], placed[:, 3] = (ux * poses[:, 2] - uy * poses[:, 3], ux * poses[:, 3] + uy * poses[:, 2])
    return np.asarray((gap_matrix(placed, half_width, half_depth, windows[:, :6]) <= 0.0).any(axis=1))


def _beside_beds(floor: Floor, centres: Floats, half_width: float, half_depth: float) -> Floats:
    """Return a penalty for what stands where one gets into a bed for two, on either side below its head."""
    strips = [
        (x + sign * (hw + _ENTRY / 2) * ux - 0.3 * uy, y + sign * (hw + _ENTRY / 2) * uy + 0.3 * ux, ux, uy)
        for x, y, ux, uy, hw, _ in (copy.box for copy in floor.placed if floor.specs[copy.spec].role.bed)
        if 2 * hw >= _FOR_TWO
        for sign in (-1.0, 1.0)
    ]
    if not strips:
        return np.zeros(len(centres))
    boxes = np.column_stack([np.array(strips), np.full((len(strips), 2), (_ENTRY / 2, 0.6))])
    return np.asarray(1.0 * (gap_matrix(centres, half_width, half_depth, boxes) <= 0.0).any(axis=1))


def _before_runs(floor: Floor, centres: Floats, half_width: float, half_depth: float) -> Floats:
    """Return a penalty for what stands where one works at the counters and appliances of a kitchen."""
    strips = [
        (x - (hd + WORKED_AT / 2) * uy, y + (hd + WORKED_AT / 2) * ux, ux, uy, hw, WORKED_AT / 2)
        for x, y, ux, uy, hw, hd in (copy.box for copy in floor.placed if floor.specs[copy.spec].role.fitment)
    ]
    if not strips:
        return np.zeros(len(centres))
    return np.asarray(2.0 * (gap_matrix(centres, half_width, half_depth, np.array(strips)) <= 0.0).any(axis=1))


def _same_wall(floor: Floor, spec: Spec, poses: Floats) -> Floats:
    """Return a score that gathers the objects a class faces at one wall."""
    score = np.zeros(len(poses))
    for copy in floor.placed:
        if floor.specs[copy.spec].role.focal and copy.spec != spec.index:
            score += 2.0 * (poses[:, 2:] @ np.array(copy.box[2:4]) > 0.99)
            score -= 0.1 * np.abs((poses[:, :2] - np.array(copy.box[:2])) @ np.array(copy.box[2:4]))
    return score


def _ways_in(floor: Floor) -> Floats:
    """Return the middles of the doors through which visitors come, shape (n, 2): from outside, else the widest."""
    widths = np.array([np.hypot(*(door[2:] - door[:2])) for door in floor.room.doors])
    if floor.room.outer_doors.any():
        widths = np.where(floor.room.outer_doors, widths, 0.0)
    return np.asarray(floor.room.door_points[widths >= widths.max() - 0.05])


def _towards_entrance(floor: Floor, poses: Floats) -> Floats:
    """Return a score for counters whose front looks towards the way in."""
    if not len(floor.room.door_points):
        return np.zeros(len(poses))
    ways = _ways_in(floor)[None] - poses[:, None, :2]
    ahead = (-poses[:, None, 3] * ways[..., 0] + poses[:, None, 2] * ways[..., 1]) / np.hypot(*ways.transpose(2, 0, 1))
    return np.asarray(_FACING * ahead.max(axis=1))


_FACING = 1.5
"""What a counter counts for that looks straight towards the way in, beside one that looks along the room."""


def _away_from_doors(floor: Floor, poses: Floats, spec: Spec) -> Floats:
    """Return a score for distance from doors, which counts more for large objects."""
    doors = floor.room.door_points
    if not len(doors):
        return np.zeros(len(poses))
    if spec.role.entrance:
        doors = _ways_in(floor)
    distance = np.hypot(*(poses[:, None, :2] - doors[None]).transpose(2, 0, 1)).min(axis=1)
    if spec.role.entrance:
        return np.asarray(-0.8 * np.abs(np.minimum(distance, 6.0) - 1.6) / 4.4)
    weight = 0.6 if spec.size[0] * spec.size[1] > 0.5 else 0.2
    return np.asarray(weight * np.minimum(distance, 3.0) / 3.0)


def _spread_out(floor: Floor, spec: Spec, centres: Floats) -> Floats:
    """Return a score that keeps single copies apart and uses large rooms evenly."""
    score = np.zeros(len(centres))
    if len(floor.boxes) and spec.where == "middle":
        gaps = gap_matrix(centres, 0.01, 0.01, floor.boxes).min(axis=1)
        score += 0.3 * np.minimum(gaps, 3.0) / 3.0
    same = floor.boxes_of(spec.index)
    if len(same) and spec.role.symmetric:
        gaps = gap_matrix(centres, 0.01, 0.01, same).min(axis=1)
        score += 0.4 * np.minimum(gaps, 4.0) / 4.0
    return score


def _aligned(floor: Floor, spec: Spec, poses: Floats) -> Floats:
    """Return a score for poses in line with earlier copies, turned the same way or the opposite."""
    same = floor.boxes_of(spec.index)
    if not len(same):
        return np.zeros(len(poses))
    q = poses[:, None, :2] - same[None, :, :2]
    along = np.abs(q[..., 0] * same[:, 2] + q[..., 1] * same[:, 3])
    across = np.abs(-q[..., 0] * same[:, 3] + q[..., 1] * same[:, 2])
    parallel = np.abs(poses[:, None, 2] * same[:, 2] + poses[:, None, 3] * same[:, 3]) > 0.999
    return np.asarray(0.25 * ((np.minimum(along, across) < 0.02) & parallel).any(axis=1))
