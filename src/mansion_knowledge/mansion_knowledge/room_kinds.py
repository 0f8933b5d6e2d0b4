"""Which types of rooms are of a kind that is not wanted: an open office is an office, a guest room a bedroom."""

from typing import Final

from mansion_knowledge.base import default_knowledge

__all__ = ["is_one_of"]

_FURTHER: Final = {
    "private_office": frozenset({"open_office", "executive_office", "home_office", "team_room", "coworking_area"}),
    "home_office": frozenset({"private_office", "open_office", "executive_office"}),
    "bathroom": frozenset({"ensuite_bathroom"}),
    "gym": frozenset({"home_gym"}),
    "library": frozenset({"library_room"}),
    "corridor": frozenset({"hallway"}),
}
"""Types that people also mean by the name of one, beyond those that count as it."""


def is_one_of(room_type: str, refused: str) -> bool:
    """Whether a room of a type is one of the kind that is not wanted.

    Examples
    --------
    >>> is_one_of("guest_room", "bedroom"), is_one_of("bedroom", "guest_room")
    (True, False)
    >>> is_one_of("open_office", "private_office")
    True
    """
    if room_type == refused or room_type in _FURTHER.get(refused, ()):
        return True
    known = default_knowledge().rooms.get(room_type)
    return known is not None and known.counts_as == refused
