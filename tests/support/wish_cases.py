"""Wishes of every kind on the hand-made house, each with what becomes of it."""

from typing import Literal

import msgspec

from mansion_msgs_py.wishes import Scope, Wish, WishStatus, WishValue
from wish_house import wish

__all__ = ["CASES"]


def _room(name: str, count: int | None = 1, area: float | None = None, kind: str = "", **scope: object) -> Wish:
    place = Scope(**scope)  # type: ignore[arg-type]
    return wish("room", WishValue(name=name, type=kind or name, count=count, area=area), place)


def _thing(
    name: str,
    category: str,
    count: int | None,
    room: str = "",
    room_type: str = "",
    *,
    each: bool = False,
    exact: bool = False,
) -> Wish:
    scope = Scope(room=room, room_type=room_type or room, each=each)
    return wish("object", WishValue(name=name, type=category, count=count, exact=exact), scope)


def _ranked(name: str, rank: Literal["largest", "smallest"]) -> Wish:
    kind = name.partition("_")[0]
    return wish("room", WishValue(name=name, type=kind, count=1, rank=rank))


def _some(name: str, category: str, count: int, some: int, *words: str, exact: bool = False) -> Wish:
    value = WishValue(name=name, type=category, count=count, exact=exact, unheeded=list(words))
    return wish("object", value, Scope(room="bedroom", room_type="bedroom", some=some))


def _bound(name: str, count: int, area: float, limit: Literal["most", "least"]) -> WishValue:
    return WishValue(name=name, type=name, count=count, area=area, limit=limit)


def _with(name: str, *words: str) -> WishValue:
    return WishValue(name=name, type=name, count=1, unheeded=list(words))


def _pair(first: str, second: str) -> WishValue:
    return WishValue(name=first, type=first, other=second, other_type=second)


def _between(room: str, others: str) -> WishValue:
    return msgspec.structs.replace(_pair(room, others), count=2)


def _opposite(first: str, second: str) -> WishValue:
    return msgspec.structs.replace(_pair(first, second), unheeded=["opposite"])


def _made_of(material: str, surface: str = "floor", room_type: str = "", *, each: bool = False) -> Wish:
    return wish("material", WishValue(name=material, type=surface), Scope(room_type=room_type, each=each))


def _only(name: str, category: str, count: int) -> Wish:
    return wish("object", WishValue(name=name, type=category, count=count, exact=True, limit="most"))


CASES: list[tuple[str, Wish, WishStatus]] = [
    ("type", wish("building_type", WishValue(name="house", type="house")), "met"),
    ("other type", wish("building_type", WishValue(name="clinic", type="clinic")), "not_met"),
    (
        "small for its type",
        wish("building_type", WishValue(name="house", type="house", area=190.0, limit="most")),
        "met",
    ),
    ("not so small", wish("building_type", WishValue(name="house", type="house", area=120.0, limit="most")), "partly"),
    ("not so large", wish("building_type", WishValue(name="house", type="house", area=300.0, limit="least")), "partly"),
    ("two floors", wish("floors", WishValue(count=2)), "met"),
    ("three floors", wish("floors", WishValue(count=3)), "not_met"),
    ("no basement", wish("basements", WishValue(count=0)), "met"),
    ("a basement", wish("basements", WishValue(count=1)), "not_met"),
    ("whole area", wish("total_area", WishValue(area=170.0)), "met"),
    ("area missed by little", wish("total_area", WishValue(area=190.0)), "partly"),
    ("area missed", wish("total_area", WishValue(area=400.0)), "not_met"),
    ("area at most that", wish("total_area", WishValue(area=190.0, limit="most")), "met"),
    ("area at most a little less", wish("total_area", WishValue(area=80.0, limit="most")), "not_met"),
    ("area at least that", wish("total_area", WishValue(area=150.0, limit="least")), "met"),
    ("storeys at least that large", wish("floor_area", WishValue(area=90.0, limit="least")), "not_met"),
    ("area above ground", wish("total_area", WishValue(area=160.0), Scope(floors=[1, 2])), "met"),
    ("area of some storeys", wish("total_area", WishValue(area=160.0), Scope(floors=[1])), "not_met"),
    (
        "neighbours without a door",
        wish("adjacent", msgspec.structs.replace(_pair("kitchen", "dining_room"), door=True)),
        "partly",
    ),
    ("room a little smaller", _room("kitchen", area=16.9), "met"),
    ("room smaller than asked", _room("kitchen", area=18.3), "partly"),
    ("area of a storey", wish("floor_area", WishValue(area=85.0)), "met"),
    ("large storey", wish("floor_area", WishValue(area=200.0)), "not_met"),
    ("rectangle", wish("outline", WishValue(name="rectangle")), "met"),
    ("square", wish("outline", WishValue(name="square")), "not_met"),
    ("L", wish("outline", WishValue(name="L")), "not_met"),
    ("style", wish("style", WishValue(name="modern")), "met"),
    ("other style", wish("style", WishValue(name="rustic")), "not_met"),
    ("use", wish("use", WishValue(name="house", type="house"), Scope(floors=[1, 2])), "met"),
    ("a room is no use", wish("use", WishValue(name="kitchen"), Scope(floors=[1])), "not_met"),
    ("use of no storey", wish("use", WishValue(name="house"), Scope(floors=[7])), "not_met"),
    ("copy", wish("copy", WishValue(), Scope(floors=[1, 2])), "not_met"),
    ("copy of storeys not there", wish("copy", WishValue(), Scope(floors=[2, 3])), "not_met"),
    ("stair", wish("stair"), "met"),
    ("two stairs", wish("stair", WishValue(count=2)), "partly"),
    ("lift", wish("elevator"), "not_met"),
    ("no lift", wish("elevator", WishValue(unwanted=True)), "met"),
    ("no stair", wish("stair", WishValue(unwanted=True)), "not_met"),
    ("two bedrooms", _room("bedroom", 2), "met"),
    ("several bedrooms", _room("bedroom", None), "met"),
    ("several kitchens", _room("kitchen", None), "partly"),
    ("three bedrooms", _room("bedroom", 3), "partly"),
    ("bedrooms below", _room("bedroom", 2, floors=[1]), "partly"),
    ("gym", _room("gym"), "not_met"),
    ("by another name", _room("pottery_room", kind="study_room"), "met"),
    ("by its type", _room("den", kind="study_room"), "met"),
    ("large bedrooms", _room("bedroom", 2, 16.5), "met"),
    ("bedrooms at least that large", wish("room", _bound("bedroom", 2, 12.0, "least")), "met"),
    ("bedrooms at most that large", wish("room", _bound("bedroom", 2, 12.0, "most")), "partly"),
    ("soundproof kitchen", wish("room", _with("kitchen", "soundproof")), "partly"),
    (
        "a stool for a sofa",
        msgspec.structs.replace(_thing("sofa", "sofa", 1, "living_room"), reason="a sofa stands for it"),
        "partly",
    ),
    (
        "a bed that is no double bed",
        wish("object", WishValue(name="bed", type="bed", count=1, unheeded=["double"])),
        "partly",
    ),
    (
        "a bed that is a single bed",
        wish("object", WishValue(name="bed", type="bed", count=1, unheeded=["single"])),
        "met",
    ),
    ("red sofa", wish("object", WishValue(name="sofa", type="sofa", count=1, unheeded=["red"])), "partly"),
    ("larger bedrooms", _room("bedroom", 2, 25.0), "partly"),
    ("hallway on each storey", _room("hallway", 1, floors=[1, 2], each=True), "met"),
    ("kitchen on each storey", _room("kitchen", 1, floors=[1, 2], each=True), "partly"),
    ("bedroom with a hallway", _room("hallway", 2, room="bedroom_1", room_type="bedroom"), "met"),
    ("more hallways than it needs", _room("hallway", 1, room="bedroom_1", room_type="bedroom"), "met"),
    ("bedrooms with a hallway", _room("hallway", 2, room="bedroom", room_type="bedroom"), "partly"),
    ("no gym", wish("no_room", WishValue(name="gym", type="gym", unwanted=True)), "met"),
    ("no kitchen", wish("no_room", WishValue(name="kitchen", type="kitchen", unwanted=True)), "not_met"),
    ("no kitchen above", wish("no_room", WishValue(type="kitchen", unwanted=True), Scope(floors=[2])), "met"),
    ("side by side", wish("adjacent", _pair("kitchen", "dining_room")), "met"),
    ("a corner is no wall", wish("adjacent", _pair("bedroom_1", "kitchen")), "not_met"),
    ("each beside one", wish("adjacent", _pair("kitchen", "dining_room"), Scope(each=True)), "met"),
    (
        "beside two of them",
        wish("adjacent", msgspec.structs.replace(_between("pottery_room", "bedroom"), type="study_room")),
        "met",
    ),
    ("beside one of the two", wish("adjacent", _between("hallway", "bedroom")), "partly"),
    ("opposite", wish("adjacent", _opposite("kitchen", "dining_room")), "partly"),
    ("no such neighbour", wish("adjacent", _pair("kitchen", "gym")), "not_met"),
    ("apart", wish("apart", _pair("hallway", "dining_room")), "met"),
    ("not apart", wish("apart", _pair("kitchen", "dining_room")), "not_met"),
    ("sofa", _thing("sofa", "sofa", 1, "living_room"), "met"),
    ("two sofas", _thing("sofas", "sofa", 2, "living_room"), "partly"),
    ("sofa in the kitchen", _thing("sofa", "sofa", 1, "kitchen"), "not_met"),
    ("not in the catalogue", _thing("harp", "", 1), "not_met"),
    ("an office desk is a desk", _thing("desks", "desk", 2, "pottery_room", "study_room"), "met"),
    ("no more desks", _thing("desks", "desk", 2, "pottery_room", "study_room", exact=True), "met"),
    ("more desks than asked for", _thing("desk", "desk", 1, "pottery_room", "study_room", exact=True), "partly"),
    ("a coffee table is a table", _thing("tables", "dining_table", 1, "living_room"), "met"),
    ("a table more of another kind", _thing("tables", "dining_table", 1, "living_room", exact=True), "met"),
    ("it is no dining table", _thing("dining_tables", "dining_table", 1, "living_room"), "not_met"),
    ("beds anywhere", _thing("beds", "bed", 3), "met"),
    ("a bed in each", _thing("bed", "bed", 1, "bedroom", each=True), "met"),
    ("two beds in each", _thing("beds", "bed", 2, "bedroom", each=True), "partly"),
    ("a bed on each storey", _thing("bed", "bed", 1, each=True), "partly"),
    ("no television", wish("no_object", WishValue(name="television", type="television", unwanted=True)), "met"),
    ("no sofa", wish("no_object", WishValue(name="sofa", type="sofa", unwanted=True)), "not_met"),
    ("only three beds", _only("beds", "bed", 3), "met"),
    ("only two beds", _only("beds", "bed", 2), "partly"),
    ("no carpets", wish("no_object", WishValue(name="carpets", type="rug", unwanted=True)), "met"),
    ("oak everywhere", _made_of("oak", each=True), "met"),
    ("oak of another colour", _made_of("black oak", room_type="kitchen"), "partly"),
    ("dark oak", _made_of("dark oak"), "partly"),
    ("white drywall", _made_of("white drywall", "wall", "kitchen"), "met"),
    ("a material of no room", _made_of("oak", room_type="gym"), "not_met"),
    ("ceilings", wish("height", WishValue(height=2.8)), "met"),
    ("high ceilings", wish("height", WishValue(height=3.5)), "not_met"),
    ("ceilings of no room", wish("height", WishValue(height=2.8), Scope(room_type="gym")), "not_met"),
    ("wooden floors", wish("material", WishValue(name="wooden", type="floor")), "met"),
    ("wooden walls", wish("material", WishValue(name="wooden", type="wall")), "not_met"),
    ("white walls", wish("material", WishValue(name="white", type="wall")), "met"),
    ("forty people", wish("occupants", WishValue(name="visitor", count=40)), "met"),
    ("forty sleepers", wish("occupants", WishValue(name="resident", count=40)), "partly"),
    ("crowd", wish("occupants", WishValue(name="guest", count=4000)), "not_met"),
    ("only", wish("only"), "not_met"),
    ("unread", wish("unread"), "not_understood"),
    ("the largest of its type", _ranked("bedroom_1", "largest"), "met"),
    (
        "not the largest",
        wish("room", WishValue(name="dining_room", type="living_room", count=1, rank="largest")),
        "partly",
    ),
    ("the only one of its type", _ranked("kitchen", "smallest"), "met"),
    ("of the wood that is named", _made_of("oak"), "met"),
    ("of another wood", _made_of("pine"), "partly"),
    ("in one of two rooms", _some("beds", "bed", 2, 1), "met"),
    ("exactly so many in one of two rooms", _some("beds", "bed", 1, 1, exact=True), "met"),
    ("in one room too few", _some("beds", "bed", 3, 1), "partly"),
    ("in both of two rooms", _some("beds", "bed", 4, 2), "partly"),
    ("in one room, more than so many in each", _some("beds", "bed", 2, 2, exact=True), "partly"),
    ("in one room, as it is to be", _some("beds", "bed", 1, 1, "round"), "partly"),
    ("in none of two rooms", _some("desks", "desk", 1, 1), "not_met"),
]
"""What the wish is, the wish, and the status that the house gives it."""
