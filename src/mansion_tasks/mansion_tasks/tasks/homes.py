"""Where kinds of things are used or kept: the rooms to which somebody would have them brought.

Room types are matched by their end (``open_office`` is an office); what each end says of a room's use is in the
knowledge base.
"""

from collections.abc import Iterable
from typing import Final

from mansion_knowledge import uses_of

__all__ = ["at_home_in"]

_KEPT: Final = {
    "chilled": frozenset(["eating", "homes"]),
    "food": frozenset(["eating", "homes", "shops"]),
    "drink": frozenset(["eating", "meeting", "desks", "beds", "homes", "care"]),
    "baked": frozenset(["eating", "homes"]),
    "tableware": frozenset(["eating", "homes"]),
    "cookware": frozenset(["eating", "homes"]),
    "stationery": frozenset(["meeting", "desks", "machines", "homes", "post", "labs"]),
    "reading": frozenset(["meeting", "desks", "beds", "homes", "lounging", "showing"]),
    "medical": frozenset(["care", "beds"]),
    "lab": frozenset(["labs"]),
    "cultures": frozenset(["labs"]),
    "bath": frozenset(["washing", "homes", "laundry"]),
    "linen": frozenset(["beds", "homes", "lounging", "laundry", "care"]),
    "towels": frozenset(["washing", "laundry", "homes"]),
    "clothing": frozenset(["beds", "homes", "wraps"]),
    "personal": frozenset(["meeting", "desks", "beds", "homes", "lounging"]),
    "toy": frozenset(["play", "homes", "lounging", "bedrooms"]),
    "sport": frozenset(["sport", "play", "wraps", "stores"]),
    "tool": frozenset(["stores"]),
    "decor": frozenset(["meeting", "desks", "eating", "beds", "homes", "lounging", "showing", "shops"]),
    "post": frozenset(["post", "stores", "machines"]),
    "device": frozenset(["desks", "machines", "presenting", "homes", "lounging"]),
}
"""From a kind to the uses of the rooms in which it is used or kept."""


def at_home_in(kinds: Iterable[str], room_type: str) -> bool:
    """Whether one of some kinds is used or kept in a room; in rooms of an unknown type anything may be.

    Examples
    --------
    >>> at_home_in(["personal"], "private_office"), at_home_in(["personal"], "commercial_kitchen")
    (True, False)
    """
    uses = uses_of(room_type)
    if not uses - {"passing"}:
        return "passing" not in uses
    return any(not uses.isdisjoint(_KEPT.get(kind, ())) for kind in kinds)
