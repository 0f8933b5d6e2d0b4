"""Rules on what guests, patients and residents have for themselves or share: toilets, showers, kitchens."""

import math
from collections.abc import Iterator, Sequence

from mansion_bringup.check.norms.door_graph import behind, door_graph
from mansion_bringup.check.norms.premises import Deviation, Premises, rooms_of
from mansion_knowledge.norms import Norm
from mansion_msgs_py.scene import SceneRoom

__all__ = ["unit_deviations"]

_BEDS = {"bunk_bed": 2}
"""People who sleep in a bed, where they are more than one for each 0.9 m of its width."""


def unit_deviations(premises: Premises) -> Iterator[Deviation]:
    """Yield deviations from the rules of dwellings and of rooms that people sleep in."""
    yield from _showers(premises)
    yield from _own(premises, "unit_toilet", "no toilet of its own")
    yield from _own(premises, "dwelling_kitchen", "no kitchen sink")
    yield from _shared(premises, "shared_toilets", "toilet")
    yield from _shared(premises, "shared_showers", "shower")


def _showers(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("sleeping_unit_shower")
    if norm is None:
        return
    baths = premises.of_types(norm.rooms)
    own = [room for room in baths if premises.serves_unit(room)]
    for room in own:
        if not premises.pieces(norm, [room]):
            yield premises.deviation(norm, room.id, "no bathtub and no shower", "one")
    shared = [room for room in baths if room not in own]
    if premises.family == "home" and shared and not own and not premises.pieces(norm, shared):
        yield premises.deviation(norm, shared[0].id, "no bathtub and no shower in the dwelling", "one")


def _own(premises: Premises, name: str, found: str) -> Iterator[Deviation]:
    """Yield rooms without a thing in them or in the rooms behind them."""
    norm = premises.norm(name)
    for room in premises.of_types(norm.rooms) if norm is not None else ():
        if norm is not None and not premises.pieces(norm, _unit(premises, room)):
            yield premises.deviation(norm, room.id, found, "one")
    if norm is not None and name == "dwelling_kitchen" and premises.family == "home":
        rooms = list(premises.rooms())
        if not premises.pieces(norm, rooms):
            yield premises.deviation(norm, "building", found, "one")


def _unit(premises: Premises, room: SceneRoom) -> list[SceneRoom]:
    """Return a room and those that are reached through it alone."""
    scene = next(scene for scene in premises.scenes if any(other.id == room.id for other in scene.rooms))
    inner = behind(door_graph(scene), room.id)
    return [room, *(other for other in rooms_of(scene) if other.id in inner)]


def _shared(premises: Premises, name: str, thing: str) -> Iterator[Deviation]:
    """Yield where the building's shared fixtures are too few for the sleepers without fixtures of their own."""
    norm = premises.norm(name)
    if norm is None:
        return
    rooms = [room for room in premises.of_types(norm.rooms) if not premises.pieces(norm, _unit(premises, room))]
    sleepers = sum(_sleepers(premises, room) for room in rooms)
    needed = math.ceil(sleepers / premises.limit(norm))
    there = premises.pieces(norm, _common(premises, norm))
    if there < needed:
        asked = f"{needed} for {sleepers} sleepers, one for {premises.limit(norm):.0f}"
        yield premises.deviation(norm, "building", f"{there} shared {thing}{'s' * (there != 1)}", asked)


def _common(premises: Premises, norm: Norm) -> Sequence[SceneRoom]:
    units = {other.id for room in premises.of_types(norm.rooms) for other in _unit(premises, room)}
    return [room for room in premises.rooms() if room.id not in units and not premises.serves_unit(room)]


def _sleepers(premises: Premises, room: SceneRoom) -> int:
    return sum(
        _BEDS.get(item.category, max(1, int(item.size[0] / 0.9 + 0.02)))
        for scene in premises.scenes
        for item in scene.objects
        if item.room == room.id and (item.category == "bed" or item.category.endswith("_bed"))
    )
