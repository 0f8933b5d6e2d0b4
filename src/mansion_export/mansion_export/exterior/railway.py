"""The platform of a railway station beside its building, with a roof on posts, and the track along it."""

from typing import Final

import numpy as np
from shapely.geometry import Polygon

from mansion_export.exterior.fronts import Front
from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Node, Part
from mansion_export.meshes.solids import Box, boxes_surface

__all__ = ["platform_part", "track_bed"]

PLATFORM: Final = (0.8, 4.6)
"""From the building's end to either edge of the platform, metres."""

TRACK: Final = (4.8, 8.0)
"""From the building's end to either edge of the ballast, metres."""

BEYOND: Final = 10.0
"""How far the platform and the track reach behind the building, metres."""

GAUGE, SLEEPERS = 1.435, 0.65
"""Between the rails, and between the middles of sleepers, metres."""

ROOF: Final = 3.4
"""Height of the roof over the platform, metres."""

_WIDTH: Final = 0.12
"""Width of posts and of the line along the edge, metres."""


def _depth(front: Front, slab: Polygon) -> float:
    """Return how far a building reaches behind its front, metres."""
    corners = np.asarray(slab.exterior.coords) - np.array(front.middle)
    return float(-(corners @ np.array(front.out)).min())


def track_bed(front: Front, slab: Polygon) -> Polygon:
    """Return the ground that the platform and the track take, beside the end of the front that `along` points to."""
    near, far = front.high, front.high + TRACK[1]
    back = -_depth(front, slab) - BEYOND
    return Polygon([front.at(near, 1.0), front.at(far, 1.0), front.at(far, back), front.at(near, back)])


def platform_part(front: Front, slab: Polygon, ground: float, name: str) -> Part:
    """Return the platform, the roof over it, and the track with its rails, sleepers and a buffer stop."""
    depth, end = _depth(front, slab), front.high
    long = (-depth - BEYOND, 0.5)
    edges = (end + PLATFORM[0], end + PLATFORM[1])
    middle, bed = end + sum(TRACK) / 2, (end + TRACK[0], end + TRACK[1])
    rails = [
        front.box((rail - 0.035, rail + 0.035), long, (ground + 0.2, ground + 0.34))
        for rail in (middle - GAUGE / 2, middle + GAUGE / 2)
    ]
    sleepers = [
        front.box((middle - 1.25, middle + 1.25), (float(at), float(at) + 0.24), (ground + 0.1, ground + 0.2))
        for at in np.arange(long[0], long[1] - 0.3, SLEEPERS)
    ]
    posts = [
        front.box((edges[0] + 1.7, edges[0] + 1.7 + _WIDTH), (float(at), float(at) + _WIDTH), (ground, ROOF))
        for at in np.linspace(-depth, -0.6, max(2, round(depth / 4.5)))
    ]
    roof = front.box((edges[0], edges[1] - 0.2), (-depth - 0.4, 0.2), (ROOF, ROOF + 0.16))
    stop = front.box((middle - 1.2, middle + 1.2), (long[1] - 0.3, long[1]), (ground + 0.2, ground + 1.2))
    line = front.box((edges[1] - 0.5, edges[1] - 0.5 + _WIDTH), long, (ground + 0.4, ground + 0.41))
    bodies: list[tuple[list[Box], str]] = [
        ([front.box(edges, long, (ground - 0.1, ground + 0.4))], "concrete_panels"),
        ([front.box(bed, long, (ground - 0.1, ground + 0.12))], "roof_gravel"),
        (sleepers, "dark_wood"),
        ([*rails, *posts], "brushed_steel"),
        ([roof], "metal_panels"),
        ([stop], "sign_red"),
        ([line], "signal_white"),
    ]
    return Node(name, name, "site"), [boxes_surface(boxes, named(material)) for boxes, material in bodies]
