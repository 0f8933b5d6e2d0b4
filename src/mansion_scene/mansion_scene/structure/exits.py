"""A second door into the open, for storeys of public buildings whose occupants need two exits."""

import math
from collections.abc import Mapping, Sequence

from shapely.geometry import Polygon

from mansion_knowledge import default_knowledge
from mansion_knowledge.norms import load_norms
from mansion_scene.structure.boundaries import BoundarySegment
from mansion_scene.structure.dimensions import CLEAR_WIDTH, WALL_END
from mansion_scene.structure.door_positions import Frontage, approach_zone, choose_position
from mansion_scene.structure.openings import Opening, OpeningKind, is_circulation
from mansion_scene.structure.outer_doors import facades_of
from mansion_scene.structure.regions import FloorRegions, Region

__all__ = ["place_second_exit"]

_APART = 1 / 3
"""Least distance of the second exit from the entrance, of the storey's diagonal (IBC 2018, 1007.1.1, exception 2)."""

_WIDTHS = (1.2, CLEAR_WIDTH)


def place_second_exit(
    floor: FloorRegions,
    boundaries: Sequence[BoundarySegment],
    entrance: Opening,
    frontages: Mapping[str, Frontage],
    nets: Mapping[str, Polygon],
    building_type: str,
) -> list[Opening]:
    """Place the exit farthest from the entrance: of a passage, the hub, or a room open to the public.

    None where the occupants are few and everything lies near the entrance, or no facade is far enough from it.
    """
    middle = _middle(entrance)
    if not _is_public_building(building_type) or not _needs_two(floor, middle):
        return []
    x0, y0, x1, y1 = floor.outline.bounds
    least = _APART * math.hypot(x1 - x0, y1 - y0)
    for leads_out in (is_circulation, _is_public):
        found = [
            opening
            for region in floor.regions
            if region.is_room and leads_out(region)
            for opening in _doors(floor, boundaries, region, frontages, nets)
            if math.dist(_middle(opening), middle) >= least
        ]
        if found:
            return [max(found, key=lambda opening: round(math.dist(_middle(opening), middle), 2))]
    return []


def _is_public_building(building_type: str) -> bool:
    """Whether the rule of two exits is asked of a building type; it is of those that are not known."""
    known = default_knowledge().buildings.get(building_type.replace(" ", "_"))
    return known is None or load_norms().rules["exits"].holds_for(known.family)


def _needs_two(floor: FloorRegions, entrance: tuple[float, float]) -> bool:
    norms, knowledge = load_norms(), default_knowledge()
    rooms = [region for region in floor.regions if region.is_room]
    people = sum(norms.people(region.room_type, region.polygon.area, knowledge) for region in rooms)
    far = max(math.dist(entrance, corner) for corner in floor.outline.exterior.coords)
    return people > norms.rules["exits"].limit("ground") or far > norms.rules["single_exit_travel"].figure


def _is_public(region: Region) -> bool:
    return default_knowledge().room(region.room_type).zone == "public"


def _doors(
    floor: FloorRegions,
    boundaries: Sequence[BoundarySegment],
    region: Region,
    frontages: Mapping[str, Frontage],
    nets: Mapping[str, Polygon],
) -> list[Opening]:
    """Return a door in the middle of each facade of a region that has place for one."""
    doors = []
    for facade in facades_of(floor, boundaries, region.id):
        for width in _WIDTHS:
            center = facade.at(facade.length / 2)
            position = choose_position([facade], frontages, width, margin=WALL_END, center=center)
            if position is None:
                continue
            dx, dy = facade.direction
            zone = approach_zone(position.segment, (-dy, dx), wall=0.0)
            if nets[region.id].intersection(zone).area > 0.95 * zone.area:
                kind = OpeningKind("entrance", round(position.width, 4), "glass")
                doors.append(Opening((region.id, None), kind, facade, position.segment))
                break
    return doors


def _middle(opening: Opening) -> tuple[float, float]:
    (ax, ay), (bx, by) = opening.segment
    return (ax + bx) / 2, (ay + by) / 2
