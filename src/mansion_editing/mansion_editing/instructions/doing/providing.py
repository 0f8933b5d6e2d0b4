"""Add, Ensure and Replace: new things where words want them, with the fewest of them."""

import re
from collections.abc import Generator, Sequence, Set
from dataclasses import replace
from typing import Any, Final

import msgspec

from mansion_editing.instructions.doing.new_assets import assets_of, compared, counters_by, like_those_there
from mansion_editing.instructions.doing.removing import removed
from mansion_editing.instructions.doing.work import Done, Work, listed, live
from mansion_editing.instructions.meaning.choices import one_room_each, things_meant
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import all_at, rooms_of, things_of
from mansion_editing.instructions.meaning.nouns import called, has_material
from mansion_editing.instructions.meaning.numbers import (
    is_one_of_each_room,
    is_shared_out,
    means_any_in_each_room,
    means_one,
    means_several,
    new_number,
)
from mansion_editing.instructions.meaning.targets import Target, places_of
from mansion_editing.instructions.meaning.vacated import vacated_by
from mansion_editing.instructions.meaning.wording import (
    at_words,
    bare_words,
    counted,
    place_in,
    place_words,
    there_were,
    thing_words,
)
from mansion_editing.instructions.phrases.nouns import is_comparative
from mansion_editing.instructions.phrases.word_sets import BESIDE_RELATIONS
from mansion_editing.instructions.statements import Add, Amount, Ensure, Place, Replace, Rooms, Things
from mansion_editing.provisioning.facts import ObjectDescription, Scope
from mansion_editing.provisioning.making_room import make_room
from mansion_editing.provisioning.new_objects import place_any
from mansion_editing.provisioning.satisfying import MOST_CARRIERS, furnish
from mansion_editing.provisioning.usual_places import find_surfaces, is_furniture, relation_of, rooms_for
from mansion_editing.runs.policies import Action, Outcome, Unmet, ask
from mansion_editing.state import SceneState
from mansion_editing.tools.perception import object_info
from mansion_msgs_py.editing.questions import AssetInfo
from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.shapes import Point3

__all__ = ["add", "at_target", "ensure", "place_at", "replace_things", "wishes_of"]

MOST_NEW = 100
"""Greatest number of new things of a kind for one place."""

_WHOLE: Final = re.compile(r"\b(all|each|every|any|both|whatever)\b", re.IGNORECASE)
"""Words for things of which each is replaced by one; ``the two chairs`` are replaced by ``a bench`` together."""

_ONE_FOR_ALL: Final = re.compile(r"\b(?:by|with|for) (?:just |only )?(?:one|a single|1)\b", re.IGNORECASE)
"""Words for one new thing in place of all; of ``both lamps by a candle`` each is replaced."""

Made = Generator[Action, Outcome, list[str]]
"""Ends with the ids of new objects."""


def at_target(state: SceneState, things: Things, place: Place, target: Target, context: Context) -> list[SceneObject]:
    """Return the things of the kind that are at one of the places that words mean."""
    anchor = None if target.anchor is None else Things(noun=target.anchor.id, definite=True)
    other = None if target.other is None else Things(noun=target.other.id, definite=True)
    facing = None if target.facing is None else Things(noun=target.facing.id, definite=True)
    room = None if target.anchor is not None else Rooms(words=target.room)
    exact = msgspec.structs.replace(place, anchor=anchor, other=other, facing=facing, rooms=room, outside=False)
    kind = msgspec.structs.replace(
        things, place=None, amount=Amount(kind="all", number=0), definite=False, refers="", ordinal=0, size="", hints=()
    )
    return all_at(state, things_of(state, kind, context), exact, context)


def add(statement: Add, state: SceneState, context: Context) -> Work:
    """Bring so many more things, always new ones, at each place or at the first that takes them."""
    things, place = statement.things, _whole_place(statement.things, statement.place)
    if place.outside:
        raise Unmet(f"say where, not only {place_words(place)}")
    if things.refers == "last" and not things.noun:
        things = msgspec.structs.replace(things, noun=context.noun, refers="")
    number = new_number(things)
    if number > MOST_NEW:
        raise Unmet(f"{number} things are more than one instruction brings; at most {MOST_NEW}")
    known = {item.id for _, item in state.objects()}
    if place.former is not None:
        there = yield from _in_place_of(vacated_by(state, place.former, context), things, number, state)
        return _added_reply(things, place, 0, there, state, context)
    groups = yield from _groups(things, place, state, context, each=statement.each)
    if place.anchor is not None and place.anchor.amount.of:  # on one of the desks: first on those without such a thing
        groups = [sorted(g, key=lambda target: len(at_target(state, things, place, target, context))) for g in groups]
    made: list[str] = []
    before = sum(len(at_target(state, things, place, t, context)) for group in groups for t in group)
    if is_shared_out(things, place, each=statement.each):
        made = yield from _shared_out(things, number, place, groups, state, context)
    else:
        for group in groups:
            made += yield from place_at(things, number, place, group, state)
    done = _added_reply(things, place, before, made, state, context)
    chosen = _chosen_of_several(things, place, groups, made, state, context)
    return replace(done, reply=done.reply + chosen + _brought_to_carry(groups, known))


def _chosen_of_several(
    things: Things,
    place: Place,
    groups: Sequence[Sequence[Target]],
    made: Sequence[str],
    state: SceneState,
    context: Context,
) -> str:
    """Return words for the one that was taken where words for one thing ("beside the chair") fit several alike."""
    if place.anchor is None or not means_one(place.anchor) or max(map(len, groups), default=0) < 2:
        return ""
    for group in groups:
        for target in group:
            if target.anchor and any(i.id in made for i in at_target(state, things, place, target, context)):
                return f", at {target.anchor.id}, one of {len(group)}"
    return ""


def _shared_out(
    things: Things, number: int, place: Place, groups: Sequence[Sequence[Target]], state: SceneState, context: Context
) -> Made:
    """Place so many things on several pieces of furniture together: each next one where the fewest are."""
    targets = [target for group in groups for target in group]
    one = msgspec.structs.replace(things, amount=Amount(number=1), plural=False)
    made: list[str] = []
    for _ in range(number):
        order = sorted(targets, key=lambda target: len(at_target(state, things, place, target, context)))
        made += yield from place_at(one, 1, place, order, state)
    return made


def _added_reply(
    things: Things, place: Place, before: int, made: list[str], state: SceneState, context: Context
) -> Done:
    items = live(state, made)
    rooms = tuple(dict.fromkeys(item.room for item in items))
    where = place_in(state, place, context) or f"in {' and '.join(rooms)}"
    had = f"{there_were(before, things.noun)} {where}"
    reply = f"{had}; {len(made)} added ({listed(made)}), now {before + len(made)}"
    reply += _passed_over(state, place, context)
    return Done(reply, context.followed(made, rooms, things.noun))


def _brought_to_carry(groups: Sequence[Sequence[Target]], known: Set[str]) -> str:
    """Return words for furniture that was missing and came for things to be on or in."""
    anchors = [target.anchor.id for group in groups for target in group if target.anchor is not None]
    came = [name for name in dict.fromkeys(anchors) if name not in known]
    return f"; {listed(came)} added to carry that" if came else ""


def _whole_place(things: Things, place: Place) -> Place:
    """Return the place with what the words for the things say of it."""
    own = things.place
    if own is None:
        return place
    if place == Place():
        return own
    return msgspec.structs.replace(place, rooms=place.rooms or own.rooms) if place.anchor else place


def _is_each(place: Place) -> bool:
    of_all = place.anchor is not None and place.anchor.amount.kind == "all"
    return of_all or (place.anchor is None and place.rooms is not None and place.rooms.every)


def _groups(
    things: Things, place: Place, state: SceneState, context: Context, *, each: bool
) -> Generator[Action, Outcome, list[list[Target]]]:
    """Return groups of places: the things go to one place of each group."""
    if place.anchor is None and place.rooms is None:
        rooms = Rooms(same=True) if context.rooms else Rooms(every=True)
        place = msgspec.structs.replace(place, rooms=rooms)
        targets = places_of(state, place, context, each=True)
        return [(yield from _best_first(things, targets, state))]
    if is_one_of_each_room(place):
        return _one_of_each_room(state, place, context)
    if means_any_in_each_room(place):
        return (yield from _groups_by_room(place, state, context))
    several = each or _is_each(place)
    plural_rooms = place.rooms is not None and (place.rooms.every or place.rooms.number > 1)
    having = _rooms_having(state, place, context)
    targets = places_of(state, place, context, each=several, fits=having.__contains__)
    if not targets:
        targets = [(yield from _new_carrier(place, state, context))]
    if not several and plural_rooms:
        names = list(dict.fromkeys(target.room for target in targets))
        return [[target for target in targets if target.room == name] for name in names]
    anchor = place.anchor
    beside = place.relation in BESIDE_RELATIONS | {"between"}  # "a plant next to the chairs" is one
    if several or (anchor is not None and anchor.definite and means_several(anchor) and not beside):
        return [[target] for target in targets]
    if place.anchor is None and len(targets) > 1 and place.rooms is not None and not place.rooms.words:
        return [targets]
    return [targets] if place.anchor is not None else [[target] for target in targets]


def _groups_by_room(
    place: Place, state: SceneState, context: Context
) -> Generator[Action, Outcome, list[list[Target]]]:
    """Return the places in each of several rooms; a room that has none gets what is missing."""
    groups: list[list[Target]] = []
    for room in [] if place.rooms is None else one_room_each(state, place.rooms, context):
        own = msgspec.structs.replace(place, rooms=Rooms(words=room))
        targets = places_of(state, own, context, each=True)
        groups.append(targets or [(yield from _new_carrier(own, state, context))])
    return groups


def _one_of_each_room(state: SceneState, place: Place, context: Context) -> list[list[Target]]:
    """Return the places of each room that has the thing which words mean; rooms of any kind may be without it.

    Raises
    ------
    Unmet
        Where a room that the words name has no such thing.
    """
    groups = _by_room(state, place, context)
    without = [name for name, targets in groups.items() if not targets]
    if place.anchor is not None and (len(without) == len(groups) or (without and _names_rooms(place))):
        raise Unmet(f"there is no {bare_words(place.anchor)} in {listed(without)}")
    return [targets for targets in groups.values() if targets]


def _names_rooms(place: Place) -> bool:
    return place.rooms is not None and bool(place.rooms.words)


def _by_room(state: SceneState, place: Place, context: Context) -> dict[str, list[Target]]:
    """Return the places in each of the rooms that each have one, by the rooms' ids."""
    if not is_one_of_each_room(place) or place.rooms is None:
        return {}
    names = one_room_each(state, place.rooms, context)
    own = {name: msgspec.structs.replace(place, rooms=Rooms(words=name)) for name in names}
    return {name: places_of(state, here, context) for name, here in own.items()}


def _passed_over(state: SceneState, place: Place, context: Context) -> str:
    """Return the words that tell in which rooms nothing was done."""
    without = [name for name, targets in _by_room(state, place, context).items() if not targets]
    if not without or place.anchor is None:
        return ""
    return f"; nothing in {listed(without)}, which have no {bare_words(place.anchor)}"


def _best_first(things: Things, targets: list[Target], state: SceneState) -> Generator[Action, Outcome, list[Target]]:
    """Return rooms that words leave open in the order in which they suit a thing."""
    first = (yield from assets_of(things, state))[0]
    rooms = Scope("room", "", tuple(target.room for target in targets))
    order = rooms_for(rooms, state, first.category, first.size)
    return sorted((target for target in targets if target.room in order), key=lambda target: order.index(target.room))


def _rooms_having(state: SceneState, place: Place, context: Context) -> set[str]:
    """Return the rooms that have what the place is on, at or facing."""
    marks = [mark for mark in (place.anchor, place.facing) if mark is not None]
    if not marks or place.rooms is None:
        return set()
    sets = [{item.room for item in things_of(state, mark, context)} for mark in marks]
    return set.intersection(*sets) & set(rooms_of(state, place.rooms, context))


def _new_carrier(place: Place, state: SceneState, context: Context) -> Generator[Action, Outcome, Target]:
    """Furnish a room with the receptacle that is missing, where words do not say that it is there."""
    anchor = place.anchor
    known = place.rooms is not None and len(rooms_of(state, place.rooms, context)) == 1
    told = anchor is not None and anchor.definite and not (known and place.relation in ("on", "in"))
    told = told or (anchor is not None and anchor.definite and _is_another_there(anchor, place, state, context))
    told = told or (anchor is not None and anchor.each)
    if anchor is None or told or anchor.refers or "/" in anchor.noun or place.relation == "between":
        raise Unmet(
            f"there is nothing {place_words(place)}" if anchor is None else f"there is no {_kind(anchor, place)}"
        )
    if anchor.place is not None and anchor.place.anchor is not None:
        bare = msgspec.structs.replace(anchor, place=None)
        where = msgspec.structs.replace(anchor.place, rooms=anchor.place.rooms or place.rooms)
        (small,) = yield from place_at(bare, 1, where, places_of(state, where, context), state)
        holder = live(state, [small])[0]
        return Target(holder.room, holder)
    rooms = () if place.rooms is None else tuple(rooms_of(state, place.rooms, context))
    made = yield from furnish(ObjectDescription(anchor.noun, 1, anchor.colour), Scope("room", "", rooms), state)
    item = live(state, [made])[0]
    return Target(item.room, item)


def _is_another_there(anchor: Things, place: Place, state: SceneState, context: Context) -> bool:
    """Whether a room has such furniture, only not as words tell it: its table is not ``the table by the window``."""
    alike = Things(noun=anchor.noun, amount=Amount(kind="all", number=0), plural=True, place=Place(rooms=place.rooms))
    told = anchor.place is not None or anchor.colour or anchor.material or anchor.ordinal or anchor.size
    return bool(told) and bool(things_of(state, alike, context))


def _kind(anchor: Things, place: Place) -> str:
    rooms = "" if place.rooms is None else f" {place_words(Place(rooms=place.rooms))}"
    return f"{thing_words(msgspec.structs.replace(anchor, definite=False))}{rooms}"


def wishes_of(place: Place, target: Target) -> dict[str, Any]:
    """Return the arguments of a place tool that say where from its anchor, where in the room, and how turned."""
    out: dict[str, Any] = {}
    if target.anchor is not None and place.relation not in ("on", "in"):
        out["near"] = target.anchor.id
        if place.relation not in ("", "near"):
            out["side"] = place.relation
    if target.other is not None:
        out["other"] = target.other.id
    if place.within:
        out["within"] = place.within
    if place.apart:
        out["apart"] = place.apart
    if place.spot or target.door:
        out["spot"] = place.spot or "door"
    if target.door:
        out["door"] = target.door
    if target.facing is not None:
        out["facing"] = target.facing.id
    return out


def place_at(
    things: Things,
    number: int,
    place: Place,
    targets: Sequence[Target],
    state: SceneState,
    before: Point3 | None = None,
) -> Made:
    """Place new things at the first of some places that takes them all.

    Parameters
    ----------
    before : (x, y, z), optional
        Size of what was there, with which ``a bigger one`` is compared.

    Raises
    ------
    Unmet
        Where none does.
    """
    assets = yield from assets_of(things, state)
    assets = like_those_there(things, assets, {target.room for target in targets}, state)
    if before is not None and any(map(is_comparative, things.hints)):
        assets = compared(things, assets, before, state)
    reasons: list[str] = []
    for kinds, clearing in _attempts(assets, number):
        for target in targets[:MOST_CARRIERS]:
            made: list[str] = []
            for _ in range(number):
                one, reason = yield from _place_one(things, kinds, place, target, state, clearing=clearing)
                if not one:
                    reasons.append(reason)
                    break
                made.append(one)
            if len(made) == number:
                yield from _finished(things, made, state)
                return made
            for object_id in reversed(made):
                yield from ask("They do not all fit there.", "RemoveObject", {"object_id": object_id})
    raise Unmet("; ".join(dict.fromkeys(reasons)) or f"there is no place for {thing_words(things)}")


def _attempts(assets: list[AssetInfo], number: int) -> list[tuple[list[AssetInfo], bool]]:
    """Return which assets are tried in turn, and whether what is in the way may make room: small ones before that."""
    small = sorted(assets, key=lambda asset: (asset.category != assets[0].category, asset.size[0] * asset.size[1]))
    tried = [(assets, False), (small, False)] if number > 1 and small[0] != assets[0] else [(assets, False)]
    return [*tried, (small if number > 1 else assets, True)]


def _place_one(
    things: Things, assets: list[AssetInfo], place: Place, target: Target, state: SceneState, *, clearing: bool
) -> Generator[Action, Outcome, tuple[str, str]]:
    colour, wishes = things.colour, wishes_of(place, target)
    if target.anchor is not None and place.relation in ("on", "in"):
        found = state.find(target.anchor.id)
        if found is None:
            return "", f"{target.anchor.id} is gone"
        carrier = object_info(state, *found)
        assets = sorted(assets, key=lambda asset: state.catalogue.asset(asset.asset_id).mount != "surface")
        relation = relation_of(place.relation, carrier, state)
        made, reason = yield from place_any(
            assets, carrier.id, relation, colour=colour, name=things.noun, wishes=wishes
        )
        if not made and clearing:
            there = [item for _, item in state.objects() if item.parent == carrier.id]
            alike = {item.id for item in called(state, there, things.noun, many=True)}
            thing = ObjectDescription(things.noun, 1, colour)
            made = yield from make_room(thing, assets, carrier, state, alike, relation)
        return made, reason
    stands = _goes_to_room(assets, state)
    if target.anchor is not None and target.anchor.parent is not None and not stands:
        return (
            yield from place_any(assets, target.anchor.parent, "on", colour=colour, name=things.noun, wishes=wishes)
        )
    for top in [] if stands or target.anchor is None or place.on_floor else counters_by(target.anchor, place, state):
        made, reason = yield from place_any(assets, top, "on", colour=colour, name=things.noun, wishes=wishes)
        if made:
            return made, ""
    if stands or target.anchor is not None or place.spot or place.on_floor:
        return (yield from place_any(assets, target.room, "on", colour=colour, name=things.noun, wishes=wishes))
    surfaces = yield from find_surfaces(Scope("room", "", (target.room,)), state, things.noun)
    reason = f"no surface in {target.room} can carry it"
    for surface in surfaces[: 2 * MOST_CARRIERS]:
        made, reason = yield from place_any(assets, surface, "on", colour=colour, name=things.noun, wishes=wishes)
        if made:
            return made, ""
    return "", reason


def _goes_to_room(assets: list[AssetInfo], state: SceneState) -> bool:
    mount = state.catalogue.asset(assets[0].asset_id).mount
    return mount in ("wall", "ceiling") or is_furniture(assets, state)


def _finished(things: Things, made: Sequence[str], state: SceneState) -> Generator[Action, Outcome, None]:
    """Give new things the material and the states that words ask for."""
    for item in live(state, made):
        if things.material and not has_material(item, things.material):
            arguments = {"object_id": item.id, "material": things.material}
            yield from ask(f"{item.id} should be of {things.material}.", "PaintObject", arguments)
        for name, value in things.states.items():
            if bool(item.states.get(name, False)) != value:
                yield from ask(f"{item.id} should be so.", "SetState", {"object_id": item.id, name: value})


def ensure(statement: Ensure, state: SceneState, context: Context) -> Work:
    """Bring what is missing of a number, counting what is there; take away what is more only where words say so."""
    things, place = statement.things, _whole_place(statement.things, statement.place)
    if things.refers == "last" and not things.noun and context.noun:
        things = msgspec.structs.replace(things, noun=context.noun, refers="")
    if not things.noun:
        raise Unmet("say what shall be there")
    kind, number = things.amount.kind, new_number(things)
    if kind == "more" or place.former is not None:
        return (yield from add(Add(things=things, place=place, each=statement.each), state, context))
    several = statement.each or _is_each(place)
    before = {item.id for _, item in state.objects()}
    least = kind not in ("at_most", "none")
    if place.anchor is None and place.rooms is None:
        groups = [places_of(state, Place(rooms=Rooms(every=True), spot=place.spot), context, each=True)]
        if least:
            groups = [(yield from _best_first(things, groups[0], state))]
    elif not least and place.anchor is not None and not things_of(state, place.anchor, context):
        groups = []
    else:
        groups = yield from _groups(things, place, state, context, each=several)
    _refuse_other_number_lacking(statement, things, place, groups, state, context)
    if is_shared_out(things, place, each=statement.each):
        had = len({i.id for g in groups for t in g for i in at_target(state, things, place, t, context)})
        made = yield from _shared_out(things, max(0, number - had), place, groups, state, context)
        gone: list[str] = []
    else:
        _refuse_to_take_away(statement, number, groups, state, context)
        had, made, gone = yield from _as_many_in_each(things, number, place, groups, state, context)
    if kind == "at_most" and not had and _TOO_MANY.search(statement.quote):
        raise Unmet(f"there are no {bare_words(things)}{at_words(place)}")
    items = live(state, made)
    rooms = tuple(dict.fromkeys([*(i.room for i in items), *(t.room for g in groups for t in g[:1])]))
    reply = f"{there_were(had, things.noun)} {place_in(state, place, context) or 'in the building'}"
    reply += _changed(had, made, gone) + _brought_to_carry(groups, before) + _passed_over(state, place, context)
    known = made or [i.id for g in groups for t in g for i in at_target(state, things, place, t, context)]
    return Done(reply, context.followed(known, rooms[:1], things.noun))


_ADDING: Final = re.compile(
    r"\b(add|another|additional|extra|(?<!any )(?<!no )(?<!not )more (?!than))\b", re.IGNORECASE
)
"""Words by which things come, so that none goes: ``add one more so that there are six``."""


_TOO_MANY: Final = re.compile(r"\b(enough|plenty|will do|too many|too much|suffice)\b", re.IGNORECASE)
"""Words by which there are more than so many."""


def _refuse_to_take_away(
    statement: Ensure, number: int, groups: Sequence[Sequence[Target]], state: SceneState, context: Context
) -> None:
    """Refuse a total that fewer things have than there are already, where words only add.

    Raises
    ------
    Unmet
    """
    things, place = statement.things, statement.place
    if things.amount.kind != "exactly" or not _ADDING.search(statement.quote):
        return
    for group in groups:
        there = {item.id for target in group for item in at_target(state, things, place, target, context)}
        if len(there) > number:
            raise Unmet(
                f"there are {counted(len(there), things.noun)} already, more than {number}; say where they shall be"
            )


def _as_many_in_each(
    things: Things, number: int, place: Place, groups: Sequence[Sequence[Target]], state: SceneState, context: Context
) -> Generator[Action, Outcome, tuple[int, list[str], list[str]]]:
    """Bring what is missing in each group of places and take away the surplus; return how many were there, and both."""
    kind = things.amount.kind
    least, whole = kind not in ("at_most", "none"), place.anchor is None
    had, made, gone = 0, [], []
    for group in groups:
        there = [(target, at_target(state, things, place, target, context)) for target in group]
        best = max(there, key=lambda pair: len(pair[1]), default=None)
        found = list({i.id: i for _, items in there for i in items}.values())
        if not whole and (best is None or kind in ("exactly", "at_most", "none") or len(found) < number):
            found = best[1] if best else []
        had += len(found)
        if len(found) > number and kind in ("exactly", "at_most", "none"):
            gone += yield from removed(found[number:], state)
        elif len(found) < number and least and best is not None:
            order = [best[0], *(target for target in group if target is not best[0])]
            anywhere = whole or (not found and means_any_in_each_room(place))
            made += yield from place_at(things, number - len(found), place, order if anywhere else order[:1], state)
    return had, made, gone


def _refuse_other_number_lacking(
    statement: Ensure,
    things: Things,
    place: Place,
    groups: Sequence[Sequence[Target]],
    state: SceneState,
    context: Context,
) -> None:
    """Refuse to give what "two of the desks" have not where another number of them has none.

    Raises
    ------
    Unmet
    """
    if not statement.lacking:
        return
    none = [group for group in groups if not any(at_target(state, things, place, target, context) for target in group)]
    if len(none) != statement.lacking:
        raise Unmet(f"{len(none)} have no {things.noun}, not {statement.lacking}")


def _changed(had: int, made: Sequence[str], gone: Sequence[str]) -> str:
    """Return words for what came and what left after those that were there."""
    if not made and not gone:
        return " already; nothing had to change"
    came = f"; {len(made)} added ({listed(made)}), now {had + len(made)}" if made else ""
    return came + (f"; {len(gone)} removed ({listed(gone)})" if gone else "")


def replace_things(statement: Replace, state: SceneState, context: Context) -> Work:
    """Take things away and put new ones where they stood."""
    olds = things_meant(state, statement.things, context)
    by = statement.by
    each = bool(_WHOLE.search(statement.quote)) or len({old.room for old in olds}) > 1
    together = by.amount.number == 1 and _ONE_FOR_ALL.search(statement.quote) is not None
    one_by_one = by.plural or len(olds) == 1 or (statement.things.amount.kind == "all" and each and not together)
    number = new_number(by) if by.amount.number > 1 or not one_by_one else len(olds)
    gone: list[str] = []
    made: list[str] = []
    for order, old in enumerate(olds):
        gone += yield from removed([old], state)
        share = number // len(olds) + (order < number % len(olds))
        made += yield from _in_place_of(old, by, share, state)
    kinds = {item.category for item in live(state, made)}
    other = by.noun != statement.things.noun and not (by.colour or by.material)
    if other and kinds and kinds <= {old.category for old in olds}:
        kind = kinds.pop().replace("_", " ")
        raise Unmet(f"the catalogue has no {by.noun} of its own; what comes nearest is another {kind}")
    carried = [name for name in gone if name not in {old.id for old in olds}]
    reply = f"{listed(olds)} replaced by {listed(made)}" + (f"; gone with it: {listed(carried)}" if carried else "")
    rooms = tuple(dict.fromkeys(old.room for old in olds))
    return Done(reply, context.followed(made, rooms, by.noun))


def _in_place_of(old: SceneObject, by: Things, number: int, state: SceneState) -> Made:
    """Place new things as close to an old one's place as there is room."""
    if not number:
        return []
    parent = live(state, [old.parent or ""])
    relation = "in" if old.mount == "inside" else "on"
    place = Place(relation=relation) if parent else Place()  # type: ignore[arg-type]
    made = yield from place_at(by, number, place, [Target(old.room, parent[0] if parent else None)], state, old.size)
    first = live(state, made[:1])[0]
    if first.mount == old.mount and first.parent == old.parent:
        x, y, _ = old.position
        arguments = {"object_id": first.id, "x": x, "y": y, "rotation": old.rotation}
        yield Action(f"{first.id} should stand where {old.id} was.", "MoveObject", arguments)
    return made
