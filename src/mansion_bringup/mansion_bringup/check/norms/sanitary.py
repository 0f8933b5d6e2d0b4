"""Toilets, showers, and wet rooms above each other."""

import math
from collections.abc import Iterator

from shapely.ops import unary_union

from mansion_bringup.check.norms.premises import Deviation, Premises
from mansion_bringup.check.shapes import net_area, room_area
from mansion_geometry.object_footprints import footprint
from mansion_knowledge.norms import Norm
from mansion_msgs_py.scene import SceneRoom

__all__ = ["sanitary_deviations"]


def sanitary_deviations(premises: Premises) -> Iterator[Deviation]:
    """Yield deviations from the rules of sanitary rooms."""
    yield from _water_closets(premises)
    yield from _separate_toilets(premises)
    yield from _accessible_toilet(premises)
    yield from _public_toilet(premises)
    yield from _unit_showers(premises)
    yield from _wet_stack(premises)


def _fixtures(premises: Premises, norm: Norm, rooms: list[SceneRoom]) -> int:
    ids = {room.id for room in rooms}
    return sum(item.room in ids and item.category in norm.things for scene in premises.scenes for item in scene.objects)


def _public_toilets(premises: Premises) -> list[SceneRoom]:
    rooms = premises.of_types(premises.norms.rules["public_toilet"].rooms)
    return [room for room in rooms if not premises.serves_unit(room)]


def _water_closets(premises: Premises) -> Iterator[Deviation]:
    men, women = premises.norm("water_closets_men"), premises.norm("water_closets_women")
    if men is None or women is None:
        return
    half = sum(premises.people(scene) for scene in premises.scenes) / 2
    needed = [max(1, math.ceil(half / premises.limit(norm))) for norm in (men, women)]
    there = _fixtures(premises, men, list(premises.rooms()))
    for_men = round(there * needed[0] / sum(needed))
    for norm, least, found in zip((men, women), needed, (for_men, there - for_men)):
        if found < least:
            asked = f"{least} for {half:.0f} {norm.unit}"
            yield premises.deviation(norm, "building", f"{found} of {there} water closets and urinals", asked)


def _separate_toilets(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("separate_toilets")
    people = sum(premises.people(scene) for scene in premises.scenes)
    if norm is None or people <= premises.limit(norm):
        return
    restrooms = {room.id for room in _public_toilets(premises) if premises.is_one_of(room, norm.rooms)}
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


def _unit_showers(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("sleeping_unit_shower")
    if norm is None:
        return
    baths = premises.of_types(norm.rooms)
    own = [room for room in baths if premises.serves_unit(room)]
    for room in own:
        if not _fixtures(premises, norm, [room]):
            yield premises.deviation(norm, room.id, "no bathtub and no shower", "one")
    shared = [room for room in baths if room not in own]
    if premises.family == "home" and shared and not own and not _fixtures(premises, norm, shared):
        yield premises.deviation(norm, shared[0].id, "no bathtub and no shower in the dwelling", "one")


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
