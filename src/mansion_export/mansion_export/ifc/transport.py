"""Stairs and lifts of an IFC file."""

from collections.abc import Set
from typing import Final

from shapely.geometry import Polygon

from mansion_export.ifc.document import Document, Entity
from mansion_export.ifc.frames import FLOOR
from mansion_export.meshes.core_meshes import core_parts
from mansion_msgs_py.scene import FloorScene, SceneCore, StairDetails

__all__ = ["add_cores"]

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
