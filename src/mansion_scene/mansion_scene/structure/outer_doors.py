"""Doors in outer walls: the building's entrance and garage doors."""

from collections.abc import Container, Mapping, Sequence
from dataclasses import replace

import shapely
from shapely.geometry import LineString, Point, Polygon

from mansion_knowledge import is_class
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import GROUND_FLOOR, Downgrade
from mansion_scene.structure.boundaries import BoundarySegment, reentrant_corners, usable_part
from mansion_scene.structure.dimensions import CLEAR_WIDTH, WALL_END
from mansion_scene.structure.door_positions import Frontage, Position, approach_zone, choose_position
from mansion_scene.structure.openings import Opening, OpeningKind, entrance_kind, is_circulation, with_doors
from mansion_scene.structure.regions import FloorRegions, Region

__all__ = ["door_in_facade", "entrance_room", "facades_of", "place_entrance", "place_garage_doors"]

_ENTRANCE_WALL = CLEAR_WIDTH + 2 * WALL_END

_GARAGE_WIDTHS = (5.0, 3.5, 2.5)
"""Clear widths: for two cars side by side, for a lorry or a bay, for a car; metres."""

_NARROWEST_GARAGE = 2.4
"""Least clear width of a garage door, metres: a car of 1.8 m passes with its mirrors."""

_BAY_DOOR, _BAY_PITCH = 3.8, 4.8
"""Clear width of the door of a bay, and least distance between the middles of two such doors, metres."""

_BAY = 60.0
"""Square metres of a hall of bays for each of its doors."""

_MOST_BAYS = 6

_FAR = 100.0  # metres, longer than any building

_HALL = 60.0
"""Area from which a room takes cars side by side, square metres."""

_TWO_CARS = 30.0
"""Area from which a room gets a door wider than for one car, square metres."""


def facades_of(floor: FloorRegions, boundaries: Sequence[BoundarySegment], region: str) -> list[BoundarySegment]:
    """Return the region's boundaries on the outline itself, courtyards left out, longest first."""
    ring = floor.outline.exterior
    corners = reentrant_corners(floor.outline)
    facades = [
        boundary
        for wall in boundaries
        if wall.exterior
        and wall.left == region
        and (boundary := usable_part(wall, corners)) is not None
        and boundary.length >= _ENTRANCE_WALL - 1e-6
        and shapely.distance(ring, shapely.Point(boundary.at(boundary.length / 2))) < 0.01
    ]
    return sorted(facades, key=lambda boundary: -round(boundary.length, 3))


def door_in_facade(
    facade: BoundarySegment, region: str, kind: OpeningKind, frontages: Mapping[str, Frontage], net: Polygon
) -> Opening | None:
    """Return a door as near to the middle of a facade as may be; ``None`` where there is no free floor behind it.

    Parameters
    ----------
    region : str
        The room behind the facade, whose walls leave the floor `net` free.
    """
    center = facade.at(facade.length / 2)
    position = choose_position([facade], frontages, kind.width, margin=WALL_END, center=center)
    if position is None or not _is_free(position, net):
        return None
    return Opening((region, None), replace(kind, width=round(position.width, 4)), facade, position.segment)


def _is_free(position: Position, net: Polygon) -> bool:
    """Whether the floor behind a place for an outer door is free."""
    dx, dy = position.boundary.direction
    zone = approach_zone(position.segment, (-dy, dx), wall=0.0)
    return bool(net.intersection(zone).area > 0.95 * zone.area)


def entrance_room(floor: FloorRegions, boundaries: Sequence[BoundarySegment]) -> Region:
    """Return the room through which the building is entered: the hub, else the room best placed on the outer wall.

    Where a reception stands open to a passage that is the hub, people come in to it.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when no room has 1.2 m of outer wall.
    """
    choices = [
        (_entrance_rank(floor, region, facades[0].length), -round(facades[0].length, 3), region.id)
        for region in floor.regions
        if region.is_room and (facades := facades_of(floor, boundaries, region.id))
    ]
    if not choices:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"the ground floor has no entrance: no room has {_ENTRANCE_WALL:.2f} m of outer wall",
            path="$.layout.rooms",
        )
    return floor.by_id[min(choices)[2]]


_FRONT = 3.0
"""Least facade of a reception that people come in to, metres."""

_RECEPTION = 10.0
"""Least area of one, square metres."""


def _receives(floor: FloorRegions, region: Region, facade: float) -> bool:
    """Whether a room is a reception open to a passage, with a facade and floor for a way in beside its desk."""
    stands_open = region.open_relation == "open" and is_circulation(floor.hub) and not is_circulation(region)
    large = region.polygon.area >= _RECEPTION and facade >= _FRONT
    return stands_open and large and is_class(region.room_type, "welcome")


def _entrance_rank(floor: FloorRegions, region: Region, facade: float) -> int:
    if _receives(floor, region, facade):
        return -1
    if region.id == floor.hub.id:
        return 0
    if is_class(region.room_type, "welcome"):
        return 1
    if is_circulation(region):
        return 2
    for rank, name in ((6, "outdoor"), (9, "wet"), (8, "store"), (7, "sleeping")):
        if is_class(region.room_type, name):
            return rank
    return 3 if is_class(region.room_type, "living") or is_class(region.room_type, "assembly") else 4


def place_entrance(
    floor: FloorRegions,
    boundaries: Sequence[BoundarySegment],
    region: Region,
    frontages: Mapping[str, Frontage],
    nets: Mapping[str, Polygon],
    *,
    residential: bool,
) -> Opening:
    """Place the entrance door in the region's facade: in the middle in a public building, near an end in a dwelling."""
    kind = entrance_kind(public=not residential)
    facades = facades_of(floor, boundaries, region.id)
    for width in (kind.width, 1.2, CLEAR_WIDTH):
        for facade in facades:
            margin = WALL_END if residential else (facade.length - width) / 2 - 1e-6
            if margin < WALL_END - 1e-6:
                continue
            position = choose_position([facade], frontages, width, margin=margin)
            if position is None:
                continue
            if facade is facades[-1] or _is_free(position, nets[region.id]):
                return Opening(
                    (region.id, None),
                    OpeningKind("entrance", round(position.width, 4), kind.material),
                    facade,
                    position.segment,
                )
    raise MansionError(
        ErrorCode.INFEASIBLE,
        f"no room for an entrance of {CLEAR_WIDTH} m in the outer wall of {region.id}",
        path="$.layout.rooms",
    )


def place_garage_doors(
    floor: FloorRegions,
    boundaries: Sequence[BoundarySegment],
    frontages: Mapping[str, Frontage],
    nets: Mapping[str, Polygon],
    served: Container[str] = (),
) -> tuple[list[Opening], list[Downgrade]]:
    """Place a door for each room of the ground floor that vehicles drive into.

    Parameters
    ----------
    served : container of str
        Regions that have such a door already.

    Returns
    -------
    list of Opening
        Openings of kind ``garage``, in the order of the floor's regions.
    list of Downgrade
        Rooms that have no outer wall long enough.
    """
    placed: list[Opening] = []
    missing: list[Downgrade] = []
    for region in floor.regions if floor.floor == GROUND_FLOOR else ():
        if region.id in served or not (region.is_room and is_class(region.room_type, "vehicle")):
            continue
        bays = _place_bay_doors(floor, boundaries, region, frontages) if is_class(region.room_type, "lorry") else []
        frontages = with_doors(frontages, bays)
        placed += bays
        if bays:
            continue
        found = _place(floor, boundaries, region, frontages, nets)
        if isinstance(found, Downgrade):
            missing.append(found)
        else:
            frontages = with_doors(frontages, [found])
            placed.append(found)
    return placed, missing


def _place_bay_doors(
    floor: FloorRegions, boundaries: Sequence[BoundarySegment], region: Region, frontages: Mapping[str, Frontage]
) -> list[Opening]:
    """Place two and more doors side by side in the longest facade of a hall of bays; none where it is too short."""
    facade = next(iter(facades_of(floor, boundaries, region.id)), None)
    if facade is None:
        return []
    most = min(_MOST_BAYS, int(region.polygon.area // _BAY), int(facade.length // _BAY_PITCH))
    kind = OpeningKind("garage", _BAY_DOOR, "painted_steel")
    for number in range(most, 1, -1):
        doors: list[Opening] = []
        for bay in range(number):
            center = facade.at(facade.length * (bay + 0.5) / number)
            seen = with_doors(frontages, doors)
            position = choose_position([facade], seen, _BAY_DOOR, margin=WALL_END, center=center)
            if position is not None:
                doors.append(Opening((region.id, None), kind, facade, position.segment))
        if len(doors) == number:
            return doors
    return []


def _place(
    floor: FloorRegions,
    boundaries: Sequence[BoundarySegment],
    region: Region,
    frontages: Mapping[str, Frontage],
    nets: Mapping[str, Polygon],
) -> Opening | Downgrade:
    """Place the widest door that fits in the middle of one of the room's facades.

    A hall has it in its longest facade, a garage where cars drive in along its length.
    """
    facades = facades_of(floor, boundaries, region.id)
    if region.polygon.area < _HALL:
        facades.sort(key=lambda facade: -round(_depth(facade, nets[region.id]), 2))
    large = region.polygon.area >= _TWO_CARS
    for width in (*(_GARAGE_WIDTHS if large else _GARAGE_WIDTHS[-1:]), _NARROWEST_GARAGE):
        for facade in facades:
            kind = OpeningKind("garage", width, "painted_steel")
            door = door_in_facade(facade, region.id, kind, frontages, nets[region.id])
            if door is not None:
                return door
    return Downgrade(
        wish=f"a garage door for {region.id}",
        got="none",
        reason=f"no outer wall of the room has {_NARROWEST_GARAGE + 2 * WALL_END:.2f} m free for it",
        stage="furnish_floor",
        floor=floor.floor,
    )


def _depth(facade: BoundarySegment, net: Polygon) -> float:
    """Return how far a room goes on behind the middle of a facade, metres."""
    (x, y), (dx, dy) = facade.at(facade.length / 2), facade.direction
    line = LineString([(x, y), (x - dy * _FAR, y + dx * _FAR)])
    first = line.intersection(net)
    parts = getattr(first, "geoms", [first])
    return float(max((part.length for part in parts if part.distance(Point(x, y)) < 0.5), default=0.0))
