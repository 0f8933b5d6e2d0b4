"""Check assets for faults: in their meshes, collision pieces, joints, facts and files."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Final, NamedTuple

import numpy as np

from mansion_assets.catalogue.asset import Asset
from mansion_assets.catalogue.loading import load_catalogue
from mansion_assets.catalogue.records import AssetRecord
from mansion_assets.convex import Box, Convex, Hull, volume_of
from mansion_assets.joints import Joint
from mansion_assets.library.asset_files import content_hash
from mansion_assets.meshes import Link, links
from mansion_geometry.compiled import Floats
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.files import read_payload

__all__ = ["AssetFault", "asset_faults", "library_faults"]

_BEYOND: Final = 0.03
"""Share of an asset's longest edge by which pieces may stand out of their part."""

_PASSES: Final = 0.012
"""Metres by which a part may come into another on its way, beyond what it does when it is closed."""

_THROUGH: Final = 0.3
"""The same as a share of a piece's thinnest side: no point is deeper in a board than half its thickness."""

_STEP: Final = 0.01
"""Metres that a part's farthest point moves between two positions that are looked at, within bounds of their number."""

_POSITIONS: Final = (9, 65)
_MOST_POINTS: Final = 600

_UNIT: Final = 1e-3

_SIZES: Final = (0.001, 30.0)
"""Least and longest edge of what is found in a building, metres."""


class AssetFault(NamedTuple):
    """What is wrong with an asset."""

    asset: str
    message: str

    def __str__(self) -> str:
        return f"{self.asset}: {self.message}"


def library_faults(folder: Path) -> Iterator[AssetFault]:
    """Yield what is wrong with each asset of a library."""
    for file in sorted((folder / "assets").glob("*.json")):
        if file.name.endswith(".pieces.json"):
            continue
        try:
            record = read_payload(AssetRecord, file)
            yield from (AssetFault(record.key, text) for text in _file_faults(file, record))
        except MansionError as error:
            yield AssetFault(file.name, error.info.message)
    try:
        assets = [asset for asset in load_catalogue([folder]).assets.values() if asset.record]
    except MansionError as error:
        yield AssetFault(folder.name, f"cannot be read by a catalogue: {error.info.message}")
        return
    for asset in assets:
        yield from asset_faults(asset)


def _file_faults(file: Path, record: AssetRecord) -> Iterator[str]:
    """Yield facts that are missing, and files that are not as they were when the asset was added."""
    for name in ("source", "licence", "name"):
        if not getattr(record, name):
            yield f"states no {name}"
    if record.glb is None or record.pieces is None:
        return
    named = [file.parent / record.glb, file.parent / record.pieces]
    missing = [path.name for path in named if not path.is_file()]
    if missing:
        yield f"has no file {', '.join(missing)}"
    elif record.sha256 and content_hash(*(path.read_bytes() for path in named)) != record.sha256:
        yield "has a mesh or pieces that have changed since it was added: its sha256 differs"


def asset_faults(asset: Asset) -> list[AssetFault]:
    """Return what is wrong with an asset's mesh, pieces and joints."""
    try:
        rigid = links(asset)
    except MansionError as error:
        return [AssetFault(asset.key, error.info.message)]
    found = [*_fact_faults(asset), *_mesh_faults(asset, rigid), *_piece_faults(asset, rigid)]
    if not found:
        found = list(_joint_faults(asset, rigid))
    return [AssetFault(asset.key, text) for text in found]


def _fact_faults(asset: Asset) -> Iterator[str]:
    if not _SIZES[0] <= min(asset.size) <= max(asset.size) <= _SIZES[1]:
        yield f"is {' x '.join(f'{side:g}' for side in asset.size)} m; edges are {_SIZES[0]:g} to {_SIZES[1]:g} m"
    half = np.array(asset.size) / 2 + _BEYOND * max(asset.size)
    for surface in asset.surfaces:
        reach = np.abs([surface.x, surface.y, surface.z]) + np.array([surface.w, surface.d, 0.0]) / 2
        if (reach > half).any():
            yield f"has a surface ({surface.kind}) that reaches out of its box"
    for volume in asset.volumes:
        reach = np.abs([volume.x, volume.y, volume.z]) + np.array([volume.w, volume.d, volume.h]) / 2
        if (reach > half).any():
            yield f"has a volume ({volume.kind}) that reaches out of its box"


def _mesh_faults(asset: Asset, rigid: Sequence[Link]) -> Iterator[str]:
    for link in rigid:
        where = link.name or "the body"
        if not link.parts and link.joint is not None:
            yield f"has a joint of {where}, but the mesh has no such part"
        for part in link.parts:
            if not np.isfinite(part.vertices).all():
                yield f"has vertices in {where} that are not finite"
            elif len(part.faces) and (part.faces.min() < 0 or part.faces.max() >= len(part.vertices)):
                yield f"has faces in {where} that refer to missing vertices"


def _piece_faults(asset: Asset, rigid: Sequence[Link]) -> Iterator[str]:
    slack = _BEYOND * max(asset.size) + 2e-3
    for link in rigid:
        if not link.parts:
            continue
        where = link.name or "the body"
        points = np.concatenate([part.vertices for part in link.parts])
        low, high = points.min(axis=0) - slack, points.max(axis=0) + slack
        if not link.pieces:
            yield f"has no collision piece for {where}"
        for number, piece in enumerate(link.pieces):
            corners = _corners(piece)
            if not np.isfinite(corners).all() or volume_of(piece) <= 0.0:
                yield f"has a piece of {where} (number {number + 1}) that is not a solid body"
            elif (corners < low).any() or (corners > high).any():
                beyond = float(max((low - corners).max(), (corners - high).max())) + slack
                yield f"has a piece of {where} (number {number + 1}) that protrudes from it by {beyond * 1000:.0f} mm"


def _joint_faults(asset: Asset, rigid: Sequence[Link]) -> Iterator[str]:
    """Yield invalid joints, and parts that pass through others on their way from closed to open."""
    for link in rigid:
        if link.joint is None:
            continue
        if abs(float(np.linalg.norm(link.joint.axis)) - 1.0) > _UNIT:
            yield f"has a joint of {link.name} whose axis is not a unit vector"
            continue
        points = np.concatenate([part.vertices for part in link.parts])
        points = points[:: max(1, len(points) // _MOST_POINTS)]
        for other in rigid:
            if other is not link:
                depth = _deepest(link.joint, points, other.pieces)
                if depth > 0.0:
                    yield f"has {link.name} pass into {other.name or 'the body'} by {depth * 1000:.0f} mm as it opens"


def _deepest(joint: Joint, points: Floats, pieces: Sequence[Convex]) -> float:
    """Return by how much deeper than when it is closed a part comes into pieces on its way, metres; 0 if it may."""
    away = points - np.array(joint.origin)
    reach = (
        joint.travel if joint.kind == "slide" else np.radians(joint.travel) * float(np.linalg.norm(away, axis=1).max())
    )
    positions = np.linspace(0.0, joint.travel, int(np.clip(reach / _STEP, *_POSITIONS)))
    allowed = [min(_PASSES, _THROUGH * float(np.ptp(_corners(piece), axis=0).min())) for piece in pieces]
    # How deep each point lies in each piece, by position.
    depths = np.array([[_depths(piece, _moved(joint, points, at)) for piece in pieces] for at in positions])
    deeper = (depths[1:].max(axis=0) - np.maximum(depths[0].max(axis=0), 0.0)).max(axis=1)
    return float(max((deep for deep, most in zip(deeper.tolist(), allowed, strict=True) if deep > most), default=0.0))


def _moved(joint: Joint, points: Floats, position: float) -> Floats:
    axis = np.array(joint.axis)
    if joint.kind == "slide":
        moved: Floats = points + axis * position
        return moved
    angle, away = np.radians(position), points - np.array(joint.origin)
    turned = (
        away * np.cos(angle) + np.cross(axis, away) * np.sin(angle) + np.outer(away @ axis, axis) * (1 - np.cos(angle))
    )
    return np.asarray(turned + np.array(joint.origin))


def _depths(piece: Convex, points: Floats) -> Floats:
    """Return how deep points lie in a piece, metres; negative outside."""
    if isinstance(piece, Box):
        inside: Floats = (np.array(piece.size) / 2 - np.abs(points - np.array(piece.center))).min(axis=1)
        return inside
    return _hull_depths(piece, points)


def _hull_depths(hull: Hull, points: Floats) -> Floats:
    corners = hull.vertices[hull.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    kept = lengths > 1e-12
    units = normals[kept] / lengths[kept, None]
    offsets = np.einsum("ij,ij->i", units, corners[kept, 0])
    depths: Floats = (offsets - points @ units.T).min(axis=1)
    return depths


def _corners(piece: Convex) -> Floats:
    if isinstance(piece, Hull):
        return piece.vertices
    signs = np.array(np.meshgrid((-0.5, 0.5), (-0.5, 0.5), (-0.5, 0.5))).reshape(3, -1).T
    corners: Floats = np.array(piece.center) + signs * np.array(piece.size)
    return corners
