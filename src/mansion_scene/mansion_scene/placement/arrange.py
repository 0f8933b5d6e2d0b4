"""Repeated units as one pattern: evenly spaced rows along walls, aligned tables over the floor."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from mansion_geometry.boxes import compose, unit_vector
from mansion_scene.placement.candidates import wall_poses
from mansion_scene.placement.floor import Floor
from mansion_scene.placement.groups import Spec
from mansion_scene.placement.room import Wall
from mansion_scene.placement.scoring import pose_scores
from mansion_scene.placement.search import examine, relation_mask
from mansion_scene.placement.units import Unit

__all__ = ["place_along_walls", "place_lattice", "place_rows", "repeated", "row_gaps"]

Floats = npt.NDArray[np.float64]

_OFFSETS = 6
"""Positions of a lattice that are tried at each pitch."""


def repeated(unit: Unit, offsets: Floats) -> Unit:
    """Return one unit that holds a copy of `unit` at each offset, shape (n, 2), in the anchor's frame."""
    out = Unit()
    size = len(unit.parts)
    for i, (dx, dy) in enumerate(offsets):
        for part, spec, host, own in zip(unit.parts, unit.specs, unit.hosts, unit.sizes):
            out.parts.append((part[0] + float(dx), part[1] + float(dy), *part[2:]))
            out.specs.append(spec)
            out.hosts.append(host + i * size if host >= 0 else -1)
            out.sizes.append(own)
    return out


def row_gaps(floor: Floor, spec: Spec, unit: Unit, aisle: float) -> list[float]:
    """Return gaps between the units of a row in order of preference; plain storage stands shoulder to shoulder."""
    if spec.role.centred or spec.role.bed or len(unit.parts) > 1:
        return [aisle, 0.75 * aisle, floor.passage, 0.25, 0.05]
    return [floor.options.gap, floor.passage]


def place_rows(floor: Floor, spec: Spec, unit: Unit, count: int, rng: np.random.Generator, aisle: float) -> bool:
    """Place `count` units with their backs to walls in evenly spaced rows of equal length, all or none.

    Rows that leave an aisle between units come first, then shorter rows on several walls, then narrower spacing;
    storage stands shoulder to shoulder.
    """
    x0, x1, _, _ = unit.extent()
    gaps = row_gaps(floor, spec, unit, aisle)
    lengths = sorted({count, -(-count // 2), -(-count // 3)}, reverse=True)
    longest = max((wall.length for wall in floor.room.walls), default=0.0)
    for gap in gaps:
        pitch = x1 - x0 + gap
        for length in lengths:
            if length < 2 or (length - 1) * pitch + x1 - x0 > longest:
                continue
            before = floor.copy()
            left = count
            while left:
                n = min(length, left)
                offsets = np.array([[i * pitch, 0.0] for i in range(n)])
                if not _place_row(floor, spec, repeated(unit, offsets), rng):
                    break
                left -= n
            if not left:
                return True
            floor.__dict__.update(before.__dict__)
    return False


def _place_row(
    floor: Floor, spec: Spec, row: Unit, rng: np.random.Generator, *, walls: Sequence[Wall] | None = None
) -> bool:
    poses = wall_poses(floor, row.extent(), row.sizes[0][1] / 2, rng, walls=walls)
    if not len(poses):
        return False
    poses = poses[floor.fits(poses, row.array())]
    held, asked = relation_mask(floor, spec, row, poses)
    poses = poses[held == asked]
    if not len(poses):
        return False
    if len(poses) > 60:
        poses = poses[np.sort(rng.choice(len(poses), 60, replace=False))]
    scores = pose_scores(floor, spec, row, poses, rng, at_wall=True)
    return examine(floor, row, poses, scores, host=spec.host, most=6) is not None


def place_along_walls(
    floor: Floor, spec: Spec, unit: Unit, lines: int, per_line: int, rng: np.random.Generator, aisle: float
) -> bool:
    """Place one or two aligned rows with every back at a wall: two stand at opposite walls, facing each other.

    Where no two walls lie opposite, the rows go to any walls. All units or none are placed.
    """
    x0, x1, _, _ = unit.extent()
    for gap in row_gaps(floor, spec, unit, aisle):
        offsets = np.array([[i * (x1 - x0 + gap), 0.0] for i in range(per_line)])
        row = repeated(unit, offsets)
        if lines == 1:
            if _place_row(floor, spec, row, rng):
                return True
            continue
        for walls, distance in _opposite_walls(floor):
            across = distance - 2.0 * (unit.sizes[0][1] / 2 + floor.options.wall_gap)
            pair = _joined(row, _turned(row, float(offsets[-1, 0]), across))
            if _place_row(floor, spec, pair, rng, walls=walls):
                return True
    if lines == 1:
        return False
    before = floor.copy()
    if all(place_along_walls(floor, spec, unit, 1, per_line, rng, aisle) for _ in range(lines)):
        return True
    floor.__dict__.update(before.__dict__)
    return False


def _opposite_walls(floor: Floor) -> list[tuple[list[Wall], float]]:
    """Return walls by the distance of a parallel wall that faces them, the nearest first."""
    found: dict[float, list[Wall]] = {}
    for wall in floor.room.walls:
        for other in floor.room.walls:
            distance = float((other.start - wall.start) @ wall.inward)
            if wall.inward @ other.inward < -0.99999 and distance > 0.5:
                walls = found.setdefault(round(distance, 4), [])
                if not any(wall is known for known in walls):
                    walls.append(wall)
    return [(found[distance], distance) for distance in sorted(found)]


def _turned(unit: Unit, dx: float, dy: float) -> Unit:
    """Return a unit turned by 180 degrees about its anchor, then moved."""
    parts = [(dx - p[0], dy - p[1], -p[2], -p[3], *p[4:]) for p in unit.parts]
    return Unit(parts, list(unit.specs), list(unit.hosts), list(unit.sizes))


def _joined(first: Unit, second: Unit) -> Unit:
    """Return one unit with the parts of two."""
    shift = len(first.parts)
    return Unit(
        first.parts + second.parts,
        first.specs + second.specs,
        first.hosts + [host + shift if host >= 0 else -1 for host in second.hosts],
        first.sizes + second.sizes,
    )


def place_lattice(floor: Floor, spec: Spec, unit: Unit, count: int, rng: np.random.Generator, aisle: float) -> bool:
    """Place `count` units over the floor on one lattice in the direction of the walls, all or none.

    The pitch starts as wide as the area allows, so that a large room is used evenly, and shrinks until enough
    places are free.
    """
    x0, x1, y0, y1 = unit.extent()
    centre = np.array([(x0 + x1) / 2, (y0 + y1) / 2])
    spare = (floor.room.area / count) ** 0.5 - max(x1 - x0, y1 - y0)
    gap = max(min(spare, 2.5), 0.45)
    while gap >= 0.4:
        for turn in rng.permutation(2):
            for _ in range(_OFFSETS):
                poses = _lattice(floor, x1 - x0 + gap, y1 - y0 + gap, 90.0 * int(turn), centre, rng)
                if len(poses) < count:
                    continue
                poses = poses[floor.fits(poses, unit.array())]
                held, asked = relation_mask(floor, spec, unit, poses)
                poses = poses[held == asked]
                if len(poses) >= count and _put_lattice(floor, spec, unit, poses, count, rng):
                    return True
        gap *= 0.86
    return False


def _lattice(floor: Floor, px: float, py: float, turn: float, centre: Floats, rng: np.random.Generator) -> Floats:
    """Return lattice poses over the room's bounds with a random offset."""
    angle = (floor.room.angles or [0.0])[0] + turn
    u = np.array(unit_vector(angle))
    v = np.array([-u[1], u[0]])
    low, high = floor.room.bounds[:2], floor.room.bounds[2:]
    corners = np.array([(x, y) for x in (low[0], high[0]) for y in (low[1], high[1])])
    a = np.arange((corners @ u).min() + rng.uniform(0, px), (corners @ u).max(), px)
    b = np.arange((corners @ v).min() + rng.uniform(0, py), (corners @ v).max(), py)
    ga, gb = (g.ravel() for g in np.meshgrid(a, b))
    xy = np.outer(ga - centre[0], u) + np.outer(gb - centre[1], v)
    return np.hstack([xy, np.broadcast_to(u, (len(xy), 2))])


def _put_lattice(floor: Floor, spec: Spec, unit: Unit, poses: Floats, count: int, rng: np.random.Generator) -> bool:
    """Put `count` of the feasible lattice places that leave the doors and each other most room."""
    scores = pose_scores(floor, spec, unit, poses, rng, at_wall=False)
    for _ in range(3):
        chosen = np.sort(np.argsort(-scores, kind="stable")[:count])
        boxes = np.concatenate([compose(pose, unit.array()) for pose in poses[chosen]])
        size = len(unit.parts)
        hosts = [-2 - (h + i * size) if h >= 0 else -1 for i in range(count) for h in unit.hosts]
        if floor.put(boxes, unit.specs * count, hosts, unit.sizes * count) is not None:
            return True
        scores = scores + rng.uniform(-0.5, 0.5, len(scores))
    return False
