"""Elements of a floor with parts that move: doors and lids of furniture, drawers, leaves of rooms and lifts."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

import msgspec
import numpy as np

from mansion_assets.catalogue import Catalogue, load_catalogue
from mansion_assets.convex import volume_of
from mansion_assets.joints import DOOR_OPENS, Joint
from mansion_assets.meshes import Link, links
from mansion_assets.solids import Vec3
from mansion_export.meshes.asset_surfaces import part_surfaces
from mansion_export.meshes.door_sides import swing_side
from mansion_export.meshes.model import Mesh, Node, Part, merge_surfaces
from mansion_export.meshes.opening_meshes import leaf_parts
from mansion_export.meshes.solids import Box, boxes_of
from mansion_export.physics.collision import Shape, lies_flat, mass_properties_of, piece_shape, shape_scaled
from mansion_geometry.building_models import object_mass
from mansion_msgs_py.scene import FloorScene, SceneObject
from mansion_msgs_py.shapes import Size3

__all__ = ["Assembly", "Moving", "assemblies", "pose_at"]

GRAVITY: Final = 9.81

HOLDS: Final = 1.5
"""How much stronger a lid's hinge holds than its weight pulls, so that it stays where it is put."""

EASY: Final = 0.05
"""Share of its weight that a part resists with which gravity does not pull: an upright door, a drawer."""

CLEARANCE: Final = 0.002
"""Metres that a leaf's collider is smaller than the leaf on every side: it hangs in its frame without touching."""


@dataclass(frozen=True, slots=True)
class Moving:
    """A part on a joint.

    Attributes
    ----------
    id : str
        Id of the scene's element, with the part's name in it.
    mesh : Mesh
    shapes : tuple of Box or Hull
        What of it collides. Both are in the element's frame when it is closed, before its scale.
    joint : Joint
        In the element's frame, scaled.
    position : float
        Where it stands in the scene: from 0, closed, to the joint's travel, open.
    mass, resistance, damping : float
        Kilograms; N m or N, and N m s/rad or N s/m, of the joint.
    """

    id: str
    mesh: Mesh
    shapes: tuple[Shape, ...]
    joint: Joint
    position: float
    mass: float
    resistance: float
    damping: float


@dataclass(frozen=True, slots=True)
class Assembly:
    """An element whose parts move.

    Attributes
    ----------
    node : Node
        Where the element is; of a leaf, where it is closed.
    mesh : Mesh, optional
        Mesh of what does not move; None where everything does.
    shapes : tuple of Box or Hull
        What of that collides, before the node's scale.
    mass : float
        Mass of what does not move, kilograms.
    """

    node: Node
    mesh: Mesh | None
    shapes: tuple[Shape, ...]
    mass: float
    moving: tuple[Moving, ...]


def pose_at(joint: Joint, position: float) -> tuple[Vec3, Vec3]:
    """Return where a part is at a position of its joint: shift in metres, turn in degrees about x, y and z.

    Joints turn about axes of the element's frame, so at most one of the three angles is not 0.
    """
    axis = np.array(joint.axis)
    if joint.kind == "slide":
        return _vec(axis * position), (0.0, 0.0, 0.0)
    angle = np.radians(position)
    origin = np.array(joint.origin)
    turned = (
        origin * np.cos(angle) + np.cross(axis, origin) * np.sin(angle) + axis * (axis @ origin) * (1.0 - np.cos(angle))
    )
    return _vec(origin - turned), _vec(axis * position)


def _vec(values: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> Vec3:
    return float(values[0]), float(values[1]), float(values[2])


def assemblies(scene: FloorScene, nodes: Mapping[str, Node], catalogue: Catalogue | None = None) -> dict[str, Assembly]:
    """Return the elements of a floor whose parts move, by the id of their node.

    Parameters
    ----------
    scene : FloorScene
        Its doors' ``is_open`` and its objects' state ``open`` say where the parts stand.
    nodes : mapping of str to Node
        Nodes of the floor's model.
    catalogue : Catalogue, optional
        The shipped one when it is left out.
    """
    known = catalogue or load_catalogue()
    found = {assembly.node.id: assembly for assembly in _leaves(scene)}
    for item in scene.objects:
        if item.id in nodes and item.asset in known.assets and not lies_flat(item):
            rigid = _links(item.asset, known)
            if len(rigid) > 1:
                found[item.id] = _furniture(item, nodes[item.id], rigid, known)
    return found


@lru_cache(maxsize=256)
def _links(key: str, catalogue: Catalogue) -> tuple[Link, ...]:
    return links(catalogue.asset(key))


def _furniture(item: SceneObject, node: Node, rigid: tuple[Link, ...], catalogue: Catalogue) -> Assembly:
    """Return an object; its mass is spread over its parts by their volume."""
    own = catalogue.asset(item.asset)
    color = "" if item.color in ("", own.color) else item.color
    volumes = [sum(volume_of(piece) for piece in link.pieces) for link in rigid]
    total = object_mass(item.size) if own.mass is None else own.mass
    is_open = item.states.get("open") is True
    moving, body = [], rigid[0]
    for link, volume in zip(rigid[1:], volumes[1:]):
        if link.joint is None:
            continue
        joint = link.joint.fitted(np.zeros(3), np.array(node.scale))
        mesh = Mesh(f"{node.mesh}/{link.name}", merge_surfaces(part_surfaces(link.parts, own.material, color)))
        shapes = tuple(piece_shape(piece) for piece in link.pieces)
        position = joint.travel if is_open else 0.0
        moving.append(
            _moving(f"{item.id}/{link.name}", mesh, shapes, joint, position, total * volume / sum(volumes), node.scale)
        )
    still = Mesh(f"{node.mesh}/body", merge_surfaces(part_surfaces(body.parts, own.material, color)))
    shapes = tuple(piece_shape(piece) for piece in body.pieces)
    return Assembly(node, still, shapes, total * volumes[0] / sum(volumes), tuple(moving))


def _moving(
    name: str, mesh: Mesh, shapes: tuple[Shape, ...], joint: Joint, position: float, mass: float, scale: Size3
) -> Moving:
    """Return a part whose joint resists so much that it stays where it is put."""
    center = np.array(mass_properties_of([shape_scaled(shape, scale) for shape in shapes], mass).center)
    axis = np.array(joint.axis)
    away = center - np.array(joint.origin)
    reach = float(np.linalg.norm(away - axis * (axis @ away))) if joint.kind == "hinge" else 1.0
    upright = joint.kind == "slide" or abs(joint.axis[2]) > 0.5
    resistance = mass * GRAVITY * reach * (EASY if upright else HOLDS)
    return Moving(name, mesh, shapes, joint, position, mass, resistance, 0.2 * mass * reach * max(reach, 0.1))


def _leaves(scene: FloorScene) -> Iterator[Assembly]:
    """Yield the leaves of the floor's doors; how they move is what an open one differs in from a closed one."""
    closed = _leaf_parts(scene, is_open=False)
    opened = _leaf_parts(scene, is_open=True)
    rings = {room.id: room.polygon for room in scene.rooms}
    doors = {name: door for door in scene.doors for name in closed if name.startswith(f"{door.id}/leaf")}
    for name, (node, surfaces) in closed.items():
        mesh = Mesh(node.mesh, merge_surfaces(surfaces))
        boxes = tuple(_shrunk(box) for surface in mesh.surfaces for box in boxes_of(surface))
        inward = swing_side(doors[name], rings)
        joint = _leaf_joint(node, opened[name][0], boxes, inward)
        position = joint.travel if doors[name].is_open else 0.0
        low = np.min([np.array(box.center) - np.array(box.size) / 2 for box in boxes], axis=0)
        high = np.max([np.array(box.center) + np.array(box.size) / 2 for box in boxes], axis=0)
        mass = object_mass((high - low).tolist())
        yield Assembly(node, None, (), 0.0, (_moving(name, mesh, boxes, joint, position, mass, node.scale),))


def _leaf_parts(scene: FloorScene, *, is_open: bool) -> dict[str, Part]:
    doors = [msgspec.structs.replace(door, is_open=is_open) for door in scene.doors]
    return {part[0].id: part for part in leaf_parts(msgspec.structs.replace(scene, doors=doors))}


def _shrunk(box: Box) -> Box:
    size = tuple(max(value - 2 * CLEARANCE, value / 2) for value in box.size)
    return Box(box.center, (size[0], size[1], size[2]))


def _leaf_joint(closed: Node, opened: Node, boxes: tuple[Box, ...], inward: int) -> Joint:
    """Return the hinge or slide between two poses of a leaf; one that has but one pose tilts outward about its head.

    Parameters
    ----------
    inward : int
        The side of the door's segment that it opens to: 1 left, -1 right.
    """
    turn = (opened.rotation - closed.rotation + 180.0) % 360.0 - 180.0
    if abs(turn) > 1e-6:
        return Joint("leaf", "hinge", (0.0, 0.0, float(np.sign(turn))), (0.0, 0.0, 0.0), abs(turn))
    shift = np.array(opened.position) - np.array(closed.position)
    travel = float(np.linalg.norm(shift))
    if travel > 1e-6:
        angle = np.radians(closed.rotation)
        along = float(shift[0] * np.cos(angle) + shift[1] * np.sin(angle))
        return Joint("leaf", "slide", (float(np.sign(along)), 0.0, 0.0), (0.0, 0.0, 0.0), travel)
    head = max(box.center[2] + box.size[2] / 2 for box in boxes)
    return Joint("leaf", "hinge", (float(-inward), 0.0, 0.0), (0.0, 0.0, head), DOOR_OPENS)
