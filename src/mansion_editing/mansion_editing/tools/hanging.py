"""Places on the walls and the ceiling of a room, for what hangs there."""

import math
from collections import Counter
from collections.abc import Iterator, Sequence

import msgspec

from mansion_assets.catalogue import Asset
from mansion_editing.state import SceneState
from mansion_editing.tools.destinations import InRoom
from mansion_editing.tools.placing_wishes import hangs, hindered, refusal
from mansion_editing.tools.relations import PlacingWish, fulfils, middle_of
from mansion_geometry.object_footprints import WALKABLE_HEIGHT, footprint_at, footprint_distance
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom
from mansion_msgs_py.wording import with_article
from mansion_scene.decor.ceiling_objects import HEADROOM, CeilingSpace
from mansion_scene.decor.frames import room_polygon, wall_edges
from mansion_scene.decor.wall_objects import BACK_GAP, WallSpace, hanging_height, height_above

__all__ = ["hang"]

STEP = 0.1
"""Distance between places that are tried along a wall, metres."""

LATTICE = 0.5
"""Distance between places that are tried on a ceiling, metres."""

MOST_REFUSED = 8
APART = 0.3
"""Distance between places that are judged, metres."""


def hang(state: SceneState, thing: SceneObject, where: InRoom) -> SceneObject:
    """Return an object hanging on a wall or from the ceiling of a room; the state is not changed.

    Parameters
    ----------
    thing : SceneObject
        Its `mount` says where it hangs.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with what is in the way.
    """
    asset = state.asset(thing)
    if asset is None:
        raise refusal(f"the catalogue lacks {thing.asset!r}; how it hangs is not known")
    room, wish = where.room, where.wish
    if wish.side == "under" or (wish.spot == "middle" and thing.mount == "wall"):
        raise hangs(thing, "not on the floor")
    scene = state.scenes[where.floor]
    own = {thing.id, *where.companions}
    others = [item for item in scene.objects if item.room == room.id and item.id not in own]
    places = _on_walls if thing.mount == "wall" else _on_ceiling
    reasons: Counter[str] = Counter()
    refused: list[SceneObject] = []
    for placed, found in places(scene, thing, asset, where, others):
        if not fulfils(scene, room, placed, wish):
            continue
        if found:
            reasons.update(found)
        elif any(math.dist(placed.position, other.position) < APART for other in refused):
            continue
        elif where.accept is None or where.accept(where.floor, placed):
            return placed
        else:
            refused.append(placed)
            reasons["the way that a robot needs"] += 100
            if len(refused) == MOST_REFUSED:
                break
    raise hindered(thing, where, reasons)


Places = Iterator[tuple[SceneObject, list[str]]]
"""Poses, the best first, each with what is in its way."""


def _on_walls(
    scene: FloorScene, thing: SceneObject, asset: Asset, where: InRoom, others: Sequence[SceneObject]
) -> Places:
    room, wish = where.room, where.wish
    w, d, _ = thing.size
    found: list[tuple[float, SceneObject, list[str]]] = []
    edges = wall_edges(room.net_polygon, room.net_holes)
    for edge in edges:
        if edge.length < w + 0.04:
            continue
        wall = WallSpace(edge, edges)
        wall.block_openings(scene.doors, scene.windows)
        for item in others:
            if item.size[2] > WALKABLE_HEIGHT:
                wall.block_object(item)
        low, high = w / 2 + 0.02, edge.length - w / 2 - 0.02
        stops = _stops(low, high, None if wish.near is None else edge.coordinates(wish.near.position[:2])[0])
        for order, height in enumerate(_heights(thing, asset, room, wish)):
            for along in stops:
                x, y = edge.point(along, d / 2 + BACK_GAP)
                placed = _hung(thing, room, (x, y, height), edge.rotation)
                away = 0.0 if wish.near is None else math.dist((x, y), wish.near.position[:2])
                gaps = wall.gaps(w, *_span(placed), d)
                free = min((abs(along - end) for gap in gaps for end in gap), default=0.0)
                cost = order + away - 0.1 * min(free, 2.0)
                found.append((round(cost, 6), placed, wall.hindrances(along, height, thing.size)))
    found.sort(key=lambda entry: entry[0])
    for _, placed, hindrances in found:
        yield placed, hindrances


def _span(item: SceneObject) -> tuple[float, float]:
    return item.bottom, item.top


def _heights(thing: SceneObject, asset: Asset, room: SceneRoom, wish: PlacingWish) -> list[float]:
    """Return heights of the centre: the usual one; above an object, also closely above it."""
    if wish.side == "above" and wish.near is not None:
        close = asset.size[2] / 2
        heights = [height_above(asset, room.ceiling_height, wish.near, wanted) for wanted in (None, close)]
    else:
        heights = [hanging_height(asset, room.ceiling_height)]
    known = list(dict.fromkeys(height for height in heights if height is not None))
    if not known:
        over = "" if wish.near is None else f" above {wish.near.id}"
        raise refusal(f"{room.id} is too low for {with_article(thing.name)} of {thing.size[2]:.2f} m{over}")
    return known


def _stops(low: float, high: float, goal: float | None) -> list[float]:
    """Return positions along a wall, that nearest to `goal` among them."""
    if high < low:
        return []
    count = max(1, int((high - low) / STEP))
    stops = [low + (high - low) * number / count for number in range(count + 1)]
    return stops if goal is None else [min(max(goal, low), high), *stops]


def _on_ceiling(
    scene: FloorScene, thing: SceneObject, asset: Asset, where: InRoom, others: Sequence[SceneObject]
) -> Places:
    room, wish = where.room, where.wish
    area = room_polygon(room.net_polygon, room.net_holes)
    ceiling = CeilingSpace(area, wall_edges(room.net_polygon, room.net_holes), room.ceiling_height, others)
    below = room.ceiling_height - asset.size[2]
    marks = [mark.position[:2] for mark in (wish.near,) if mark is not None]
    goal = marks[0] if marks else middle_of(room)[0]
    points = [*marks, middle_of(room)[0], *ceiling.lattice(LATTICE)]
    points.sort(key=lambda point: round(math.dist(point, goal), 6))
    for x, y in points:
        for turn in (0.0, 90.0):
            rotation = ceiling.angle + turn
            within = area.contains(footprint_at((x, y), thing.size, rotation))
            found = [] if within else [f"the wall of {room.id}"]
            found += ceiling.hindrances(thing.size, (x, y), rotation)
            placed = _hung(thing, room, (x, y, room.ceiling_height - thing.size[2] / 2), rotation)
            if below < HEADROOM and not _over_furniture(placed, others):
                found.append(f"who walks below in {room.id} of {room.ceiling_height:.2f} m height")
            yield placed, found


def _over_furniture(placed: SceneObject, others: Sequence[SceneObject]) -> bool:
    """Whether nobody walks below: the middle is over something that stands there."""
    return any(
        item.mount == "floor"
        and item.size[2] > WALKABLE_HEIGHT
        and footprint_distance(placed.position[:2], item.position, item.size, item.rotation) == 0.0
        for item in others
    )


def _hung(thing: SceneObject, room: SceneRoom, at: tuple[float, float, float], rotation: float) -> SceneObject:
    x, y, z = (round(value, 4) for value in at)
    return msgspec.structs.replace(
        thing, room=room.id, position=(x, y, z), rotation=round(rotation % 360.0, 4), parent=None
    )
