"""Make room on a full receptacle: small objects move aside on it, or one of them goes elsewhere in the room."""

from collections.abc import Generator, Set
from typing import Final

from mansion_assets.catalogue.vocabulary import vocabulary_of
from mansion_editing.provisioning.facts import ObjectDescription, Scope
from mansion_editing.provisioning.new_objects import place_any
from mansion_editing.provisioning.object_search import list_contents
from mansion_editing.provisioning.usual_places import find_surfaces, relation_of
from mansion_editing.runs.policies import Action, Outcome
from mansion_editing.state import Change, SceneState
from mansion_editing.tools.ledges import free_places
from mansion_editing.tools.rearranging import shifts_for
from mansion_editing.tools.tops import places_on
from mansion_msgs_py.editing.changes import ObjectChange
from mansion_msgs_py.editing.questions import AssetInfo, ObjectInfo
from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.shapes import Point3

__all__ = ["make_room", "move_after_clearing"]


def moved_to(object_id: str, target: str, thought: str) -> Generator[Action, Outcome, str]:
    """Move an object, and return why it cannot be moved there, empty when it was."""
    answer = yield Action(thought, "MoveObject", {"object_id": object_id, "receptacle_id": target})
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
    return (yield from moved_to(item.id, target, f"{target} has room for {item.id} now."))


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
    """Move objects aside, or one to another surface of the room, and return the size that fits in its place.

    What this instruction has touched stays, and only one thing leaves its surface for each new one.
    """
    touched = {change.id for change in state.pending}
    relation = relation_of(relation, carrier, state)
    inside = relation == "in"
    there = yield from list_contents(carrier, relation)
    loose = [found for item in there if item.id not in touched and (found := state.find(item.id)) is not None]
    loose = [found for found in loose if found[1].mount != "floor" and not state.subtree(*found)[1:]]
    size = yield from _shifted_aside(noun, sizes, carrier, [item for _, item in loose], state, inside=inside)
    if size is not None:
        return size
    new = sum(isinstance(change, ObjectChange) and change.before is None for change in state.pending)
    if sum(_is_elsewhere(change) for change in state.pending) > new:
        return None
    for _, item in loose:
        if item.id in staying or not item.pickupable or vocabulary_of(state.catalogue).rank(item, noun) >= 2:
            continue
        size = next((size for size in sizes if _fits_without(size, carrier, item.id, state, inside=inside)), None)
        if size is None:
            continue
        targets = yield from find_surfaces(Scope("room", "", (item.room,)), state)
        for target in targets[:MOST_TARGETS]:
            if target == carrier.id:
                continue
            if not (yield from moved_to(item.id, target, f"{item.id} makes room for the {noun}.")):
                return size
    return None


def _shifted_aside(
    noun: str, sizes: list[Point3], carrier: ObjectInfo, loose: list[SceneObject], state: SceneState, *, inside: bool
) -> Generator[Action, Outcome, Point3 | None]:
    """Shift what lies on a surface aside on it, and return the size that fits then, None where that is not enough."""
    found, kind = state.find(carrier.id), state.catalogue.assets.get(carrier.asset_id)
    if found is None or kind is None or not loose:
        return None
    for size in sizes:
        for ledge in places_on(kind, inside=inside):
            shifts = shifts_for(state.index(found[0]), found[1], ledge, size, loose)
            for name, (x, y) in shifts or []:
                arguments = {"object_id": name, "x": round(x, 4), "y": round(y, 4)}
                answer = yield Action(f"{name} moves aside for the {noun}.", "MoveObject", arguments)
                if answer.error is not None:
                    return None
            if shifts:
                return size
    return None


def _is_elsewhere(change: Change) -> bool:
    """Whether a change brought an object that was there before to another carrier."""
    if not isinstance(change, ObjectChange) or change.before is None or change.after is None:
        return False
    return change.before.parent != change.after.parent or change.before.room != change.after.room


def _fits_without(size: Point3, carrier: ObjectInfo, item: str, state: SceneState, *, inside: bool) -> bool:
    found = state.find(carrier.id)
    kind = state.catalogue.assets.get(carrier.asset_id)
    if found is None or kind is None:
        return False
    return bool(free_places(state.index(found[0]), found[1], places_on(kind, inside=inside), size, {item}))
