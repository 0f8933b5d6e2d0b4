"""Sketch a storey with corridors: where they run, which rooms they serve, and the place of each room."""

import itertools
from collections.abc import Sequence
from dataclasses import replace

import msgspec

from mansion_knowledge.norms import load_norms
from mansion_planner.program.bands import (
    Segment,
    bring_to_end,
    fill_segments,
    front_order,
    rooms_at_door,
    with_central,
    with_door_first,
    with_rows,
)
from mansion_planner.program.blocks import DOOR, group_blocks, lay_block, of_full_depth, passage_of
from mansion_planner.program.end_rooms import boxes_at_end, corner_of, end_rooms
from mansion_planner.program.home_orders import best_sketch, home_price
from mansion_planner.program.model import (
    Box,
    Corridor,
    Massing,
    Placement,
    PlannedRoom,
    Sketch,
    Storey,
    behind_lifts,
    box_area,
    far_stair,
    lobby_length,
    pocket,
)
from mansion_planner.program.plan_quality import fill
from mansion_planner.program.separation import keep_apart
from mansion_planner.program.side_passages import SidePassage, with_passages

__all__ = ["capacity", "sketch_storey"]


HUB_CHILDREN = 8
"""Rooms that a corridor serves before it is divided."""

_Front = tuple[str, PlannedRoom, float, float]
"""A room at a corridor: its bar, the room, and where its front, or the passage that it lies at, begins and ends."""

_AT_END = "@end"
"""Stands for the last piece of the main corridor until the corridors are known."""


def sketch_storey(
    massing: Massing, storey: Storey, hub_id: str, pairs: list[tuple[str, str]], apart: Sequence[tuple[str, str]] = ()
) -> Sketch:
    """Lay out the rooms of a storey along its corridors.

    Parameters
    ----------
    massing : Massing
    storey : Storey
        With rooms whose areas add up to about the storey's capacity.
    hub_id : str
    pairs : list of (str, str)
        Room types to be side by side.
    apart : sequence of (str, str)
        Those that must not share a wall.
    """
    length = _extent(massing, storey)
    at_door = rooms_at_door(storey, pairs)
    pairs = [pair[::-1] if pair[0] in at_door and pair[1] not in at_door else pair for pair in pairs]
    ends, rest = end_rooms(massing, storey, length)
    stop = length - (sum(room.gross for room in ends) + box_area(corner_of(massing)) * bool(ends)) / massing.depth
    stop = massing.length if storey.hall_wing else stop
    if _is_one_room(massing, storey):
        ends, rest = list(storey.rooms), []
        stop = max(pocket(massing), lobby_length(massing, storey)) + _LANDING
    segments = _segments(massing, stop, lobby_length(massing, storey))
    segments = _with_floor_behind_lifts(massing, storey, segments)
    depth = max(segment.depth for segment in segments)
    rest = of_full_depth(front_order(rest, at_door), ends, depth, pairs)
    blocks = group_blocks(rest, depth, pairs, passages=storey.use.family != "home")
    filled = bring_to_end(fill_segments(segments, blocks, pairs), stop, ends, pairs)
    filled = keep_apart(filled, apart, pairs)
    filled = with_central(_room_beside_lifts(filled if ends else with_door_first(filled, at_door)))
    if storey.use.family != "home":
        return _assemble(massing, storey, hub_id, filled, ends, stop, length)
    return best_sketch(
        filled,
        lambda order: _assemble(massing, storey, hub_id, order, ends, stop, length),
        lambda sketch: home_price(sketch, pairs, apart),
    )


_LANDING = 1.6
"""Metres of corridor beside the stair, where a single room takes the rest of a storey."""


def _is_one_room(massing: Massing, storey: Storey) -> bool:
    """Whether a storey is a single room of free area, beside the stair or at the end of a short corridor."""
    free = len(storey.rooms) == 1 and not storey.rooms[0].fixed and not storey.rooms[0].suite
    return free and bool(massing.cores) and not massing.wings and not far_stair(massing)


def _is_main(corridor: Corridor) -> bool:
    return not corridor.id.startswith("wing_") and corridor.id != "far"


def _with_pocket(massing: Massing, rooms: list[Placement]) -> list[Placement]:
    """Return the rooms, where the one beside a lift next to the stair also has the floor behind that lift."""
    upper = massing.south + massing.corridor
    lifts = [core.box for core in massing.cores if core.type == "elevator" and core.box[1] >= upper - 0.01]
    if not lifts or pocket(massing) <= 0:
        return rooms
    edge = max(box[2] for box in lifts)
    top = max(box[3] for box in lifts)
    spare: Box = (min(box[0] for box in lifts), top, edge, massing.depth)
    neighbours = [
        placement for placement in rooms
        for box in placement.boxes
        if abs(box[0] - edge) < 0.01 and min(box[3], massing.depth) - max(box[1], top) > 1.2
    ]  # fmt: skip
    return [
        msgspec.structs.replace(placement, boxes=[*placement.boxes, spare])
        if neighbours and placement is neighbours[0]
        else placement
        for placement in rooms
    ]


def _with_niche(
    niche: Box, rooms: list[Placement], corridors: list[Corridor]
) -> tuple[list[Placement], list[Corridor]]:
    """Return rooms and corridors with the floor behind the lifts: for the room beside it, else the hub."""
    if not box_area(niche):
        return rooms, corridors
    beside = [
        max(
            (min(box[3], niche[3]) - max(box[1], niche[1]) for box in room.boxes if abs(box[0] - niche[2]) < 0.01),
            default=0.0,
        )
        for room in rooms
    ]
    longest = max(beside, default=0.0)
    if longest > _NICHE_DOOR:
        number = beside.index(longest)
        grown = msgspec.structs.replace(rooms[number], boxes=[*rooms[number].boxes, niche])
        return [*rooms[:number], grown, *rooms[number + 1 :]], corridors
    hub = replace(corridors[0], boxes=[*corridors[0].boxes, niche])
    return rooms, [hub, *corridors[1:]]


_NICHE_DOOR = 1.2
"""Metres over which a room is open to the floor behind the lifts."""


def _with_empty_bands(massing: Massing, corridors: list[Corridor], segments: list[Segment]) -> list[Corridor]:
    """Return the corridors with the stretches of band along them that have no room."""
    given: dict[str, list[Box]] = {}
    for segment in segments:
        if segment.blocks:
            continue
        box = segment.world((0.0, 0.0, segment.length, segment.depth), segment.begin, massing)
        owners = [c for c in corridors if c.id == segment.bar]
        if not owners:
            middle = (box[0] + box[2]) / 2
            mains = [c for c in corridors if _is_main(c)]
            owners = [c for c in mains if c.boxes[0][0] <= middle <= c.boxes[0][2]] or mains[-1:]
        given.setdefault(owners[0].id, []).append(box)
    return [replace(c, boxes=[*c.boxes, *given.get(c.id, [])]) for c in corridors]


def _corridors_of(
    massing: Massing, hub_id: str, fronts: list[_Front], stop: float, lobby: float, *, ended: bool
) -> list[Corridor]:
    """Return the corridors, the hub first: the main one in pieces, one in each wing, and that of the far bar.

    Parameters
    ----------
    fronts : list of _Front
    stop : float
        Where the main corridor ends.
    lobby : float
        Length of the lift lobby.
    ended : bool
        A room closes the bar over its whole depth.
    """
    low, high = massing.south, massing.south + massing.corridor
    main = sorted((x0, x1) for bar, _, x0, x1 in fronts if bar == "main")
    load = len(main) + len(massing.cores) + len(massing.wings) + ended
    pieces = max(1, -(-load // (HUB_CHILDREN + 2)))
    cuts = _cut_positions(main, stop, pieces, _ways_to_kitchens(fronts))
    xs = [0.0, *cuts, stop]
    corridors = []
    for number, (x0, x1) in enumerate(itertools.pairwise(xs)):
        name = hub_id if number == 0 else f"corridor_{number}"
        parent = "" if number == 0 else (hub_id if number == 1 else f"corridor_{number - 1}")
        corridors.append(Corridor(name, [(x0, low, x1, high)], parent))
    corridors[0].boxes.extend(_lobby_boxes(massing, lobby))
    for core in massing.cores:
        if core.box[1] > high + 0.01 and core.box[0] < 0.5 * massing.length:
            corridors[0].boxes.append((core.box[0], high, core.box[2], core.box[1]))
        elif core.box[1] > high + 0.01 and not ended:
            corridors[-1].boxes.append((core.box[0], high, core.box[2], core.box[1]))
    return corridors + _wing_corridors(massing, corridors)


def _lobby_boxes(massing: Massing, lobby: float) -> list[Box]:
    """Return what a lobby of `lobby` metres takes of the lower band: the floor before, beside and behind the lifts."""
    lifts = [core.box for core in massing.cores if core.box[3] <= massing.south + 0.01]
    if not lifts:
        return [(0.0, 0.0, lobby, massing.south)] if lobby else []
    if not lobby:
        return []
    edge, low, top = max(box[2] for box in lifts), min(box[1] for box in lifts), max(box[3] for box in lifts)
    boxes: list[Box] = [(0.0, top, lobby, massing.south)] if massing.south - top > 0.01 else []
    if lobby > edge:
        boxes.append((edge, low, lobby, top))
        boxes += [(0.0, 0.0, lobby, low)] if low > 0.0 else []
    return boxes


def _wing_corridors(massing: Massing, corridors: list[Corridor]) -> list[Corridor]:
    """Return the corridors of the wings, each on the piece of the main one that it meets, and that of the far bar."""
    low, high = massing.south, massing.south + massing.corridor
    found: list[Corridor] = []
    for number, wing in enumerate(massing.wings, 1):
        side = (wing.x1 - wing.x0 - massing.corridor) / 2
        box = (
            (wing.x0 + side, high, wing.x1 - side, massing.depth + wing.reach)
            if wing.north
            else (wing.x0 + side, -wing.reach - (massing.far_band if massing.court else 0.0), wing.x1 - side, low)
        )
        centre = (wing.x0 + wing.x1) / 2
        owner = next((c.id for c in corridors if c.boxes[0][0] <= centre <= c.boxes[0][2]), corridors[0].id)
        found.append(Corridor(f"wing_{number}", [box], owner))
    if massing.court:
        top = -massing.wings[0].reach - massing.far_band
        far: Box = (massing.far[0], top - massing.corridor, massing.far[1], top)
        found.append(Corridor("far", [far], "wing_1"))
    return found


def _ways_to_kitchens(fronts: Sequence[_Front]) -> list[tuple[float, float]]:
    """Return the stretches of the main corridor from the middle of a dining room to that of its nearest kitchen."""
    rule = load_norms().rules["kitchen_of_dining"]
    middles = [(room.kind.name, (x0 + x1) / 2) for bar, room, x0, x1 in fronts if bar == "main"]
    kitchens = [x for name, x in middles if name in rule.others]
    ways = [
        (x, min(kitchens, key=lambda other: abs(other - x))) for name, x in middles if kitchens and name in rule.rooms
    ]
    return [(min(way), max(way)) for way in ways]


def _cut_positions(
    main: list[tuple[float, float]], stop: float, pieces: int, whole: Sequence[tuple[float, float]]
) -> list[float]:
    """Choose where the main corridor is divided: every front keeps a door's width on one side.

    Stretches that are to stay whole are divided only where nothing else can be.
    """
    cuts: list[float] = []
    for number in range(1, pieces):
        ideal = sorted(x0 for x0, _ in main)[min(number * len(main) // pieces, len(main) - 1)]
        candidates = sorted(
            {x for pair in main for x in pair},
            key=lambda x: (sum(low < x < high for low, high in whole), abs(x - ideal), x),
        )
        for x in candidates:
            clear = all(max(x - x0, x1 - x) >= 1.5 or x <= x0 or x >= x1 for x0, x1 in main)
            if clear and 3.0 <= x <= stop - 3.0 and all(abs(x - other) > 4.0 for other in cuts):
                cuts.append(x)
                break
    return sorted(cuts)


def _with_parents(rooms: list[Placement], corridors: list[Corridor], fronts: list[_Front]) -> list[Placement]:
    """Return the rooms, each front room reached from the corridor that it touches most."""
    mains = [c for c in corridors if _is_main(c)]
    owners: dict[int, str] = {}
    for bar, room, x0, x1 in fronts:
        owners[id(room)] = bar
        if bar == "main":
            owners[id(room)] = max(mains, key=lambda c: min(c.boxes[0][2], x1) - max(c.boxes[0][0], x0)).id
    placed = [
        msgspec.structs.replace(placement, parent=owners.get(id(placement.room), placement.parent))
        for placement in rooms
    ]
    return [msgspec.structs.replace(p, parent=mains[-1].id) if p.parent == _AT_END else p for p in placed]


def _closed(
    massing: Massing, corridors: list[Corridor], rooms: list[Placement], stop: float
) -> tuple[list[Corridor], list[Placement]]:
    """Return corridors and rooms, the last room on the north side across the dead end of the corridor where it can."""
    unchanged = (corridors, rooms)
    if far_stair(massing):
        return unchanged
    last = [c for c in corridors if _is_main(c)][-1]
    low, high = massing.south, massing.south + massing.corridor
    if any(abs(w.x1 - stop) < 8.0 for w in massing.wings):
        return unchanged
    x0c = last.boxes[0][0]
    closing = None
    for placement in rooms:
        if placement.parent == last.id and len(placement.boxes) == 1 and not placement.room.suite:
            box = placement.boxes[0]
            if abs(box[2] - stop) < 0.01 and abs(box[1] - high) < 0.01 and not placement.room.fixed:
                closing = placement
    if closing is None:
        return unchanged
    x = closing.boxes[0][0]
    if x - x0c < 3.0 or any(box[2] > x + 0.01 for box in last.boxes[1:]):
        return unchanged
    for placement in rooms:
        if placement is closing or placement.parent != last.id:
            continue
        for box in placement.boxes:
            touches = abs(box[3] - low) < 0.01 and box[2] > x
            if touches and min(box[2], x) - max(box[0], x0c) < 1.5:
                return unchanged
    x0, _, x1, y1 = closing.boxes[0]
    shortened = replace(last, boxes=[(x0c, low, x, high), *last.boxes[1:]])
    widened = msgspec.structs.replace(closing, boxes=[(x0, low, x1, y1)])
    return [shortened if c is last else c for c in corridors], [widened if p is closing else p for p in rooms]


def _leads_out(massing: Massing, storey: Storey, rooms: Sequence[Placement], length: float) -> bool:
    """Whether the far end of the corridor is to be an exit.

    It is on an entrance storey that reaches farther than one exit is enough for, and has no room for visitors in its
    far half that a second exit could lead out of.
    """
    rule = load_norms().rules["single_exit_travel"]
    asked = rule.holds_for(storey.use.family) and storey.role in ("ground", "single") and not massing.wings
    if not asked or length <= rule.limit(storey.use.name, storey.use.family):
        return False
    far = (box for room in rooms if room.room.kind.zone == "public" for box in room.boxes)
    return not any(box[2] > length / 2 for box in far)


def _is_open_to(corridors: list[Corridor], stop: float) -> bool:
    """Whether the main corridor runs to the end of the bar."""
    return abs([c for c in corridors if _is_main(c)][-1].boxes[0][2] - stop) < 0.01


def _turned_in(
    massing: Massing, corridors: list[Corridor], rooms: list[Placement], stop: float
) -> tuple[list[Corridor], list[Placement]]:
    """Return corridors and rooms, the hall of a home no longer than its doors need: a room at its end has the rest.

    The room is the one beside the end that stays the more compact; wet rooms and rooms of a stated area are left alone.
    """
    last = [c for c in corridors if _is_main(c)][-1]
    x0, low, _, high = last.boxes[0]
    fronts = [
        (placement, box)
        for placement in rooms
        for box in placement.boxes
        if (abs(box[3] - low) < 0.01 or abs(box[1] - high) < 0.01) and box[2] > x0
    ]
    doors = [max(box[0], x0) + DOOR for placement, box in fronts if placement.parent == last.id]
    doors += [box[2] for box in last.boxes[1:]] + [core.box[2] for core in massing.cores if core.box[0] < stop / 2]
    end = max(doors, default=stop)
    takers = [
        placement
        for placement, box in fronts
        if abs(box[2] - stop) < 0.01 and box[0] <= end - DOOR + 0.01
        and (abs(box[3] - low) < 0.01 or not last.boxes[1:])  # the floor before a stair stays clear of its box
        and not placement.room.fixed and not placement.room.kind.wet and not placement.room.suite
    ]  # fmt: skip
    if massing.wings or far_stair(massing) or stop - end < _WORTH_TURNING or not takers:
        return corridors, rooms
    rest: Box = (end, low, stop, high)
    taker = max(takers, key=lambda placement: (round(fill([*placement.boxes, rest]), 2), placement.area))
    shortened = replace(last, boxes=[(x0, low, end, high), *last.boxes[1:]])
    grown = msgspec.structs.replace(taker, boxes=[*taker.boxes, rest])
    return [shortened if c is last else c for c in corridors], [grown if p is taker else p for p in rooms]


_WORTH_TURNING = 0.8
"""Least metres of hall that a room takes."""


def _bearing_lines(
    massing: Massing, corridors: list[Corridor], segments: Sequence[Segment], lobby: float, stop: float, *, home: bool
) -> dict[float, list[tuple[float, float]]]:
    """Return the stretches along x, by their y, where both sides of the main corridor are walls.

    A stretch of band without a room has none: it is part of the corridor.
    """
    mains = [c for c in corridors if _is_main(c)]
    end = max(corridor.boxes[0][2] for corridor in mains)
    far = min((core.box[0] for core in massing.cores if core.box[0] > 0.5 * massing.length), default=end)
    # A hall that ends before its bar may have given the rest to a room on either side.
    south = end if home else stop
    lines = {massing.south + massing.corridor: [(pocket(massing), min(end, far))], massing.south: [(lobby, south)]}
    for wing in massing.wings:
        y = massing.south + massing.corridor if wing.north else massing.south
        side = (wing.x1 - wing.x0 - massing.corridor) / 2
        lines[y] = _without(lines[y], wing.x0 + side, wing.x1 - side)
    for segment in segments:
        if segment.bar == "main" and not segment.blocks:
            lines[segment.front] = _without(lines[segment.front], segment.begin, segment.end)
    return lines


def _without(spans: list[tuple[float, float]], x0: float, x1: float) -> list[tuple[float, float]]:
    left = [(a, min(b, x0)) for a, b in spans]
    right = [(max(a, x1), b) for a, b in spans]
    return [(a, b) for a, b in left + right if b - a > 0.5]


def _core_parents(massing: Massing, corridors: list[Corridor], closing: str) -> dict[str, str]:
    """Return what each core opens to: the hub, or at the far end the room that closes the bar or the last piece.

    Parameters
    ----------
    closing : str
        The room around the stair at the far end; empty where the corridor reaches it.
    """
    mains = [c for c in corridors if _is_main(c)]
    far = closing or mains[-1].id
    return {core.id: far if core.box[0] >= 0.5 * massing.length else mains[0].id for core in massing.cores}


def _extent(massing: Massing, storey: Storey) -> float:
    return massing.length - storey.setback + storey.extension


def capacity(massing: Massing, storey: Storey) -> float:
    """Return the area that rooms can take on a storey, square metres."""
    length = _extent(massing, storey)
    total = length * massing.depth - (massing.length if storey.hall_wing else length) * massing.corridor
    for wing in massing.wings:
        total += (wing.x1 - wing.x0 - massing.corridor) * wing.reach
        band = massing.north if wing.north else massing.south
        total -= massing.corridor * band
    if massing.court:
        total += (massing.court - massing.corridor) * massing.far_length
        total -= massing.corridor * massing.far_band * len(massing.wings)
    total -= lobby_length(massing, storey) * massing.south - box_area(_behind_lifts(massing, storey))
    total -= pocket(massing) * massing.north + far_stair(massing) * massing.north
    if massing.hall:
        hub = length * massing.corridor
        return total + hub
    return total


def _behind_lifts(massing: Massing, storey: Storey) -> Box:
    """Return the floor behind the lifts that a room has; on the entrance storey it is part of the lobby."""
    return (0.0, 0.0, 0.0, 0.0) if storey.role in ("ground", "single") else behind_lifts(massing)


def _with_floor_behind_lifts(massing: Massing, storey: Storey, segments: list[Segment]) -> list[Segment]:
    """Return the stretches of band, where the first room beside the lifts also has the floor behind them."""
    behind = _behind_lifts(massing, storey)
    return [
        msgspec.structs.replace(segment, behind=box_area(behind))
        if segment.bar == "main" and not segment.north and segment.begin == behind[2] > 0.0
        else segment
        for segment in segments
    ]


def _room_beside_lifts(segments: Sequence[Segment]) -> list[Segment]:
    """Return the segments, with no passage at the beginning of one whose first room has the floor behind the lifts."""
    rows = []
    for segment in segments:
        whole = [block for block in segment.blocks if not block.passage][:1] if segment.behind else []
        rows.append([*whole, *(block for block in segment.blocks if not any(block is first for first in whole))])
    return with_rows(segments, rows)


def _segments(massing: Massing, stop: float, lobby: float) -> list[Segment]:
    """List the stretches of band along corridors, nearest to the stair first."""
    south, north = massing.south, massing.north
    upper = massing.south + massing.corridor
    segments: list[Segment] = []
    for is_north, begin in ((True, pocket(massing)), (False, lobby)):
        front, depth = (upper, north) if is_north else (south, south)
        end = min(stop, massing.length - far_stair(massing)) if is_north and far_stair(massing) else stop
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
    rooms, fronts, passages = _placed(massing, segments)
    closed = boxes_at_end(massing, ends, stop, length, beyond=storey.hall_wing)
    rooms += [Placement(room, boxes, _AT_END) for room, boxes in zip(ends, closed)]
    lobby = lobby_length(massing, storey)
    corridors = _corridors_of(massing, hub_id, fronts, stop, lobby, ended=bool(ends) and not storey.hall_wing)
    corridors = with_passages(corridors, [c for c in corridors if _is_main(c)], passages)
    rooms, corridors = _with_niche(_behind_lifts(massing, storey), rooms, corridors)
    rooms = _with_parents(_with_pocket(massing, rooms), corridors, fronts)
    if not ends:
        if not _leads_out(massing, storey, rooms, length):
            corridors, rooms = _closed(massing, corridors, rooms, stop)
        if storey.use.family == "home" and _is_open_to(corridors, stop):
            corridors, rooms = _turned_in(massing, corridors, rooms, stop)
    corridors = _with_empty_bands(massing, corridors, segments)
    bearing = _bearing_lines(massing, corridors, segments, lobby, stop, home=storey.use.family == "home")
    for passage in passages:
        if passage.bar == "main":
            bearing[passage.front] = _without(bearing[passage.front], passage.x0, passage.x1)
    closing = ends[0].id if ends and far_stair(massing) and not storey.hall_wing else ""
    return Sketch(corridors, rooms, _core_parents(massing, corridors, closing), bearing=bearing)


def _placed(massing: Massing, segments: Sequence[Segment]) -> tuple[list[Placement], list[_Front], list[SidePassage]]:
    """Return the places of the rooms of all stretches, which of them front a corridor, and the passages."""
    rooms: list[Placement] = []
    fronts: list[_Front] = []
    passages: list[SidePassage] = []
    for segment in segments:
        for block, x0, x1 in segment.laid():
            passage = passage_of(block, x1 - x0, segment.depth)
            if passage:
                box = segment.world(passage, x0, massing)
                passages.append(SidePassage(segment.bar, segment.front, x0 + passage[0], x0 + passage[2], box))
            for room, boxes in lay_block(block, x1 - x0, segment.depth):
                world = [segment.world(box, x0, massing) for box in boxes]
                parent = next((p.id for p in block.host.each() if any(c is room for c in p.suite)), "")
                rooms.append(Placement(room, world, parent))
                if not parent:
                    span = [passage] if passage else [box for box in boxes if box[1] < 0.01]
                    fronts.append((segment.bar, room, x0 + min(b[0] for b in span), x0 + max(b[2] for b in span)))
    return rooms, fronts, passages
