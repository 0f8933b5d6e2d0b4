"""Places of members in their anchor's frame: the chair at a desk, seats around a table, nightstands beside a bed.

A slot is ``(x, y, degrees)``: the member's centre and rotation where the anchor's centre is the origin and its
front +y.
"""

from collections.abc import Iterator
from functools import lru_cache
from itertools import product
from typing import TypeAlias

__all__ = ["Slot", "around_slots", "front_slots", "near_slots", "paired_slot", "side_slots"]

Slot: TypeAlias = tuple[float, float, float]
Size: TypeAlias = tuple[float, float]

SIDE_GAP = 0.05
"""Between things that stand side by side as one, metres."""


def paired_slot(anchor: Size, member: Size, *, beside: bool, mirrored: bool, gap: float) -> Slot:
    """Return the accessory's place: before the front, facing it, or beside it with the backs in one line."""
    if beside:
        x = (anchor[0] + member[0]) / 2 + SIDE_GAP
        return (-x if mirrored else x), (member[1] - anchor[1]) / 2, 0.0
    return 0.0, (anchor[1] + member[1]) / 2 + gap, 180.0


def _spread(count: int, length: float) -> list[float]:
    """Return `count` places evenly along a side, centred."""
    return [length * ((i + 0.5) / count - 0.5) for i in range(count)]


@lru_cache(maxsize=512)
def _around_counts(n: int, caps: tuple[int, int, int, int], size: Size) -> tuple[int, ...]:
    """Share `n` seats among front, back, right and left: even spacing first, then symmetry."""
    best: tuple[float, tuple[int, ...]] | None = None
    lengths = (size[0], size[0], size[1], size[1])
    for counts in product(*(range(min(cap, n) + 1) for cap in caps)):
        if sum(counts) != n:
            continue
        pitch = [length / c for length, c in zip(lengths, counts) if c]
        uneven = abs(counts[0] - counts[1]) + abs(counts[2] - counts[3])
        # People sit along the long sides before they sit at the ends.
        ends = sum(c for c, length in zip(counts, lengths) if length < max(size) - 0.05)
        rank = (-min(min(pitch, default=0.0), 0.75) + 0.2 * uneven + 0.02 * ends, counts)
        if best is None or rank < best:
            best = rank
    return best[1] if best else ()


def around_slots(
    anchor: Size, member: Size, count: int, *, backed: bool, gap: float, long_sides: bool = False
) -> list[Slot]:
    """Return places of up to `count` seats around a table, each facing it.

    Parameters
    ----------
    backed : bool
        The anchor's back is at a wall: nobody sits there.
    gap : float
        Between a seat and the table, metres.
    long_sides : bool
        Use only the two sides along the width (or, where backed, the front).
    """
    pitch = member[0] + 0.04
    if long_sides and count > int((anchor[0] + 0.06) / pitch) * (1 if backed else 2):
        long_sides = False
    along, across = (max(1, int((length + 0.06) / pitch)) for length in anchor)
    if long_sides:
        caps = (along, 0 if backed else along, 0, 0)
    else:
        caps = (along, 0 if backed else along, across, across)
    counts = _around_counts(min(count, sum(caps)), caps, anchor)
    x, y = (anchor[0] + member[1]) / 2 + gap, (anchor[1] + member[1]) / 2 + gap
    slots: list[Slot] = []
    if counts:
        slots += [(t, y, 180.0) for t in _spread(counts[0], anchor[0])]
        slots += [(t, -y, 0.0) for t in _spread(counts[1], anchor[0])]
        slots += [(x, t, 90.0) for t in _spread(counts[2], anchor[1])]
        slots += [(-x, t, 270.0) for t in _spread(counts[3], anchor[1])]
    return slots


def front_slots(anchor: Size, member: Size, count: int, *, seat: bool, touching: bool, gap: float) -> list[Slot]:
    """Return places before the anchor's front, in rows no wider than the anchor; seats face it.

    Parameters
    ----------
    seat : bool
        People sit there, facing the anchor.
    touching : bool
        It belongs right at the anchor (a bench at the foot of a bed); else legs fit between.
    """
    gap = gap if seat or touching else 0.35
    row = max(1, int((anchor[0] + 0.06) / (member[0] + 0.04)))
    slots: list[Slot] = []
    y = anchor[1] / 2
    while len(slots) < count:
        here = min(row, count - len(slots))
        y += gap + member[1]
        slots += [(x, y - member[1] / 2, 180.0 if seat else 0.0) for x in _spread(here, anchor[0])]
    return slots


def side_slots(anchor: Size, member: Size, count: int, *, backed: bool, mirrored: bool) -> list[Slot]:
    """Return places beside the anchor, in turn on either side, outward; backs in line where `backed`."""
    y = (member[1] - anchor[1]) / 2 if backed else 0.0
    slots: list[Slot] = []
    for i in range(count):
        x = (anchor[0] + member[0]) / 2 + SIDE_GAP + (i // 2) * (member[0] + SIDE_GAP)
        left = (i % 2 == 1) != mirrored
        slots.append((-x if left else x, y, 0.0))
    return slots


def near_slots(anchor: Size, member: Size, *, seat: bool, backed: bool, mirrored: bool) -> Iterator[Slot]:
    """Yield places near the anchor, the most usual first: beside it from back to front, then before it."""
    signs = (-1.0, 1.0) if mirrored else (1.0, -1.0)
    turned = member[::-1] if seat else member
    for gap in (SIDE_GAP if not seat else 0.15, 0.3, 0.5):
        for sign in signs:
            x = sign * ((anchor[0] + turned[0]) / 2 + gap)
            spare = (anchor[1] - turned[1]) / 2
            for y in (-spare, 0.0, spare) if not seat else (0.0, spare, -spare):
                yield x, y, (90.0 * sign) % 360.0 if seat else 0.0
        yield 0.0, (anchor[1] + member[1]) / 2 + gap, 180.0 if seat else 0.0
        if not backed:
            yield 0.0, -(anchor[1] + member[1]) / 2 - gap, 0.0
