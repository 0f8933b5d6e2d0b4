"""An object laid on or into a receptacle: a free place, physics until it rests, and a look at where it came to rest."""

import math

import msgspec

from mansion_assets.catalogue import Asset
from mansion_editing.physics.engine import PhysicsEngine, PosedBox, SettleProblem, SettleResult
from mansion_editing.state import FloorIndex, SceneState
from mansion_editing.tools.destinations import AtReceptacle
from mansion_editing.tools.ledges import Admit, Ledge, Place, free_places
from mansion_editing.tools.placing_wishes import hangs, refusal, wish_words
from mansion_editing.tools.receptacle_bodies import half_diagonal, receptacle_shell, support_boxes
from mansion_editing.tools.relations import PlacingWish, fulfils
from mansion_editing.tools.tops import places_on
from mansion_msgs_py.scene import SceneObject, SceneRoom
from mansion_msgs_py.shapes import Point, Point3
from mansion_msgs_py.wording import with_article
from mansion_scene.decor.frames import to_floor, to_local

__all__ = ["COOLING", "settle_on"]

COOLING = ("fridge", "freezer", "minibar", "display_fridge", "freezer_chest")
"""Containers that make cold what lies in them."""

MOST_PENETRATION = 0.002
MOST_TILT = 3.0
"""Degrees; scene objects are upright, so one that tilts more is refused."""

MOST_PUSH = 0.005
"""Metres that a neighbour may move."""

MOST_SLIDE = 0.03
DROP = 0.003
NEAR = 0.20
"""Neighbours within this distance take part in the physics, metres."""


def settle_on(state: SceneState, thing: SceneObject, where: AtReceptacle, engine: PhysicsEngine) -> SceneObject:
    """Return an object at rest on or in a receptacle; the state is not changed.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with what stood in the way at each place that was tried.
    """
    if thing.mount in ("wall", "ceiling"):
        raise hangs(thing, "it cannot be put anywhere else")
    floor, receptacle, inside, wish = where.floor, where.receptacle, where.inside, where.wish
    asset = state.asset(receptacle)
    ledges = [] if asset is None else places_on(asset, inside=inside)
    if asset is None or not ledges:
        what = "holds nothing inside" if inside else "has no surface that carries things"
        raise refusal(f"{receptacle.id} ({receptacle.name}) {what}")
    moving = {thing.id, *where.companions}
    holds = _admission(state, thing, where)
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


def _admission(state: SceneState, thing: SceneObject, where: AtReceptacle) -> Admit | None:
    """Return what tells the places of a wish, None where it leaves the place open."""
    receptacle, wish = where.receptacle, where.wish
    if not wish.binding:
        return None
    if wish.spot or wish.side in ("under", "above"):
        part = f"{wish.spot} of a room" if wish.spot else wish.side
        raise refusal(f"{part!r} says nothing of a place on {receptacle.id}; give the id of a room")
    for mark in (wish.near, wish.other):
        beside = mark is not None and mark.mount == "floor" and mark.id != receptacle.id
        if mark is not None and mark.parent != receptacle.id and not beside:
            raise refusal(f"{mark.id} is not on {receptacle.id}")
    scene = state.scenes[where.floor]
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
        foot = item.bottom
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
