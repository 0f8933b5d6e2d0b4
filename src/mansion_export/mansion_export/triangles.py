"""A model's nodes as one list of world triangles, for renderers and formats without instances."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from mansion_export.model import Mesh, Model, Node
from mansion_geometry.compiled import kernel

__all__ = ["Triangles", "bounds", "flatten", "placed", "project"]

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Triangles:
    """Triangles in world coordinates.

    Attributes
    ----------
    corners : (n, 3, 3) array
    colors : (n, 3) array
        sRGB from 0 to 1.
    alpha : (n,) array
    """

    corners: Floats
    colors: Floats
    alpha: Floats

    @staticmethod
    def join(parts: "list[Triangles]") -> "Triangles":
        """Put several lists one after the other."""
        if not parts:
            return Triangles(np.zeros((0, 3, 3)), np.zeros((0, 3)), np.zeros(0))
        return Triangles(
            np.concatenate([part.corners for part in parts]),
            np.concatenate([part.colors for part in parts]),
            np.concatenate([part.alpha for part in parts]),
        )


def placed(node: Node, vertices: Floats) -> Floats:
    """Return a mesh's vertices as the node scales, turns and moves them."""
    scaled = vertices * np.array(node.scale)
    angle = np.radians(node.rotation)
    c, s = np.cos(angle), np.sin(angle)
    x = scaled[:, 0] * c - scaled[:, 1] * s + node.position[0]
    y = scaled[:, 0] * s + scaled[:, 1] * c + node.position[1]
    return np.column_stack([x, y, scaled[:, 2] + node.position[2]])


def flatten(model: Model, keep: Callable[[Node], bool] | None = None) -> Triangles:
    """Return all triangles of a model, in its own frame.

    Parameters
    ----------
    keep : callable, optional
        Which nodes to take; all when it is left out.
    """
    nodes = [node for node in model.nodes if keep is None or keep(node)]
    meshes: dict[str, int] = {}
    for node in nodes:
        meshes.setdefault(node.mesh, len(meshes))
    sources = [_triangles(model.meshes[name]) for name in meshes]
    source = Triangles.join(sources)
    starts = np.cumsum([0, *(len(part.alpha) for part in sources)])
    which = np.array([meshes[node.mesh] for node in nodes], dtype=np.int64)
    poses = np.array([(*node.scale, *node.position, np.radians(node.rotation)) for node in nodes]).reshape(-1, 7)
    counts = (starts[1:] - starts[:-1])[which]
    corners = np.empty((int(counts.sum()), 3, 3))
    origin = np.empty(len(corners), dtype=np.int64)
    _place_instances(source.corners, starts, which, poses, corners, origin)
    return Triangles(corners, source.colors[origin], source.alpha[origin])


def _triangles(mesh: Mesh) -> Triangles:
    """Return a mesh's triangles in its own frame."""
    counts = [len(surface.faces) for surface in mesh.surfaces]
    if not counts:
        return Triangles.join([])
    return Triangles(
        np.concatenate([surface.vertices[surface.faces] for surface in mesh.surfaces]),
        np.repeat([surface.material.color for surface in mesh.surfaces], counts, axis=0),
        np.repeat([surface.material.alpha for surface in mesh.surfaces], counts),
    )


@kernel
def _place_instances(
    source: npt.NDArray[np.float64],
    starts: npt.NDArray[np.int64],
    which: npt.NDArray[np.int64],
    poses: npt.NDArray[np.float64],
    corners: npt.NDArray[np.float64],
    origin: npt.NDArray[np.int64],
) -> None:
    """Write the triangles of mesh ``which[i]`` at ``poses[i]``: scale, position, angle; and where each came from."""
    at = 0
    for i in range(len(which)):
        sx, sy, sz = poses[i, 0], poses[i, 1], poses[i, 2]
        c, s = np.cos(poses[i, 6]), np.sin(poses[i, 6])
        for k in range(starts[which[i]], starts[which[i] + 1]):
            for corner in range(3):
                x, y = source[k, corner, 0] * sx, source[k, corner, 1] * sy
                corners[at, corner, 0] = x * c - y * s + poses[i, 3]
                corners[at, corner, 1] = x * s + y * c + poses[i, 4]
                corners[at, corner, 2] = source[k, corner, 2] * sz + poses[i, 5]
            origin[at] = k
            at += 1


@kernel
def project(corners: npt.NDArray[np.float64], axes: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Return corners, shape (n, 3, 3), along the rows of `axes`."""
    out = np.empty_like(corners)
    for k in range(len(corners)):
        for corner in range(3):
            x, y, z = corners[k, corner, 0], corners[k, corner, 1], corners[k, corner, 2]
            for axis in range(3):
                out[k, corner, axis] = x * axes[axis, 0] + y * axes[axis, 1] + z * axes[axis, 2]
    return out


@kernel
def bounds(corners: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Return the lowest and the highest coordinates of corners, shape (n, 3, 3), as rows."""
    out = np.empty((2, 3))
    out[0], out[1] = np.inf, -np.inf
    for k in range(len(corners)):
        for corner in range(3):
            for axis in range(3):
                out[0, axis] = min(out[0, axis], corners[k, corner, axis])
                out[1, axis] = max(out[1, axis], corners[k, corner, axis])
    return out
