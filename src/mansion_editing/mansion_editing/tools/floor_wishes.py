"""Places on a floor where a wish holds: beside, between, below others, in a part of the room, turned to something."""

import math
from collections import Counter
from collections.abc import Callable, Iterator
from typing import Final, NamedTuple

import msgspec
from shapely import GeometryCollection, LineString, MultiPoint, Point

from mansion_assets.meshes import collision_boxes
from mansion_editing.state import SceneState
from mansion_editing.tools.destinations import Accept, InRoom
from mansion_editing.tools.floor_places import FloorSpace, Pose, floor_poses
from mansion_editing.tools.placing_wishes import hindered, refusal
from mansion_editing.tools.relations import PlacingWish, extents, fulfils, greatest_gap, spot_shapes
from mansion_geometry.object_footprints import WALKABLE_HEIGHT, footprint
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom
from mansion_msgs_py.wording import with_article
from mansion_scene.decor.frames import to_floor, to_local, wall_edges

__all__ = ["place_as_wished"]

GAPS: Final = (0.02, 0.1, 0.25, 0.45, 0.7, 1.0, 1.4)
"""Distances from a landmark that are tried, metres."""

STEP = 0.1
WALL_GAP = 0.01
BELOW_STEP = 0.05
BELOW_GAP = 0.01
MOST_REFUSED = 20
APART = 0.25
"""Distance between places that are judged, metres."""

OBLIQUE = 0.5
"""Cost of standing oblique to the walls."""

QUARTERS: Final = (0.0, 90.0, 180.0, 270.0)
TURN_TO: Final = {"left": 270.0, "right": 90.0, "front": 180.0, "behind": 0.0}
"""Turn of what looks at a landmark from each of its sides, in the landmark's frame."""


class _Candidate(NamedTuple):
    """A pose and its cost; less is better."""

    cost: float
    pose: Pose


def place_as_wished(state: SceneState, thing: SceneObject, where: InRoom) -> SceneObject:
    """Return an object standing on the floor of a room where a wish holds; the state is not changed.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with what is in the way.
    """
    room, wish = where.room, where.wish
    scene = state.scenes[where.floor]
    if wish.side == "above":
        raise refusal(f"{with_article(thing.name)} stands on the floor; only what hangs can be above something")
    flat = thing.size[2] <= WALKABLE_HEIGHT
    space = FloorSpace(scene, room, thing, where.companions, flat=flat)
    below = _below(state, wish) if wish.side == "under" and not flat else None
    marks = [mark.id for mark in (wish.near, wish.other, wish.facing) if mark is not None]
    ignored = [below.landmark.id] if below else []
    reasons: Counter[str] = Counter()
    without_front: list[SceneObject] = []
    judge = _Judge(where.floor, where.accept)
    for _, pose in sorted(_candidates(scene, room, thing, wish)):
        placed = _standing(thing, room, pose)
        if not fulfils(scene, room, placed, wish):
            continue
        found = space.hindrances(pose, ignored)
        if below and not found:
            found = below.hindrances(placed)
            placed = below.carried(placed)
        if found:
            reasons.update(found)
        elif not (flat or below) and space.before(pose, marks):
            without_front.append(placed)
            reasons.update(space.before(pose, marks))
        elif judge.accepts(placed):
            return placed
    for placed in [] if thing.openable else without_front:
        if judge.accepts(placed):
            return placed
    if judge.refused:
        reasons["the way that a robot needs"] = max(reasons.values(), default=0) + 1
    raise hindered(thing, where, reasons)


class _Judge:
    """Asks whether places are accepted, a few of them and none twice."""

    def __init__(self, floor: int, accept: Accept | None) -> None:
        self._floor, self._accept = floor, accept
        self.refused: list[SceneObject] = []

    def accepts(self, placed: SceneObject) -> bool:
        """Whether a place is accepted."""
        if self._accept is None:
            return True
        if len(self.refused) >= MOST_REFUSED or any(_alike(placed, other) for other in self.refused):
            return False
        if self._accept(self._floor, placed):
            return True
        self.refused.append(placed)
        return False


def _alike(one: SceneObject, other: SceneObject) -> bool:
    return one.rotation == other.rotation and math.dist(one.position[:2], other.position[:2]) < APART


def _standing(thing: SceneObject, room: SceneRoom, pose: Pose) -> SceneObject:
    x, y, rotation = pose
    position = (round(x, 4), round(y, 4), round(thing.size[2] / 2, 4))
    turn = round(rotation % 360.0, 4)
    return msgspec.structs.replace(thing, room=room.id, position=position, rotation=turn, mount="floor", parent=None)


def _candidates(scene: FloorScene, room: SceneRoom, thing: SceneObject, wish: PlacingWish) -> Iterator[_Candidate]:
    near = wish.near
    if near is not None and wish.side == "under":
        yield from _poses_below(thing, near)
        return
    if near is not None and wish.side == "between":
        yield from _poses_between(thing, near, wish)
    elif near is not None and (wish.side or wish.within is not None):
        yield from _poses_round(scene, thing, near, wish)
    yield from _poses_in_room(scene, room, thing, wish)


def _poses_round(scene: FloorScene, thing: SceneObject, near: SceneObject, wish: PlacingWish) -> Iterator[_Candidate]:
    """Yield poses along the sides of a landmark: those in line with it, and nearer ones, first."""
    most = greatest_gap(thing, wish)
    least = wish.apart or 0.0
    tried = (*GAPS, (least + most) / 2) if least else GAPS
    gaps = [gap for gap in tried if least <= gap <= most] or [most / 2]
    sides = (wish.side,) if wish.side in TURN_TO else tuple(TURN_TO)
    crowd = _neighbours(scene, near, thing) if wish.side == "around" else Counter[str]()
    for side in sides:
        aside = 0.4 if wish.side != "around" and side in ("front", "behind") and len(sides) > 1 else 0.0
        for turn in _turns(thing, near, wish, side):
            for gap in gaps:
                for shift, (u, v) in _along(thing, near, side, turn.angle, gap):
                    x, y = to_floor(near, (u, v))
                    cost = aside + turn.cost + gap + 0.3 * shift + 0.6 * crowd[side]
                    yield _Candidate(round(cost, 6), (x, y, near.rotation + turn.angle))


class _Turn(NamedTuple):
    angle: float
    cost: float


def _turns(thing: SceneObject, near: SceneObject, wish: PlacingWish, side: str) -> list[_Turn]:
    """Return turns in the landmark's frame, the usual one first."""
    to_it = wish.side in ("around", "front") or (wish.facing is not None and wish.facing.id == near.id)
    usual = TURN_TO[side] if to_it else 0.0
    turns = [_Turn((usual + quarter) % 360.0, 0.8 * (quarter != 0.0)) for quarter in QUARTERS]
    return turns[:1] if wish.side == "around" and wish.facing is None else turns


def _along(
    thing: SceneObject, near: SceneObject, side: str, turn: float, gap: float
) -> Iterator[tuple[float, tuple[float, float]]]:
    """Yield centres beside a landmark in its frame, each with its distance from the place in line with it."""
    w, d = thing.size[:2] if turn % 180.0 == 0.0 else (thing.size[1], thing.size[0])
    across = side in ("left", "right")
    half_w, half_d = near.size[0] / 2, near.size[1] / 2
    away = gap + ((half_w + w / 2) if across else (half_d + d / 2))
    reach = (
        (half_d if across else half_w)
        + (d if across else w) / 2
        - 0.5 * min(d if across else w, 2 * (half_d if across else half_w))
    )
    in_line = -half_d + d / 2 if across else 0.0
    count = int(reach / STEP)
    offsets = {round(in_line, 4), 0.0, *(round(STEP * k, 4) for k in range(-count, count + 1))}
    sign = -1.0 if side in ("left", "behind") else 1.0
    for offset in sorted(offsets, key=lambda value: (abs(value - in_line), value)):
        if abs(offset) <= reach + 1e-9:
            yield abs(offset - in_line), ((sign * away, offset) if across else (offset, sign * away))


def _neighbours(scene: FloorScene, near: SceneObject, thing: SceneObject) -> Counter[str]:
    """Count the things of the same category close to each side of a landmark, so that the next one takes another."""
    out: Counter[str] = Counter()
    for item in scene.objects:
        if item.room != near.room or item.category != thing.category or item.id in (near.id, thing.id):
            continue
        if footprint(item).distance(footprint(near)) < 0.8:
            u, v = to_local(near, item.position)
            across = abs(u) / near.size[0] > abs(v) / near.size[1]
            out[("right" if u > 0 else "left") if across else ("front" if v > 0 else "behind")] += 1
    return out


def _poses_between(thing: SceneObject, near: SceneObject, wish: PlacingWish) -> Iterator[_Candidate]:
    """Yield poses on and beside the line between two landmarks, from its middle."""
    other = wish.other
    if other is None:
        return
    line = LineString([near.position[:2], other.position[:2]])
    if line.length < 0.05:
        return
    steps = int(line.length / STEP)
    dx, dy = ((b - a) / line.length for a, b in zip(near.position[:2], other.position[:2], strict=True))
    free = (footprint(near).distance(footprint(other)), line.difference(footprint(near)).difference(footprint(other)))
    middle = free[1].interpolate(0.5, normalized=True) if free[0] > 0 else line.interpolate(0.5, normalized=True)
    for number in range(-steps, steps + 1):
        for aside in (0.0, 0.1, -0.1, 0.2, -0.2):
            x = middle.x + STEP * number * dx / 2 - aside * dy
            y = middle.y + STEP * number * dy / 2 + aside * dx
            for order, quarter in enumerate(QUARTERS):
                cost = abs(STEP * number / 2) + abs(aside) + 0.2 * order
                yield _Candidate(round(cost, 6), (x, y, near.rotation + quarter))


def _poses_in_room(scene: FloorScene, room: SceneRoom, thing: SceneObject, wish: PlacingWish) -> Iterator[_Candidate]:
    """Yield poses all over a room, those at walls and close to what the wish names first; turned in quarters."""
    towards = _attraction(scene, room, wish)
    sided = wish.near is not None and bool(wish.side or wish.within is not None)
    reach = _reach(thing, wish) if sided else math.inf
    for number, (x, y, rotation) in enumerate([*_corner_poses(room, thing, wish), *floor_poses(room, thing)]):
        if wish.near is not None and math.dist((x, y), wish.near.position[:2]) > reach:
            continue
        base = (3.0 if sided else 0.0) + towards(x, y) + 1e-5 * number
        for quarter in QUARTERS:
            yield _Candidate(round(base + 0.3 * (quarter != 0.0), 6), (x, y, rotation + quarter))
        if wish.facing is not None:
            tx, ty = wish.facing.position[0] - x, wish.facing.position[1] - y
            aim = math.degrees(math.atan2(-tx, ty))
            yield _Candidate(round(base + OBLIQUE, 6), (x, y, aim))


def _reach(thing: SceneObject, wish: PlacingWish) -> float:
    """Return the greatest distance between the middles of a thing and of its landmark, metres."""
    near, other = wish.near, wish.other
    if near is None:
        return math.inf
    if other is not None:
        return math.dist(near.position[:2], other.position[:2])
    return greatest_gap(thing, wish) + (math.hypot(*thing.size[:2]) + math.hypot(*near.size[:2])) / 2


def _attraction(scene: FloorScene, room: SceneRoom, wish: PlacingWish) -> Callable[[float, float], float]:
    """Return the distance of a point from what a wish is about, metres."""
    shapes = [] if wish.spot in ("", "wall") else spot_shapes(scene, room, wish.spot, wish.door)
    goal = MultiPoint() if not shapes else GeometryCollection(shapes)
    mark = None if wish.near is None else Point(wish.near.position[:2])

    def distance(x: float, y: float) -> float:
        here = Point(x, y)
        out = 0.0 if goal.is_empty else float(goal.distance(here))
        return out if mark is None else out + float(mark.distance(here))

    return distance


def _corner_poses(room: SceneRoom, thing: SceneObject, wish: PlacingWish) -> Iterator[Pose]:
    """Yield poses in the corners of a room, with the back at either wall."""
    if wish.spot != "corner":
        return
    w, d, _ = thing.size
    for edge in wall_edges(room.net_polygon):
        for along in (w / 2 + WALL_GAP, edge.length - w / 2 - WALL_GAP):
            x, y = edge.point(along, d / 2 + WALL_GAP)
            yield x, y, edge.rotation


class _Below:
    """The room below a landmark, between its legs."""

    def __init__(self, state: SceneState, landmark: SceneObject) -> None:
        self.landmark = landmark
        asset = state.asset(landmark)
        self._boxes = [] if asset is None else collision_boxes(asset)

    def hindrances(self, placed: SceneObject) -> list[str]:
        """Return the landmark where its own body is in the way."""
        u0, u1, v0, v1 = extents(self.landmark, placed)
        top = placed.top + BELOW_GAP - self.landmark.position[2]
        for box in self._boxes:
            (x, y, z), (w, d, h) = box.center, box.size
            apart = (u0 - x - w / 2, x - w / 2 - u1, v0 - y - d / 2, y - d / 2 - v1, z - h / 2 - top)
            if max(apart) < 0.0:
                return [f"{self.landmark.id} itself"]
        return []

    def carried(self, placed: SceneObject) -> SceneObject:
        """Return a thing as one that belongs to the landmark where their heights overlap."""
        over = self.landmark.position[2] - self.landmark.size[2] / 2 < placed.size[2]
        return msgspec.structs.replace(placed, parent=self.landmark.id if over else None)


def _below(state: SceneState, wish: PlacingWish) -> _Below | None:
    return None if wish.near is None else _Below(state, wish.near)


def _poses_below(thing: SceneObject, near: SceneObject) -> Iterator[_Candidate]:
    """Yield poses below a landmark, those at its front first; of a rug, that in its middle."""
    for quarter in (0.0, 90.0):
        w, d = thing.size[:2] if quarter == 0.0 else (thing.size[1], thing.size[0])
        reach = max(0.0, near.size[0] / 2 - w / 2), max(0.0, near.size[1] / 2 - d / 2)
        counts = [int(value / BELOW_STEP) for value in reach]
        for i in range(-counts[0], counts[0] + 1):
            for j in range(-counts[1], counts[1] + 1):
                u, v = BELOW_STEP * i, BELOW_STEP * j
                aside = math.hypot(u, v) if thing.size[2] <= WALKABLE_HEIGHT else abs(u) + reach[1] - v
                x, y = to_floor(near, (u, v))
                yield _Candidate(round(aside + quarter / 900.0, 6), (x, y, near.rotation + quarter))
