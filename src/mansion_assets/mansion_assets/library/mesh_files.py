"""Models from GLB, glTF, OBJ, STL, PLY and DAE files."""

import json
import os
from pathlib import Path
from typing import Any, Final, Literal, TypeAlias
from urllib.parse import unquote

import numpy as np

from mansion_assets.library.source_model import SourceModel, SourcePart, SourceSurface
from mansion_assets.library.surface_colours import surfaces_of
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["MODELS", "Up", "file_within", "read_model", "read_surfaces", "refused"]

Up: TypeAlias = Literal["y", "z"]

MODELS: Final = (".glb", ".gltf", ".obj")
"""Endings of files that are models by themselves."""

_MESHES: Final = (*MODELS, ".stl", ".ply", ".dae")
_GLTF: Final = (".glb", ".gltf")

_LARGEST: Final = 512 * 1024 * 1024
"""Bytes of the largest file that is read."""

_TURNS: Final = {"y": np.array([[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]]), "z": np.eye(3)}
"""From a file's axes to ours, z up; of a file with y up the front is taken to face +z, as glTF has it."""


def read_model(path: Path, up: Up = "y") -> SourceModel:
    """Return the model that a file holds; its front is where the file's convention has it.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a file that is not there, ``INVALID_PAYLOAD`` for one that cannot be read, has no triangle, or
        names files outside its folder.
    """
    turn = _TURNS[up]
    surfaces = [surface._replace(vertices=surface.vertices @ turn.T) for surface in read_surfaces(path, path.parent)]
    front = "glTF's convention: +z" if path.suffix.lower() in _GLTF else ""
    return SourceModel(path.stem, (SourcePart("", tuple(surfaces)),), front=front if up == "y" else "")


def read_surfaces(path: Path, root: Path) -> list[SourceSurface]:
    """Return the triangles of a mesh file in its own axes; what it names beside itself lies below `root`.

    Raises
    ------
    MansionError
        As `read_model`.
    """
    import trimesh

    kind = path.suffix.lower()
    if kind not in _MESHES:
        raise refused(path, f"cannot be read; models are {', '.join(_MESHES)} and .urdf")
    try:
        data = path.read_bytes() if path.stat().st_size <= _LARGEST else None
    except OSError as error:
        raise MansionError(ErrorCode.NOT_FOUND, f"{path}: {error.strerror or error}") from None
    if data is None:
        raise refused(path, f"is larger than {_LARGEST >> 20} MB")
    _check_named_files(path, kind, data, root)
    try:
        # Left as it is, so that vertices that are not finite are found and reported.
        scene = trimesh.load(path, force="scene", process=False)
        meshes = [mesh for mesh in scene.dump() if isinstance(mesh, trimesh.Trimesh) and len(mesh.faces)]
    except Exception as error:
        # Readers of meshes fail in any of many ways at damaged files.
        raise refused(path, f"cannot be read: {type(error).__name__}: {error}") from None
    if not meshes:
        raise refused(path, "is empty: it has no triangle")
    return [surface for mesh in meshes for surface in surfaces_of(mesh, linear=kind in _GLTF)]


def file_within(root: Path, folder: Path, name: str) -> Path:
    """Return the file that another one names, relative to its folder.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for one outside `root`, ``NOT_FOUND`` for one that is not there.
    """
    path = folder / name
    inside = Path(os.path.normpath(path.absolute())).is_relative_to(Path(os.path.normpath(root.absolute())))
    if not inside or not path.resolve().is_relative_to(root.resolve()):
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, f"it refers to {name[:200]!r}, which is outside {root}; put it below that folder"
        )
    if not path.is_file():
        raise MansionError(ErrorCode.NOT_FOUND, f"it refers to {name[:200]!r}, which is not there")
    return path


def _check_named_files(path: Path, kind: str, data: bytes, root: Path) -> None:
    """Refuse a file that names others outside the folder; pictures that are missing cost its colours alone."""
    try:
        if kind in _GLTF:
            document = json.loads(data if kind == ".gltf" else _json_chunk(data))
            entries: list[Any] = [*document.get("buffers", []), *document.get("images", [])]
            uris = [entry["uri"] for entry in entries if isinstance(entry, dict) and "uri" in entry]
            for uri in uris:
                if isinstance(uri, str) and not uri.startswith("data:"):
                    file_within(root, path.parent, unquote(uri))
        elif kind == ".obj":
            for name in _named_by(data, (b"mtllib",)):
                _refuse_outside(root, path.parent, name)
                library = path.parent / name
                pictures = (b"map_Kd", b"map_Ka", b"map_Ks", b"map_d")
                for picture in _named_by(library.read_bytes(), pictures) if library.is_file() else ():
                    _refuse_outside(root, library.parent, picture)
    except MansionError as error:
        raise error.with_message(f"{path.name}: {error.info.message}") from None
    except (ValueError, KeyError, TypeError, AttributeError, IndexError) as error:
        raise refused(path, f"cannot be read: {error}") from None


def _refuse_outside(root: Path, folder: Path, name: str) -> None:
    try:
        file_within(root, folder, name)
    except MansionError as error:
        if error.info.code != ErrorCode.NOT_FOUND:
            raise


def _named_by(data: bytes, keywords: tuple[bytes, ...]) -> list[str]:
    lines = [line.strip().split(None, 1) for line in data.splitlines()]
    named = [line[1].decode(errors="replace") for line in lines if len(line) == 2 and line[0] in keywords]
    # Options such as `-s 1 1 1` stand before a picture's name.
    return [name.split()[-1] if name.startswith("-") else name for name in named]


def _json_chunk(data: bytes) -> bytes:
    if data[:4] != b"glTF":
        raise ValueError("it is not a binary glTF file")
    length = int.from_bytes(data[12:16], "little")
    if data[16:20] != b"JSON" or 20 + length > len(data):
        raise ValueError("its JSON is cut off")
    return data[20 : 20 + length]


def refused(path: Path, why: str) -> MansionError:
    """Return the error of a file that cannot be used as a model; `why` goes on from its name."""
    return MansionError(ErrorCode.INVALID_PAYLOAD, f"{path.name} {why}", details={"file": str(path)})
