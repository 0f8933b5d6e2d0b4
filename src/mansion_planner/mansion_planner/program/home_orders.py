"""In which order the rooms of a home line its hall: so that the hall is short, and day rooms lie side by side."""

import itertools
from collections.abc import Sequence

import msgspec

from mansion_planner.program.bands import Segment
from mansion_planner.program.blocks import Block
from mansion_planner.program.model import Sketch, joined_pairs, short_edges, touching
from mansion_planner.program.plan_quality import ragged

__all__ = ["HOME_PAIRS", "home_orders", "home_price"]

Pair = tuple[str, str]

_KITCHENS = ("kitchen_diner", "open_kitchen", "kitchen")

HOME_PAIRS: tuple[Pair, ...] = (
    *itertools.product(("laundry_room", "utility_room"), _KITCHENS),
    ("dining_room", "living_room"),
    *((kitchen, "living_room") for kitchen in _KITCHENS),
    ("open_kitchen", "dining_room"),
)
"""Rooms that are side by side in a home, the least wanted first."""

_WIDEST = 3
"""So many of the widest blocks of a stretch are tried at the end of the hall."""


def home_orders(segments: Sequence[Segment]) -> list[list[Segment]]:
    """Return the ways to fill a home's stretches, the given one first: each with one of its widest blocks at the end.

    A hall ends where the last room on either side begins, so that a wide one there makes it short.
    """
    choices = [_with_last(segment) if segment.bar == "main" else [segment] for segment in segments]
    return [list(choice) for choice in itertools.product(*choices)]


def _with_last(segment: Segment) -> list[Segment]:
    """Return a stretch as it is, and with each of its widest blocks last."""
    blocks = segment.blocks
    movable = [block for block in blocks[:-1] if not (block.host.kind.wet or block.host.suite or block.fixed)]
    widest = sorted(movable, key=lambda block: -block.gross)[:_WIDEST]
    return [segment, *(msgspec.structs.replace(segment, blocks=_moved(blocks, block)) for block in widest)]


def _moved(blocks: Sequence[Block], last: Block) -> tuple[Block, ...]:
    return (*(block for block in blocks if block is not last), last)


def home_price(sketch: Sketch, pairs: Sequence[Pair], apart: Sequence[Pair]) -> tuple[int, int, float]:
    """Return what is wrong with an order of rooms: doors without a wall, pairs apart, hall and ragged rooms."""
    wrong = len(short_edges(sketch)) + len(joined_pairs(sketch, apart))
    hall = sum(corridor.area for corridor in sketch.corridors)
    return wrong, sum(_are_apart(sketch, pair) for pair in pairs), hall + _RAGGED * len(ragged(sketch))


_RAGGED = 4.0
"""Square metres of hall that a room of an awkward shape counts as."""


def _are_apart(sketch: Sketch, pair: Pair) -> bool:
    """Whether both rooms of a pair are there and share no wall."""
    ours, theirs = ([p for p in sketch.rooms if p.room.called(name)] for name in pair)
    return bool(ours and theirs) and not any(a is not b and touching(a, b) for a in ours for b in theirs)
