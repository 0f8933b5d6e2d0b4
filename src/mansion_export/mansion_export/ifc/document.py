"""An IFC4 file under construction: entities with ids that are the same in every run, bodies, and relations."""

import uuid
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Final, TypeAlias

import numpy as np
from shapely.geometry import Polygon
from shapely.geometry.polygon import orient

from mansion_export.ifc.frames import Frame
from mansion_export.meshes.model import Material, Node, Surface
from mansion_geometry.compiled import Floats
from mansion_msgs_py import __version__
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["Document", "Entity"]

Entity: TypeAlias = Any
"""An ``ifcopenshell.entity_instance``."""

_EPOCH: Final = "2000-01-01T00:00:00"
"""Time in the header: the same building is the same file."""

_DIGITS: Final = 4
"""Decimals of metres in meshes."""


class Document:
    """A file and what its parts share.

    Parameters
    ----------
    name : str
        The building's name; the ids of all entities follow from it.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` where ifcopenshell is not installed.
    """

    def __init__(self, name: str) -> None:
        try:
            import ifcopenshell
            import ifcopenshell.guid
        except ImportError as error:
            raise MansionError(
                ErrorCode.UNAVAILABLE, "IFC needs the package ifcopenshell: pip install 'mansion[ifc]'"
            ) from error
        self._name = name
        self._compress = ifcopenshell.guid.compress
        self.file: Any = ifcopenshell.file(schema="IFC4")
        self._styles: dict[Material, Entity] = {}
        self._members: dict[tuple[str, int], tuple[Entity, list[Entity]]] = {}
        self._types: dict[int, tuple[Entity, list[Entity]]] = {}
        self.up, self.right = self.direction(0.0, 0.0, 1.0), self.direction(1.0, 0.0, 0.0)
        self.origin = self.point(0.0, 0.0, 0.0)
        self.axes = self.file.create_entity("IfcAxis2Placement3D", self.origin, self.up, self.right)
        self.context = self.file.create_entity(
            "IfcGeometricRepresentationContext", None, "Model", 3, 1e-5, self.axes, None
        )
        self.body = self._view("Body", "MODEL_VIEW")
        self.footprint = self._view("FootPrint", "PLAN_VIEW")

    def _view(self, name: str, target: str) -> Entity:
        return self.file.create_entity(
            "IfcGeometricRepresentationSubContext",
            ContextIdentifier=name,
            ContextType="Model",
            ParentContext=self.context,
            TargetView=target,
        )

    def root(self, kind: str, key: str, **attributes: Any) -> Entity:
        """Add an entity with a GlobalId, which `kind` and `key` give."""
        made = uuid.uuid5(uuid.NAMESPACE_OID, f"{self._name}/{kind}/{key}")
        return self.file.create_entity(kind, GlobalId=self._compress(made.hex), **attributes)

    def point(self, *values: float) -> Entity:
        """Add a point."""
        return self.file.create_entity("IfcCartesianPoint", tuple(float(value) for value in values))

    def direction(self, *values: float) -> Entity:
        """Add a direction."""
        return self.file.create_entity("IfcDirection", tuple(float(value) for value in values))

    def placement(self, frame: Frame, within: Entity | None = None) -> Entity:
        """Add the placement of an element in that of another."""
        axes = self.file.create_entity(
            "IfcAxis2Placement3D",
            self.point(frame.x, frame.y, frame.z),
            self.up,
            self.right if frame.rotation == 0.0 else self.direction(*frame.axis, 0.0),
        )
        return self.file.create_entity("IfcLocalPlacement", within, axes)

    def prism(self, shape: Polygon, bottom: float, top: float) -> Entity:
        """Add the solid over a polygon, in the frame of the element that it is a body of."""
        whole = orient(shape)
        outer, *inner = (self._ring(ring.coords[:-1]) for ring in (whole.exterior, *whole.interiors))
        if inner:
            profile = self.file.create_entity("IfcArbitraryProfileDefWithVoids", "AREA", None, outer, inner)
        else:
            profile = self.file.create_entity("IfcArbitraryClosedProfileDef", "AREA", None, outer)
        axes = self.file.create_entity("IfcAxis2Placement3D", self.point(0.0, 0.0, bottom), self.up, self.right)
        return self.file.create_entity("IfcExtrudedAreaSolid", profile, axes, self.up, float(top - bottom))

    def _ring(self, points: Sequence[Sequence[float]]) -> Entity:
        corners = [self.point(x, y) for x, y, *_ in points]
        return self.file.create_entity("IfcPolyline", [*corners, corners[0]])

    def mesh(self, surface: Surface, vertices: Floats) -> Entity:
        """Add the triangles of a surface, its vertices in the frame of the element, in its material's colour."""
        points = np.round(vertices, _DIGITS) + 0.0
        corners = self.file.create_entity("IfcCartesianPointList3D", points.tolist())
        made = self.file.create_entity(
            "IfcTriangulatedFaceSet", Coordinates=corners, CoordIndex=(surface.faces + 1).tolist()
        )
        self.colour(made, surface.material)
        return made

    def colour(self, item: Entity, material: Material) -> None:
        """Show a solid or a mesh in the colour of a material."""
        if material not in self._styles:
            rgb = self.file.create_entity("IfcColourRgb", None, *(float(value) for value in material.color))
            shading = self.file.create_entity(
                "IfcSurfaceStyleRendering",
                rgb,
                Transparency=1.0 - float(material.alpha),
                ReflectanceMethod="NOTDEFINED",
            )
            self._styles[material] = self.file.create_entity("IfcSurfaceStyle", material.name, "BOTH", [shading])
        self.file.create_entity("IfcStyledItem", item, [self._styles[material]])

    def meshes(self, node: Node, surfaces: Iterable[Surface], frame: Frame) -> list[Entity]:
        """Add the mesh of a node, which stands on the floor, for an element in `frame`."""
        return [self.mesh(each, frame.vertices(node, each.vertices)) for each in surfaces if len(each.faces)]

    def representation(self, items: Sequence[Entity], kind: str) -> Entity:
        """Add a body made of solids (``SweptSolid``), meshes (``Tessellation``) or mapped items."""
        return self.file.create_entity("IfcShapeRepresentation", self.body, "Body", kind, list(items))

    def shape(self, items: Sequence[Entity], kind: str) -> Entity | None:
        """Add the shape of an element; ``None`` where it has no body."""
        if not items:
            return None
        return self.file.create_entity("IfcProductDefinitionShape", None, None, [self.representation(items, kind)])

    def contain(self, place: Entity, element: Entity) -> None:
        """Put an element into a storey or a space."""
        self._members.setdefault(("IfcRelContainedInSpatialStructure", place.id()), (place, []))[1].append(element)

    def aggregate(self, whole: Entity, part: Entity) -> None:
        """Make something a part of another."""
        self._members.setdefault(("IfcRelAggregates", whole.id()), (whole, []))[1].append(part)

    def of_type(self, kind: Entity, element: Entity) -> None:
        """Say of which type an element is."""
        self._types.setdefault(kind.id(), (kind, []))[1].append(element)

    def relate(self) -> None:
        """Add the relations that were gathered; the last step."""
        for (relation, _), (whole, parts) in self._members.items():
            sides = ("RelatingObject", "RelatedObjects")
            if relation != "IfcRelAggregates":
                sides = ("RelatingStructure", "RelatedElements")
            self.root(relation, whole.GlobalId, **{sides[0]: whole, sides[1]: parts})
        for kind, elements in self._types.values():
            self.root("IfcRelDefinesByType", kind.GlobalId, RelatedObjects=elements, RelatingType=kind)

    def properties(self, element: Entity, name: str, values: Mapping[str, bool]) -> None:
        """Give an element a set of properties that are true or false."""
        each = [
            self.file.create_entity("IfcPropertySingleValue", key, None, self.file.create_entity("IfcBoolean", value))
            for key, value in values.items()
        ]
        self._define(element, self.root("IfcPropertySet", f"{element.GlobalId}/{name}", Name=name, HasProperties=each))

    def quantities(self, element: Entity, name: str, values: Mapping[str, float]) -> None:
        """Give an element areas (names that end in ``Area``) and lengths in metres."""
        each = []
        for key, value in values.items():
            kind = "IfcQuantityArea" if key.endswith("Area") else "IfcQuantityLength"
            each.append(self.file.create_entity(kind, key, None, None, round(float(value), 4)))
        made = self.root("IfcElementQuantity", f"{element.GlobalId}/{name}", Name=name, Quantities=each)
        self._define(element, made)

    def _define(self, element: Entity, definition: Entity) -> None:
        self.root(
            "IfcRelDefinesByProperties",
            definition.GlobalId,
            RelatedObjects=[element],
            RelatingPropertyDefinition=definition,
        )

    def data(self) -> bytes:
        """Return the file."""
        header = self.file.header
        header.file_description.description = ("ViewDefinition [DesignTransferView]",)
        header.file_name.name = f"{self._name}.ifc"
        header.file_name.time_stamp = _EPOCH
        header.file_name.originating_system = f"Mansion {__version__}"
        text: str = self.file.to_string()
        return text.encode()
