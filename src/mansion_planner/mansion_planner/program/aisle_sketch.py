"""Plan a storey that is too deep for one corridor: parallel corridors, joined by one across at the lifts.

Rooms line both sides of each parallel corridor. Those that want a window go to the two bands along the outer walls, and
large ones take the depth of both bands between two corridors.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from mansion_planner.program.bands import Segment, fill_segments, front_order, with_rows
from mansion_planner.program.blocks import Block, group_blocks, lay_block, passage_of
from mansion_planner.program.massing import MassingWish, corridor_width
from mansion_planner.program.model import (
    LIFT,
    Aisles,
    Box,
    CoreBox,
    CoreWish,
    Corridor,
    Massing,
    Placement,
    PlannedRoom,
    Sketch,
    Storey,
    box_area,
    joined_pairs,
    short_edges,
)
from mansion_planner.program.plan_quality import aspect, carved, dark_rooms, strips
from mansion_planner.program.separation import keep_apart

__all__ = ["aisle_capacity", "aisle_massings", "plan_price", "sketch_aisles"]

_LEAST_OUTER, _LEAST_INNER, _DEEPEST = 4.0, 3.0, 16.0
"""Bounds of the depth of a band, metres."""

_RATIOS = (1.0, 1.3, 1.7)
"""Depths of the outer bands that are tried, as multiples of the inner ones."""

_MOST_AISLES = 5

_THROUGH = (3.0, 1.6, 0.0)
"""Areas from which a room takes the depth of two bands, in squares of a band's depth; all are tried."""

_LEAST_REST = 4.0
"""Least length of the two bands beside rooms that take the depth of both, metres."""


def aisle_massings(wish: MassingWish, length: float, depth: float) -> list[Massing]:
    """Return the massings of a rectangle with two corridors or more, the ones nearest to the typical room first."""
    found = [
        massing
        for count in range(2, _MOST_AISLES + 1)
        for ratio in _RATIOS
        if (massing := _massing(wish, length, depth, count, ratio)) is not None
    ]
    usual = math.sqrt(1.2 * wish.room)
    return sorted(found, key=lambda massing: abs(_mean_depth(massing) - usual))[:6]


def _mean_depth(massing: Massing) -> float:
    aisles = _aisles(massing)
    return (2 * aisles.outer + (2 * len(aisles.lines) - 2) * aisles.inner) / (2 * len(aisles.lines))


def _aisles(massing: Massing) -> Aisles:
    assert massing.aisles is not None
    return massing.aisles


def _massing(wish: MassingWish, length: float, depth: float, count: int, ratio: float) -> Massing | None:
    """Return the massing with `count` corridors; none where its bands have no sane depth."""
    width = corridor_width(wish.use, wish.area)
    inner = (depth - count * width) / (2 * ratio + 2 * count - 2)
    outer = ratio * inner
    if not (inner >= _LEAST_INNER and _LEAST_OUTER <= outer <= _DEEPEST):
        return None
    stair = wish.cores.stair if wish.cores.stair[1] <= outer else wish.cores.stair[::-1]
    if wish.cores.stairs and stair[1] > outer:
        return None
    lines = tuple((outer + j * (2 * inner + width), outer + j * (2 * inner + width) + width) for j in range(count))
    # Cores stand on whole metres.
    edge = float(round(length / 2 + width / 2))
    cross = (edge - width, edge)
    middle = count // 2 - 1
    low, high = lines[middle][1], lines[middle + 1][0]
    if 2 * inner < LIFT * wish.cores.lifts:
        return None
    lobby: Box | None = (edge, low, edge + LIFT, high) if wish.cores.lifts else None
    return Massing(
        length=length, north=outer, corridor=width, south=depth - outer - width,
        cores=_cores(wish.cores, stair, length, depth, lobby),
        aisles=Aisles(lines, cross, lobby, outer, inner),
    )  # fmt: skip


def _cores(
    wish: CoreWish, stair: tuple[int, int], length: float, depth: float, lobby: Box | None
) -> tuple[CoreBox, ...]:
    """Place the stairs in opposite corners and the lifts beside the corridor across."""
    wide, high = stair
    corners: list[CoreBox] = [
        CoreBox("stair_1", "stair", (0.0, depth - high, float(wide), depth), "south"),
        CoreBox("stair_2", "stair", (length - wide, 0.0, length, float(high)), "north"),
    ]
    cores = corners[: wish.stairs]
    if lobby is not None:
        x0, low, x1, high_end = lobby
        y0 = float(math.ceil((low + high_end - LIFT * wish.lifts) / 2 - 0.5))
        y0 = min(max(y0, float(math.ceil(low))), float(math.floor(high_end)) - LIFT * wish.lifts)
        for number in range(wish.lifts):
            box = (x0, y0 + LIFT * number, x1, y0 + LIFT * (number + 1))
            cores.append(CoreBox(f"elevator_{number + 1}", "elevator", box, "west"))
    return tuple(cores)


def _stair_width(massing: Massing, number: int) -> float:
    """Return the length of outer band that a stair takes, metres; 0 where there is none of that number."""
    return next((c.box[2] - c.box[0] for c in massing.cores if c.id == f"stair_{number}"), 0.0)


def aisle_capacity(massing: Massing) -> float:
    """Return the area that rooms can take on a storey, square metres."""
    return sum(s.length * s.depth for s in _half_bands(massing, massing.length)) + sum(
        (cell.x1 - cell.x0) * 2 * _aisles(massing).inner for cell in _cells(massing, massing.length)
    )


@dataclass(frozen=True)
class _Cell:
    """The floor between two parallel corridors on one side of the corridor across; `line` is the lower one."""

    line: int
    east: bool
    x0: float
    x1: float


def _cells(massing: Massing, stop: float) -> list[_Cell]:
    aisles = _aisles(massing)
    found = []
    for line in range(len(aisles.lines) - 1):
        before = aisles.lobby is not None and abs(aisles.lobby[1] - aisles.lines[line][1]) < 0.01
        begin = aisles.lobby[2] if aisles.lobby is not None and before else aisles.cross[1]
        found += [_Cell(line, False, 0.0, aisles.cross[0]), _Cell(line, True, begin, stop)]
    return found


def _half_bands(massing: Massing, stop: float) -> list[Segment]:
    """Return the stretches of the two outer bands."""
    aisles = _aisles(massing)
    last, depth = len(aisles.lines) - 1, aisles.outer
    top, low = aisles.lines[last][1], aisles.lines[0][0]
    ends = (aisles.cross[0], stop)
    return [
        Segment(_corridor_name(last, east=False), True, _stair_width(massing, 1), ends[0], top, depth),
        Segment(_corridor_name(last, east=True), True, aisles.cross[1], ends[1], top, depth),
        Segment(_corridor_name(0, east=False), False, 0.0, ends[0], low, depth),
        Segment(_corridor_name(0, east=True), False, aisles.cross[1], ends[1] - _stair_width(massing, 2), low, depth),
    ]


def _corridor_name(line: int, *, east: bool) -> str:
    return f"corridor_{2 * line + 1 + east}"


def sketch_aisles(
    massing: Massing, storey: Storey, hub_id: str, pairs: list[tuple[str, str]], apart: Sequence[tuple[str, str]] = ()
) -> Sketch:
    """Lay out the rooms of a storey along its parallel corridors, in the best of the ways to place the large ones."""
    sketches = [_sketch(massing, storey, hub_id, pairs, apart, through) for through in _THROUGH]
    return min(sketches, key=lambda s: (len(short_edges(s)) + len(joined_pairs(s, apart)), plan_price(s, massing)))


def plan_price(sketch: Sketch, massing: Massing) -> float:
    """Return what is wrong with the rooms of a sketch: strips, carved halls, rooms without their window, long ones."""
    stretched = sum(max(aspect(p.boxes) - 2.0, 0.0) for p in sketch.rooms if p.boxes)
    empty = sum(len(c.boxes) > 1 and max(aspect([b]) < 8.0 for b in c.boxes[1:]) for c in sketch.corridors[1:])
    ill = 3.0 * len(strips(sketch)) + 8.0 * len(carved(sketch))
    return ill + 1.0 * len(dark_rooms(sketch, massing)) + 0.3 * stretched + 2.0 * empty


def _sketch(
    massing: Massing,
    storey: Storey,
    hub_id: str,
    pairs: list[tuple[str, str]],
    apart: Sequence[tuple[str, str]],
    through: float,
) -> Sketch:
    """Lay out the rooms, those of `through` squares of a band's depth or more over two bands."""
    aisles = _aisles(massing)
    end, rest = _end_room(massing, storey.rooms)
    stop = massing.length - (end.gross / massing.depth if end else 0.0)
    band = max(aisles.outer, aisles.inner)
    blocks = group_blocks(front_order(rest), band, pairs, passages=True)
    large = [block for block in blocks if block.gross > through * band**2] if through else []
    halls, placed = _halls(massing, stop, large)
    open_segments = [*_half_bands(massing, stop), *_inner_bands(massing, stop, halls, whole=not through)]
    others = [block for block in blocks if not any(block is other for other in placed)]
    filled = keep_apart(fill_segments(open_segments, others, pairs), apart, pairs)
    segments = _from_the_core([*filled, *halls.values()], massing)
    return _assembled(massing, hub_id, segments, end, stop)


def _end_room(massing: Massing, rooms: Sequence[PlannedRoom]) -> tuple[PlannedRoom | None, list[PlannedRoom]]:
    """Return the room that closes the storey over its whole depth, one too large for two bands, and the others."""
    limit = 3.0 * (2 * _aisles(massing).inner) ** 2
    large = [
        room
        for room in rooms
        if not room.suite and room.area > limit and room.area / massing.depth < 0.4 * massing.length
    ]
    if not large or len(rooms) < 2 or _stair_width(massing, 2):
        return None, list(rooms)
    end = max(large, key=lambda room: (room.area, room.id))
    return end, [room for room in rooms if room is not end]


def _halls(massing: Massing, stop: float, large: Sequence[Block]) -> tuple[dict[_Cell, Segment], list[Block]]:
    """Return, by cell, the stretch that rooms of two bands' depth take, outer wall first, and those rooms."""
    aisles = _aisles(massing)
    depth = 2 * aisles.inner
    given: dict[_Cell, list[Block]] = {cell: [] for cell in _cells(massing, stop)}
    placed: list[Block] = []

    def left(cell: _Cell) -> float:
        return cell.x1 - cell.x0 - sum(block.gross for block in given[cell]) / depth

    for block in sorted(large, key=lambda block: -block.gross):
        cell = max(given, key=lambda cell: (left(cell), -cell.line, cell.east))
        if block.gross / depth <= left(cell) * 1.05:
            given[cell].append(block)
            placed.append(block)
    halls = {}
    for cell, blocks in given.items():
        if blocks:
            rest = left(cell) if left(cell) >= _LEAST_REST else 0.0
            begin, end = (cell.x0 + rest, cell.x1) if cell.east else (cell.x0, cell.x1 - rest)
            halls[cell] = _with_blocks(_through(aisles, cell, begin, end), blocks)
    return halls, placed


def _with_blocks(segment: Segment, blocks: Sequence[Block]) -> Segment:
    """Return a segment with other blocks."""
    return with_rows([segment], [blocks])[0]


def _through(aisles: Aisles, cell: _Cell, begin: float, end: float) -> Segment:
    name = _corridor_name(cell.line, east=cell.east)
    return Segment(name, True, begin, end, aisles.lines[cell.line][1], 2 * aisles.inner, dark=True)


def _inner_bands(massing: Massing, stop: float, halls: dict[_Cell, Segment], *, whole: bool) -> Iterator[Segment]:
    """Yield the stretches of the bands between corridors that `halls` leave: two of each cell, or one of its depth."""
    aisles = _aisles(massing)
    for cell in _cells(massing, stop):
        hall = halls.get(cell)
        begin, end = cell.x0, cell.x1
        if hall is not None:
            begin, end = (begin, hall.begin) if cell.east else (hall.end, end)
        if end - begin < 0.5:
            continue
        if whole:
            yield _through(aisles, cell, begin, end)
            continue
        lower, upper = cell.line, cell.line + 1
        name, above = _corridor_name(lower, east=cell.east), _corridor_name(upper, east=cell.east)
        yield Segment(name, True, begin, end, aisles.lines[lower][1], aisles.inner, dark=True)
        yield Segment(above, False, begin, end, aisles.lines[upper][0], aisles.inner, dark=True)


def _from_the_core(segments: Sequence[Segment], massing: Massing) -> list[Segment]:
    """Return the segments with their rooms from the corridor across outwards, in dark ones a room for the outer wall.

    Blocks come in the order from the cores outwards.
    """
    rows = []
    for segment in segments:
        blocks = list(segment.blocks)
        ends_outside = segment.begin < 0.01 or segment.end > massing.length - 0.01
        light = [block for block in blocks if block.wants_light]
        if segment.dark and ends_outside and light and not blocks[-1].wants_light:
            blocks.remove(light[-1])
            blocks.append(light[-1])
        west = segment.end < massing.length / 2
        rows.append(blocks[::-1] if west else blocks)
    return with_rows(segments, rows)


def _assembled(
    massing: Massing, hub_id: str, segments: Sequence[Segment], end: PlannedRoom | None, stop: float
) -> Sketch:
    """Return the sketch of filled segments, with the room that closes the storey."""
    corridors = _corridors(massing, hub_id, stop)
    rooms: list[Placement] = []
    bearing: dict[float, list[tuple[float, float]]] = {}
    for segment in segments:
        if not segment.blocks:
            owner = next(k for k, corridor in enumerate(corridors) if corridor.id == segment.bar)
            box = segment.world((0.0, 0.0, segment.length, segment.depth), segment.begin, massing)
            corridors[owner] = replace(corridors[owner], boxes=[*corridors[owner].boxes, box])
            continue
        begin = segment.begin
        for block, x0, x1 in segment.laid():
            passage = passage_of(block, x1 - x0, segment.depth)
            if passage:
                owner = next(k for k, corridor in enumerate(corridors) if corridor.id == segment.bar)
                box = segment.world(passage, x0, massing)
                corridors[owner] = replace(corridors[owner], boxes=[*corridors[owner].boxes, box])
                bearing.setdefault(segment.front, []).append((begin, x0 + passage[0]))
                begin = x0 + passage[2]
            for room, boxes in lay_block(block, x1 - x0, segment.depth):
                world = [segment.world(box, x0, massing) for box in boxes]
                parent = next((p.id for p in block.host.each() if any(c is room for c in p.suite)), segment.bar)
                rooms.append(Placement(room, world, parent))
        bearing.setdefault(segment.front, []).append((begin, segment.end))
    if end is not None:
        middle = _corridor_name(len(_aisles(massing).lines) // 2 - 1, east=True)
        rooms.append(Placement(end, [(stop, 0.0, massing.length, massing.depth)], middle))
    return Sketch(corridors, rooms, _core_parents(massing, hub_id), bearing=bearing)


def _core_parents(massing: Massing, hub_id: str) -> dict[str, str]:
    last = len(_aisles(massing).lines) - 1
    stairs = {"stair_1": _corridor_name(last, east=False), "stair_2": _corridor_name(0, east=True)}
    return {core.id: stairs.get(core.id, hub_id) for core in massing.cores}


def _corridors(massing: Massing, hub_id: str, stop: float) -> list[Corridor]:
    """Return the corridor across, which is the hub, and both halves of each parallel one."""
    aisles = _aisles(massing)
    hub = Corridor(hub_id, [(aisles.cross[0], 0.0, aisles.cross[1], massing.depth)])
    if aisles.lobby is not None:
        x0, low, x1, high = aisles.lobby
        lifts = [core.box for core in massing.cores if core.type == "elevator"]
        bottom, top = min(box[1] for box in lifts), max(box[3] for box in lifts)
        hub.boxes.extend(box for box in ((x0, low, x1, bottom), (x0, top, x1, high)) if box_area(box) > 0.01)
    corridors = [hub]
    for line, (low, high) in enumerate(aisles.lines):
        west: list[Box] = [(0.0, low, aisles.cross[0], high)]
        east: list[Box] = [(aisles.cross[1], low, stop, high)]
        if line == len(aisles.lines) - 1:
            west += [b for b in _before_stair(massing, "stair_1", high) if box_area(b) > 0.01]
        if line == 0:
            east += [b for b in _before_stair(massing, "stair_2", low) if box_area(b) > 0.01]
        corridors.append(Corridor(_corridor_name(line, east=False), west, hub_id))
        corridors.append(Corridor(_corridor_name(line, east=True), east, hub_id))
    return corridors


def _before_stair(massing: Massing, name: str, edge: float) -> list[Box]:
    """Return the floor between a stair and the edge of its corridor."""
    stairs = [core.box for core in massing.cores if core.id == name]
    return [(x0, edge, x1, y0) if edge <= y0 else (x0, y1, x1, edge) for x0, y0, x1, y1 in stairs]
