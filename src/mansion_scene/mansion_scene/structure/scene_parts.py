"""Rooms, walls, doors and windows of a floor as parts of its scene, with their ids."""

import math
from collections.abc import Mapping, Sequence

from mansion_knowledge import is_class
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import RoomProgram
from mansion_msgs_py.scene import Door, SceneRoom, Wall, Window
from mansion_msgs_py.shapes import Point, Segment
from mansion_msgs_py.stages import FurnishRequest
from mansion_msgs_py.topology import TopologyNode
from mansion_scene.structure.boundaries import BoundarySegment, corner_key
from mansion_scene.structure.dimensions import (
    BAY_DOOR_HEIGHT,
    DOOR_HEIGHT,
    EXTERIOR_THICKNESS,
    GARAGE_DOOR_HEIGHT,
    INTERIOR_THICKNESS,
    PARAPET_HEIGHT,
)
from mansion_scene.structure.interiors import Partition
from mansion_scene.structure.materials import DEFAULT_FACADE, match_material
from mansion_scene.structure.openings import Opening
from mansion_scene.structure.regions import FloorRegions, Region, ring_points
from mansion_scene.structure.windows import WindowOpening

__all__ = ["number_doors", "number_walls", "number_windows", "scene_rooms"]

_FLOORS = (
    ("wet", "grey ceramic tile"),
    ("outdoor", "timber deck"),
    ("store", "sealed polished concrete"),
    ("office", "neutral gray carpet"),
    ("clinical", "hygienic hospital vinyl"),
    ("teaching", "beige vinyl"),
    ("welcome", "terrazzo"),
    ("sleeping", "light hardwood"),
)
_WALLS = (("wet", "white ceramic tiles"), ("clinical", "hygienic washable panels"))
_ACOUSTIC = ("office", "teaching", "clinical", "assembly")


def scene_rooms(request: FurnishRequest, floor: FloorRegions, partition: Partition, ceiling: float) -> list[SceneRoom]:
    """Return the floor's rooms in the order of its layout.

    Materials come from the room graph's descriptions, else from the program's, else from the room's type.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when walls leave nothing of a room.
    """
    nodes = {node.id: node for node in request.topology.nodes}
    programs = {room.id: room for room in request.floor.rooms}
    return [
        _room(region, nodes.get(region.node), programs.get(region.node), partition, ceiling)
        for region in floor.regions
        if region.is_room
    ]


def _room(
    region: Region, node: TopologyNode | None, program: RoomProgram | None, partition: Partition, ceiling: float
) -> SceneRoom:
    net = partition.nets[region.id]
    if net.is_empty or net.area < 0.05:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"the walls leave no floor area in {region.id}; a room must be wider than 0.12 m",
            path="$.layout.rooms",
        )
    floor_words = (node.floor_material if node else "") or (program.floor_material if program else "")
    wall_words = (node.wall_material if node else "") or (program.wall_material if program else "")
    return SceneRoom(
        id=region.id,
        room_type=region.room_type,
        kind=region.node_kind,
        polygon=ring_points(region.polygon.exterior),
        holes=[ring_points(hole) for hole in region.polygon.interiors],
        net_polygon=ring_points(net.exterior),
        net_holes=[ring_points(hole) for hole in net.interiors],
        area=round(region.polygon.area, 4),
        name=_display_name(region, program),
        aliases=list(program.aliases) if program is not None else [],
        floor_material=match_material(floor_words or _by_type(region, _FLOORS), "floor").name,
        wall_material=match_material(wall_words or _by_type(region, _WALLS), "wall").name,
        ceiling_material=match_material(_ceiling(region), "ceiling").name,
        ceiling_height=ceiling,
        open_relation=region.open_relation,
    )


def _display_name(region: Region, program: RoomProgram | None) -> str:
    """Return the user's name for a room, with the number of its id where several have it; else its id in words."""
    if program is None or not program.name:
        return region.node.replace("_", " ").capitalize()
    number = region.node.rpartition("_")[2]
    numbered = number.isdigit() and not program.name.endswith(number)
    name = f"{program.name} {number}" if numbered else program.name
    return name[:1].upper() + name[1:]


def _by_type(region: Region, table: tuple[tuple[str, str], ...]) -> str:
    return next((words for name, words in table if is_class(region.room_type, name)), "")


def _ceiling(region: Region) -> str:
    acoustic = any(is_class(region.room_type, name) for name in _ACOUSTIC)
    return "suspended acoustic ceiling tile" if acoustic else "smooth white plaster"


_CORE_WALL = "raw_concrete"
_NO_WALL = 1e-3
"""Metres of centre line up to which there is no wall."""


def _outside(boundary: BoundarySegment, point: Point) -> Point:
    """Move a point of an exterior boundary from the outline to the outer wall's centre line."""
    dx, dy = boundary.direction
    half = EXTERIOR_THICKNESS / 2
    return round(point[0] + dy * half, 4) + 0.0, round(point[1] - dx * half, 4) + 0.0


def _outline_corners(floor: FloorRegions) -> dict[Point, Point]:
    """Return, for each corner of the outline, where the centre lines of its two outer walls meet."""
    corners: dict[Point, Point] = {}
    for ring in (floor.outline.exterior, *floor.outline.interiors):
        points = ring_points(ring)
        for index, point in enumerate(points):
            before, after = points[index - 1], points[(index + 1) % len(points)]
            (ax, ay), (bx, by) = _outward(before, point), _outward(point, after)
            scale = EXTERIOR_THICKNESS / 2 / max(1.0 + ax * bx + ay * by, 0.2)
            meeting = point[0] + (ax + bx) * scale, point[1] + (ay + by) * scale
            corners[corner_key(point)] = round(meeting[0], 4) + 0.0, round(meeting[1], 4) + 0.0
    return corners


def _outward(start: Point, end: Point) -> Point:
    length = math.dist(start, end)
    return (end[1] - start[1]) / length, (start[0] - end[0]) / length


def _center_line(boundary: BoundarySegment, corners: Mapping[Point, Point]) -> Segment:
    """Return the centre line of a boundary's wall; outer walls meet at the corners of the building."""
    if not boundary.exterior:
        return _on_wall(boundary, (boundary.start, boundary.end))
    ends = [corners.get(corner_key(point)) or _outside(boundary, point) for point in (boundary.start, boundary.end)]
    return ends[0], ends[1]


def _on_wall(boundary: BoundarySegment, segment: Segment) -> Segment:
    if boundary.exterior:
        return _outside(boundary, segment[0]), _outside(boundary, segment[1])
    (ax, ay), (bx, by) = segment
    return (round(ax, 4) + 0.0, round(ay, 4) + 0.0), (round(bx, 4) + 0.0, round(by, 4) + 0.0)


def number_walls(
    floor: FloorRegions,
    boundaries: Sequence[BoundarySegment],
    rooms: Mapping[str, SceneRoom],
    ceiling: float,
    facade: str = DEFAULT_FACADE,
) -> list[tuple[BoundarySegment, Wall]]:
    """Return each boundary with its wall; ids count in the floor's order.

    Balconies and terraces have a parapet towards the outside instead of a wall. A ledge of the outline half as deep as
    its walls are thick has no wall of its own: the centre lines of its neighbours meet.
    """
    corners = _outline_corners(floor)
    walls = []
    lines = [(boundary, _center_line(boundary, corners)) for boundary in boundaries]
    standing = [(boundary, line) for boundary, line in lines if math.dist(*line) > _NO_WALL]
    for number, (boundary, line) in enumerate(standing, start=1):
        parapet = boundary.exterior and is_class(floor.by_id[boundary.left].room_type, "outdoor")
        walls.append(
            (
                boundary,
                Wall(
                    id=f"F{floor.floor}/wall_{number}",
                    segment=line,
                    thickness=EXTERIOR_THICKNESS if boundary.exterior else INTERIOR_THICKNESS,
                    height=PARAPET_HEIGHT if parapet else ceiling,
                    exterior=boundary.exterior,
                    structural=boundary.structural,
                    left=boundary.left,
                    right=boundary.right,
                    left_material=_face(boundary.left, rooms),
                    right_material=facade if boundary.exterior else _face(boundary.right, rooms),
                ),
            )
        )
    return walls


def _face(region: str | None, rooms: Mapping[str, SceneRoom]) -> str:
    room = rooms.get(region) if region is not None else None
    return room.wall_material if room is not None else _CORE_WALL


def _wall_of(walls: Sequence[tuple[BoundarySegment, Wall]], boundary: BoundarySegment) -> Wall:
    """Return the wall of the boundary that an opening interrupts (the opening may know only a part of it)."""
    middle = boundary.at(boundary.length / 2)
    for own, wall in walls:
        if (own.left, own.right) != (boundary.left, boundary.right):
            continue
        dx, dy = own.direction
        along = (middle[0] - own.start[0]) * dx + (middle[1] - own.start[1]) * dy
        across = (middle[0] - own.start[0]) * dy - (middle[1] - own.start[1]) * dx
        if abs(across) < 0.01 and -0.01 < along < own.length + 0.01:
            return wall
    raise AssertionError(f"no wall between {boundary.left} and {boundary.right} at {middle}")


def _vehicle_height(floor: FloorRegions, regions: Sequence[str | None]) -> float:
    """Return the height of a door that cars, or lorries, drive in by."""
    lorries = any(region.id in regions and is_class(region.room_type, "lorry") for region in floor.regions)
    return BAY_DOOR_HEIGHT if lorries else GARAGE_DOOR_HEIGHT


def number_doors(
    floor: FloorRegions, walls: Sequence[tuple[BoundarySegment, Wall]], openings: Sequence[Opening], ceiling: float
) -> list[Door]:
    """Return the doors in the order of the openings, numbered on."""
    doors = []
    for number, opening in enumerate(openings, start=1):
        kind = opening.kind
        is_open = kind.kind == "open"
        segment = _on_wall(opening.boundary, opening.segment)
        tall = _vehicle_height(floor, opening.regions) if kind.kind == "garage" else DOOR_HEIGHT
        doors.append(
            Door(
                id=f"F{floor.floor}/door_{number}",
                kind=kind.kind,
                segment=segment,
                rooms=opening.regions,
                width=round(math.dist(*segment), 4),
                height=ceiling if is_open else round(min(tall, ceiling - 0.05), 4),
                wall="" if is_open else _wall_of(walls, opening.boundary).id,
                hinge=opening.hinge,
                swing=opening.swing,
                is_open=kind.kind not in ("sliding", "entrance", "garage"),
                material=kind.material,
            )
        )
    return doors


def number_windows(
    floor: FloorRegions, walls: Sequence[tuple[BoundarySegment, Wall]], windows: Sequence[WindowOpening]
) -> list[Window]:
    """Return the windows in their order, numbered on."""
    return [
        Window(
            id=f"F{floor.floor}/window_{number}",
            wall=_wall_of(walls, window.boundary).id,
            room=window.region,
            segment=_on_wall(window.boundary, window.segment),
            sill=window.kind.sill,
            height=window.kind.height,
            kind=window.kind.name,
        )
        for number, window in enumerate(windows, start=1)
    ]
