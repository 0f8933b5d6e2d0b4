"""Lay rooms out in bands along corridors: the stretches of band that blocks of rooms are distributed over."""

from collections.abc import Collection, Sequence

import msgspec

from mansion_planner.program.blocks import Block
from mansion_planner.program.model import Box, Massing, PlannedRoom, Storey, Wing
from mansion_planner.program.widths import widened

__all__ = [
    "Place",
    "Segment",
    "bring_to_end",
    "bring_together",
    "fill_segments",
    "front_order",
    "misfit_of_exchange",
    "rooms_at_door",
    "with_central",
    "with_door_first",
    "with_rows",
]

Place = tuple[int, int]
"""Number of a segment, and of a block in it."""

_BESIDE_NICHE = 2.0
"""Least metres of corridor of a room that also has the floor behind lifts."""


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
    behind : float
        Square metres of floor beside its beginning that its first room also has.
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
    behind: float = 0.0

    @property
    def length(self) -> float:
        """Metres along the corridor."""
        return self.end - self.begin

    @property
    def used(self) -> float:
        """Metres that its blocks wish for."""
        return sum(self._wishes())

    def _wishes(self) -> list[float]:
        """Return the metres that each block wishes for; the first has a part of its area elsewhere."""
        wishes = [block.gross / self.depth for block in self.blocks]
        if wishes and self.behind:
            wishes[0] = max(wishes[0] - self.behind / self.depth, min(wishes[0], _BESIDE_NICHE))
        return wishes

    def laid(self) -> list[tuple[Block, float, float]]:
        """Return each block with its place along the corridor; fixed areas keep their width where others can give."""
        wishes = self._wishes()
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


_AT_THE_DOOR = frozenset(
    "reception ticket_office concession_stand service_counter check_in_hall waiting_room cloakroom".split()
)
"""Rooms that visitors come to first."""

_OF_CULTURE = frozenset({"shop", "cafe"})
"""Rooms of a museum or theatre beside its entrance, which people also come to for themselves."""


def rooms_at_door(storey: Storey, pairs: Sequence[tuple[str, str]]) -> frozenset[str]:
    """Return the types and names of the rooms of a public building that lie beside its entrance.

    Parameters
    ----------
    storey : Storey
    pairs : sequence of (str, str)
        Rooms that are to be side by side: one that is to be beside the lobby is beside the entrance.
    """
    if storey.role not in ("single", "ground") or storey.use.family == "home":
        return frozenset()
    hubs = {storey.hub.name, "lobby", "entrance_hall"}
    asked = {one for pair in pairs for one, other in (pair, pair[::-1]) if other in hubs and one not in hubs}
    return _AT_THE_DOOR | asked | (_OF_CULTURE if storey.use.family == "culture" else frozenset())


def front_order(rooms: Sequence[PlannedRoom], at_door: Collection[str] = ()) -> list[PlannedRoom]:
    """Order rooms from the cores outwards: wet rooms (stacked from storey to storey), public, service, private.

    Showers are with the changing rooms that they belong to, where a storey has those. Rooms of a type or name of
    `at_door` come before all.
    """
    zones = {"circulation": 0, "public": 1, "service": 2, "private": 3}
    fixed = {room.kind.name for room in rooms if not room.kind.stack}

    def rank(room: PlannedRoom) -> tuple[int, int]:
        if any(room.called(name) for name in at_door):
            return (-1, 0)
        if room.kind.stack and (room.kind.toilet or fixed.isdisjoint(room.kind.near)):
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


def bring_to_end(
    segments: Sequence[Segment], stop: float, ends: Sequence[PlannedRoom], pairs: Sequence[tuple[str, str]]
) -> list[Segment]:
    """Return the segments, a block that is to be beside a room which closes the bar last in a stretch that ends there.

    Parameters
    ----------
    stop : float
        Where the rooms that close the bar begin, along the main corridor.
    ends : sequence of PlannedRoom
        Those rooms; none where the corridor runs to the end.
    pairs : sequence of (str, str)
        Room types that are to be side by side, the most wanted last.
    """
    partners = [
        other for pair in pairs for one, other in (pair, pair[::-1]) if ends and ends[0].called(one) and one != other
    ]
    rows = [list(segment.blocks) for segment in segments]
    for name in dict.fromkeys(reversed(partners)):
        for row, segment in zip(rows, segments):
            place = next((i for i, block in enumerate(row) if _holds(block, name)), None)
            if place is not None and segment.bar == "main" and abs(segment.end - stop) < 0.01:
                row.append(row.pop(place))
                return with_rows(segments, rows)
    return list(segments)


def with_door_first(segments: Sequence[Segment], at_door: Collection[str]) -> list[Segment]:
    """Return the segments, a stretch of the main corridor turned round whose rooms beside the entrance lie far from it.

    Neighbours stay neighbours.
    """
    rows = []
    for segment in segments:
        row = list(segment.blocks)
        places = [number for number, block in enumerate(row) if any(_holds(block, name) for name in at_door)]
        far = bool(places) and sum(places) > len(places) * (len(row) - 1) / 2
        rows.append(row[::-1] if far and segment.bar == "main" else row)
    return with_rows(segments, rows)


_CENTRAL, _SERVED = frozenset({"nurse_station"}), frozenset({"patient_room", "resident_room", "hospital_ward"})
"""Rooms from which others are watched, and those others."""

_FEW_SERVED = 3
"""Rooms that are watched from anywhere beside them."""


def with_central(segments: Sequence[Segment]) -> list[Segment]:
    """Return the segments, a room from which others are watched in the middle of those that its stretch has."""
    rows = []
    for segment in segments:
        row = list(segment.blocks)
        central = [block for block in row if block.host.kind.name in _CENTRAL]
        served = [number for number, block in enumerate(row) if block.host.kind.name in _SERVED]
        if len(central) == 1 and len(served) >= _FEW_SERVED:
            middle = row[served[len(served) // 2]]
            row.remove(central[0])
            row.insert(row.index(middle), central[0])
        rows.append(row)
    return with_rows(segments, rows)


def with_rows(segments: Sequence[Segment], rows: Sequence[Sequence[Block]]) -> list[Segment]:
    """Return the segments with a row of blocks for each."""
    return [msgspec.structs.replace(segment, blocks=tuple(row)) for segment, row in zip(segments, rows)]


def _places_of(segments: Sequence[Segment], name: str) -> list[Place]:
    return [
        (s, i) for s, segment in enumerate(segments) for i, block in enumerate(segment.blocks) if _holds(block, name)
    ]


def _best_swap(
    segments: Sequence[Segment], places: Sequence[Place], goals: Sequence[Place]
) -> tuple[Place, Place, int] | None:
    """Return which block goes to the segment of which other, and the number there of the one that it changes with.

    Its segments are as full after the exchange as before, or nearly so; ``None`` where no exchange does that.
    """
    options = [
        (misfit_of_exchange(segments, (s, i), (t, k)), n, m, k)
        for n, (s, i) in enumerate(places) for m, (t, j) in enumerate(goals)
        for k in range(len(segments[t].blocks)) if k != j
    ]  # fmt: skip
    options += [
        (misfit_of_exchange(segments, (s, k), (t, j)), n, -1 - m, k)
        for n, (s, i) in enumerate(places) for m, (t, j) in enumerate(goals)
        for k in range(len(segments[s].blocks)) if k != i
    ]  # fmt: skip
    best = min(options, default=None)
    if best is None or best[0] > 0.3:
        return None
    _, n, m, k = best
    return (places[n], goals[m], k) if m >= 0 else (goals[-1 - m], places[n], k)


def misfit_of_exchange(segments: Sequence[Segment], one: Place, other: Place) -> float:
    """How far the worse of two segments is from full after they exchange a block, as a share of its length."""
    s, t = segments[one[0]], segments[other[0]]
    ours, theirs = s.blocks[one[1]], t.blocks[other[1]]
    return max(_misfit(s, ours, theirs), _misfit(t, theirs, ours))


def _misfit(segment: Segment, leaving: Block, coming: Block) -> float:
    """How far a segment is from full after an exchange, as a share of its length."""
    used = segment.used + (coming.gross - leaving.gross) / segment.depth
    return abs(used / segment.length - 1.0)
