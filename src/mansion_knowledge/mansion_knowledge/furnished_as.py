"""The type whose furniture a room gets, where its building or its name says more than its own type."""

import re
from collections.abc import Collection
from functools import cache
from importlib.resources import files

import msgspec

from mansion_knowledge.base import default_knowledge
from mansion_msgs_py.codec import prepared

__all__ = ["furnished_as"]


class _Rule(msgspec.Struct, frozen=True, forbid_unknown_fields=True, rename={"as_": "as"}):
    why: str
    as_: str
    rooms: list[str] = []
    buildings: list[str] = []
    families: list[str] = []
    names: list[str] = []
    beside: list[str] = []


class _Rules(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    rule: list[_Rule]


@cache
def _rules() -> list[_Rule]:
    text = files("mansion_knowledge").joinpath("data", "furnished_as.toml").read_bytes()
    return msgspec.toml.decode(text, type=prepared(_Rules)).rule


def furnished_as(
    room_type: str, building_type: str = "", name: str = "", beside: Collection[str] = (), called: str = ""
) -> str:
    """Return the type whose furniture a room gets: its own, but for what `furnished_as.toml` states.

    Parameters
    ----------
    room_type : str
    building_type : str
    name : str
        What people call the room.
    beside : collection of str
        Types of the other rooms of its floor.
    called : str
        What the brief calls the building, where that says more than its type: a `bookshop` of type `shop_building`.

    Examples
    --------
    >>> furnished_as("gym", "primary_school"), furnished_as("gym", "hotel")
    ('sports_hall', 'gym')
    >>> furnished_as("vip_room", "restaurant", "private dining room")
    'private_dining_room'
    >>> furnished_as("roof_terrace", "villa"), furnished_as("roof_terrace", "hotel")
    ('home_terrace', 'roof_terrace')
    >>> furnished_as("sales_area", "shop_building", called="bookshop")
    'bookshop_floor'
    """
    building, words = _words(f"{building_type} {called}"), _words(name)
    for rule in _rules():
        if (
            (not rule.rooms or room_type in rule.rooms)
            and (not rule.buildings or building.intersection(rule.buildings))
            and (not rule.families or _family(building_type) in rule.families)
            and (not rule.names or words.intersection(rule.names))
            and (not rule.beside or any(other in rule.beside for other in beside))
        ):
            return rule.as_
    return room_type


def _words(text: str) -> set[str]:
    """Return the words of a name, possessives without their apostrophe."""
    return set(re.findall(r"[a-z0-9]+", re.sub("['\u2019]", "", text.lower())))


def _family(building_type: str) -> str:
    """Return the family of a building type; empty for one that is not known."""
    known = default_knowledge().buildings.get(building_type.lower().replace(" ", "_"))
    return known.family if known is not None else ""
