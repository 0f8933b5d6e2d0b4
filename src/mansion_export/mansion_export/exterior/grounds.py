"""What is set up on the plot around a building: a playground behind a fence, a terrace with tables."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

import numpy as np
import shapely
from shapely.geometry import Polygon, box
from shapely.geometry.base import BaseGeometry

from mansion_assets.catalogue import load_catalogue
from mansion_export.exterior.fronts import front_of
from mansion_export.meshes.asset_surfaces import asset_surfaces
from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Node, Part
from mansion_export.meshes.solids import Box, boxes_surface, polygon_surface, segment_box
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import Point

__all__ = ["Patch", "fence_parts", "patch_of", "patch_parts"]

FENCE: Final = 1.1
"""Height of a fence, metres."""

SLAT: Final = 0.3
"""Between the slats of a fence, metres."""

ASIDE: Final = 7.0
"""From the entrance to the middle of what is set up beside it at best, metres."""

_SURFACING: Final = {"playground": "rubber_floor", "terrace": "timber_deck"}

_Thing = tuple[str, float, float, float, float]
"""Category, place in the patch, heading in degrees, and scale."""

_TABLE: Final[tuple[_Thing, ...]] = (
    ("patio_table", 0.0, 0.0, 0.0, 1.0),
    ("parasol", 0.0, 0.0, 0.0, 1.0),
    ("patio_chair", 0.95, 0.0, 90.0, 1.0),
    ("patio_chair", -0.95, 0.0, -90.0, 1.0),
)

_THINGS: Final[dict[str, tuple[_Thing, ...]]] = {
    "playground": (
        ("sandbox", -2.3, 0.0, 0.0, 1.7),
        ("slide", 0.2, 0.0, 0.0, 1.5),
        ("rocking_horse", 1.6, 0.6, 0.0, 1.1),
        ("picnic_table", 2.6, -0.4, 90.0, 0.8),
    ),
    "terrace": tuple(
        (category, x + middle, y, heading, scale) for middle in (-1.7, 1.7) for category, x, y, heading, scale in _TABLE
    ),
}

_SIZES: Final = {"playground": (7.6, 3.2), "terrace": (6.4, 2.7)}


@dataclass(frozen=True)
class Patch:
    """A rectangle of the plot with a surface of its own.

    Attributes
    ----------
    use : {"playground", "terrace"}
    middle : Point
    turned : bool
        Whether its length lies along y.
    """

    use: str
    middle: Point
    turned: bool

    @property
    def shape(self) -> Polygon:
        """The rectangle, metres."""
        return _rectangle(self.middle, _SIZES[self.use], turned=self.turned)


def _rectangle(middle: Point, size: tuple[float, float], *, turned: bool) -> Polygon:
    w, d = size[::-1] if turned else size
    return box(middle[0] - w / 2, middle[1] - d / 2, middle[0] + w / 2, middle[1] + d / 2)


def patch_of(scene: FloorScene, use: str, free: BaseGeometry) -> Patch | None:
    """Return the patch of a use within free ground nearest beside the entrance; None where it fits nowhere."""
    front = front_of(scene)
    if front is None or free.is_empty:
        return None
    x0, y0, x1, y1 = free.bounds
    targets = [front.at(sign * ASIDE, 2.4) for sign in (1, -1)]
    middles = [(float(x), float(y)) for x in np.arange(x0, x1, 0.5) for y in np.arange(y0, y1, 0.5)]
    middles.sort(key=lambda p: (round(min(math.dist(p, target) for target in targets), 6), p))
    upright = abs(front.along[1]) > abs(front.along[0])
    shapely.prepare(free)
    for middle in middles:
        for turned in (upright, not upright):
            if free.covers(_rectangle(middle, _SIZES[use], turned=turned)):
                return Patch(use, middle, turned)
    return None


def patch_parts(patch: Patch, ground: float, prefix: str) -> Iterator[Part]:
    """Yield a patch and the things on it."""
    name = f"{prefix}/{patch.use}"
    surface = polygon_surface(
        shapely.geometry.polygon.orient(patch.shape), ground - 0.05, ground + 0.03, named(_SURFACING[patch.use])
    )
    yield Node(name, name, "site"), [surface]
    known = load_catalogue()
    for number, (category, x, y, heading, scale) in enumerate(_THINGS[patch.use], 1):
        asset = min(known.by_category(category), key=lambda one: (one.footprint, one.key))
        dx, dy = (-y, x) if patch.turned else (x, y)
        place = (patch.middle[0] + dx, patch.middle[1] + dy, ground + 0.03 + scale * asset.size[2] / 2)
        node = Node(
            f"{name}_{number}",
            f"outdoor:{asset.key}",
            "site",
            place,
            heading + 90.0 * patch.turned,
            (scale, scale, scale),
        )
        yield node, asset_surfaces(asset.key, known)


def fence_parts(edge: Polygon, openings: BaseGeometry, ground: float, prefix: str) -> Iterator[Part]:
    """Yield a fence along the edge of a plot, but for its openings."""
    line = edge.buffer(-0.2, join_style="mitre").exterior.difference(openings)
    segments = [
        (a, b)
        for part in shapely.get_parts(shapely.line_merge(line))
        for a, b in pairwise(part.coords)
        if math.dist(a, b) > SLAT
    ]
    if segments:
        name = f"{prefix}/fence"
        yield Node(name, name, "site"), [boxes_surface(_fence(segments, ground), named("light_wood"))]


def _fence(segments: Sequence[tuple[Point, Point]], ground: float) -> list[Box]:
    """Return two rails along each segment with slats between its ends."""
    boxes = []
    for a, b in segments:
        boxes += [segment_box((a, b), 0.05, 0.09, ground + up) for up in (0.3, 0.85)]
        count = max(1, int(math.dist(a, b) / SLAT))
        heading = math.degrees(math.atan2(b[1] - a[1], b[0] - a[0]))
        for k in range(count + 1):
            share = k / count
            place = (a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), ground + FENCE / 2)
            boxes.append(Box(place, (0.09, 0.08, FENCE), heading))
    return boxes
