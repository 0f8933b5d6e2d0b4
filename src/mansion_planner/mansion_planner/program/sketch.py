"""Sketch a storey: corridors, and a place for every room, from which areas, room graph and seeds follow.

The sketch is a witness: a partition in which every access edge has its shared wall, so that the floor solver is asked
for nothing impossible. The solver is free to find a better one.
"""

from mansion_planner.program.blocks import group_blocks, lay_block
from mansion_planner.program.corridors import (
    assign_parents,
    bearing_lines,
    close_corridor,
    connect_cores,
    corridors_of,
    fill_pocket,
    give_empty,
)
from mansion_planner.program.model import Massing, PlannedRoom, Storey
from mansion_planner.program.placement import Placement, Sketch, far_stair, lobby_length, pocket
from mansion_planner.program.segments import Segment, fill_segments, front_order

__all__ = ["capacity", "sketch_storey"]


def _extent(massing: Massing, storey: Storey) -> float:
    return massing.length - storey.setback + storey.extension


def capacity(massing: Massing, storey: Storey) -> float:
    """Return the area that rooms can take on a storey, square metres."""
    length = _extent(massing, storey)
    total = length * massing.depth - length * massing.corridor
    for wing in massing.wings:
        total += (wing.x1 - wing.x0 - massing.corridor) * wing.reach
        band = massing.north if wing.north else massing.south
        total -= massing.corridor * band
    if massing.court:
        total += (massing.court - massing.corridor) * massing.far_length
        total -= massing.corridor * massing.far_band * len(massing.wings)
    total -= lobby_length(massing, storey) * massing.south
    total -= pocket(massing) * massing.north + far_stair(massing) * massing.north
    if massing.hall:
        hub = length * massing.corridor
        return total + hub
    return total


def sketch_storey(massing: Massing, storey: Storey, hub_id: str, pairs: list[tuple[str, str]]) -> Sketch:
    """Lay out the rooms of a storey along its corridors.

    Parameters
    ----------
    massing : Massing
    storey : Storey
        With rooms whose areas add up to about the storey's capacity.
    hub_id : str
    pairs : list of (str, str)
        Room types to be side by side.
    """
    length = _extent(massing, storey)
    ends, rest = _end_rooms(massing, storey.rooms, length)
    stop = length - sum(room.gross / massing.depth for room in ends)
    segments = _segments(massing, stop, lobby_length(massing, storey))
    depth = max(segment.depth for segment in segments)
    blocks = group_blocks(front_order(rest), depth, pairs)
    fill_segments(segments, blocks, pairs)
    return _assemble(massing, storey, hub_id, segments, ends, stop, length)


def _end_rooms(
    massing: Massing, rooms: list[PlannedRoom], length: float
) -> tuple[list[PlannedRoom], list[PlannedRoom]]:
    """Choose the room that closes the bar over its whole depth: one too large for a band."""
    if massing.wings or far_stair(massing):
        return [], rooms
    deep = max(massing.north, massing.south)
    large = [r for r in rooms if not r.suite and r.area > 2.4 * deep * deep and r.area > 90]
    large = [r for r in large if r.area / massing.depth < 0.55 * length]
    if not large or len(rooms) < 2:
        return [], rooms
    end = max(large, key=lambda room: (room.area, room.id))
    return [end], [room for room in rooms if room is not end]


def _segments(massing: Massing, stop: float, lobby: float) -> list[Segment]:
    """List the stretches of band along corridors, nearest to the stair first."""
    south, north = massing.south, massing.north
    upper = massing.south + massing.corridor
    segments: list[Segment] = []
    for is_north, begin in ((True, pocket(massing)), (False, lobby)):
        front, depth = (upper, north) if is_north else (south, south)
        end = stop - (far_stair(massing) if is_north else 0.0)
        x = begin
        for wing in sorted(massing.wings, key=lambda w: w.x0):
            if wing.north is is_north:
                if wing.x0 - x > 0.5:
                    segments.append(Segment("main", is_north, x, wing.x0, front, depth))
                x = wing.x1
        if end - x > 0.5:
            segments.append(Segment("main", is_north, x, end, front, depth))
    for number, wing in enumerate(massing.wings, 1):
        side = (wing.x1 - wing.x0 - massing.corridor) / 2
        band = north if wing.north else south
        run = wing.reach + band + (massing.far_band if massing.court else 0.0)
        name = f"wing_{number}"
        segments.append(Segment(name, False, 0.0, run, wing.x0 + side, side, wing=wing))
        segments.append(Segment(name, True, 0.0, run, wing.x1 - side, side, wing=wing))
    if massing.court:
        segments += _far_segments(massing)
    return [segment for segment in segments if segment.depth > 0.5]


def _far_segments(massing: Massing) -> list[Segment]:
    """List the stretches of band of the bar that closes a courtyard or an H."""
    top = -massing.wings[0].reach
    band, (begin, end) = massing.far_band, massing.far
    low, high = top - band - massing.corridor, top - band
    segments = [Segment("far", False, begin, end, low, band)]
    x = begin
    for wing in massing.wings:
        if wing.x0 - x > 0.5:
            segments.append(Segment("far", True, x, wing.x0, high, band))
        x = wing.x1
    if end - x > 0.5:
        segments.append(Segment("far", True, x, end, high, band))
    return segments


def _assemble(
    massing: Massing,
    storey: Storey,
    hub_id: str,
    segments: list[Segment],
    ends: list[PlannedRoom],
    stop: float,
    length: float,
) -> Sketch:
    fronts: list[tuple[str, PlannedRoom, float, float]] = []
    rooms: list[Placement] = []
    for segment in segments:
        for block, x0, x1 in segment.laid():
            for room, boxes in lay_block(block, x1 - x0, segment.depth):
                world = [segment.world(box, x0, massing) for box in boxes]
                parent = next((p.id for p in block.host.each() if any(c is room for c in p.suite)), "")
                rooms.append(Placement(room, world, parent))
                if not parent:
                    span = [box for box in boxes if box[1] < 0.01]
                    fronts.append((segment.bar, room, x0 + min(b[0] for b in span), x0 + max(b[2] for b in span)))
    x = stop
    for room in ends:
        wide = (length - stop) * room.gross / sum(end.gross for end in ends)
        rooms.append(Placement(room, [(x, 0.0, x + wide, massing.depth)], "@end"))
        x += wide
    lobby = lobby_length(massing, storey)
    fill_pocket(massing, rooms)
    corridors = corridors_of(massing, hub_id, fronts, stop, bool(ends), lobby)
    sketch = Sketch(corridors, rooms)
    assign_parents(sketch, fronts)
    close_corridor(massing, sketch, segments, stop, bool(ends))
    give_empty(massing, sketch, segments)
    connect_cores(massing, sketch)
    sketch.bearing = bearing_lines(massing, sketch, lobby, stop)
    return sketch
