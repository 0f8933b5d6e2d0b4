"""Rigid units: a copy of an anchor together with the members that have a fixed place in its frame.

A slot is ``(x, y, degrees)``: centre and rotation of a member where the anchor's centre is the origin, its front +y.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import product
from typing import TypeAlias

import numpy as np

from mansion_geometry.boxes import boxes_overlap, unit_vector
from mansion_geometry.compiled import Floats
from mansion_scene.placement.groups import Spec

__all__ = [
    "BACK",
    "Slot",
    "Unit",
    "UnitStyle",
    "around_slots",
    "build_unit",
    "front_slots",
    "near_slots",
    "paired_slot",
    "side_slots",
]

Slot: TypeAlias = tuple[float, float, float]
Size: TypeAlias = tuple[float, float]

SIDE_GAP = 0.05
"""Gap between objects that are placed side by side as one, metres."""


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


def behind_slots(anchor: Size, member: Size, count: int, *, gap: float) -> list[Slot]:
    """Return places of up to `count` seats in a row behind the anchor, each facing it."""
    y = -(anchor[1] + member[1]) / 2 - gap
    return [((2 * i + 1 - count) * anchor[0] / (2 * count), y, 0.0) for i in range(count)]


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


Size3 = tuple[float, float, float]

BACK = 0.14
"""How far the back of an edge object may be from its wall, metres."""


@dataclass(frozen=True)
class UnitStyle:
    """How a unit is composed.

    Attributes
    ----------
    links : frozenset of str
        Links whose members belong to the unit.
    mirrored : bool
        Whether left and right are exchanged.
    long_sides : bool
        Whether seats are placed on two opposite sides only.
    gap : float
        Gap between a seat and its table or desk, metres.
    """

    links: frozenset[str] = frozenset({"paired", "around", "in_front_of", "side_of", "near"})
    mirrored: bool = False
    long_sides: bool = False
    gap: float = 0.08


@dataclass(frozen=True)
class Unit:
    """Rigid parts in the frame of the first.

    Attributes
    ----------
    parts : tuple of 8-tuples
        Boxes with height and how far their back may be from a wall (0: anywhere); the anchor first, at the origin.
    specs : tuple of int
        Index of each part's object.
    hosts : tuple of int
        Index of each part's host among the parts, -1 for the anchor.
    sizes : tuple of (float, float, float)
    """

    parts: tuple[tuple[float, ...], ...] = ()
    specs: tuple[int, ...] = ()
    hosts: tuple[int, ...] = ()
    sizes: tuple[Size3, ...] = ()

    def array(self) -> Floats:
        """Return the parts as an array, shape (k, 8)."""
        return np.array(self.parts).reshape(-1, 8)

    def extent(self) -> tuple[float, float, float, float]:
        """Return (x min, x max, y min, y max) of all parts."""
        p = self.array()
        ex = np.abs(p[:, 2]) * p[:, 4] + np.abs(p[:, 3]) * p[:, 5]
        ey = np.abs(p[:, 3]) * p[:, 4] + np.abs(p[:, 2]) * p[:, 5]
        return (
            float((p[:, 0] - ex).min()),
            float((p[:, 0] + ex).max()),
            float((p[:, 1] - ey).min()),
            float((p[:, 1] + ey).max()),
        )

    def freed(self) -> "Unit":
        """Return the unit with no back that must be at a wall."""
        return replace(self, parts=tuple((*part[:7], 0.0) for part in self.parts))

    def with_part(self, spec: Spec, size: Size3, slot: Slot, host: int) -> "Unit | None":
        """Return the unit with one part more, at a slot in the frame of part `host`; None where it overlaps another."""
        x, y, degrees = slot
        ux, uy = unit_vector(degrees)
        if host >= 0:
            base = self.parts[host]
            x, y = base[0] + x * base[2] - y * base[3], base[1] + x * base[3] + y * base[2]
            ux, uy = ux * base[2] - uy * base[3], ux * base[3] + uy * base[2]
        back = BACK if spec.where == "edge" else 0.0
        part = (x, y, ux, uy, size[0] / 2, size[1] / 2, size[2], back)
        box = np.array(part[:6])
        if any(boxes_overlap(box, np.array(other[:6]), 0.0) for other in self.parts):
            return None
        return Unit((*self.parts, part), (*self.specs, spec.index), (*self.hosts, host), (*self.sizes, size))


def build_unit(
    spec: Spec, size: Size3, shares: Mapping[int, int], children: Mapping[int, list[Spec]], style: UnitStyle
) -> Unit:
    """Compose one copy of `spec` with its share of the members.

    Parameters
    ----------
    spec : Spec
    size : size of the copy
    shares : mapping of object index to count
        How many copies of each member belong to this unit.
    children : mapping of object index to its members
    style : UnitStyle
    """
    alone = Unit().with_part(spec, size, (0.0, 0.0, 0.0), -1)
    assert alone is not None
    return _with_members(alone, 0, spec, shares, children, style)


def _with_members(
    unit: Unit, at: int, spec: Spec, shares: Mapping[int, int], children: Mapping[int, list[Spec]], style: UnitStyle
) -> Unit:
    """Return the unit with the members of its part number `at`, and theirs, as far as they find slots."""
    backed = spec.where == "edge"
    for child in children.get(spec.index, ()):
        wanted = shares.get(child.index, 0)
        if not wanted or child.link not in style.links:
            continue
        added = 0
        for slot in _slots(spec, unit.sizes[at], child, wanted, style, backed=backed):
            if added == wanted:
                break
            grown = unit.with_part(child, child.size, slot, at)
            if grown is not None:
                added += 1
                unit = _with_members(grown, len(grown.parts) - 1, child, shares, children, style)
    return unit


def _slots(spec: Spec, size: Size3, child: Spec, count: int, style: UnitStyle, *, backed: bool) -> list[Slot]:
    anchor, member = size[:2], child.size[:2]
    seat = child.role.seat
    at_wall = child.where == "edge"
    if child.link == "paired":
        if at_wall and not backed:
            return []
        beside = at_wall or spec.role.bed
        return [paired_slot(anchor, member, beside=beside, mirrored=style.mirrored, gap=style.gap)]
    if child.link == "side_of":
        return (
            side_slots(anchor, member, count, backed=backed, mirrored=style.mirrored) if backed or not at_wall else []
        )
    if child.link == "near" and at_wall and backed:
        return side_slots(anchor, member, 2, backed=True, mirrored=style.mirrored)
    if at_wall:
        return []
    if child.link == "around":
        return around_slots(anchor, member, count, backed=backed, gap=style.gap, long_sides=style.long_sides)
    if child.link == "in_front_of":
        touching = child.role.sofa or child.role.symmetric
        return front_slots(anchor, member, count, seat=seat, touching=touching, gap=style.gap)
    slots = list(near_slots(anchor, member, seat=seat, backed=backed, mirrored=style.mirrored))
    if seat and spec.role.staffed and not backed:
        return [*behind_slots(anchor, member, count, gap=style.gap), *slots]
    return slots
