"""Keep rooms apart that the brief does not want side by side."""

import itertools
from collections.abc import Iterable, Sequence

from mansion_planner.program.bands import Block, Segment

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


def keep_apart(segments: Sequence[Segment], apart: Sequence[Pair], together: Sequence[Pair]) -> None:
    """Exchange blocks until those that are to be apart are not neighbours, as far as the lengths allow.

    Parameters
    ----------
    segments : sequence of Segment
        Their blocks are exchanged in place.
    apart : sequence of (str, str)
        Rooms that must not share a wall.
    together : sequence of (str, str)
        Rooms that are to be side by side: an exchange does not part them.
    """
    if not apart:
        return
    places = [(s, i) for s in segments for i in range(len(s.blocks))]
    for _ in range(_ROUNDS):
        now = _faults(segments, apart, together)
        if now <= 0.0:
            return
        best: tuple[float, float, int, int] | None = None
        for m, (s, i) in enumerate(places):
            for n, (t, k) in enumerate(places[m + 1 :], m + 1):
                misfit = 0.0 if s is t else _misfit(s, t, i, k)
                if misfit > _MISFIT:
                    continue
                s.blocks[i], t.blocks[k] = t.blocks[k], s.blocks[i]
                price = (_faults(segments, apart, together), misfit, m, n)
                s.blocks[i], t.blocks[k] = t.blocks[k], s.blocks[i]
                best = price if best is None or price < best else best
        if best is None or best[0] >= now:
            return
        (s, i), (t, k) = places[best[2]], places[best[3]]
        s.blocks[i], t.blocks[k] = t.blocks[k], s.blocks[i]


def _misfit(s: Segment, t: Segment, i: int, k: int) -> float:
    ours, theirs = s.blocks[i].gross, t.blocks[k].gross
    here = (s.used + (theirs - ours) / s.depth) / s.length
    there = (t.used + (ours - theirs) / t.depth) / t.length
    return max(abs(here - 1.0), abs(there - 1.0))


def _faults(segments: Iterable[Segment], apart: Sequence[Pair], together: Sequence[Pair]) -> float:
    """Count neighbours that are to be apart; one that is to be beside another and is not counts less than that."""
    neighbours = [(a, b) for s in segments for a, b in itertools.pairwise(s.blocks)]
    wrong = sum(not parted(a, b, apart) for a, b in neighbours)
    met = sum(any(not parted(a, b, [pair]) for a, b in neighbours) for pair in together)
    return wrong - 0.9 * met / max(len(together), 1)
