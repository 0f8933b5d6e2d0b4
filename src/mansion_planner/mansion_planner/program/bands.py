"""Lay rooms out in bands along corridors: blocks of rooms, and the stretches of band that they are distributed over."""

from collections.abc import Sequence

import msgspec

from mansion_knowledge.norms import load_norms
from mansion_planner.program.model import Box, Massing, PlannedRoom, Wing
from mansion_planner.program.plan_quality import STRIP

__all__ = [
    "Block",
    "Segment",
    "bring_together",
    "fill_segments",
    "front_order",
    "group_blocks",
    "lay_block",
    "widened",
    "with_rows",
]

DOOR = 1.5
"""Least contact of a room with what it is reached from, with a margin over the 1.20 m of a door, metres."""


LEAST_FRONT = 1.3
"""Least stretch of corridor, or of its host's wall, that a room gets, metres."""


_WALL = 0.15
"""What walls and rounding take of a room's width, metres."""


def least_sides(room: PlannedRoom) -> tuple[float, float]:
    """Return the least front and depth of a room in the front corner of another, metres."""
    if _is_wide(room):
        norm = load_norms().rules["accessible_toilet_size"]
        return norm.figure + _WALL, norm.limit("length") + _WALL
    return LEAST_FRONT, 1.2


def _is_wide(room: PlannedRoom) -> bool:
    """Whether a wheelchair turns in a room, however small it is."""
    return room.kind.name in load_norms().rules["accessible_toilet_size"].rooms


def widened(widths: list[float], least: list[float]) -> list[float]:
    """Raise widths to their least; those that have more to spare give it, in proportion.

    The sum stays; widths that cannot all have their least stay as they are.
    """
    need = sum(max(low - width, 0.0) for width, low in zip(widths, least))
    spare = sum(max(width - low, 0.0) for width, low in zip(widths, least))
    if need <= 0.0 or spare <= need:
        return widths
    return [low if width < low else width - (width - low) * need / spare for width, low in zip(widths, least)]


class Block(msgspec.Struct, frozen=True):
    """A room of full depth with small rooms cut from its front corner.

    Attributes
    ----------
    host : PlannedRoom
    smalls : tuple of PlannedRoom
        Rooms too small for the band's depth, also reached from the corridor.
    least : float
        Metres of front that its place asks for.
    """

    host: PlannedRoom
    smalls: tuple[PlannedRoom, ...] = ()
    least: float = 0.0

    @property
    def gross(self) -> float:
        """Area of the host with its suite and the small rooms."""
        return self.host.gross + sum(room.area for room in self.smalls)

    @property
    def fixed(self) -> bool:
        """Whether its width must not be scaled."""
        return self.host.fixed

    @property
    def wants_light(self) -> bool:
        """Whether one of its rooms wants a window."""
        return any(room.kind.daylight for front in self.fronts() for room in front.each())

    @property
    def least_width(self) -> float:
        """Metres of corridor that its rooms need at least."""
        return max(self.least, sum(least_sides(room)[0] for room in self.fronts()))

    def fronts(self) -> list[PlannedRoom]:
        """Return the rooms that touch the corridor."""
        return [*self.smalls, self.host]


def _front_depth(area: float, depth: float) -> float:
    """Return how deep a small room of `area` is made in a band of `depth`."""
    return float(min(max((area * 1.25) ** 0.5, 1.8), max(depth - 1.8, 0.55 * depth)))


def group_blocks(rooms: Sequence[PlannedRoom], depth: float, pairs: Sequence[tuple[str, str]]) -> list[Block]:
    """Give each room that is too small for a band of `depth` to a larger neighbour as its front corner."""
    narrow = [room for room in rooms if not room.suite and _is_narrow(room, depth)]
    narrow.sort(key=lambda room: -room.area)
    blocks = [Block(room) for room in rooms if not any(room is other for other in narrow)]
    for room in narrow:
        width = max(room.area / _front_depth(room.area, depth), least_sides(room)[0] if _is_wide(room) else 0.0)
        hosts = [
            number
            for number, block in enumerate(blocks)
            if not block.host.suite
            and len(block.smalls) < 3
            and _spare_front(block, depth) + room.area / depth >= width + _HOST_FRONT
        ]
        if hosts:
            best = max(hosts, key=lambda number: _fit(blocks[number], room, depth, pairs))
            blocks[best] = Block(blocks[best].host, (*blocks[best].smalls, room))
        else:
            blocks.append(Block(room))
    return blocks


_NARROW = 1.9
"""Width below which a room is too narrow for the whole depth of a band, metres."""

_HOST_FRONT = 1.9
"""Least front of a room beside the small ones in its corner, metres."""


def _is_narrow(room: PlannedRoom, depth: float) -> bool:
    """Whether a room of a band's whole depth is too narrow; one that wants no window need not reach the outer wall."""
    width = room.area / depth
    return width < _NARROW or (not room.kind.daylight and width < depth / STRIP)


def _spare_front(block: Block, depth: float) -> float:
    width = block.gross / depth
    return width - sum(room.area / _front_depth(room.area, depth) for room in block.smalls)


def _fit(block: Block, room: PlannedRoom, depth: float, pairs: Sequence[tuple[str, str]]) -> float:
    """Prefer hosts of kindred use with room to spare."""
    same_zone = block.host.kind.zone == room.kind.zone
    wanted = room.kind.name in block.host.kind.near or block.host.kind.name in room.kind.near
    asked = any(
        (block.host.called(one) and room.called(other)) or (block.host.called(other) and room.called(one))
        for one, other in pairs
    )
    clean = not (room.kind.wet and "kitchen" in block.host.kind.name)
    return (
        3.0 * wanted
        + 8.0 * asked
        + 2.0 * clean
        + 0.5 * same_zone
        - 2.0 * len(block.smalls)
        + min(_spare_front(block, depth), 12.0) / 6.0
        - (1.0 if block.host.fixed else 0.0)
    )


def lay_block(block: Block, width: float, depth: float) -> list[tuple[PlannedRoom, list[Box]]]:
    """Lay out a block in ``width x depth``; areas keep their proportions.

    Returns
    -------
    list of (PlannedRoom, list of Box)
        Boxes that make up each room, in the local frame.
    """
    scale = width * depth / block.gross
    placed: list[tuple[PlannedRoom, list[Box]]] = []
    x = 0.0
    corner_boxes: list[Box] = []
    for number, room in enumerate(block.smalls):
        front, least = least_sides(room)
        high = max(_front_depth(room.area * scale, depth), min(least, depth - 1.2))
        after = sum(least_sides(other)[0] for other in (*block.smalls[number + 1 :], block.host))
        wide = min(max(room.area * scale / high, front), max(width - x - after, 0.5))
        high = min(high, max(room.area * scale / wide, least))
        corner_boxes.append((x, 0.0, x + wide, high))
        placed.append((room, [(x, 0.0, x + wide, high)]))
        x += wide
    if block.smalls:
        boxes = [(x, 0.0, width, depth)]
        boxes += [(box[0], box[3], box[2], depth) for box in corner_boxes]
        placed.append((block.host, boxes))
        return placed
    return _lay_suite(block.host, width, depth, scale)


def _lay_suite(host: PlannedRoom, width: float, depth: float, scale: float) -> list[tuple[PlannedRoom, list[Box]]]:
    suite = host.suite
    if not suite:
        return [(host, [(0.0, 0.0, width, depth)])]
    if len(suite) == 1 and not suite[0].suite:
        return _lay_one(host, suite[0], width, depth, scale)
    return _lay_columns(host, width, depth, scale)


def _lay_one(
    host: PlannedRoom, child: PlannedRoom, width: float, depth: float, scale: float
) -> list[tuple[PlannedRoom, list[Box]]]:
    """A child in the front corner when the front is wide enough (a hotel room's bath), else at the back."""
    area = child.area * scale
    high = _front_depth(area, depth)
    wide = area / high
    if width - wide >= DOOR and area < 0.4 * host.area * scale:
        corner: Box = (0.0, 0.0, wide, high)
        return [(host, [(wide, 0.0, width, depth), (0.0, high, wide, depth)]), (child, [corner])]
    back = area / width
    if back >= 1.5:
        front = depth - back
        return [(host, [(0.0, 0.0, width, front)]), (child, [(0.0, front, width, depth)])]
    high = max(area / max(0.5 * width, 1.5), 1.5)
    wide = area / high
    boxes: list[Box] = [(0.0, 0.0, width, depth - high), (wide, depth - high, width, depth)]
    return [(host, boxes), (child, [(0.0, depth - high, wide, depth)])]


def _lay_columns(host: PlannedRoom, width: float, depth: float, scale: float) -> list[tuple[PlannedRoom, list[Box]]]:
    """The host as a slab of full depth between two columns of its children."""
    children = sorted(host.suite, key=lambda room: -room.gross)
    columns: tuple[list[PlannedRoom], list[PlannedRoom]] = ([], [])
    if len(children) <= 3:
        columns[1].extend(children)
    else:
        for child in children:
            sums = [sum(room.gross for room in column) for column in columns]
            columns[0 if sums[0] <= sums[1] else 1].append(child)
    placed: list[tuple[PlannedRoom, list[Box]]] = []
    wide = [sum(room.gross for room in column) * scale / depth for column in columns]
    least = [LEAST_FRONT if column else 0.0 for column in columns]
    wide = widened([*wide, width - sum(wide)], [*least, LEAST_FRONT])[:2]
    placed.append((host, [(wide[0], 0.0, width - wide[1], depth)]))
    for number, column in enumerate(columns):
        x0, x1 = (0.0, wide[0]) if number == 0 else (width - wide[1], width)
        y = 0.0
        ordered = sorted(column, key=lambda room: (not room.kind.wet, room.id))
        whole = sum(child.gross for child in ordered) or 1.0
        rises = widened([depth * child.gross / whole for child in ordered], [LEAST_FRONT] * len(ordered))
        for child, high in zip(ordered, rises):
            placed.append((child, [(x0, y, x1, y + high)]))
            y += high
    return placed


class Segment(msgspec.Struct, frozen=True):
    """A stretch of band: from `begin` to `end` along its corridor, `depth` metres deep.

    Attributes
    ----------
    bar : str
        ``main``, or the wing's name.
    north : bool
        On the upper side of the main corridor, or on the right side of a wing's.
    front : float
        Coordinate of the corridor's edge across the bar.
    dark : bool
        It has no outer wall.
    """

    bar: str
    north: bool
    begin: float
    end: float
    front: float
    depth: float
    wing: Wing | None = None
    blocks: tuple[Block, ...] = ()
    dark: bool = False

    @property
    def length(self) -> float:
        """Metres along the corridor."""
        return self.end - self.begin

    @property
    def used(self) -> float:
        """Metres that its blocks wish for."""
        return sum(block.gross for block in self.blocks) / self.depth

    def laid(self) -> list[tuple[Block, float, float]]:
        """Return each block with its place along the corridor; fixed areas keep their width where others can give."""
        wishes = [block.gross / self.depth for block in self.blocks]
        if not wishes:
            return []
        fixed = sum(w for w, block in zip(wishes, self.blocks) if block.fixed)
        loose = sum(wishes) - fixed
        spare = self.length - fixed
        keep = loose > 0 and 0.6 * loose <= spare <= 2.5 * loose
        everyone = self.length / sum(wishes)
        widths = [
            wish * (everyone if not keep else 1.0 if block.fixed else spare / loose)
            for wish, block in zip(wishes, self.blocks)
        ]
        widths = widened(widths, [block.least_width for block in self.blocks])
        placed, x = [], self.begin
        for width, block in zip(widths, self.blocks):
            placed.append((block, x, x + width))
            x += width
        return placed

    def world(self, box: Box, x0: float, massing: Massing) -> Box:
        """Turn a block's box into the massing frame."""
        if self.wing is None:
            if self.north:
                return (x0 + box[0], self.front + box[1], x0 + box[2], self.front + box[3])
            return (x0 + box[0], self.front - box[3], x0 + box[2], self.front - box[1])
        across = (self.front + box[1], self.front + box[3])
        if not self.north:
            across = (self.front - box[3], self.front - box[1])
        if self.wing.north:
            start = massing.south + massing.corridor + x0
            return (across[0], start + box[0], across[1], start + box[2])
        start = massing.south - x0
        return (across[0], start - box[2], across[1], start - box[0])


def front_order(rooms: Sequence[PlannedRoom]) -> list[PlannedRoom]:
    """Order rooms from the cores outwards: wet rooms (stacked from storey to storey), public, service, private."""
    zones = {"circulation": 0, "public": 1, "service": 2, "private": 3}

    def rank(room: PlannedRoom) -> tuple[int, int]:
        if room.kind.stack:
            return (0, room.kind.stack)
        if room.kind.open:
            return (1, 0)
        return (2 + zones[room.kind.zone], 0)

    return sorted(rooms, key=rank)


def fill_segments(
    segments: Sequence[Segment], blocks: Sequence[Block], pairs: Sequence[tuple[str, str]] = ()
) -> list[Segment]:
    """Return the segments with each block in one, filled in equal measure and so that rooms are well shaped.

    Parameters
    ----------
    segments : sequence of Segment
    blocks : sequence of Block
        In the order from the cores outwards, which each segment keeps.
    pairs : sequence of (str, str), optional
        Room types that are to be side by side, the most wanted first.
    """
    total = sum(block.gross for block in blocks)
    room = sum(segment.length * segment.depth for segment in segments)
    scale = room / total if total > 0 else 1.0
    share = [_Share(segment, scale, blocks) for segment in segments]
    for number in range(len(blocks)):
        best = min(
            share, key=lambda s: (s.overflow(number) > 0.06 * s.segment.length, s.filling + 1.5 * s.parts[number][1])
        )
        best.add(number)
    _balance(share)
    filled = [
        msgspec.structs.replace(entry.segment, blocks=tuple(blocks[number] for number in sorted(entry.members)))
        for entry in share
    ]
    for first, second in pairs:
        filled = bring_together(filled, first, second)
    return filled


def shape_cost(area: float, depth: float) -> float:
    """Price of a room of `area` in a band of `depth`: 0 for well-proportioned ones, more for slivers and galleries."""
    width = area / depth
    slender = max(0.0, 0.55 - width / depth)
    stretched = max(0.0, width / depth - 3.0)
    return 2.0 * slender + 0.3 * min(stretched, 2.0)


_DARKNESS = 1.0
"""Price of a room that wants a window where there is none."""

_Parts = tuple[float, float, float]
_NOTHING: _Parts = (0.0, 0.0, 0.0)


class _Share:
    """A segment while `fill_segments` fills it: member blocks by number, and the metres that they take.

    Attributes
    ----------
    parts : list of (float, float, float)
        Metres, shape price and metres of fixed area of each block here.
    """

    def __init__(self, segment: Segment, scale: float, blocks: Sequence[Block]) -> None:
        self.segment = segment
        self.members: list[int] = []
        self.used = 0.0
        self.shape = 0.0
        self.rigid = 0.0
        self.parts = [_parts(segment, block, scale) for block in blocks]

    @property
    def filling(self) -> float:
        return self.used / self.segment.length

    def overflow(self, number: int) -> float:
        return self.used + self.parts[number][0] - self.segment.length

    def add(self, number: int) -> None:
        self._count(self.parts[number], 1.0)
        self.members.append(number)

    def remove(self, number: int) -> None:
        self._count(self.parts[number], -1.0)
        self.members.remove(number)

    def _count(self, parts: _Parts, sign: float) -> None:
        """Account for a block that comes (+1) or leaves (-1)."""
        self.used += sign * parts[0]
        self.shape += sign * parts[1]
        self.rigid += sign * parts[2]

    def cost(self, coming: _Parts = _NOTHING, leaving: _Parts = _NOTHING, members: int = 0) -> float:
        """Return the segment's price after a change."""
        # Squared, so that two segments a little off are cheaper than one far off. A block of fixed area costs extra
        # where the others cannot give way, and a segment without a block is worth avoiding at almost any price.
        length = self.segment.length
        used = self.used + coming[0] - leaving[0]
        rigid = self.rigid + coming[2] - leaving[2]
        price = 3.0 * (used / length - 1.0) ** 2 * length + self.shape + coming[1] - leaving[1]
        loose, spare = used - rigid, length - rigid
        if rigid > 0.01 and not 0.62 * loose <= spare <= 2.4 * loose:
            price += 8.0 * abs(used / length - 1.0) * rigid
        return price + (50.0 if len(self.members) + members <= 0 else 0.0)


def _parts(segment: Segment, block: Block, scale: float) -> _Parts:
    """Return metres, shape price and metres of fixed area of a block in a segment."""
    area = block.gross * scale
    metres = area / segment.depth
    price = shape_cost(area, segment.depth) + (_DARKNESS if segment.dark and block.wants_light else 0.0)
    return metres, price, metres if block.fixed else 0.0


def _balance(share: list[_Share]) -> None:
    """Move or swap blocks between segments while that lowers the price."""
    for _ in range(40):
        if not any(_improve(a, b) for a in share for b in share if a is not b):
            return


def _improve(a: _Share, b: _Share) -> bool:
    """Move or swap the first block whose place in the other segment is cheaper, and tell whether there was one."""
    base = a.cost() + b.cost() - 1e-6
    for number in a.members:
        here, there = a.parts[number], b.parts[number]
        if a.cost(leaving=here, members=-1) + b.cost(coming=there, members=1) < base:
            a.remove(number)
            b.add(number)
            return True
        for other in b.members:
            if a.cost(a.parts[other], here) + b.cost(there, b.parts[other]) < base:
                a.remove(number)
                b.add(number)
                b.remove(other)
                a.add(other)
                return True
    return False


def _holds(block: Block, name: str) -> bool:
    return block.host.called(name)


def bring_together(segments: Sequence[Segment], first: str, second: str) -> list[Segment]:
    """Return the segments with a block of one type beside one of the other.

    It moves within its segment, else a block that takes as much of the front makes room for it.
    """
    places = _places_of(segments, first)
    goals = _places_of(segments, second) if places else []
    if not goals or any(s == t and abs(i - j) == 1 for s, i in places for t, j in goals):
        return list(segments)
    rows = [list(segment.blocks) for segment in segments]
    within = next(((s, i, j) for s, i in places for t, j in goals if s == t), None)
    if within is not None:
        s, i, j = within
        rows[s].insert(j, rows[s].pop(i))
        return with_rows(segments, rows)
    swap = _best_swap(segments, places, goals)
    if swap is None:
        return list(segments)
    (s, i), (t, j), k = swap
    rows[s][i], rows[t][k] = rows[t][k], rows[s][i]
    rows[t].insert(j, rows[t].pop(k))
    return with_rows(segments, rows)


def with_rows(segments: Sequence[Segment], rows: Sequence[Sequence[Block]]) -> list[Segment]:
    """Return the segments with a row of blocks for each."""
    return [msgspec.structs.replace(segment, blocks=tuple(row)) for segment, row in zip(segments, rows)]


_Place = tuple[int, int]
"""Number of a segment, and of a block in it."""


def _places_of(segments: Sequence[Segment], name: str) -> list[_Place]:
    return [
        (s, i) for s, segment in enumerate(segments) for i, block in enumerate(segment.blocks) if _holds(block, name)
    ]


def _best_swap(
    segments: Sequence[Segment], places: Sequence[_Place], goals: Sequence[_Place]
) -> tuple[_Place, _Place, int] | None:
    """Return which block goes to the segment of which other, and the number there of the one that it changes with.

    Its segments are as full after the exchange as before, or nearly so; ``None`` where no exchange does that.
    """
    options = [
        (_misfit_of_swap(segments, (s, i), (t, k)), n, m, k)
        for n, (s, i) in enumerate(places) for m, (t, j) in enumerate(goals)
        for k in range(len(segments[t].blocks)) if k != j
    ]  # fmt: skip
    options += [
        (_misfit_of_swap(segments, (s, k), (t, j)), n, -1 - m, k)
        for n, (s, i) in enumerate(places) for m, (t, j) in enumerate(goals)
        for k in range(len(segments[s].blocks)) if k != i
    ]  # fmt: skip
    best = min(options, default=None)
    if best is None or best[0] > 0.3:
        return None
    _, n, m, k = best
    return (places[n], goals[m], k) if m >= 0 else (goals[-1 - m], places[n], k)


def _misfit_of_swap(segments: Sequence[Segment], one: _Place, other: _Place) -> float:
    """How far the worse of two segments is from full after they exchange a block, as a share of its length."""
    s, t = segments[one[0]], segments[other[0]]
    ours, theirs = s.blocks[one[1]], t.blocks[other[1]]
    return max(_misfit(s, ours, theirs), _misfit(t, theirs, ours))


def _misfit(segment: Segment, leaving: Block, coming: Block) -> float:
    """How far a segment is from full after an exchange, as a share of its length."""
    used = segment.used + (coming.gross - leaving.gross) / segment.depth
    return abs(used / segment.length - 1.0)
