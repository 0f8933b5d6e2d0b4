"""Make facts hold with the fewest edits: look first, then place what is missing."""

from collections import Counter
from collections.abc import Generator
from dataclasses import replace
from typing import Final

from mansion_assets.catalogue.vocabulary import vocabulary_of
from mansion_editing.provisioning.facts import Fact, ObjectDescription, ObjectFact, PathFact, Scope
from mansion_editing.provisioning.making_room import make_room
from mansion_editing.provisioning.new_objects import find_assets, place_any
from mansion_editing.provisioning.object_search import find_objects, list_contents, matches, receptacles, rooms_of
from mansion_editing.provisioning.usual_places import (
    _in_room_program,
    find_surfaces,
    is_furniture,
    relation_of,
    rooms_for,
)
from mansion_editing.runs.policies import Action, Outcome, Policy, Unmet, Verdict, ask
from mansion_editing.state import SceneState
from mansion_msgs_py.editing.questions import ObjectInfo, ObjectList, PathReport
from mansion_msgs_py.scene import SceneRoom

__all__ = ["MOST_CARRIERS", "furnish", "satisfy"]

Provisioning = Generator[Action, Outcome, None]
"""Raises `Unmet` where a fact cannot be made to hold."""


def satisfy(facts: list[Fact], state: SceneState) -> Policy:
    """Check facts in order and provision what is missing."""
    failed = []
    for fact in facts:
        try:
            yield from _satisfy(fact, state)
        except Unmet as reason:
            failed.append(f"{fact}: {reason}")
    words = [str(fact) for fact in facts]
    summary = f"{len(facts) - len(failed)} of {len(facts)} facts hold" + (f"; {'; '.join(failed)}" if failed else "")
    return Verdict(summary, words, failed)


def _satisfy(fact: Fact, state: SceneState) -> Provisioning:
    if isinstance(fact, PathFact):
        yield from _require_path(fact)
    else:
        yield from _provide(fact, state)


def _require_path(fact: PathFact) -> Provisioning:
    report: PathReport = yield from ask(f"Is there {fact}?", "CheckPath", {"start": fact.start, "end": fact.end})
    if not report.reachable:
        raise Unmet(report.message)


MOST_CARRIERS: Final = 6
MOST_ROOMS: Final = 12


def _provide(fact: ObjectFact, state: SceneState) -> Provisioning:
    if fact.where.receptacle:
        yield from _provide_on_receptacle(fact, state)
    else:
        yield from _provide_in_room(fact, state)


def _provide_on_receptacle(fact: ObjectFact, state: SceneState) -> Provisioning:
    carriers = yield from receptacles(fact.where, state)
    if not carriers:
        carriers = [(yield from _provide_carrier(fact, state))]
    counted: list[tuple[int, int, ObjectInfo]] = []
    for order, carrier in enumerate(carriers[:40]):
        there = yield from list_contents(carrier, relation_of(fact.where.relation, carrier, state))
        mine = [item for item in there if matches(fact.object, item, state)]
        if len(mine) >= fact.object.count:
            return
        counted.append((-len(mine), order, carrier))
    counted.sort(key=lambda entry: entry[:2])
    yield from _place_missing(fact, [(-n, c) for n, _, c in counted[:MOST_CARRIERS]], state)


def _place_missing(fact: ObjectFact, carriers: list[tuple[int, ObjectInfo]], state: SceneState) -> Provisioning:
    """Place what is missing on the first receptacle that takes it all."""
    assets = yield from find_assets(fact.object, state)
    reasons: list[str] = []
    for number, carrier in carriers:
        relation = relation_of(fact.where.relation, carrier, state)
        missing = fact.object.count - number
        added: list[str] = []
        for _ in range(missing):
            made, reason = yield from place_any(assets, carrier.id, relation, colour=fact.object.colour)
            if not made and len(carriers) == 1:
                made = yield from make_room(fact.object, assets, carrier, state)
            if not made:
                reasons.append(reason)
                break
            added.append(made)
        if len(added) == missing:
            return
        for object_id in reversed(added):
            yield Action("They do not all fit there.", "RemoveObject", {"object_id": object_id})
    if fact.object.count == 1 and len(carriers) > 1:
        for _, carrier in carriers:
            if (yield from make_room(fact.object, assets, carrier, state)):
                return
    raise Unmet("; ".join(dict.fromkeys(reasons)) or "no receptacle takes it")


def _provide_carrier(fact: ObjectFact, state: SceneState) -> Generator[Action, Outcome, ObjectInfo]:
    """Furnish a room of the scope with the receptacle that is missing."""
    where = fact.where
    if "/" in where.receptacle or "_" in where.receptacle:
        raise Unmet(f"there is no {where.receptacle}")
    made = yield from furnish(ObjectDescription(where.receptacle, 1, where.colour), where, state)
    listed: ObjectList = yield from ask("It is there now.", "ListObjects", {"id": made})
    return listed.objects[0]


def furnish(thing: ObjectDescription, where: Scope, state: SceneState) -> Generator[Action, Outcome, str]:
    """Put furniture into the room of a scope that suits it best, and return its id.

    A kind of it that belongs into a room of the scope (an office desk) goes before one that belongs into none.
    """
    assets = yield from find_assets(thing, state)
    standing = [a for a in assets if state.catalogue.asset(a.asset_id).mount == "floor"]
    reason = f"there is no {thing.noun} {Scope('room', '', where.rooms, where.floor)}"
    if not standing:
        raise Unmet(reason)
    first = standing[0]
    common = Counter(item.category for _, item in state.objects())
    kinds = sorted(vocabulary_of(state.catalogue).nouns(thing.noun), key=lambda name: -common[name])
    for category in dict.fromkeys([first.category, *kinds]):
        own = [a for a in state.catalogue.by_category(category) if a.mount == "floor"]
        if not own or not any(_in_room_program(state, room, category) for room in _rooms(where, state)):
            continue
        if category != first.category:
            standing = yield from find_assets(replace(thing, noun=category.replace("_", " ")), state)
        break
    first = standing[0]
    for room in rooms_for(where, state, first.category, first.size)[:MOST_ROOMS]:
        made, reason = yield from place_any(standing, room, "on", colour=thing.colour)
        if made:
            return made
    raise Unmet(reason)


def _rooms(where: Scope, state: SceneState) -> list[SceneRoom]:
    named = set(rooms_of(where, state))
    return [room for f in state.floors for room in state.scenes[f].rooms if room.id in named]


def _provide_in_room(fact: ObjectFact, state: SceneState) -> Provisioning:
    found = yield from find_objects(fact.object, fact.where, state)
    missing = fact.object.count - len(found)
    if missing <= 0:
        return
    assets = yield from find_assets(fact.object, state)
    if is_furniture(assets, state):
        for _ in range(missing):
            yield from furnish(fact.object, fact.where, state)
        return
    targets = yield from find_surfaces(fact.where, state, fact.object.noun)
    reason = f"no surface {fact.where} can carry it"
    for target in targets[: 2 * MOST_CARRIERS]:
        while missing:
            made, fault = yield from place_any(assets, target, "on", colour=fact.object.colour)
            if not made:
                reason = fault
                break
            missing -= 1
        if not missing:
            return
    raise Unmet(reason)
