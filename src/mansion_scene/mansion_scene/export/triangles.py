"""A model's nodes as one list of world triangles, for renderers and formats without instances."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from mansion_scene.export.model import Model, Node

__all__ = ["Triangles", "flatten", "placed"]

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
    parts = []
    for node in model.nodes:
        if keep is not None and not keep(node):
            continue
        for surface in model.meshes[node.mesh].surfaces:
            corners = placed(node, surface.vertices)[surface.faces]
            count = len(corners)
            color = np.array(surface.material.color)
            parts.append(
                Triangles(
                    corners, np.tile(color, (count, 1)), np.full(count, surface.material.alpha)
                )
            )
    return Triangles.join(parts)
