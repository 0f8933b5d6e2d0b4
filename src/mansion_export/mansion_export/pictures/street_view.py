"""A building as seen from across the street, its panes mirroring the sky."""

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final

import numpy as np
from shapely.geometry import box

from mansion_assets.materials import set_of
from mansion_export.exterior.fronts import front_of
from mansion_export.meshes.model import Model, Node
from mansion_export.meshes.solids import SIDES
from mansion_export.pictures.backdrop import HORIZON, ground_surfaces, sky
from mansion_export.pictures.projecting import bounds, seen_from, turned
from mansion_export.pictures.renderer import Camera, Triangles, flatten, photograph
from mansion_export.pictures.texture_sampling import texture_number
from mansion_geometry.compiled import Floats
from mansion_knowledge import is_class
from mansion_msgs_py.scene import FloorScene

if TYPE_CHECKING:
    from PIL.Image import Image

__all__ = ["StreetView", "mirroring"]

FOCAL: Final = 1.45
"""Focal length as a share of the picture's width: about 38 degrees across."""

ASIDE: Final = 32.0
"""How far from straight before the front the eye stands, degrees."""

ACROSS, TALL = 0.8, 0.66
"""Shares of the picture that a building fills at most."""

EYE: Final = 0.11
"""Height of the eye as a share of its distance."""

CLEAR: Final = 900.0
"""How far away things are faded by 63%, metres."""

_GROUND: Final = ("/plot/lawn", "/plot/path", "/plot/parking", "/plot/apron")
"""Ends of the names of what a plot consists of."""

SHAPES: Final = (0.36, 0.56)
"""The lowest and the tallest picture, as shares of the width."""

TONES: Final = np.array([(0.94, 0.97, 1.0), (0.8, 0.85, 0.9), (0.86, 0.88, 0.88), (0.7, 0.76, 0.82), (1.0, 1.0, 0.98)])
"""What the sky in a pane is multiplied with: rooms behind are bright or dark, curtains open or drawn."""


class StreetView:
    """What is seen of a building from the street.

    Parameters
    ----------
    models : sequence of Model
        Models of all floors, lowest first.
    scenes : sequence of FloorScene
        Scenes of the same floors.
    """

    def __init__(self, models: Sequence[Model], scenes: Sequence[FloorScene]) -> None:
        turns = _turns_to_the_sun(scenes)
        self._building = _shown(models, scenes, turns, site=False)
        self._site = _shown(models, scenes, turns, site=True)
        low, high = bounds(self._building.corners)
        self._middle = (low + high) / 2
        self._ends = np.array(
            [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
        )
        ground = np.concatenate([turned(flatten(model, _is_ground).corners, turns) for model in models])
        whole = bounds(ground) if len(ground) else np.stack([low, high])
        self._plot = box(*whole[0, :2], *whole[1, :2])

    def height(self, width: int) -> int:
        """Return how tall a picture of a width shows the building well, pixels."""
        across, tall = self._extent(self._camera(width, width))
        return round(width * min(max(ACROSS * tall / across / TALL, SHAPES[0]), SHAPES[1]))

    def draw(self, width: int, height: int) -> "Image":
        """Return the picture."""
        from PIL import Image

        camera = self._camera(width, height)
        toward = (math.cos(math.radians(camera.azimuth)), math.sin(math.radians(camera.azimuth)))
        ground = Triangles.of(ground_surfaces(self._plot, camera.eye[:2], toward))
        background = sky((width, height), camera.center[1])
        seen = Triangles.join([self._building, self._site])
        return Image.fromarray(photograph(seen, camera, background, ground))

    def _camera(self, width: int, height: int) -> Camera:
        """Return the camera that shows the building as large as fits, in the middle."""
        azimuth = ASIDE - 90.0
        toward = np.array([math.cos(math.radians(azimuth)), math.sin(math.radians(azimuth))])
        reach = float(np.hypot(*(self._ends[7] - self._ends[0])[:2])) / 2
        near, far = reach + 4.0, reach + 2000.0
        for _ in range(24):
            middle = math.sqrt(near * far)
            camera = self._at(azimuth, toward, middle, width)
            across, tall = self._extent(camera)
            if across > ACROSS * width or tall > TALL * height:
                near = middle
            else:
                far = middle
        camera = self._at(azimuth, toward, far, width)
        low, high = self._bounds(camera)
        center = (0.5 * width - (low[0] + high[0]) / 2, 0.53 * height - (low[1] + high[1]) / 2)
        return replace(camera, center=center)

    def _at(self, azimuth: float, toward: Floats, distance: float, width: int) -> Camera:
        x, y = self._middle[:2] + distance * toward
        eye = (float(x), float(y), max(EYE * distance, 2.0))
        return Camera(azimuth, eye, FOCAL * width, (0.0, 0.0), HORIZON, CLEAR)

    def _bounds(self, camera: Camera) -> tuple[Floats, Floats]:
        axes = camera.axes()
        ends = self._ends[:, None].repeat(3, axis=1)
        low, high = bounds(seen_from(ends, axes, axes @ np.array(camera.eye), camera.focal, np.array(camera.center)))
        return low, high

    def _extent(self, camera: Camera) -> tuple[float, float]:
        low, high = self._bounds(camera)
        return float(high[0] - low[0]), float(high[1] - low[1])


def _turns_to_the_sun(scenes: Sequence[FloorScene]) -> int:
    """Return by how many quarters to turn a building so that its front faces south, where the sun is in pictures."""
    ground = next((scene for scene in scenes if scene.floor == 1), None)
    front = front_of(ground) if ground is not None else None
    if front is None:
        return 0
    return round((-90.0 - math.degrees(math.atan2(front.out[1], front.out[0]))) / 90.0) % 4


def _shown(models: Sequence[Model], scenes: Sequence[FloorScene], turns: int, *, site: bool) -> Triangles:
    """Return what is seen of a building above the ground with what it shows at its front, or of its plot."""
    parts = []
    buried = all(scene.floor < 1 for scene in scenes)
    for model, scene in zip(models, scenes):
        if scene.floor < 1 and not buried:
            continue
        part = flatten(model, _is_plot) if site else Triangles.join([_shell(model, scene), flatten(model, _is_feature)])
        parts.append(replace(part, corners=part.corners + np.array([0.0, 0.0, model.elevation])))
    whole = Triangles.join(parts)
    return replace(whole, corners=turned(whole.corners, turns))


def _shell(model: Model, scene: FloorScene) -> Triangles:
    """Return a floor's outer walls with what is in them, its roof, and what stands on terraces."""
    terraces = {room.id for room in scene.rooms if is_class(room.room_type, "outdoor")}
    outer = {wall.id for wall in scene.walls if wall.exterior or {wall.left, wall.right} & terraces}
    inner = {wall.id for wall in scene.walls} - outer
    inner |= {door.id for door in scene.doors if None not in door.rooms and not {*door.rooms} & terraces}
    shell = flatten(model, lambda node: _outside(node, inner))
    standing = flatten(model, lambda node: node.group == "objects" and node.room in terraces)
    return Triangles.join([mirroring(shell), standing])


def _is_plot(node: Node) -> bool:
    return node.group == "site" and "/plot/" in node.id


def _is_feature(node: Node) -> bool:
    """Tell whether a node is a canopy, a sign, a tower or another thing that a building shows at its front."""
    return node.group == "site" and "/plot/" not in node.id


def _is_ground(node: Node) -> bool:
    return node.id.endswith(_GROUND)


def _outside(node: Node, inner: set[str]) -> bool:
    if node.group in ("structure", "windows", "doors"):
        return node.id not in inner and node.id.removesuffix("/leaf") not in inner
    return node.group == "ceiling" and (node.id.endswith("/roof") or "/chimney_" in node.id)


def mirroring(triangles: Triangles) -> Triangles:
    """Return triangles whose boxes of glass are opaque and show the sky, each pane in a tone of its own."""
    glass = np.flatnonzero((triangles.looks.alpha < 0.99)[triangles.which])
    if not len(glass) or len(glass) % len(SIDES):
        return triangles
    shown = triangles.apart()
    looks = shown.looks
    corners = triangles.corners[glass].reshape(-1, len(SIDES) * 3, 3)
    low, high = corners.min(axis=1), corners.max(axis=1)
    height = np.maximum(high[:, 2] - low[:, 2], 1e-3)[:, None]
    extent = high - low
    turned = (extent[:, 1] > extent[:, 0])[:, None]
    across = np.where(turned, corners[..., 1], corners[..., 0]) / height
    up = (corners[..., 2] - low[:, None, 2]) / height
    # Neighbours differ, and the same building always looks the same.
    numbers = np.round((low + high) @ (3.1, 5.3, 7.7)).astype(np.int64) % len(TONES)
    looks.colors[glass] = np.repeat(TONES[numbers], len(SIDES), axis=0)
    looks.alpha[glass] = 1.0
    looks.textures[glass] = texture_number(set_of("mirroring_glass"))
    looks.coordinates[glass] = np.stack([across, up], axis=-1).reshape(-1, 3, 2)
    return shown
