"""Making room on a full surface: one loose thing moves elsewhere in the room so that the new one fits."""

from collections.abc import Generator
from typing import Final

from mansion_msgs_py.editing import AssetInfo, ObjectInfo
from mansion_scene.editing.agent.choosing import place_any
from mansion_scene.editing.agent.facts import Scope, Thing
from mansion_scene.editing.agent.looking import look_at
from mansion_scene.editing.agent.protocol import Action, Outcome
from mansion_scene.editing.agent.surfaces import relation_of, surfaces_of
from mansion_scene.editing.packing import free_places, ledges_of
from mansion_scene.editing.state import SceneState

__all__ = ["make_room"]

MOST_TARGETS: Final = 6


def make_room(
    thing: Thing, assets: list[AssetInfo], carrier: ObjectInfo, state: SceneState
) -> Generator[Action, Outcome, str]:
    """Move the one thing whose place is enough, and place the new one; return its id, empty when there is none.

    What this instruction has touched stays, and only one thing moves for an instruction.
    """
    touched = {change.id for change in state.pending}
    if any(change.before is not None and change.after is not None for change in state.pending):
        return ""
    relation = relation_of("on", carrier, state)
    there = yield from look_at(carrier, relation)
    if isinstance(there, str):
        return ""
    for item in there:
        found = state.find(item.id)
        if (
            found is None
            or item.id in touched
            or not found[1].pickupable
            or state.subtree(*found)[1:]
        ):
            continue
        serving = [asset for asset in assets if _fits_without(asset, carrier, item, state)]
        if not serving or item.category == serving[0].category:
            continue
        targets = yield from surfaces_of(Scope("room", "", (item.room,)), state)
        if isinstance(targets, str):
            return ""
        for target in [name for name in targets if name != carrier.id][:MOST_TARGETS]:
            answer = yield Action(
                f"{item.id} stands where the {thing.noun} shall be.",
                "MoveObject",
                {"object_id": item.id, "receptacle_id": target},
            )
            if answer.error is not None:
                continue
            placed = yield from place_any(serving, carrier.id, relation, colour=thing.colour)
            return placed[0]
    return ""


def _fits_without(
    asset: AssetInfo, carrier: ObjectInfo, item: ObjectInfo, state: SceneState
) -> bool:
    found = state.find(carrier.id)
    kind = state.catalogue.assets.get(carrier.asset_id)
    if found is None or kind is None:
        return False
    ledges = ledges_of(kind, inside=False)
    return bool(free_places(state.index(found[0]), found[1], ledges, asset.size, {item.id}))
