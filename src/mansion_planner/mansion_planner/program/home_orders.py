"""The order in which the rooms of a home line its hall: with a short hall, and day rooms side by side."""

import itertools
from collections.abc import Callable, Iterator, Sequence

import msgspec

from mansion_planner.program.bands import Segment, misfit_of_exchange, with_rows
from mansion_planner.program.blocks import Block
from mansion_planner.program.model import Sketch, joined_pairs, short_edges, touching
from mansion_planner.program.plan_quality import ragged, shallow_garages, shrunk_rooms, strips, swollen_rooms

__all__ = ["HOME_PAIRS", "best_sketch", "home_orders", "home_price"]

Pair = tuple[str, str]

_KITCHENS = ("kitchen_diner", "open_kitchen", "kitchen")

HOME_PAIRS: tuple[Pair, ...] = (
    *itertools.product(("laundry_room", "utility_room"), _KITCHENS),
    ("dining_room", "living_room"),
    *((kitchen, "living_room") for kitchen in _KITCHENS),
    *((kitchen, "dining_room") for kitchen in _KITCHENS),
)
"""Rooms that are side by side in a home, the least wanted first."""

_WIDEST = 3
"""So many of the widest blocks of a stretch are tried at the end of the hall."""


_ROUNDS = 4
"""Times that two blocks change places at most."""

_MOST_BLOCKS = 27
"""Blocks of a storey beyond which none change places: the time for it grows with their third power, and more."""

Price = tuple[float, float, float]


def best_sketch(
    segments: Sequence[Segment], lay: Callable[[list[Segment]], Sketch], price: Callable[[Sketch], Price]
) -> Sketch:
    """Return the best sketch of a home's blocks: of all orders of `home_orders`, then with blocks exchanged.

    Parameters
    ----------
    segments : sequence of Segment
        With the blocks as they fill the stretches.
    lay : callable
        Draws an order.
    price : callable
        Tells what is wrong with a sketch, the worst first.
    """
    tried = [(price(sketch), order, sketch) for order in home_orders(segments) for sketch in [lay(order)]]
    paid, order, best = min(tried, key=lambda entry: entry[0])
    rounds = _ROUNDS if sum(len(segment.blocks) for segment in segments) <= _MOST_BLOCKS else 0
    for _ in range(rounds):
        if not any(paid[:2]):
            break
        tried = [(price(sketch), other, sketch) for other in _exchanged(order) for sketch in [lay(other)]]
        found = min(tried, key=lambda entry: entry[0], default=None)
        if found is None or found[0] >= paid:
            break
        paid, order, best = found
    return best


_MISFIT = 0.12
"""How far an exchange may leave a stretch from full, as a share of its length."""


def _exchanged(segments: Sequence[Segment]) -> Iterator[list[Segment]]:
    """Yield the orders in which two blocks have changed places; what is stacked over the storeys stays."""
    places = [
        (s, i)
        for s, segment in enumerate(segments)
        for i, block in enumerate(segment.blocks)
        if not block.host.kind.stack
    ]
    for one, other in itertools.combinations(places, 2):
        (s, i), (t, j) = one, other
        if s != t and misfit_of_exchange(segments, one, other) > _MISFIT:
            continue
        rows = [list(segment.blocks) for segment in segments]
        rows[s][i], rows[t][j] = rows[t][j], rows[s][i]
        yield with_rows(segments, rows)


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


def home_price(sketch: Sketch, pairs: Sequence[Pair], apart: Sequence[Pair]) -> Price:
    """Return what is wrong with an order of rooms: doors without a wall; pairs apart, odd rooms; hall, ragged rooms.

    Pairs that the brief asks for count more than those that any home has.
    """
    wrong = len(short_edges(sketch)) + len(joined_pairs(sketch, apart))
    hall = sum(corridor.area for corridor in sketch.corridors)
    dining = any(placement.room.called("dining_room") for placement in sketch.rooms)
    missed = sum(_are_apart(sketch, pair) * _weight(pair, dining=dining) for pair in pairs)
    odd = len(strips(sketch)) + len(shrunk_rooms(sketch)) + len(swollen_rooms(sketch)) + len(shallow_garages(sketch))
    return wrong, missed + odd, hall + _RAGGED * len(ragged(sketch))


def _weight(pair: Pair, *, dining: bool) -> float:
    """Return what a pair counts for: with a dining room, meals are not carried to the living room."""
    if pair not in HOME_PAIRS:
        return _ASKED
    return _LESS if dining and pair[0] in _KITCHENS and pair[1] == "living_room" else 1.0


_LESS = 0.5
"""What a kitchen counts for that is away from the living room, where it is beside the dining room."""

_ASKED = 3.0
"""What a pair that the brief asks for counts beside one that any home has."""

_RAGGED = 4.0
"""Square metres of hall that a room of an awkward shape counts as."""


def _are_apart(sketch: Sketch, pair: Pair) -> bool:
    """Whether both rooms of a pair are there and share no wall."""
    ours, theirs = ([p for p in sketch.rooms if p.room.called(name)] for name in pair)
    return bool(ours and theirs) and not any(a is not b and touching(a, b) for a in ours for b in theirs)
