"""Walls of an IFC file with their openings, and the doors and windows that fill these."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from shapely.geometry import Polygon, box

from mansion_export.ifc.document import Document, Entity
from mansion_export.ifc.frames import FLOOR, Frame
from mansion_export.meshes.materials import surface_material
from mansion_export.meshes.model import Part
from mansion_export.meshes.opening_meshes import door_parts, window_parts
from mansion_export.meshes.walls import Opening, WallBodies
from mansion_geometry.doorways import LEAFLESS
from mansion_msgs_py.scene import Door, DoorKind, FloorScene, Wall, Window

__all__ = ["add_walls"]

_THROUGH: Final = 0.02
"""Metres by which an opening's body reaches beyond the faces of its wall."""

_OPERATIONS: Final[Mapping[DoorKind, str]] = {
    "double": "DOUBLE_DOOR_SINGLE_SWING",
    "sliding": "DOUBLE_DOOR_SLIDING",
    "garage": "ROLLINGUP",
}
_DOORWAY: Final = "doorway"


@dataclass(frozen=True, slots=True)
class _Hole:
    """An opening in a wall: its entity, where it is on the floor, and how wide and high it is."""

    entity: Entity
    frame: Frame
    width: float
    height: float


def add_walls(document: Document, storey: Entity, scene: FloorScene, spaces: Mapping[str, Entity]) -> None:
    """Add the walls of a floor, cut at their openings, with doors, windows and open boundaries between spaces."""
    bodies = WallBodies(scene)
    holes: dict[str, _Hole] = {}
    walls = {wall.id: wall for wall in scene.walls}
    for wall in scene.walls:
        made = _wall(document, storey, scene, wall, bodies)
        for opening in bodies.openings(wall):
            holes[opening.id] = _hole(document, made, wall, opening)
    parts = _parts_by_opening([*door_parts(scene), *window_parts(scene)])
    for door in scene.doors:
        hole = holes.get(door.id)
        if hole is None:
            made = _open_boundary(document, storey, door)
        elif door.kind == _DOORWAY:
            hole.entity.ObjectType = _DOORWAY
            made = hole.entity
        else:
            made = _door(document, storey, door, hole, parts.get(door.id, ()))
        for name in door.rooms:
            if name is not None and name in spaces:
                _bound(document, spaces[name], made, outside=None in door.rooms)
    for window in scene.windows:
        if hole := holes.get(window.id):
            made = _window(document, storey, window, hole, parts.get(window.id, ()))
            if window.room in spaces:
                outside = walls[window.wall].exterior
                _bound(document, spaces[window.room], made, outside=outside)


def _parts_by_opening(parts: Sequence[Part]) -> dict[str, list[Part]]:
    """Return frames, leaves and panes by the door or the window that they belong to."""
    found: dict[str, list[Part]] = {}
    for part in parts:
        name = part[0].id
        owner = name.rsplit("/", 1)[0] if name.count("/") > 1 else name
        found.setdefault(owner, []).append(part)
    return found


def _wall(document: Document, storey: Entity, scene: FloorScene, wall: Wall, bodies: WallBodies) -> Entity:
    frame, half = Frame.along(*wall.segment), wall.thickness / 2
    (left, right), (left_end, right_end) = bodies.faces(wall).tolist()
    solid = document.prism(
        Polygon([(right, -half), (right_end, -half), (left_end, half), (left, half)]), 0.0, wall.height
    )
    document.colour(solid, surface_material(wall.left_material, "wall"))
    made = document.root(
        "IfcWall",
        wall.id,
        Name=wall.id.rsplit("/", 1)[-1],
        Tag=wall.id,
        ObjectPlacement=document.placement(frame, storey.ObjectPlacement),
        Representation=document.shape([solid], "SweptSolid"),
        PredefinedType="SOLIDWALL",
    )
    document.contain(storey, made)
    document.properties(made, "Pset_WallCommon", {"IsExternal": wall.exterior, "LoadBearing": wall.structural})
    return made


def _hole(document: Document, wall: Entity, of: Wall, opening: Opening) -> _Hole:
    """Cut an opening into a wall; its frame has x along the wall and its origin at the lower corner."""
    width, height = opening.high - opening.low, opening.head - opening.sill
    half = of.thickness / 2 + _THROUGH
    made = document.root(
        "IfcOpeningElement",
        opening.id,
        Name=opening.id.rsplit("/", 1)[-1],
        Tag=opening.id,
        ObjectPlacement=document.placement(Frame(x=opening.low, z=opening.sill), wall.ObjectPlacement),
        Representation=document.shape([document.prism(box(0.0, -half, width, half), 0.0, height)], "SweptSolid"),
        PredefinedType="OPENING",
    )
    document.root("IfcRelVoidsElement", opening.id, RelatingBuildingElement=wall, RelatedOpeningElement=made)
    frame = Frame.along(*of.segment).inside(opening.low, 0.0, opening.sill)
    return _Hole(made, frame, width, height)


def _bodies(document: Document, parts: Sequence[Part], frame: Frame) -> Entity | None:
    items = [item for node, surfaces in parts for item in document.meshes(node, surfaces, frame)]
    return document.shape(items, "Tessellation")


def _filling(
    document: Document,
    storey: Entity,
    entity: str,
    element: Door | Window,
    hole: _Hole,
    parts: Sequence[Part],
    types: dict[str, str],
) -> Entity:
    """Return a door or window that fills a hole; `types` are the attributes that only its entity has."""
    made = document.root(
        entity,
        element.id,
        Name=element.id.rsplit("/", 1)[-1],
        ObjectType=element.kind,
        Tag=element.id,
        ObjectPlacement=document.placement(FLOOR, hole.entity.ObjectPlacement),
        Representation=_bodies(document, parts, hole.frame),
        OverallHeight=round(hole.height, 4),
        OverallWidth=round(hole.width, 4),
        **types,
    )
    document.contain(storey, made)
    document.root("IfcRelFillsElement", element.id, RelatingOpeningElement=hole.entity, RelatedBuildingElement=made)
    return made


def _door(document: Document, storey: Entity, door: Door, hole: _Hole, parts: Sequence[Part]) -> Entity:
    types = {"PredefinedType": "DOOR", "OperationType": _operation(door)}
    made = _filling(document, storey, "IfcDoor", door, hole, parts, types)
    document.properties(made, "Pset_DoorCommon", {"IsExternal": None in door.rooms})
    return made


def _operation(door: Door) -> str:
    if door.kind in _OPERATIONS:
        return _OPERATIONS[door.kind]
    if door.kind in LEAFLESS or door.hinge == "none":
        return "NOTDEFINED"
    return "DOUBLE_DOOR_SINGLE_SWING" if door.hinge == "both" else "SINGLE_SWING_LEFT"


def _window(document: Document, storey: Entity, window: Window, hole: _Hole, parts: Sequence[Part]) -> Entity:
    types = {"PredefinedType": "WINDOW", "PartitioningType": "NOTDEFINED"}
    made = _filling(document, storey, "IfcWindow", window, hole, parts, types)
    document.properties(made, "Pset_WindowCommon", {"IsExternal": True})
    return made


def _open_boundary(document: Document, storey: Entity, door: Door) -> Entity:
    """Add the boundary between two spaces where no wall stands: a virtual element with the line of its place."""
    frame, end = Frame.along(*door.segment), door.segment[1]
    made = document.root(
        "IfcVirtualElement",
        door.id,
        Name=door.id.rsplit("/", 1)[-1],
        ObjectType=door.kind,
        ObjectPlacement=document.placement(frame, storey.ObjectPlacement),
        Representation=_line(document, door, end),
    )
    document.contain(storey, made)
    return made


def _line(document: Document, door: Door, end: tuple[float, float]) -> Entity:
    start = door.segment[0]
    length = ((end[0] - start[0]) ** 2 + (end[1] - start[1]) ** 2) ** 0.5
    line = document.file.create_entity("IfcPolyline", [document.point(0.0, 0.0), document.point(length, 0.0)])
    drawn = document.file.create_entity("IfcShapeRepresentation", document.footprint, "FootPrint", "Curve2D", [line])
    return document.file.create_entity("IfcProductDefinitionShape", None, None, [drawn])


def _bound(document: Document, space: Entity, element: Entity, *, outside: bool) -> None:
    """Say that an opening is at the boundary of a space."""
    virtual = element.is_a("IfcVirtualElement") or element.is_a("IfcOpeningElement")
    document.root(
        "IfcRelSpaceBoundary",
        f"{space.GlobalId}/{element.GlobalId}",
        RelatingSpace=space,
        RelatedBuildingElement=element,
        PhysicalOrVirtualBoundary="VIRTUAL" if virtual else "PHYSICAL",
        InternalOrExternalBoundary="EXTERNAL" if outside else "INTERNAL",
    )
