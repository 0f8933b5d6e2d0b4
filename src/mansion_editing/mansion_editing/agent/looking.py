"""Finding things with the perception tools."""

from collections.abc import Generator

from mansion_editing.agent.facts import Scope, Thing
from mansion_editing.agent.protocol import Action, Outcome
from mansion_editing.state import SceneState
from mansion_editing.tools.placing import COOLING
from mansion_editing.vocabulary import colour_of, stems
from mansion_msgs_py.editing import ObjectInfo, ObjectList, ReceptacleReport

__all__ = ["Look", "find_things", "fits", "look_at", "named_so", "receptacles"]

Look = Generator[Action, Outcome, list[ObjectInfo] | str]
"""Ends with what was found, or why nothing can be."""


def fits(thing: Thing, item: ObjectInfo, state: SceneState) -> bool:
    """Whether an object is such a thing."""
    if thing.noun and thing.noun != item.id:
        scene_object = state.find(item.id)
        ends = "_" in thing.noun and item.id.endswith(f"/{thing.noun}")
        if not ends and (scene_object is None or state.vocabulary.rank(scene_object[1], thing.noun) < 2):
            return False
    if thing.colour:
        material = state.find(item.id)
        if material is None or colour_of(material[1].material) != thing.colour:
            return False
    return not thing.cold or item.states.get("temperature") == "cold" or _in_the_cold(item, state)


def _in_the_cold(item: ObjectInfo, state: SceneState) -> bool:
    parent = state.find(item.parent or "")
    return parent is not None and item.mount == "inside" and parent[1].category in COOLING


def receptacles(where: Scope, state: SceneState) -> Look:
    """Find the receptacles of a scope."""
    if not where.receptacle:
        return []
    found: list[ObjectInfo] = []
    for room in where.rooms or ("",):
        answer = yield Action(
            f"Which {where.receptacle} is there{f' in {room}' if room else ''}?",
            "ListObjects",
            {"room": room, "keyword": where.receptacle, "limit": 200},
        )
        if answer.error is not None:
            return str(answer.error)
        listed: ObjectList = answer.value
        found += listed.objects
    mine = [i for i in found if where.floor in (None, i.floor)]
    mine = [i for i in mine if fits(Thing(where.receptacle, 0, where.colour), i, state)]
    if stems(where.receptacle)[-1:] == (where.receptacle.lower().rpartition(" ")[2],):
        mine = named_so(where.receptacle, mine) or mine
    return [i for i in mine if not where.base or _stands_on(i, where.base, state)]


def named_so(noun: str, items: list[ObjectInfo]) -> list[ObjectInfo]:
    """Return what is called by a noun itself: of a fridge and a display fridge, the fridge."""
    words = stems(noun)
    return [i for i in items if stems(i.category.replace("_", " ")) == words]


def _stands_on(item: ObjectInfo, base: str, state: SceneState) -> bool:
    found = state.find(item.parent or "")
    return found is not None and (found[1].id == base or state.vocabulary.rank(found[1], base) >= 2)


def look_at(receptacle: ObjectInfo, relation: str) -> Look:
    """List what is on or in a receptacle."""
    tool = "SearchContents" if relation == "in" else "CheckSurface"
    answer = yield Action(f"What is {relation} {receptacle.id}?", tool, {"id": receptacle.id})
    if answer.error is not None:
        return str(answer.error)
    report: ReceptacleReport = answer.value
    return report.receptacles[0].objects


def find_things(thing: Thing, where: Scope, state: SceneState) -> Look:
    """Find the things of a kind in a scope."""
    found: list[ObjectInfo] = []
    if where.receptacle:
        carriers = yield from receptacles(where, state)
        if isinstance(carriers, str):
            return carriers
        for carrier in carriers[:40]:
            for relation in ("in", "on"):
                there = yield from look_at(carrier, relation)
                if isinstance(there, str):
                    return there
                found += [i for i in there if i not in found]
    else:
        for room in where.rooms or ("",):
            answer = yield Action(
                f"Which {thing.noun or 'things'} are there{f' in {room}' if room else ''}?",
                "ListObjects",
                {"room": room, "keyword": thing.noun, "limit": 500},
            )
            if answer.error is not None:
                return str(answer.error)
            listed: ObjectList = answer.value
            found += listed.objects
    return [i for i in found if where.floor in (None, i.floor) and fits(thing, i, state)]
