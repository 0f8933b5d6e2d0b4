"""A building as meshes, materials and nodes, from which every 3D format is written."""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, fields, replace
from hashlib import blake2b
from typing import TypeAlias

import numpy as np

from mansion_assets.texture_coordinates import box_coordinates
from mansion_geometry.compiled import Floats, Ints

__all__ = ["Material", "Mesh", "Model", "Node", "Part", "Surface", "assemble", "merge_surfaces", "named_by_content"]

_NOT_GIVEN = np.zeros((0, 3, 2))


@dataclass(frozen=True, slots=True)
class Material:
    """A metallic-roughness material; colour and alpha are sRGB from 0 to 1.

    `texture` names its set of textures, which `color` tints (`mansion_assets.materials`); empty for a plain one.
    """

    name: str
    color: tuple[float, float, float]
    alpha: float = 1.0
    roughness: float = 0.8
    metallic: float = 0.0
    emission: float = 0.0
    texture: str = ""


@dataclass(frozen=True, slots=True)
class Surface:
    """Triangles of one material, z up, metres.

    Attributes
    ----------
    vertices : (n, 3) array
    faces : (m, 3) array of int
        Counter-clockwise seen from outside.
    coordinates : (m, 3, 2) array
        Place of each face's corners on the material's textures: metres to the right and up, seen from outside. By
        default each face is laid flat along the axis that it faces most.
    """

    material: Material
    vertices: Floats
    faces: Ints
    coordinates: Floats = field(default_factory=lambda: _NOT_GIVEN)

    def __post_init__(self) -> None:
        if self.coordinates is _NOT_GIVEN:
            laid = box_coordinates(self.vertices, self.faces, np.zeros(1, dtype=np.int64), turned=False)
            object.__setattr__(self, "coordinates", laid)


@dataclass(frozen=True, slots=True)
class Mesh:
    """Surfaces that are drawn together, shared by all nodes that name it."""

    name: str
    surfaces: tuple[Surface, ...]


@dataclass(frozen=True, slots=True)
class Node:
    """A mesh at a pose.

    Attributes
    ----------
    id : str
        Id of the scene's element.
    group : str
        ``structure``, ``ceiling``, ``doors``, ``windows``, ``cores``, ``objects`` or ``site``.
    position : (x, y, z)
        In the floor's frame.
    rotation : float
        Degrees counter-clockwise about z.
    scale : (x, y, z)
    room : str
        Id of the room it belongs to; empty where it belongs to several.
    label : tuple of str
        What a viewer writes over it, line by line.
    label_at : (x, y, z)
        Where it writes that.
    """

    id: str
    mesh: str
    group: str
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    rotation: float = 0.0
    scale: tuple[float, float, float] = (1.0, 1.0, 1.0)
    room: str = ""
    label: tuple[str, ...] = ()
    label_at: tuple[float, float, float] = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Model:
    """Nodes of one floor and the meshes that they share.

    Attributes
    ----------
    elevation : float
        Height of the floor's frame in the building's, metres.
    nodes : tuple of Node
    meshes : dict of str to Mesh
        By name, in the order in which nodes first name them.
    title : str
        What a person calls the floor; empty where it has no such name.
    """

    name: str
    floor: int
    elevation: float
    nodes: tuple[Node, ...]
    meshes: dict[str, Mesh]
    title: str = ""


Part: TypeAlias = tuple[Node, Sequence[Surface]]
"""A node and the surfaces of its mesh; of nodes that share a mesh the first one's are taken."""


def assemble(name: str, floor: int, elevation: float, parts: Iterable[Part], title: str = "") -> Model:
    """Return the model of a floor from its parts, in their order; see `Model`."""
    nodes: list[Node] = []
    meshes: dict[str, Mesh] = {}
    for node, surfaces in parts:
        nodes.append(node)
        if node.mesh not in meshes:
            meshes[node.mesh] = Mesh(node.mesh, merge_surfaces(surfaces))
    return Model(name, floor, elevation, tuple(nodes), meshes, title)


def merge_surfaces(surfaces: Iterable[Surface]) -> tuple[Surface, ...]:
    """Join surfaces of the same material, in the order in which materials come up."""
    groups: dict[Material, list[Surface]] = {}
    for surface in surfaces:
        if len(surface.faces):
            groups.setdefault(surface.material, []).append(surface)
    merged = []
    for material, parts in groups.items():
        if len(parts) == 1:
            merged.append(parts[0])
            continue
        offsets = np.cumsum([0] + [len(part.vertices) for part in parts[:-1]])
        vertices = np.concatenate([part.vertices for part in parts])
        faces = np.concatenate([part.faces + start for part, start in zip(parts, offsets)])
        coordinates = np.concatenate([part.coordinates for part in parts])
        merged.append(Surface(material, vertices, faces, coordinates))
    return tuple(merged)


_FLOOR = re.compile(r"^(F-?\d+/)+")
"""The floor that an element's name begins with."""

_NUMBER = re.compile(r"_\d+\b")


def named_by_content(model: Model) -> Model:
    """Return the model with each mesh of one element named after its kind and its content.

    Meshes that are named after an element (``F2/stair_1/landing``) become ``stair/landing:7c1f09aa``, where the equal
    landing of another floor has the same name. Those of assets, doors and windows keep their names, which say what
    they show.
    """
    names = {name: _name(mesh) if _FLOOR.match(name) else name for name, mesh in model.meshes.items()}
    meshes: dict[str, Mesh] = {}
    for name, mesh in model.meshes.items():
        meshes.setdefault(names[name], replace(mesh, name=names[name]))
    return replace(model, nodes=tuple(_named(node, names[node.mesh]) for node in model.nodes), meshes=meshes)


def _named(node: Node, mesh: str) -> Node:
    return node if node.mesh == mesh else replace(node, mesh=mesh)


def _name(mesh: Mesh) -> str:
    kind = _NUMBER.sub("", _FLOOR.sub("", mesh.name))
    return f"{kind}:{_digest(mesh.surfaces)}"


def _digest(surfaces: tuple[Surface, ...]) -> str:
    digest = blake2b(digest_size=8)
    for surface in surfaces:
        for each in fields(surface):
            value = getattr(surface, each.name)
            digest.update(value.tobytes() if isinstance(value, np.ndarray) else repr(value).encode())
    return digest.hexdigest()
