"""Remove and Clear: things leave, exactly those that words mean."""

from collections.abc import Callable, Generator, Sequence
from dataclasses import replace

import msgspec

from mansion_assets.catalogue.vocabulary import stems, vocabulary_of
from mansion_editing.instructions.doing.work import Done, Work, listed, live
from mansion_editing.instructions.meaning.choices import concerned, one_room_each, things_meant
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import all_at, anchors_of, carried_by, rooms_of, things_of
from mansion_editing.instructions.meaning.nouns import is_fixed, is_loose, names_many
from mansion_editing.instructions.meaning.numbers import means_one
from mansion_editing.instructions.meaning.sparing import is_movable, spared_among, spares_furniture
from mansion_editing.instructions.meaning.wording import bare_words, counted, place_in, place_words, thing_words
from mansion_editing.instructions.statements import Clear, Place, Remove, Things
from mansion_editing.runs.policies import Action, Outcome, Unmet, ask
from mansion_editing.state import SceneState
from mansion_msgs_py.scene import SceneObject

__all__ = ["clear", "remove", "removed", "to_clear"]

Gone = Generator[Action, Outcome, list[str]]
"""Ends with the ids of what left."""


def removed(items: Sequence[SceneObject], state: SceneState) -> Gone:
    """Remove objects; what furniture carries goes with it, what lies on a smaller thing stays where that was."""
    gone: list[str] = []
    for item in items:
        found = state.find(item.id)
        if found is None:
            continue
        floor, now = found
        if now.parent is not None:
            for member in state.index(floor).children.get(now.id, []):
                if member.id not in {other.id for other in items}:
                    arguments = {"object_id": member.id, "receptacle_id": now.parent}
                    yield from ask(f"{member.id} stays when {now.id} goes.", "MoveObject", arguments)
        answer = yield from ask(f"{item.id} should be removed.", "RemoveObject", {"object_id": item.id})
        gone += answer.object_ids
    return gone


def remove(statement: Remove, state: SceneState, context: Context) -> Work:
    """Remove the things that words mean."""
    things = statement.things
    chosen = _chosen(things, state, context)
    if not chosen:
        return _nothing_to_remove(things, state, context)
    before = len(concerned(state, things, context))
    gone = yield from removed(chosen, state)
    own = {item.id for item in chosen}
    carried = sorted(name for name in gone if name not in own)
    reply = f"{listed(chosen)} removed" + (f", with what stood on it: {listed(carried)}" if carried else "")
    if before > len(chosen):
        reply += f"; {before - len(chosen)} of {before} left"
    rooms = tuple(dict.fromkeys(item.room for item in chosen))
    holders = tuple(dict.fromkeys(item.parent for item in chosen if item.parent and live(state, [item.parent])))
    told = context.followed((), rooms, things.noun, holders)
    return Done(reply, replace(told, things=tuple(item.id for item in chosen)))


def _chosen(things: Things, state: SceneState, context: Context) -> list[SceneObject]:
    amount = things.amount
    several = amount.kind in ("all", "at_most", "none") or (things.plural and amount.number <= 1)
    found = concerned(state, things, context)
    known = names_many(things.noun) or bool(vocabulary_of(state.catalogue).nouns(things.noun))
    if not found and things.refers:
        raise Unmet(f"there is nothing that {thing_words(things)!r} could be")
    if not found and known and things.definite and not several:
        _refuse_others(things, state, context)
    if not found and known and (several or (means_one(things) and bool(things.noun))):
        return []
    if amount.kind in ("all_but", "exactly") and len(found) < amount.number:
        raise Unmet(f"there are only {counted(len(found), things.noun or 'thing')}, not {amount.number}")
    chosen = things_meant(state, things, context, surplus=True)
    certain = things.definite and means_one(things) and not names_many(things.noun)
    free = [item for item in chosen if certain or not is_fixed(item) or _is_named(state, item, things.noun)]
    if chosen and not free:
        raise Unmet(f"{chosen[0].id} is fixed to the building; name it by its kind to remove it")
    return free


def _refuse_others(things: Things, state: SceneState, context: Context) -> None:
    """Refuse to leave ``the second fridge`` or ``the red chair`` as gone where there are others of the kind.

    Raises
    ------
    Unmet
    """
    if not (things.ordinal or things.colour or things.material or things.states):
        return
    plain = msgspec.structs.replace(things, ordinal=0, colour="", material="", states={})
    others = things_of(state, plain, context)
    if others:
        raise Unmet(f"there is no such {things.noun}; there is {listed(others)}")


def _is_named(state: SceneState, item: SceneObject, noun: str) -> bool:
    """Whether a noun names what is fixed to the building itself, not only many kinds that it is one of."""
    words = stems(noun)
    own = stems(item.category.replace("_", " "))
    by_name = bool(words) and set(words) <= {*own, *stems(item.name)}
    return item.id == noun or by_name or item.category in vocabulary_of(state.catalogue).exact(words)


def _nothing_to_remove(things: Things, state: SceneState, context: Context) -> Done:
    place = things.place
    if place is not None and place.rooms is not None:
        one_room_each(state, place.rooms, context, lambda room: True)
    if place is not None and place.anchor is not None and not anchors_of(state, place, context):
        raise Unmet(f"there is no {thing_words(msgspec.structs.replace(place.anchor, definite=False))}")
    found = concerned(state, things, context)
    where = "" if place is None else f" {place_in(state, place, context)}"
    if not found and place is not None and place.anchor is not None and means_one(things) and things.definite:
        raise Unmet(
            f"there is no {bare_words(things)} {place_in(state, place, context)}{_instead(state, place, context)}"
        )
    verb = "is" if len(found) == 1 else "are"
    left = counted(len(found), things.noun or "thing")
    rooms = [] if place is None or place.rooms is None else rooms_of(state, place.rooms, context)
    said = f"there was nothing to remove: there {verb} {left}{where}"
    return Done(said, context.followed((), rooms, things.noun))


def _instead(state: SceneState, place: Place, context: Context) -> str:
    """Return in words what is there instead, of what a piece of furniture carries."""
    if place.relation not in ("on", "in", ""):
        return ""
    there = [item for holder in anchors_of(state, place, context) for item in carried_by(state, holder, place.relation)]
    return f"; there is {listed(there)}" if there else "; nothing is there"


def to_clear(statement: Clear, state: SceneState, context: Context) -> list[SceneObject]:
    """Return what is loose at a place, without what is spared.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a place that is not there; see `things_meant`.
    """
    place = statement.place
    if place == Place():
        raise Unmet("say which room, storey or piece of furniture is to be emptied; not the whole building at once")
    if place.anchor is not None and place.relation in ("on", "in", ""):
        anchor = place.anchor
        if place.rooms is not None and (anchor.place is None or anchor.place.rooms is None):
            within = msgspec.structs.replace(anchor.place or Place(), rooms=place.rooms)
            anchor = msgspec.structs.replace(anchor, place=within)
        holders = things_meant(state, anchor, context, _carries(state))
        relations = (place.relation,) if place.relation else ("on", "in")
        there = [item for holder in holders for relation in relations for item in carried_by(state, holder, relation)]
    else:
        rooms = set() if place.rooms is None else set(one_room_each(state, place.rooms, context))
        pool = [item for _, item in state.objects() if not rooms or item.room in rooms]
        there = all_at(state, pool, place, context)
    whole = spares_furniture(state, statement, context)
    loose = {item.id: item for item in there if is_loose(item) or (whole and is_movable(item))}
    spared = spared_among(state, statement.spare, [*loose.values()], context) | context.kept
    holding = {item.parent for item in loose.values() if item.id in spared}
    return [item for name, item in loose.items() if name not in spared and name not in holding]


def _carries(state: SceneState) -> Callable[[SceneObject], bool]:
    bearing = {item.parent for _, item in state.objects()}
    return lambda item: item.id in bearing


def _from_words(place: Place) -> str:
    if place.anchor is not None and place.relation in ("on", "in", ""):
        rooms = "" if place.rooms is None else f" {place_words(Place(rooms=place.rooms))}"
        return f"from {thing_words(place.anchor)}{rooms}"
    return place_words(place)


def clear(statement: Clear, state: SceneState, context: Context) -> Work:
    """Empty furniture, a room or a part of it of what is loose."""
    there = to_clear(statement, state, context)
    where = _from_words(statement.place)
    if not there:
        bare = () if statement.place.rooms is None else tuple(rooms_of(state, statement.place.rooms, context))
        return Done(f"there was nothing loose to clear {where}", context.followed((), bare, ""))
    gone: list[str] = []
    for item in there:
        if live(state, [item.id]):
            answer = yield from ask(f"{item.id} should go.", "RemoveObject", {"object_id": item.id})
            gone += answer.object_ids
    rooms = tuple(dict.fromkeys(item.room for item in there))
    holders = tuple(dict.fromkeys(item.parent for item in there if item.parent))
    return Done(f"{len(gone)} removed {where}: {listed(gone)}", context.followed(holders, rooms, ""))
