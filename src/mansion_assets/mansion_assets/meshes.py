"""Meshes and collision boxes of assets, in the asset's frame: origin at the box centre, front +y, z up."""

from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import msgspec
import numpy as np

from mansion_assets.builder import Box, Builder, Piece
from mansion_assets.catalogue import Asset
from mansion_assets.catalogue.palette import PbrMaterial, material
from mansion_assets.materials.sets import material_set, set_of
from mansion_assets.registry import recipe_named
from mansion_assets.texture_coordinates import box_coordinates, fitted_coordinates
from mansion_geometry.compiled import Floats, Ints
from mansion_msgs_py.errors import ErrorCode, MansionError

if TYPE_CHECKING:
    from trimesh import Trimesh

__all__ = ["MeshPart", "collision_boxes", "mesh"]

_MOST_BOXES = 24
"""Most collision boxes of one asset."""


class MeshPart(NamedTuple):
    """One part of an asset in one material: (n, 3) vertices in metres and (m, 3) faces.

    `coordinates`, (m, 3, 2), are those of each face's corners on the material's textures, metres.
    """

    name: str
    vertices: Floats
    faces: Ints
    material: PbrMaterial
    coordinates: Floats

    @property
    def mesh(self) -> "Trimesh":
        """The part as a mesh of trimesh."""
        from trimesh import Trimesh

        return Trimesh(self.vertices, self.faces, process=False)


class _Look(msgspec.Struct, frozen=True):
    """The fields that determine an asset's shape; assets that agree in them share a mesh."""

    payload: bytes


def mesh(asset: Asset) -> list[MeshPart]:
    """Return the parts of an asset's mesh; together they fill its bounding box exactly.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown recipe or an unreadable GLB.
    """
    if asset.glb is not None:
        return _from_glb(asset)
    pieces, _ = _built(_look(asset))
    return [
        MeshPart(part, vertices.copy(), faces.copy(), material(name), coordinates.copy())
        for part, name, vertices, faces, coordinates in pieces
    ]


def collision_boxes(asset: Asset) -> list[Box]:
    """Return the collision boxes of an asset, at most 24; its bounding box where it has no recipe."""
    if asset.glb is not None or not asset.recipe:
        return [Box((0.0, 0.0, 0.0), asset.size)]
    return list(_built(_look(asset))[1])


def _look(asset: Asset) -> _Look:
    plain = msgspec.structs.replace(
        asset, key="", category="", name="", synonyms=(), rooms=(), tags=(), asset_id=None, thor_type=""
    )
    return _Look(msgspec.msgpack.encode(plain))


Pieces = list[tuple[str, str, Floats, Ints, Floats]]


@lru_cache(maxsize=1024)
def _built(look: _Look) -> tuple[Pieces, list[Box]]:
    asset = msgspec.msgpack.decode(look.payload, type=Asset)
    make = recipe_named(asset.recipe)
    if make is None:
        raise MansionError(ErrorCode.NOT_FOUND, f"no mesh recipe {asset.recipe!r}")
    builder = Builder(asset)
    make(builder)
    pieces = [
        (p.part, p.material, np.concatenate(p.vertices), np.concatenate(p.faces), _first_faces(p))
        for p in builder.pieces.values()
    ]
    low = np.min([v.min(axis=0) for _, _, v, _, _ in pieces], axis=0)
    high = np.max([v.max(axis=0) for _, _, v, _, _ in pieces], axis=0)
    size = np.array(asset.size)
    scale = size / np.maximum(high - low, 1e-6)
    center = (low + high) / 2
    fitted = [_placed(part, name, (v - center) * scale, f, bodies) for part, name, v, f, bodies in pieces]
    boxes = [
        Box(_vec((np.array(b.center) - center) * scale), _vec(np.array(b.size) * scale)) for b in _fewer(builder.boxes)
    ]
    return fitted, boxes or [Box((0.0, 0.0, 0.0), asset.size)]


def _first_faces(piece: Piece) -> Ints:
    """Return the number of the first face of each body of a piece."""
    return np.cumsum([0, *(len(faces) for faces in piece.faces[:-1])])


def _placed(part: str, name: str, vertices: Floats, faces: Ints, bodies: Ints) -> tuple[str, str, Floats, Ints, Floats]:
    texture = set_of(name)
    if texture and material_set(texture).fitted:
        return part, name, vertices, faces, fitted_coordinates(vertices, faces, bodies)
    return part, name, vertices, faces, box_coordinates(vertices, faces, bodies, turned=True)


def _vec(values: Floats) -> tuple[float, float, float]:
    return (round(float(values[0]), 5), round(float(values[1]), 5), round(float(values[2]), 5))


def _fewer(boxes: list[Box]) -> list[Box]:
    """Keep the largest boxes."""
    if len(boxes) <= _MOST_BOXES:
        return boxes
    order = sorted(range(len(boxes)), key=lambda i: -float(np.prod(boxes[i].size)))[:_MOST_BOXES]
    return [boxes[i] for i in sorted(order)]


def _from_glb(asset: Asset) -> list[MeshPart]:
    """Read a GLB (y up, front +z) and fit it to the asset's box."""
    import trimesh

    try:
        scene = trimesh.load(asset.glb, force="scene")
        geometries = scene.dump()
    except (OSError, ValueError) as error:
        raise MansionError(ErrorCode.NOT_FOUND, f"cannot read the GLB of asset {asset.key!r}: {error}") from None
    axes = np.array([[-1.0, 0, 0], [0, 0, 1.0], [0, 1.0, 0]])
    points = [np.asarray(g.vertices) @ axes.T for g in geometries]
    low = np.min([p.min(axis=0) for p in points], axis=0)
    high = np.max([p.max(axis=0) for p in points], axis=0)
    scale = np.array(asset.size) / np.maximum(high - low, 1e-6)
    out = []
    for number, (geometry, p) in enumerate(zip(geometries, points, strict=True)):
        fitted = (p - (low + high) / 2) * scale
        faces = np.asarray(geometry.faces, dtype=np.int64)
        coordinates = box_coordinates(fitted, faces, np.zeros(1, dtype=np.int64), turned=False)
        out.append(MeshPart(f"part_{number + 1}", fitted, faces, _glb_material(geometry, asset), coordinates))
    return out


def _glb_material(geometry: "Trimesh", asset: Asset) -> PbrMaterial:
    source = getattr(geometry.visual, "material", None)
    color = getattr(source, "baseColorFactor", None)
    if color is None:
        return material(asset.material or "plastic_grey")
    rgb = [int(c) if max(color) > 1 else round(float(c) * 255) for c in color[:3]]
    return PbrMaterial(
        getattr(source, "name", None) or "glb",
        "#{:02x}{:02x}{:02x}".format(*rgb),
        float(getattr(source, "metallicFactor", None) or 0.0),
        float(getattr(source, "roughnessFactor", None) or 0.8),
    )
