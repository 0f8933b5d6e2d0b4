"""A small software renderer: models flattened to triangles, drawn from above without perspective, or photographed."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields

import numpy as np
import numpy.typing as npt

from mansion_export.meshes.model import Model, Node, Surface
from mansion_export.pictures.projecting import bounds_along, number_seen, rasterise, seen_along, seen_from
from mansion_export.pictures.shading import LIGHT, NO_HAZE, faces_seen, shade_pixels, shadow_map
from mansion_export.pictures.texture_sampling import base_color, texture_number, tiles_at
from mansion_geometry.compiled import Bools, Floats, Ints, kernel

__all__ = ["Camera", "Looks", "Triangles", "View", "flatten", "photograph", "render"]


Singles = npt.NDArray[np.float32]

_BORDER = 4


@dataclass(frozen=True, slots=True)
class Looks:
    """What triangles look like, however often each of them stands in a building.

    Attributes
    ----------
    colors : (m, 3) array
        sRGB from 0 to 1.
    alpha : (m,) array
    textures : (m,) array of int
        Numbers of the sets of textures that the colours tint, see `texture_number`; -1 for none.
    coordinates : (m, 3, 2) array
        Place of the corners on the textures, metres.
    """

    colors: Floats
    alpha: Floats
    textures: Ints
    coordinates: Floats

    def rows(self, which: Bools | Ints) -> "Looks":
        """Return some of the looks."""
        return Looks(*(getattr(self, part.name)[which] for part in fields(self)))

    @staticmethod
    def join(parts: "Sequence[Looks]") -> "Looks":
        """Return several lists of looks, one after the other."""
        return Looks(*(np.concatenate([getattr(part, each.name) for part in parts]) for each in fields(Looks)))


@dataclass(frozen=True, slots=True)
class Triangles:
    """Triangles in world coordinates.

    Attributes
    ----------
    corners : (n, 3, 3) array
    looks : Looks
    which : (n,) array of int
        The row of `looks` that each triangle has; triangles of things that stand there many times share theirs.
    """

    corners: Floats
    looks: Looks
    which: Ints

    def __len__(self) -> int:
        return len(self.which)

    @staticmethod
    def plain(corners: Floats, color: Floats) -> "Triangles":
        """Return opaque triangles of one colour."""
        look = Looks(np.array(color)[None], np.ones(1), np.full(1, -1), np.zeros((1, 3, 2)))
        return Triangles(corners, look, np.zeros(len(corners), dtype=np.int64))

    def where(self, keep: Bools | Ints) -> "Triangles":
        """Return some of the triangles."""
        return Triangles(self.corners[keep], self.looks, self.which[keep])

    def apart(self) -> "Triangles":
        """Return the triangles with a row of looks for each, in their order, which may be changed."""
        return Triangles(self.corners, self.looks.rows(self.which), np.arange(len(self)))

    @staticmethod
    def of(surfaces: Sequence[Surface]) -> "Triangles":
        """Return the triangles of surfaces in their own frame."""
        counts = [len(surface.faces) for surface in surfaces]
        if not counts:
            return Triangles.join([])
        looks = Looks(
            np.repeat([base_color(surface.material) for surface in surfaces], counts, axis=0),
            np.repeat([surface.material.alpha for surface in surfaces], counts),
            np.repeat([texture_number(surface.material.texture) for surface in surfaces], counts),
            np.concatenate([surface.coordinates for surface in surfaces]),
        )
        corners = np.concatenate([surface.vertices[surface.faces] for surface in surfaces])
        return Triangles(corners, looks, np.arange(len(corners)))

    @staticmethod
    def join(parts: "Sequence[Triangles]") -> "Triangles":
        """Return the triangles of several lists, one list after the other."""
        if not parts:
            return Triangles.plain(np.zeros((0, 3, 3)), np.zeros(3))
        starts = np.cumsum([0, *(len(part.looks.alpha) for part in parts)])
        return Triangles(
            np.concatenate([part.corners for part in parts]),
            Looks.join([part.looks for part in parts]),
            np.concatenate([part.which + start for part, start in zip(parts, starts)]),
        )


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
    surfaces = [model.meshes[name].surfaces for name in meshes]
    source = Triangles.of([surface for each in surfaces for surface in each])
    starts = np.cumsum([0, *(sum(len(surface.faces) for surface in each) for each in surfaces)])
    which = np.array([meshes[node.mesh] for node in nodes], dtype=np.int64)
    poses = np.array([(*node.scale, *node.position, np.radians(node.rotation)) for node in nodes]).reshape(-1, 7)
    counts = (starts[1:] - starts[:-1])[which]
    corners = np.empty((int(counts.sum()), 3, 3))
    origin = np.empty(len(corners), dtype=np.int64)
    _place_instances(source.corners, starts, which, poses, corners, origin)
    return Triangles(corners, source.looks, origin)


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


@dataclass(frozen=True, slots=True)
class View:
    """An axonometric view.

    Attributes
    ----------
    azimuth, elevation : float
        Where the eye stands, degrees: azimuth counter-clockwise from +x, elevation above the ground.
    scale : float
        Pixels a metre.
    """

    azimuth: float = -62.0
    elevation: float = 48.0
    scale: float = 40.0

    def axes(self) -> Floats:
        """Return the rows right, up and towards the eye."""
        a, e = np.radians(self.azimuth), np.radians(self.elevation)
        toward = np.array([np.cos(a) * np.cos(e), np.sin(a) * np.cos(e), np.sin(e)])
        right = np.array([-np.sin(a), np.cos(a), 0.0])
        return np.stack([right, np.cross(toward, right), toward])


@dataclass(frozen=True, slots=True)
class Camera:
    """A camera that looks level, as architects photograph: uprights stay parallel.

    Attributes
    ----------
    azimuth : float
        Where the eye stands as seen from what it looks at, degrees counter-clockwise from +x.
    eye : (x, y, z)
    focal : float
        Focal length, pixels.
    center : (x, y)
        Where the optical axis meets the picture, pixels; the horizon runs through it.
    haze : (r, g, b)
        What far things fade to.
    clear : float
        How far away things are faded by 63%, metres.
    """

    azimuth: float
    eye: tuple[float, float, float]
    focal: float
    center: tuple[float, float]
    haze: tuple[float, float, float]
    clear: float

    def axes(self) -> Floats:
        """Return the rows right, up and towards the eye."""
        return View(self.azimuth, 0.0).axes()


def render(
    triangles: Triangles, view: View, background: tuple[float, float, float] = (1.0, 1.0, 1.0)
) -> npt.NDArray[np.uint8]:
    """Draw triangles from an axonometric view.

    Parameters
    ----------
    triangles : Triangles
    view : View
    background : (r, g, b)

    Returns
    -------
    (height, width, 3) array of uint8
        Just large enough for the triangles, first row on top.
    """
    axes = view.axes()
    low, high = bounds_along(triangles.corners, axes)
    scale, border = 2.0 * view.scale, 2 * _BORDER
    samples = seen_along(triangles.corners, axes, (float(low[0]), float(high[1])), scale, float(border))
    width, height = (int(np.ceil(extent * view.scale)) + 2 * _BORDER for extent in (high - low)[:2])
    image = np.empty((height, width, 3), dtype=np.float32)
    image[:] = background
    # Where sample (0, 0) lies in the view's plane.
    left, top = low[0] - (border - 0.5) / scale, high[1] + (border - 0.5) / scale
    frame = (float(left), float(top), 0.0, 0.0, scale, np.inf)
    _draw(triangles, samples, axes, axes[2], frame, triangles.corners, image)
    return _bytes(image)


def photograph(
    triangles: Triangles, camera: Camera, background: Singles, surroundings: Triangles
) -> npt.NDArray[np.uint8]:
    """Draw triangles in perspective.

    Parameters
    ----------
    triangles : Triangles
        All before the eye.
    camera : Camera
    background : (height, width, 3) array
        The picture of what is behind everything, from 0 to 1; drawn over.
    surroundings : Triangles
        What casts no shadow, also before the eye.
    """
    axes = camera.axes()
    both = Triangles.join([triangles, surroundings])
    eye = axes @ np.array(camera.eye)
    focal, center = 2.0 * camera.focal, 2.0 * np.array(camera.center)
    samples = seen_from(both.corners, axes, eye, focal, center)
    frame = (float(eye[0]), float(eye[1]), center[0] - 0.5, center[1] - 0.5, focal, float(eye[2]))
    _draw(both, samples, axes, np.array(camera.eye), frame, triangles.corners, background, (*camera.haze, camera.clear))
    return _bytes(background)


def _draw(
    triangles: Triangles,
    samples: Floats,
    axes: Floats,
    eye: Floats,
    frame: tuple[float, float, float, float, float, float],
    casting: Floats,
    image: Singles,
    haze: tuple[float, float, float, float] = NO_HAZE,
) -> None:
    """Draw triangles over a picture, two by two samples a pixel; `frame` and `haze` as `shade_pixels` has them.

    Parameters
    ----------
    samples : (n, 3, 3) array
        Corners in the picture by samples, the last coordinate towards the eye.
    eye : (3,) array
        Where the eye is, or without perspective the direction towards it.
    casting : (m, 3, 3) array
        Corners of the first triangles, which cast shadows.
    """
    clear = (triangles.looks.alpha <= 0.99)[triangles.which]
    opaque, panes = np.flatnonzero(~clear), np.flatnonzero(clear)
    depth = np.full((2 * image.shape[0], 2 * image.shape[1]), -np.inf, dtype=np.float32)
    index = np.full(depth.shape, -1, dtype=np.int32)
    rasterise(samples, opaque, depth, index)
    glass = np.full(depth.shape if len(panes) else (0, 0), -1, dtype=np.int32)
    if len(panes):
        rasterise(samples, panes, depth.copy(), glass)
    perspective = bool(np.isfinite(frame[5]))
    if perspective:
        np.subtract(np.float32(frame[5]), 1.0 / depth, out=depth, where=index >= 0)
    shadow, corner, cell = shadow_map(casting, opaque[opaque < len(casting)])
    # Of the triangles of a building few are seen: only their looks are gathered.
    seen = number_seen(index, glass, len(triangles))
    looks = triangles.looks.rows(triangles.which[seen])
    tiles = tiles_at(np.unique(looks.textures), _density(frame, depth))
    shade_pixels(
        depth,
        index,
        glass,
        faces_seen(triangles.corners[seen], samples[seen], looks.coordinates, eye, perspective),
        (looks.colors, looks.alpha, looks.textures),
        (tiles.texels, tiles.frames, tiles.sizes),
        shadow,
        (float(corner[0]), float(corner[1]), cell),
        frame,
        axes @ LIGHT.T,
        haze,
        image,
    )


def _density(frame: tuple[float, float, float, float, float, float], depth: Singles) -> float:
    """Return how many pixels a metre has in the middle of what is seen."""
    scale, eye = frame[4] / 2.0, frame[5]
    if not np.isfinite(eye):
        return scale
    seen = depth[::16, ::16]
    return scale / max(eye - float(np.median(seen[np.isfinite(seen)])), 1.0)


def _bytes(image: Singles) -> npt.NDArray[np.uint8]:
    return np.asarray(np.clip(image, 0.0, 1.0) * 255.0 + 0.5, dtype=np.uint8)
