"""Objects as nodes of a model; objects of one asset share its mesh."""

from mansion_msgs_py.scene import FloorScene, SceneObject
from mansion_scene.export.appearance import hex_color
from mansion_scene.export.model import Material, Model, Node, Surface
from mansion_scene.export.solids import Box
from mansion_scene.export.solids3d import boxes_surface

__all__ = ["add_objects"]


def add_objects(model: Model, scene: FloorScene) -> None:
    """Add each object of a floor where it stands."""
    for item in scene.objects:
        name = f"asset:{item.asset}:{item.color}"
        surfaces = None if name in model.meshes else _box(item)
        node = Node(item.id, name, "objects", item.position, item.rotation, item.size, item.room)
        model.add(node, surfaces)


def _box(item: SceneObject) -> list[Surface]:
    material = Material(f"color_{item.color.lstrip('#') or 'plain'}", hex_color(item.color))
    return [boxes_surface([Box((0.0, 0.0, 0.0), (1.0, 1.0, 1.0))], material)]
