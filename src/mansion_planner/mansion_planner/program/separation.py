"""Exchange blocks of rooms so that rooms which the brief does not want side by side lie apart."""

import itertools
from collections.abc import Iterable, Sequence

from mansion_planner.program.bands import Place, Segment, with_rows
from mansion_planner.program.blocks import Block

__all__ = ["keep_apart", "parted"]

Pair = tuple[str, str]


_MISFIT = 0.25
"""How far an exchange may leave a stretch from full, as a share of its length."""

_ROUNDS = 6


def parted(first: Block, second: Block, apart: Iterable[Pair]) -> bool:
    """Whether no room of one block is unwanted beside a room of the other."""
    ours, theirs = [first.host, *first.smalls], [second.host, *second.smalls]
    return not any(
        (a.called(one) and b.called(other)) or (a.called(other) and b.called(one))
        for one, other in apart
        for a in ours
        for b in theirs
        if a is not b
    )


def keep_apart(segments: Sequence[Segment], apart: Sequence[Pair], together: Sequence[Pair]) -> list[Segment]:
    """Return the segments with blocks exchanged so that, if the lengths allow, no rooms to be kept apart adjoin.

    Parameters
    ----------
    segments : sequence of Segment
    apart : sequence of (str, str)
        Rooms that must not share a wall.
    together : sequence of (str, str)
        Rooms that are to be side by side: an exchange does not part them.
    """
    if not apart:
        return list(segments)
    rows = [list(segment.blocks) for segment in segments]
    faults = _faults(rows, apart, together)
    for _ in range(_ROUNDS):
        found = _best_exchange(segments, rows, apart, together) if faults > 0.0 else None
        if found is None or found[0] >= faults:
            break
        faults, one, other = found
        rows = _exchanged(rows, one, other)
    return with_rows(segments, rows)


Rows = list[list[Block]]
"""The blocks of each segment."""


def _best_exchange(
    segments: Sequence[Segment], rows: Rows, apart: Sequence[Pair], together: Sequence[Pair]
) -> tuple[float, Place, Place] | None:
    """Return the faults that the best exchange of two blocks leaves, and the places of the two."""
    places = [(s, i) for s, row in enumerate(rows) for i in range(len(row))]
    best: tuple[float, float, Place, Place] | None = None
    for one, other in itertools.combinations(places, 2):
        misfit = 0.0 if one[0] == other[0] else _misfit(segments, rows, one, other)
        if misfit > _MISFIT:
            continue
        price = (_faults(_exchanged(rows, one, other), apart, together), misfit, one, other)
        best = price if best is None or price < best else best
    return (best[0], best[2], best[3]) if best is not None else None


def _exchanged(rows: Rows, one: Place, other: Place) -> Rows:
    """Return the rows with two blocks in each other's place."""
    (s, i), (t, k) = one, other
    made = [list(row) for row in rows]
    made[s][i], made[t][k] = rows[t][k], rows[s][i]
    return made


def _misfit(segments: Sequence[Segment], rows: Rows, one: Place, other: Place) -> float:
    """How far the worse of two segments is from full after an exchange, as a share of its length."""
    ours, theirs = (rows[s][i].gross for s, i in (one, other))
    here = _filling(segments[one[0]], rows[one[0]], theirs - ours)
    there = _filling(segments[other[0]], rows[other[0]], ours - theirs)
    return max(abs(here - 1.0), abs(there - 1.0))


def _filling(segment: Segment, row: Sequence[Block], more: float) -> float:
    return (sum(block.gross for block in row) / segment.depth + more / segment.depth) / segment.length


def _faults(rows: Rows, apart: Sequence[Pair], together: Sequence[Pair]) -> float:
    """Count neighbours that are to be apart; one that is to be beside another and is not counts less than that."""
    neighbours = [(a, b) for row in rows for a, b in itertools.pairwise(row)]
    wrong = sum(not parted(a, b, apart) for a, b in neighbours)
    met = sum(any(not parted(a, b, [pair]) for a, b in neighbours) for pair in together)
    return wrong - 0.9 * met / max(len(together), 1)
