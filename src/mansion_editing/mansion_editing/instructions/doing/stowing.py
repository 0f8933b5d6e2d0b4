"""Move of things that are put away: each into furniture of its room that such things are kept in."""

from typing import Final

from mansion_editing.instructions.doing.work import Done, Work, listed, live, whereabouts
from mansion_editing.instructions.meaning.choices import things_meant
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.nouns import is_loose, names_many
from mansion_editing.instructions.statements import Move
from mansion_editing.provisioning.usual_places import usual_receptacles
from mansion_editing.runs.policies import Action, Unmet
from mansion_editing.state import SceneState
from mansion_msgs_py.scene import SceneObject

__all__ = ["is_stowed", "stow"]

_KEEPING: Final = (
    "cabinet", "wardrobe", "nightstand", "dresser", "sideboard", "chest", "drawer", "locker", "kitchen_counter",
    "kitchen_island", "service_station", "card_catalog", "crash_cart", "medicine_cart", "media_console", "cubbies",
)  # fmt: skip
"""Ends of the categories of furniture that keeps things out of sight."""


def stow(statement: Move, state: SceneState, context: Context) -> Work:
    """Put things away in their own room; refused where that has nothing to keep them in."""
    items = things_meant(state, statement.things, context)
    items = [item for item in items if is_loose(item)] if names_many(statement.things.noun) else items
    ids: list[str] = []
    replies: list[str] = []
    for item in items:
        if is_stowed(item, state):
            ids.append(item.id)
            replies.append(f"{item.id} is {whereabouts(item)} already")
            continue
        stores = _stores_for(item, state)
        if not is_loose(item) or not stores:
            raise Unmet(f"say where {item.id} shall go: {item.room} has no furniture to put it away in")
        reason = ""
        for store in stores:
            arguments = {"object_id": item.id, "receptacle_id": store.id, **_inside(store, state)}
            answer = yield Action(f"{item.id} should be put away.", "MoveObject", arguments)
            if answer.error is None:
                (now,) = live(state, [item.id])
                ids.append(item.id)
                replies.append(f"{item.id} moved from {whereabouts(item).removeprefix('in ')} to {now.parent}")
                break
            reason = reason or answer.error.info.message
        else:
            raise Unmet(f"{listed(stores)} cannot take {item.id}: {reason}")
    rooms = tuple(dict.fromkeys(item.room for item in items))
    return Done("; ".join(replies), context.followed(ids, rooms, statement.things.noun))


def is_stowed(item: SceneObject, state: SceneState) -> bool:
    """Whether a thing is in furniture, or where such things are usually kept."""
    found = None if item.parent is None else state.find(item.parent)
    return (
        found is not None and _keeps(found[1], item, state) and (item.mount == "inside" or _is_shelf(found[1], state))
    )


def _stores_for(item: SceneObject, state: SceneState) -> list[SceneObject]:
    """Return the furniture of a thing's room that may keep it: where such things usually are first."""
    there = [other for _, other in state.objects() if other.room == item.room and other.id != item.id]
    usual = usual_receptacles(state.catalogue, (item.category,))
    stores = [other for other in there if _keeps(other, item, state)]
    return sorted(stores, key=lambda other: (other.category not in usual, not other.openable))


def _keeps(store: SceneObject, item: SceneObject, state: SceneState) -> bool:
    """Whether furniture keeps things of a kind: behind doors or in drawers, or on shelves where they usually are."""
    asset = state.asset(store)
    if asset is None or store.mount not in ("floor", "wall"):
        return False
    usual = store.category in usual_receptacles(state.catalogue, (item.category,))
    inward = bool(asset.volumes) and (store.category.endswith(_KEEPING) or (usual and store.openable))
    return inward or (usual and _is_shelf(store, state))


def _is_shelf(store: SceneObject, state: SceneState) -> bool:
    asset = state.asset(store)
    return asset is not None and not asset.volumes and any(surface.kind == "shelf" for surface in asset.surfaces)


def _inside(store: SceneObject, state: SceneState) -> dict[str, bool]:
    asset = state.asset(store)
    return {"inside": True} if asset is not None and asset.volumes else {}
