"""Further doors into the open, for storeys of public buildings whose occupants need more than one exit."""

import math
from collections.abc import Iterator, Mapping, Sequence

from shapely.geometry import Polygon

from mansion_knowledge import default_knowledge, is_class
from mansion_knowledge.norms import load_norms
from mansion_msgs_py.shapes import Point
from mansion_scene.structure.boundaries import BoundarySegment
from mansion_scene.structure.dimensions import CLEAR_WIDTH
from mansion_scene.structure.door_positions import Frontage
from mansion_scene.structure.openings import Opening, OpeningKind, is_circulation, with_doors
from mansion_scene.structure.outer_doors import door_in_facade, facades_of
from mansion_scene.structure.regions import FloorRegions, Region

__all__ = ["exit_doors", "is_crowded", "is_public_building", "middle_of", "place_further_exits"]

_APART = 1 / 3
"""Least distance of the second exit from the entrance, of the storey's diagonal (IBC 2018, 1007.1.1, exception 2)."""

_ASIDE = 5.0
"""Least distance of an exit from the others where no facade is far enough, metres."""

_WIDTHS = (1.2, CLEAR_WIDTH)


def place_further_exits(
    floor: FloorRegions,
    boundaries: Sequence[BoundarySegment],
    entrance: Opening,
    frontages: Mapping[str, Frontage],
    nets: Mapping[str, Polygon],
    building_type: str,
) -> list[Opening]:
    """Place exits until there are as many as the occupants require, each as far as possible from the others.

    They lead out of passages and the hub, else of rooms open to the public or of crowded ones. None where the occupants
    are few and everything lies near the entrance, or no facade is far enough from it.
    """
    if not is_public_building(building_type):
        return []
    x0, y0, x1, y1 = floor.outline.bounds
    least = _APART * math.hypot(x1 - x0, y1 - y0)
    placed = [entrance]
    needed = _exits_needed(floor, middle_of(entrance))
    while len(placed) < needed:
        taken = [middle_of(opening) for opening in placed]
        apart = least if len(placed) == 1 else min(least, _ASIDE)
        found = _farthest(floor, boundaries, frontages, nets, taken, apart)
        if found is None:
            break
        placed.append(found)
        frontages = with_doors(frontages, [found])
    return placed[1:]


def _farthest(
    floor: FloorRegions,
    boundaries: Sequence[BoundarySegment],
    frontages: Mapping[str, Frontage],
    nets: Mapping[str, Polygon],
    taken: Sequence[Point],
    least: float,
) -> Opening | None:
    """Return the exit that is farthest from the nearest of those taken; ``None`` where all are nearer than `least`."""

    def away(opening: Opening) -> float:
        return round(min(math.dist(middle_of(opening), place) for place in taken), 2)

    for leads_out in (is_circulation, _is_public, is_crowded):
        found = [
            opening
            for region in floor.regions
            if region.is_room and leads_out(region) and not is_class(region.room_type, "outdoor")
            for opening in exit_doors(floor, boundaries, region, frontages, nets)
            if away(opening) >= least
        ]
        if found:
            return max(found, key=away)
    return None


def is_public_building(building_type: str) -> bool:
    """Whether the rules of exits are asked of a building type; they are of those that are not known."""
    known = default_knowledge().buildings.get(building_type.replace(" ", "_"))
    return known is None or load_norms().rules["exits"].holds_for(known.family)


def _exits_needed(floor: FloorRegions, entrance: Point) -> int:
    """Return how many exits a ground floor needs: by its occupants, and two where a place is far from the entrance.

    Ways run along walls, so that they are as long as both coordinates' differences together.
    """
    norms, knowledge = load_norms(), default_knowledge()
    rooms = [region for region in floor.regions if region.is_room]
    people = round(sum(norms.people(region.room_type, region.polygon.area, knowledge) for region in rooms))
    rule = norms.rules["exits"]
    needed = 1 + sum(people > rule.limit(level) for level in ("ground", "three", "four"))
    corners = floor.outline.exterior.coords
    far = max(abs(x - entrance[0]) + abs(y - entrance[1]) for x, y, *_ in corners)
    return max(needed, 2 if far > norms.rules["single_exit_travel"].figure else 1)


def _is_public(region: Region) -> bool:
    return default_knowledge().room(region.room_type).zone == "public"


def is_crowded(region: Region) -> bool:
    """Whether a room holds so many people that it needs two doors."""
    norms = load_norms()
    people = norms.people(region.room_type, region.polygon.area, default_knowledge())
    return round(people) > norms.rules["room_exits"].figure


def exit_doors(
    floor: FloorRegions,
    boundaries: Sequence[BoundarySegment],
    region: Region,
    frontages: Mapping[str, Frontage],
    nets: Mapping[str, Polygon],
) -> Iterator[Opening]:
    """Yield a door into the open in the middle of each facade of a region that has space for one."""
    for facade in facades_of(floor, boundaries, region.id):
        for width in _WIDTHS:
            kind = OpeningKind("entrance", width, "glass")
            door = door_in_facade(facade, region.id, kind, frontages, nets[region.id])
            if door is not None:
                yield door
                break


def middle_of(opening: Opening) -> Point:
    """Return the middle of an opening."""
    (ax, ay), (bx, by) = opening.segment
    return (ax + bx) / 2, (ay + by) / 2
