"""What lies around a building in its picture: the sky, the ground, and the street before the front."""

import math
from typing import Final

import numpy as np
import numpy.typing as npt
from shapely.geometry import LineString, Polygon, box
from shapely.geometry import Point as Place
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient

from mansion_export.exterior.plants import tree
from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Surface
from mansion_export.meshes.solids import Box, boxes_surface, polygon_surface
from mansion_geometry.rings import polygon_parts
from mansion_msgs_py.shapes import Point

__all__ = ["HORIZON", "ground_surfaces", "sky"]

Singles = npt.NDArray[np.float32]

ZENITH: Final = np.array([0.36, 0.56, 0.83])
HORIZON: Final = (0.86, 0.91, 0.95)
"""Colours of the sky far up and at the horizon."""

WOODS: Final = np.array([0.60, 0.68, 0.62])
"""Colour of the trees at the horizon, with the haze before them."""

_COARSE: Final = 8
"""Pixels of the sky's picture that are computed together: it has no sharp edges."""

_CLOUDS: Final = ((0.12, 0.22, 0.10), (0.33, 0.09, 0.07), (0.55, 0.30, 0.11), (0.78, 0.13, 0.09), (0.95, 0.33, 0.08))
"""Middle, across and down, and half the width of clouds, as shares of the picture's width."""

PAVEMENT: Final = 2.2
ROAD: Final = 6.5
"""Widths of the pavements and the carriageway of the street, metres."""

TREES: Final = 22
"""Places for trees behind a plot."""

REACH: Final = 400.0
"""How far the ground reaches, metres."""

_LOW: Final = -0.12
"""Height of the ground around the plot, metres: a little below the plot's."""


def sky(size: tuple[int, int], horizon: float) -> Singles:
    """Return the picture of a sky with a few clouds, down to woods at the horizon.

    Parameters
    ----------
    size : (width, height)
        Pixels.
    horizon : float
        Its row.

    Returns
    -------
    (height, width, 3) array
    """
    from PIL import Image

    width, height = size
    x = (np.arange(-(-width // _COARSE)) * _COARSE / width)[None]
    y = (np.arange(-(-height // _COARSE)) * _COARSE)[:, None]
    up = np.clip((horizon - y) / (0.75 * width), 0.0, 1.0) ** 0.6
    cover = np.zeros(np.broadcast_shapes(x.shape, y.shape))
    for middle, down, half in _CLOUDS:
        for k in range(7):
            across = middle + half * np.sin(2.4 * k + 9.0 * middle) * 0.7
            above = down * 0.5 - half * 0.10 * np.cos(1.7 * k + 5.0 * middle)
            puff = half * (0.30 + 0.12 * np.sin(3.1 * k))
            cover += 0.24 * np.exp(-(((x - across) / puff) ** 2) - ((y / width - above) / (0.34 * puff)) ** 2)
    cover = np.clip(cover, 0.0, 0.8) * np.clip((horizon - y) / (0.04 * width), 0.0, 1.0)
    blue = np.array(HORIZON) + up[..., None] * (ZENITH - HORIZON)
    picture = blue + cover[..., None] * (np.array([0.985, 0.988, 0.995]) - blue)
    crowns = 1.0 + 0.35 * np.sin(61.0 * x) + 0.25 * np.sin(137.0 * x + 1.0) + 0.15 * np.sin(397.0 * x)
    trees = np.clip((y - horizon) / _COARSE + 0.009 * width / _COARSE * crowns, 0.0, 1.0)
    picture += trees[..., None] * (WOODS - picture)
    coarse = Image.fromarray(np.asarray(np.clip(picture, 0.0, 1.0) * 255.0, dtype=np.uint8))
    whole = coarse.resize((coarse.width * _COARSE, coarse.height * _COARSE), Image.Resampling.BILINEAR)
    return np.asarray(whole, dtype=np.float32)[:height, :width] / np.float32(255.0)


def ground_surfaces(plot: Polygon, eye: Point, toward: Point) -> list[Surface]:
    """Return the ground before the eye without the plot, the street along the plot's south, and trees far behind.

    Parameters
    ----------
    plot : Polygon
        A rectangle.
    eye, toward : Point
        Where the eye is, and the unit vector to it from what it looks at.
    """
    before = LineString([_at(eye, toward, -2.0), _at(eye, toward, -2.0 - 2 * REACH)]).buffer(REACH, cap_style="flat")
    paved, road = _street(plot)
    open_ground = before.difference(plot).difference(paved).difference(road)
    surfaces = [
        surface
        for shape, material in ((open_ground, "lawn"), (paved, "stone_paving"), (road, "asphalt"))
        for surface in _flat(shape.intersection(before).difference(plot), material)
    ]
    return [*surfaces, *_dashes(road, before), *_trees(plot, toward)]


def _trees(plot: Polygon, toward: Point) -> list[Surface]:
    """Return trees in no order behind a plot, as one sees it from a direction."""
    x0, y0, x1, y1 = plot.bounds
    half = math.hypot(x1 - x0, y1 - y0) / 2
    found = []
    for k in range(TREES):
        aside, beyond = 3.0 * half * ((k + 0.5) / TREES - 0.5), half * (1.0 - 0.6 * (k % 2)) + 25.0 * (k * 0.618 % 1.0)
        x = (x0 + x1) / 2 - beyond * toward[0] - aside * toward[1]
        y = (y0 + y1) / 2 - beyond * toward[1] + aside * toward[0]
        if y > y0 + 6.0 and plot.distance(Place(x, y)) > 4.0:
            found += tree(x, y, 6.0 + 3.5 * (k * 0.414 % 1.0), _LOW)
    return found


def _at(place: Point, along: Point, length: float) -> Point:
    return (place[0] + length * along[0], place[1] + length * along[1])


def _street(plot: Polygon) -> tuple[BaseGeometry, BaseGeometry]:
    """Return the pavements and the carriageway along the south of a plot."""
    edge = plot.bounds[1]

    def band(near: float, far: float) -> Polygon:
        return box(-2 * REACH, edge - far, 2 * REACH, edge - near)

    far = PAVEMENT + ROAD
    return band(0.0, PAVEMENT).union(band(far, far + PAVEMENT)), band(PAVEMENT, far)


def _flat(shape: BaseGeometry, material: str) -> list[Surface]:
    top = _LOW - 0.1 * (material == "asphalt")
    return [polygon_surface(orient(part), top - 0.2, top, named(material)) for part in polygon_parts(shape)]


def _dashes(road: BaseGeometry, before: BaseGeometry) -> list[Surface]:
    """Return the broken white line along the middle of a road."""
    _, y0, _, y1 = road.bounds
    y = (y0 + y1) / 2
    boxes = [
        Box((6.0 * k, y, _LOW - 0.095), (3.0, 0.13, 0.01))
        for k in range(-25, 26)
        if before.contains(box(6.0 * k - 2, y - 1, 6.0 * k + 2, y + 1))
    ]
    return [boxes_surface(boxes, named("signal_white"))] if boxes else []
