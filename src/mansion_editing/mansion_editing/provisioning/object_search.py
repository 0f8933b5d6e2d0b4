"""Find the objects, receptacles and rooms that a fact means, with the editor's tools."""

from collections.abc import Generator

from mansion_assets.catalogue.vocabulary import stems, vocabulary_of
from mansion_editing.provisioning.facts import ObjectDescription, Scope
from mansion_editing.runs.policies import Action, Outcome, ask
from mansion_editing.state import SceneState
from mansion_editing.tools.resting import COOLING
from mansion_language.colours import colour_of
from mansion_msgs_py.editing.questions import ObjectInfo, ObjectList, ReceptacleReport

__all__ = ["ObjectSearch", "exactly_named", "find_objects", "list_contents", "matches", "receptacles", "rooms_of"]

ObjectSearch = Generator[Action, Outcome, list[ObjectInfo]]
"""Ends with the objects found."""


def matches(thing: ObjectDescription, item: ObjectInfo, state: SceneState) -> bool:
    """Whether an object fits a description."""
    if thing.noun and thing.noun != item.id:
        scene_object = state.find(item.id)
        ends = "_" in thing.noun and item.id.endswith(f"/{thing.noun}")
        if not ends and (scene_object is None or vocabulary_of(state.catalogue).rank(scene_object[1], thing.noun) < 2):
            return False
    if thing.colour:
        material = state.find(item.id)
        if material is None or colour_of(material[1].material) != thing.colour:
            return False
    return not thing.cold or item.states.get("temperature") == "cold" or _is_cooled(item, state)


def _is_cooled(item: ObjectInfo, state: SceneState) -> bool:
    parent = state.find(item.parent or "")
    return parent is not None and item.mount == "inside" and parent[1].category in COOLING


def receptacles(where: Scope, state: SceneState) -> ObjectSearch:
    """Find the receptacles of a scope."""
    if not where.receptacle:
        return []
    found = yield from _listed(where, where.receptacle, 200, f"Which {where.receptacle} is there")
    mine = [i for i in found if matches(ObjectDescription(where.receptacle, 0, where.colour), i, state)]
    if stems(where.receptacle)[-1:] == (where.receptacle.lower().rpartition(" ")[2],):
        mine = exactly_named(where.receptacle, mine) or mine
    return [i for i in mine if not where.base or _is_on(i, where.base, state)]


def _listed(where: Scope, keyword: str, limit: int, question: str) -> ObjectSearch:
    """List the objects that a keyword names in the rooms, or on the floor, of a scope."""
    found: list[ObjectInfo] = []
    for room in where.rooms or ("",):
        arguments = {"room": room, "keyword": keyword, "limit": limit}
        listed: ObjectList = yield from ask(f"{question}{f' in {room}' if room else ''}?", "ListObjects", arguments)
        found += listed.objects
    return [i for i in found if where.floor in (None, i.floor)]


def exactly_named(noun: str, items: list[ObjectInfo]) -> list[ObjectInfo]:
    """Return the objects whose whole name is the noun: of a fridge and a display fridge, the fridge."""
    words = stems(noun)
    return [i for i in items if stems(i.category.replace("_", " ")) == words]


def _is_on(item: ObjectInfo, base: str, state: SceneState) -> bool:
    found = state.find(item.parent or "")
    return found is not None and (found[1].id == base or vocabulary_of(state.catalogue).rank(found[1], base) >= 2)


def list_contents(receptacle: ObjectInfo, relation: str) -> ObjectSearch:
    """List the objects on or in a receptacle."""
    tool = "SearchContents" if relation == "in" else "CheckSurface"
    report: ReceptacleReport = yield from ask(f"What is {relation} {receptacle.id}?", tool, {"id": receptacle.id})
    return report.receptacles[0].objects


def find_objects(thing: ObjectDescription, where: Scope, state: SceneState) -> ObjectSearch:
    """Find the objects in a scope that fit a description."""
    if not where.receptacle:
        there = yield from _listed(where, thing.noun, 500, f"Which {thing.noun or 'things'} are there")
        return [i for i in there if matches(thing, i, state)]
    found: list[ObjectInfo] = []
    carriers = yield from receptacles(where, state)
    for carrier in carriers[:40]:
        for relation in ("in", "on"):
            there = yield from list_contents(carrier, relation)
            found += [i for i in there if i not in found]
    return [i for i in found if where.floor in (None, i.floor) and matches(thing, i, state)]


def rooms_of(where: Scope, state: SceneState) -> list[str]:
    """Return the rooms of a scope, the large ones first."""
    rooms = [
        (-room.area, room.id)
        for floor, room in state.rooms()
        if where.floor in (None, floor) and (not where.rooms or room.id in where.rooms)
    ]
    return [name for _, name in sorted(rooms)]
