"""Parking spaces, and the cars on some of them."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import shapely
from shapely.geometry import box
from shapely.geometry.base import BaseGeometry

from mansion_assets.catalogue import load_catalogue
from mansion_export.meshes.asset_surfaces import asset_surfaces
from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Node, Part, Surface
from mansion_export.meshes.solids import Box, boxes_surface
from mansion_geometry.randomness import item_generator
from mansion_msgs_py.shapes import Point
from mansion_scene.structure.grounds import BAY

__all__ = ["Bay", "bay_lines", "bays", "parked_cars"]

TAKEN: Final = 0.45
"""Share of the places with a car."""


@dataclass(frozen=True)
class Bay:
    """A place to park: its middle, and the direction of its length in degrees from +y."""

    x: float
    y: float
    heading: float

    def beside(self, across: float) -> Point:
        """Return the point so far to the right of its middle, metres."""
        angle = math.radians(self.heading)
        return self.x + across * math.cos(angle), self.y + across * math.sin(angle)


def bays(parking: BaseGeometry) -> list[Bay]:
    """Return the places that lie whole in an area of strips as wide as a place is long."""
    found = []
    for part in shapely.get_parts(parking):
        x0, y0, x1, y1 = part.bounds
        upright = y1 - y0 > x1 - x0
        low, high = (y0, y1) if upright else (x0, x1)
        for k in range(int((high - low) / BAY[0] + 1e-6)):
            at = low + (k + 0.5) * BAY[0]
            x, y = ((x0 + x1) / 2, at) if upright else (at, (y0 + y1) / 2)
            width, length = (BAY[1], BAY[0]) if upright else BAY
            if part.buffer(1e-3).covers(box(x - width / 2, y - length / 2, x + width / 2, y + length / 2)):
                found.append(Bay(x, y, 90.0 if upright else 0.0))
    return found


def bay_lines(parking: BaseGeometry, ground: float) -> Surface:
    """Return white lines between places to park."""
    boxes = []
    for bay in bays(parking):
        for side in (-1, 1):
            x, y = bay.beside(side * BAY[0] / 2)
            boxes.append(Box((x, y, ground + 0.025), (0.1, BAY[1], 0.01), bay.heading))
    return boxes_surface(boxes, named("signal_white"))


def parked_cars(parking: BaseGeometry, seed: int, ground: float, prefix: str) -> Iterator[Part]:
    """Yield cars on some of the places, of several colours; the same for the same seed."""
    generator = item_generator(seed, "parked cars")
    known = load_catalogue()
    cars = known.by_category("garage_car")
    for number, bay in enumerate(bays(parking), 1):
        taken, turned = generator.random() < TAKEN, generator.random() < 0.5
        asset = cars[int(generator.integers(len(cars)))]
        if not taken:
            continue
        node = Node(
            f"{prefix}/car_{number}",
            f"parked:{asset.key}",
            "site",
            (bay.x, bay.y, ground + asset.size[2] / 2),
            bay.heading + 180.0 * turned,
        )
        yield node, asset_surfaces(asset.key, known)
