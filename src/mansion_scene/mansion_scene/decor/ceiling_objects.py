"""Ceiling objects: lamps on a grid or above furniture, detectors, sprinklers, vents."""

import math
from collections.abc import Iterator, Sequence

import numpy as np
import shapely
from shapely import Polygon

from mansion_assets.catalogue import Asset, Catalogue, HangRequest
from mansion_geometry.object_footprints import footprint, footprint_at
from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.shapes import Point, Size3
from mansion_scene.decor.frames import Ids, WallEdge, scene_object
from mansion_scene.decor.rugs import matches

__all__ = ["HEADROOM", "CeilingSpace", "ceiling_objects"]

HEADROOM = 2.05
"""Least height of a lamp's lower edge above free floor, metres."""


def ceiling_objects(
    catalogue: Catalogue,
    requests: Sequence[HangRequest],
    room: Polygon,
    edges: Sequence[WallEdge],
    height: float,
    placed: Sequence[SceneObject],
    ids: Ids,
    room_id: str,
    rng: np.random.Generator,
) -> list[SceneObject]:
    """Return the ceiling objects of a room: inside it, clear of each other and of tall objects below."""
    ceiling = CeilingSpace(room, edges, height, placed)
    out: list[SceneObject] = []
    for request in requests:
        asset = _hangable(catalogue, request, height)
        if asset is None:
            continue
        left = 10_000 if request.place == "grid" else request.count
        for center, rotation in ceiling.places(request, asset, rng):
            if left <= 0:
                break
            if not ceiling.reserve(asset.size, center, rotation):
                continue
            left -= 1
            position = (center[0], center[1], height - asset.size[2] / 2)
            out.append(scene_object(asset, ids.new(asset.category), room_id, position, rotation))
    return out


def _hangable(catalogue: Catalogue, request: HangRequest, height: float) -> Asset | None:
    """Return the requested asset, or a flat lamp for one that would hang too low; None where no lamp is flat enough."""
    limit = height - (HEADROOM if request.place != "above" else 1.25)
    if request.asset.size[2] <= limit:
        return request.asset
    flat = [a for a in catalogue.by_category("ceiling_light") if a.size[2] <= limit]
    return flat[0] if flat and request.asset.toggleable else None


class CeilingSpace:
    """The ceiling of a room, what hangs from it and what reaches up to it."""

    def __init__(self, room: Polygon, edges: Sequence[WallEdge], height: float, placed: Sequence[SceneObject]) -> None:
        self.room, self.height, self.placed = room, height, placed
        longest = max(edges, key=lambda e: e.length)
        self.angle = math.degrees(math.atan2(longest.along[1], longest.along[0])) % 180.0
        self.taken: list[tuple[str, tuple[float, float, float, float]]] = [
            (o.id, footprint(o).bounds) for o in placed if o.mount == "ceiling"
        ]
        self.tall = [(o.id, footprint(o), o.top) for o in placed if o.top > 1.4]

    def reserve(self, size: Size3, center: Point, rotation: float) -> bool:
        """Reserve a position if it is free, and tell whether it was."""
        shape = footprint_at(center, size, rotation)
        if not self.room.contains(shape) or self.hindrances(size, center, rotation):
            return False
        self.taken.append(("", shape.bounds))
        return True

    def hindrances(self, size: Size3, center: Point, rotation: float) -> list[str]:
        """Return the objects, by id, that are in the way of one of a size."""
        shape = footprint_at(center, size, rotation)
        x0, y0, x1, y1 = shape.bounds
        low = self.height - size[2] - 0.03
        beside = [
            name
            for name, (a, b, c, d) in self.taken
            if not (x1 + 0.05 < a or c + 0.05 < x0 or y1 + 0.05 < b or d + 0.05 < y0)
        ]
        return beside + [name for name, other, top in self.tall if top > low and shape.intersects(other)]

    def places(self, request: HangRequest, asset: Asset, rng: np.random.Generator) -> Iterator[tuple[Point, float]]:
        """Yield centres and rotations to try, the best first."""
        if request.place == "above":
            for obj in self.placed:
                if matches(obj, request.above):
                    yield (obj.position[0], obj.position[1]), obj.rotation
        elif request.place in ("center", "door", "free", "facing_door", "facing_seats"):
            middle = self.room.centroid
            if not self.room.contains(middle):
                middle = self.room.representative_point()
            yield (middle.x, middle.y), self.angle
            yield from ((p, self.angle) for p in self.lattice(1.2))
        else:
            spacing = request.spacing
            if request.place == "spread":
                spacing = max(1.0, math.sqrt(self.room.area / max(request.count, 1)))
            shift = 0.31 if request.place == "spread" else 0.0
            points = self.lattice(spacing, shift)
            if request.place == "spread":
                points = [points[int(i)] for i in rng.permutation(len(points))]
            yield from ((p, self.angle) for p in points)
            if request.place == "spread" or len(points) < 1:
                inner = self.room.representative_point()
                yield (inner.x, inner.y), self.angle

    def lattice(self, spacing: float, shift: float = 0.0) -> list[Point]:
        """Return points of a regular grid along the longest wall, centred in the room's rectangle."""
        c, s = math.cos(math.radians(self.angle)), math.sin(math.radians(self.angle))
        ring = list(self.room.exterior.coords)
        us = [c * x + s * y for x, y in ring]
        vs = [-s * x + c * y for x, y in ring]
        u0, v0, width, depth = min(us), min(vs), max(us) - min(us), max(vs) - min(vs)
        nu, nv = max(1, round(width / spacing)), max(1, round(depth / spacing))
        points = []
        for i in range(nu):
            for j in range(nv):
                u, v = u0 + (i + 0.5 + shift) * width / nu, v0 + (j + 0.5 + shift) * depth / nv
                points.append((c * u - s * v, s * u + c * v))
        inside = shapely.contains_xy(self.room, np.array(points))
        return [point for point, there in zip(points, inside, strict=True) if there]
