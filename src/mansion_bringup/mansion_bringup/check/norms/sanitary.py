"""Rules on toilets and washbasins for those who use a building, and on wet rooms above one another."""

import math
from collections.abc import Iterator

from shapely.ops import unary_union

from mansion_bringup.check.norms.premises import ROUNDING, Deviation, Premises
from mansion_bringup.check.norms.room_quality import sides_of
from mansion_bringup.check.shapes import net_area, room_area
from mansion_geometry.object_footprints import footprint
from mansion_knowledge.norms import Norm
from mansion_msgs_py.scene import SceneRoom
from mansion_msgs_py.wording import counted

__all__ = ["sanitary_deviations"]

_BASIN = 0.6
"""Metres of a row of washbasins for one of them."""


def sanitary_deviations(premises: Premises) -> Iterator[Deviation]:
    """Yield deviations from the rules of sanitary rooms."""
    yield from _water_closets(premises)
    yield from _separate_toilets(premises)
    yield from _accessible_toilet(premises)
    yield from _accessible_toilet_size(premises)
    yield from _public_toilet(premises)
    yield from _washbasins(premises)
    yield from _toilet_storey(premises)
    yield from _service_sink(premises)
    yield from _home_fixtures(premises)
    yield from _wet_stack(premises)


def _public_toilets(premises: Premises) -> list[SceneRoom]:
    rooms = premises.of_types(premises.norms.rules["public_toilet"].rooms)
    return [room for room in rooms if not premises.serves_unit(room)]


def _water_closets(premises: Premises) -> Iterator[Deviation]:
    men, women = premises.norm("water_closets_men"), premises.norm("water_closets_women")
    if men is None or women is None:
        return
    people = sum(premises.people(scene) for scene in premises.scenes)
    there = premises.pieces(men, premises.rooms())
    shares = [people / 2 / premises.limit(norm) for norm in (men, women)]
    separate = premises.norm("separate_toilets")
    if separate is not None and people <= premises.limit(separate):
        least = max(1, math.ceil(sum(shares)))
        if there < least:
            found = f"{there} water closets and urinals"
            yield premises.deviation(women, "building", found, f"{least} for {people} occupants of both sexes")
        return
    needed = [max(1, math.ceil(share)) for share in shares]
    for_men = round(there * needed[0] / sum(needed))
    for norm, least, own in zip((men, women), needed, (for_men, there - for_men)):
        if own < least:
            asked = f"{least} for {people / 2:.0f} {norm.unit}"
            yield premises.deviation(norm, "building", f"{own} of {there} water closets and urinals", asked)


def _separate_toilets(premises: Premises) -> Iterator[Deviation]:
    """Yield that men and women share toilets; two accessible ones serve where one closet is enough for each."""
    norm = premises.norm("separate_toilets")
    people = sum(premises.people(scene) for scene in premises.scenes)
    if norm is None or people <= premises.limit(norm):
        return
    rules = premises.norms.rules
    one_each = all(people / 2 <= premises.limit(rules[name]) for name in ("water_closets_men", "water_closets_women"))
    names = (*norm.rooms, *norm.others) if one_each else norm.rooms
    restrooms = {room.id for room in _public_toilets(premises) if premises.is_one_of(room, names)}
    found = max(len(restrooms & {room.id for room in scene.rooms}) for scene in premises.scenes)
    if found < 2:
        asked = f"2 side by side for {people} occupants, as above {premises.limit(norm):.0f}"
        yield premises.deviation(norm, "building", f"{found} restroom" + "s" * (found != 1) + " a storey", asked)


def _accessible_toilet(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("accessible_toilet")
    toilets = _public_toilets(premises)
    if norm is None or not toilets or any(premises.is_one_of(room, norm.rooms) for room in toilets):
        return
    if not any(_turns(premises, room, norm.figure) for room in toilets):
        asked = f"an accessible toilet, or a free circle of {norm.figure} m in one"
        yield premises.deviation(norm, toilets[0].id, "no wheelchair turns in any public toilet", asked)


def _turns(premises: Premises, room: SceneRoom, diameter: float) -> bool:
    scene = next(scene for scene in premises.scenes if any(other.id == room.id for other in scene.rooms))
    taken = [footprint(item) for item in scene.objects if item.room == room.id and item.mount == "floor"]
    return not net_area(room).difference(unary_union(taken)).buffer(-diameter / 2).is_empty


def _public_toilet(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("public_toilet")
    if norm is None or not premises.limit(norm):
        return
    ground = {room.id for scene in premises.scenes if scene.floor == 1 for room in scene.rooms}
    if not any(room.id in ground for room in _public_toilets(premises)):
        yield premises.deviation(norm, "floor 1", "no toilet for visitors", "one on the entrance storey")


def _washbasins(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("washbasins")
    if norm is not None:
        people = sum(premises.people(scene) for scene in premises.scenes)
        needed, there = max(1, math.ceil(people / premises.limit(norm))), _basins(premises, norm, None)
        if there < needed:
            yield premises.deviation(norm, "building", counted(there, "washbasin"), f"{needed} for {people} occupants")
    norm = premises.norm("toilet_washbasin")
    for room in premises.of_types(norm.rooms) if norm is not None else ():
        if norm is not None and not _basins(premises, norm, room.id):
            yield premises.deviation(norm, room.id, "no washbasin", "one")


def _basins(premises: Premises, norm: Norm, room: str | None) -> int:
    """Return the washbasins of a room or of the building; a row counts as many as fit side by side."""
    return sum(
        max(1, round(item.size[0] / _BASIN)) if item.category == "sink_row" else 1
        for scene in premises.scenes
        for item in scene.objects
        if item.category in norm.things and room in (None, item.room)
    )


def _toilet_storey(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("toilet_storey")
    if norm is None:
        return
    toilets = {room.id for room in premises.of_types(norm.rooms)}
    floors = [scene.floor for scene in premises.scenes if any(room.id in toilets for room in scene.rooms)]
    for scene in premises.scenes:
        away = min((abs(scene.floor - floor) for floor in floors), default=math.inf)
        if premises.people(scene) and away > premises.limit(norm):
            found = f"the nearest toilet is {away} storeys away" if floors else "no toilet in the building"
            yield premises.deviation(norm, f"floor {scene.floor}", found, f"at most {premises.limit(norm):.0f}")


def _service_sink(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("service_sink")
    if norm is not None and _basins(premises, norm, None) < premises.limit(norm):
        yield premises.deviation(norm, "building", "no sink for cleaning", "one")


def _home_fixtures(premises: Premises) -> Iterator[Deviation]:
    for name in ("home_toilet", "home_bath", "home_sink"):
        norm = premises.norm(name)
        if norm is not None and not premises.pieces(norm, premises.rooms()):
            yield premises.deviation(norm, "building", f"no {norm.unit}", "one")


def _accessible_toilet_size(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("accessible_toilet_size")
    for room in premises.of_types(norm.rooms) if norm is not None else ():
        assert norm is not None
        short, long = sides_of(room)
        if short < norm.figure - ROUNDING or long < norm.limit("length") - ROUNDING:
            asked = f"{norm.figure} by {norm.limit('length')} m"
            yield premises.deviation(norm, room.id, f"{short:.2f} by {long:.2f} m", asked)


def _wet_stack(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("wet_stack")
    by_floor = {scene.floor: scene for scene in premises.scenes}
    if norm is None:
        return
    for room in premises.of_types(norm.rooms):
        floor = next(scene.floor for scene in premises.scenes if room in scene.rooms)
        below = by_floor.get(floor - 1)
        if floor < 2 or below is None:
            continue
        wet = [room_area(r) for r in below.rooms if premises.knowledge.room(r.room_type).wet]
        distance = min((room_area(room).distance(shape) for shape in wet), default=math.inf)
        if distance > premises.limit(norm):
            found = f"{distance:.1f} m from the nearest wet room below" if wet else "no wet room below"
            yield premises.deviation(norm, room.id, found, f"at most {norm.figure} m")
