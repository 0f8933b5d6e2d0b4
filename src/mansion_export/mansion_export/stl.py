"""Binary STL: what physics engines load; one file for each material of a mesh."""

import re
import zlib

import numpy as np

from mansion_export.model import Surface

__all__ = ["file_name", "write_stl"]

TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def write_stl(surface: Surface) -> bytes:
    """Write a surface as binary STL, z up, metres."""
    corners = surface.vertices[surface.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    keep = lengths > 1e-12
    triangles = np.zeros(int(keep.sum()), dtype=TRIANGLE)
    triangles["normal"] = normals[keep] / lengths[keep][:, None]
    triangles["corners"] = corners[keep]
    count = len(triangles).to_bytes(4, "little")
    return b"Mansion binary STL".ljust(80) + count + triangles.tobytes()


def file_name(mesh: str, part: int) -> str:
    """Return a file name for a part of a mesh: readable, and different for different meshes."""
    readable = re.sub(r"[^A-Za-z0-9.]+", "_", mesh).strip("_")[:60]
    return f"{readable}_{zlib.crc32(mesh.encode()):08x}_{part}.stl"
