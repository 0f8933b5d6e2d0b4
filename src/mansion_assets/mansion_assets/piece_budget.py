"""Reduce collision pieces: drop those that lie inside others, join those whose union adds little volume."""

import math
from collections.abc import Sequence
from typing import Final

import numpy as np

from mansion_assets.convex import Box, Convex, Hull, bounding_box, volume_of
from mansion_geometry.compiled import Bools, Floats, Ints
from mansion_msgs_py.shapes import Size3

__all__ = ["BUDGETS", "budget_of", "simplified"]

BUDGETS: Final = ((0.3, 12), (1.0, 20), (2.0, 28), (math.inf, 36))
"""Most pieces of one body by its longest edge: up to 0.3 m, 1 m, 2 m, and above."""

SKIN: Final = 0.015
"""Metres by which a knob or a label may stand out of a box that stands for it too."""

THIN: Final = 0.03
"""The same as a share of the longest edge, for small things."""

FREELY: Final = 0.02
"""Share of a joined box that may be air before any budget asks for joining."""

INTRUDES: Final = 0.004
"""Metres by which a joined box may reach into what is to stay free."""


def budget_of(size: Size3) -> int:
    """Return the most collision pieces of a body of a size."""
    longest = max(size)
    return next(count for bound, count in BUDGETS if longest <= bound)


def simplified(bodies: Sequence[Convex], size: Size3, free: Sequence[Box] = ()) -> list[Convex]:
    """Return at most the budget of pieces that together cover the bodies.

    Parameters
    ----------
    bodies : sequence of Box or Hull
    size : (w, d, h)
        Size of the asset, from which its budget follows.
    free : sequence of Box
        Room for objects, that no joined piece may take.

    Notes
    -----
    Pieces are joined to their common box in the order of the air that this takes in, as CoACD [1]_ and V-HACD join
    their parts in the order of the concavity. Where nothing may be joined, the smallest pieces go.

    References
    ----------
    .. [1] Wei, X., et al. (2022). Approximate convex decomposition for 3D meshes with collision-aware concavity and
       tree search. ACM Transactions on Graphics, 41(4).
    """
    pieces = _without_inner(list(bodies), min(SKIN, THIN * max(size)))
    return _Joining(pieces, free).down_to(budget_of(size))


def _bounds(bodies: Sequence[Convex]) -> Floats:
    """Return lowest and highest corners, (n, 6)."""
    table = np.empty((len(bodies), 6))
    for row, body in zip(table, bodies):
        if isinstance(body, Hull):
            row[:3], row[3:] = body.vertices.min(axis=0), body.vertices.max(axis=0)
        else:
            center, half = np.array(body.center), np.array(body.size) / 2
            row[:3], row[3:] = center - half, center + half
    return table


def _without_inner(bodies: list[Convex], skin: float) -> list[Convex]:
    """Leave out what lies within a larger box, or beyond it by no more than `skin` metres."""
    bounds = _bounds(bodies)
    volumes = np.array([volume_of(body) for body in bodies])
    boxes = np.array([isinstance(body, Box) for body in bodies])
    inside = (bounds[:, None, :3] >= bounds[None, :, :3] - skin).all(axis=2)
    inside &= (bounds[:, None, 3:] <= bounds[None, :, 3:] + skin).all(axis=2)
    kept = np.zeros(len(bodies), dtype=bool)
    for i in np.argsort(-volumes, kind="stable").tolist():
        kept[i] = not bool((inside[i] & kept & boxes).any())
    return [body for body, stays in zip(bodies, kept.tolist()) if stays]


class _Joining:
    """Pieces, and what each pair of them would take in if it were joined."""

    def __init__(self, pieces: list[Convex], free: Sequence[Box]) -> None:
        self.pieces: list[Convex | None] = list(pieces)
        self.bounds = _bounds(pieces)
        self.volumes = np.array([volume_of(piece) for piece in pieces])
        self.free = _bounds(free)
        self.taken = self._intrusion(self.bounds)
        count = len(pieces)
        self.gone = np.zeros(count, dtype=bool)
        self.costs, self.shares = self._weighed(np.arange(count))

    def _weighed(self, rows: Ints) -> tuple[Floats, Floats]:
        """Return the air that pieces would take in if they were joined with each other one, and its share; (k, n)."""
        mine = self.bounds[rows][:, None]
        low, high = np.minimum(mine[..., :3], self.bounds[:, :3]), np.maximum(mine[..., 3:], self.bounds[:, 3:])
        shared = np.minimum(mine[..., 3:], self.bounds[:, 3:]) - np.maximum(mine[..., :3], self.bounds[:, :3])
        common = np.clip(shared, 0.0, None).prod(axis=2)
        whole = (high - low).prod(axis=2)
        cost = np.maximum(whole - self.volumes[rows][:, None] - self.volumes + common, 0.0)
        barred = np.broadcast_to(self.gone, cost.shape) | (rows[:, None] == np.arange(len(self.pieces)))
        if len(self.free):
            before = self.taken[rows][:, None] | self.taken
            joined = np.concatenate([low, high], axis=2).reshape(-1, 6)
            barred |= (self._intrusion(joined).reshape(before.shape) & ~before).any(axis=2)
        cost[barred] = np.inf
        return cost, cost / np.maximum(whole, 1e-12)

    def _intrusion(self, bounds: Floats) -> Bools:
        """Tell which boxes reach into which room that is to stay free, (n, m)."""
        low = np.maximum(bounds[:, None, :3], self.free[None, :, :3])
        high = np.minimum(bounds[:, None, 3:], self.free[None, :, 3:])
        inside: Bools = (high - low > INTRUDES).all(axis=2)
        return inside

    def down_to(self, budget: int) -> list[Convex]:
        """Join what may be joined freely, and then until the budget holds."""
        count = len(self.pieces)
        while count > 1:
            i, j = divmod(int(self.shares.argmin()), len(self.pieces))
            if self.shares[i, j] > FREELY:
                break
            self._join(i, j)
            count -= 1
        while count > budget:
            i, j = divmod(int(self.costs.argmin()), len(self.pieces))
            if np.isfinite(self.costs[i, j]):
                self._join(i, j)
            else:
                left = [k for k, piece in enumerate(self.pieces) if piece is not None]
                self._drop(min(left, key=lambda k: float(self.volumes[k])))
            count -= 1
        return [piece for piece in self.pieces if piece is not None]

    def _join(self, i: int, j: int) -> None:
        low = np.minimum(self.bounds[i, :3], self.bounds[j, :3])
        high = np.maximum(self.bounds[i, 3:], self.bounds[j, 3:])
        joined = bounding_box(low, high)
        self.pieces[i] = joined
        self.bounds[i] = [*low, *high]
        self.volumes[i] = volume_of(joined)
        self.taken[i] |= self.taken[j]
        self._drop(j)
        cost, share = self._weighed(np.array([i]))
        self.costs[i], self.costs[:, i] = cost[0], cost[0]
        self.shares[i], self.shares[:, i] = share[0], share[0]

    def _drop(self, i: int) -> None:
        self.pieces[i], self.gone[i] = None, True
        for table in (self.costs, self.shares):
            table[i], table[:, i] = np.inf, np.inf
