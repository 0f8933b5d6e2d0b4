"""Repeated units as one pattern: rows along walls, lattices over the floor, and matrices of rows and columns."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from mansion_geometry.boxes import compose, unit_vector
from mansion_geometry.compiled import Floats
from mansion_geometry.fitting import front_clearance
from mansion_scene.placement.candidates import floor_poses, flush_poses, wall_poses
from mansion_scene.placement.floor import Floor
from mansion_scene.placement.groups import Spec
from mansion_scene.placement.room_model import Wall
from mansion_scene.placement.scoring import looks_along, pose_scores, with_way_around
from mansion_scene.placement.search import examine, needs_floor_before, relation_mask, worked_at
from mansion_scene.placement.units import Unit

__all__ = [
    "downgrades",
    "focus_direction",
    "place_along_walls",
    "place_lattice",
    "place_matrix",
    "place_rows",
    "repeated",
    "row_gaps",
]


BACK_TO_BACK = 0.4
"""Least gap between the seats of neighbouring tables that people pass through, metres."""

_BETWEEN_BEDS = 0.5
"""Least gap between beds in a row where no number of beds is asked for, metres."""

_FORKLIFT_AISLES = (3.0, 2.6, 2.2, 1.8)
"""Widths of the aisles between pallet racks that are tried, metres: a reach truck turns in 2.7 m."""

_ALONG_SHELVES = 0.75
"""Least width of an aisle between shelves that nobody asks for a number of, metres."""

_FLUE = 0.1
"""Gap between the backs of a double row, metres."""

_LEGS = 0.5
"""Least distance between the rows of an audience, metres."""

_VIEW = 3.0
"""Free floor before an audience, metres; more does not count."""

_LEAST_VIEW, _FEWER = 2.0, 0.5
"""Least free floor before an audience, metres, and the share of its seats that may lack it."""

_SCREEN = 5.0
"""Width of a wall for a screen or a stage, metres; more does not count."""

_OFFSETS = 6
"""Positions of a lattice that are tried at each pitch."""


def repeated(unit: Unit, offsets: Floats) -> Unit:
    """Return one unit that holds a copy of `unit` at each offset, shape (n, 2), in the anchor's frame."""
    size, copies = len(unit.parts), len(offsets)
    return Unit(
        parts=tuple((part[0] + float(dx), part[1] + float(dy), *part[2:]) for dx, dy in offsets for part in unit.parts),
        specs=unit.specs * copies,
        hosts=tuple(host + i * size if host >= 0 else -1 for i in range(copies) for host in unit.hosts),
        sizes=unit.sizes * copies,
    )


def row_gaps(floor: Floor, spec: Spec, unit: Unit, aisle: float) -> list[float]:
    """Return gaps between the units of a row in order of preference; plain storage is placed side by side."""
    if spec.role.bed and not spec.first:
        return [aisle, 0.75 * aisle, _BETWEEN_BEDS]
    if spec.role.centred or spec.role.bed or len(unit.parts) > 1:
        return [aisle, 0.75 * aisle, floor.passage, 0.25, 0.05]
    return [floor.options.gap, floor.passage]


def place_rows(floor: Floor, spec: Spec, unit: Unit, count: int, rng: np.random.Generator, aisle: float) -> bool:
    """Place `count` units with their backs to walls in evenly spaced rows of equal length, all or none.

    Rows that leave an aisle between units come first, then shorter rows on several walls, then narrower spacing;
    storage is placed side by side.
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
            floor.restore(before)
    return False


def _place_row(
    floor: Floor, spec: Spec, row: Unit, rng: np.random.Generator, *, walls: Sequence[Wall] | None = None
) -> bool:
    poses = wall_poses(floor, row.extent(), row.sizes[0][1] / 2, rng, walls=walls)
    if not len(poses):
        return False
    poses = poses[floor.fits(poses, row.array())]
    if needs_floor_before(floor, spec):
        poses = poses[worked_at(floor, row, poses)]
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
    floor.restore(before)
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
    return replace(unit, parts=tuple((dx - p[0], dy - p[1], -p[2], -p[3], *p[4:]) for p in unit.parts))


def _joined(first: Unit, second: Unit) -> Unit:
    """Return one unit with the parts of two."""
    shift = len(first.parts)
    return Unit(
        first.parts + second.parts,
        first.specs + second.specs,
        first.hosts + tuple(host + shift if host >= 0 else -1 for host in second.hosts),
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
                poses = poses[with_way_around(floor, spec, unit, poses)]
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


def downgrades(rows: int, cols: int) -> Iterator[tuple[int, int]]:
    """Yield smaller matrices, the one that keeps most copies first (DOWNGRADEMATRIX), beginning with the whole."""
    sizes = [(r, c) for r in range(1, rows + 1) for c in range(1, cols + 1)]
    yield from sorted(sizes, key=lambda s: (-s[0] * s[1], -min(s), -s[1]))


def focus_direction(floor: Floor) -> Floats | None:
    """Return the direction that the board, stage or teacher's desk faces; None without one."""
    for copy in floor.placed:
        if floor.specs[copy.spec].role.focal:
            return np.array([-copy.box[3], copy.box[2]])
    return None


def place_matrix(
    floor: Floor, spec: Spec, unit: Unit, rng: np.random.Generator, aisle: float, *, least: float, roomy: bool = False
) -> tuple[int, int] | None:
    """Place the largest matrix of units that fits and return its size, None where not even one copy fits.

    Parameters
    ----------
    unit : Unit
        One copy with its members.
    aisle : float
        Widest gap between rows and columns that is tried, metres.
    least : float
        Share of the copies below which no smaller matrix is tried: 1 for the whole one alone.
    roomy : bool
        Whether people pass between copies in both directions.
    """
    for rows, cols in downgrades(spec.rows, spec.cols):
        if rows * cols < least * spec.rows * spec.cols - 1e-9:
            break
        if spec.where == "edge" and min(rows, cols) <= 2:
            if place_along_walls(floor, spec, unit, min(rows, cols), max(rows, cols), rng, aisle):
                return rows, cols
            continue
        if _place_whole(floor, spec, unit, rows, cols, rng, aisle, roomy=roomy):
            return rows, cols
    return None


def _place_whole(
    floor: Floor, spec: Spec, unit: Unit, rows: int, cols: int, rng: np.random.Generator, aisle: float, *, roomy: bool
) -> bool:
    """Place a matrix of one size at the most comfortable spacing that fits."""
    shapes = [(rows, cols)] if rows == cols else [(rows, cols), (cols, rows)]
    spacings = _spacings(floor, spec, unit, rows * cols, aisle)
    if roomy:
        spacings = [spacing for spacing in spacings if min(spacing) >= BACK_TO_BACK]
    for tried, gaps in enumerate(spacings):
        if tried == 2:
            # What does not fit at the narrowest spacings fits at no wider one.
            shapes = [
                shape
                for shape in shapes
                if any(len(_macro_poses(floor, spec, unit, shape, narrow, rng)[1]) for narrow in _narrowest(spacings))
            ]
        for shape in shapes:
            if _place_macro(floor, spec, unit, shape, gaps, rng):
                return True
    return False


def _narrowest(spacings: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return the spacings that no other undercuts in both directions."""
    return [(x, y) for x, y in spacings if not any((a <= x and b <= y) and (a, b) != (x, y) for a, b in spacings)]


def _is_audience(spec: Spec, unit: Unit) -> bool:
    """Whether copies are the seats of an audience, in rows one behind the other."""
    return spec.role.seat and spec.rows > 0 and len(unit.parts) == 1


def _spacings(floor: Floor, spec: Spec, unit: Unit, copies: int, aisle: float) -> list[tuple[float, float]]:
    """Return gaps between columns and between rows, the most comfortable first.

    Shelves and the seats of an audience are placed side by side with aisles between the rows; desks may have aisles in
    either direction.
    """
    lane = floor.passage
    if spec.role.driven_between:
        return [(floor.gap, wide) for wide in _FORKLIFT_AISLES] + [(floor.gap, aisle), (floor.gap, lane)]
    if spec.role.bed and not spec.first:
        return [(0.6, aisle), (_BETWEEN_BEDS, 0.75), (_BETWEEN_BEDS, _BETWEEN_BEDS), (lane, lane)]
    if spec.role.entered_at_ends:
        return [(wide, deep) for wide in (1.4, aisle, 0.8) for deep in (0.6, _LEGS, 0.4)] + [(floor.gap, _LEGS)]
    if _is_audience(spec, unit) and not spec.first:
        return [(floor.gap, 1.25 * aisle), (floor.gap, aisle), (floor.gap, 0.75), (floor.gap, 0.6), (floor.gap, _LEGS)]
    if spec.role.walked_along and not spec.first:
        return [(floor.gap, 1.25 * aisle), (floor.gap, aisle), (floor.gap, max(0.75 * aisle, _ALONG_SHELVES))]
    if len(unit.parts) == 1 and not spec.role.table:
        beside = 0.5 if spec.role.exercise else floor.gap
        return [
            *((beside, 1.25 * aisle), (beside, aisle), (beside, 0.75), (beside, 0.6), (beside, lane)),
            *((aisle, aisle), (0.6, 0.6), (lane, lane), (lane, beside)),
        ]
    spacings = [
        *((aisle, aisle), (0.8, aisle), (aisle, 0.6), (0.75, 0.75), (0.75, 0.45), (0.6, 0.6)),
        *((0.6, 0.3), (0.3, 0.6), (lane, 0.3), (0.3, lane), (lane, 0.12), (0.05, 0.6), (0.12, lane)),
        *((0.05, lane), (lane, 0.03), (0.02, lane)),
    ]
    if copies <= 4:
        spacings.append((0.1, 0.1))
    return [(x, y) for x, y in spacings if max(x, y) <= aisle + 1e-9]


def _macro_poses(
    floor: Floor, spec: Spec, unit: Unit, shape: tuple[int, int], gaps: tuple[float, float], rng: np.random.Generator
) -> tuple[Unit, Floats]:
    """Return the macro object of a matrix (BUILDMACROOBJECT) and poses at which it is in bounds and free."""
    x0, x1, y0, y1 = unit.extent()
    px = x1 - x0 + gaps[0]
    double = spec.role.back_to_back and spec.where != "edge" and len(unit.parts) == 1
    lines = _lines(shape[0], y1 - y0, gaps[1], double=double)
    width, depth = shape[1] * px - gaps[0], lines[-1][0] + y1 - y0
    span = floor.room.bounds[2:] - floor.room.bounds[:2]
    if width * depth > floor.room.area or max(width, depth) > float(np.hypot(*span)):
        return unit, np.zeros((0, 4))
    offsets = np.array([(c * px, y) for y, _ in lines for c in range(shape[1])])
    centre = (offsets.min(axis=0) + offsets.max(axis=0)) / 2
    if spec.where == "edge":
        macro = repeated(unit, offsets - [centre[0], 0.0])
        # Only the first row of a block of three and more can be at the wall.
        row = len(unit.parts) * shape[1]
        freed = tuple((*part[:7], 0.0) for part in macro.parts[row:])
        macro = replace(macro, parts=macro.parts[:row] + freed)
        poses = wall_poses(floor, macro.extent(), unit.sizes[0][1] / 2, rng)
    else:
        macro = repeated(unit, offsets - centre)
        if double:
            macro = _turned_about(macro, [turned for _, turned in lines for _ in range(shape[1])])
        flush = flush_poses(floor, macro.extent(), (floor.gap, floor.passage, floor.room.aisle))
        poses = np.concatenate([flush, floor_poses(floor, rng, limit=1000)])
    poses = _facing(floor, spec, unit, poses)
    if _is_audience(spec, unit) and not spec.first:
        poses = _looking_lengthwise(floor, poses)
    if not len(poses):
        return macro, poses
    return macro, poses[floor.fits(poses, macro.array())]


def _lines(rows: int, depth: float, gap: float, *, double: bool) -> list[tuple[float, bool]]:
    """Return where the rows of a matrix stand, and whether each looks back: those of a double row look apart."""
    lines: list[tuple[float, bool]] = []
    y = 0.0
    for row in range(rows):
        paired = double and row % 2 == 1
        if row:
            y += depth + (_FLUE if paired else gap)
        lines.append((y, double and rows > 1 and not paired))
    return lines


def _turned_about(macro: Unit, turned: Sequence[bool]) -> Unit:
    """Return a macro object of single parts with some of them turned round where they stand."""
    parts = tuple(
        (*part[:2], -part[2], -part[3], *part[4:]) if back else part
        for part, back in zip(macro.parts, turned, strict=True)
    )
    return replace(macro, parts=parts)


def _place_macro(
    floor: Floor, spec: Spec, unit: Unit, shape: tuple[int, int], gaps: tuple[float, float], rng: np.random.Generator
) -> bool:
    macro, poses = _macro_poses(floor, spec, unit, shape, gaps, rng)
    if not len(poses):
        return False
    audience = _is_audience(spec, unit)
    if audience and not spec.first and shape[0] * shape[1] > _FEWER * spec.rows * spec.cols:
        poses = poses[(_clear_before(floor, macro, poses) >= _LEAST_VIEW) & (_wide_ahead(floor, macro, poses) >= 0.7)]
        if not len(poses):
            return False
    if len(poses) > 80:
        poses = poses[np.sort(rng.choice(len(poses), 80, replace=False))]
    scores = pose_scores(floor, spec, macro, poses, rng, at_wall=spec.where == "edge")
    scores += _before_the_board(floor, spec, unit, poses)
    if audience:
        scores += _with_view(floor, macro, poses)
    return examine(floor, macro, poses, scores, most=5) is not None


def _facing(floor: Floor, spec: Spec, unit: Unit, poses: Floats) -> Floats:
    """Return the poses at which seats face the board, or all where there is none."""
    focus = focus_direction(floor)
    seated = [floor.specs[s].role.seat for s in unit.specs]
    if focus is None or not any(seated):
        return poses
    wanted = -focus if seated[0] else focus
    ahead = -poses[:, 3] * wanted[0] + poses[:, 2] * wanted[1]
    return np.asarray(poses[ahead > 0.9])


def _looking_lengthwise(floor: Floor, poses: Floats) -> Floats:
    """Return the poses at which an audience looks along a long room, where there are any."""
    along = looks_along(floor, poses)
    return np.asarray(poses[along]) if along.any() else poses


def _with_view(floor: Floor, macro: Unit, poses: Floats) -> Floats:
    """Return a score for free floor before the foremost row, and for a wide wall without doors beyond it."""
    walls = [_wall_ahead(floor, pose) for pose in _centred(macro, poses)]
    doors = floor.room.door_points
    shut = np.array([wall is not None and not any(_is_on(wall, door) for door in doors) for wall in walls])
    return np.asarray(3.0 * _clear_before(floor, macro, poses) / _VIEW + 2.0 * _wide_ahead(floor, macro, poses) + shut)


def _wide_ahead(floor: Floor, macro: Unit, poses: Floats) -> Floats:
    """Return how wide the wall straight ahead of an audience is, 1 where a screen has all the place that it needs."""
    walls = [_wall_ahead(floor, pose) for pose in _centred(macro, poses)]
    return np.array([min(wall.length, _SCREEN) / _SCREEN if wall is not None else 0.0 for wall in walls])


def _clear_before(floor: Floor, macro: Unit, poses: Floats) -> Floats:
    """Return the free floor before the foremost row at each pose, metres, up to what counts."""
    x0, x1, y0, y1 = macro.extent()
    centres = _centred(macro, poses)
    clear = front_clearance(centres, (x1 - x0) / 2, (y1 - y0) / 2, floor.room.edges, floor.boxes, _VIEW)
    return np.asarray(np.minimum(clear[:, 0], _VIEW))


def _centred(macro: Unit, poses: Floats) -> Floats:
    """Return the poses of a unit's middle."""
    x0, x1, y0, y1 = macro.extent()
    centres = poses.copy()
    centres[:, :2] += (x0 + x1) / 2 * poses[:, 2:] + (y0 + y1) / 2 * np.column_stack([-poses[:, 3], poses[:, 2]])
    return centres


def _wall_ahead(floor: Floor, pose: Floats) -> Wall | None:
    """Return the nearest wall that one looks at straight ahead."""
    here, front = pose[:2], np.array([-pose[3], pose[2]])
    found: list[tuple[float, int]] = []
    for number, wall in enumerate(floor.room.walls):
        distance, along = float((wall.start - here) @ front), float((here - wall.start) @ wall.along)
        if wall.inward @ front < -0.99 and distance > 0.0 and 0.0 <= along <= wall.length:
            found.append((distance, number))
    return floor.room.walls[min(found)[1]] if found else None


def _is_on(wall: Wall, point: Floats) -> bool:
    """Whether a door's middle is on a wall."""
    along = float((point - wall.start) @ wall.along)
    return abs(float((point - wall.start) @ wall.inward)) < 0.3 and 0.0 <= along <= wall.length


def _before_the_board(floor: Floor, spec: Spec, unit: Unit, poses: Floats) -> Floats:
    """Return a score that centres rows before the board that they face."""
    for copy in floor.placed:
        if floor.specs[copy.spec].role.focal and any(floor.specs[s].role.seat for s in unit.specs):
            aside = (poses[:, :2] - np.array(copy.box[:2])) @ np.array(copy.box[2:4])
            return np.asarray(-0.3 * np.minimum(np.abs(aside), 4.0))
    return np.zeros(len(poses))
