"""Sketch a storey whose hub is its main room: a living room, a sales floor, a restaurant; the other rooms line it."""

from mansion_planner.program.blocks import Block, group_blocks, lay_block
from mansion_planner.program.model import Box, CoreBox, Massing, Storey
from mansion_planner.program.placement import Corridor, Placement, Sketch
from mansion_planner.program.segments import Segment, bring_together, front_order

__all__ = ["sketch_hall"]


def sketch_hall(
    massing: Massing, storey: Storey, hub_id: str, pairs: list[tuple[str, str]]
) -> Sketch:
    """Line the north side of the hub with rooms, then its far side when the north is full.

    The band's depth follows from the rooms, so that the hub gets what they leave.
    """
    length = massing.length - storey.setback + storey.extension
    depth = massing.depth
    stairs = [core for core in massing.cores if core.type == "stair"]
    lifts = [core for core in massing.cores if core.type == "elevator"]
    begin = max((core.box[2] for core in stairs), default=0.0)
    rooms = front_order(storey.rooms)
    total = sum(room.gross for room in rooms)
    band = _band_depth(total, length - begin, depth, [room.gross for room in rooms], stairs)
    blocks = group_blocks(rooms, band, pairs)
    north, east = _split(blocks, band, length - begin)
    for first, second in pairs:
        bring_together([Segment("main", True, 0.0, 1.0, 0.0, band, blocks=north)], first, second)
    column = sum(block.gross for block in east) / depth
    placements: list[Placement] = []
    segment = Segment("main", True, begin, length - column, depth - band, band, blocks=north)
    _place(segment, massing, hub_id, placements)
    if north and sum(block.gross for block in north) < 0.97 * segment.length * band:
        band = sum(block.gross for block in north) / segment.length
        placements.clear()
        segment = Segment("main", True, begin, length - column, depth - band, band, blocks=north)
        _place(segment, massing, hub_id, placements)
    y = 0.0
    high = sum(block.gross for block in east) or 1.0
    for block in east:
        rise = depth * block.gross / high
        for room, boxes in lay_block(block, rise, column):
            parent = (
                hub_id
                if room is block.host or any(room is s for s in block.smalls)
                else block.host.id
            )
            world: list[Box] = [
                (length - column + b[1], y + b[0], length - column + b[3], y + b[2]) for b in boxes
            ]
            placements.append(Placement(room, world, parent))
        y += rise
    hub_boxes: list[Box] = [(0.0, 0.0, length - column, depth - band)]
    floor = min((core.box[1] for core in stairs), default=depth)
    if stairs and floor > depth - band:
        hub_boxes.append((0.0, depth - band, begin, floor))
    if not north:
        hub_boxes[0] = (0.0, 0.0, length - column, depth - band if stairs else depth)
    if lifts:
        edge, top = max(core.box[2] for core in lifts), max(core.box[3] for core in lifts)
        x0, _, x1, y1 = hub_boxes[0]
        hub_boxes[:1] = [(x0, top, x1, y1), (edge, 0.0, x1, top)]
    hub = Corridor(hub_id, hub_boxes)
    sketch = Sketch([hub], placements)
    sketch.core_parent = {core.id: hub_id for core in (*stairs, *lifts)}
    return sketch


def _band_depth(
    total: float, length: float, depth: float, areas: list[float], stairs: list[CoreBox]
) -> float:
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


def _place(segment: Segment, massing: Massing, hub_id: str, placements: list[Placement]) -> None:
    for block, x0, x1 in segment.laid():
        for room, boxes in lay_block(block, x1 - x0, segment.depth):
            fronts = [block.host, *block.smalls]
            parent = hub_id if any(room is front for front in fronts) else block.host.id
            placements.append(
                Placement(room, [segment.world(box, x0, massing) for box in boxes], parent)
            )
