"""The files of an asset in a library: mesh, pieces, picture and record, written in this order."""

import hashlib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

import msgspec
import numpy as np

from mansion_assets.catalogue.records import AssetRecord
from mansion_assets.glb_meshes import BODY, GLTF_AXES, PieceRecord
from mansion_assets.library.preparing import Prepared, material_name
from mansion_assets.library.source_model import SourceModel, SourceSurface
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.files import write_atomic

if TYPE_CHECKING:
    from trimesh import Trimesh

__all__ = ["Drawer", "asset_files", "content_hash", "library_glb", "write_asset"]

Drawer: TypeAlias = Callable[[Sequence[SourceSurface]], bytes]
"""Makes the picture of an asset, a PNG, from its surfaces."""


def library_glb(model: SourceModel) -> bytes:
    """Return a model as a GLB whose nodes are called ``PART/NUMBER``; ``body`` is the part that does not move."""
    import trimesh

    scene = trimesh.Scene()
    for part in model.parts:
        for number, surface in enumerate(part.surfaces, start=1):
            name = f"{part.name or BODY}/{number}"
            scene.add_geometry(_geometry(surface), node_name=name, geom_name=name)
    return bytes(scene.export(file_type="glb"))


def _geometry(surface: SourceSurface) -> "Trimesh":
    from trimesh import Trimesh
    from trimesh.visual import TextureVisuals
    from trimesh.visual.material import PBRMaterial

    look = surface.look
    factor = [*(_linear(value / 255.0) for value in look.color), look.opacity]
    material = PBRMaterial(
        name=material_name(surface),
        baseColorFactor=np.round(np.array(factor) * 255.0).astype(np.uint8),
        metallicFactor=look.metallic,
        roughnessFactor=look.roughness,
        alphaMode="BLEND" if look.opacity < 1.0 else "OPAQUE",
    )
    visual = TextureVisuals(material=material)
    return Trimesh(surface.vertices @ GLTF_AXES, surface.faces, visual=visual, process=False)


def _linear(value: float) -> float:
    return value / 12.92 if value <= 0.04045 else float(((value + 0.055) / 1.055) ** 2.4)


def content_hash(glb: bytes, pieces: bytes) -> str:
    """Return the SHA-256 of what an asset looks like and collides with."""
    return hashlib.sha256(glb + pieces).hexdigest()


def asset_files(asset: Prepared, key: str) -> tuple[AssetRecord, dict[str, bytes]]:
    """Return the record of an asset under a key, and its mesh and pieces by the names of their files."""
    names = f"{key}.glb", f"{key}.pieces.json"
    glb, pieces = library_glb(asset.model), _encoded(asset.pieces)
    record = msgspec.structs.replace(
        asset.record, key=key, glb=names[0], pieces=names[1], sha256=content_hash(glb, pieces)
    )
    return record, dict(zip(names, (glb, pieces), strict=True))


def _encoded(pieces: Sequence[PieceRecord]) -> bytes:
    return msgspec.json.encode(list(pieces)) + b"\n"


def write_asset(folder: Path, asset: Prepared, key: str, draw: Drawer) -> AssetRecord:
    """Write an asset into a library, and return its record.

    Raises
    ------
    OSError
        When the folder cannot be written; a reader then finds the asset as it was before, or not at all.
    """
    record, files = asset_files(asset, key)
    files[f"{key}.png"] = draw([surface for part in asset.model.parts for surface in part.surfaces])
    for name, data in files.items():
        write_atomic(folder / "assets" / name, data)
    write_atomic(folder / "assets" / f"{key}.json", encode_bytes(record, indent=1))
    return record
