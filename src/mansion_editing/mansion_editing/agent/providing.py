"""Provisioning of an object fact: count what is there, add what is missing where it takes the fewest edits."""

from collections import Counter
from collections.abc import Generator
from dataclasses import replace
from typing import Final

from mansion_editing.agent.belonging import at_home, rooms_for
from mansion_editing.agent.choosing import assets_of, place_any
from mansion_editing.agent.clearing import make_room
from mansion_editing.agent.facts import ObjectFact, Scope, Thing
from mansion_editing.agent.looking import find_things, fits, look_at, receptacles
from mansion_editing.agent.nearness import beside, references
from mansion_editing.agent.protocol import Action, Outcome
from mansion_editing.agent.surfaces import furnishable, relation_of, surfaces_of
from mansion_editing.state import SceneState
from mansion_msgs_py.editing import AssetInfo, ObjectInfo
from mansion_msgs_py.scene import SceneRoom

__all__ = ["provide"]

Work = Generator[Action, Outcome, str]

MOST_CARRIERS: Final = 6
MOST_ROOMS: Final = 12


def provide(fact: ObjectFact, state: SceneState) -> Work:
    """Make an object fact hold; return why it cannot."""
    if fact.where.near:
        return (yield from _provide_beside(fact, state))
    if not fact.where.receptacle:
        return (yield from _provide_in_room(fact, state))
    carriers = yield from receptacles(fact.where, state)
    if isinstance(carriers, str):
        return carriers
    if not carriers and fact.most:
        return ""
    if not carriers:
        carrier = yield from _provide_carrier(fact, state)
        if isinstance(carrier, str):
            return carrier
        carriers = [carrier]
    counted: list[tuple[int, int, ObjectInfo]] = []
    surplus: list[ObjectInfo] = []
    for order, carrier in enumerate(carriers[:40]):
        relation = relation_of(fact.where.relation, carrier, state)
        there = yield from look_at(carrier, relation)
        if isinstance(there, str):
            return there
        mine = [item for item in there if fits(fact.thing, item, state)]
        if fact.most:
            surplus += mine[fact.thing.count :]
            continue
        if fact.more:
            mine = []
        if len(mine) >= fact.thing.count:
            surplus = surplus or mine[fact.thing.count :]
            return (yield from _reduce(surplus)) if fact.exact else ""
        counted.append((-len(mine), order, carrier))
    if fact.most:
        return (yield from _reduce(surplus))
    counted.sort(key=lambda entry: entry[:2])
    return (yield from _fill(fact, [(-n, c) for n, _, c in counted[:MOST_CARRIERS]], state))


def _reduce(surplus: list[ObjectInfo]) -> Work:
    for item in surplus:
        answer = yield Action(f"{item.id} is one too many.", "RemoveObject", {"object_id": item.id})
        if answer.error is not None:
            return str(answer.error)
    return ""


def _fill(fact: ObjectFact, carriers: list[tuple[int, ObjectInfo]], state: SceneState) -> Work:
    """Place what is missing on the first receptacle that takes it all."""
    assets = yield from assets_of(fact.thing, state)
    if isinstance(assets, str):
        return assets
    reasons: list[str] = []
    for number, carrier in carriers:
        relation = relation_of(fact.where.relation, carrier, state)
        missing = fact.thing.count - number
        added: list[str] = []
        for _ in range(missing):
            placed = yield from place_any(assets, carrier.id, relation, colour=fact.thing.colour)
            made = placed[0]
            if not made and len(carriers) == 1:
                made = yield from make_room(fact.thing, assets, carrier, state)
            if not made:
                reasons.append(placed[1])
                break
            added.append(made)
        if len(added) == missing:
            return ""
        for object_id in reversed(added):
            yield Action("They do not all fit there.", "RemoveObject", {"object_id": object_id})
    if fact.thing.count == 1 and len(carriers) > 1:
        for _, carrier in carriers:
            if (yield from make_room(fact.thing, assets, carrier, state)):
                return ""
    return "; ".join(dict.fromkeys(reasons)) or "no receptacle takes it"


def _provide_carrier(fact: ObjectFact, state: SceneState) -> Generator[Action, Outcome, ObjectInfo | str]:
    """Furnish a room of the scope with the receptacle that is missing."""
    where = fact.where
    if "/" in where.receptacle or "_" in where.receptacle:
        return f"there is no {where.receptacle}"
    placed = yield from _furnish(Thing(where.receptacle, 1, where.colour), where, state)
    if not placed[0]:
        return placed[1]
    listed = yield Action("It is there now.", "ListObjects", {"id": placed[0]})
    info: ObjectInfo = listed.value.objects[0]
    return info


def _furnish(
    thing: Thing, where: Scope, state: SceneState, near: str = ""
) -> Generator[Action, Outcome, tuple[str, str]]:
    """Put furniture into the room of a scope that suits it best.

    A kind of it that belongs into a room of the scope (an office desk) goes before one that belongs into none.
    """
    assets = yield from assets_of(thing, state)
    if isinstance(assets, str):
        return "", assets
    standing = [a for a in assets if state.catalogue.asset(a.asset_id).mount == "floor"]
    reason = f"there is no {thing.noun} {Scope('room', '', where.rooms, where.floor)}"
    if not standing:
        return "", reason
    first = standing[0]
    common = Counter(item.category for _, item in state.objects())
    kinds = sorted(state.vocabulary.nouns(thing.noun), key=lambda name: -common[name])
    for category in dict.fromkeys([first.category, *kinds]):
        own = [a for a in state.catalogue.by_category(category) if a.mount == "floor"]
        if not own or not any(at_home(state, room, [category]) for room in _rooms(where, state)):
            continue
        if category != first.category:
            other = yield from assets_of(replace(thing, noun=category.replace("_", " ")), state)
            standing = standing if isinstance(other, str) else other
        break
    first = standing[0]
    for room in rooms_for(where, state, first.category, first.size)[:MOST_ROOMS]:
        placed = yield from place_any(standing, room, "on", colour=thing.colour, near=near)
        if placed[0]:
            return placed
        reason = placed[1]
    return "", reason


def _rooms(where: Scope, state: SceneState) -> list[SceneRoom]:
    named = set(furnishable(where, state))
    return [room for f in state.floors for room in state.scenes[f].rooms if room.id in named]


def _provide_in_room(fact: ObjectFact, state: SceneState) -> Work:
    found = yield from find_things(fact.thing, fact.where, state)
    if isinstance(found, str):
        return found
    missing = fact.thing.count - (0 if fact.more else len(found))
    if missing <= 0 or fact.most:
        surplus = found[fact.thing.count :] if fact.exact or fact.most else []
        return (yield from _reduce(surplus))
    assets = yield from assets_of(fact.thing, state)
    if isinstance(assets, str):
        return assets
    if _stands(assets, state):
        for _ in range(missing):
            placed = yield from _furnish(fact.thing, fact.where, state)
            if not placed[0]:
                return placed[1]
        return ""
    targets = yield from surfaces_of(fact.where, state, fact.thing.noun)
    if isinstance(targets, str):
        return targets
    reason = f"nothing {fact.where} carries it"
    for target in targets[: 2 * MOST_CARRIERS]:
        while missing:
            placed = yield from place_any(assets, target, "on", colour=fact.thing.colour)
            if not placed[0]:
                reason = placed[1]
                break
            missing -= 1
        if not missing:
            return ""
    return reason


def _stands(assets: list[AssetInfo], state: SceneState) -> bool:
    first = state.catalogue.asset(assets[0].asset_id)
    return first.mount == "floor" and not (first.pickupable and max(first.size) < 0.6)


def _provide_beside(fact: ObjectFact, state: SceneState) -> Work:
    """Provide things next to something; they go on what carries it, furniture on the floor."""
    anchors = yield from references(fact.where, state)
    if isinstance(anchors, str):
        return anchors
    found = yield from find_things(fact.thing, Scope("room", "", (), fact.where.floor), state)
    if isinstance(found, str):
        return found
    counts = [
        (sum(item.id != anchor.id and beside(item, anchor, state) for item in found), anchor) for anchor in anchors
    ]
    if any(count >= fact.thing.count for count, _ in counts):
        return ""
    assets = yield from assets_of(fact.thing, state)
    if isinstance(assets, str):
        return assets
    reason = f"there is no {fact.where.near} to put it next to"
    for count, anchor in sorted(counts, key=lambda pair: -pair[0])[:MOST_CARRIERS]:
        added: list[str] = []
        for _ in range(fact.thing.count - count):
            target = anchor.room if _stands(assets, state) else anchor.parent or anchor.id
            placed = yield from place_any(assets, target, "on", colour=fact.thing.colour, near=anchor.id)
            if placed[0]:
                added.append(placed[0])
            listed = yield Action("Is it near?", "ListObjects", {"id": placed[0] or anchor.id})
            item = listed.value.objects[0]
            if not placed[0] or not beside(item, anchor, state):
                reason = placed[1] or f"no free place next to {anchor.id}"
                break
        else:
            return ""
        for object_id in reversed(added):
            yield Action("That is too far away.", "RemoveObject", {"object_id": object_id})
    return reason
