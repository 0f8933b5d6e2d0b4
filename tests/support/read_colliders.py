"""The colliders of a building as another program reads them, from USD stages and SDF worlds, in its frame."""

import io
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

CORNERS = np.array([(x, y, z) for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)])
SIDES = np.array(
    [
        (0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4),
        (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5),
    ]
)  # fmt: skip

FLAT = 2e-3
"""Metres by which a corner of a convex piece may lie before one of its faces."""


@dataclass(frozen=True)
class Collider:
    """One shape that collides.

    Attributes
    ----------
    id : str
        Of the element it belongs to.
    triangles : (n, 3, 3) array
        In the building's frame, metres.
    """

    id: str
    triangles: np.ndarray

    def distance(self, points: np.ndarray) -> np.ndarray:
        """Return how far points, (m, 3), are from the shape's surface, (m,)."""
        return np.array([_to_triangles(point, self.triangles) for point in points])


def _to_triangles(point: np.ndarray, triangles: np.ndarray) -> float:
    a, b, c = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    normal = np.cross(b - a, c - a)
    area = np.einsum("ij,ij->i", normal, normal)
    whole = area > 1e-16
    height = np.einsum("ij,ij->i", point - a, normal)
    foot = point - normal * (height / np.maximum(area, 1e-16))[:, None]
    inside = whole.copy()
    for p, q in ((a, b), (b, c), (c, a)):
        inside &= np.einsum("ij,ij->i", np.cross(q - p, foot - p), normal) >= 0.0
    found = [np.abs(height[inside]) / np.sqrt(area[inside])]
    for p, q in ((a, b), (b, c), (c, a)):
        along = np.einsum("ij,ij->i", point - p, q - p) / np.maximum(np.einsum("ij,ij->i", q - p, q - p), 1e-16)
        near = p + np.clip(along, 0.0, 1.0)[:, None] * (q - p)
        found.append(np.linalg.norm(point - near, axis=1))
    return float(min(part.min() for part in found if len(part)))


def usd_colliders(path: Path) -> list[Collider]:
    """Return what collides in a USD stage, as UsdPhysics says that an engine has to take it."""
    from pxr import Usd, UsdGeom, UsdPhysics

    stage = Usd.Stage.Open(str(path))
    cache = UsdGeom.XformCache()
    found = []
    for prim in Usd.PrimRange(stage.GetPseudoRoot(), Usd.TraverseInstanceProxies()):
        if not prim.HasAPI(UsdPhysics.CollisionAPI):
            continue
        placed = np.array(cache.GetLocalToWorldTransform(prim))
        if prim.IsA(UsdGeom.Cube):
            local = CORNERS * UsdGeom.Cube(prim).GetSizeAttr().Get()
            triangles = local[SIDES]
        else:
            shape = UsdGeom.Mesh(prim)
            points = np.array(shape.GetPointsAttr().Get(), dtype=float)
            faces = np.array(shape.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3)
            approximation = UsdPhysics.MeshCollisionAPI(prim).GetApproximationAttr().Get()
            triangles = _approximated(str(approximation), points, faces)
        world = triangles @ placed[:3, :3] + placed[3, :3]
        found.append(Collider(_usd_owner(prim), world))
    return found


def _usd_owner(prim: object) -> str:
    """Return our id of the nearest ancestor that has one."""
    while prim.GetPath().pathString != "/":
        attribute = prim.GetAttribute("mansion:id")
        if attribute and attribute.Get():
            return str(attribute.Get())
        prim = prim.GetParent()
    return ""


def _approximated(approximation: str, points: np.ndarray, faces: np.ndarray) -> np.ndarray:
    if approximation == "none":
        return points[faces]
    if approximation == "boundingCube":
        low, high = points.min(0), points.max(0)
        return (CORNERS * (high - low) + (low + high) / 2)[SIDES]
    assert approximation == "convexHull", approximation
    assert_convex(points, faces)
    return points[faces]


def assert_convex(points: np.ndarray, faces: np.ndarray) -> None:
    """Check that a mesh is its own convex hull, so that its triangles are where an engine collides."""
    for corner in points[faces]:
        normal = np.cross(corner[1] - corner[0], corner[2] - corner[0])
        length = float(np.linalg.norm(normal))
        if length > 1e-10:
            assert ((points - corner[0]) @ normal / length).max() < FLAT


def sdf_colliders(xml: str, files: Mapping[str, bytes]) -> list[Collider]:
    """Return what collides in a Gazebo world; `files` are its meshes by the name that the world gives them."""
    found = []
    for model in ElementTree.fromstring(xml).findall("world/model"):
        for link in model.findall("link"):
            for collision in link.findall("collision"):
                placed = pose_of(model) @ pose_of(link) @ pose_of(collision)
                for triangles in _geometry(collision.find("geometry"), files):
                    owner = link.get("name") if model.findtext("static") == "true" else model.get("name")
                    found.append(Collider(str(owner), triangles @ placed[:3, :3].T + placed[:3, 3]))
    return found


def _geometry(geometry: ElementTree.Element, files: Mapping[str, bytes]) -> Iterator[np.ndarray]:
    if (size := geometry.findtext("box/size")) is not None:
        yield (CORNERS * np.array([float(value) for value in size.split()]))[SIDES]
    if (uri := geometry.findtext("mesh/uri")) is not None:
        scale = np.array([float(value) for value in (geometry.findtext("mesh/scale") or "1 1 1").split()])
        triangles = _stl(files[uri]) * scale
        flat = triangles.reshape(-1, 3)
        assert_convex(flat, np.arange(len(flat)).reshape(-1, 3))
        yield triangles


def _stl(data: bytes) -> np.ndarray:
    stream = io.BytesIO(data)
    stream.seek(80)
    count = int.from_bytes(stream.read(4), "little")
    record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    return np.frombuffer(stream.read(), dtype=record, count=count)["corners"].astype(float)


def pose_of(element: ElementTree.Element) -> np.ndarray:
    x, y, z, roll, pitch, yaw = (float(value) for value in (element.findtext("pose") or "0 0 0 0 0 0").split())
    turn = np.eye(3)
    for angle, (i, j) in ((roll, (1, 2)), (pitch, (2, 0)), (yaw, (0, 1))):
        step = np.eye(3)
        c, s = np.cos(angle), np.sin(angle)
        step[i, i], step[i, j], step[j, i], step[j, j] = c, -s, s, c
        turn = step @ turn
    placed = np.eye(4)
    placed[:3, :3], placed[:3, 3] = turn, (x, y, z)
    return placed
