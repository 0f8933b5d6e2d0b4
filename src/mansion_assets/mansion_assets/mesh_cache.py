"""Meshes and collision pieces that recipes have made, kept in the user's cache: read in a tenth of the time."""

import hashlib
from collections.abc import Callable, Iterator
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable
from typing import Final, NamedTuple

import msgspec
import numpy as np

from mansion_assets.convex import Box, Convex, Hull
from mansion_assets.registry import recipe_named
from mansion_assets.user_cache import cache_folder, kept
from mansion_geometry.compiled import Floats, Ints
from mansion_msgs_py.codec import prepared

__all__ = ["PartArrays", "kept_parts", "kept_pieces"]

VARIABLE: Final = "MANSION_MESH_CACHE"
"""Names the folder; else it is ``mansion/meshes`` of the user's cache."""

_NO_SHAPE: Final = ("library", "retrieval", "__pycache__", "import_thor.py", "mesh_cache.py", "user_cache.py")
"""What of this package has no say in the shape of a mesh."""


class PartArrays(NamedTuple):
    """A part of a mesh with the name of its material, otherwise as `mansion_assets.meshes.MeshPart`."""

    name: str
    material: str
    vertices: Floats
    faces: Ints
    coordinates: Floats


class _Part(msgspec.Struct, frozen=True, array_like=True):
    """A part with its arrays as bytes: float64, int64 and float64."""

    name: str
    material: str
    vertices: bytes
    faces: bytes
    coordinates: bytes


class _Piece(msgspec.Struct, frozen=True, array_like=True):
    """A box by its centre and size, or a hull by its vertices (float64) and faces (int64)."""

    box: tuple[float, float, float, float, float, float] | None
    vertices: bytes = b""
    faces: bytes = b""


class _Parts(msgspec.Struct, frozen=True, array_like=True):
    parts: list[_Part]


class _Pieces(msgspec.Struct, frozen=True, array_like=True):
    pieces: list[_Piece]


def kept_parts(recipe: str, look: bytes, make: Callable[[], list[PartArrays]]) -> list[PartArrays]:
    """Return the parts of the mesh of a look, from the cache or from `make`.

    Parameters
    ----------
    recipe : str
        One that the package does not bring is not kept: nothing tells when its code changes.
    look : bytes
        All of an asset that determines its shape.
    make : callable
    """
    if not _is_own(recipe):
        return make()
    file = cache_folder("meshes", VARIABLE) / _folder() / f"{_name(look)}.mesh"
    found = kept(file, prepared(_Parts), lambda: _Parts([_packed(part) for part in make()]))
    return [_unpacked(part) for part in found.parts]


def kept_pieces(recipe: str, look: bytes, make: Callable[[], tuple[Convex, ...]]) -> tuple[Convex, ...]:
    """Return the collision pieces of a look, from the cache or from `make`; see `kept_parts`."""
    if not _is_own(recipe):
        return make()
    file = cache_folder("meshes", VARIABLE) / _folder() / f"{_name(look)}.pieces"
    found = kept(file, prepared(_Pieces), lambda: _Pieces([_packed_piece(piece) for piece in make()]))
    return tuple(_unpacked_piece(piece) for piece in found.pieces)


def _is_own(recipe: str) -> bool:
    found = recipe_named(recipe)
    return found is not None and found.__module__.startswith("mansion_assets.recipes.")


def _name(look: bytes) -> str:
    return hashlib.sha256(look).hexdigest()[:24]


@cache
def _folder() -> str:
    """Return a hash of the code and data that shapes are made by, and of the library that computes them."""
    digest = hashlib.sha256(np.__version__.encode())
    for entry in _sources(files("mansion_assets")):
        digest.update(entry.name.encode() + b"\0" + entry.read_bytes())
    return digest.hexdigest()[:16]


def _sources(folder: Traversable) -> Iterator[Traversable]:
    for entry in sorted(folder.iterdir(), key=lambda each: each.name):
        if entry.name in _NO_SHAPE:
            continue
        if entry.is_dir():
            yield from _sources(entry)
        elif entry.name.endswith((".py", ".toml")):
            yield entry


def _packed(part: PartArrays) -> _Part:
    return _Part(part.name, part.material, _bytes(part.vertices), _whole(part.faces), _bytes(part.coordinates))


def _unpacked(part: _Part) -> PartArrays:
    return PartArrays(
        part.name,
        part.material,
        _floats(part.vertices).reshape(-1, 3),
        _ints(part.faces).reshape(-1, 3),
        _floats(part.coordinates).reshape(-1, 3, 2),
    )


def _packed_piece(piece: Convex) -> _Piece:
    if isinstance(piece, Box):
        return _Piece((*piece.center, *piece.size))
    return _Piece(None, _bytes(piece.vertices), _whole(piece.faces))


def _unpacked_piece(piece: _Piece) -> Convex:
    if piece.box is not None:
        x, y, z, w, d, h = piece.box
        return Box((x, y, z), (w, d, h))
    return Hull(_floats(piece.vertices).reshape(-1, 3), _ints(piece.faces).reshape(-1, 3))


def _bytes(values: Floats) -> bytes:
    return np.ascontiguousarray(values, dtype=np.float64).tobytes()


def _whole(values: Ints) -> bytes:
    return np.ascontiguousarray(values, dtype=np.int64).tobytes()


def _floats(data: bytes) -> Floats:
    # A copy, since compiled kernels take arrays that can be written.
    return np.frombuffer(data, dtype=np.float64).copy()


def _ints(data: bytes) -> Ints:
    return np.frombuffer(data, dtype=np.int64).copy()
