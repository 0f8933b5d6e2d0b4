"""The building as meshes, materials and nodes: what every 3D format is written from."""

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

__all__ = ["Material", "Mesh", "Model", "Node", "Surface", "merge_surfaces"]

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class Material:
    """A metallic-roughness material; colour and alpha are sRGB from 0 to 1."""

    name: str
    color: tuple[float, float, float]
    alpha: float = 1.0
    roughness: float = 0.8
    metallic: float = 0.0
    emission: float = 0.0


@dataclass(frozen=True, slots=True)
class Surface:
    """Triangles of one material, z up, metres.

    Attributes
    ----------
    vertices : (n, 3) array
    faces : (m, 3) array of int
        Counter-clockwise seen from outside.
    """

    material: Material
    vertices: Floats
    faces: Ints


@dataclass(frozen=True, slots=True)
class Mesh:
    """Surfaces that are drawn together, shared by all nodes that name it."""

    name: str
    surfaces: tuple[Surface, ...]


@dataclass(frozen=True, slots=True)
class Node:
    """A mesh in a place.

    Attributes
    ----------
    id : str
        Id of the scene's element.
    group : str
        ``structure``, ``ceiling``, ``doors``, ``windows``, ``cores`` or ``objects``.
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


@dataclass(slots=True)
class Model:
    """Nodes of one floor and the meshes that they share.

    Attributes
    ----------
    elevation : float
        Of the floor's frame in the building's, metres.
    title : str
        What a person calls the floor; empty where it has no such name.
    """

    name: str
    floor: int
    elevation: float
    nodes: list[Node] = field(default_factory=list)
    meshes: dict[str, Mesh] = field(default_factory=dict)
    title: str = ""

    def add(self, node: Node, surfaces: Iterable[Surface] | None = None) -> None:
        """Add a node, and its mesh where that is not there yet."""
        if surfaces is not None and node.mesh not in self.meshes:
            self.meshes[node.mesh] = Mesh(node.mesh, merge_surfaces(surfaces))
        self.nodes.append(node)


def merge_surfaces(surfaces: Iterable[Surface]) -> tuple[Surface, ...]:
    """Join surfaces of the same material, in the order in which materials come up."""
    groups: dict[Material, list[Surface]] = {}
    for surface in surfaces:
        if len(surface.faces):
            groups.setdefault(surface.material, []).append(surface)
    merged = []
    for material, parts in groups.items():
        offsets = np.cumsum([0] + [len(part.vertices) for part in parts[:-1]])
        vertices = np.concatenate([part.vertices for part in parts])
        faces = np.concatenate([part.faces + start for part, start in zip(parts, offsets)])
        merged.append(Surface(material, vertices, faces))
    return tuple(merged)
