"""The furniture that each bedroom of a home gets: for two people in the main one of a floor, for one in the others."""

from collections.abc import Sequence

from mansion_knowledge import default_knowledge, kin_of
from mansion_knowledge.essentials import needs_of
from mansion_msgs_py.scene import SceneRoom

__all__ = ["slept_in_as"]

_BEDROOM, _MAIN, _OTHER = "bedroom", "master_bedroom", "smaller_bedroom"

_FOR_TWO = 15.0
"""Area from which another bedroom, too, has the furniture of one for any number, square metres."""


def slept_in_as(room: SceneRoom, rooms: Sequence[SceneRoom], building_type: str) -> str:
    """Return the type whose furniture a room gets, by its place among the bedrooms of a home.

    Parameters
    ----------
    room : SceneRoom
        Any room; one that is no plain bedroom keeps its type.
    rooms : sequence of SceneRoom
        All rooms of its floor.
    building_type : str
        Households live in some; one that the knowledge does not know counts as such.

    Notes
    -----
    The largest of the plain bedrooms is the main one where no room is called so. On a floor with several kitchens, and
    so several homes, bedrooms stay as they are.
    """
    knowledge = default_knowledge()
    home = building_type not in knowledge.buildings or knowledge.is_dwelling(building_type)
    kitchens = sum(kin_of(other.room_type) == "kitchen" for other in rooms)
    if room.room_type != _BEDROOM or not home or kitchens > 1 or _stated(room):
        return room.room_type
    plain = [other for other in rooms if other.room_type == _BEDROOM and not _stated(other)]
    main = max(plain, key=lambda other: (round(other.area, 2), other.id), default=room)
    if not any(other.room_type == _MAIN for other in rooms) and main.id == room.id:
        return _MAIN
    return _OTHER if room.area < _FOR_TWO else _BEDROOM


def _stated(room: SceneRoom) -> bool:
    """Tell whether a room's name says how many sleep in it."""
    return needs_of(_BEDROOM, (room.name, *room.aliases)) != needs_of(_BEDROOM)
