"""How far rooms grow into the area that a building has to spare before it gets rooms that nobody asked for."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_knowledge import BuildingType, RoomType
from mansion_planner.program.model import PlannedRoom

__all__ = ["at_home", "growth_weight", "is_described", "is_needed", "reach", "weight_beyond"]

_NEEDED: Final = frozenset(
    """
    restroom toilet accessible_toilet bathroom ensuite_bathroom reception waiting_room ticket_office kitchen
    commercial_kitchen open_kitchen living_room changing_room shower_area loading_dock utility_room
    """.split()
)
"""Rooms of a type's own list that serve the others, whatever the brief asks for."""

_DESCRIBED: Final = 0.2
"""Share of the area for rooms that those of the brief take where it describes the storey."""

_FLEXIBLE, _OTHERS, _SERVING = 2.2, 1.6, 1.25
"""To how many times its usual area a room grows at most: one that is good at any size, another, one of service."""

_UNASKED: Final = 0.85
"""Share of that to which a room of the type's own list grows."""


_AT_HOME: Final = {
    "bar": 12.0, "workshop": 14.0, "music_room": 16.0, "art_room": 16.0, "dance_studio": 22.0, "yoga_studio": 16.0,
    "photo_studio": 16.0, "recording_studio": 14.0, "greenhouse": 15.0, "spa": 20.0, "laundry_room": 7.0,
    "roof_terrace": 26.0, "terrace": 18.0,
}  # fmt: skip
"""Usual square metres in a home of rooms that other buildings have for many: a bar for a household and its guests."""

_WITH_A_BATH: Final = frozenset({"resident_room", "patient_room", "hotel_room"})
"""Rooms that have a bathroom of their own in other buildings, and are plain bedrooms in a home."""

_LEAST_AT_HOME, _MOST_AT_HOME = 0.7, 1.8
"""Least and greatest share of those."""


def at_home(kind: RoomType) -> RoomType:
    """Return a type of room with the sizes, and the rooms of its own, that it has in a home."""
    kind = replace(kind, suite=()) if kind.name in _WITH_A_BATH else kind
    usual = _AT_HOME.get(kind.name)
    if usual is None:
        return kind
    return replace(kind, least=min(kind.least, _LEAST_AT_HOME * usual), usual=usual, most=_MOST_AT_HOME * usual)


def is_described(asked: Sequence[PlannedRoom], capacity: float) -> bool:
    """Whether a brief asks for so many of a storey's rooms that it describes the storey."""
    return sum(room.gross for room in asked) >= _DESCRIBED * capacity


def is_needed(kind: RoomType, use: BuildingType) -> bool:
    """Whether a storey has a room of its type's own list also where the brief describes it.

    It serves the others, or it is what such a building is known by: the bookshelves of a library.
    """
    return kind.name in _NEEDED or kind.suggests == use.name


def reach(rooms: Sequence[PlannedRoom]) -> float:
    """Return the square metres to which rooms grow together and still have sensible sizes."""
    return sum(_reach(room) for top in rooms for room in top.each())


def _reach(room: PlannedRoom) -> float:
    if room.fixed:
        return room.area
    times = _FLEXIBLE if room.kind.flexible else _SERVING if _serves(room.kind) else _OTHERS
    times = times if room.stated else max(1.0, _UNASKED * times)
    return max(min(room.most, times * room.area), room.area)


def growth_weight(room: PlannedRoom) -> float:
    """Return by how much more or less than others a room grows where a storey has area to spare."""
    if room.kind.flexible:
        return 1.3 if room.stated else 1.05
    little = (_serves(room.kind) and not room.stated) or room.kind.name in _BATHS
    return 0.5 if little else 1.0


_BATHS: Final = frozenset({"bathroom", "ensuite_bathroom", "toilet"})
"""Rooms for one at a time; those for many grow with the rooms of these."""


def weight_beyond(room: PlannedRoom) -> float:
    """Return the same where all rooms have the most that is sensible: nobody wants a toilet or a store larger then."""
    serves = room.kind.zone == "service" and not (room.kind.flexible or room.kind.daylight)
    hardly = serves or room.kind.toilet or room.kind.name in _BATHS
    return _HARDLY if hardly else growth_weight(room)


_HARDLY: Final = 0.15


def _serves(kind: RoomType) -> bool:
    """Whether a room keeps things or machines, which want no more floor than they need."""
    return kind.zone == "service" and not kind.wet and not kind.flexible
