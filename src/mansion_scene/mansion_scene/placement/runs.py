"""Kitchens in one run: fridge, worktop, sink, worktop and hob side by side along a wall, or round a corner."""

from collections.abc import Iterator, Sequence

from mansion_scene.placement.groups import Group, Spec
from mansion_scene.placement.roles import Fitment
from mansion_scene.placement.units import BACK, Size3, Unit

__all__ = ["is_run", "run_order", "runs"]

_JOINT = 0.01
"""Gap between the pieces of a run, metres."""

_OVERHANG = 0.05
"""How far what stands past a corner may reach before the neighbour of the worktop in it, metres."""

_ORDER: tuple[Fitment, ...] = ("fridge", "worktop", "sink", "dishwasher", "worktop", "hob", "worktop")
"""A run as one works along it: what is stored is washed, cut and cooked."""

_SPARED = (6, 1, 4)
"""Worktops of the order that a shorter run does without, in turn: the one between sink and hob stays."""

Piece = tuple[Spec, Size3]


def is_run(group: Group) -> bool:
    """Tell whether a group is a kitchen's: worktops at a wall with what belongs beside them."""
    fitted = [member for member in group.members if member.role.fitment]
    anchor = group.anchor
    return anchor.role.fitment == "worktop" and anchor.where == "edge" and not anchor.rows and bool(fitted)


def run_order(worktops: int, present: Sequence[Fitment]) -> list[Fitment]:
    """Return the pieces of a run from one end to the other.

    Parameters
    ----------
    worktops : int
        How many of them; more than three go to the end.
    present : sequence of Fitment
        What else there is.

    Examples
    --------
    >>> run_order(2, ["sink", "hob", "fridge"])
    ['fridge', 'worktop', 'sink', 'worktop', 'hob']
    """
    spared = _SPARED[: max(3 - worktops, 0)]
    order = [kind for i, kind in enumerate(_ORDER) if i not in spared and (kind == "worktop" or kind in present)]
    return order + ["worktop"] * (worktops - 3)


def runs(group: Group, worktops: int, size: Size3, *, mirrored: bool, left: Sequence[Spec]) -> Iterator[Unit]:
    """Yield the units of a run with a number of worktops of one size, straight ones before those round a corner.

    Parameters
    ----------
    mirrored : bool
        Which way round comes first.
    left : sequence of Spec
        Members that are not placed yet.
    """
    pieces = _pieces(group.anchor, worktops, size, left)
    for turned in (mirrored, not mirrored):
        yield _unit(pieces, len(pieces), mirrored=turned)
    for corner in _corners(pieces):
        for turned in (mirrored, not mirrored):
            yield _unit(pieces, corner + 1, mirrored=turned)


def _pieces(anchor: Spec, worktops: int, size: Size3, left: Sequence[Spec]) -> list[Piece]:
    by_kind = {spec.role.fitment: spec for spec in reversed(left) if spec.role.fitment}
    kinds = run_order(worktops, [kind for kind in by_kind if kind and kind != "worktop"])
    return [(anchor, size) if kind == "worktop" else (by_kind[kind], by_kind[kind].size) for kind in kinds]


def _corners(pieces: Sequence[Piece]) -> list[int]:
    """Return the worktops that may stand in a corner, those that part the run most evenly first."""
    total = sum(size[0] for _, size in pieces)
    found = []
    for i, (spec, _) in enumerate(pieces[:-1]):
        deepest = max(size[1] for _, size in pieces[i + 1 :])
        if spec.role.fitment == "worktop" and deepest <= pieces[i][1][0] + _OVERHANG:
            found.append((abs(sum(size[0] for _, size in pieces[: i + 1]) - total / 2), i))
    return [i for _, i in sorted(found)]


def _unit(pieces: Sequence[Piece], straight: int, *, mirrored: bool) -> Unit:
    """Return a run whose first pieces stand along one wall and the rest along the wall at its end.

    The frame is that of the first worktop, which is the unit's anchor.
    """
    placed: list[tuple[float, float, int]] = []
    x = 0.0
    for _, (width, depth, _height) in pieces[:straight]:
        placed.append((x + width / 2, depth / 2, 0))
        x += width + _JOINT
    corner = x - _JOINT
    y = pieces[straight - 1][1][1] + _JOINT
    for _, (width, depth, _height) in pieces[straight:]:
        placed.append((corner - depth / 2, y + width / 2, 1))
        y += width + _JOINT
    first = next(i for i, (spec, _) in enumerate(pieces) if spec.role.fitment == "worktop" and placed[i][2] == 0)
    at = placed[first]
    order = [first, *(i for i in range(len(pieces)) if i != first)]
    sign = -1.0 if mirrored else 1.0
    parts = []
    for i in order:
        dx, dy, turned = placed[i]
        u = (0.0, sign) if turned else (1.0, 0.0)
        size = pieces[i][1]
        parts.append((sign * (dx - at[0]), dy - at[1], *u, size[0] / 2, size[1] / 2, size[2], BACK))
    anchor = pieces[first][0].index
    specs = tuple(pieces[i][0].index for i in order)
    hosts = tuple(-1 if index == anchor else 0 for index in specs)
    return Unit(tuple(parts), specs, hosts, tuple(pieces[i][1] for i in order))
