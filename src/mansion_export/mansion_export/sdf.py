"""A building as a Gazebo world (SDFormat 1.9): a static model for each floor, links named after the scene's ids."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from xml.sax.saxutils import quoteattr

import numpy as np

from mansion_assets.catalogue import Catalogue
from mansion_assets.convex import Hull
from mansion_export.licences import licence_records, xml_notice
from mansion_export.meshes.building_model import building_models
from mansion_export.meshes.model import Material, Mesh, Model, Node
from mansion_export.meshes.solids import Box, box_scaled
from mansion_export.meshes.walls import WallBodies
from mansion_export.physics.articulation import Assembly, Moving, assemblies, pose_at
from mansion_export.physics.collision import Colliders, Shape, ground_boxes, mass_properties_of, shape_scaled
from mansion_export.simulator_files import SimulatorModel, mesh_file_name, number_list, write_stl
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import Size3

__all__ = ["sdf_files", "world_sdf"]

BODY = "body"
"""Name of the link of an element that does not move."""


def world_sdf(
    scenes: Sequence[FloorScene],
    mesh_dir: str = "meshes",
    catalogue: Catalogue | None = None,
    *,
    articulated: bool = False,
    site: bool = True,
) -> SimulatorModel:
    """Make a Gazebo world of all floors.

    Parameters
    ----------
    scenes : sequence of FloorScene
    mesh_dir : str
        Folder of the meshes, seen from the world file.
    catalogue : Catalogue, optional
        Where the assets are, when they are not all in the shipped one.
    articulated : bool
        Make what has doors, drawers or lids, and each leaf, a model of its own whose parts have joints.
    site : bool
        With the plot around the building.

    Returns
    -------
    SimulatorModel
        Each floor is a static model at its elevation, z up. Every wall, door leaf, window, stair and object is a link
        with its id; walls, floors, steps, doors and objects have shapes to collide with.
    """
    writer = _Writer(mesh_dir, catalogue, articulated)
    ordered = sorted(scenes, key=lambda scene: scene.floor)
    models: list[str] = []
    for model, scene in zip(building_models(ordered, site=site, catalogue=catalogue), ordered):
        models += writer.models(model, scene)
    name = ordered[0].building_id if ordered else "building"
    notice = xml_notice(licence_records(ordered, catalogue))
    return SimulatorModel(_world(name, models, notice), dict(sorted(writer.files.items())))


def sdf_files(scenes: Sequence[FloorScene], *, articulated: bool = False, site: bool = True) -> dict[str, bytes]:
    """Return ``building.sdf`` and its meshes by their paths in the building's folder."""
    world = world_sdf(scenes, articulated=articulated, site=site)
    return {"building.sdf": world.xml.encode(), **{f"meshes/{name}": data for name, data in world.meshes.items()}}


def _world(name: str, models: Sequence[str], notice: str) -> str:
    content = "\n".join(models)
    return f"""<?xml version="1.0"?>
{notice}<sdf version="1.9">
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
    articulated: bool
    files: dict[str, bytes] = field(default_factory=dict)

    def models(self, model: Model, scene: FloorScene) -> list[str]:
        """Return the model of a floor, and after it those of its elements whose parts move."""
        moving = assemblies(scene, {node.id: node for node in model.nodes}, self.catalogue) if self.articulated else {}
        walls = {wall.id: wall for wall in scene.walls}
        colliders = Colliders(scene, self.catalogue)
        bodies = WallBodies(scene)
        links = []
        for node in model.nodes:
            if node.id in moving:
                continue
            mesh = model.meshes[node.mesh]
            parts = self._visuals(node, mesh)
            if node.id in walls:
                parts += [_collision(i, box) for i, box in enumerate(bodies.boxes(walls[node.id]))]
            else:
                shapes = colliders.of(node, mesh) or ()
                parts += self._shapes(shapes, node.mesh, node.scale)
            links.append(_link(node.id, node.position, node.rotation, parts))
        ground = [_collision(i, box) for i, (_, box) in enumerate(ground_boxes(scene))]
        links.append(_link(f"F{scene.floor}/ground", (0.0, 0.0, 0.0), 0.0, ground))
        content = "\n".join(links)
        floor = f"""    <model name={quoteattr(model.name)}>
      <static>true</static>
      <pose>0 0 {model.elevation:g} 0 0 0</pose>
{content}
    </model>"""
        return [floor, *(self.assembly(moving[key], model.elevation) for key in sorted(moving))]

    def assembly(self, assembly: Assembly, elevation: float) -> str:
        """Return an element with parts on joints as a model; each joint is 0 where the scene has its part."""
        node = assembly.node
        parent, parts = "world", []
        if assembly.mesh is not None:
            parent = BODY
            content = [
                *self._visuals(node, assembly.mesh),
                *self._shapes(assembly.shapes, assembly.mesh.name, node.scale),
            ]
            parts.append(
                _link(BODY, (0.0, 0.0, 0.0), 0.0, [_inertial(assembly.shapes, node.scale, assembly.mass), *content])
            )
            parts.append(f'      <joint name="fixed" type="fixed"><parent>world</parent><child>{BODY}</child></joint>')
        for part in assembly.moving:
            parts += self._moving(part, parent, node)
        x, y, z = node.position
        inner = "\n".join(parts)
        return f"""    <model name={quoteattr(node.id)}>
      {_pose((x, y, z + elevation), node.rotation)}
{inner}
    </model>"""

    def _moving(self, part: Moving, parent: str, node: Node) -> list[str]:
        """Return the link and the joint of a part that moves."""
        joint = part.joint
        shift, turn = pose_at(joint, part.position)
        angles = number_list(np.radians(turn).tolist())
        content = [
            f"<pose>{number_list(shift)} {angles}</pose>",
            _inertial(part.shapes, node.scale, part.mass),
            *self._visuals(node, part.mesh),
            *self._shapes(part.shapes, part.mesh.name, node.scale),
        ]
        turns = joint.kind == "hinge"
        low, high = -part.position, joint.travel - part.position
        if turns:
            low, high = float(np.radians(low)), float(np.radians(high))
        name = f"{joint.part}_joint"
        return [
            f"      <link name={quoteattr(joint.part)}>{''.join(content)}</link>",
            f'      <joint name={quoteattr(name)} type="{"revolute" if turns else "prismatic"}">'
            f"<pose>{number_list(joint.origin)} 0 0 0</pose><parent>{parent}</parent><child>{joint.part}</child>"
            f"<axis><xyz>{number_list(joint.axis)}</xyz><limit><lower>{low:.6g}</lower><upper>{high:.6g}</upper></limit>"
            f"<dynamics><damping>{part.damping:.4g}</damping><friction>{part.resistance:.4g}</friction></dynamics>"
            f"</axis></joint>",
        ]

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

    def _shapes(self, shapes: Sequence[Shape], mesh: str, scale: Size3) -> list[str]:
        """Return the collisions of a mesh: boxes, and hulls in files of their own, which all its scales share."""
        found = []
        stretch = f"<scale>{number_list(scale)}</scale>" if scale != (1.0, 1.0, 1.0) else ""
        for i, shape in enumerate(shapes):
            if not isinstance(shape, Hull):
                found.append(_collision(i, box_scaled(shape, scale)))
                continue
            file = mesh_file_name(f"{mesh}/hull", i)
            if file not in self.files:
                self.files[file] = write_stl(shape)
            found.append(
                f'<collision name="collision_{i}">'
                f"<geometry><mesh><uri>{self._uri(file)}</uri>{stretch}</mesh></geometry></collision>"
            )
        return found

    def _uri(self, file: str) -> str:
        return f"{self.mesh_dir}/{file}" if self.mesh_dir else file


def _inertial(shapes: Sequence[Shape], scale: Size3, mass: float) -> str:
    """Return the mass, centre and inertia of a link of one density."""
    body = mass_properties_of([shape_scaled(shape, scale) for shape in shapes], mass)
    i = body.inertia
    names = {"ixx": i[0, 0], "ixy": i[0, 1], "ixz": i[0, 2], "iyy": i[1, 1], "iyz": i[1, 2], "izz": i[2, 2]}
    inertia = "".join(f"<{name}>{float(value):.6g}</{name}>" for name, value in names.items())
    pose = f"<pose>{number_list(body.center)} 0 0 0</pose>"
    return f"<inertial>{pose}<mass>{body.mass:.6g}</mass><inertia>{inertia}</inertia></inertial>"


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
