"""Distribute blocks over the stretches of band along the corridors, and scale them to fill each stretch."""

from dataclasses import dataclass, field

from mansion_planner.program.blocks import Block, widened
from mansion_planner.program.model import Box, Massing, PlannedRoom, Wing

__all__ = ["Segment", "bring_together", "fill_segments", "front_order"]


@dataclass
class Segment:
    """A stretch of band: from `begin` to `end` along its corridor, `depth` metres deep.

    Attributes
    ----------
    bar : str
        ``main``, or the wing's name.
    north : bool
        On the upper side of the main corridor, or on the right side of a wing's.
    front : float
        Coordinate of the corridor's edge across the bar.
    """

    bar: str
    north: bool
    begin: float
    end: float
    front: float
    depth: float
    wing: Wing | None = None
    blocks: list[Block] = field(default_factory=list)

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


_NEAR_CORE = ("restroom", "accessible_toilet", "shower_area", "janitor_closet", "toilet", "bathroom")


def front_order(rooms: list[PlannedRoom]) -> list[PlannedRoom]:
    """Order rooms from the cores outwards: wet rooms (stacked from storey to storey), public, service, private."""
    zones = {"circulation": 0, "public": 1, "service": 2, "private": 3}

    def rank(room: PlannedRoom) -> tuple[int, int]:
        if room.kind.name in _NEAR_CORE:
            return (0, _NEAR_CORE.index(room.kind.name))
        if room.kind.open:
            return (1, 0)
        return (2 + zones[room.kind.zone], 0)

    return sorted(rooms, key=rank)


def fill_segments(segments: list[Segment], blocks: list[Block], pairs: list[tuple[str, str]] | None = None) -> None:
    """Put each block into a segment, so that the segments are filled in equal measure and rooms are well shaped.

    Parameters
    ----------
    segments : list of Segment
    blocks : list of Block
        In the order from the cores outwards, which each segment keeps.
    pairs : list of (str, str), optional
        Room types that are to be side by side, the most wanted first.
    """
    total = sum(block.gross for block in blocks)
    room = sum(segment.length * segment.depth for segment in segments)
    scale = room / total if total > 0 else 1.0
    share = [_Share(segment, scale) for segment in segments]
    for number, block in enumerate(blocks):
        best = min(
            share,
            key=lambda s: (
                s.overflow(block) > 0.06 * s.segment.length,
                s.filling + 1.5 * shape_cost(block.gross * scale, s.segment.depth),
            ),
        )
        best.add(number, block)
    _balance(share, blocks)
    for entry in share:
        entry.segment.blocks = [blocks[number] for number in sorted(entry.members)]
    for first, second in pairs or []:
        bring_together(segments, first, second)


def shape_cost(area: float, depth: float) -> float:
    """Price of a room of `area` in a band of `depth`: 0 for well-proportioned ones, more for slivers and galleries."""
    width = area / depth
    slender = max(0.0, 0.55 - width / depth)
    stretched = max(0.0, width / depth - 3.0)
    return 2.0 * slender + 0.3 * min(stretched, 2.0)


_Parts = tuple[float, float, float]
_NOTHING: _Parts = (0.0, 0.0, 0.0)


class _Share:
    """A segment while it is filled: member blocks by number, and the metres that they take."""

    def __init__(self, segment: Segment, scale: float) -> None:
        self.segment = segment
        self.scale = scale
        self.members: list[int] = []
        self.used = 0.0
        self.shape = 0.0
        self.rigid = 0.0

    @property
    def filling(self) -> float:
        return self.used / self.segment.length

    def overflow(self, block: Block) -> float:
        return self.used + block.gross * self.scale / self.segment.depth - self.segment.length

    def parts(self, block: Block) -> _Parts:
        """Return metres, shape price and metres of fixed area of a block here."""
        area = block.gross * self.scale
        metres = area / self.segment.depth
        return metres, shape_cost(area, self.segment.depth), metres if block.fixed else 0.0

    def add(self, number: int, block: Block) -> None:
        self.change(self.parts(block), 1.0)
        self.members.append(number)

    def change(self, parts: _Parts, sign: float) -> None:
        """Account for a block that comes (+1) or leaves (-1)."""
        self.used += sign * parts[0]
        self.shape += sign * parts[1]
        self.rigid += sign * parts[2]

    def cost(self, coming: _Parts = _NOTHING, leaving: _Parts = _NOTHING, members: int = 0) -> float:
        """Return the segment's price after a change."""
        length = self.segment.length
        used = self.used + coming[0] - leaving[0]
        rigid = self.rigid + coming[2] - leaving[2]
        price = 3.0 * (used / length - 1.0) ** 2 * length + self.shape + coming[1] - leaving[1]
        loose, spare = used - rigid, length - rigid
        if rigid > 0.01 and not 0.62 * loose <= spare <= 2.4 * loose:
            price += 8.0 * abs(used / length - 1.0) * rigid
        return price + (50.0 if len(self.members) + members <= 0 else 0.0)


def _balance(share: list[_Share], blocks: list[Block]) -> None:
    """Move or swap blocks between segments while that lowers the price."""
    for _ in range(40):
        if not any(_improve(a, b, blocks) for a in share for b in share if a is not b):
            return


def _improve(a: _Share, b: _Share, blocks: list[Block]) -> bool:
    base = a.cost() + b.cost() - 1e-6
    in_b = [(number, b.parts(blocks[number]), a.parts(blocks[number])) for number in b.members]
    for number in a.members:
        here, there = a.parts(blocks[number]), b.parts(blocks[number])
        if a.cost(leaving=here, members=-1) + b.cost(coming=there, members=1) < base:
            _transfer(a, b, number, here, there)
            return True
        for other, other_here, other_there in in_b:
            if a.cost(other_there, here) + b.cost(there, other_here) < base:
                _transfer(a, b, number, here, there)
                _transfer(b, a, other, other_here, other_there)
                return True
    return False


def _transfer(a: _Share, b: _Share, number: int, here: _Parts, there: _Parts) -> None:
    a.members.remove(number)
    a.change(here, -1.0)
    b.members.append(number)
    b.change(there, 1.0)


def _holds(block: Block, name: str) -> bool:
    return block.host.called(name)


def bring_together(segments: list[Segment], first: str, second: str) -> None:
    """Put a block of one type beside one of the other: within its segment, else by a swap with a like block."""
    places = [(s, i) for s in segments for i, block in enumerate(s.blocks) if _holds(block, first)]
    goals = [(s, i) for s in segments for i, block in enumerate(s.blocks) if _holds(block, second)]
    if not places or not goals:
        return
    if any(s is t and abs(i - j) == 1 for s, i in places for t, j in goals):
        return
    for s, i in places:
        for t, j in goals:
            if s is t:
                s.blocks.insert(j, s.blocks.pop(i))
                return
    options = [
        (max(_misfit(s, moving, t.blocks[k]), _misfit(t, t.blocks[k], moving)), n, m, k)
        for n, (s, i) in enumerate(places) for m, (t, j) in enumerate(goals)
        for moving in [s.blocks[i]] for k in range(len(t.blocks)) if k != j
    ]  # fmt: skip
    options += [
        (max(_misfit(s, s.blocks[k], goal), _misfit(t, goal, s.blocks[k])), n, -1 - m, k)
        for n, (s, i) in enumerate(places) for m, (t, j) in enumerate(goals)
        for goal in [t.blocks[j]] for k in range(len(s.blocks)) if k != i
    ]  # fmt: skip
    best = min(options, default=None)
    if best is None or best[0] > 0.3:
        return
    _, n, m, k = best
    (s, i), (t, j) = places[n], goals[m if m >= 0 else -1 - m]
    if m < 0:
        (s, i), (t, j) = (t, j), (s, i)
    s.blocks[i], t.blocks[k] = t.blocks[k], s.blocks[i]
    moved = t.blocks.pop(k)
    t.blocks.insert(j, moved)


def _misfit(segment: Segment, leaving: Block, coming: Block) -> float:
    """How far a segment is from full after an exchange, as a share of its length."""
    used = segment.used + (coming.gross - leaving.gross) / segment.depth
    return abs(used / segment.length - 1.0)
