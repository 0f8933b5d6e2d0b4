"""Kitchen runs: fridge, worktop, sink, worktop and hob side by side along a wall, or round a corner."""

from collections.abc import Iterator, Sequence
from itertools import product

from mansion_scene.placement.groups import Spec
from mansion_scene.placement.roles import Fitment
from mansion_scene.placement.units import BACK, Size3, Unit

__all__ = ["run_members", "run_orders", "run_pieces", "runs"]

_JOINT = 0.01
"""Gap between the pieces of a run, metres."""

_OVERHANG = 0.05
"""How far what stands past a corner may reach before the neighbour of the worktop in it, metres."""

_SILL = 0.9
"""Height to which worktops, sinks and hobs count before a window: taps and hobs are slim above it, metres."""

_ORDERS: dict[int, tuple[tuple[Fitment, ...], ...]] = {
    1: (("fridge", "sink", "dishwasher", "worktop", "hob"), ("fridge", "worktop", "sink", "dishwasher", "hob")),
    2: (
        ("fridge", "worktop", "sink", "dishwasher", "worktop", "hob"),
        ("fridge", "sink", "dishwasher", "worktop", "hob", "worktop"),
    ),
    3: (("fridge", "worktop", "sink", "dishwasher", "worktop", "hob", "worktop"),),
}
"""Runs by their worktops, as one works along them: what is stored is washed, cut and cooked."""

_SPARED: tuple[frozenset[Fitment | None], ...] = (
    frozenset(),
    frozenset({"dishwasher"}),
    frozenset({"dishwasher", "fridge"}),
)
"""What stands apart where a whole run finds no wall."""

Piece = tuple[Spec, Size3]


def run_pieces(anchor: Spec, specs: Sequence[Spec]) -> list[Spec]:
    """Return what stands in a run with some worktops at a wall; nothing unless the anchor of a group is a worktop."""
    if anchor.role.fitment != "worktop" or anchor.where != "edge" or anchor.rows:
        return []
    return [
        spec
        for spec in specs
        if spec.role.fitment not in (None, "worktop")
        and (spec.where, spec.rows) == ("edge", 0)
        and spec.host in (-1, anchor.index)
    ]


def run_orders(worktops: int, present: Sequence[Fitment]) -> list[list[Fitment]]:
    """Return the usual orders of a run's pieces from one end to the other.

    Parameters
    ----------
    worktops : int
        How many of them; more than three go to the end.
    present : sequence of Fitment
        What else there is.

    Examples
    --------
    >>> run_orders(2, ["sink", "hob", "fridge"])[0]
    ['fridge', 'worktop', 'sink', 'worktop', 'hob']
    """
    more: list[Fitment] = ["worktop"] * (worktops - 3)
    return [
        [kind for kind in order if kind == "worktop" or kind in present] + more for order in _ORDERS[min(worktops, 3)]
    ]


def runs(anchor: Spec, missing: int, left: Sequence[Spec], walls: Sequence[float], *, mirrored: bool) -> Iterator[Unit]:
    """Yield the units of a run that the walls have the length for, the most complete first.

    Parameters
    ----------
    missing : int
        How many worktops it has at most.
    left : sequence of Spec
        Its other members.
    walls : sequence of float
        Lengths of the room's walls, the longest first, metres.
    mirrored : bool
        Which way round comes first.
    """
    fitted = {spec.role.fitment: spec for spec in reversed(left)}
    widths = (False, True) if any(spec.smaller for spec in left) else (False,)
    for worktops, size, compact in product(range(missing, 0, -1), (anchor.size, *anchor.smaller), widths):
        for order in run_orders(worktops, [kind for kind in fitted if kind]):
            pieces = [(anchor, size) if kind == "worktop" else _piece(fitted[kind], compact=compact) for kind in order]
            yield from _shapes(pieces, walls, mirrored=mirrored)


def run_members(left: Sequence[Spec]) -> Iterator[list[Spec]]:
    """Yield what stands in a run: all that is left, then less where no wall is long enough for it."""
    for spared in _SPARED:
        if not spared or not spared.isdisjoint(spec.role.fitment for spec in left):
            yield [spec for spec in left if spec.role.fitment not in spared]


def _piece(spec: Spec, *, compact: bool) -> Piece:
    return spec, min((spec.size, *spec.smaller), key=lambda size: size[0]) if compact else spec.size


def _shapes(pieces: Sequence[Piece], walls: Sequence[float], *, mirrored: bool) -> Iterator[Unit]:
    """Yield a run straight, then round each corner, either way round."""
    for straight in (len(pieces), *(corner + 1 for corner in _corners(pieces))):
        legs = sorted((_length(pieces[:straight]), _length(pieces[straight:])), reverse=True)
        if all(leg <= wall for leg, wall in zip(legs, walls, strict=False)):
            for turned in (mirrored, not mirrored):
                yield _unit(pieces, straight, mirrored=turned)


def _length(pieces: Sequence[Piece]) -> float:
    return sum(size[0] for _, size in pieces)


def _corners(pieces: Sequence[Piece]) -> list[int]:
    """Return the worktops that may stand in a corner, those that part the run most evenly first."""
    found = []
    for i, (spec, (width, *_)) in enumerate(pieces[:-1]):
        deepest = max(size[1] for _, size in pieces[i + 1 :])
        if spec.role.fitment == "worktop" and deepest <= width + _OVERHANG:
            found.append((abs(_length(pieces[: i + 1]) - _length(pieces) / 2), i))
    return [i for _, i in sorted(found)]


def _unit(pieces: Sequence[Piece], straight: int, *, mirrored: bool) -> Unit:
    """Return a run whose first pieces stand along one wall and the rest along the wall at its end.

    The frame is that of the first worktop, which is the unit's anchor.
    """
    places = _places([size for _, size in pieces], straight)
    first = next(i for i, (spec, _) in enumerate(pieces[:straight]) if spec.role.fitment == "worktop")
    order = [first, *(i for i in range(len(pieces)) if i != first)]
    sign = -1.0 if mirrored else 1.0
    parts = []
    for i in order:
        spec, (width, depth, height) = pieces[i]
        x, y = (sign * (places[i][0] - places[first][0]), places[i][1] - places[first][1])
        u = (1.0, 0.0) if i < straight else (0.0, sign)
        top = height if spec.role.fitment == "fridge" else min(height, _SILL)
        parts.append((x, y, *u, width / 2, depth / 2, top, BACK))
    specs = tuple(pieces[i][0].index for i in order)
    hosts = tuple(-1 if index == specs[0] else 0 for index in specs)
    return Unit(tuple(parts), specs, hosts, tuple(pieces[i][1] for i in order))


def _places(sizes: Sequence[Size3], straight: int) -> list[tuple[float, float]]:
    """Return the centres of a run's pieces, the backs of the first along y = 0, of the rest along their end."""
    places, x = [], 0.0
    for width, depth, _ in sizes[:straight]:
        places.append((x + width / 2, depth / 2))
        x += width + _JOINT
    y = sizes[straight - 1][1] + _JOINT
    for width, depth, _ in sizes[straight:]:
        places.append((x - _JOINT - depth / 2, y + width / 2))
        y += width + _JOINT
    return places
