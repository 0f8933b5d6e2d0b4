"""What MuJoCo models and Gazebo worlds share: an XML document, its binary STL meshes, and how numbers are written."""

import re
import zlib
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mansion_assets.convex import Hull
from mansion_export.meshes.model import Surface

__all__ = ["SimulatorModel", "mesh_file_name", "number_list", "write_stl"]

_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


@dataclass(frozen=True, slots=True)
class SimulatorModel:
    """A document and the meshes that it names.

    Attributes
    ----------
    xml : str
        The document: MJCF or SDFormat.
    meshes : dict of str to bytes
        Binary STL files by name, one for each material of a mesh; the same in both formats.
    """

    xml: str
    meshes: dict[str, bytes]


def write_stl(surface: Surface | Hull) -> bytes:
    """Write a surface as binary STL, z up, metres; degenerate triangles are left out."""
    corners = surface.vertices[surface.faces]
    ax, ay, az = (corners[:, 1] - corners[:, 0]).T
    bx, by, bz = (corners[:, 2] - corners[:, 0]).T
    normals = np.stack([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], axis=1)
    lengths = np.linalg.norm(normals, axis=1)
    keep = lengths > 1e-12
    triangles = np.zeros(int(keep.sum()), dtype=_TRIANGLE)
    triangles["normal"] = normals[keep] / lengths[keep][:, None]
    triangles["corners"] = corners[keep]
    count = len(triangles).to_bytes(4, "little")
    return b"Mansion binary STL".ljust(80) + count + triangles.tobytes()


def mesh_file_name(mesh: str, part: int) -> str:
    """Return a file name for a part of a mesh: readable, and different for different meshes."""
    readable = re.sub(r"[^A-Za-z0-9.]+", "_", mesh).strip("_")[:60]
    return f"{readable}_{zlib.crc32(mesh.encode()):08x}_{part}.stl"


def number_list(values: Sequence[float]) -> str:
    """Write numbers with at most five decimals, separated by spaces."""
    return " ".join(f"{round(float(value), 5) + 0.0:g}" for value in values)
