"""SwapObjects: two objects change places, each with what it carries."""

import math
from collections.abc import Callable, Collection, Mapping
from typing import TypeAlias

import msgspec

from mansion_editing.physics.engine import PhysicsEngine
from mansion_editing.state import SceneState
from mansion_editing.tools.destinations import AtReceptacle
from mansion_editing.tools.manipulation import at_point, relocate
from mansion_editing.tools.perception import object_named
from mansion_editing.tools.placing_wishes import refusal
from mansion_editing.tools.relations import PlacingWish
from mansion_editing.tools.resting import settle_on
from mansion_geometry.plane import turned
from mansion_msgs_py.editing.objects import SwapObjectsArgs
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene, SceneObject
from mansion_msgs_py.wording import with_article

__all__ = ["Judge", "swap_objects"]

Judge: TypeAlias = Callable[[Mapping[int, FloorScene], Mapping[int, FloorScene]], bool]
"""Gets the floors before and after, and tells whether the building is as sound as before."""

ASIDE = 0.15
"""Greatest distance on a surface from the middle of what lay there, metres."""


def swap_objects(
    state: SceneState, args: SwapObjectsArgs, engine: PhysicsEngine, judge: Judge | None = None
) -> tuple[SceneObject, SceneObject]:
    """Exchange the places of two objects; the state is left half changed where it raises.

    Parameters
    ----------
    judge : callable, optional
        Judges the building afterwards.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for one object twice, ``INFEASIBLE`` where either does not fit into the other's place.

    Notes
    -----
    On floors and walls the pose is taken over, backs in line, then middles, then fronts; on surfaces and in containers
    each settles where the other lay.
    """
    floor, one = object_named(state, args.object_id, "$.object_id")
    second, other = object_named(state, args.other_id, "$.other_id")
    if one.id == other.id:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{one.id} is named twice", path="$.other_id")
    members = [member.id for member in state.subtree(floor, one)]
    others = [member.id for member in state.subtree(second, other)]
    if other.id in members or one.id in others:
        raise refusal(f"one of {one.id} and {other.id} carries the other")
    before = dict(state.scenes)
    moved = _instead_of(state, engine, second, one, other, {*members, *others})
    moved = relocate(state, floor, one, second, moved)
    returned = _instead_of(state, engine, floor, other, one, set(others))
    returned = relocate(state, second, other, floor, returned)
    if judge is not None and not judge(before, state.scenes):
        raise refusal(
            f"with {one.id} and {other.id} exchanged, objects would overlap, block a door or stand in a robot's way"
        )
    return moved, returned


def _instead_of(
    state: SceneState, engine: PhysicsEngine, floor: int, item: SceneObject, there: SceneObject, skip: Collection[str]
) -> SceneObject:
    """Return an object in the place that another had."""
    fixed = {mount for mount in (item.mount, there.mount) if mount in ("wall", "ceiling")}
    if fixed and item.mount != there.mount:
        raise refusal(f"{item.id} cannot take the place of {there.id}: one of them hangs on {with_article(*fixed)}")
    if there.mount in ("surface", "inside") and there.parent is not None:
        _, receptacle = state.get(there.parent)
        goal = PlacingWish(near=there)
        where = AtReceptacle(floor, receptacle, inside=there.mount == "inside", wish=goal, companions=skip)
        placed = settle_on(state, item, where, engine)
        if math.dist(placed.position[:2], there.position[:2]) > ASIDE:
            raise refusal(f"{receptacle.id} does not have enough room for {item.id} where {there.id} is")
        return placed
    reasons: list[str] = []
    for aside, shift in _shifts(item, there):
        dx, dy = turned(aside, shift, there.rotation)
        posed = msgspec.structs.replace(
            item, room=there.room, mount=there.mount, parent=there.parent, position=_at_height(item, there)
        )
        x, y = there.position[0] + dx, there.position[1] + dy
        try:
            return at_point(state, x, y, there.rotation, floor, posed, skip)
        except MansionError as error:
            reasons.append(error.info.message)
    raise refusal(f"{item.id} does not fit into the place of {there.id}: " + "; ".join(dict.fromkeys(reasons)))


def _shifts(item: SceneObject, there: SceneObject) -> list[tuple[float, float]]:
    """Return how far an object may stand beside the middle of another's place: to a side where it is wider."""
    deeper = (item.size[1] - there.size[1]) / 2
    wider = max(0.0, (item.size[0] - there.size[0]) / 2)
    return [
        (aside, shift)
        for aside in dict.fromkeys((0.0, wider, -wider))
        for shift in dict.fromkeys((deeper, 0.0, -deeper))
    ]


def _at_height(item: SceneObject, there: SceneObject) -> tuple[float, float, float]:
    """Return the place of another object: feet level on floors, tops on ceilings, middles on walls."""
    x, y, z = there.position
    apart = (item.size[2] - there.size[2]) / 2
    lift = {"floor": apart, "ceiling": -apart}.get(there.mount, 0.0)
    return x, y, round(max(z + lift, item.size[2] / 2), 4)
