"""Second doors of rooms that hold too many people for one door."""

import math
from collections.abc import Iterator, Mapping, Sequence

from shapely.geometry import Polygon

from mansion_knowledge import default_knowledge, is_class
from mansion_msgs_py.program import GROUND_FLOOR
from mansion_scene.structure.access import Pair
from mansion_scene.structure.boundaries import BoundarySegment
from mansion_scene.structure.dimensions import CLEAR_WIDTH
from mansion_scene.structure.door_positions import Frontage, ranked_positions
from mansion_scene.structure.exits import exit_doors, is_crowded, is_public_building, middle_of
from mansion_scene.structure.openings import Opening, is_circulation, opening_at, opening_kind, with_doors
from mansion_scene.structure.regions import FloorRegions, Region

__all__ = ["place_second_doors"]

_APART = 1 / 3
"""Least distance of a room's two doors, of its diagonal (IBC 2018, 1007.1.1, exception 2)."""


def place_second_doors(
    floor: FloorRegions,
    boundaries: Sequence[BoundarySegment],
    shared: Mapping[Pair, Sequence[BoundarySegment]],
    openings: Sequence[Opening],
    frontages: Mapping[str, Frontage],
    nets: Mapping[str, Polygon],
    building_type: str,
) -> list[Opening]:
    """Place a further door for each crowded room of a public building that has one alone.

    It leads into circulation, into the open on the ground floor, or through another room open to the public, as far
    from the first as the rules ask; else into circulation beside it.
    """
    placed: list[Opening] = []
    for region in floor.regions if is_public_building(building_type) else ():
        own = [opening for opening in (*openings, *placed) if region.id in opening.regions]
        if not (region.is_room and is_crowded(region) and len(own) == 1):
            continue
        x0, y0, x1, y1 = region.polygon.bounds
        least, first = _APART * math.hypot(x1 - x0, y1 - y0), middle_of(own[0])
        choices = list(_choices(floor, boundaries, shared, region, frontages, nets))
        apart = (door for door in choices if math.dist(middle_of(door), first) >= least)
        inside = [door for door in choices if door.regions[1] is not None]
        nearest = max(inside, key=lambda door: round(math.dist(middle_of(door), first), 2), default=None)
        chosen = next(apart, nearest)
        if chosen is not None:
            placed.append(chosen)
            frontages = with_doors(frontages, [chosen])
    return placed


def _choices(
    floor: FloorRegions,
    boundaries: Sequence[BoundarySegment],
    shared: Mapping[Pair, Sequence[BoundarySegment]],
    region: Region,
    frontages: Mapping[str, Frontage],
    nets: Mapping[str, Polygon],
) -> Iterator[Opening]:
    """Yield places of a further door: into circulation, the open, then other public rooms, each the best first."""
    beside = {(b if a == region.id else a): (a, b) for a, b in shared if region.id in (a, b)}
    others = [floor.by_id[name] for name in sorted(beside) if floor.by_id[name].is_room]
    for other in (other for other in others if is_circulation(other)):
        yield from _inner_doors(region, other, shared[beside[other.id]], frontages)
    if floor.floor == GROUND_FLOOR:
        yield from exit_doors(floor, boundaries, region, frontages, nets)
    for other in (other for other in others if _leads_on(other)):
        yield from _inner_doors(region, other, shared[beside[other.id]], frontages)


def _leads_on(region: Region) -> bool:
    """Whether people may leave through a room: one that is open to the public, and no toilet, store or kitchen."""
    barred = any(is_class(region.room_type, name) for name in ("wet", "store", "outdoor"))
    public = default_knowledge().room(region.room_type).zone == "public"
    return public and not barred and not is_circulation(region)


def _inner_doors(
    region: Region, other: Region, walls: Sequence[BoundarySegment], frontages: Mapping[str, Frontage]
) -> Iterator[Opening]:
    kind = opening_kind(region, other)
    for width in dict.fromkeys((kind.width, CLEAR_WIDTH)):
        for position in ranked_positions(walls, frontages, width):
            yield opening_at(position, kind)
