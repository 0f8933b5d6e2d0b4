"""PlaceOnSurface and PlaceInContainer: find a free place on a ledge, settle the object by physics, check its pose."""

import math
from collections.abc import Callable, Collection, Iterable, Sequence
from itertools import islice
from typing import NamedTuple, TypeAlias

import msgspec
import numpy as np
import numpy.typing as npt

from mansion_assets.builder import Box
from mansion_assets.catalogue import Asset
from mansion_assets.meshes import collision_boxes, mesh
from mansion_editing.physics.engine import PhysicsEngine, PosedBox, SettleProblem, SettleResult
from mansion_editing.state import FloorIndex, SceneState
from mansion_editing.tools.floor_places import Accept, stand_on_floor
from mansion_editing.tools.floor_wishes import stand_as_wished
from mansion_editing.tools.hanging import hang
from mansion_editing.tools.painting import recoloured
from mansion_editing.tools.perception import object_named
from mansion_editing.tools.placing_wishes import refusal, wish_of, wish_words
from mansion_editing.tools.relations import NO_WISH, PlacingWish, fulfils
from mansion_msgs_py.editing import PlaceInContainerArgs, PlaceOnSurfaceArgs
from mansion_msgs_py.scene import SceneObject, SceneRoom
from mansion_msgs_py.shapes import Point, Point3
from mansion_msgs_py.wording import with_article
from mansion_scene.decor.frames import scene_object, to_floor, to_local

__all__ = [
    "COOLING",
    "Ledge",
    "Place",
    "free_places",
    "half_diagonal",
    "ledges_of",
    "place_in_container",
    "place_on_surface",
    "put_in_room",
    "receptacle_shell",
    "settle_on",
    "support_boxes",
]

COOLING = ("fridge", "freezer", "minibar", "display_fridge", "freezer_chest")
"""Containers that make cold what lies in them."""


class Ledge(NamedTuple):
    """A flat place of a receptacle, in its frame: a surface, or the floor of an inner box.

    Attributes
    ----------
    z : float
        Of the flat, above the centre of the receptacle's box.
    clearance : float
        Free height above it.
    vessel : bool
        Of something open at the top (a bowl), out of which a thing may stand by less than half.
    """

    kind: str
    inside: bool
    x: float
    y: float
    z: float
    w: float
    d: float
    clearance: float
    round: bool = False
    vessel: bool = False

    @property
    def headroom(self) -> float:
        """Greatest height of what lies there, metres."""
        return self.clearance * (2.0 if self.vessel else 1.0)


class Place(NamedTuple):
    """A free place: centre in the receptacle's frame, degrees of turn, and its cost (less is better)."""

    ledge: Ledge
    x: float
    y: float
    turn: float
    cost: float


def place_on_surface(
    state: SceneState, args: PlaceOnSurfaceArgs, engine: PhysicsEngine, accept: Accept | None = None
) -> SceneObject:
    """Put a new object on a receptacle, or furniture on the floor of a room.

    Parameters
    ----------
    accept : callable, optional
        Judges a place on the floor before it is taken.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown asset or receptacle, ``INFEASIBLE`` with the reason where it finds no place.
    """
    asset = state.catalogue.asset(args.asset_id)
    room = state.room(args.receptacle_id)
    wish = wish_of(state, args)
    if room is not None:
        floor = room[0]
        placed = put_in_room(state, _new(state, asset, *room, args.color, args.name), *room, wish, accept=accept)
    else:
        floor, receptacle = object_named(state, args.receptacle_id, "$.receptacle_id")
        new = _new(state, asset, floor, receptacle, args.color, args.name)
        placed = settle_on(state, new, floor, receptacle, engine, inside=False, wish=wish)
    state.add(floor, placed)
    return placed


def put_in_room(
    state: SceneState,
    thing: SceneObject,
    floor: int,
    room: SceneRoom,
    wish: PlacingWish,
    *,
    accept: Accept | None = None,
    skip: Collection[str] = (),
) -> SceneObject:
    """Return an object on a wall, the ceiling or the floor of a room, as it is made for; the state is not changed.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with the reason where it finds no place.
    """
    if thing.mount in ("wall", "ceiling"):
        return hang(state, thing, floor, room, wish, accept=accept, skip=skip)
    if wish.binding:
        return stand_as_wished(state, thing, floor, room, wish, accept=accept, skip=skip)
    return stand_on_floor(state, thing, floor, room, near=wish.near, accept=accept)


def place_in_container(state: SceneState, args: PlaceInContainerArgs, engine: PhysicsEngine) -> SceneObject:
    """Put a new object into a container, its door open while it is placed.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown asset or container, ``INFEASIBLE`` with the reason where it finds no place.
    """
    asset = state.catalogue.asset(args.asset_id)
    floor, container = object_named(state, args.container_id, "$.container_id")
    placed = settle_on(
        state, _new(state, asset, floor, container, args.color, args.name), floor, container, engine, inside=True
    )
    state.add(floor, placed)
    return placed


def _new(
    state: SceneState, asset: Asset, floor: int, place: SceneRoom | SceneObject, colour: str, name: str
) -> SceneObject:
    """Return a new object in the room that is, or that has, its place; where exactly is found later."""
    room = place.room if isinstance(place, SceneObject) else place.id
    new = scene_object(asset, state.new_id(floor, room, asset.category), room, (0.0, 0.0, 0.0), 0.0, name=name)
    return recoloured(new, colour)


MOST_PENETRATION = 0.002
MOST_TILT = 3.0
"""Degrees; scene objects are upright, so one that tilts more is refused."""

MOST_PUSH = 0.005
"""Metres that a neighbour may move."""

MOST_SLIDE = 0.03
DROP = 0.003
NEAR = 0.20
"""Neighbours within this distance take part in the physics, metres."""


def settle_on(
    state: SceneState,
    thing: SceneObject,
    floor: int,
    receptacle: SceneObject,
    engine: PhysicsEngine,
    *,
    inside: bool,
    skip: Iterable[str] = (),
    wish: PlacingWish = NO_WISH,
) -> SceneObject:
    """Return an object at rest on or in a receptacle; the state is not changed.

    Parameters
    ----------
    skip : iterable of str
        Objects that go with it.
    wish : PlacingWish
        What it shall lie beside, left of, between, ... on the same surface.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with what stood in the way at each place that was tried.
    """
    if thing.mount in ("wall", "ceiling"):
        raise refusal(
            f"{with_article(thing.name)} hangs on {with_article(thing.mount)}, it cannot be put anywhere else"
        )
    asset = state.asset(receptacle)
    ledges = [] if asset is None else ledges_of(asset, inside=inside)
    if asset is None or not ledges:
        what = "holds nothing inside" if inside else "has no surface that carries things"
        raise refusal(f"{receptacle.id} ({receptacle.name}) {what}")
    moving = {thing.id, *skip}
    holds = _wish_on(state, floor, thing, receptacle, wish)
    places = free_places(state.index(floor), receptacle, ledges, thing.size, moving, near=_goal(wish), admit=holds)
    if not places:
        if holds is None or not free_places(state.index(floor), receptacle, ledges, thing.size, moving):
            raise refusal(_no_room(thing, receptacle, ledges, inside=inside))
        raise refusal(_crowded(state.index(floor), thing, receptacle, wish))
    reasons: list[str] = []
    for place in places:
        problem = _problem(state, floor, thing, receptacle, asset, place, moving)
        result = engine.settle(problem)
        reason = _fault(result, problem, receptacle, place)
        if not reason:
            placed = _settled(thing, receptacle, place, result)
            if holds is None or fulfils(state.scenes[floor], _room_of(state, receptacle), placed, wish):
                return placed
            reason = f"it does not stay {wish_words(wish)}"
        reasons.append(reason)
    raise refusal(
        f"the {thing.name} does not come to rest {'in' if inside else 'on'} {receptacle.id}: "
        + "; ".join(dict.fromkeys(reasons))
    )


Admit: TypeAlias = Callable[["Place"], bool]
"""Whether a place on a ledge is one that a wish allows."""


def _wish_on(
    state: SceneState, floor: int, thing: SceneObject, receptacle: SceneObject, wish: PlacingWish
) -> Admit | None:
    """Return what tells the places of a wish, None where it leaves the place open."""
    if not wish.binding:
        return None
    if wish.spot or wish.side in ("under", "above"):
        where = f"{wish.spot} of a room" if wish.spot else wish.side
        raise refusal(f"{where!r} says nothing of a place on {receptacle.id}; give the id of a room")
    for mark in (wish.near, wish.other):
        if mark is not None and mark.parent != receptacle.id:
            raise refusal(f"{mark.id} is not on {receptacle.id}")
    scene = state.scenes[floor]
    room = _room_of(state, receptacle)

    def admit(place: Place) -> bool:
        x, y = to_floor(receptacle, (place.x, place.y))
        position = (x, y, receptacle.position[2] + place.ledge.z + thing.size[2] / 2)
        mount = "inside" if place.ledge.inside else "surface"
        turn = receptacle.rotation + place.turn
        there = {"position": position, "rotation": turn, "mount": mount, "parent": receptacle.id, "room": room.id}
        return fulfils(scene, room, msgspec.structs.replace(thing, **there), wish)

    return admit


def _room_of(state: SceneState, item: SceneObject) -> SceneRoom:
    found = state.room(item.room)
    if found is None:
        raise refusal(f"{item.id} is in {item.room!r}, which does not exist")
    return found[1]


def _goal(wish: PlacingWish) -> Point | None:
    """Return the point that a wish is about."""
    if wish.near is None:
        return None
    x, y, _ = wish.near.position
    if wish.other is None:
        return x, y
    return (x + wish.other.position[0]) / 2, (y + wish.other.position[1]) / 2


def _crowded(index: FloorIndex, thing: SceneObject, receptacle: SceneObject, wish: PlacingWish) -> str:
    """Say what leaves no place where a wish has it: what lies around there, and the edge."""
    goal = _goal(wish) or receptacle.position
    others = [item for item in index.children.get(receptacle.id, []) if item.id != thing.id and item != wish.near]
    others.sort(key=lambda item: (round(math.dist(item.position[:2], goal[:2]), 6), item.id))
    names = [item.id for item in others[:3]] + [f"the edge of {receptacle.id}"]
    w, d, _ = thing.size
    what = f"no free place for {with_article(thing.name)} ({w:.2f} x {d:.2f} m) {wish_words(wish)} on {receptacle.id}"
    return f"{what}: {', '.join(names)} {'is' if len(names) == 1 else 'are'} in the way"


def _no_room(thing: SceneObject, receptacle: SceneObject, ledges: list[Ledge], *, inside: bool) -> str:
    w, d, h = thing.size
    fitting = [
        ledge
        for ledge in ledges
        if h < ledge.headroom and max(w, d) <= max(ledge.w, ledge.d) and min(w, d) <= min(ledge.w, ledge.d)
    ]
    where = f"{'in' if inside else 'on'} {receptacle.id}"
    if fitting:
        return f"no free place for {with_article(thing.name)} ({w:.2f} x {d:.2f} m) {where}; remove something first"
    biggest = max(ledges, key=lambda ledge: ledge.w * ledge.d)
    return (
        f"{with_article(thing.name)} of {w:.2f} x {d:.2f} x {h:.2f} m does not fit {where}: its largest place is "
        f"{biggest.w:.2f} x {biggest.d:.2f} m, {biggest.clearance:.2f} m high"
    )


def _problem(
    state: SceneState,
    floor: int,
    thing: SceneObject,
    receptacle: SceneObject,
    asset: Asset,
    place: Place,
    moving: set[str],
) -> SettleProblem:
    ledge = place.ledge
    support = support_boxes(receptacle, asset, ledge, (place.x, place.y), half_diagonal(thing.size))
    top = max(box.center[2] + box.size[2] / 2 for box in support)
    x, y = to_floor(receptacle, (place.x, place.y))
    start = PosedBox((x, y, top + DROP + thing.size[2] / 2), thing.size, receptacle.rotation + place.turn)
    near = {}
    level = receptacle.position[2] + ledge.z
    for item in state.index(floor).objects:
        if item.id in moving or item.id == receptacle.id or item.parent != receptacle.id:
            continue
        foot = item.position[2] - item.size[2] / 2
        reach = half_diagonal(item.size) + half_diagonal(thing.size) + NEAR
        if abs(foot - level) < 0.02 and math.dist((x, y), item.position[:2]) < reach:
            near[item.id] = PosedBox(item.position, item.size, item.rotation)
    return SettleProblem(
        body=start,
        support=support,
        shell=receptacle_shell(receptacle, asset, ledge, thing.size),
        neighbours=dict(list(near.items())[:12]),
    )


def _fault(result: SettleResult, problem: SettleProblem, receptacle: SceneObject, place: Place) -> str:
    """Return why a pose is refused, empty for a good one."""
    if not result.at_rest:
        return "it does not come to rest"
    if result.tilt > MOST_TILT:
        return f"it tilts by {result.tilt:.0f} degrees"
    if result.penetration > MOST_PENETRATION:
        return f"it penetrates something by {1000 * result.penetration:.1f} mm"
    pushed = {name: way for name, way in result.pushed.items() if way > MOST_PUSH}
    if pushed:
        return f"it pushes {', '.join(pushed)}"
    x, y = to_local(receptacle, result.position)
    ledge = place.ledge
    on = abs(x - ledge.x) <= ledge.w / 2 and abs(y - ledge.y) <= ledge.d / 2
    start = problem.body
    fell = abs(result.position[2] - start.center[2] + DROP) > 0.02
    slid = math.dist(result.position[:2], start.center[:2]) > MOST_SLIDE
    return "it slides or falls off" if fell or slid or not on else ""


def _settled(thing: SceneObject, receptacle: SceneObject, place: Place, result: SettleResult) -> SceneObject:
    states = dict(thing.states)
    states.pop("temperature", None)
    if place.ledge.inside and receptacle.category in COOLING:
        states["temperature"] = "cold"
    x, y, z = (round(value, 4) for value in result.position)
    position: Point3 = (x, y, z)
    return msgspec.structs.replace(
        thing,
        room=receptacle.room,
        position=position,
        rotation=round(result.rotation % 360.0, 4),
        mount="inside" if place.ledge.inside else "surface",
        parent=receptacle.id,
        states=states,
    )


GAP = 0.008
"""Least distance between neighbours, metres."""

HAND = 0.05
"""Distance to neighbours that leaves room for a hand, metres."""

HEADROOM = 0.01
STEP = 0.02
"""Least distance between places that are tried, metres."""

EDGE = 0.01
BESIDE = 20.0
"""Cost of a metre from what an object shall lie beside."""

MOST_ROWS = 80
MOST_ON_LEDGE = 40


def ledges_of(asset: Asset, *, inside: bool) -> list[Ledge]:
    """Return the ledges on, or in, a receptacle; those at a good height for a hand first.

    Shelves count as both.
    """
    out = [
        Ledge(s.kind, False, s.x, s.y, s.z, s.w, s.d, s.clearance, s.round)
        for s in asset.surfaces
        if not inside or s.kind == "shelf"
    ]
    if inside:
        bare = asset.pickupable and not asset.openable
        out = [Ledge(v.kind, True, v.x, v.y, v.z - v.h / 2, v.w, v.d, v.h, vessel=bare) for v in asset.volumes] + out
    return out


def free_places(
    index: FloorIndex,
    receptacle: SceneObject,
    ledges: Sequence[Ledge],
    size: Point3,
    skip: Iterable[str] = (),
    most: int = 6,
    near: Sequence[float] | None = None,
    admit: Admit | None = None,
) -> list[Place]:
    """Return free places for an object, the best first.

    Parameters
    ----------
    size : (w, d, h)
        Of the object.
    skip : iterable of str
        Objects that are no obstacle, because they are what is being moved.
    most : int
        Greatest number of places, spread over ledges and over each ledge.
    near : (x, y), optional
        Point of the floor that the object shall lie close to.
    admit : callable, optional
        Whether a place may be taken; with it, places turned by all quarters are looked at.
    """
    landmark = None if near is None else to_local(receptacle, near)
    boxes = _obstacles(index, receptacle, {receptacle.id, *skip})
    found: list[Place] = []
    for order, ledge in enumerate(_by_height(ledges, receptacle)):
        if size[2] > ledge.headroom - HEADROOM:
            continue
        places = [
            place
            for turn in ((0.0, 90.0) if admit is None else (0.0, 90.0, 180.0, 270.0))
            for place in _on_ledge(ledge, boxes, size, turn, 0.4 * order + turn / 450.0, landmark, admit)
        ]
        places.sort(key=lambda p: p.cost)
        found += _apart(places, 3)
    found.sort(key=lambda p: p.cost)
    return found[:most]


def _by_height(ledges: Sequence[Ledge], receptacle: SceneObject) -> list[Ledge]:
    return sorted(ledges, key=lambda ledge: abs(receptacle.position[2] + ledge.z - 1.0))


def _obstacles(index: FloorIndex, receptacle: SceneObject, skip: set[str]) -> npt.NDArray[np.float64]:
    """Objects near a receptacle in its frame: x, y, half extents along its axes, lower and upper end."""
    ancestors = set(skip)
    above = receptacle.parent
    while above is not None and above not in ancestors and above in index.at:
        ancestors.add(above)
        above = index.objects[index.at[above]].parent
    boxes = index.boxes
    reach = math.hypot(receptacle.size[0], receptacle.size[1]) / 2 + 0.5
    spread = np.hypot(boxes[:, 3], boxes[:, 4]) / 2
    distance = np.hypot(boxes[:, 0] - receptacle.position[0], boxes[:, 1] - receptacle.position[1])
    rows = []
    for number in np.flatnonzero(distance < reach + spread):
        item = index.objects[int(number)]
        if item.id in ancestors:
            continue
        x, y = to_local(receptacle, item.position)
        turn = math.radians(item.rotation - receptacle.rotation)
        c, s = abs(math.cos(turn)), abs(math.sin(turn))
        z = item.position[2] - receptacle.position[2]
        rows.append(
            (
                x,
                y,
                (c * item.size[0] + s * item.size[1]) / 2,
                (s * item.size[0] + c * item.size[1]) / 2,
                z - item.size[2] / 2,
                z + item.size[2] / 2,
            )
        )
    return np.array(rows, dtype=float).reshape(-1, 6)


def _on_ledge(
    ledge: Ledge,
    boxes: npt.NDArray[np.float64],
    size: Point3,
    turn: float,
    handicap: float,
    landmark: Point | None = None,
    admit: Admit | None = None,
) -> list[Place]:
    hw, hd = (size[0] / 2, size[1] / 2) if turn % 180.0 == 0.0 else (size[1] / 2, size[0] / 2)
    rx, ry = ledge.w / 2 - hw - 0.002, ledge.d / 2 - hd - 0.002
    if rx < 0 or ry < 0:
        return []
    xs, ys = ledge.x + _steps(rx), ledge.y + _steps(ry)
    gx, gy = (grid.ravel() for grid in np.meshgrid(xs, ys))
    if ledge.round:
        ratio = np.hypot((np.abs(gx - ledge.x) + hw) / (ledge.w / 2), (np.abs(gy - ledge.y) + hd) / (ledge.d / 2))
        gx, gy = gx[ratio <= 1.0], gy[ratio <= 1.0]
    near = boxes[(boxes[:, 4] < ledge.z + size[2] + 0.002) & (boxes[:, 5] > ledge.z + 0.002)]
    gap = np.full(len(gx), 1.0)
    for x, y, half_w, half_d, _, _ in near:
        apart = np.maximum(np.abs(gx - x) - hw - half_w, np.abs(gy - y) - hd - half_d)
        gap = np.minimum(gap, apart)
    edge = np.minimum(ledge.w / 2 - np.abs(gx - ledge.x) - hw, ledge.d / 2 - np.abs(gy - ledge.y) - hd)
    front = ledge.y + ledge.d / 2 - hd - gy
    cost = (
        handicap
        + 2.0 * np.maximum(0.0, HAND - gap) / HAND
        + np.maximum(0.0, EDGE - edge) / EDGE * 0.5
        + np.abs(front - min(0.08, ry)) * 1.5
        + 0.3 * np.abs(gx - ledge.x)
    )
    if landmark is not None:
        cost += BESIDE * np.hypot(gx - landmark[0], gy - landmark[1])
    free = np.flatnonzero(gap >= GAP)
    order = free[np.argsort(cost[free], kind="stable")]
    places = (Place(ledge, float(gx[k]), float(gy[k]), turn, round(float(cost[k]), 6)) for k in order)
    return list(islice(places if admit is None else filter(admit, places), MOST_ON_LEDGE))


def _steps(reach: float) -> npt.NDArray[np.float64]:
    count = min(MOST_ROWS, int(2 * reach / STEP))
    return np.linspace(-reach, reach, count + 1) if count else np.zeros(1)


def _apart(places: Sequence[Place], most: int) -> list[Place]:
    """Keep the best places that are not all beside each other."""
    kept: list[Place] = []
    for place in places:
        if all(math.dist((place.x, place.y), (p.x, p.y)) > 0.1 for p in kept):
            kept.append(place)
        if len(kept) == most:
            break
    return kept


SLAB = 0.03
"""Thickness of what carries, metres."""

SOFT = ("seat", "mattress")
"""Kinds of surface whose mesh swells and sags."""

MOST_SWELL = 0.05
WALL = 0.01


def support_boxes(
    item: SceneObject, asset: Asset, ledge: Ledge, spot: tuple[float, float], reach: float
) -> list[PosedBox]:
    """Return the support below a ledge: a slab, and on soft tops the cushion below the object.

    Parameters
    ----------
    spot : (x, y)
        Where the object is to lie, in the receptacle's frame.
    reach : float
        Half diagonal of the object's rectangle, metres.
    """
    slab = Box((ledge.x, ledge.y, ledge.z - SLAB / 2), (ledge.w, ledge.d, SLAB))
    boxes = [_posed(item, slab)]
    if ledge.kind in SOFT:
        swell = _swell(item, asset, ledge, spot, reach)
        if swell > 1e-4:
            side = min(2 * reach, ledge.w), min(2 * reach, ledge.d)
            cushion = Box((*spot, ledge.z + swell / 2 - 0.01), (*side, swell + 0.02))
            boxes.append(_posed(item, cushion))
    return boxes


def _swell(item: SceneObject, asset: Asset, ledge: Ledge, spot: tuple[float, float], reach: float) -> float:
    """Height of the mesh above a ledge below an object, so that it lies on the cushion and not in it."""
    steps = np.linspace(-0.7 * reach, 0.7 * reach, 5)
    xs = np.clip(spot[0] + steps, ledge.x - ledge.w / 2, ledge.x + ledge.w / 2)
    ys = np.clip(spot[1] + steps, ledge.y - ledge.d / 2, ledge.y + ledge.d / 2)
    points = np.array([(x, y) for x in xs for y in ys])
    heights = _heights(asset, points, ledge.z - MOST_SWELL, ledge.z + MOST_SWELL)
    return float(max(0.0, heights.max() - ledge.z)) if heights.size else 0.0


def _heights(asset: Asset, points: npt.NDArray[np.float64], low: float, high: float) -> npt.NDArray[np.float64]:
    """Heights within [low, high] at which verticals through the points meet the mesh."""
    found = []
    for part in mesh(asset):
        corners = part.vertices[part.faces]
        a, b, c = (corners[:, k, :] for k in range(3))
        area: npt.NDArray[np.float64]
        area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
        flat = np.abs(area) > 1e-12
        a, b, c, area = a[flat], b[flat], c[flat], area[flat]
        for x, y in points:
            u = ((x - a[:, 0]) * (c[:, 1] - a[:, 1]) - (y - a[:, 1]) * (c[:, 0] - a[:, 0])) / area
            v = ((b[:, 0] - a[:, 0]) * (y - a[:, 1]) - (b[:, 1] - a[:, 1]) * (x - a[:, 0])) / area
            hit = (u >= 0) & (v >= 0) & (u + v <= 1)
            z = a[hit, 2] + u[hit] * (b[hit, 2] - a[hit, 2]) + v[hit] * (c[hit, 2] - a[hit, 2])
            found += z[(z >= low) & (z <= high)].tolist()
    return np.array(found)


def receptacle_shell(item: SceneObject, asset: Asset, ledge: Ledge, size: Point3) -> list[PosedBox]:
    """Return the boxes that an object on a ledge could run into.

    Notes
    -----
    Inside a container these are the walls of its inner box, its door open: the front is left free. Elsewhere they are
    the asset's collision boxes, less those that fill the room above the whole ledge, which stand for a hollow body.
    """
    if ledge.inside:
        return [_posed(item, wall) for wall in _walls(ledge)]
    return [
        _posed(item, box)
        for box in collision_boxes(asset)
        if box.center[2] + box.size[2] / 2 > ledge.z + 0.004
        and box.center[2] - box.size[2] / 2 < ledge.z + size[2] + 0.01
        and not _fills(box, ledge)
    ]


def _walls(ledge: Ledge) -> Sequence[Box]:
    middle = ledge.z + ledge.clearance / 2
    left, right = ledge.x - ledge.w / 2 - WALL / 2, ledge.x + ledge.w / 2 + WALL / 2
    upright = (WALL, ledge.d, ledge.clearance)
    return [
        Box((left, ledge.y, middle), upright),
        Box((right, ledge.y, middle), upright),
        Box((ledge.x, ledge.y - ledge.d / 2 - WALL / 2, middle), (ledge.w, WALL, ledge.clearance)),
    ]


def _fills(box: Box, ledge: Ledge) -> bool:
    over = [
        min(box.center[k] + box.size[k] / 2, center + extent / 2)
        - max(box.center[k] - box.size[k] / 2, center - extent / 2)
        for k, center, extent in ((0, ledge.x, ledge.w), (1, ledge.y, ledge.d))
    ]
    covered = max(0.0, over[0]) * max(0.0, over[1])
    through = box.center[2] - box.size[2] / 2 < ledge.z + 0.004
    return through and covered > 0.9 * ledge.w * ledge.d


def _posed(item: SceneObject, box: Box) -> PosedBox:
    x, y = to_floor(item, (box.center[0], box.center[1]))
    sizes = tuple(max(float(value), 1e-3) for value in box.size)
    return PosedBox((x, y, item.position[2] + box.center[2]), (sizes[0], sizes[1], sizes[2]), item.rotation)


def half_diagonal(size: Point3) -> float:
    """Return half the diagonal of an object's rectangle, metres."""
    return math.hypot(size[0], size[1]) / 2
