"""Meshes of assets that are GLB files: their parts, looks and collision pieces."""

import math
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import msgspec
import numpy as np

from mansion_assets.catalogue.asset import Asset
from mansion_assets.catalogue.palette import PbrMaterial, material
from mansion_assets.convex import Box, Convex, Hull
from mansion_assets.joints import Joint
from mansion_assets.texture_coordinates import box_coordinates
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import read_payload
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.shapes import Size3

if TYPE_CHECKING:
    from trimesh import Trimesh

    from mansion_assets.meshes import MeshPart

__all__ = ["BODY", "GLTF_AXES", "PieceRecord", "glb_joints", "glb_parts", "glb_pieces", "srgb_of_linear"]

BODY = "body"
"""What the part of an asset that does not move is called in files."""

GLTF_AXES = np.array([[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
"""From glTF (y up, front +z) to an asset's frame (z up, front +y): ``points @ GLTF_AXES.T``."""


class PieceRecord(msgspec.Struct, frozen=True, kw_only=True, omit_defaults=True, forbid_unknown_fields=True):
    """A convex piece of an asset: a box by `center` and `size`, or a hull by its `vertices` and `faces`.

    Attributes
    ----------
    part : str
        The part that it belongs to; empty for the body.
    """

    part: str = ""
    center: tuple[float, float, float] | None = None
    size: Size3 | None = None
    vertices: list[tuple[float, float, float]] = []
    faces: list[tuple[int, int, int]] = []

    @property
    def shape(self) -> Convex:
        """The piece as a body that collides."""
        if self.center is not None and self.size is not None:
            return Box(self.center, self.size)
        return Hull(np.array(self.vertices, dtype=np.float64), np.array(self.faces, dtype=np.int64))


class _Read(NamedTuple):
    """What a GLB holds, by the part that it belongs to; the body's name is empty."""

    parts: tuple[tuple[str, "MeshPart"], ...]


def glb_parts(asset: Asset, link: str | None = None) -> list["MeshPart"]:
    """Return the meshes of an asset's GLB, or of one of its parts, fitted to the asset's box.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a file that cannot be read, ``INVALID_PAYLOAD`` for one without a triangle.
    """
    names = frozenset(joint.part for joint in asset.joints)
    read = _read(str(asset.glb), _stamp(Path(str(asset.glb))), asset.size, names, asset.material, asset.key)
    return [part for name, part in read.parts if link is None or name == link]


def glb_joints(asset: Asset) -> tuple[Joint, ...]:
    """Return the joints of an asset's parts."""
    return tuple(Joint(j.part, j.kind, j.axis, j.origin, j.travel) for j in asset.joints)


def glb_pieces(asset: Asset, link: str | None = None) -> tuple[Convex, ...]:
    """Return the convex pieces of an asset, or of one of its parts; the box around all where its record has none.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` or ``INVALID_PAYLOAD`` for a file of pieces that is not there, or none.
    """
    whole = Box((0.0, 0.0, 0.0), asset.size)
    if asset.pieces is None:
        return (whole,) if not link else ()
    path = Path(asset.pieces)
    records = _pieces(str(path), _stamp(path))
    return tuple(record.shape for record in records if link is None or record.part == link)


def _stamp(path: Path) -> tuple[int, int]:
    try:
        status = path.stat()
    except OSError as error:
        raise MansionError(
            ErrorCode.NOT_FOUND, f"{path}: {error.strerror or error}", details={"file": str(path)}
        ) from None
    return status.st_mtime_ns, status.st_size


@lru_cache(maxsize=256)
def _pieces(path: str, stamp: tuple[int, int]) -> tuple[PieceRecord, ...]:
    return tuple(read_payload(list[PieceRecord], Path(path), "convex pieces of an asset"))


@lru_cache(maxsize=256)
def _read(path: str, stamp: tuple[int, int], size: Size3, parts: frozenset[str], main: str, key: str) -> _Read:
    """Read a GLB; `stamp` tells a file from an older one of the same name."""
    with importing:
        from mansion_assets.meshes import MeshPart

    named = _geometries(path, key)
    points = [np.asarray(geometry.vertices, dtype=np.float64) @ GLTF_AXES.T for _, geometry in named]
    low = np.min([p.min(axis=0) for p in points], axis=0)
    high = np.max([p.max(axis=0) for p in points], axis=0)
    scale = np.array(size) / np.maximum(high - low, 1e-6)
    found = []
    for number, ((node, geometry), p) in enumerate(zip(named, points, strict=True)):
        fitted = (p - (low + high) / 2) * scale
        faces = np.asarray(geometry.faces, dtype=np.int64)
        coordinates = box_coordinates(fitted, faces, np.zeros(1, dtype=np.int64), turned=False)
        name = node.partition("/")[0]
        look = _material(geometry, main)
        found.append((name if name in parts else "", MeshPart(f"part_{number + 1}", fitted, faces, look, coordinates)))
    return _Read(tuple(found))


def _geometries(path: str, key: str) -> list[tuple[str, "Trimesh"]]:
    """Return the meshes of a file where its nodes place them, by the nodes' names."""
    import trimesh

    try:
        scene = trimesh.load(path, force="scene")
        named = []
        for node in scene.graph.nodes_geometry:
            pose, name = scene.graph[node]
            geometry = scene.geometry[name]
            if isinstance(geometry, trimesh.Trimesh) and len(geometry.faces):
                geometry = geometry.copy()
                geometry.apply_transform(pose)
                named.append((str(node), geometry))
    except Exception as error:
        # A damaged file makes the reader fail in any of many ways.
        raise MansionError(ErrorCode.NOT_FOUND, f"cannot read the GLB of asset {key!r}: {error}") from None
    if not named:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"the GLB of asset {key!r} has no triangle")
    return named


def _material(geometry: "Trimesh", main: str) -> PbrMaterial:
    source: Any = getattr(geometry.visual, "material", None)
    factor = getattr(source, "baseColorFactor", None)
    if factor is None:
        return material(main or "plastic_grey")
    values = [float(c) / 255.0 if max(factor) > 1 else float(c) for c in factor]
    rgb = [round(255 * srgb_of_linear(c)) for c in values[:3]]
    metallic, roughness = getattr(source, "metallicFactor", None), getattr(source, "roughnessFactor", None)
    return PbrMaterial(
        getattr(source, "name", None) or "glb",
        "#{:02x}{:02x}{:02x}".format(*rgb),
        0.0 if metallic is None else float(metallic),
        0.8 if roughness is None else float(roughness),
        values[3] if len(values) > 3 else 1.0,
    )


def srgb_of_linear(value: float) -> float:
    """Return a share of linear light as sRGB has it (IEC 61966-2-1).

    Examples
    --------
    >>> round(srgb_of_linear(0.5), 3)
    0.735
    """
    return 12.92 * value if value <= 0.0031308 else 1.055 * math.pow(value, 1 / 2.4) - 0.055
