"""Sketch a storey whose hub is its main room: a living room, a sales floor, a restaurant; the other rooms line it."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import msgspec

from mansion_planner.program.bands import Segment, bring_together, front_order
from mansion_planner.program.blocks import LEAST_FRONT, Block, group_blocks, lay_block, least_sides
from mansion_planner.program.model import (
    DOOR_WALL,
    Box,
    CoreBox,
    Corridor,
    Massing,
    Placement,
    PlannedRoom,
    Sketch,
    Storey,
    far_stair,
    joined_pairs,
    short_edges,
)
from mansion_planner.program.plan_quality import strips
from mansion_planner.program.separation import keep_apart
from mansion_planner.program.widths import widened

__all__ = ["most_fronts", "sketch_hall"]

_LEAST_HUB = 2.4
"""Metres of the outline's length that stay for the hub and the north side."""

MOST_DIVIDED = 5
"""Rooms whose every division between the two sides is tried."""


@dataclass(frozen=True)
class _Arrangement:
    """Which blocks line the north side (by number, or as many as it takes), and how far the east column reaches.

    Attributes
    ----------
    north : tuple of int, optional
    under : bool
        The column ends below the north row, which takes the whole length.
    large_last : bool
        The largest block of the row lies above the column: what lies there is as wide as the column is.
    part : bool
        The row takes as much of the north side as its rooms need at a good depth, and the hub has the rest.
    """

    north: tuple[int, ...] | None = None
    under: bool = False
    large_last: bool = False
    part: bool = False


def sketch_hall(
    massing: Massing, storey: Storey, hub_id: str, pairs: list[tuple[str, str]], apart: Sequence[tuple[str, str]] = ()
) -> Sketch:
    """Line the north side of the hub with rooms, then its far side when the north is full.

    The band's depth follows from the rooms, so that the hub gets what they leave. Where a room would share too little
    wall with the hub, the other ways to divide the rooms between the two sides are tried.
    """
    best = _arranged(massing, storey, hub_id, pairs, apart, _Arrangement())
    short = len(short_edges(best)) + len(joined_pairs(best, apart))
    odd = _ill_shape(best) > _ODD if storey.use.family == "home" else bool(strips(best))
    if not (short or odd) or far_stair(massing):
        return best
    price = (short, _ill_shape(best) if odd else float("inf"))
    for arrangement in _others(len(storey.rooms), home=storey.use.family == "home"):
        sketch = _arranged(massing, storey, hub_id, pairs, apart, arrangement)
        found = (len(short_edges(sketch)) + len(joined_pairs(sketch, apart)), _ill_shape(sketch))
        if found < price:
            best, price = sketch, found
    return best


_ODD = 1.0
"""How far the rooms of a home may be from good proportions before other ways to place them are tried."""

_FRONT = 3.0
"""Metres of a hall's sides for each room that opens to it."""


def most_fronts(massing: Massing) -> int:
    """Return how many rooms well line a hall: along its north side beside the stair, and its far side."""
    return int((massing.length - _begin(massing) - far_stair(massing) + massing.depth) / _FRONT)


def _begin(massing: Massing) -> float:
    """Return where the north side is free from: beside the first stair."""
    near = [core.box for core in massing.cores if core.type == "stair" and core.box[0] < 0.5 * massing.length]
    return max((box[2] for box in near), default=0.0)


def _others(rooms: int, *, home: bool) -> list[_Arrangement]:
    """List ways to divide up to `MOST_DIVIDED` rooms: all of them; of more, those that cut their order in two.

    A few rooms of a home may take a part of the north side alone; those of another hall may all lie at its far side.
    """
    if rooms <= MOST_DIVIDED:
        # Bit n of `bits` says whether room n lines the north side; no room at all there is left out.
        groups = [tuple(n for n in range(rooms) if bits >> n & 1) for bits in range(1, 1 << rooms)]
    else:
        groups = [tuple(range(n)) for n in range(1, rooms + 1)]
        groups += [tuple(range(n, rooms)) for n in range(1, rooms)]
    forms = ((True, False), (True, True), (False, False))
    found = [_Arrangement(group, *form) for form in forms for group in groups]
    few = 0 < rooms <= _FEW
    return found + [_Arrangement(tuple(range(rooms)), part=True)] * (few and home) + [_Arrangement(())] * (not home)


_FEW = 3
"""Number of rooms that need not line the whole north side of a hall."""


def _ill_shape(sketch: Sketch) -> float:
    """Sum of how far the rooms and the hub are from a well-proportioned rectangle of at least 2.8 m."""
    total = 0.0
    for boxes in [p.boxes for p in sketch.rooms] + [c.boxes[:1] for c in sketch.corridors]:
        wide = max(b[2] for b in boxes) - min(b[0] for b in boxes)
        high = max(b[3] for b in boxes) - min(b[1] for b in boxes)
        if min(wide, high) <= 0.01:
            return float("inf")
        total += max(max(wide, high) / min(wide, high) - 1.4, 0.0)
        if wide * high > 8.0:
            total += max(2.8 - min(wide, high), 0.0)
    return total + sum(_misfit(placement) for placement in sketch.rooms)


_FITS = 1.3
"""Factor by which a room may be larger or smaller than planned and still fit."""


def _misfit(placement: Placement) -> float:
    """Return by how much the ratio of a room's area to the planned one, or its inverse, exceeds what fits."""
    planned, area = max(placement.room.area, 0.1), max(placement.area, 0.1)
    return max(planned / area, area / planned, _FITS) - _FITS


def _arranged(
    massing: Massing,
    storey: Storey,
    hub_id: str,
    pairs: list[tuple[str, str]],
    apart: Sequence[tuple[str, str]],
    arrangement: _Arrangement,
) -> Sketch:
    length = massing.length - storey.setback + storey.extension
    depth = massing.depth
    stairs = [core for core in massing.cores if core.type == "stair"]
    begin, far = _begin(massing), far_stair(massing)
    north, east, band = _divided(massing, front_order(storey.rooms), length, pairs, arrangement)
    row = [Segment("main", True, 0.0, 1.0, 0.0, band, blocks=tuple(north))]
    for first, second in pairs:
        row = bring_together(row, first, second)
    north = list(keep_apart(row, apart, pairs)[0].blocks)
    east = _for_column(east, sum(block.gross for block in east) / depth)
    area = sum(block.gross for block in east)
    under = arrangement.under and bool(east)
    if under and north:
        if arrangement.large_last:
            north.append(north.pop(max(range(len(north)), key=lambda n: north[n].gross)))
        north[-1] = msgspec.structs.replace(north[-1], least=area / (depth - band) + DOOR_WALL + 0.1)
    # Rooms that ask for more than there is are laid smaller, so that the hub and the north side keep their places.
    widest = max(length - begin - _LEAST_HUB, 1.0)
    column = min(area / depth, widest)
    end = length - far if far else length if under else length - column
    lined_area = sum(block.gross for block in north)
    if arrangement.part and lined_area < 0.7 * (end - begin) * band:
        end = begin + lined_area / band
    elif north and lined_area < 0.97 * (end - begin) * band:
        band = max(lined_area / (end - begin), 3.0 if stairs else 0.0)
    lined = Segment("main", True, begin, end, depth - band, band, blocks=tuple(north))
    reach = depth - band if under else depth
    column = min(area / reach, widest)
    placements = _in_row(lined, massing, hub_id) + _in_column(east, (length - column, reach, column), hub_id)
    boxes = _hub_boxes(massing, begin, length - column, band, lined=bool(north))
    boxes += [(end, depth - band, length, depth)] if arrangement.part and end < length - 0.01 else []
    hub = Corridor(hub_id, boxes)
    return Sketch([hub], placements, {core.id: hub_id for core in massing.cores})


_LEAST_BAND = 3.0
"""Least depth of the rooms between two stairs, metres."""


def _divided(
    massing: Massing,
    rooms: Sequence[PlannedRoom],
    length: float,
    pairs: list[tuple[str, str]],
    arrangement: _Arrangement,
) -> tuple[list[Block], list[Block], float]:
    """Return the blocks of the north and of the far side of a hall, and the depth of the north side, metres.

    With a stair at either end of the north side all rooms lie between the two.
    """
    depth, begin, far = massing.depth, _begin(massing), far_stair(massing)
    stairs = [core for core in massing.cores if core.type == "stair"]
    if far:
        band = sum(room.gross for room in rooms) / max(length - far - begin, _LEAST_BAND)
        band = min(max(band, _LEAST_BAND), 0.6 * depth)
        return group_blocks(rooms, band, pairs), [], band
    if arrangement.north is None:
        total = sum(room.gross for room in rooms)
        band = _band_depth(total, length - begin, depth, [room.gross for room in rooms], stairs)
        return *_split(group_blocks(rooms, band, pairs), band, length - begin), band
    chosen = [rooms[n] for n in arrangement.north]
    rest = [room for n, room in enumerate(rooms) if n not in arrangement.north]
    band = sum(room.gross for room in chosen) / (length - begin)
    band = max(band, math.sqrt(max(room.gross for room in chosen))) if arrangement.part else band
    band = min(max(band, 3.0 if stairs else 2.4), 0.6 * depth)
    slim = any(room.area / band < 1.5 for room in chosen)
    north = group_blocks(chosen, band, pairs) if slim else [Block(room) for room in chosen]
    return north, [Block(room) for room in rest], band


def _for_column(east: list[Block], column: float) -> list[Block]:
    """Return the blocks of the far side, split where their small rooms would be too narrow in the column."""
    found: list[Block] = []
    for block in east:
        deep = max((least_sides(room)[1] for room in block.smalls), default=0.0)
        apart = _apart(block, column) if column - deep >= LEAST_FRONT else [Block(room) for room in block.fronts()]
        found += [_turned(each, column) if not each.smalls else each for each in apart]
    return found


_LONG = 2.4
"""Greatest ratio of long to short side of a small room that lies in a column by itself."""


def _apart(block: Block, column: float) -> list[Block]:
    """Return a block of the far side and, before it, those of its small rooms that are well shaped by themselves."""
    alone = [room for room in block.smalls if room.area * _LONG >= column**2 and room.area >= DOOR_WALL * column]
    if not alone:
        return [block]
    kept = tuple(room for room in block.smalls if not any(room is other for other in alone))
    return [*map(Block, alone), msgspec.structs.replace(block, smalls=kept)]


def _turned(block: Block, column: float) -> Block:
    """Return a block of one room, which lies along the column where that is narrower than the room is to be long."""
    front, depth = least_sides(block.host)
    return msgspec.structs.replace(block, least=depth) if front <= column < depth else block


def _in_column(east: list[Block], place: tuple[float, float, float], hub_id: str) -> list[Placement]:
    """Stack blocks from the south along the hub's far side; `place` is where it begins, its reach and its width."""
    x0, reach, column = place
    high = sum(block.gross for block in east) or 1.0
    rises = widened([reach * block.gross / high for block in east], [block.least_width for block in east])
    placements: list[Placement] = []
    y = 0.0
    for block, rise in zip(east, rises):
        for room, boxes in lay_block(block, rise, column):
            world: list[Box] = [(x0 + b[1], y + b[0], x0 + b[3], y + b[2]) for b in boxes]
            placements.append(Placement(room, world, _parent(block, room, hub_id)))
        y += rise
    return placements


def _hub_boxes(massing: Massing, begin: float, end: float, band: float, *, lined: bool) -> list[Box]:
    """Return what the rooms leave to the hub, around the cores."""
    depth, far = massing.depth, far_stair(massing)
    stairs = [core.box for core in massing.cores if core.type == "stair"]
    lifts = [core.box for core in massing.cores if core.type == "elevator"]
    floor, top = min((box[1] for box in stairs), default=depth), depth - band
    boxes: list[Box] = [(0.0, 0.0, end, top if lined or stairs else depth)]
    if stairs and floor > top:
        boxes.append((0.0, top, begin, floor))
        boxes += [(end - far, top, end, floor)] if far else []
    elif stairs and floor < top:
        boxes = [(0.0, 0.0, end, floor), (begin, floor, end - far, top)]
    if lifts:
        edge, top = max(box[2] for box in lifts), max(box[3] for box in lifts)
        x0, _, x1, y1 = boxes[0]
        boxes[:1] = [(x0, top, x1, y1), (edge, 0.0, x1, top)]
    return boxes


def _parent(block: Block, room: PlannedRoom, hub_id: str) -> str:
    if any(room is front for front in block.fronts()):
        return hub_id
    return next((p.id for p in block.host.each() if any(c is room for c in p.suite)), hub_id)


def _band_depth(total: float, length: float, depth: float, areas: list[float], stairs: list[CoreBox]) -> float:
    usual = (sum(areas) / len(areas)) ** 0.5 if areas else 3.0
    band = max(total / length, 0.85 * usual, 2.6)
    if stairs:
        band = max(band, 3.0)
    return min(band, 0.5 * depth)


def _split(blocks: list[Block], band: float, length: float) -> tuple[list[Block], list[Block]]:
    """Fill the north side up to its length; what is left over goes to the far side."""
    if sum(block.gross for block in blocks) / band <= length * 1.02:
        return blocks, []
    north: list[Block] = []
    east: list[Block] = []
    used = 0.0
    ordered = sorted(blocks, key=lambda block: block.gross)
    for block in ordered:
        if used + block.gross / band <= length * 0.86:
            north.append(block)
            used += block.gross / band
        else:
            east.append(block)
    return north, east


def _in_row(segment: Segment, massing: Massing, hub_id: str) -> list[Placement]:
    """Return the places of a segment's rooms."""
    return [
        Placement(room, [segment.world(box, x0, massing) for box in boxes], _parent(block, room, hub_id))
        for block, x0, x1 in segment.laid()
        for room, boxes in lay_block(block, x1 - x0, segment.depth)
    ]
