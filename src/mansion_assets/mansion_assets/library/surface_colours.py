"""The colours of a mesh's faces: those of its materials, textures and vertices, reduced to a few."""

from typing import TYPE_CHECKING, Any, Final

import numpy as np
import numpy.typing as npt

from mansion_assets.glb_meshes import srgb_of_linear
from mansion_assets.library.source_model import Look, SourceSurface

if TYPE_CHECKING:
    from trimesh import Trimesh

__all__ = ["surfaces_of"]

MOST_COLOURS: Final = 12
"""Colours of one texture, or of coloured vertices, that are kept: every format shows plain colours."""

_GREY: Final = (168, 163, 155)


def surfaces_of(mesh: "Trimesh", *, linear: bool) -> list[SourceSurface]:
    """Return the triangles of a mesh by their looks.

    Parameters
    ----------
    mesh : Trimesh
    linear : bool
        Whether factors of materials and colours of vertices are linear light, as in glTF, or sRGB.
    """
    vertices, faces = np.asarray(mesh.vertices, dtype=np.float64), np.asarray(mesh.faces, dtype=np.int64)
    source: Any = getattr(mesh.visual, "material", None)
    factor = _factor(source, linear)
    name = str(getattr(source, "name", None) or "")
    rest = (factor[3] / 255.0, _number(source, "metallicFactor", 0.0), _number(source, "roughnessFactor", 0.8), name)
    each = _face_colours(mesh, source, factor, linear)
    if each is None:
        return [SourceSurface(vertices, faces, Look(_rgb(factor), *rest))]
    few, which = _few(each)
    return [
        _part_of(vertices, faces[which == number], Look(_rgb(colour), *rest))
        for number, colour in enumerate(few)
        if (which == number).any()
    ]


def _number(source: Any, field: str, default: float) -> float:
    value = getattr(source, field, None)
    return default if value is None else min(1.0, max(0.0, float(value)))


def _rgb(values: npt.NDArray[np.float64]) -> tuple[int, int, int]:
    return round(float(values[0])), round(float(values[1])), round(float(values[2]))


def _factor(source: Any, linear: bool) -> npt.NDArray[np.float64]:
    """Return the colour of a material as sRGB and opacity, 0 to 255."""
    value = getattr(source, "baseColorFactor", None)
    if value is None and hasattr(source, "diffuse"):
        value, linear = source.diffuse, False
    if value is None:
        textured = getattr(source, "baseColorTexture", None) is not None
        return np.array([255.0, 255.0, 255.0, 255.0] if textured else [*_GREY, 255.0])
    values = np.asarray(value, dtype=np.float64).reshape(-1)
    values = values * 255.0 if values.max(initial=0.0) <= 1.0 and np.asarray(value).dtype.kind == "f" else values
    values = np.append(values[:4], 255.0)[:4]
    return _encoded(values) if linear else values


def _encoded(values: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    return np.array([*(255 * srgb_of_linear(float(v) / 255) for v in values[:3]), values[3]])


def _face_colours(
    mesh: "Trimesh", source: Any, factor: npt.NDArray[np.float64], linear: bool
) -> npt.NDArray[np.float64] | None:
    """Return the colour of each face, (m, 3), where a texture or the vertices say it."""
    kind = getattr(mesh.visual, "kind", None)
    if kind in ("vertex", "face"):
        colours = np.asarray(mesh.visual.face_colors, dtype=np.float64)
        return np.array([_encoded(row)[:3] for row in colours]) if linear else colours[:, :3]
    image = getattr(source, "baseColorTexture", None) or getattr(source, "image", None)
    places = getattr(mesh.visual, "uv", None)
    if image is None or places is None or len(places) != len(mesh.vertices):
        return None
    pixels = np.asarray(image.convert("RGB"), dtype=np.float64)
    where = np.nan_to_num(np.asarray(places, dtype=np.float64)[np.asarray(mesh.faces)].mean(axis=1)) % 1.0
    rows = np.clip(((1.0 - where[:, 1]) * pixels.shape[0]).astype(int), 0, pixels.shape[0] - 1)
    columns = np.clip((where[:, 0] * pixels.shape[1]).astype(int), 0, pixels.shape[1] - 1)
    tinted: npt.NDArray[np.float64] = pixels[rows, columns] * factor[:3] / 255.0
    return tinted


def _few(colours: npt.NDArray[np.float64]) -> tuple[list[npt.NDArray[np.float64]], npt.NDArray[np.int64]]:
    """Return a few colours, and which of them each face has."""
    from PIL import Image

    whole = np.clip(np.round(colours), 0, 255).astype(np.uint8)
    distinct, which = np.unique(whole, axis=0, return_inverse=True)
    if len(distinct) <= MOST_COLOURS:
        return [row.astype(np.float64) for row in distinct], which.reshape(-1)
    picture = Image.fromarray(whole.reshape(1, -1, 3)).quantize(
        MOST_COLOURS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE
    )
    palette = np.array(picture.getpalette(), dtype=np.float64).reshape(-1, 3)
    chosen = np.asarray(picture, dtype=np.int64).reshape(-1)
    return list(palette), chosen


def _part_of(vertices: npt.NDArray[np.float64], faces: npt.NDArray[np.int64], look: Look) -> SourceSurface:
    used, compact = np.unique(faces, return_inverse=True)
    return SourceSurface(vertices[used], compact.reshape(-1, 3).astype(np.int64), look)
