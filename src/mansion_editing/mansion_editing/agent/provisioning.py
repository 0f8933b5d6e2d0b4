"""Make facts hold with the fewest edits: place, move, remove and switch what is needed."""

from collections import Counter
from collections.abc import Generator
from dataclasses import replace
from typing import Final

from mansion_editing.agent.candidates import (
    exactly_named,
    find_assets,
    find_landmarks,
    find_objects,
    find_surfaces,
    in_room_program,
    is_next_to,
    list_contents,
    matches,
    place_any,
    receptacles,
    relation_of,
    rooms_for,
    rooms_of,
)
from mansion_editing.agent.protocol import (
    AbsentFact,
    Action,
    Fact,
    MoveFact,
    ObjectDescription,
    ObjectFact,
    Outcome,
    PathFact,
    Policy,
    Scope,
    StateFact,
    Verdict,
)
from mansion_editing.references import stems, vocabulary_of
from mansion_editing.state import SceneState
from mansion_editing.tools.placement import free_places, ledges_of
from mansion_msgs_py.editing import AssetInfo, ObjectInfo, PathReport
from mansion_msgs_py.scene import SceneRoom
from mansion_msgs_py.shapes import Point3

__all__ = ["free_up", "make_room", "provide_objects", "satisfy", "remove_objects", "move_objects"]

Provisioning = Generator[Action, Outcome, str]
"""Ends with the reason why a fact does not hold, empty when it does."""


def satisfy(facts: list[Fact], state: SceneState) -> Policy:
    """Check facts in order and provision what is missing."""
    failed = []
    for fact in facts:
        reason = yield from _satisfy(fact, state)
        if reason:
            failed.append(f"{fact}: {reason}")
    words = [str(fact) for fact in facts]
    summary = f"{len(facts) - len(failed)} of {len(facts)} facts hold" + (f"; {'; '.join(failed)}" if failed else "")
    return Verdict(summary, words, failed)


def _satisfy(fact: Fact, state: SceneState) -> Provisioning:
    if isinstance(fact, ObjectFact):
        return (yield from provide_objects(fact, state))
    if isinstance(fact, PathFact):
        return (yield from _path(fact))
    if isinstance(fact, AbsentFact):
        return (yield from remove_objects(fact, state))
    if isinstance(fact, MoveFact):
        return (yield from move_objects(fact, state))
    return (yield from _switch(fact, state))


def _path(fact: PathFact) -> Provisioning:
    answer = yield Action(f"Is there {fact}?", "CheckPath", {"start": fact.start, "end": fact.end})
    if answer.error is not None:
        return str(answer.error)
    report: PathReport = answer.value
    return "" if report.reachable else report.message


def _switch(fact: StateFact, state: SceneState) -> Provisioning:
    found = yield from find_objects(fact.object, fact.where, state)
    if isinstance(found, str):
        return found
    if not fact.object.noun and not (fact.where.rooms or fact.where.floor is not None):
        return "say in which room, or on which floor"
    if not found:
        return f"there is no {fact.object.noun} {fact.where}"
    able = [i for i in found if ("openable" if fact.state == "open" else "toggleable") in i.properties]
    if not able:
        what = "opens" if fact.state == "open" else "switches"
        return f"no {fact.object.noun} {fact.where} {what}"
    several = fact.object.count == 0 and fact.object.every
    own = set(stems(fact.object.noun))
    named = [i for i in able if own <= set(stems(i.category.replace("_", " ")))]
    able = ([] if several else exactly_named(fact.object.noun, able)) or named or able
    wanted = able if several else able[: max(1, fact.object.count)]
    as_wished = [i for i in able if bool(i.states.get(fact.state, False)) == fact.value]
    if not several and len(as_wished) >= max(1, fact.object.count):
        return ""
    for item in wanted:
        if bool(item.states.get(fact.state, False)) == fact.value:
            continue
        answer = yield Action(
            f"{item.id} is not in the requested state.", "SetState", {"object_id": item.id, fact.state: fact.value}
        )
        if answer.error is not None:
            return str(answer.error)
    return ""


MOST_CARRIERS: Final = 6
MOST_ROOMS: Final = 12


def provide_objects(fact: ObjectFact, state: SceneState) -> Provisioning:
    """Make an object fact hold; return why it cannot."""
    if fact.where.near:
        return (yield from _provide_next_to(fact, state))
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
        there = yield from list_contents(carrier, relation)
        if isinstance(there, str):
            return there
        mine = [item for item in there if matches(fact.object, item, state)]
        if fact.most:
            surplus += mine[fact.object.count :]
            continue
        if fact.more:
            mine = []
        if len(mine) >= fact.object.count:
            surplus = surplus or mine[fact.object.count :]
            return (yield from _remove_surplus(surplus)) if fact.exact else ""
        counted.append((-len(mine), order, carrier))
    if fact.most:
        return (yield from _remove_surplus(surplus))
    counted.sort(key=lambda entry: entry[:2])
    return (yield from _place_missing(fact, [(-n, c) for n, _, c in counted[:MOST_CARRIERS]], state))


def _remove_surplus(surplus: list[ObjectInfo]) -> Provisioning:
    for item in surplus:
        answer = yield Action(f"{item.id} is surplus.", "RemoveObject", {"object_id": item.id})
        if answer.error is not None:
            return str(answer.error)
    return ""


def _place_missing(fact: ObjectFact, carriers: list[tuple[int, ObjectInfo]], state: SceneState) -> Provisioning:
    """Place what is missing on the first receptacle that takes it all."""
    assets = yield from find_assets(fact.object, state)
    if isinstance(assets, str):
        return assets
    reasons: list[str] = []
    for number, carrier in carriers:
        relation = relation_of(fact.where.relation, carrier, state)
        missing = fact.object.count - number
        added: list[str] = []
        for _ in range(missing):
            placed = yield from place_any(assets, carrier.id, relation, colour=fact.object.colour)
            made = placed[0]
            if not made and len(carriers) == 1:
                made = yield from make_room(fact.object, assets, carrier, state)
            if not made:
                reasons.append(placed[1])
                break
            added.append(made)
        if len(added) == missing:
            return ""
        for object_id in reversed(added):
            yield Action("They do not all fit there.", "RemoveObject", {"object_id": object_id})
    if fact.object.count == 1 and len(carriers) > 1:
        for _, carrier in carriers:
            if (yield from make_room(fact.object, assets, carrier, state)):
                return ""
    return "; ".join(dict.fromkeys(reasons)) or "no receptacle takes it"


def _provide_carrier(fact: ObjectFact, state: SceneState) -> Generator[Action, Outcome, ObjectInfo | str]:
    """Furnish a room of the scope with the receptacle that is missing."""
    where = fact.where
    if "/" in where.receptacle or "_" in where.receptacle:
        return f"there is no {where.receptacle}"
    placed = yield from _furnish(ObjectDescription(where.receptacle, 1, where.colour), where, state)
    if not placed[0]:
        return placed[1]
    listed = yield Action("It is there now.", "ListObjects", {"id": placed[0]})
    info: ObjectInfo = listed.value.objects[0]
    return info


def _furnish(
    thing: ObjectDescription, where: Scope, state: SceneState, near: str = ""
) -> Generator[Action, Outcome, tuple[str, str]]:
    """Put furniture into the room of a scope that suits it best.

    A kind of it that belongs into a room of the scope (an office desk) goes before one that belongs into none.
    """
    assets = yield from find_assets(thing, state)
    if isinstance(assets, str):
        return "", assets
    standing = [a for a in assets if state.catalogue.asset(a.asset_id).mount == "floor"]
    reason = f"there is no {thing.noun} {Scope('room', '', where.rooms, where.floor)}"
    if not standing:
        return "", reason
    first = standing[0]
    common = Counter(item.category for _, item in state.objects())
    kinds = sorted(vocabulary_of(state.catalogue).nouns(thing.noun), key=lambda name: -common[name])
    for category in dict.fromkeys([first.category, *kinds]):
        own = [a for a in state.catalogue.by_category(category) if a.mount == "floor"]
        if not own or not any(in_room_program(state, room, [category]) for room in _rooms(where, state)):
            continue
        if category != first.category:
            other = yield from find_assets(replace(thing, noun=category.replace("_", " ")), state)
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
    named = set(rooms_of(where, state))
    return [room for f in state.floors for room in state.scenes[f].rooms if room.id in named]


def _provide_in_room(fact: ObjectFact, state: SceneState) -> Provisioning:
    found = yield from find_objects(fact.object, fact.where, state)
    if isinstance(found, str):
        return found
    missing = fact.object.count - (0 if fact.more else len(found))
    if missing <= 0 or fact.most:
        surplus = found[fact.object.count :] if fact.exact or fact.most else []
        return (yield from _remove_surplus(surplus))
    assets = yield from find_assets(fact.object, state)
    if isinstance(assets, str):
        return assets
    if _is_furniture(assets, state):
        for _ in range(missing):
            placed = yield from _furnish(fact.object, fact.where, state)
            if not placed[0]:
                return placed[1]
        return ""
    targets = yield from find_surfaces(fact.where, state, fact.object.noun)
    if isinstance(targets, str):
        return targets
    reason = f"no surface {fact.where} can carry it"
    for target in targets[: 2 * MOST_CARRIERS]:
        while missing:
            placed = yield from place_any(assets, target, "on", colour=fact.object.colour)
            if not placed[0]:
                reason = placed[1]
                break
            missing -= 1
        if not missing:
            return ""
    return reason


def _is_furniture(assets: list[AssetInfo], state: SceneState) -> bool:
    first = state.catalogue.asset(assets[0].asset_id)
    return first.mount == "floor" and not (first.pickupable and max(first.size) < 0.6)


def _provide_next_to(fact: ObjectFact, state: SceneState) -> Provisioning:
    """Provide objects next to a landmark: on its receptacle, or furniture on the floor beside it."""
    anchors = yield from find_landmarks(fact.where, state)
    if isinstance(anchors, str):
        return anchors
    found = yield from find_objects(fact.object, Scope("room", "", (), fact.where.floor), state)
    if isinstance(found, str):
        return found
    counts = [
        (sum(item.id != anchor.id and is_next_to(item, anchor, state) for item in found), anchor) for anchor in anchors
    ]
    if any(count >= fact.object.count for count, _ in counts):
        return ""
    assets = yield from find_assets(fact.object, state)
    if isinstance(assets, str):
        return assets
    reason = f"there is no {fact.where.near} to put it next to"
    for count, anchor in sorted(counts, key=lambda pair: -pair[0])[:MOST_CARRIERS]:
        added: list[str] = []
        for _ in range(fact.object.count - count):
            target = anchor.room if _is_furniture(assets, state) else anchor.parent or anchor.id
            placed = yield from place_any(assets, target, "on", colour=fact.object.colour, near=anchor.id)
            if placed[0]:
                added.append(placed[0])
            listed = yield Action("Is it near?", "ListObjects", {"id": placed[0] or anchor.id})
            item = listed.value.objects[0]
            if not placed[0] or not is_next_to(item, anchor, state):
                reason = placed[1] or f"no free place next to {anchor.id}"
                break
        else:
            return ""
        for object_id in reversed(added):
            yield Action("That is too far away.", "RemoveObject", {"object_id": object_id})
    return reason


def remove_objects(fact: AbsentFact, state: SceneState) -> Provisioning:
    """Remove objects; those fixed to walls or ceilings stay."""
    if not fact.object.noun:
        return (yield from _clear(fact, state))
    found = yield from find_objects(fact.object, fact.where, state)
    if isinstance(found, str):
        return found
    loose = [i for i in found if i.mount not in ("ceiling", "wall")]
    if found and not loose:
        return f"{found[0].id} is fixed to the building"
    if fact.object.count and len(loose) < fact.object.count:
        return f"there are only {len(loose)} {fact.object.noun} {fact.where}"
    chosen = loose[: fact.object.count] if fact.object.count else loose
    for item in chosen:
        if state.find(item.id) is None:
            continue
        answer = yield Action(f"{item.id} should be removed.", "RemoveObject", {"object_id": item.id})
        if answer.error is not None:
            return str(answer.error)
    return ""


def _clear(fact: AbsentFact, state: SceneState) -> Provisioning:
    carriers = yield from receptacles(fact.where, state)
    if isinstance(carriers, str):
        return carriers
    if not carriers:
        return f"there is no {fact.where.receptacle} {fact.where}"
    for carrier in carriers:
        there: list[ObjectInfo] = []
        for relation in ("on", "in"):
            seen = yield from list_contents(carrier, relation)
            if isinstance(seen, str):
                return seen
            there += seen
        spared = [i for i in there if any(matches(thing, i, state) for thing in fact.spare)]
        if spared:
            gone = [i.id for i in there if i not in spared]
            requests = [{"object_id": name} for name in dict.fromkeys(gone)]
        else:
            requests = [{"receptacle_id": carrier.id}] if there else []
        for request in requests:
            answer = yield Action(f"{carrier.id} should be empty.", "RemoveObject", request)
            if answer.error is not None:
                return str(answer.error)
    return ""


def move_objects(fact: MoveFact, state: SceneState) -> Provisioning:
    """Move objects from one scope to another; those already there count."""
    found = yield from find_objects(fact.object, fact.source, state)
    if isinstance(found, str):
        return found
    loose = [i for i in found if i.mount not in ("ceiling", "wall")]
    targets = yield from _targets(fact, state)
    if isinstance(targets, str):
        return targets
    there: list[str] = []
    for target in targets:
        if state.find(target) is not None:
            carrier = next(iter((yield from _carrier(target))), None)
            if carrier is not None:
                relation = relation_of("in", carrier, state)
                seen = yield from list_contents(carrier, relation)
                there += [] if isinstance(seen, str) else [i.id for i in seen if matches(fact.object, i, state)]
    if len(there) >= fact.object.count and not fact.source.receptacle and not fact.source.rooms:
        return ""
    movable = [i for i in loose if i.id not in there]
    if len(movable) < fact.object.count:
        return f"there are only {len(movable)} {fact.object.noun} {fact.source} to move"
    for item in movable[: fact.object.count or len(movable)]:
        reason = "no place for it"
        for target in targets[:6]:
            answer = yield Action(
                f"{item.id} should be on {target}.", "MoveObject", {"object_id": item.id, "receptacle_id": target}
            )
            if answer.error is None:
                reason = ""
                break
            reason = answer.error.info.message
        if reason and len(targets) == 1:
            reason = yield from _move_after_clearing(item, targets[0], reason, state)
        if reason:
            return reason
    return ""


def _move_after_clearing(item: ObjectInfo, target: str, reason: str, state: SceneState) -> Provisioning:
    """Move an object to a full surface after clearing a place on it."""
    carriers = yield from _carrier(target)
    found = state.find(item.id)
    if not carriers or found is None:
        return reason
    freed = yield from free_up(item.name, [found[1].size], carriers[0], state)
    if freed is None:
        return reason
    answer = yield Action(
        f"{target} has room for {item.id} now.", "MoveObject", {"object_id": item.id, "receptacle_id": target}
    )
    return "" if answer.error is None else answer.error.info.message


def _carrier(object_id: str) -> Generator[Action, Outcome, list[ObjectInfo]]:
    answer = yield Action(f"What is {object_id}?", "ListObjects", {"id": object_id})
    return [] if answer.error is not None else answer.value.objects


def _targets(fact: MoveFact, state: SceneState) -> Generator[Action, Outcome, list[str] | str]:
    if fact.target.receptacle:
        carriers = yield from receptacles(fact.target, state)
        if isinstance(carriers, str):
            return carriers
        if not carriers:
            return f"there is no {fact.target.receptacle} {fact.target}"
        return [carrier.id for carrier in carriers]
    if not fact.target.rooms:
        return "say where to move it, not only to which floor"
    surfaces = yield from find_surfaces(fact.target, state)
    if isinstance(surfaces, str):
        return surfaces
    categories = vocabulary_of(state.catalogue).nouns(fact.object.noun)
    stands = any(asset.mount == "floor" for name in categories for asset in state.catalogue.by_category(name))
    return [*fact.target.rooms] if stands else surfaces


MOST_TARGETS: Final = 6


def make_room(
    thing: ObjectDescription, assets: list[AssetInfo], carrier: ObjectInfo, state: SceneState
) -> Generator[Action, Outcome, str]:
    """Clear a place on a full surface for a new object and return its id, empty when that fails."""
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
    """Move one object to another surface of the room, and return the size that fits in its place.

    What this instruction has touched stays, and only one thing makes room for an instruction.
    """
    touched = {change.id for change in state.pending}
    if any(change.before is not None and change.after is not None for change in state.pending):
        return None
    there = yield from list_contents(carrier, relation_of("on", carrier, state))
    for item in [] if isinstance(there, str) else there:
        found = state.find(item.id)
        if found is None or item.id in touched or not found[1].pickupable:
            continue
        if state.subtree(*found)[1:] or vocabulary_of(state.catalogue).rank(found[1], noun) >= 2:
            continue
        size = next((size for size in sizes if _fits_without(size, carrier, item, state)), None)
        if size is None:
            continue
        targets = yield from find_surfaces(Scope("room", "", (item.room,)), state)
        for target in [] if isinstance(targets, str) else targets[:MOST_TARGETS]:
            if target == carrier.id:
                continue
            answer = yield Action(
                f"{item.id} makes room for the {noun}.", "MoveObject", {"object_id": item.id, "receptacle_id": target}
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
