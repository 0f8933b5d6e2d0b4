"""Furniture that a room cannot be used without: what is missing or does not fit, and whose furniture a bedroom gets."""

import math
from collections.abc import Iterable, Sequence

import msgspec

from mansion_assets.catalogue import Asset, Catalogue
from mansion_assets.catalogue.records import Extent, Item
from mansion_knowledge import default_knowledge, kin_of
from mansion_knowledge.essentials import Need, needs_of, pieces_there, still_wanted
from mansion_msgs_py.program import RequestedObject
from mansion_msgs_py.scene import Discard, SceneObject, SceneRoom

__all__ = ["essential_items", "essential_requests", "essentials_of", "lacking", "left_out", "slept_in_as"]


def essentials_of(room: SceneRoom, requested: Iterable[RequestedObject] = ()) -> list[Need]:
    """Return what a room cannot be used without, except what the brief does not want in it."""
    unwanted = [request.category for request in requested if not request.count]
    return still_wanted(needs_of(room.room_type, (room.name, *room.aliases)), unwanted)


def lacking(needs: Iterable[Need], objects: Iterable[SceneObject]) -> dict[Need, int]:
    """Return how much of each need the objects of a room leave unmet, of those alone that they do."""
    things = [(thing.category, thing.size[0]) for thing in objects]
    short = {need: need.count - pieces_there(need, things) for need in needs}
    return {need: count for need, count in short.items() if count > 0}


def essential_requests(
    catalogue: Catalogue, room_type: str, needs: Iterable[Need], *, smallest: bool
) -> list[RequestedObject]:
    """Return needs as requests for furniture.

    Parameters
    ----------
    smallest : bool
        Whether the smallest of the objects that meet a need is asked for; else the one that such rooms usually have.
    """
    requests = list[RequestedObject]()
    for need in needs:
        category = _smallest(catalogue, need) if smallest else _usual(catalogue, room_type, need)
        if category:
            widths = [asset.size[0] for asset in catalogue.by_category(category)]
            each = need.pieces(category, min(widths) if smallest else max(widths))
            row = any(asset.recipe == "seat_row" for asset in catalogue.by_category(category))
            count = need.count if row else math.ceil(need.count / each)
            requests.append(RequestedObject(category=category, count=count))
    return requests


def essential_items(catalogue: Catalogue, items: Sequence[Item], needs: Iterable[Need]) -> list[Item]:
    """Return floor objects of which those for several people are wide enough: a bed for two, not one for one."""
    out = list(items)
    for need in needs:
        for thing in need.things:
            width = thing.place * min(need.count, thing.most)
            for number, item in enumerate(out):
                names = [item.category] if isinstance(item.category, str) else item.category
                fitting = [name for name in names if name in thing.categories]
                if fitting and width and any(a.size[0] >= width for a in catalogue.choose_from(fitting, item.extent)):
                    out[number] = msgspec.structs.replace(item, category=fitting, extent=_wider(item.extent, width))
                    break
    return out


def _wider(extent: Extent | None, width: float) -> Extent:
    bounds = extent or Extent()
    return msgspec.structs.replace(bounds, min=(max(width, bounds.min[0]), *bounds.min[1:]))


def _usual(catalogue: Catalogue, room_type: str, need: Need) -> str:
    """Return the category of the room type's own furniture that meets a need, else the most usual of the need's."""
    card = catalogue.room_program(room_type)
    floor = sorted(card.floor, key=lambda item: item.p < 1.0)
    held = [*(item.category for item in floor), *(item.category for item in (*card.wall, *card.ceiling))]
    held += [item.category for item in card.rugs]
    names = [name for one in held for name in ([one] if isinstance(one, str) else one)]
    known = [name for name in need.categories if catalogue.by_category(name)]
    return next((name for name in names if name in known), next(iter(known), ""))


def _smallest(catalogue: Catalogue, need: Need) -> str:
    asset = _least(catalogue, need)
    return "" if asset is None else asset.category


def _least(catalogue: Catalogue, need: Need) -> Asset | None:
    """Return the asset that takes the least floor of those that meet a need; one on the floor before any other."""
    assets = [asset for name in need.categories for asset in catalogue.by_category(name)]
    return min(assets, key=lambda a: (a.mount != "floor", a.footprint, a.key), default=None)


def left_out(catalogue: Catalogue, room: SceneRoom, short: dict[Need, int]) -> list[Discard]:
    """Return for each unmet need what is not there, and why."""
    out = []
    for need, count in short.items():
        asset = _least(catalogue, need)
        if asset is None:
            reason = "the catalogue has none"
        elif asset.mount == "floor":
            reason = f"no place of {asset.size[0]:.1f} x {asset.size[1]:.1f} m that can be reached is free"
        else:
            reason = "no place for it is free"
        out.append(Discard(room=room.id, name=need.name, count=count, reason=reason))
    return out


_BEDROOM, _MAIN, _OTHER = "bedroom", "master_bedroom", "smaller_bedroom"

_FOR_TWO = 15.0
"""Area from which another bedroom, too, has the furniture of one for any number, square metres."""


def slept_in_as(room: SceneRoom, rooms: Sequence[SceneRoom], building_type: str) -> str:
    """Return the type whose furniture a room gets, by its place among the bedrooms of a home.

    Parameters
    ----------
    room : SceneRoom
        Any room; one that is not a plain bedroom keeps its type.
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
