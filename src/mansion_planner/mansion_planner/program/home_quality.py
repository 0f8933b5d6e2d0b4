"""How well a storey is planned as a home: its hall, the group of its day rooms, its utility room, its narrow rooms."""

from collections.abc import Iterable, Sequence

from mansion_planner.program.model import Placement, Sketch, Storey, touching
from mansion_planner.program.plan_quality import STRIP, aspect

__all__ = ["home_faults"]

_KITCHENS = ("kitchen", "open_kitchen", "kitchen_diner")
_GROUP = ("living_room", "dining_room", "open_kitchen", "kitchen_diner", "lounge", "studio_room")
_UTILITY = ("utility_room", "laundry_room", "pantry")

_HALL = 0.15
"""Share of a home that its halls take at most, stairs not counted."""

_SLENDER = 2.2
"""Long side of a room to live in to its short one from which furniture is hard to place."""

_HALL_PRICE, _KITCHEN_PRICE, _UTILITY_PRICE, _SLENDER_PRICE = 1.0, 1.5, 0.75, 0.4
"""What each fault counts for, beside a strip or a room of a wrong size, which counts 1."""

_EACH_SHARE = 8.0
"""What the share of the halls beyond the most adds to its price."""


def home_faults(storeys: Sequence[tuple[Storey, Sketch, float]]) -> float:
    """Return what is wrong with a home as such; 0 for nothing.

    Parameters
    ----------
    storeys : sequence of (Storey, Sketch, float)
        Storeys above ground that repeat no other, with their gross areas in square metres.

    Notes
    -----
    Figures follow what architects ask of dwellings (Neufert, Architects' Data): circulation of 12 to 15%, kitchen,
    dining and living room as one group, the utility room by the kitchen.
    """
    halls = sum(
        corridor.area
        for storey, sketch, _ in storeys
        for corridor in sketch.corridors
        if storey.hub.zone == "circulation"
    )
    over = halls / max(sum(area for *_, area in storeys), 1.0) - _HALL
    price = _HALL_PRICE + _EACH_SHARE * over if over > 0.0 else 0.0
    return price + sum(_storey_faults(storey, sketch) for storey, sketch, _ in storeys)


def _storey_faults(storey: Storey, sketch: Sketch) -> float:
    """Return what is wrong with the places and forms of a storey's rooms."""
    placed = [placement for placement in sketch.rooms if placement.boxes]
    kitchens, group, utility = (_of(placed, kinds) for kinds in (_KITCHENS, _GROUP, _UTILITY))
    price = _SLENDER_PRICE * sum(p.room.kind.daylight and aspect(p.boxes) > _SLENDER for p in placed)
    if storey.hub.daylight and sketch.corridors:
        # The room that the others line is no placed room: whether it is a strip is told here alone.
        form = aspect(sketch.corridors[0].boxes)
        price += _SLENDER_PRICE * (form > _SLENDER) + (form > STRIP)
    if kitchens and group and storey.hub.name not in _GROUP:
        price += _KITCHEN_PRICE * (not _are_beside(kitchens, group))
    if kitchens and utility:
        price += _UTILITY_PRICE * (not _are_beside(kitchens, utility))
    return price


def _of(placements: Iterable[Placement], kinds: Sequence[str]) -> list[Placement]:
    """Return the rooms of some types, or counted as one."""
    return [p for p in placements if p.room.kind.name in kinds or p.room.kind.counts_as in kinds]


def _are_beside(ours: Iterable[Placement], theirs: Sequence[Placement]) -> bool:
    """Whether one of our rooms shares a wall with one of theirs."""
    return any(a is not b and touching(a, b) for a in ours for b in theirs)
