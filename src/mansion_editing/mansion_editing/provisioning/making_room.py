"""Make room on a full receptacle by moving one small object elsewhere in the room."""

from collections.abc import Generator, Set
from typing import Final

from mansion_assets.catalogue.vocabulary import vocabulary_of
from mansion_editing.provisioning.facts import ObjectDescription, Scope
from mansion_editing.provisioning.new_objects import place_any
from mansion_editing.provisioning.object_search import list_contents
from mansion_editing.provisioning.usual_places import find_surfaces, relation_of
from mansion_editing.runs.policies import Action, Outcome
from mansion_editing.state import Change, SceneState
from mansion_editing.tools.ledges import free_places, ledges_of
from mansion_msgs_py.editing.changes import ObjectChange
from mansion_msgs_py.editing.questions import AssetInfo, ObjectInfo
from mansion_msgs_py.shapes import Point3

__all__ = ["make_room", "move_after_clearing"]


def moved_to(item: ObjectInfo, target: str, thought: str) -> Generator[Action, Outcome, str]:
    """Move an object, and return why it cannot be moved there, empty when it was."""
    answer = yield Action(thought, "MoveObject", {"object_id": item.id, "receptacle_id": target})
    return "" if answer.error is None else answer.error.info.message


def move_after_clearing(
    item: ObjectInfo, target: str, reason: str, state: SceneState
) -> Generator[Action, Outcome, str]:
    """Move an object to a full surface after clearing a place on it; return why that fails, empty when it does not."""
    carriers = yield from _carrier(target)
    found = state.find(item.id)
    if not carriers or found is None:
        return reason
    freed = yield from _free_up(item.name, [found[1].size], carriers[0], state)
    if freed is None:
        return reason
    return (yield from moved_to(item, target, f"{target} has room for {item.id} now."))


def _carrier(object_id: str) -> Generator[Action, Outcome, list[ObjectInfo]]:
    answer = yield Action(f"What is {object_id}?", "ListObjects", {"id": object_id})
    return [] if answer.error is not None else answer.value.objects


MOST_TARGETS: Final = 6


def make_room(
    thing: ObjectDescription,
    assets: list[AssetInfo],
    carrier: ObjectInfo,
    state: SceneState,
    staying: Set[str] = frozenset(),
    relation: str = "on",
) -> Generator[Action, Outcome, str]:
    """Clear a place on, or in, a full receptacle for a new object and return its id, empty when that fails.

    Parameters
    ----------
    staying : set of str
        Ids of what does not make room.
    relation : {"on", "in"}
    """
    relation = relation_of(relation, carrier, state)
    serving = yield from _free_up(thing.noun, [asset.size for asset in assets], carrier, state, staying, relation)
    if serving is None:
        return ""
    fitting = [asset for asset in assets if asset.size == serving]
    made, _ = yield from place_any(fitting, carrier.id, relation, colour=thing.colour)
    return made


def _free_up(
    noun: str,
    sizes: list[Point3],
    carrier: ObjectInfo,
    state: SceneState,
    staying: Set[str] = frozenset(),
    relation: str = "on",
) -> Generator[Action, Outcome, Point3 | None]:
    """Move one object to another surface of the room, and return the size that fits in its place.

    What this instruction has touched stays, and only one thing makes room for an instruction.
    """
    touched = {change.id for change in state.pending} | staying
    if any(_is_elsewhere(change) for change in state.pending):
        return None
    relation = relation_of(relation, carrier, state)
    for item in (yield from list_contents(carrier, relation)):
        found = state.find(item.id)
        if found is None or item.id in touched or not found[1].pickupable:
            continue
        if state.subtree(*found)[1:] or vocabulary_of(state.catalogue).rank(found[1], noun) >= 2:
            continue
        inside = relation == "in"
        size = next((size for size in sizes if _fits_without(size, carrier, item, state, inside=inside)), None)
        if size is None:
            continue
        targets = yield from find_surfaces(Scope("room", "", (item.room,)), state)
        for target in targets[:MOST_TARGETS]:
            if target == carrier.id:
                continue
            if not (yield from moved_to(item, target, f"{item.id} makes room for the {noun}.")):
                return size
    return None


def _is_elsewhere(change: Change) -> bool:
    """Whether a change moved an object that was there before."""
    if not isinstance(change, ObjectChange) or change.before is None or change.after is None:
        return False
    return change.before.position != change.after.position


def _fits_without(size: Point3, carrier: ObjectInfo, item: ObjectInfo, state: SceneState, *, inside: bool) -> bool:
    found = state.find(carrier.id)
    kind = state.catalogue.assets.get(carrier.asset_id)
    if found is None or kind is None:
        return False
    ledges = ledges_of(kind, inside=inside)
    return bool(free_places(state.index(found[0]), found[1], ledges, size, {item.id}))
