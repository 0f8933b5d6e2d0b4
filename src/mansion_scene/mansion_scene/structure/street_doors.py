"""Doors to the street through which customers enter shops, showrooms and restaurants."""

from collections.abc import Mapping, Sequence
from typing import Final

from shapely.geometry import Polygon

from mansion_knowledge import kin_of
from mansion_scene.structure.boundaries import BoundarySegment
from mansion_scene.structure.dimensions import CLEAR_WIDTH
from mansion_scene.structure.door_positions import Frontage
from mansion_scene.structure.exits import is_public_building
from mansion_scene.structure.openings import Opening, OpeningKind, with_doors
from mansion_scene.structure.outer_doors import door_in_facade, facades_of
from mansion_scene.structure.regions import FloorRegions

__all__ = ["place_street_doors"]

_FROM_THE_STREET: Final = frozenset(
    "sales_area showroom car_showroom salon_floor restaurant cafe bank_hall waiting_hall".split()
)
"""Rooms that customers come in to from the street."""

_WIDTHS: Final = (1.6, 1.2, CLEAR_WIDTH)


def place_street_doors(
    floor: FloorRegions,
    boundaries: Sequence[BoundarySegment],
    openings: Sequence[Opening],
    frontages: Mapping[str, Frontage],
    nets: Mapping[str, Polygon],
    building_type: str,
) -> list[Opening]:
    """Place a glazed door in the longest facade of each room of customers that has no door to the open.

    None in homes, and none where the facade has no space for one.
    """
    if not is_public_building(building_type):
        return []
    entered = {opening.regions[0] for opening in openings if opening.regions[1] is None}
    placed: list[Opening] = []
    for region in floor.regions:
        if region.is_room and region.id not in entered and kin_of(region.room_type) in _FROM_THE_STREET:
            door = _street_door(facades_of(floor, boundaries, region.id), region.id, frontages, nets[region.id])
            if door is not None:
                placed.append(door)
                frontages = with_doors(frontages, [door])
    return placed


def _street_door(
    facades: Sequence[BoundarySegment], region: str, frontages: Mapping[str, Frontage], net: Polygon
) -> Opening | None:
    for width in _WIDTHS:
        for facade in facades:
            door = door_in_facade(facade, region, OpeningKind("entrance", width, "glass"), frontages, net)
            if door is not None:
                return door
    return None
