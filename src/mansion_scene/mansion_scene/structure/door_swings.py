"""Hinges and swings of doors, such that no leaf hits a wall, another leaf or another opening."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import chain
from typing import Literal

import shapely
from shapely.geometry import Polygon

from mansion_msgs_py.program import Downgrade
from mansion_msgs_py.shapes import Point
from mansion_scene.structure.dimensions import EXTERIOR_THICKNESS, INTERIOR_THICKNESS
from mansion_scene.structure.door_positions import approach_zone
from mansion_scene.structure.openings import Opening, OpeningKind, served_room
from mansion_scene.structure.regions import FloorRegions

__all__ = ["hang_doors", "leaf_sectors"]

Hinge = Literal["start", "end", "both", "none"]
_PASSAGE_DEPTH = 0.5  # metres in front of other openings that a leaf must not sweep
_TOUCH = 2e-3  # square metres of overlap that rounding explains


def leaf_sectors(opening: Opening, region: str, hinge: Hinge) -> list[Polygon]:
    """Return the floor that the leaves sweep in a region: a quarter disc for each, from the wall's face.

    Parameters
    ----------
    opening : Opening
    region : str
        Id of the region into which it opens.
    hinge : {"start", "end", "both"}
        End of the opening's segment at which the leaf hangs; ``both`` is a double door.
    """
    a, b = opening.segment
    inward = opening.inward(region)
    face = 0.0 if opening.boundary.exterior else INTERIOR_THICKNESS / 2
    width = math.dist(a, b)
    sectors = []
    if hinge in ("start", "both"):
        sectors.append(_quarter(a, b, inward, width / 2 if hinge == "both" else width, face))
    if hinge in ("end", "both"):
        sectors.append(_quarter(b, a, inward, width / 2 if hinge == "both" else width, face))
    return sectors


def _quarter(pivot: Point, other: Point, inward: Point, radius: float, face: float) -> Polygon:
    length = math.dist(pivot, other)
    ux, uy = (other[0] - pivot[0]) / length, (other[1] - pivot[1]) / length
    nx, ny = inward
    px, py = pivot[0] + nx * face, pivot[1] + ny * face
    arc = [
        (
            px + radius * (math.cos(turn) * ux + math.sin(turn) * nx),
            py + radius * (math.cos(turn) * uy + math.sin(turn) * ny),
        )
        for turn in (math.pi / 2 * step / 6 for step in range(7))
    ]
    return Polygon([(px, py), *arc])


def hang_doors(
    floor: FloorRegions,
    nets: Mapping[str, Polygon],
    openings: Sequence[Opening],
    elsewhere: Callable[[Opening], Iterable[Opening]] = lambda opening: (),
) -> tuple[list[Opening], list[Downgrade]]:
    """Give each door with leaves a swing and a hinge that keep clear of walls, other leaves and other openings.

    A leaf opens into the room that the door serves, not into circulation, and hangs at the end nearer to a side wall.
    Where no swing is free the door moves along its wall. Failing that, an outer door opens outwards and an inner one
    loses its leaf (kind ``doorway``), which is recorded. A door that has a hinge keeps it where its leaf hits no wall.

    Parameters
    ----------
    elsewhere : callable
        Other places for a door, best first.
    """
    swept: dict[str, list[Polygon]] = {region.id: [] for region in floor.regions}
    hung = [_if_clear(opening, nets) for opening in openings]
    for opening in hung:
        if opening.swing is not None:
            swept[opening.swing].extend(leaf_sectors(opening, opening.swing, opening.hinge))
    downgrades: list[Downgrade] = []
    for index in sorted(range(len(hung)), key=lambda i: -hung[i].kind.leaves):
        opening = hung[index]
        if opening.kind.leaves == 0 or opening.hinge != "none":
            continue
        others = [other for i, other in enumerate(hung) if i != index]
        for place in chain((opening,), elsewhere(opening)):
            chosen = _choose(floor, nets, place, others, swept)
            if chosen is not None:
                region, hinge = chosen
                swept[region].extend(leaf_sectors(place, region, hinge))
                hung[index] = replace(place, hinge=hinge, swing=region)
                break
        else:
            hung[index] = _without_swing(opening)
            if opening.regions[1] is not None:
                downgrades.append(_no_leaf(floor, opening))
    return hung, downgrades


def _if_clear(opening: Opening, nets: Mapping[str, Polygon]) -> Opening:
    """Return a door as it hangs, or without hinge where its leaf hits a wall."""
    if opening.swing is None:
        return opening
    sectors = leaf_sectors(opening, opening.swing, opening.hinge)
    outside = sum(sector.difference(nets[opening.swing]).area for sector in sectors)
    return opening if outside <= _TOUCH else replace(opening, hinge="none", swing=None)


def _without_swing(opening: Opening) -> Opening:
    """Return a door that finds no room to swing: opening outwards if it is an outer door, else without leaf."""
    if opening.regions[1] is None:
        return replace(opening, hinge="both" if opening.kind.leaves == 2 else "start")
    return replace(opening, kind=OpeningKind("doorway", opening.kind.width, "painted_wood"))


def _no_leaf(floor: FloorRegions, opening: Opening) -> Downgrade:
    return Downgrade(
        wish=f"{opening.kind.kind} door between {opening.regions[0]} and {opening.regions[1] or 'outside'}",
        got="a doorway without leaf",
        reason="its leaf would hit a wall or another door either way",
        stage="furnish_floor",
        floor=floor.floor,
    )


def _swing_rooms(floor: FloorRegions, opening: Opening) -> list[str]:
    a = floor.by_id[opening.regions[0]]
    if opening.regions[1] is None:
        return [a.id]
    b = floor.by_id[opening.regions[1]]
    served = served_room(a, b)
    other = b if served is a else a
    # The other side, a corridor perhaps, takes the leaf only when the served room cannot.
    return [region.id for region in (served, other) if region.is_room]


def _choose(
    floor: FloorRegions,
    nets: Mapping[str, Polygon],
    opening: Opening,
    others: Sequence[Opening],
    swept: Mapping[str, Sequence[Polygon]],
) -> tuple[str, Hinge] | None:
    hinges: tuple[Hinge, ...] = ("both",) if opening.kind.leaves == 2 else ("start", "end")
    for region in _swing_rooms(floor, opening):
        passages = [
            approach_zone(other.segment, other.inward(region), depth=_PASSAGE_DEPTH)
            for other in others
            if region in other.regions and other.kind.kind != "open"
        ]
        free: list[tuple[float, int, Hinge]] = []
        for rank, hinge in enumerate(hinges):
            sectors = leaf_sectors(opening, region, hinge)
            outside = sum(sector.difference(nets[region]).area for sector in sectors)
            hits = sum(s.intersection(o).area for s in sectors for o in (*swept[region], *passages))
            if outside <= _TOUCH and hits <= _TOUCH:
                free.append((_to_side_wall(opening, nets[region], region, hinge), rank, hinge))
        if free:
            return region, min(free)[2]
    return None


def _to_side_wall(opening: Opening, net: Polygon, region: str, hinge: Hinge) -> float:
    """Return how far the open leaf stands from the room's boundary: little beside a side wall."""
    if hinge == "both":
        return 0.0
    a, b = opening.segment
    pivot = a if hinge == "start" else b
    nx, ny = opening.inward(region)
    half = (EXTERIOR_THICKNESS if opening.boundary.exterior else INTERIOR_THICKNESS) / 2
    depth = half + math.dist(a, b) / 2
    middle = shapely.Point(pivot[0] + nx * depth, pivot[1] + ny * depth)
    return round(float(shapely.distance(net.exterior, middle)), 3)
