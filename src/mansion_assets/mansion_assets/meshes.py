"""Meshes and collision pieces of assets, in the asset's frame: origin at the box centre, front +y, z up."""

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import msgspec
import numpy as np

from mansion_assets.builder import Body, Builder, Chunk, Piece
from mansion_assets.catalogue import Asset
from mansion_assets.catalogue.palette import PbrMaterial, material
from mansion_assets.convex import Box, Convex, fitted
from mansion_assets.glb_meshes import glb_joints, glb_parts, glb_pieces
from mansion_assets.joints import Joint
from mansion_assets.materials.sets import material_set, set_of
from mansion_assets.mesh_cache import PartArrays, kept_parts, kept_pieces
from mansion_assets.piece_budget import simplified
from mansion_assets.registry import recipe_named
from mansion_assets.texture_coordinates import box_coordinates, fitted_coordinates
from mansion_geometry.compiled import Floats, Ints
from mansion_msgs_py.codec import prepared
from mansion_msgs_py.errors import ErrorCode, MansionError

if TYPE_CHECKING:
    from trimesh import Trimesh

__all__ = ["Link", "MeshPart", "collision_boxes", "collision_pieces", "free_room", "links", "mesh"]

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

    @property
    def asset(self) -> Asset:
        """An asset of this look."""
        return msgspec.msgpack.decode(self.payload, type=prepared(Asset))


def mesh(asset: Asset) -> list[MeshPart]:
    """Return the parts of an asset's mesh; together they fill its bounding box exactly.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown recipe or an unreadable GLB.
    """
    if asset.glb is not None:
        return glb_parts(asset)
    look = _look(asset)
    return _in_materials(kept_parts(asset.recipe, look.payload, lambda: _shown(look)))


def _shown(look: _Look) -> list[PartArrays]:
    """Return what is seen of a look while it is closed."""
    return _parts([(piece, [c for c in piece.chunks if not c.hidden]) for piece in _built(look).pieces])


def _in_materials(parts: Sequence[PartArrays]) -> list[MeshPart]:
    return [MeshPart(p.name, p.vertices, p.faces, material(p.material), p.coordinates) for p in parts]


def _parts(pieces: Sequence[tuple[Piece, Sequence[Chunk]]]) -> list[PartArrays]:
    found = []
    for piece, chunks in pieces:
        if chunks:
            starts = np.cumsum([0] + [len(chunk.vertices) for chunk in chunks[:-1]])
            vertices = np.concatenate([chunk.vertices for chunk in chunks])
            faces = np.concatenate([chunk.faces + start for chunk, start in zip(chunks, starts)])
            bodies = np.cumsum([0] + [len(chunk.faces) for chunk in chunks[:-1]])
            coordinates = _coordinates(piece.material, vertices, faces, bodies)
            found.append(PartArrays(piece.part, piece.material, vertices, faces, coordinates))
    return found


def _coordinates(name: str, vertices: Floats, faces: Ints, bodies: Ints) -> Floats:
    """Return where faces lie on the textures of a material; `bodies` are the first faces of boards, legs, cushions."""
    texture = set_of(name)
    if texture and material_set(texture).fitted:
        return fitted_coordinates(vertices, faces, bodies)
    return box_coordinates(vertices, faces, bodies, turned=True)


def collision_boxes(asset: Asset) -> list[Box]:
    """Return the collision boxes of an asset, at most 24; its bounding box where it has no recipe."""
    if asset.glb is not None or not asset.recipe:
        return [Box((0.0, 0.0, 0.0), asset.size)]
    return list(_built(_look(asset)).boxes)


def collision_pieces(asset: Asset) -> tuple[Convex, ...]:
    """Return the convex pieces of an asset whose parts do not move, at most the budget of its size.

    Those of its record where it is a GLB, its bounding box where that has none.
    """
    if asset.glb is not None:
        return glb_pieces(asset)
    if not asset.recipe:
        return (Box((0.0, 0.0, 0.0), asset.size),)
    return _closed_pieces(_look(asset))


@lru_cache(maxsize=256)
def _closed_pieces(look: _Look) -> tuple[Convex, ...]:
    return kept_pieces(look.asset.recipe, look.payload, lambda: _simplified(look))


def _simplified(look: _Look) -> tuple[Convex, ...]:
    asset = look.asset
    bodies = [body.shape for body in _built(look).bodies if not body.hidden]
    return tuple(simplified(bodies, asset.size, free_room(asset)))


class Link(NamedTuple):
    """A rigid part of an asset: triangles, collision bodies, and how it moves; the body has no joint."""

    name: str
    parts: tuple[MeshPart, ...]
    pieces: tuple[Convex, ...]
    joint: Joint | None


def links(asset: Asset) -> tuple[Link, ...]:
    """Return the rigid parts of an asset, closed, its body first; one part where nothing moves."""
    if asset.glb is not None and asset.joints:
        moving = (None, *glb_joints(asset))
        names = ["" if joint is None else joint.part for joint in moving]
        return tuple(
            Link(name, tuple(glb_parts(asset, name)), glb_pieces(asset, name), joint)
            for name, joint in zip(names, moving, strict=True)
        )
    if asset.glb is not None or not asset.recipe:
        return (Link("", tuple(mesh(asset)), collision_pieces(asset), None),)
    return _linked(_look(asset))


@lru_cache(maxsize=256)
def _linked(look: _Look) -> tuple[Link, ...]:
    asset, built = look.asset, _built(look)
    if not built.joints:
        return (Link("", tuple(mesh(asset)), _closed_pieces(look), None),)
    room = free_room(asset)
    found = []
    for joint in (None, *built.joints):
        name = "" if joint is None else joint.part
        parts = _in_materials(_parts([(piece, [c for c in piece.chunks if c.link == name]) for piece in built.pieces]))
        bodies = [body.shape for body in built.bodies if body.link == name]
        found.append(Link(name, tuple(parts), tuple(simplified(bodies, asset.size, room)), joint))
    return tuple(found)


def free_room(asset: Asset) -> list[Box]:
    """Return the room on and in an asset that objects take, as boxes."""
    above = [Box((s.x, s.y, s.z + s.clearance / 2), (s.w, s.d, s.clearance)) for s in asset.surfaces]
    return [*above, *(Box((v.x, v.y, v.z), (v.w, v.d, v.h)) for v in asset.volumes)]


def _look(asset: Asset) -> _Look:
    plain = msgspec.structs.replace(
        asset, key="", category="", name="", synonyms=(), rooms=(), tags=(), asset_id=None, thor_type=""
    )
    return _Look(msgspec.msgpack.encode(plain))


class _Built(NamedTuple):
    """What a recipe has made, in the asset's frame."""

    pieces: tuple[Piece, ...]
    boxes: tuple[Box, ...]
    bodies: tuple[Body, ...]
    joints: tuple[Joint, ...]


@lru_cache(maxsize=640)  # a hotel of seven storeys has 603; each takes some 26 kB
def _built(look: _Look) -> _Built:
    asset = look.asset
    make = recipe_named(asset.recipe)
    if make is None:
        raise MansionError(ErrorCode.NOT_FOUND, f"no mesh recipe {asset.recipe!r}")
    builder = Builder(asset)
    make(builder)
    chunks = [chunk for piece in builder.pieces.values() for chunk in piece.chunks if not chunk.hidden]
    low = np.min([chunk.vertices.min(axis=0) for chunk in chunks], axis=0)
    high = np.max([chunk.vertices.max(axis=0) for chunk in chunks], axis=0)
    size = np.array(asset.size)
    scale = size / np.maximum(high - low, 1e-6)
    center = (low + high) / 2
    boxes = [
        Box(_vec((np.array(b.center) - center) * scale), _vec(np.array(b.size) * scale)) for b in _fewer(builder.boxes)
    ]
    return _Built(
        tuple(piece.fitted(center, scale) for piece in builder.pieces.values()),
        tuple(boxes) or (Box((0.0, 0.0, 0.0), asset.size),),
        tuple(body._replace(shape=fitted(body.shape, center, scale)) for body in builder.bodies),
        tuple(joint.fitted(center, scale) for joint in builder.joints),
    )


def _vec(values: Floats) -> tuple[float, float, float]:
    return (round(float(values[0]), 5), round(float(values[1]), 5), round(float(values[2]), 5))


def _fewer(boxes: list[Box]) -> list[Box]:
    """Keep the largest boxes."""
    if len(boxes) <= _MOST_BOXES:
        return boxes
    order = sorted(range(len(boxes)), key=lambda i: -float(np.prod(boxes[i].size)))[:_MOST_BOXES]
    return [boxes[i] for i in sorted(order)]
