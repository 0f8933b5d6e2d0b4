"""Rugs: below furniture, before it, at doors, or on free floor."""

import math
from collections.abc import Sequence

import numpy as np
from shapely import Polygon
from shapely.strtree import STRtree

from mansion_assets.catalogue import Asset, RugRequest
from mansion_geometry.object_footprints import footprint, footprint_at
from mansion_msgs_py.scene import Door, SceneObject
from mansion_msgs_py.shapes import Point
from mansion_scene.decor.frames import Ids, WallEdge, scene_object, to_floor

__all__ = ["matches", "rugs"]


def matches(obj: SceneObject, name: str) -> bool:
    """Tell whether a placed object is of a category, or a copy of a program's item called `name`."""
    return name in (obj.category, obj.name) or obj.id.rpartition("/")[2].rstrip("0123456789") == f"{name}_"


def rugs(
    requests: Sequence[RugRequest],
    room: Polygon,
    edges: Sequence[WallEdge],
    doors: Sequence[Door],
    placed: Sequence[SceneObject],
    ids: Ids,
    room_id: str,
    rng: np.random.Generator,
) -> list[SceneObject]:
    """Return the rugs of a room, inside it and clear of each other; they lie flat and can be walked on."""
    out: list[SceneObject] = []
    shapes: list[Polygon] = []
    floor = [footprint(o) for o in placed if o.mount == "floor"]
    tree = STRtree(floor)
    for request in requests:
        targets = [o for o in placed if request.under and matches(o, request.under)]
        laid = 0
        for asset in request.assets:
            if laid >= request.count:
                break
            for center, rotation, free in _candidates(request, asset, room, edges, doors, targets, rng):
                shape = footprint_at(center, asset.size, rotation)
                if not room.contains(shape) or any(shape.intersects(other) for other in shapes):
                    continue
                if free and request.free and len(tree.query(shape, predicate="intersects")):
                    continue
                shapes.append(shape)
                position = (center[0], center[1], asset.size[2] / 2)
                out.append(scene_object(asset, ids.new(asset.category), room_id, position, rotation))
                laid += 1
                if laid >= request.count:
                    break
    return out


Candidate = tuple[Point, float, bool]


def _candidates(
    request: RugRequest,
    asset: Asset,
    room: Polygon,
    edges: Sequence[WallEdge],
    doors: Sequence[Door],
    targets: Sequence[SceneObject],
    rng: np.random.Generator,
) -> list[Candidate]:
    """Return centres and rotations to try, and whether the floor there must be free of furniture."""
    if asset.category == "door_mat":
        return [c for door in doors if (c := _at_door(asset, edges, door)) is not None]
    if request.under:
        return [c for target in targets for c in _at_object(request, asset, target)]
    return _on_free_floor(asset, room, edges, rng, request.count)


def _at_door(asset: Asset, edges: Sequence[WallEdge], door: Door) -> Candidate | None:
    edge = next((e for e in edges if e.carries(door.segment)), None)
    if edge is None:
        return None
    (s0, _), (s1, _) = (edge.coordinates(p) for p in door.segment)
    return edge.point((s0 + s1) / 2, 0.05 + asset.size[1] / 2), edge.rotation, False


def _at_object(request: RugRequest, asset: Asset, target: SceneObject) -> list[Candidate]:
    """Return places under an object, with a margin on all sides; in front of it where the margin is zero."""
    w, d = target.size[0], target.size[1]
    if request.margin <= 0.0:
        center = to_floor(target, (0.0, d / 2 + asset.size[1] / 2 + 0.03))
        return [(center, target.rotation, False)]
    bed = target.mount == "floor" and d > 1.6 and w > 0.7
    shift = d * 0.22 if bed else 0.0
    out: list[Candidate] = []
    for turn in (0.0, 90.0):
        size = asset.size if turn == 0.0 else (asset.size[1], asset.size[0], asset.size[2])
        covers = size[0] >= w + request.margin and (bed or size[1] >= d + request.margin)
        if covers:
            out.append((to_floor(target, (0.0, shift)), target.rotation + turn, False))
    return out


def _on_free_floor(
    asset: Asset, room: Polygon, edges: Sequence[WallEdge], rng: np.random.Generator, count: int
) -> list[Candidate]:
    """Return places on a lattice along the longest wall: a block of rows in the middle of the room first, for many."""
    longest = max(edges, key=lambda e: e.length)
    angle = math.degrees(math.atan2(longest.along[1], longest.along[0]))
    x0, y0, x1, y1 = room.bounds
    middle = ((x0 + x1) / 2, (y0 + y1) / 2)
    long_way = 90.0 if asset.size[1] > 1.8 * asset.size[0] and rng.random() < 0.99 else 0.0
    step = (asset.size[0] + 0.25, asset.size[1] + 0.25)
    if long_way:
        step = (step[1], step[0])
    reach = int(max(x1 - x0, y1 - y0) / min(step)) // 2 + 1
    columns, rows = _block(count, step, longest.length, room.area / longest.length)
    # Half a step where a block has an even number of columns or rows, so that it lies about the middle.
    shift = (0.5 * (columns % 2 == 0), 0.5 * (rows % 2 == 0))
    cells = [(i + shift[0], j + shift[1]) for i in range(-reach, reach + 1) for j in range(-reach, reach + 1)]

    def beyond_block(cell: tuple[float, float]) -> tuple[bool, float, tuple[float, float]]:
        outside = abs(cell[0]) > columns / 2 or abs(cell[1]) > rows / 2
        return outside, math.hypot(cell[0] * step[0], cell[1] * step[1]), cell

    cells.sort(key=beyond_block)
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    out: list[Candidate] = []
    for i, j in cells[:150]:
        dx, dy = i * step[0], j * step[1]
        center = (middle[0] + c * dx - s * dy, middle[1] + s * dx + c * dy)
        out.append((center, (angle + long_way) % 360.0, True))
    return out


def _block(count: int, step: tuple[float, float], along: float, across: float) -> tuple[int, int]:
    """Return columns and rows of a block of `count` rugs, as full and as close to the shape of the room as possible."""

    def unlike(columns: int) -> float:
        rows = -(-count // columns)
        shape = columns * step[0] / (rows * step[1]) / (along / across)
        return abs(math.log(shape)) + 2.0 * (columns * rows - count) / count

    columns = min(range(1, count + 1), key=unlike) if count > 3 else 1
    return columns, -(-count // columns)
