"""A building as IFC4: project, site, building, storeys and spaces, stairs and lifts, and what stands in them."""

from collections.abc import Sequence, Set
from typing import Final

from shapely import union_all
from shapely.geometry import LineString, Polygon

from mansion_assets.catalogue import Catalogue
from mansion_export.exterior import roof_parts
from mansion_export.ifc.document import Document, Entity
from mansion_export.ifc.frames import FLOOR, Frame
from mansion_export.ifc.furnishing import Furnishing
from mansion_export.ifc.walls import add_walls
from mansion_export.meshes.building_model import slab_polygon
from mansion_export.meshes.core_meshes import core_parts
from mansion_export.meshes.materials import named
from mansion_export.presentation import building_title, floor_name, room_title
from mansion_geometry.rings import polygon_parts
from mansion_knowledge import is_class
from mansion_msgs_py.scene import FloorScene, SceneCore, SceneRoom, StairDetails

__all__ = ["add_cores", "building_ifc", "ifc_files"]

_CORES: Final = {"stair": ("Stairs", "stairs"), "elevator": ("Lift", "elevator")}
"""Name and type of the spaces of cores, as `mansion build --plan` reads them."""


def building_ifc(scenes: Sequence[FloorScene], catalogue: Catalogue | None = None) -> bytes:
    """Make an IFC4 file of all floors, in metres, z up.

    Parameters
    ----------
    scenes : sequence of FloorScene
        In any order.
    catalogue : Catalogue, optional
        Where the assets are, when they are not all in the shipped one.

    Returns
    -------
    bytes
        The STEP file. ``IfcSpace.Name`` is the room's id on its floor, ``LongName`` what people call it, ``ObjectType``
        its type; the ``Tag`` of doors, windows and furniture is their id, the ``ObjectType`` of furniture its category.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` where ifcopenshell is not installed.
    """
    ordered = sorted(scenes, key=lambda scene: scene.floor)
    document = Document(ordered[0].building_id if ordered else "building")
    building, ground = _site(document, building_title(ordered))
    furnishing = Furnishing(document, catalogue)
    cabins = {core.id: scene.floor for scene in reversed(ordered) if scene.floor >= 1 for core in scene.cores}
    for number, scene in enumerate(ordered):
        above = ordered[number + 1] if number + 1 < len(ordered) else None
        storey = _storey(document, building, ground, scene)
        spaces = {room.id: _space(document, storey, scene, room) for room in scene.rooms}
        spaces |= {core.id: _core_space(document, storey, scene, core) for core in scene.cores}
        _add_slabs(document, storey, scene, above)
        add_walls(document, storey, scene, spaces)
        add_cores(document, storey, scene, {name for name, floor in cabins.items() if floor == scene.floor})
        furnishing.add(scene, storey, spaces)
    document.relate()
    return document.data()


def ifc_files(scenes: Sequence[FloorScene]) -> dict[str, bytes]:
    """Return ``building.ifc`` by its path in the building's folder."""
    return {"building.ifc": building_ifc(scenes)}


def _site(document: Document, title: str) -> tuple[Entity, Entity]:
    """Add project, site and building; return the building and its placement."""
    units = [
        document.file.create_entity("IfcSIUnit", None, kind, None, name)
        for kind, name in (
            ("LENGTHUNIT", "METRE"),
            ("AREAUNIT", "SQUARE_METRE"),
            ("VOLUMEUNIT", "CUBIC_METRE"),
            ("PLANEANGLEUNIT", "RADIAN"),
        )
    ]
    project = document.root(
        "IfcProject",
        "project",
        Name=title,
        RepresentationContexts=[document.context],
        UnitsInContext=document.file.create_entity("IfcUnitAssignment", units),
    )
    on_site = document.placement(FLOOR)
    site = document.root("IfcSite", "site", Name="Site", ObjectPlacement=on_site, CompositionType="ELEMENT")
    within = document.placement(FLOOR, on_site)
    building = document.root(
        "IfcBuilding",
        "building",
        Name=title,
        ObjectPlacement=within,
        CompositionType="ELEMENT",
        ElevationOfRefHeight=0.0,
    )
    document.aggregate(project, site)
    document.aggregate(site, building)
    return building, within


def _storey(document: Document, building: Entity, within: Entity, scene: FloorScene) -> Entity:
    storey = document.root(
        "IfcBuildingStorey",
        f"floor_{scene.floor}",
        Name=floor_name(scene).capitalize(),
        LongName=scene.label,
        ObjectPlacement=document.placement(Frame(z=scene.elevation), within),
        CompositionType="ELEMENT",
        Elevation=float(scene.elevation),
    )
    document.aggregate(building, storey)
    document.quantities(storey, "Qto_BuildingStoreyBaseQuantities", {"GrossHeight": scene.height})
    return storey


def _space(document: Document, storey: Entity, scene: FloorScene, room: SceneRoom) -> Entity:
    return _add_space(
        document,
        storey,
        scene,
        (room.id.rsplit("/", 1)[-1], room_title(room), room.room_type),
        (Polygon(room.net_polygon, room.net_holes), room.area, room.ceiling_height),
        outdoors=is_class(room.room_type, "outdoor"),
    )


def _core_space(document: Document, storey: Entity, scene: FloorScene, core: SceneCore) -> Entity:
    title, kind = _CORES[core.type]
    shaft = Polygon(core.polygon)
    bodies = [LineString(wall.segment).buffer(wall.thickness / 2, cap_style="square") for wall in scene.walls]
    net = max(polygon_parts(shaft.difference(union_all(bodies))), key=lambda part: part.area, default=shaft)
    height = max((wall.height for wall in scene.walls), default=scene.height)
    name = core.id.rsplit("/", 1)[-1]
    return _add_space(document, storey, scene, (name, title, kind), (net, shaft.area, height))


def _add_space(
    document: Document,
    storey: Entity,
    scene: FloorScene,
    words: tuple[str, str, str],
    measures: tuple[Polygon, float, float],
    *,
    outdoors: bool = False,
) -> Entity:
    """Add a space of a name, a title and a type; of a net polygon, a gross area and a height."""
    (name, title, kind), (net, area, height) = words, measures
    space = document.root(
        "IfcSpace",
        f"floor_{scene.floor}/{name}",
        Name=name,
        LongName=title,
        ObjectType=kind,
        ObjectPlacement=document.placement(FLOOR, storey.ObjectPlacement),
        Representation=document.shape([document.prism(net, 0.0, height)], "SweptSolid"),
        CompositionType="ELEMENT",
        PredefinedType="EXTERNAL" if outdoors else "INTERNAL",
    )
    document.aggregate(storey, space)
    quantities = {"NetFloorArea": net.area, "GrossFloorArea": area, "Height": height}
    document.quantities(space, "Qto_SpaceBaseQuantities", quantities)
    return space


def _add_slabs(document: Document, storey: Entity, scene: FloorScene, above: FloorScene | None) -> None:
    """Add the slab below a floor, and the roof over what no storey covers."""
    thickness = max(scene.height - max((wall.height for wall in scene.walls), default=2.8), 0.1)
    shape = slab_polygon(scene, above=False)
    pieces = [shape] if shape.geom_type == "Polygon" else list(shape.geoms)
    solids = [document.prism(piece, -thickness, 0.0) for piece in pieces if piece.area > 1e-4]
    for solid in solids:
        document.colour(solid, named("polished_concrete"))
    lowest = not any(floor < scene.floor for core in scene.cores for floor in core.floors) and scene.elevation <= 0.0
    slab = document.root(
        "IfcSlab",
        f"floor_{scene.floor}/slab",
        Name="Slab",
        Tag=f"F{scene.floor}/slab",
        ObjectPlacement=document.placement(FLOOR, storey.ObjectPlacement),
        Representation=document.shape(solids, "SweptSolid"),
        PredefinedType="BASESLAB" if lowest else "FLOOR",
    )
    document.contain(storey, slab)
    covered = None if above is None else slab_polygon(above, above=False, openings=False)
    for node, surfaces in roof_parts(scene, slab_polygon(scene, above=True, openings=above is not None), covered):
        roof = document.root(
            "IfcRoof",
            f"floor_{scene.floor}/{node.id}",
            Name="Roof",
            Tag=node.id,
            ObjectPlacement=document.placement(FLOOR, storey.ObjectPlacement),
            Representation=document.shape(document.meshes(node, surfaces, FLOOR), "Tessellation"),
        )
        document.contain(storey, roof)


_FORMS: Final = {"dog_leg": "HALF_TURN_STAIR"}
"""Stair types of IFC by the form of a stair."""

_SHAFT: Final = 0.2
"""Metres between a shaft's polygon and a cabin of which nothing else is known."""

_CABIN: Final = 2.3


def add_cores(document: Document, storey: Entity, scene: FloorScene, cabins: Set[str]) -> None:
    """Add the flights that leave a floor upwards, and the lifts whose cabin stands there."""
    meshes = {node.id: (node, surfaces) for node, surfaces in core_parts(scene, frozenset(cabins))}
    for core in scene.cores:
        items, kind = [], "Tessellation"
        if core.id in meshes:
            items = document.meshes(*meshes[core.id], FLOOR)
        if core.type == "stair" and items and isinstance(core.details, StairDetails):
            _add(document, storey, scene, core, "IfcStair", _FORMS.get(core.details.form, "NOTDEFINED"), items, kind)
        elif core.type == "elevator" and core.id in cabins:
            if not items:
                inner = Polygon(core.polygon).buffer(-_SHAFT, join_style="mitre")
                items, kind = [document.prism(inner, 0.0, _CABIN)], "SweptSolid"
            _add(document, storey, scene, core, "IfcTransportElement", "ELEVATOR", items, kind)


def _add(
    document: Document,
    storey: Entity,
    scene: FloorScene,
    core: SceneCore,
    entity: str,
    predefined: str,
    items: list[Entity],
    kind: str,
) -> None:
    made = document.root(
        entity,
        f"floor_{scene.floor}/{core.id}",
        Name=core.id,
        Tag=core.id,
        ObjectPlacement=document.placement(FLOOR, storey.ObjectPlacement),
        Representation=document.shape(items, kind),
        PredefinedType=predefined,
    )
    document.contain(storey, made)
