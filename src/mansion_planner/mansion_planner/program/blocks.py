"""Blocks of rooms along a corridor: a room of a band's depth with small rooms in its front corner, or a suite.

Small rooms that want no window lie around a passage of their own where there are enough of them.
"""

from collections.abc import Sequence

import msgspec

from mansion_knowledge import RoomType, is_class
from mansion_knowledge.norms import Norm, load_norms
from mansion_planner.program.model import Box, PlannedRoom
from mansion_planner.program.plan_quality import STRIP
from mansion_planner.program.side_passages import Cluster, Wish, cluster_layout, cluster_width
from mansion_planner.program.widths import widened

__all__ = [
    "DOOR",
    "LEAST_FRONT",
    "Block",
    "group_blocks",
    "lay_block",
    "least_sides",
    "needs_outer_wall",
    "of_full_depth",
    "passage_of",
]

DOOR = 1.5
"""Least contact of a room with what it is reached from, with a margin over the 1.20 m of a door, metres."""


LEAST_FRONT = 1.3
"""Least stretch of corridor, or of its host's wall, that a room gets, metres."""


_WALL = 0.15
"""Width of a room that walls and rounding take, metres."""


def least_sides(room: PlannedRoom) -> tuple[float, float]:
    """Return the least front and depth of a room in the front corner of another, metres."""
    if _is_wide(room):
        norm = load_norms().rules["accessible_toilet_size"]
        return norm.figure + _WALL, norm.limit("length") + _WALL
    return LEAST_FRONT, 1.2


def needs_outer_wall(kind: RoomType) -> bool:
    """Whether the rules of building ask for a window in a room of a type."""
    return _is_of(kind, load_norms().rules["outer_wall"])


def _is_of(kind: RoomType, norm: Norm) -> bool:
    """Whether a rule asks something of rooms of a type, or of those that it is treated or counted as."""
    return not {kind.name, kind.kin, kind.counts_as}.isdisjoint(norm.rooms)


def _is_wide(room: PlannedRoom) -> bool:
    """Whether a wheelchair turns in a room, however small it is."""
    return room.kind.name in load_norms().rules["accessible_toilet_size"].rooms


class Block(msgspec.Struct, frozen=True):
    """A room of full depth with small rooms cut from its front corner.

    Attributes
    ----------
    host : PlannedRoom
    smalls : tuple of PlannedRoom
        Rooms too small for the band's depth, also reached from the corridor.
    least : float
        Metres of front that its place requires.
    passage : float
        Square metres of the passage around which host and small rooms lie, rectangles all; 0 where the small rooms are
        cut from the host's corner.
    """

    host: PlannedRoom
    smalls: tuple[PlannedRoom, ...] = ()
    least: float = 0.0
    passage: float = 0.0

    @property
    def gross(self) -> float:
        """Area of the host with its suite, the small rooms and their passage."""
        return self.host.gross + sum(room.area for room in self.smalls) + self.passage

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
        """Least length of corridor that its rooms need, metres."""
        own = 0.0 if self.fixed or self.smalls else _least_across(self.host)
        return max(self.least, own, sum(least_sides(room)[0] for room in self.fronts()))

    def fronts(self) -> list[PlannedRoom]:
        """Return the rooms that touch the corridor."""
        return [*self.smalls, self.host]


def _front_depth(area: float, depth: float) -> float:
    """Return how deep a small room of `area` is made in a band of `depth`."""
    return float(min(max((area * 1.25) ** 0.5, 1.8), max(depth - 1.8, 0.55 * depth)))


def group_blocks(
    rooms: Sequence[PlannedRoom], depth: float, pairs: Sequence[tuple[str, str]], *, passages: bool = False
) -> list[Block]:
    """Give each room that is too small for a band of `depth` to a larger neighbour as its front corner.

    With `passages`, those that want no window first form clusters around a passage.
    """
    bright = [_wide_enough(room, depth) for room in rooms]
    narrow = [room for room in bright if not room.suite and _is_narrow(room, depth) and _fits_in_front(room, depth)]
    narrow.sort(key=lambda room: -room.area)
    clusters = (
        _clusters(narrow, [room for room in bright if room.area <= _MOST_SERVICE], depth, pairs) if passages else []
    )
    placed = [room for block in clusters for room in block.fronts()]
    narrow = [room for room in narrow if not any(room is other for other in placed)]
    blocks = _in_order(bright, clusters, narrow)
    for room in narrow:
        width = max(room.area / _front_depth(room.area, depth), least_sides(room)[0] if _is_wide(room) else 0.0)
        hosts = [
            number
            for number, block in enumerate(blocks)
            if not block.host.suite
            and not block.passage
            and len(block.smalls) < 3
            and _spare_front(block, depth) + room.area / depth >= width + _HOST_FRONT
        ]
        if hosts:
            best = max(hosts, key=lambda number: _fit(blocks[number], room, depth, pairs))
            blocks[best] = Block(blocks[best].host, (*blocks[best].smalls, room))
        else:
            blocks.append(Block(room))
    return blocks


def _in_order(rooms: Sequence[PlannedRoom], clusters: Sequence[Block], narrow: Sequence[PlannedRoom]) -> list[Block]:
    """Return a block for each room that is not narrow, and each cluster where the first of its rooms is."""
    blocks: list[Block] = []
    for room in rooms:
        cluster = next((block for block in clusters if any(room is other for other in block.fronts())), None)
        if cluster is not None:
            blocks += [cluster] if not any(cluster is block for block in blocks) else []
        elif not any(room is other for other in narrow):
            blocks.append(Block(room))
    return blocks


_MOST_AT_PASSAGE = 4
"""Rooms around one passage."""

_LONGEST_AT_PASSAGE = 3.2
"""Greatest ratio of long to short side of the rooms around a passage."""


def _clusters(
    narrow: Sequence[PlannedRoom], rooms: Sequence[PlannedRoom], depth: float, pairs: Sequence[tuple[str, str]]
) -> list[Block]:
    """Return blocks of small rooms around passages: of all ways to divide them, wet ones first, the one of least price.

    A narrow room that is left alone goes with a wider one of `rooms`. Rooms that want a window, or that a brief wants
    beside another, form no cluster.
    """
    dark = [
        room for room in rooms
        if not room.kind.daylight and not room.suite and not room.kind.open
        and not any(room.called(name) for pair in pairs for name in pair)
    ]  # fmt: skip
    free = [room for room in dark if any(room is other for other in narrow)]
    wider = [room for room in dark if not any(room is other for other in free)]
    free.sort(key=lambda room: (not room.kind.wet, -room.area))
    best: list[tuple[float, list[list[PlannedRoom]]]] = [(0.0, [])]
    for end in range(1, len(free) + 1):
        ways = [(best[end - 1][0] + _ALONE, [*best[end - 1][1], [free[end - 1]]])]
        for begin in range(max(end - _MOST_AT_PASSAGE, 0), end - 1):
            priced = _cluster(free[begin:end], depth)
            if priced is not None:
                ways.append((best[begin][0] + priced[0], [*best[begin][1], free[begin:end]]))
        best.append(min(ways, key=lambda way: way[0]))
    blocks = []
    for group in best[-1][1]:
        found = [_cluster(group, depth)] if len(group) > 1 else [_cluster([*group, room], depth) for room in wider]
        taken = min((each for each in found if each is not None), key=lambda each: each[0], default=None)
        if taken is not None:
            blocks.append(taken[1])
            wider = [room for room in wider if not any(room is other for other in taken[1].fronts())]
    return blocks


_MOST_SERVICE = 24.0
"""Greatest area of a room that may lie at a side passage, square metres."""

_ALONE = 4.0
"""Price of a room that is left for the corner of another, in units of a room's long side to its short one."""


def _cluster(rooms: Sequence[PlannedRoom], depth: float) -> tuple[float, Block] | None:
    """Return a block of rooms around a passage and its price; none where one would be too long or narrow."""
    host, *smalls = sorted(rooms, key=lambda room: -room.area)
    block = Block(host, tuple(smalls))
    width = cluster_width(_wishes(block), depth)
    laid = cluster_layout(_wishes(block), width, depth)
    if laid.price > _LONGEST_AT_PASSAGE:
        return None
    passage = width * depth - sum(room.area for room in rooms)
    least = width if any(_is_wide(room) for room in rooms) else 0.9 * width
    return laid.price, msgspec.structs.replace(block, passage=passage, least=least)


def _wishes(block: Block) -> tuple[Wish, ...]:
    """Return what the rooms around a passage ask for."""
    wishes = []
    for room in block.fronts():
        short, long = sorted(least_sides(room))
        if not _is_wide(room):
            short = max(short, min(_SHORT_SIDE, (room.area / 1.6) ** 0.5))
        wishes.append(Wish(round(room.area, 6), short, long))
    return tuple(wishes)


_SHORT_SIDE = 1.6
"""Least short side of a room at a passage, metres; less for a very small one."""


def passage_of(block: Block, width: float, depth: float) -> Box | None:
    """Return the passage of a block in ``width x depth``, in the local frame; none where it has none."""
    return _laid_cluster(block, width, depth).passage if block.passage else None


def _laid_cluster(block: Block, width: float, depth: float) -> Cluster:
    return cluster_layout(_wishes(block), round(width, 9), round(depth, 9))


_NARROW = 1.9
"""Width below which a room is too narrow for the whole depth of a band, metres."""

_HOST_FRONT = 1.9
"""Least front of a room beside the small ones in its corner, metres."""


def _is_narrow(room: PlannedRoom, depth: float) -> bool:
    """Whether a room of a band's whole depth is too narrow; one that wants no window need not reach the outer wall."""
    width = room.area / depth
    return width < _NARROW or (not room.kind.daylight and width < depth / STRIP)


_WINDOWED = 2.5
"""Least width of a room of a band's whole depth that must have a window, metres."""

_SLENDER = 0.88 * STRIP
"""Greatest ratio of depth to width of such a room, which may still be laid somewhat smaller."""


def _wide_enough(room: PlannedRoom, depth: float) -> PlannedRoom:
    """Return a room that must have a window with the area to reach the outer wall, where its limits allow it."""
    area = min(max(_WINDOWED, depth / _SLENDER) * depth, room.most)
    must = needs_outer_wall(room.kind) and not room.fixed and not room.suite
    if not must or not _is_narrow(room, depth) or area < _WINDOWED * depth:
        return room
    return msgspec.structs.replace(room, area=area)


def of_full_depth(
    rooms: Sequence[PlannedRoom], beside: Sequence[PlannedRoom], depth: float, pairs: Sequence[tuple[str, str]]
) -> list[PlannedRoom]:
    """Return the rooms, those that are to be beside one that closes the bar with the area for a band's whole depth.

    In the corner of another room they would not reach its wall.

    Parameters
    ----------
    beside : sequence of PlannedRoom
        Rooms that close the bar.
    """
    partners = {other for pair in pairs for one, other in (pair, pair[::-1]) for room in beside if room.called(one)}
    width = max(_NARROW, depth / STRIP) + 0.02
    return [
        msgspec.structs.replace(room, area=min(max(room.area, width * depth), room.most))
        if not room.fixed and any(room.called(name) for name in partners)
        else room
        for room in rooms
    ]


_BEHIND = 1.2
"""Least depth of a host behind the small room in its front corner, metres."""


def _fits_in_front(room: PlannedRoom, depth: float) -> bool:
    """Whether a room that is to be long leaves its host the floor behind it, where they share a band."""
    return not _is_wide(room) or depth - least_sides(room)[1] >= _BEHIND


def _spare_front(block: Block, depth: float) -> float:
    width = block.gross / depth
    return width - sum(room.area / _front_depth(room.area, depth) for room in block.smalls)


_WHOLE = 12.0
"""Price of cutting a corner from a room that is only useful as a rectangle; above that of parting wished neighbours."""


def _fit(block: Block, room: PlannedRoom, depth: float, pairs: Sequence[tuple[str, str]]) -> float:
    """Prefer hosts of kindred use with room to spare; toilets go together, so that they carve up one room alone."""
    same_zone = block.host.kind.zone == room.kind.zone
    others = len(block.smalls)
    if room.kind.toilet and not block.host.fixed and any(small.kind.toilet for small in block.smalls):
        others = -others
    wanted = room.kind.name in block.host.kind.near or block.host.kind.name in room.kind.near
    asked = any(
        (block.host.called(one) and room.called(other)) or (block.host.called(other) and room.called(one))
        for one, other in pairs
    )
    garage = "garage" in (block.host.kind.name, block.host.kind.counts_as)
    clean = not garage and not (room.kind.wet and "kitchen" in block.host.kind.name)
    return (
        3.0 * wanted
        + 8.0 * asked
        + 2.0 * clean
        + 0.5 * same_zone
        - 2.0 * others
        - (_WHOLE if block.host.kind.whole else 0.0)
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
    if block.passage:
        rooms = _laid_cluster(block, width, depth).rooms
        return [(room, [box]) for room, box in zip(block.fronts(), rooms)]
    scale = width * depth / block.gross
    placed: list[tuple[PlannedRoom, list[Box]]] = []
    x = 0.0
    corner_boxes: list[Box] = []
    for number, room in enumerate(block.smalls):
        front, least = least_sides(room)
        high = max(_front_depth(room.area * scale, depth), min(least, depth - _BEHIND))
        high = high if _fits_in_front(room, depth) else depth
        after = sum(least_sides(other)[0] for other in (*block.smalls[number + 1 :], block.host))
        wide = min(max(room.area * scale / high, front), max(width - x - after, 0.5))
        high = min(high, max(room.area * scale / wide, least)) if high < depth else depth
        corner_boxes.append((x, 0.0, x + wide, high))
        placed.append((room, [(x, 0.0, x + wide, high)]))
        x += wide
    if block.smalls:
        boxes = [(x, 0.0, width, depth)]
        boxes += [(box[0], box[3], box[2], depth) for box in corner_boxes if box[3] < depth - 0.01]
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
    if width - wide < DOOR and (width - DOOR) * _DEEPEST_BATH * depth >= area and width - DOOR >= _NARROWEST_BATH:
        wide = width - DOOR
        high = area / wide
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


_NARROWEST_BATH, _DEEPEST_BATH = 1.7, 0.5
"""Least width of a bath in the front corner of a narrow room, metres, and its greatest share of the depth."""


def _lay_columns(host: PlannedRoom, width: float, depth: float, scale: float) -> list[tuple[PlannedRoom, list[Box]]]:
    """The host as a slab of full depth between two columns of its children, a balcony in its outer corner."""
    balcony = next((room for room in host.suite if is_class(room.kind.name, "outdoor")), None)
    children = sorted((room for room in host.suite if room is not balcony), key=lambda room: -room.gross)
    columns: tuple[list[PlannedRoom], list[PlannedRoom]] = ([], [])
    if len(host.suite) <= 3:
        columns[1].extend(children)
    else:
        for child in children:
            sums = [sum(room.gross for room in column) for column in columns]
            columns[0 if sums[0] <= sums[1] else 1].append(child)
    placed: list[tuple[PlannedRoom, list[Box]]] = []
    wide = [sum(room.gross for room in column) * scale / depth for column in columns]
    least = [max(map(_least_across, column), default=0.0) for column in columns]
    across = _least_across(host) if balcony is None else _lit_by(host.area * scale) + _LOGGIA[0]
    wide = widened([*wide, width - sum(wide)], [*least, across])[:2]
    slab = (wide[0], 0.0, width - wide[1], depth)
    placed += [(host, [slab])] if balcony is None else _with_loggia(host, slab, balcony, balcony.gross * scale)
    for number, column in enumerate(columns):
        x0, x1 = (0.0, wide[0]) if number == 0 else (width - wide[1], width)
        y = 0.0
        ordered = sorted(column, key=_inner_first)
        whole = sum(child.gross for child in ordered) or 1.0
        rises = widened([depth * child.gross / whole for child in ordered], [_least_across(room) for room in ordered])
        for child, high in zip(ordered, rises):
            placed.append((child, [(x0, y, x1, y + high)]))
            y += high
    return placed


_ONE_WINDOW, _TWO_WINDOWS = 2.4, 4.7
"""Outer wall that a balcony leaves to the room in whose corner it lies, metres."""

_LIT_BY_ONE = 28.0
"""Area of a room for which one window is enough, square metres."""

_LOGGIA = (1.6, 2.4)
"""Least and greatest depth of such a balcony, metres."""


def _inner_first(room: PlannedRoom) -> tuple[int, str]:
    """Return where a room of a column comes: what wants no window lies inside, what must have one at the outer wall."""
    if is_class(room.kind.name, "outdoor"):
        return 3, room.id
    if not room.kind.wet:
        return (2 if room.kind.daylight else 1), room.id
    return int(room.kind.daylight), room.id


def _lit_by(area: float) -> float:
    """Return how much outer wall the windows of a room of some square metres need, metres."""
    return _ONE_WINDOW if area <= _LIT_BY_ONE else _TWO_WINDOWS


def _with_loggia(
    host: PlannedRoom, slab: Box, balcony: PlannedRoom, area: float
) -> list[tuple[PlannedRoom, list[Box]]]:
    """Return a slab from the corridor to the outer wall with a balcony in its outer corner."""
    x0, y0, x1, y1 = slab
    deep = min(max((area / 1.8) ** 0.5, _LOGGIA[0]), _LOGGIA[1])
    beside = _lit_by((x1 - x0) * (y1 - y0) - area)
    wide = max(min(area / deep, x1 - x0 - beside), LEAST_FRONT)
    corner = (x0, y1 - deep, x0 + wide, y1)
    return [(host, [(x0, y0, x1, y1 - deep), (x0 + wide, y1 - deep, x1, y1)]), (balcony, [corner])]


def _least_across(room: PlannedRoom) -> float:
    """Return the least width of a room of a suite, metres: people who live or sleep in it have more than a door's."""
    norm = load_norms().rules["room_dimension"]
    return norm.figure + _WALL if _is_of(room.kind, norm) else LEAST_FRONT
