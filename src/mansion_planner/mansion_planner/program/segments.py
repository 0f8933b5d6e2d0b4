"""Distribute blocks over the stretches of band along the corridors, and scale them to fill each stretch."""

from dataclasses import dataclass, field

from mansion_planner.program.blocks import Block
from mansion_planner.program.model import Box, Massing, PlannedRoom, Wing

__all__ = ["Segment", "fill_segments", "front_order"]


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
        """Return each block with its place along the corridor; blocks of fixed area keep their width where others can give."""
        wishes = [block.gross / self.depth for block in self.blocks]
        if not wishes:
            return []
        fixed = sum(w for w, block in zip(wishes, self.blocks) if block.fixed)
        loose = sum(wishes) - fixed
        spare = self.length - fixed
        keep = loose > 0 and 0.6 * loose <= spare <= 2.5 * loose
        everyone = self.length / sum(wishes)
        placed, x = [], self.begin
        for wish, block in zip(wishes, self.blocks):
            width = wish * (everyone if not keep else 1.0 if block.fixed else spare / loose)
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


def fill_segments(segments: list[Segment], blocks: list[Block]) -> None:
    """Put each block into a segment, so that the segments are filled in equal measure."""
    total = sum(block.gross for block in blocks)
    room = sum(segment.length * segment.depth for segment in segments)
    scale = room / total if total > 0 else 1.0
    for block in blocks:
        segment = min(
            segments,
            key=lambda s: (
                (s.used * scale + block.gross * scale / s.depth) > s.length * 1.06,
                s.bar != "main",
                s.used / s.length if s.bar == "main" else s.used / s.length,
            ),
        )
        segment.blocks.append(block)
    _balance(segments, scale)


def _imbalance(segments: list[Segment], scale: float) -> float:
    """Sum of squared misfit of the segments, with a heavy price for an empty one."""
    total = 0.0
    for segment in segments:
        ratio = segment.used * scale / segment.length
        total += (ratio - 1.0) ** 2 * segment.length + (50.0 if not segment.blocks else 0.0)
    return total


def _balance(segments: list[Segment], scale: float) -> None:
    """Move or swap blocks between segments while that evens them out."""
    best = _imbalance(segments, scale)
    for _ in range(24):
        improved = False
        for a in segments:
            for b in segments:
                if a is not b:
                    best, moved = _improve_pair(segments, a, b, scale, best)
                    improved = improved or moved
        if not improved:
            return


def _improve_pair(
    segments: list[Segment], a: Segment, b: Segment, scale: float, best: float
) -> tuple[float, bool]:
    for i, block in enumerate(a.blocks):
        a.blocks.pop(i)
        b.blocks.append(block)
        cost = _imbalance(segments, scale)
        if cost < best - 1e-6:
            return cost, True
        b.blocks.pop()
        a.blocks.insert(i, block)
        for j in range(len(b.blocks)):
            a.blocks[i], b.blocks[j] = b.blocks[j], a.blocks[i]
            cost = _imbalance(segments, scale)
            if cost < best - 1e-6:
                return cost, True
            a.blocks[i], b.blocks[j] = b.blocks[j], a.blocks[i]
    return best, False
