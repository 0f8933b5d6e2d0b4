"""Chimneys over the fireplaces of a building."""

from collections.abc import Iterator, Sequence
from typing import Final

import numpy as np
from shapely.geometry import Point as Place
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Node, Part
from mansion_export.meshes.solids import Box, boxes_surface
from mansion_msgs_py.scene import FloorScene

__all__ = ["chimney_parts"]

STACK: Final = 0.7
"""Side of a chimney's stack, metres."""

ABOVE: Final = 0.8
"""From the roof to the head of a chimney, metres."""

HEARTHS: Final = frozenset({"fireplace"})


def chimney_parts(
    scene: FloorScene, below: Sequence[FloorScene], roof: Sequence[Part], above: BaseGeometry | None
) -> Iterator[Part]:
    """Yield a chimney over each fireplace of a floor and of those below that its roof covers.

    Parameters
    ----------
    below : sequence of FloorScene
        The floors below the roof, this one among them.
    roof : sequence of Part
        What covers the floor.
    above : geometry, optional
        Ground plan of the storey above; none over the highest.
    """
    points = [surface.vertices for _, surfaces in roof for surface in surfaces if len(surface.vertices)]
    if not points:
        return
    outline = Polygon(scene.outline, scene.holes)
    vertices = np.concatenate(points)
    ridge, eaves = float(vertices[:, 2].max()), max((wall.height for wall in scene.walls), default=2.8)
    hearths = [thing for floor in below for thing in floor.objects if thing.category in HEARTHS]
    for number, thing in enumerate(hearths, 1):
        x, y = thing.position[0], thing.position[1]
        if not outline.contains(Place(x, y)) or (above is not None and above.contains(Place(x, y))):
            continue
        name = f"F{scene.floor}/chimney_{number}"
        head = ridge + ABOVE
        stack = Box((x, y, (eaves + head) / 2), (STACK, STACK, head - eaves))
        cap = Box((x, y, head + 0.05), (STACK + 0.14, STACK + 0.14, 0.1))
        pots = [Box((x + side * 0.17, y, head + 0.22), (0.2, 0.2, 0.25)) for side in (-1, 1)]
        yield (
            Node(name, name, "ceiling"),
            [boxes_surface([stack], named("dark_brick")), boxes_surface([cap, *pots], named("concrete_panels"))],
        )
