"""Making room on a full surface: one loose thing moves elsewhere in the room so that the new one fits."""

from collections.abc import Generator
from typing import Final

from mansion_editing.agent.choosing import place_any
from mansion_editing.agent.facts import Scope, Thing
from mansion_editing.agent.looking import look_at
from mansion_editing.agent.protocol import Action, Outcome
from mansion_editing.agent.surfaces import relation_of, surfaces_of
from mansion_editing.packing import free_places, ledges_of
from mansion_editing.state import SceneState
from mansion_msgs_py.editing import AssetInfo, ObjectInfo
from mansion_msgs_py.shapes import Point3

__all__ = ["free_up", "make_room"]

MOST_TARGETS: Final = 6


def make_room(
    thing: Thing, assets: list[AssetInfo], carrier: ObjectInfo, state: SceneState
) -> Generator[Action, Outcome, str]:
    """Move one thing away and place the new one; return its id, empty when that cannot be."""
    serving = yield from free_up(thing.noun, [asset.size for asset in assets], carrier, state)
    if serving is None:
        return ""
    relation = relation_of("on", carrier, state)
    fitting = [asset for asset in assets if asset.size == serving]
    placed = yield from place_any(fitting, carrier.id, relation, colour=thing.colour)
    return placed[0]


def free_up(
    noun: str, sizes: list[Point3], carrier: ObjectInfo, state: SceneState
) -> Generator[Action, Outcome, Point3 | None]:
    """Move the one thing whose place is enough to another surface of the room; return the size that fits then.

    What this instruction has touched stays, and only one thing makes room for an instruction.
    """
    touched = {change.id for change in state.pending}
    if any(change.before is not None and change.after is not None for change in state.pending):
        return None
    there = yield from look_at(carrier, relation_of("on", carrier, state))
    for item in [] if isinstance(there, str) else there:
        found = state.find(item.id)
        if found is None or item.id in touched or not found[1].pickupable:
            continue
        if state.subtree(*found)[1:] or state.vocabulary.rank(found[1], noun) >= 2:
            continue
        size = next((size for size in sizes if _fits_without(size, carrier, item, state)), None)
        if size is None:
            continue
        targets = yield from surfaces_of(Scope("room", "", (item.room,)), state)
        for target in [] if isinstance(targets, str) else targets[:MOST_TARGETS]:
            if target == carrier.id:
                continue
            answer = yield Action(
                f"{item.id} stands where the {noun} shall be.",
                "MoveObject",
                {"object_id": item.id, "receptacle_id": target},
            )
            if answer.error is None:
                return size
    return None


def _fits_without(size: Point3, carrier: ObjectInfo, item: ObjectInfo, state: SceneState) -> bool:
    found = state.find(carrier.id)
    kind = state.catalogue.assets.get(carrier.asset_id)
    if found is None or kind is None:
        return False
    ledges = ledges_of(kind, inside=False)
    return bool(free_places(state.index(found[0]), found[1], ledges, size, {item.id}))
