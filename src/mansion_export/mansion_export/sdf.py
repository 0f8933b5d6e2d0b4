"""A building as a Gazebo world (SDFormat 1.9): a static model for each floor, links named after the scene's ids."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from xml.sax.saxutils import quoteattr

import numpy as np

from mansion_assets.catalogue import Catalogue
from mansion_assets.convex import Hull
from mansion_export.building_model import building_models
from mansion_export.collision import Colliders, Shape, ground_boxes
from mansion_export.model import Material, Mesh, Model, Node
from mansion_export.simulator_files import SimulatorModel, mesh_file_name, number_list, write_stl
from mansion_export.solids import Box, box_scaled
from mansion_export.walls import WallBodies
from mansion_msgs_py.scene import FloorScene

__all__ = ["sdf_files", "world_sdf"]


def world_sdf(
    scenes: Sequence[FloorScene], mesh_dir: str = "meshes", catalogue: Catalogue | None = None
) -> SimulatorModel:
    """Make a Gazebo world of all floors.

    Parameters
    ----------
    scenes : sequence of FloorScene
    mesh_dir : str
        Folder of the meshes, seen from the world file.
    catalogue : Catalogue, optional
        Where the assets are, when they are not all in the shipped one.

    Returns
    -------
    SimulatorModel
        Each floor is a static model at its elevation, z up. Every wall, door leaf, window, stair and object is a link
        with its id; walls, floors, steps, doors and objects have shapes to collide with.
    """
    writer = _Writer(mesh_dir, catalogue)
    ordered = sorted(scenes, key=lambda scene: scene.floor)
    models = [
        writer.model(model, scene) for model, scene in zip(building_models(ordered, catalogue=catalogue), ordered)
    ]
    name = ordered[0].building_id if ordered else "building"
    return SimulatorModel(_world(name, models), dict(sorted(writer.files.items())))


def sdf_files(scenes: Sequence[FloorScene]) -> dict[str, bytes]:
    """Return ``building.sdf`` and its meshes by their paths in the building's folder."""
    world = world_sdf(scenes)
    return {"building.sdf": world.xml.encode(), **{f"meshes/{name}": data for name, data in world.meshes.items()}}


def _world(name: str, models: Sequence[str]) -> str:
    content = "\n".join(models)
    return f"""<?xml version="1.0"?>
<sdf version="1.9">
  <world name={quoteattr(name)}>
    <gravity>0 0 -9.81</gravity>
    <scene>
      <ambient>0.55 0.55 0.55 1</ambient>
      <background>0.75 0.85 1 1</background>
      <shadows>false</shadows>
    </scene>
    <light name="sun" type="directional">
      <pose>0 0 60 0 0 0</pose>
      <diffuse>0.8 0.8 0.78 1</diffuse>
      <specular>0.1 0.1 0.1 1</specular>
      <direction>-0.4 0.5 -0.9</direction>
      <cast_shadows>false</cast_shadows>
    </light>
{content}
  </world>
</sdf>
"""


@dataclass(slots=True)
class _Writer:
    """Writes floors, and each mesh once."""

    mesh_dir: str
    catalogue: Catalogue | None
    files: dict[str, bytes] = field(default_factory=dict)

    def model(self, model: Model, scene: FloorScene) -> str:
        """Return the model of a floor."""
        walls = {wall.id: wall for wall in scene.walls}
        colliders = Colliders(scene, self.catalogue)
        bodies = WallBodies(scene)
        links = []
        for node in model.nodes:
            mesh = model.meshes[node.mesh]
            parts = self._visuals(node, mesh)
            if node.id in walls:
                parts += [_collision(i, box) for i, box in enumerate(bodies.boxes(walls[node.id]))]
            else:
                shapes = colliders.of(node, mesh) or ()
                parts += [self._shape(i, shape, node) for i, shape in enumerate(shapes)]
            links.append(_link(node.id, node.position, node.rotation, parts))
        ground = [_collision(i, box) for i, (_, box) in enumerate(ground_boxes(scene))]
        links.append(_link(f"F{scene.floor}/ground", (0.0, 0.0, 0.0), 0.0, ground))
        content = "\n".join(links)
        return f"""    <model name={quoteattr(model.name)}>
      <static>true</static>
      <pose>0 0 {model.elevation:g} 0 0 0</pose>
{content}
    </model>"""

    def _visuals(self, node: Node, mesh: Mesh) -> list[str]:
        scale = ""
        if node.scale != (1.0, 1.0, 1.0):
            scale = f"<scale>{number_list(node.scale)}</scale>"
        visuals = []
        for i, surface in enumerate(mesh.surfaces):
            file = mesh_file_name(mesh.name, i)
            if file not in self.files:
                self.files[file] = write_stl(surface)
            uri = self._uri(file)
            visuals.append(
                f'<visual name="visual_{i}"><geometry><mesh><uri>{uri}</uri>{scale}</mesh></geometry>'
                f"{_material(surface.material)}</visual>"
            )
        return visuals

    def _shape(self, number: int, shape: Shape, node: Node) -> str:
        """Return a collision: a box, or a hull in a file of its own, which all scales of an asset share."""
        if not isinstance(shape, Hull):
            return _collision(number, box_scaled(shape, node.scale))
        file = mesh_file_name(f"{node.mesh}/hull", number)
        if file not in self.files:
            self.files[file] = write_stl(shape)
        scale = f"<scale>{number_list(node.scale)}</scale>" if node.scale != (1.0, 1.0, 1.0) else ""
        return (
            f'<collision name="collision_{number}">'
            f"<geometry><mesh><uri>{self._uri(file)}</uri>{scale}</mesh></geometry></collision>"
        )

    def _uri(self, file: str) -> str:
        return f"{self.mesh_dir}/{file}" if self.mesh_dir else file


def _link(name: str, position: tuple[float, float, float], rotation: float, parts: Sequence[str]) -> str:
    pose = _pose(position, rotation)
    return f"      <link name={quoteattr(name)}>{pose}{''.join(parts)}</link>"


def _material(material: Material) -> str:
    color = f"{number_list(material.color)} {material.alpha:g}"
    clear = f"<transparency>{1.0 - material.alpha:g}</transparency>" if material.alpha < 1 else ""
    return (
        f"{clear}<material><ambient>{color}</ambient><diffuse>{color}</diffuse>"
        f"<pbr><metal><metalness>{material.metallic:g}</metalness>"
        f"<roughness>{material.roughness:g}</roughness></metal></pbr></material>"
    )


def _collision(number: int, box: Box) -> str:
    return (
        f'<collision name="collision_{number}">{_pose(box.center, box.rotation)}'
        f"<geometry><box><size>{number_list(box.size)}</size></box></geometry></collision>"
    )


def _pose(position: tuple[float, float, float], rotation: float) -> str:
    yaw = round(float(np.radians(rotation)), 7) + 0.0
    if not any(position) and not yaw:
        return ""
    return f"<pose>{number_list(position)} 0 0 {yaw:g}</pose>"
