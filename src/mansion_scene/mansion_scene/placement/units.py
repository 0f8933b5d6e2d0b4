"""Rigid units: a copy of an anchor together with the members that have a fixed place in its frame."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from mansion_geometry.boxes import boxes_overlap, unit_vector
from mansion_scene.placement.groups import Spec
from mansion_scene.placement.slots import Slot, around_slots, front_slots, near_slots, paired_slot, side_slots

__all__ = ["Unit", "UnitStyle", "build_unit"]

Floats = npt.NDArray[np.float64]
Size3 = tuple[float, float, float]

_BACK = 0.14
"""How far the back of an edge object may be from its wall, metres."""


@dataclass(frozen=True)
class UnitStyle:
    """How a unit is composed.

    Attributes
    ----------
    links : frozenset of str
        Which links to compose.
    mirrored : bool
        Left and right exchanged.
    long_sides : bool
        Seats on two opposite sides only.
    gap : float
        Between a seat and the table or desk it belongs to, metres.
    """

    links: frozenset[str] = frozenset({"paired", "around", "in_front_of", "side_of", "near"})
    mirrored: bool = False
    long_sides: bool = False
    gap: float = 0.08


@dataclass
class Unit:
    """Rigid parts in the frame of the first.

    Attributes
    ----------
    parts : list of 8-tuples
        Boxes with height and how far their back may be from a wall (0: anywhere); the anchor first, at the origin.
    specs : list of int
    hosts : list of int
        Index of each part's host among the parts, -1 for the anchor.
    sizes : list of sizes
    """

    parts: list[tuple[float, ...]] = field(default_factory=list)
    specs: list[int] = field(default_factory=list)
    hosts: list[int] = field(default_factory=list)
    sizes: list[Size3] = field(default_factory=list)

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

    def add(self, spec: Spec, size: Size3, slot: Slot, host: int) -> bool:
        """Add a part at a slot in the frame of part `host` unless it overlaps another."""
        x, y, degrees = slot
        ux, uy = unit_vector(degrees)
        if host >= 0:
            base = self.parts[host]
            x, y = base[0] + x * base[2] - y * base[3], base[1] + x * base[3] + y * base[2]
            ux, uy = ux * base[2] - uy * base[3], ux * base[3] + uy * base[2]
        back = _BACK if spec.where == "edge" else 0.0
        part = (x, y, ux, uy, size[0] / 2, size[1] / 2, size[2], back)
        box = np.array(part[:6])
        if any(boxes_overlap(box, np.array(other[:6]), 0.0) for other in self.parts):
            return False
        self.parts.append(part)
        self.specs.append(spec.index)
        self.hosts.append(host)
        self.sizes.append(size)
        return True


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
    unit = Unit()
    unit.add(spec, size, (0.0, 0.0, 0.0), -1)
    _add_members(unit, 0, spec, shares, children, style)
    return unit


def _add_members(
    unit: Unit, at: int, spec: Spec, shares: Mapping[int, int], children: Mapping[int, list[Spec]], style: UnitStyle
) -> None:
    backed = spec.where == "edge"
    for child in children.get(spec.index, ()):
        wanted = shares.get(child.index, 0)
        if not wanted or child.link not in style.links:
            continue
        added = 0
        for slot in _slots(spec, unit.sizes[at], child, wanted, backed, style):
            if added == wanted:
                break
            if unit.add(child, child.size, slot, at):
                added += 1
                _add_members(unit, len(unit.parts) - 1, child, shares, children, style)


def _slots(spec: Spec, size: Size3, child: Spec, count: int, backed: bool, style: UnitStyle) -> list[Slot]:
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
    return list(near_slots(anchor, member, seat=seat, backed=backed, mirrored=style.mirrored))
