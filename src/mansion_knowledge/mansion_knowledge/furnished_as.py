"""The type whose furniture a room gets, where its building or its name says more than its own type."""

from functools import cache
from importlib.resources import files

import msgspec

from mansion_msgs_py.codec import prepared

__all__ = ["furnished_as"]


class _Rule(msgspec.Struct, frozen=True, forbid_unknown_fields=True, rename={"as_": "as"}):
    why: str
    rooms: list[str]
    as_: str
    buildings: list[str] = []
    names: list[str] = []


class _Rules(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    rule: list[_Rule]


@cache
def _rules() -> list[_Rule]:
    text = files("mansion_knowledge").joinpath("data", "furnished_as.toml").read_bytes()
    return msgspec.toml.decode(text, type=prepared(_Rules)).rule


def furnished_as(room_type: str, building_type: str = "", name: str = "") -> str:
    """Return the type whose furniture a room gets: its own, but for what `furnished_as.toml` states.

    Parameters
    ----------
    room_type : str
    building_type : str
    name : str
        What people call the room.

    Examples
    --------
    >>> furnished_as("gym", "primary_school"), furnished_as("gym", "hotel")
    ('sports_hall', 'gym')
    >>> furnished_as("vip_room", "restaurant", "private dining room")
    'private_dining_room'
    """
    building, called = (set(text.lower().replace("_", " ").split()) for text in (building_type, name))
    for rule in _rules():
        if (
            room_type in rule.rooms
            and (not rule.buildings or building.intersection(rule.buildings))
            and (not rule.names or called.intersection(rule.names))
        ):
            return rule.as_
    return room_type
