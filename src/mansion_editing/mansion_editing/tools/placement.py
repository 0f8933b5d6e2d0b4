"""PlaceOnSurface and PlaceInContainer: find a free place, settle the object by physics, check its pose."""

import math
from collections.abc import Callable, Iterable, Iterator

import msgspec
from shapely import LineString, Polygon, STRtree
from shapely.prepared import prep

from mansion_assets.catalogue import Asset
from mansion_assets.catalogue.palette import COLOURS
from mansion_editing.physics.engine import PhysicsEngine, PosedBox, SettleProblem, SettleResult
from mansion_editing.receptacles import (
    Ledge,
    Place,
    free_places,
    half_diagonal,
    ledges_of,
    receptacle_shell,
    support_boxes,
)
from mansion_editing.references import COLOUR_WORDS, colour_of, object_named
from mansion_editing.state import SceneState
from mansion_geometry.object_footprints import footprint, footprint_at
from mansion_msgs_py.editing import PlaceInContainerArgs, PlaceOnSurfaceArgs
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject, SceneRoom
from mansion_msgs_py.shapes import Point, Point3
from mansion_msgs_py.wording import with_article
from mansion_scene.decor.frames import room_polygon, scene_object, to_floor, to_local, wall_edges

__all__ = [
    "Accept",
    "COOLING",
    "free_floor_places",
    "place_in_container",
    "place_on_floor",
    "place_on_surface",
    "recoloured",
    "settle_on",
]


def recoloured(item: SceneObject, colour: str) -> SceneObject:
    """Return an object in a colour, as it is when the colour is its own or empty.

    Parameters
    ----------
    colour : str
        A word of `COLOUR_WORDS`.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for another word.

    Notes
    -----
    Exports paint the main material of the asset's mesh in the object's colour.
    """
    if not colour:
        return item
    name = COLOUR_WORDS.get(colour.lower())
    if name is None:
        known = ", ".join(sorted(set(COLOUR_WORDS.values())))
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, f"unknown colour {colour[:40]!r}; colours are {known}", path="$.color"
        )
    if colour_of(item.material) == name:
        return item
    family = item.material.split("_")[0] or "paint"
    return msgspec.structs.replace(item, material=f"{family}_{name}", color=COLOURS[name])


DOOR_DEPTH = 0.75
"""Depth of the area before a door that stays clear, metres."""

FRONT = 0.65
"""Free depth before the front of furniture, for a robot to stand in, metres."""

LOW = 0.03
STEP = 0.25
APART = 0.6
"""Distance between places that are judged, metres."""

MOST_REFUSED = 8
BACK_GAP = 0.01


Accept = Callable[[int, SceneObject], bool]
"""Whether the building stays free of new faults with an object on a floor."""


def place_on_floor(
    state: SceneState,
    asset: Asset,
    floor: int,
    room: SceneRoom,
    *,
    color: str = "",
    near: SceneObject | None = None,
    accept: Accept | None = None,
) -> SceneObject:
    """Put a new piece of furniture on the floor of a room, and return it; the state is left as it is.

    Parameters
    ----------
    near : SceneObject, optional
        What it shall stand beside.
    accept : callable, optional
        Judges a place; others are tried while it refuses.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` for what does not stand on floors, and where the room has no free place.
    """
    if asset.mount in ("wall", "ceiling"):
        raise MansionError(
            ErrorCode.INFEASIBLE, f"{with_article(asset.name)} hangs on {with_article(asset.mount)}, not on the floor"
        )
    new = scene_object(
        asset, state.new_id(floor, room.id, asset.category), room.id, (0.0, 0.0, asset.size[2] / 2), 0.0, mount="floor"
    )
    refused: list[Point] = []
    for x, y, rotation in free_floor_places(state, floor, room, new, near):
        if any(math.dist((x, y), other) < APART for other in refused):
            continue
        placed = scene_object(asset, new.id, room.id, (x, y, asset.size[2] / 2), rotation, mount="floor")
        placed = recoloured(placed, color)
        if accept is None or accept(floor, placed):
            return placed
        refused.append((x, y))
        if len(refused) == MOST_REFUSED:
            break
    w, d, _ = asset.size
    why = "keeps all rooms and objects within a robot's reach" if refused else "is free"
    raise MansionError(
        ErrorCode.INFEASIBLE,
        f"no place for {with_article(asset.name)} of {w:.2f} x {d:.2f} m in {room.id} {why}; remove something first",
    )


def free_floor_places(
    state: SceneState, floor: int, room: SceneRoom, thing: SceneObject, near: SceneObject | None = None
) -> Iterator[tuple[float, float, float]]:
    """Yield places (x, y, rotation) on the floor of a room: with the back to a wall first, then amid the room.

    Those next to `near` come first where it is given.
    """
    area = room_polygon(room.net_polygon, room.net_holes)
    inner = prep(area.buffer(1e-4))
    scene = state.scenes[floor]
    others = [
        footprint(item)
        for item in scene.objects
        if item.id != thing.id
        and item.room == room.id
        and item.parent is None
        and item.size[2] > LOW
        and item.position[2] - item.size[2] / 2 < thing.size[2] + 0.02
    ]
    doors = [
        LineString(door.segment).buffer(DOOR_DEPTH, cap_style="flat") for door in scene.doors if room.id in door.rooms
    ]
    furniture = STRtree(others)
    kept_clear = STRtree(doors)
    w, d, _ = thing.size
    poses = list(_poses(room, area, w, d))
    if near is not None:
        poses.sort(key=lambda pose: round(math.dist(pose[:2], near.position[:2]), 6))
    for x, y, rotation in poses:
        body = footprint_at((x, y), (w + 0.02, d), rotation)
        if not inner.covers(footprint_at((x, y), (w, d), rotation)):
            continue
        turn = math.radians(rotation)
        ahead = (d + FRONT) / 2
        before = footprint_at((x - math.sin(turn) * ahead, y + math.cos(turn) * ahead), (w, FRONT), rotation)
        if furniture.query(body, predicate="intersects").size:
            continue
        if kept_clear.query(body, predicate="intersects").size:
            continue
        if furniture.query(before, predicate="intersects").size or not inner.covers(before):
            continue
        yield x, y, rotation


def _poses(room: SceneRoom, area: Polygon, w: float, d: float) -> Iterator[tuple[float, float, float]]:
    for wall in wall_edges(room.net_polygon, room.net_holes):
        if wall.length < w:
            continue
        count = int((wall.length - w) / STEP)
        slack = wall.length - w
        offsets = [slack * k / max(1, count) for k in range(count + 1)]
        for offset in offsets:
            x, y = wall.point(offset + w / 2, d / 2 + BACK_GAP)
            yield x, y, wall.rotation
    x0, y0, x1, y1 = area.bounds
    turn = wall_edges(room.net_polygon)[0].rotation if len(room.net_polygon) > 2 else 0.0
    center: Point = (area.centroid.x, area.centroid.y)
    points = [
        (x0 + STEP * i, y0 + STEP * j)
        for i in range(int((x1 - x0) / STEP) + 1)
        for j in range(int((y1 - y0) / STEP) + 1)
    ]
    for x, y in sorted(points, key=lambda p: (round(math.dist(p, center), 6), p)):
        yield x, y, turn


MOST_PENETRATION = 0.002
MOST_TILT = 3.0
"""Degrees; scene objects are upright, so one that tilts more is refused."""

MOST_PUSH = 0.005
"""Metres that a neighbour may move."""

MOST_SLIDE = 0.03
DROP = 0.003
NEAR = 0.20
"""Neighbours within this distance take part in the physics, metres."""

COOLING = ("fridge", "freezer", "minibar", "display_fridge", "freezer_chest")
"""Containers that make cold what lies in them."""


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
    landmark = object_named(state, args.near, "$.near")[1] if args.near else None
    if room is not None:
        placed = place_on_floor(state, asset, *room, color=args.color, near=landmark, accept=accept)
        state.add(room[0], placed)
        return placed
    floor, receptacle = object_named(state, args.receptacle_id, "$.receptacle_id")
    return _place(state, asset, floor, receptacle, engine, inside=False, color=args.color, near=landmark)


def place_in_container(state: SceneState, args: PlaceInContainerArgs, engine: PhysicsEngine) -> SceneObject:
    """Put a new object into a container, its door open while it is placed.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown asset or container, ``INFEASIBLE`` with the reason where it finds no place.
    """
    asset = state.catalogue.asset(args.asset_id)
    floor, container = object_named(state, args.container_id, "$.container_id")
    return _place(state, asset, floor, container, engine, inside=True, color=args.color)


def _place(
    state: SceneState,
    asset: Asset,
    floor: int,
    receptacle: SceneObject,
    engine: PhysicsEngine,
    *,
    inside: bool,
    color: str = "",
    near: SceneObject | None = None,
) -> SceneObject:
    if asset.mount in ("wall", "ceiling"):
        raise _refusal(
            f"{with_article(asset.name)} hangs on {with_article(asset.mount)}, it cannot be put anywhere else"
        )
    new = scene_object(
        asset,
        state.new_id(floor, receptacle.room, asset.category),
        receptacle.room,
        receptacle.position,
        receptacle.rotation,
    )
    new = recoloured(new, color)
    placed = settle_on(state, new, floor, receptacle, engine, inside=inside, near=near)
    state.add(floor, placed)
    return placed


def settle_on(
    state: SceneState,
    thing: SceneObject,
    floor: int,
    receptacle: SceneObject,
    engine: PhysicsEngine,
    *,
    inside: bool,
    skip: Iterable[str] = (),
    near: SceneObject | None = None,
) -> SceneObject:
    """Return an object at rest on or in a receptacle; the state is not changed.

    Parameters
    ----------
    skip : iterable of str
        Objects that go with it.
    near : SceneObject, optional
        What it shall lie beside.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with what stood in the way at each place that was tried.
    """
    asset = state.asset(receptacle)
    ledges = [] if asset is None else ledges_of(asset, inside=inside)
    if asset is None or not ledges:
        what = "holds nothing inside" if inside else "has no surface that carries things"
        raise _refusal(f"{receptacle.id} ({receptacle.name}) {what}")
    moving = {thing.id, *skip}
    places = free_places(
        state.index(floor), receptacle, ledges, thing.size, moving, near=None if near is None else near.position[:2]
    )
    if not places:
        raise _refusal(_no_room(thing, receptacle, ledges, inside=inside))
    reasons: list[str] = []
    for place in places:
        problem = _problem(state, floor, thing, receptacle, asset, place, moving)
        result = engine.settle(problem)
        reason = _fault(result, problem, receptacle, place)
        if not reason:
            return _settled(thing, receptacle, place, result)
        reasons.append(reason)
    raise _refusal(
        f"the {thing.name} does not come to rest {'in' if inside else 'on'} {receptacle.id}: "
        + "; ".join(dict.fromkeys(reasons))
    )


def _refusal(message: str) -> MansionError:
    return MansionError(ErrorCode.INFEASIBLE, message)


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
