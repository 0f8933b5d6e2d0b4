"""Doors for vehicles: which rooms of the ground floor have one, and where in the outer wall."""

from collections.abc import Mapping, Sequence

from shapely.geometry import LineString, Point, Polygon

from mansion_msgs_py.program import Downgrade
from mansion_scene.structure.dimensions import WALL_END
from mansion_scene.structure.entrance import facades_of
from mansion_scene.structure.frontage import Frontage, approach_zone, choose_position
from mansion_scene.structure.opening_kinds import OpeningKind
from mansion_scene.structure.openings import Opening, take
from mansion_scene.structure.regions import FloorRegions, Region
from mansion_scene.structure.room_classes import is_class
from mansion_scene.structure.stretches import Stretch

__all__ = ["place_garage_doors"]

WIDTHS = (5.0, 3.5, 2.5)
"""Clear widths: for two cars side by side, for a lorry or a bay, for a car; metres."""

NARROWEST = 2.4
"""What a garage door may shrink to; a car of 1.8 m with its mirrors passes."""

_GROUND = 1
_FAR = 100.0

HALL = 60.0
"""Area from which cars stand side by side, square metres."""

TWO_CARS = 30.0
"""Area from which a room gets a door wider than for one car, square metres."""


def place_garage_doors(
    floor: FloorRegions, stretches: Sequence[Stretch], frontages: dict[str, Frontage], nets: Mapping[str, Polygon]
) -> tuple[list[Opening], list[Downgrade]]:
    """Give each room of the ground floor that vehicles drive into a door, and enter it into the frontages.

    Returns
    -------
    list of Opening
        Of kind ``garage``, in the order of the floor's regions.
    list of Downgrade
        Rooms that have no outer wall long enough.
    """
    placed: list[Opening] = []
    missing: list[Downgrade] = []
    for region in floor.regions if floor.floor == _GROUND else ():
        if not (region.is_room and is_class(region.room_type, "vehicle")):
            continue
        found = _place(floor, stretches, region, frontages, nets)
        if isinstance(found, Downgrade):
            missing.append(found)
        else:
            take(found, frontages)
            placed.append(found)
    return placed, missing


def _place(
    floor: FloorRegions,
    stretches: Sequence[Stretch],
    region: Region,
    frontages: dict[str, Frontage],
    nets: Mapping[str, Polygon],
) -> Opening | Downgrade:
    """Place the widest door that fits in the middle of one of the room's facades.

    A hall has it in its longest facade, a garage where cars drive in along its length.
    """
    facades = facades_of(floor, stretches, region.id)
    if region.polygon.area < HALL:
        facades.sort(key=lambda facade: -round(_depth(facade, nets[region.id]), 2))
    large = region.polygon.area >= TWO_CARS
    for width in (*(WIDTHS if large else WIDTHS[-1:]), NARROWEST):
        for facade in facades:
            center = facade.at(facade.length / 2)
            position = choose_position([facade], frontages, width, margin=WALL_END, center=center)
            if position is None:
                continue
            dx, dy = facade.direction
            zone = approach_zone(position.segment, (-dy, dx), wall=0.0)
            if nets[region.id].intersection(zone).area > 0.95 * zone.area:
                kind = OpeningKind("garage", round(position.width, 4), "painted_steel")
                return Opening((region.id, None), kind, facade, position.segment)
    return Downgrade(
        wish=f"a garage door for {region.id}",
        got="none",
        reason=f"no outer wall of the room has {NARROWEST + 2 * WALL_END:.2f} m free for it",
        stage="furnish_floor",
        floor=floor.floor,
    )


def _depth(facade: Stretch, net: Polygon) -> float:
    """Return how far a room goes on behind the middle of a facade, metres."""
    (x, y), (dx, dy) = facade.at(facade.length / 2), facade.direction
    line = LineString([(x, y), (x - dy * _FAR, y + dx * _FAR)])
    first = line.intersection(net)
    parts = getattr(first, "geoms", [first])
    return float(max((part.length for part in parts if part.distance(Point(x, y)) < 0.5), default=0.0))
