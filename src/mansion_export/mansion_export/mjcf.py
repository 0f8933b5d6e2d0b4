"""A floor as a MuJoCo model (MJCF): bodies named after the scene's ids, collision boxes and visual meshes."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from mansion_assets.catalogue import Catalogue
from mansion_assets.convex import Hull
from mansion_assets.mass_properties import FRICTION
from mansion_export.licences import licence_records, xml_notice
from mansion_export.meshes.building_model import floor_model
from mansion_export.meshes.materials import surface_material
from mansion_export.meshes.model import Material, Mesh, Model, Node, Surface
from mansion_export.meshes.solids import Box
from mansion_export.meshes.walls import WallBodies
from mansion_export.physics.articulation import Assembly, Moving, assemblies, pose_at
from mansion_export.physics.cavities import is_loose, loose_colliders
from mansion_export.physics.collision import Colliders, Shape, ground_boxes, mass_properties_of, shape_scaled
from mansion_export.simulator_files import SimulatorModel, mesh_file_name, number_list, write_stl
from mansion_geometry.building_models import CEILING_GROUP, COLLISION_GROUP, OBJECT_GROUP, STRUCTURE_GROUP
from mansion_msgs_py.building_folder import floor_directory
from mansion_msgs_py.scene import FloorScene, Wall
from mansion_msgs_py.shapes import Size3

__all__ = ["floor_mjcf", "mjcf_files"]

UNSCALED = (1.0, 1.0, 1.0)

EYE = 1.3
"""Height of the spawn camera, metres."""


def floor_mjcf(
    scene: FloorScene,
    mesh_dir: str = "../../meshes",
    *,
    free_pickupables: bool = False,
    articulated: bool = False,
    catalogue: Catalogue | None = None,
) -> SimulatorModel:
    """Make the MuJoCo model of a floor, its finished floor at z = 0.

    Parameters
    ----------
    scene : FloorScene
    mesh_dir : str
        Where the meshes will lie, seen from the XML file.
    free_pickupables : bool
        Give what can be picked up a free joint, and furniture that holds or covers such things boxes with room for
        them; else everything is fixed to the world, and a body is moved by writing its ``body_pos``.
    articulated : bool
        Give doors, drawers and lids joints, which stand as the scene has them: 0 is closed.
    catalogue : Catalogue, optional
        Where the assets are, when they are not all in the shipped one.

    Returns
    -------
    SimulatorModel
        Bodies carry our ids. Geom groups: 0 structure, 1 objects, 2 ceilings, 3 collision boxes (not drawn).
    """
    model = floor_model(scene, catalogue=catalogue)
    writer = _Writer()
    items = {item.id: item for item in scene.objects}
    colliders = Colliders(scene, catalogue)
    moving = assemblies(scene, {node.id: node for node in model.nodes}, catalogue) if articulated else {}
    hollowed = loose_colliders(scene, colliders, model) if free_pickupables else {}
    for wall, pieces in _wall_boxes(scene):
        writer.wall(wall, pieces)
    for node in model.nodes:
        if node.id in writer.walls:
            continue
        item = items.get(node.id)
        loose = item is not None and free_pickupables and is_loose(item)
        if node.id in moving:
            writer.assembly(moving[node.id], free=loose)
            continue
        mesh = model.meshes[node.mesh]
        mass = colliders.mass_of(item) if item is not None and loose else None
        if node.id in hollowed:
            writer.body(node, mesh, _Solid(f"{node.id}/hollowed", hollowed[node.id], UNSCALED), mass)
        else:
            own = colliders.of_object(item) if item is not None and loose else colliders.of(node, mesh)
            writer.body(node, mesh, _Solid(node.mesh, own or (), node.scale), mass)
    for door in scene.doors if articulated else ():
        writer.excluded += [
            (name, other)
            for name in moving
            if name.startswith(f"{door.id}/leaf")
            for other in (door.id, door.wall)
            if other
        ]
    for name, solid in ground_boxes(scene):
        writer.solid(name, solid)
    notice = xml_notice(licence_records([scene], catalogue))
    return SimulatorModel(notice + _document(scene, model, writer, mesh_dir), writer.files)


def mjcf_files(scene: FloorScene, *, articulated: bool = False) -> dict[str, bytes]:
    """Return ``model.xml`` of a floor and its meshes by their paths in the building's folder."""
    model = floor_mjcf(scene, articulated=articulated)
    meshes = {f"meshes/{name}": data for name, data in sorted(model.meshes.items())}
    return {f"{floor_directory(scene.floor)}/model.xml": model.xml.encode(), **meshes}


class _Solid(NamedTuple):
    """What of a mesh collides, before its scale; meshes of one name have the same shapes."""

    name: str
    shapes: Sequence[Shape]
    scale: Size3

    def scaled(self) -> list[Shape]:
        """Return the shapes in the body's frame."""
        return [shape_scaled(shape, self.scale) for shape in self.shapes]


@dataclass(slots=True)
class _Writer:
    bodies: list[str] = field(default_factory=list)
    materials: dict[Material, str] = field(default_factory=dict)
    assets: dict[str, str] = field(default_factory=dict)
    files: dict[str, bytes] = field(default_factory=dict)
    walls: set[str] = field(default_factory=set)
    hulls: dict[str, str] = field(default_factory=dict)
    solids: dict[tuple[str, int, Size3], list[str]] = field(default_factory=dict)
    excluded: list[tuple[str, str]] = field(default_factory=list)

    def material(self, material: Material) -> str:
        """Return the name of a material, writing it when it is new."""
        if material not in self.materials:
            taken = sum(known.name == material.name for known in self.materials)
            self.materials[material] = f"{material.name}_{taken}" if taken else material.name
        return self.materials[material]

    def wall(self, wall: Wall, boxes: Sequence[Box]) -> None:
        """Write a wall as boxes of half its thickness, each in the material of its room."""
        self.walls.add(wall.id)
        faces = (
            (1.0, surface_material(wall.left_material, "wall")),
            (-1.0, surface_material(wall.right_material, "wall")),
        )
        geoms = []
        for i, solid in enumerate(boxes):
            angle = np.radians(solid.rotation)
            for side, material in faces:
                shift = side * wall.thickness / 4
                x = solid.center[0] - float(np.sin(angle)) * shift
                y = solid.center[1] + float(np.cos(angle)) * shift
                half = Box((x, y, solid.center[2]), (solid.size[0], solid.size[1] / 2, solid.size[2]), solid.rotation)
                name = f"{wall.id}/{i}{'l' if side > 0 else 'r'}"
                geoms.append(
                    f"<geom name={quoteattr(name)} {_box_attributes(half)} "
                    f'group="{STRUCTURE_GROUP}" material={quoteattr(self.material(material))}/>'
                )
        self.bodies.append(f"<body name={quoteattr(wall.id)}>{''.join(geoms)}</body>")

    def body(self, node: Node, mesh: Mesh, solid: _Solid, mass: float | None = None) -> None:
        """Write a node as a body of visual meshes and shapes to collide with; `mass` is that of a free one."""
        parts = [*_freedom(node.id, solid, mass), *self._geoms(node.id, node, mesh, solid)]
        self.bodies.append(f"<body name={quoteattr(node.id)} {_place(node)}>{''.join(parts)}</body>")

    def assembly(self, assembly: Assembly, *, free: bool) -> None:
        """Write an element with parts on joints: bodies within its body, or in a frame where all of it moves."""
        node = assembly.node
        inner = [self._moving(part, node) for part in assembly.moving]
        if assembly.mesh is None:
            self.bodies.append(f"<frame {_place(node)}>{''.join(inner)}</frame>")
            return
        solid = _Solid(assembly.mesh.name, assembly.shapes, node.scale)
        parts = _freedom(node.id, solid, assembly.mass if free else None)
        parts += self._geoms(node.id, node, assembly.mesh, solid)
        self.bodies.append(f"<body name={quoteattr(node.id)} {_place(node)}>{''.join([*parts, *inner])}</body>")
        self.excluded += [(part.id, node.id) for part in assembly.moving]

    def _moving(self, part: Moving, node: Node) -> str:
        """Return a part as a body with its joint, where the scene has it."""
        joint = part.joint
        shift, turn = pose_at(joint, part.position)
        solid = _Solid(part.mesh.name, part.shapes, node.scale)
        anchor = f' pos="{number_list(joint.origin)}"' if joint.kind == "hinge" else ""
        content = [
            f'<joint name={quoteattr(part.id)} type="{joint.kind}" axis="{number_list(joint.axis)}"{anchor} '
            f'range="0 {joint.travel:.6g}" ref="{part.position:.6g}" '
            f'frictionloss="{part.resistance:.4g}" damping="{part.damping:.4g}"/>',
            _inertial(solid.scaled(), part.mass),
            *self._geoms(part.id, node, part.mesh, solid),
        ]
        place = f'pos="{number_list(shift)}" euler="{number_list(turn)}"'
        return f"<body name={quoteattr(part.id)} {place}>{''.join(content)}</body>"

    def _geoms(self, name: str, node: Node, mesh: Mesh, solid: _Solid) -> list[str]:
        """Return what of a body is seen and what of it collides."""
        group = {"objects": OBJECT_GROUP, "ceiling": CEILING_GROUP}.get(node.group, STRUCTURE_GROUP)
        parts, called = [], escape(name, {'"': "&quot;"})
        for i, surface in enumerate(mesh.surfaces):
            parts.append(
                f'<geom name="{called}{f"/{i}" if i else ""}" type="mesh" '
                f"mesh={quoteattr(self.mesh(mesh.name, i, surface, node.scale))} "
                f'group="{group}" contype="0" conaffinity="0" mass="0" '
                f"material={quoteattr(self.material(surface.material))}/>"
            )
        for i, shape in enumerate(self._shapes(solid)):
            parts.append(f'<geom name="{called}/collision{f"_{i}" if i else ""}" class="collision" {shape}/>')
        return parts

    def _shapes(self, solid: _Solid) -> list[str]:
        """Return the attributes of shapes; bodies that are alike have them from the first."""
        key = (solid.name, len(solid.shapes), solid.scale)
        if key not in self.solids:
            self.solids[key] = [self.shape(shape) for shape in solid.scaled()]
        return self.solids[key]

    def mesh(self, name: str, part: int, surface: Surface, scale: tuple[float, float, float]) -> str:
        """Return the name of a mesh asset at a scale, writing the asset and its file when they are new."""
        file = mesh_file_name(name, part)
        if file not in self.files:
            self.files[file] = write_stl(surface)
        asset = file.removesuffix(".stl")
        size = ""
        if scale != (1.0, 1.0, 1.0):
            size = f' scale="{number_list(scale)}"'
            asset += "@" + "x".join(f"{value:.4g}" for value in scale)
        if asset not in self.assets:
            self.assets[asset] = f'<mesh name={quoteattr(asset)} file={quoteattr(file)} inertia="shell"{size}/>'
        return asset

    def shape(self, shape: Shape) -> str:
        """Return the attributes of a shape to collide with, writing a hull's corners when they are new."""
        if not isinstance(shape, Hull):
            return _box_attributes(shape)
        corners = number_list(shape.vertices.ravel().tolist())
        if corners not in self.hulls:
            self.hulls[corners] = f"hull_{len(self.hulls)}"
        return f'type="mesh" mesh="{self.hulls[corners]}"'

    def solid(self, name: str, solid: Box) -> None:
        """Write a box of the world that is only collided with."""
        self.bodies.append(f'<geom name={quoteattr(name)} class="collision" {_box_attributes(solid)}/>')


def _wall_boxes(scene: FloorScene) -> list[tuple[Wall, list[Box]]]:
    bodies = WallBodies(scene)
    return [(wall, bodies.boxes(wall)) for wall in scene.walls]


def _document(scene: FloorScene, model: Model, writer: _Writer, mesh_dir: str) -> str:
    points = np.array(scene.outline, dtype=float)
    (x0, y0), (x1, y1) = points.min(0).tolist(), points.max(0).tolist()
    cx, cy = (x0 + x1) / 2, (y0 + y1) / 2
    reach = max(x1 - x0, y1 - y0)
    bodies = "\n".join(f"    {body}" for body in writer.bodies)
    return f"""<mujoco model={quoteattr(f"{scene.building_id} {model.name}")}>
  <compiler angle="degree" meshdir={quoteattr(mesh_dir)} autolimits="true"/>
  <option timestep="0.004"/>
  <size memory="{_memory(len(writer.bodies))}M"/>
  <default>
    <geom friction="{FRICTION:g} 0.005 0.0001"/>
    <default class="collision">
      <geom group="{COLLISION_GROUP}" rgba="0.5 0.5 0.5 0.3"/>
    </default>
  </default>
  <statistic center="{number_list((cx, cy, 1.0))}" extent="{reach:.4g}"/>
  <visual>
    <global offwidth="1280" offheight="960" fovy="70"/>
    <headlight ambient="0.5 0.5 0.5" diffuse="0.3 0.3 0.3" specular="0.05 0.05 0.05"/>
    <map znear="0.002" zfar="4"/>
    <quality shadowsize="1024" offsamples="0"/>
  </visual>
  <asset>
    <texture type="skybox" builtin="gradient" {_sky(scene)} width="128" height="128"/>
{_assets(writer)}
  </asset>
  <worldbody>
    <light name="sun" type="directional" dir="0.35 0.5 -0.79" diffuse="0.35 0.34 0.32" castshadow="false"/>
    <light name="fill" type="directional" dir="-0.6 -0.35 -0.7" diffuse="0.16 0.17 0.19" castshadow="false"/>
    <light name="bounce" type="directional" dir="0.1 0.15 0.98" diffuse="0.22 0.22 0.21" castshadow="false"/>
    <camera name="overview" pos="{number_list((cx, cy - 0.75 * reach, 1.15 * reach))}" \
xyaxes="1 0 0 0 0.84 0.55" fovy="45"/>
{_robot_camera(scene)}
{bodies}
  </worldbody>
{_contacts(writer.excluded)}</mujoco>
"""


def _assets(writer: _Writer) -> str:
    """Return the materials, the meshes that are drawn, and the hulls that collide."""
    materials = "\n".join(
        f"    <material name={quoteattr(name)} "
        f'rgba="{number_list((*material.color, material.alpha))}" '
        f'specular="{0.5 * (1.0 - material.roughness):.3g}" '
        f'shininess="{1.0 - material.roughness:.3g}" emission="{material.emission:.3g}"/>'
        for material, name in writer.materials.items()
    )
    meshes = "\n".join(f"    {asset}" for asset in writer.assets.values())
    hulls = "\n".join(
        f'    <mesh name="{name}" vertex="{corners}" inertia="shell"/>' for corners, name in writer.hulls.items()
    )
    return f"{materials}\n{meshes}\n{hulls}"


def _contacts(excluded: Sequence[tuple[str, str]]) -> str:
    """Return the pairs of bodies that do not collide, because a joint holds them apart."""
    if not excluded:
        return ""
    pairs = "\n".join(f"    <exclude body1={quoteattr(a)} body2={quoteattr(b)}/>" for a, b in excluded)
    return f"  <contact>\n{pairs}\n  </contact>\n"


def _place(node: Node) -> str:
    """Return the position and heading of a node."""
    place = f'pos="{number_list(node.position)}"' if any(node.position) else ""
    return place + (f' quat="{_quaternion(node.rotation)}"' if node.rotation % 360.0 else "")


def _sky(scene: FloorScene) -> str:
    digits = scene.sky.color if len(scene.sky.color) == 7 else "#bfd9ff"
    r, g, b = (int(digits[i : i + 2], 16) / 255.0 for i in (1, 3, 5))
    return f'rgb1="{r:.3g} {g:.3g} {b:.3g}" rgb2="0.92 0.93 0.94"'


def _robot_camera(scene: FloorScene) -> str:
    """Return a level camera at the spawn pose, at eye height."""
    if scene.spawn is None:
        return ""
    yaw = np.radians(scene.spawn.yaw)
    c, s = float(np.cos(yaw)), float(np.sin(yaw))
    place = number_list((scene.spawn.x, scene.spawn.y, EYE))
    return f'    <camera name="spawn" pos="{place}" xyaxes="{s:.6g} {-c:.6g} 0 0 0 1" fovy="70"/>'


def _memory(bodies: int) -> int:
    """Return the megabytes that the search for pairs of bodies needs; MuJoCo's default is too small for that."""
    return 16 + math.ceil(8 * bodies * bodies / 2**20)


def _freedom(name: str, solid: _Solid, mass: float | None) -> list[str]:
    """Return the free joint and the inertia of a body that is not fixed to the world."""
    if mass is None:
        return []
    return [f"<freejoint name={quoteattr(name + '/joint')}/>{_inertial(solid.scaled(), mass)}"]


def _inertial(shapes: Sequence[Shape], mass: float) -> str:
    """Return the mass, centre and inertia of a body of one density."""
    body = mass_properties_of(shapes, mass)
    i = body.inertia
    values = (i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2])
    inertia = " ".join(f"{float(value):.6g}" for value in values)
    return f'<inertial pos="{number_list(body.center)}" mass="{body.mass:.6g}" fullinertia="{inertia}"/>'


def _box_attributes(solid: Box) -> str:
    half = tuple(max(value / 2, 5e-4) for value in solid.size)
    turn = f' quat="{_quaternion(solid.rotation)}"' if solid.rotation % 360.0 else ""
    return f'type="box" pos="{number_list(solid.center)}" size="{number_list(half)}"{turn}'


def _quaternion(rotation: float) -> str:
    half = np.radians(rotation) / 2.0
    return number_list((float(np.cos(half)), 0.0, 0.0, float(np.sin(half))))
