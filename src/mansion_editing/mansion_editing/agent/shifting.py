"""Removing and moving: the facts that take something from where it is."""

from collections.abc import Generator

from mansion_editing.agent.clearing import free_up
from mansion_editing.agent.facts import AbsentFact, MoveFact
from mansion_editing.agent.looking import find_things, fits, look_at, receptacles
from mansion_editing.agent.protocol import Action, Outcome
from mansion_editing.agent.surfaces import relation_of, surfaces_of
from mansion_editing.state import SceneState
from mansion_msgs_py.editing import ObjectInfo

__all__ = ["take_away", "transfer"]

Work = Generator[Action, Outcome, str]


def take_away(fact: AbsentFact, state: SceneState) -> Work:
    """Remove what is to be gone; what is fixed to a building (ceilings, walls) stays."""
    if not fact.thing.noun:
        return (yield from _clear(fact, state))
    found = yield from find_things(fact.thing, fact.where, state)
    if isinstance(found, str):
        return found
    loose = [i for i in found if i.mount not in ("ceiling", "wall")]
    if found and not loose:
        return f"{found[0].id} is fixed to the building"
    if fact.thing.count and len(loose) < fact.thing.count:
        return f"there are only {len(loose)} {fact.thing.noun} {fact.where}"
    chosen = loose[: fact.thing.count] if fact.thing.count else loose
    for item in chosen:
        if state.find(item.id) is None:
            continue
        answer = yield Action(f"{item.id} is to be gone.", "RemoveObject", {"object_id": item.id})
        if answer.error is not None:
            return str(answer.error)
    return ""


def _clear(fact: AbsentFact, state: SceneState) -> Work:
    carriers = yield from receptacles(fact.where, state)
    if isinstance(carriers, str):
        return carriers
    if not carriers:
        return f"there is no {fact.where.receptacle} {fact.where}"
    for carrier in carriers:
        there: list[ObjectInfo] = []
        for relation in ("on", "in"):
            seen = yield from look_at(carrier, relation)
            if isinstance(seen, str):
                return seen
            there += seen
        spared = [i for i in there if any(fits(thing, i, state) for thing in fact.spare)]
        if spared:
            gone = [i.id for i in there if i not in spared]
            requests = [{"object_id": name} for name in dict.fromkeys(gone)]
        else:
            requests = [{"receptacle_id": carrier.id}] if there else []
        for request in requests:
            answer = yield Action(f"{carrier.id} is to be empty.", "RemoveObject", request)
            if answer.error is not None:
                return str(answer.error)
    return ""


def transfer(fact: MoveFact, state: SceneState) -> Work:
    """Move things from one scope to another; those that are there already count."""
    found = yield from find_things(fact.thing, fact.source, state)
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
                seen = yield from look_at(carrier, relation)
                there += [] if isinstance(seen, str) else [i.id for i in seen if fits(fact.thing, i, state)]
    if len(there) >= fact.thing.count and not fact.source.receptacle and not fact.source.rooms:
        return ""
    movable = [i for i in loose if i.id not in there]
    if len(movable) < fact.thing.count:
        return f"there are only {len(movable)} {fact.thing.noun} {fact.source} to move"
    for item in movable[: fact.thing.count or len(movable)]:
        reason = "no place for it"
        for target in targets[:6]:
            answer = yield Action(
                f"{item.id} belongs to {target}.", "MoveObject", {"object_id": item.id, "receptacle_id": target}
            )
            if answer.error is None:
                reason = ""
                break
            reason = answer.error.info.message
        if reason and len(targets) == 1:
            reason = yield from _squeeze(item, targets[0], reason, state)
        if reason:
            return reason
    return ""


def _squeeze(item: ObjectInfo, target: str, reason: str, state: SceneState) -> Work:
    """Move a thing to a full surface, from which another goes first."""
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
        return "say where to, not only on which floor"
    surfaces = yield from surfaces_of(fact.target, state)
    if isinstance(surfaces, str):
        return surfaces
    standing = any(
        a.mount == "floor" for c in state.vocabulary.nouns(fact.thing.noun) for a in state.catalogue.by_category(c)
    )
    return [*fact.target.rooms] if standing else surfaces
