"""Furniture and other objects of an IFC file: one type with a body for each mesh, and its occurrences in the spaces."""

from collections.abc import Mapping, Sequence
from typing import Final

import numpy as np

from mansion_assets.catalogue import Catalogue
from mansion_export.ifc.document import Document, Entity
from mansion_export.ifc.frames import Frame
from mansion_export.meshes.building_model import object_parts
from mansion_export.meshes.model import Node, Surface
from mansion_msgs_py.scene import FloorScene, SceneObject

__all__ = ["Furnishing"]

_CLASSES: Final[Mapping[str, frozenset[str]]] = {
    "IfcSanitaryTerminal": frozenset(
        "bathtub bidet jacuzzi pedestal_sink scrub_sink shower_cabin sink sink_row toilet toilet_pan urinal "
        "utility_sink washbasin".split()
    ),
    "IfcLightFixture": frozenset(
        "ceiling_light ceiling_panel chandelier floor_lamp high_bay_light linear_light pendant_lamp reading_lamp "
        "spot_track studio_light surgical_light table_lamp wall_lamp".split()
    ),
    "IfcElectricAppliance": frozenset(
        "clothes_dryer coffee_machine dishwasher freezer fridge microwave stove toaster vending_machine "
        "washing_machine".split()
    ),
}
"""Categories that IFC has a class of its own for; everything else is furniture."""

_FURNITURE: Final = "IfcFurniture"


class Furnishing:
    """Adds the objects of floors; those of one mesh share its body.

    Parameters
    ----------
    document : Document
    catalogue : Catalogue, optional
        The shipped one when it is left out.
    """

    def __init__(self, document: Document, catalogue: Catalogue | None) -> None:
        self._document = document
        self._catalogue = catalogue
        self._kinds: dict[tuple[str, str], tuple[Entity, Entity]] = {}

    def add(self, scene: FloorScene, storey: Entity, spaces: Mapping[str, Entity]) -> None:
        """Add the objects of a floor to their spaces."""
        for item, (node, surfaces) in zip(scene.objects, object_parts(scene, self._catalogue), strict=True):
            place = spaces.get(item.room, storey)
            self._document.contain(place, self._object(item, node, surfaces, place))

    def _object(self, item: SceneObject, node: Node, surfaces: Sequence[Surface], place: Entity) -> Entity:
        document, entity = self._document, _class_of(item.category)
        kind, body = self._kind(entity, item, node, surfaces)
        frame = Frame(*node.position, node.rotation % 360.0)
        made = document.root(
            entity,
            item.id,
            Name=item.name or item.category.replace("_", " "),
            ObjectType=item.category,
            Tag=item.id,
            ObjectPlacement=document.placement(frame, place.ObjectPlacement),
            Representation=document.shape([self._mapped(body, node)], "MappedRepresentation"),
        )
        document.of_type(kind, made)
        return made

    def _kind(self, entity: str, item: SceneObject, node: Node, surfaces: Sequence[Surface]) -> tuple[Entity, Entity]:
        """Return the type of a mesh, and the body that its occurrences share."""
        if (entity, node.mesh) not in self._kinds:
            document = self._document
            meshes = [document.mesh(each, np.asarray(each.vertices)) for each in surfaces if len(each.faces)]
            body = document.file.create_entity(
                "IfcRepresentationMap", document.axes, document.representation(meshes, "Tessellation")
            )
            extra = {"AssemblyPlace": "NOTDEFINED"} if entity == _FURNITURE else {}
            made = document.root(
                f"{entity}Type",
                node.mesh,
                Name=item.asset or item.category,
                RepresentationMaps=[body],
                ElementType=item.category,
                PredefinedType="USERDEFINED",
                **extra,
            )
            self._kinds[entity, node.mesh] = made, body
        return self._kinds[entity, node.mesh]

    def _mapped(self, body: Entity, node: Node) -> Entity:
        document = self._document
        x, y, z = (float(value) for value in node.scale)
        if (x, y, z) == (1.0, 1.0, 1.0):
            scaled = document.file.create_entity(
                "IfcCartesianTransformationOperator3D", None, None, document.origin, 1.0, None
            )
        else:
            scaled = document.file.create_entity(
                "IfcCartesianTransformationOperator3DnonUniform", None, None, document.origin, x, None, y, z
            )
        return document.file.create_entity("IfcMappedItem", body, scaled)


def _class_of(category: str) -> str:
    return next((name for name, categories in _CLASSES.items() if category in categories), _FURNITURE)
