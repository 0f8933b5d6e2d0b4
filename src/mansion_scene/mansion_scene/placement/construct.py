"""The constructive pass: Algorithm 4 over groups in strict priority order."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from mansion_scene.placement.floor import Floor
from mansion_scene.placement.groups import Group, Spec
from mansion_scene.placement.kitchen_runs import run_members, run_pieces, runs
from mansion_scene.placement.patterns import place_lattice, place_matrix, place_rows
from mansion_scene.placement.search import find_placement
from mansion_scene.placement.units import Size3, Unit, UnitStyle, build_unit
from mansion_scene.placement.vehicle_bays import place_behind_doors

__all__ = ["Construction", "construct"]

_LARGE = 0.6
"""Footprint from which several copies of an unconstrained object are aligned, square metres."""

ENOUGH = 0.7
"""Share of the tables that are placed at least with room to pass behind their seats, before all are pushed together."""

_TIGHT = frozenset({"paired", "around", "in_front_of", "side_of"})

_NOWHERE_ELSE = frozenset({"at_head", "sat_at"})
"""Relations of what is in the way anywhere else."""

_AT_HOST = frozenset({"paired", "around", "in_front_of"})
"""Links of what is of no use without its host."""


@dataclass
class Construction:
    """One construction of a room.

    Attributes
    ----------
    floor : Floor
    children : dict of object index to its members
    rng : numpy.random.Generator
    aisle : float
        Widest aisle that patterns try, metres.
    """

    floor: Floor
    children: dict[int, list[Spec]]
    rng: np.random.Generator
    aisle: float

    def missing(self, spec: Spec) -> int:
        """Return how many copies are not placed yet."""
        return spec.quantity - self.floor.count(spec.index)

    def due(self, spec: Spec) -> int:
        """Return how many of the missing copies have what they stand at: a chair without its table is in the way."""
        wanted = spec.quantity
        seated = spec.link == "near" and spec.role.seat
        if (seated or spec.link in _AT_HOST) and not spec.first:
            host = self.floor.specs[spec.host]
            wanted = min(wanted, -(-wanted * self.floor.count(host.index) // host.quantity))
        return max(wanted - self.floor.count(spec.index), 0)

    def complete(self, specs: Sequence[Spec]) -> bool:
        """Tell whether every copy is placed."""
        return all(self.missing(spec) <= 0 for spec in specs)

    def place_group(self, group: Group) -> None:
        """Place a group: all copies of its anchor, then the members that were not placed with them."""
        anchor = group.anchor
        self._place_run(anchor)
        if anchor.rows:
            self._place_matrix(anchor)
        else:
            self.place_copies(anchor)
        for member in group.members:
            self.place_copies(member)

    def _place_run(self, anchor: Spec) -> None:
        """Place a kitchen's worktops and appliances side by side: as many worktops as fit, the widest first."""
        left = [spec for spec in run_pieces(anchor, self.floor.specs) if self.missing(spec) > 0]
        if not left:
            return
        walls = sorted((wall.length for wall in self.floor.room.walls), reverse=True)
        mirrored = bool(self.rng.integers(2))
        for members, clear in product(run_members(left), (True, False)):
            for unit in runs(anchor, self.missing(anchor), members, walls, mirrored=mirrored):
                if find_placement(self.floor, anchor, unit, self.rng, clear_hob=clear):
                    return

    def place_copies(self, spec: Spec, *, strict: bool = True) -> None:
        """Place the missing copies of an object, each with its share of members."""
        if not strict and not spec.first and any(kind in _NOWHERE_ELSE for kind, _ in spec.relations):
            return
        if spec.role.vehicle and spec.host < 0:
            place_behind_doors(self.floor, spec, self.due(spec))
        count = self.due(spec)
        if count >= 2 and spec.host < 0 and strict and self._place_pattern(spec, count):
            return
        for left in range(self.due(spec), 0, -1):
            if not self._place_one(spec, left, strict=strict):
                return

    def _place_pattern(self, spec: Spec, count: int) -> bool:
        footprint = spec.size[0] * spec.size[1]
        if spec.role.symmetric or (spec.where == "unconstrained" and footprint < _LARGE):
            return False
        place = place_rows if spec.where == "edge" else place_lattice
        shares = self._shares(spec, count, equal=True)
        units = self._units(spec, spec.size, shares)[:3]
        if spec.role.sofa and spec.where == "middle" and self._place_groups(spec, units[:2], count):
            return True
        return any(place(self.floor, spec, unit, count, self.rng, self.aisle) for unit in units)

    def _place_groups(self, spec: Spec, units: Sequence[Unit], count: int) -> bool:
        """Place sofas with all that belongs to each: rather fewer such groups than many sofas without."""
        numbers = range(count, 1, -1) if not spec.first else (count,)
        return any(
            len(unit.parts) > 1 and place_lattice(self.floor, spec, unit, number, self.rng, self.aisle)
            for number in numbers
            for unit in units
        )

    def _place_matrix(self, spec: Spec) -> None:
        shares = self._shares(spec, spec.quantity, equal=True)
        units = self._units(spec, spec.size, shares)
        seated = next((unit for unit in units if _seats(self.floor, unit) > 1), None)
        if seated is not None and self._place_tables(spec, seated):
            return
        alone = [unit for unit in units if len(unit.parts) == 1]
        ways = [(unit, 1.0) for unit in units if len(unit.parts) > 1]
        if ways and not spec.first and self._in_aisles(spec, units[0]):
            return
        if ways and not spec.first:
            # Half of the desks with a chair at each are better than all without.
            ways.append((units[0], 0.5))
        ways += [(unit, 1.0) for unit in alone] + [(unit, 0.0) for unit in units]
        for unit, least in ways:
            if place_matrix(self.floor, spec, unit, self.rng, self.aisle, least=least) is not None:
                return

    def _in_aisles(self, spec: Spec, unit: Unit) -> bool:
        """Place most of some desks with their chairs so that people pass between all of them."""
        return place_matrix(self.floor, spec, unit, self.rng, self.aisle, least=ENOUGH, roomy=True) is not None

    def _place_tables(self, spec: Spec, unit: Unit) -> bool:
        """Place most of some tables with their seats, so that people pass between them, in rows or around corners.

        Tables that are asked for are placed so all, or not at all.
        """
        least = 1.0 if spec.first else ENOUGH
        if place_matrix(self.floor, spec, unit, self.rng, self.aisle, least=least, roomy=True) is not None:
            return True
        shares = (1.0,) if spec.first else (1.0, 0.85, 0.7, 0.55)
        counts = dict.fromkeys(round(share * spec.quantity) for share in shares)
        return any(place_lattice(self.floor, spec, unit, count, self.rng, self.aisle) for count in counts if count > 1)

    def _place_one(self, spec: Spec, left: int, *, strict: bool) -> bool:
        shares = self._shares(spec, left)
        alone: list[Unit] = []
        for size in (spec.size, *spec.smaller):
            *units, bare = self._units(spec, size, shares)
            for fewer in self._fewer(spec, shares):
                units += self._units(spec, size, fewer)[:2]
            alone.append(bare)
            if any(find_placement(self.floor, spec, unit, self.rng, strict=strict) for unit in units):
                return True
        return any(find_placement(self.floor, spec, unit, self.rng, strict=strict) for unit in alone)

    def _fewer(self, spec: Spec, shares: dict[int, int]) -> list[dict[int, int]]:
        """Return shares with fewer seats around the copy, a pair each time, and with one table beside its head."""
        children = self.children.get(spec.index, ())
        around = {c.index: shares.get(c.index, 0) for c in children if c.link == "around" and c.role.seat}
        fewer = [
            {**shares, **{index: max(2, number - cut) for index, number in around.items()}}
            for cut in (2, 4, 6)
            if any(number - cut >= 2 for number in around.values())
        ]
        heads = [c.index for c in children if c.role.bedside and spec.role.bed and shares.get(c.index, 0) > 1]
        return [*fewer, {**shares, **dict.fromkeys(heads, 1)}] if heads else fewer

    def _units(self, spec: Spec, size: Size3, shares: dict[int, int]) -> list[Unit]:
        """Return the distinct units of a copy and its share of members, the most complete first."""
        units: list[Unit] = []
        styles = self._styles(spec) if any(shares.values()) else [UnitStyle(frozenset())]
        for style in styles:
            unit = build_unit(spec, size, shares, self.children, style)
            if all(unit.parts != other.parts for other in units):
                units.append(unit)
        return units

    def _styles(self, spec: Spec) -> list[UnitStyle]:
        """Return the styles in which a unit is composed, the most complete first."""
        mirrored = bool(self.rng.integers(2))
        every = _TIGHT | {"near"} if spec.quantity > 1 else _TIGHT
        width, depth = sorted(spec.size[:2], reverse=True)
        long_sides = bool(self.rng.integers(2)) and width > 1.25 * depth
        gap = 0.08 if self.floor.roomy else 0.03
        pairs = frozenset({"paired"})
        ways = [
            (every, mirrored, long_sides),
            (every, not mirrored, not long_sides),
            (_TIGHT, mirrored, True),
            (_TIGHT, not mirrored, False),
            (pairs, mirrored, False),
            (pairs, not mirrored, False),
            (frozenset[str](), mirrored, False),
        ]
        return [UnitStyle(links, left, along, gap) for links, left, along in ways]

    def _shares(self, spec: Spec, copies: int, *, equal: bool = False) -> dict[int, int]:
        """Return how many members of each kind one of `copies` copies gets.

        With `equal` all copies get the same number, and the rest is placed later.
        """
        shares: dict[int, int] = {}
        for child in self.children.get(spec.index, ()):
            left = self.missing(child)
            if left <= 0 or child.rows:
                continue
            share = left // copies if equal else -(-left // copies)
            shares[child.index] = min(share, 1) if child.link == "paired" else share
            shares.update(self._shares(child, max(left, 1), equal=equal))
        return shares


def _seats(floor: Floor, unit: Unit) -> int:
    return sum(floor.specs[index].role.seat for index in unit.specs)


def construct(
    floor: Floor, specs: Sequence[Spec], groups: Sequence[Group], rng: np.random.Generator, *, aisle: float
) -> Construction:
    """Fill `floor` group by group (Algorithm 4), then place what is left over wherever it fits.

    Parameters
    ----------
    groups : sequence of Group
        Groups in the order in which they are placed.
    aisle : float
        Widest aisle that patterns try, metres.

    Returns
    -------
    Construction
        The filled floor with what is needed to place more.
    """
    children: dict[int, list[Spec]] = {}
    for group in groups:
        for member in group.members:
            children.setdefault(member.host, []).append(member)
    build = Construction(floor, children, rng, aisle)
    for group in groups:
        build.place_group(group)
    for strict in (True, False):
        for spec in sorted(specs, key=lambda s: (not s.first, -s.size[0] * s.size[1], s.index)):
            if build.missing(spec) > 0 and not spec.rows:
                build.place_copies(spec, strict=strict)
    return build
