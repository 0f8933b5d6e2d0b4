"""Boxes and prisms, and their triangles."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient

from mansion_assets.texture_coordinates import box_coordinates
from mansion_export.meshes.model import Material, Surface
from mansion_geometry.compiled import Floats
from mansion_geometry.rings import polygon_parts
from mansion_msgs_py.shapes import Point, Segment

__all__ = [
    "Box",
    "box_between",
    "boxes_of",
    "boxes_surface",
    "box_scaled",
    "polygon_surface",
    "segment_box",
    "triangulate",
]

CORNERS = np.array([(x, y, z) for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)], dtype=float)

SIDES = np.array(
    [
        (0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4),
        (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5),
    ]
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Box:
    """A box in plan coordinates: centre, full sizes, and its heading in degrees."""

    center: tuple[float, float, float]
    size: tuple[float, float, float]
    rotation: float = 0.0


def box_between(low: tuple[float, float, float], high: tuple[float, float, float], least: float = 1e-3) -> Box:
    """Return the upright box between two corners, at least `least` thick each way."""
    center = tuple((a + b) / 2 for a, b in zip(low, high))
    size = tuple(max(abs(b - a), least) for a, b in zip(low, high))
    return Box((center[0], center[1], center[2]), (size[0], size[1], size[2]))


def segment_box(segment: Segment, thickness: float, height: float, base: float = 0.0) -> Box:
    """Return the box that stands on a segment, e.g. a door's leaf when it is closed."""
    (ax, ay), (bx, by) = segment
    rotation = float(np.degrees(np.arctan2(by - ay, bx - ax)))
    length = float(np.hypot(bx - ax, by - ay))
    center = ((ax + bx) / 2, (ay + by) / 2, base + height / 2)
    return Box(center, (length, thickness, height), rotation)


def boxes_surface(boxes: Sequence[Box], material: Material) -> Surface:
    """Return boxes as one surface of outward triangles, 12 a box."""
    if not boxes:
        return Surface(material, np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int64))
    centers = np.array([box.center for box in boxes])
    sizes = np.array([box.size for box in boxes])
    angles = np.radians([box.rotation for box in boxes])
    local = CORNERS[None] * sizes[:, None, :]
    c, s = np.cos(angles)[:, None], np.sin(angles)[:, None]
    x = local[..., 0] * c - local[..., 1] * s
    y = local[..., 0] * s + local[..., 1] * c
    vertices = np.stack([x, y, local[..., 2]], axis=-1) + centers[:, None, :]
    faces = (SIDES[None] + 8 * np.arange(len(boxes))[:, None, None]).reshape(-1, 3).astype(np.int64)
    # In each box's own frame, so that a turned box shows its tile in true size, and the grain along its longest side.
    bodies = len(SIDES) * np.arange(len(boxes))
    coordinates = box_coordinates(local.reshape(-1, 3), faces, bodies, turned=True)
    return Surface(material, vertices.reshape(-1, 3), faces, coordinates)


def boxes_of(surface: Surface) -> list[Box]:
    """Return the boxes that `boxes_surface` made a surface of, where none of them is turned."""
    corners = surface.vertices.reshape(-1, len(CORNERS), 3)
    low, high = corners.min(1), corners.max(1)
    return [box_between(tuple(a), tuple(b)) for a, b in zip(low.tolist(), high.tolist())]


def box_scaled(box: Box, scale: tuple[float, float, float]) -> Box:
    """Return a box that is not turned in a frame that is stretched along its axes."""
    (x, y, z), (w, d, h), (kx, ky, kz) = box.center, box.size, scale
    return Box((x * kx, y * ky, z * kz), (w * kx, d * ky, h * kz))


def polygon_surface(polygon: Polygon, bottom: float, top: float, material: Material, *, sides: bool = True) -> Surface:
    """Return an upright prism over a polygon with holes; without `sides` only its upper face.

    Boards and courses of the material run along the longer side of the polygon.
    """
    flat, faces = triangulate(polygon)
    count = len(flat)
    upper = np.column_stack([flat, np.full(count, top)])
    x0, y0, x1, y1 = polygon.bounds
    laid = flat if x1 - x0 >= y1 - y0 else np.column_stack([flat[:, 1], -flat[:, 0]])
    if not sides:
        return Surface(material, upper, faces, laid[faces])
    lower = np.column_stack([flat, np.full(count, bottom)])
    vertices, triangles = [upper, lower], [faces, faces[:, ::-1] + count]
    coordinates = [laid[faces], laid[faces[:, ::-1]] * (1.0, -1.0)]
    offset = 2 * count
    oriented = orient(polygon)
    for ring in (oriented.exterior, *oriented.interiors):
        points = np.asarray(ring.coords, dtype=float)[:-1]
        n = len(points)
        following = np.roll(np.arange(n), -1)
        i = np.arange(n)
        vertices += [np.column_stack([points, np.full(n, bottom)]), np.column_stack([points, np.full(n, top)])]
        triangles.append(np.column_stack([i, following, following + n]) + offset)
        triangles.append(np.column_stack([i, following + n, i + n]) + offset)
        offset += 2 * n
        coordinates += _side_coordinates(points, bottom, top)
    faces = np.concatenate(triangles).astype(np.int64)
    return Surface(material, np.concatenate(vertices), faces, np.concatenate(coordinates))


def _side_coordinates(points: Floats, bottom: float, top: float) -> list[Floats]:
    """Return texture coordinates of a ring's sides, its lower and its upper triangles: along the ring, and height."""
    ends = np.cumsum(np.hypot(*(np.roll(points, -1, axis=0) - points).T))
    starts = np.concatenate([[0.0], ends[:-1]])
    low, high = np.full(len(points), bottom), np.full(len(points), top)
    a, b = np.column_stack([starts, low]), np.column_stack([ends, low])
    c, d = np.column_stack([ends, high]), np.column_stack([starts, high])
    return [np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]


def triangulate(polygon: Polygon) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
    """Triangulate a polygon with holes by ear clipping [1]_, one of many corners in parts.

    Returns
    -------
    (vertices, faces)
        Points (n, 2) and counter-clockwise triangles (m, 3).

    Notes
    -----
    Each hole is joined to the outer ring by a doubled edge, the hole that reaches furthest right first, so that later
    holes may join earlier ones. Clipping takes time with the square of the corners; parts of at most `MOST_CORNERS`
    make that n log n. They meet along straight cuts, whose ends are further vertices.

    References
    ----------
    .. [1] Meisters, G. H. (1975). Polygons have ears. The American Mathematical Monthly, 82(6), 648-651.
    """
    parts = [_ears(part) for part in _parts(polygon)]
    first = np.cumsum([0, *(len(points) for points, _ in parts)])
    points = np.concatenate([points for points, _ in parts])
    return points, np.concatenate([faces + offset for (_, faces), offset in zip(parts, first)])


MOST_CORNERS = 400
"""Most corners of a polygon that is triangulated in one part."""


def _parts(polygon: Polygon) -> Iterator[Polygon]:
    """Yield parts of a polygon that each have few corners, halved at the middle of its corners."""
    waiting = [polygon]
    while waiting:
        part = waiting.pop()
        corners = shapely.get_coordinates(part)
        halves = [] if len(corners) <= MOST_CORNERS else _halves(part, corners)
        if halves:
            waiting.extend(reversed(halves))
        else:
            yield part


def _halves(polygon: Polygon, corners: Floats) -> list[Polygon]:
    """Cut a polygon across its longer side, else its shorter one; empty where neither leaves parts of fewer corners."""
    low, high = corners.min(axis=0), corners.max(axis=0)
    longer = int(np.argmax(high - low))
    for axis in (longer, 1 - longer):
        sides = []
        for k in (0, 1):
            ends = np.array([low - 1.0, high + 1.0])
            ends[1 - k, axis] = np.median(corners[:, axis])
            sides += polygon_parts(_clipped_to(polygon, ends.ravel()))
        if all(len(shapely.get_coordinates(side)) < len(corners) for side in sides):
            return sides
    return []


def _clipped_to(polygon: Polygon, bounds: Floats) -> BaseGeometry:
    """Return the part of a polygon within bounds: by the quick way of GEOS where that gives a valid one."""
    quick = shapely.clip_by_rect(polygon, *bounds)
    return quick if shapely.is_valid(quick) else polygon.intersection(shapely.box(*bounds))


def _ears(polygon: Polygon) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
    """Triangulate a polygon by ear clipping."""
    ring = _bridge(orient(polygon))
    points = np.array(ring, dtype=float)
    remaining = list(range(len(ring)))
    faces: list[tuple[int, int, int]] = []
    guard = len(remaining) ** 2
    k = 0
    while len(remaining) > 3 and guard > 0:
        guard -= 1
        n = len(remaining)
        a, b, c = remaining[k % n], remaining[(k + 1) % n], remaining[(k + 2) % n]
        if _is_ear(points, remaining, a, b, c):
            if _cross(points[a], points[b], points[c]) > 1e-12:
                faces.append((a, b, c))
            remaining.pop((k + 1) % n)
        else:
            k = (k + 1) % n
    if len(remaining) == 3:
        faces.append((remaining[0], remaining[1], remaining[2]))
    return points, np.array(faces, dtype=np.int64).reshape(-1, 3)


def _cross(a: npt.NDArray[np.float64], b: npt.NDArray[np.float64], c: npt.NDArray[np.float64]) -> float:
    return float((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))


def _is_ear(points: npt.NDArray[np.float64], remaining: list[int], a: int, b: int, c: int) -> bool:
    """Tell whether no other vertex lies in the corner at `b`; a flat corner may always go."""
    area = _cross(points[a], points[b], points[c])
    if abs(area) <= 1e-12:
        return True
    if area < 0.0:
        return False
    others = points[remaining]
    pa, pb, pc = points[a], points[b], points[c]
    inside = np.ones(len(others), dtype=bool)
    for p, q in ((pa, pb), (pb, pc), (pc, pa)):
        inside &= (q[0] - p[0]) * (others[:, 1] - p[1]) - (q[1] - p[1]) * (others[:, 0] - p[0]) > 1e-12
    corner = (others[:, None, :] == np.stack([pa, pb, pc])[None]).all(-1).any(-1)
    return not bool((inside & ~corner).any())


def _bridge(polygon: Polygon) -> list[Point]:
    """Join each hole to the outer ring by a doubled edge to a vertex that it sees."""
    ring = [(float(x), float(y)) for x, y in list(polygon.exterior.coords)[:-1]]
    holes = [[(float(x), float(y)) for x, y in list(hole.coords)[:-1]] for hole in polygon.interiors]
    holes.sort(key=lambda hole: -max(hole)[0])
    for hole in holes:
        start = hole.index(max(hole))
        x, y = hole[start]
        best = min(range(len(ring)), key=lambda i: (not _sees(ring, holes, (x, y), ring[i]), _far(ring[i], (x, y)), i))
        around = [*hole[start:], *hole[: start + 1]]
        ring = [*ring[: best + 1], *around, *ring[best:]]
    return ring


def _far(a: Point, b: Point) -> float:
    return (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2


def _sees(ring: list[Point], holes: list[list[Point]], a: Point, b: Point) -> bool:
    """Tell whether no edge properly crosses the line from a to b."""
    for loop in (ring, *holes):
        for p, q in zip(loop, loop[1:] + loop[:1]):
            if a in (p, q) or b in (p, q):
                continue
            d1 = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
            d2 = (b[0] - a[0]) * (q[1] - a[1]) - (b[1] - a[1]) * (q[0] - a[0])
            d3 = (q[0] - p[0]) * (a[1] - p[1]) - (q[1] - p[1]) * (a[0] - p[0])
            d4 = (q[0] - p[0]) * (b[1] - p[1]) - (q[1] - p[1]) * (b[0] - p[0])
            if d1 * d2 <= 0 and d3 * d4 <= 0:
                return False
    return True
