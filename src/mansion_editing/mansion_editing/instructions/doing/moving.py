"""Move, Swap and Turn: things that are there go to another place, or turn where they stand."""

import math
import re
from collections.abc import Generator, Sequence, Set
from dataclasses import replace
from typing import Any, Final

import msgspec

from mansion_editing.instructions.doing.exact_moves import move_to_former_spot
from mansion_editing.instructions.doing.gathering import gather
from mansion_editing.instructions.doing.new_assets import counters_by
from mansion_editing.instructions.doing.providing import add, wishes_of
from mansion_editing.instructions.doing.rooms import swap_rooms
from mansion_editing.instructions.doing.stowing import stow
from mansion_editing.instructions.doing.work import Done, Work, listed, live, whereabouts
from mansion_editing.instructions.meaning.choices import at_home, from_there, one_room_each, things_meant
from mansion_editing.instructions.meaning.context import Context, ambiguous
from mansion_editing.instructions.meaning.descriptions import all_at, rooms_of, things_of
from mansion_editing.instructions.meaning.directions import faced_point, rotation_towards
from mansion_editing.instructions.meaning.nouns import is_loose
from mansion_editing.instructions.meaning.numbers import means_one
from mansion_editing.instructions.meaning.room_words import room_title
from mansion_editing.instructions.meaning.targets import Target, names_any, places_of
from mansion_editing.instructions.meaning.wording import bare_words, place_words, thing_words
from mansion_editing.instructions.phrases.each_other import EACH_OTHER
from mansion_editing.instructions.phrases.places import with_place
from mansion_editing.instructions.phrases.storage import AWAY
from mansion_editing.instructions.statements import Add, Amount, Move, Place, Rooms, Swap, Things, Turn
from mansion_editing.provisioning.facts import Scope
from mansion_editing.provisioning.making_room import move_after_clearing
from mansion_editing.provisioning.satisfying import MOST_CARRIERS
from mansion_editing.provisioning.usual_places import find_surfaces
from mansion_editing.runs.policies import Action, Outcome, Unmet, ask
from mansion_editing.state import SceneState
from mansion_editing.tools.perception import object_info
from mansion_editing.tools.tops import carries_on_top
from mansion_msgs_py.scene import SceneObject

__all__ = ["facing_rotation", "move", "of_goal_room", "swap", "turn"]


_QUARTER: Final = 90.0
_WAY_ROUND: Final = re.compile(r"clockwise|\b(left|right|counter|anti)", re.IGNORECASE)
"""Words that tell which way something turns; a quarter turn without them may be either way."""

_WHOLE: Final = re.compile(r"\b(all|every|each|both|any|whatever|everything)\b", re.IGNORECASE)
"""Words by which all of a kind are meant, wherever they are."""
_OUT_OF_THERE: Final = re.compile(r"\bout of (there|here)\b", re.IGNORECASE)

_STEPS_ASIDE: Final = 5
"""Decimetres by which a thing moves aside for a turn at most, in either direction of the plan."""


def move(statement: Move, state: SceneState, context: Context) -> Work:
    """Bring things that are there to a place; new ones only where words allow it and none is in the building."""
    if statement.place.anchor == EACH_OTHER:
        return (yield from gather(statement, state, context))
    statement = _to_its_spot(statement, state, context)
    if statement.place.former is not None:
        return (yield from move_to_former_spot(statement, state, context))
    if statement.place == AWAY:
        return (yield from stow(statement, state, context))
    statement = _of_another(statement, context)
    statement = _of_those_before(of_goal_room(statement, state, context), state, context)
    things, place = statement.things, statement.place
    found = things_of(state, things, context)
    if place == Place() or (place == Place(rooms=Rooms(same=True)) and _OUT_OF_THERE.search(statement.quote)):
        raise Unmet(f"say where {thing_words(things)} shall go")
    if not found and statement.or_new:
        _refuse_other_looks(state, things, place, context)
        return (yield from add(Add(things=_new(things), place=place), state, context))
    told = things.place is not None and things.place.relation in ("", "on", "in") and things.amount.kind != "all_but"
    if not found and things.noun and things.place is not None and told and (things.definite or things.plural):
        if things.place.rooms is not None:
            one_room_each(state, things.place.rooms, context, lambda room: True)
        kind = msgspec.structs.replace(things, place=None, amount=Amount(kind="all", number=0))
        arrived = all_at(state, things_of(state, kind, context), place, context)
        told = place.rooms is not None or place.anchor is not None
        told = told and (len(arrived) == 1 or not means_one(things))
        if told and arrived and not things.amount.of and things.amount.number in (0, len(arrived)):
            none = f"there is no {thing_words(msgspec.structs.replace(things, definite=False))}"
            said = f"{none}, and {listed(arrived)} {_is([i.id for i in arrived])} there already"
            rooms = tuple(dict.fromkeys(item.room for item in arrived))
            after = context.followed([item.id for item in arrived], rooms, things.noun)
            return Done(said, replace(after, assumed=frozenset(item.id for item in arrived)))
    place = at_home(state, things, place, context)
    place, context = _on_other_storey(state, things, place, context)
    targets = _targets(state, place, context, found, found if len(found) == 1 else ())
    there = _already_there(state, found, place, targets, context)
    away = [item for item in found if item.id not in there]
    single = not things.plural and things.amount.number <= 1 and things.amount.kind in ("some", "all")
    reached = {target.room for target in targets}
    elsewhere = bool(targets) and not any(item.room in reached for item in away)
    mentioned = [item for item in away if item.room in context.rooms]
    if means_one(things) and there and elsewhere:
        away = mentioned  # those there already are meant, unless there are some in the room that was told of
    if (found and not away) or (there and single and not means_one(things) and not statement.or_new):
        said = f"{listed(sorted(there))} {_is(there)} there already; nothing had to move"
        rooms = tuple(dict.fromkeys(item.room for item in found if item.id in there))
        return Done(said, context.followed(sorted(there), rooms, things.noun))
    chosen = _to_move(state, statement, away, targets, context)
    _refuse_guesses(statement, chosen, reached, context)
    before = [(item, whereabouts(item).removeprefix("in ")) for item in chosen]
    ids: list[str] = []
    replies = []
    for item, where in before:
        new = yield from _moved_to_any(item, place, _of_own_room(item, statement, targets), state)
        ids.append(new)
        (now,) = live(state, [new])
        name = item.id if new == item.id else f"{item.id} (now {new})"
        replies.append(f"{name} moved from {where} to {whereabouts(now).removeprefix('in ')}")
    rooms = tuple(dict.fromkeys(item.room for item in live(state, ids)))
    source = tuple(dict.fromkeys(item.room for item in chosen))
    context = context.followed((), source, "") if len(source) == 1 else context
    return Done("; ".join(replies), context.followed(ids, rooms, things.noun))


def _to_its_spot(statement: Move, state: SceneState, context: Context) -> Move:
    """Return ``hang the painting there`` as where the clock was that went, if the painting is in that room already."""
    if statement.place != Place(rooms=Rooms(same=True)) or not context.vacated or statement.things.refers:
        return statement
    here = Place(rooms=Rooms(words=context.vacated[0].room))
    things = statement.things if statement.things.place is not None else with_place(statement.things, here)
    if context.vacated[0].room not in context.rooms or not things_of(state, things, context):
        return statement
    spot = Place(former=Things(refers="last", definite=True))
    return msgspec.structs.replace(statement, things=things, place=spot)


def _refuse_other_looks(state: SceneState, things: Things, place: Place, context: Context) -> None:
    """Refuse to bring ``the yellow ball`` where there is a ball of another colour, which may be meant.

    Raises
    ------
    Unmet
    """
    if not (things.definite and (things.colour or things.material)) or place.rooms is None:
        return
    rooms = set(rooms_of(state, place.rooms, context))
    plain = msgspec.structs.replace(things, colour="", material="", place=None)
    others = [item for item in things_of(state, plain, context) if item.room in rooms]
    if others:
        looks = ", ".join(f"{item.id} ({item.material.replace('_', ' ')})" for item in others[:4])
        raise Unmet(f"there is no {bare_words(things)}; there is {looks}")


def _already_there(
    state: SceneState, found: list[SceneObject], place: Place, targets: list[Target], context: Context
) -> set[str]:
    """Return the ids of things that are at the place: at the very one that words mean where they mean one."""
    if not targets or place.anchor is None or not means_one(place.anchor):
        return {item.id for item in all_at(state, found, place, context)}
    exact = [msgspec.structs.replace(place, anchor=Things(noun=t.anchor.id)) for t in targets if t.anchor is not None]
    exact = [msgspec.structs.replace(one, rooms=None) for one in exact]
    return {item.id for one in exact for item in all_at(state, found, one, context)}


def _refuse_guesses(statement: Move, chosen: list[SceneObject], reached: Set[str], context: Context) -> None:
    """Refuse to move what is elsewhere than words say, and to bring one thing to each of several rooms.

    Raises
    ------
    Unmet
    """
    things, rooms = statement.things, statement.place.rooms
    assumed = [item for item in chosen if item.id in context.assumed and things.refers == "last"]
    if assumed:
        raise Unmet(f"{listed(assumed)} {_is([i.id for i in assumed])} elsewhere than was told: say which is meant")
    own = things.place is not None and things.place.rooms == rooms
    if rooms is not None and rooms.every and not own and len(chosen) < len(reached):
        raise Unmet(f"{listed(chosen)} cannot go to each of {len(reached)} rooms: say what goes where")


def _of_another(statement: Move, context: Context) -> Move:
    """Return ``another one`` after some went as one of those that are still where these came from."""
    things = statement.things
    if things.amount.kind != "more" or things.place is not None or things.refers or not context.earlier:
        return statement
    source = Place(rooms=Rooms(words=context.earlier[-1]))
    other = msgspec.structs.replace(things, amount=Amount(number=things.amount.number), place=source)
    return msgspec.structs.replace(statement, things=other)


def of_goal_room(statement: Move, state: SceneState, context: Context) -> Move:
    """Return what goes somewhere within a room as what is in that room, where it has such things.

    ``The smallest plant in the lounge on the table`` is the smallest of the lounge, not of the building; ``the boxes in
    the store on the floor`` are those of the store.
    """
    things, rooms = statement.things, statement.place.rooms
    within = statement.place.anchor is not None or bool(statement.place.spot)
    told = things.size or things.ordinal or things.hints or (within and _is_bare_plural(statement))
    if rooms is None or not told or things.place is not None or things.owned or things.refers:
        return statement
    there = msgspec.structs.replace(things, place=Place(rooms=rooms))
    return msgspec.structs.replace(statement, things=there) if things_of(state, there, context) else statement


def _of_those_before(statement: Move, state: SceneState, context: Context) -> Move:
    """Return ``the one in the store`` as the one that was there, not the one that was moved there just before."""
    things = statement.things
    named = things.place is not None and things.place.rooms is not None and things.place.anchor is None
    if not (named and means_one(things) and not things.refers and context.earlier):
        return statement
    found = things_of(state, things, context)
    before = [item for item in found if item.id not in context.things]
    arrived = [item for item in found if item.id in context.things and item.room in context.rooms]
    if len(before) != 1 or len(arrived) != 1:
        return statement
    return msgspec.structs.replace(statement, things=Things(noun=before[0].id, definite=True))


def _of_own_room(item: SceneObject, statement: Move, targets: list[Target]) -> list[Target]:
    """Return the places in the own room of a thing where several rooms each keep their things, else all of them.

    Where words for any of several ("one of the shelves") name no room, the nearest are meant.
    """
    source = statement.things.place
    rooms = statement.place.rooms
    if rooms is None and names_any(statement.place):
        near = [target for target in targets if target.room == item.room]
        storey = item.room.split("/", 1)[0]
        return near or [target for target in targets if target.room.split("/", 1)[0] == storey] or targets
    if source is None or rooms is None or not rooms.every or source.rooms != rooms:
        return targets
    own = [target for target in targets if target.room == item.room]
    if not own:
        raise Unmet(f"there is nothing {place_words(statement.place)} for {item.id} in {item.room}")
    return own


def _on_other_storey(state: SceneState, things: Things, place: Place, context: Context) -> tuple[Place, Context]:
    """Return the place with the room there that is of the kind of the one that things come from: ``up one floor``."""
    near = from_there(state, things, place, context)
    if near is context or place.rooms is None or place.rooms.words:
        return place, near
    kinds = {found[1].room_type for name in near.rooms if (found := state.room(name)) is not None}
    there = [name for name in rooms_of(state, place.rooms, near) if state.room(name) is not None]
    alike = [name for name in there if (found := state.room(name)) is not None and found[1].room_type in kinds]
    chosen = alike if len(alike) == 1 else there
    return (msgspec.structs.replace(place, rooms=Rooms(words=chosen[0])) if len(chosen) == 1 else place), near


def _is(ids: Sequence[str] | set[str]) -> str:
    return "is" if len(ids) == 1 else "are"


def _new(things: Things) -> Things:
    return msgspec.structs.replace(things, definite=False, place=None, owned="")


def _targets(
    state: SceneState, place: Place, context: Context, found: Sequence[SceneObject], moving: Sequence[SceneObject]
) -> list[Target]:
    if place.outside:
        raise Unmet(f"say where to, not only {place_words(place)}")
    if place.anchor is None and place.rooms is None:
        return []
    storeys = {item.room.split("/", 1)[0] for item in found}
    besides = {item.id for item in moving}
    targets = places_of(state, place, context, fits=lambda room: storeys == {room.split("/", 1)[0]}, besides=besides)
    if not targets:
        raise Unmet(f"there is nothing {place_words(place)}: no such thing is there")
    return targets


def _to_move(
    state: SceneState, statement: Move, away: list[SceneObject], targets: list[Target], context: Context
) -> list[SceneObject]:
    """Return the things that words mean; of several fits for one thing, the one that is in the room it goes to."""
    things = statement.things
    rooms = {target.room for target in targets}
    floors = {room.split("/", 1)[0] for room in rooms}
    here = [item for item in away if item.room in rooms]
    near = here or [item for item in away if item.room.split("/", 1)[0] in floors]
    ids = {item.id for item in away}
    if means_one(things) and len(away) < len(things_of(state, things, context)):
        # One that is there already is not what shall go there.
        narrowed = away if len(away) == 1 else near if len(near) == 1 else []
        if narrowed:
            return narrowed
    _refuse_scattered(state, statement, away, here, context)
    prefer = here if here else near
    alike = {item.id for item in prefer}
    chosen = things_meant(state, things, context, lambda item: item.id in alike)
    if means_one(things) or things.plural or things.refers:
        return [item for item in chosen if item.id in ids]
    going = [item for item in chosen if item.id in ids]
    spare = [item for item in (*prefer, *away) if item not in chosen]
    return [*going, *{item.id: item for item in spare}.values()][: len(chosen)]


def _refuse_scattered(
    state: SceneState, statement: Move, away: list[SceneObject], here: list[SceneObject], context: Context
) -> None:
    """Refuse to gather ``the boots`` from several rooms, none of which was mentioned or is the one they go to.

    Raises
    ------
    Ambiguous
    """
    things = statement.things
    rooms = list(dict.fromkeys(item.room for item in away))
    if _is_bare_plural(statement) and len(rooms) > 1 and not here and not set(rooms) & set(context.rooms):
        raise ambiguous(thing_words(things), [f"those in {room_title(state, room)}" for room in rooms], rooms)


def _is_bare_plural(statement: Move) -> bool:
    """Whether ``the boots`` move, of which nothing tells where they are, nor that all of them are meant."""
    things = statement.things
    bare = things.definite and things.plural and things.amount.kind in ("some", "all") and not things.amount.number
    told = things.place is not None or things.owned or things.refers or things.colour or things.material
    return bare and not told and not _WHOLE.search(statement.quote)


def _moved_to_any(
    item: SceneObject, place: Place, targets: list[Target], state: SceneState
) -> Generator[Action, Outcome, str]:
    reasons = []
    for target in targets[:MOST_CARRIERS] or [Target(item.room)]:
        for arguments in (yield from _ways(item, place, target, state, own=not targets)):
            answer = yield Action(f"{item.id} should go there.", "MoveObject", {"object_id": item.id, **arguments})
            if answer.error is not None:
                reasons.append(answer.error.info.message)
                continue
            new = _id_after(item.id, answer.value.object_ids, state)
            if not (_only_inside(new, place, target, state) or _hidden(new, place, target, state)):
                return new
            (item,) = live(state, [new])
            reasons.append(f"there is no free place on {arguments['receptacle_id']} for {item.id}, only in it")
    if len(targets) == 1 and targets[0].anchor is not None and place.relation in ("on", "in"):
        known = {other.id for _, other in state.objects()}
        anchor, info = targets[0].anchor.id, object_info(state, *state.get(item.id))
        reason = yield from move_after_clearing(info, anchor, reasons[-1], state)
        if not reason:
            fresh = [other.id for _, other in state.objects() if other.id not in known and other.asset == item.asset]
            new = _id_after(item.id, fresh, state)
            if not _only_on_top(new, place, targets[0], state):
                return new
    raise Unmet("; ".join(dict.fromkeys(reasons)) or f"there is no place for {item.id}")


def _only_inside(object_id: str, place: Place, target: Target, state: SceneState) -> bool:
    """Whether an object went into a piece of furniture on whose top it should lie."""
    asset = None if target.anchor is None else state.asset(target.anchor)
    (item,) = live(state, [object_id])
    return place.relation == "on" and asset is not None and carries_on_top(asset) and item.mount == "inside"


def _hidden(object_id: str, place: Place, target: Target, state: SceneState) -> bool:
    """Whether an object that was brought to a room went into furniture that has a top to put it on."""
    (item,) = live(state, [object_id])
    holder = None if item.parent is None else state.find(item.parent)
    asset = None if holder is None else state.asset(holder[1])
    anywhere = target.anchor is None and not place.relation and item.mount == "inside"
    return anywhere and asset is not None and carries_on_top(asset)


def _only_on_top(object_id: str, place: Place, target: Target, state: SceneState) -> bool:
    """Whether an object went on top of a piece of furniture in which it should lie."""
    asset = None if target.anchor is None else state.asset(target.anchor)
    (item,) = live(state, [object_id])
    shelves = asset is not None and any(surface.kind == "shelf" for surface in asset.surfaces)
    return (
        place.relation == "in" and asset is not None and bool(asset.volumes) and not shelves and item.mount != "inside"
    )


def _ways(
    item: SceneObject, place: Place, target: Target, state: SceneState, *, own: bool
) -> Generator[Action, Outcome, list[dict[str, Any]]]:
    """Return arguments of MoveObject, the best first."""
    wishes = wishes_of(place, target)
    if target.anchor is not None and place.relation in ("on", "in"):
        asset = state.asset(target.anchor)
        inward = place.relation == "in" and asset is not None and bool(asset.volumes)
        return [{"receptacle_id": target.anchor.id, **wishes, **({"inside": True} if inward else {})}]
    if target.anchor is not None:
        holder = target.anchor.parent if is_loose(item) else None
        tops = counters_by(target.anchor, place, state) if item.mount != "floor" and is_loose(item) else []
        return [{"receptacle_id": name, **wishes} for name in (*tops, holder or target.room)]
    if own and not place.on_floor:
        return [wishes]
    if own or not is_loose(item) or place.spot or place.on_floor:
        return [{"receptacle_id": target.room, **wishes}]
    surfaces = yield from find_surfaces(Scope("room", "", (target.room,)), state, item.name or item.category)
    ways = [{"receptacle_id": surface, **wishes} for surface in surfaces[:MOST_CARRIERS] if surface != item.id]
    return ways if item.toggleable else [*ways, {"receptacle_id": target.room, **wishes}]  # no microwave on the floor


def _id_after(old: str, changed: Sequence[str], state: SceneState) -> str:
    """Return the id of what moved: a new one where it went to another storey."""
    if state.find(old) is not None:
        return old
    return next(name for name in changed if state.find(name) is not None)


def swap(statement: Swap, state: SceneState, context: Context) -> Work:
    """Let two things, or two rooms, exchange their places."""
    one, other = statement.one, statement.other
    if isinstance(one, Rooms) and isinstance(other, Rooms):
        return (yield from swap_rooms(one, other, state, context))
    if isinstance(one, Rooms) or isinstance(other, Rooms):
        raise Unmet("a room and a thing cannot change places")
    first, second = (things_meant(state, things, context) for things in (one, other))
    if one == other and len(first) == 2:
        first, second = first[:1], first[1:]
    if len(first) != 1 or len(second) != 1:
        raise Unmet(f"{listed(first)} and {listed(second)}: say which two things change places")
    arguments = {"object_id": first[0].id, "other_id": second[0].id}
    yield from ask("They change places.", "SwapObjects", arguments)
    ids = [first[0].id, second[0].id]
    rooms = tuple(dict.fromkeys(item.room for item in live(state, ids)))
    return Done(f"{ids[0]} and {ids[1]} changed places", context.followed(ids, rooms, ""))


def turn(statement: Turn, state: SceneState, context: Context) -> Work:
    """Turn things where they stand."""
    marks = [] if statement.facing is None else things_of(state, statement.facing, context)
    rooms_of_marks = {mark.room for mark in marks}
    items = things_meant(state, statement.things, context, lambda item: {item.room} == rooms_of_marks)
    replies = []
    for item in items:
        turns = _rotations(statement, item, state, context)
        before = item.rotation
        reason = ""
        for (dx, dy), rotation in ((aside, turn) for aside in _asides(item) for turn in turns):
            x, y = (round(at + by, 4) for at, by in zip(item.position[:2], (dx, dy), strict=True))
            arguments = {"object_id": item.id, "x": x, "y": y, "rotation": rotation}
            answer = yield Action(f"{item.id} should turn.", "MoveObject", arguments)
            if answer.error is None:
                moved = f" and moved by {math.hypot(dx, dy):.1f} m, as it had no room to turn" if dx or dy else ""
                replies.append(f"{item.id} turned from {before:g} to {rotation:g} degrees{moved}")
                break
            reason = reason or answer.error.info.message
        else:
            raise Unmet(reason)
    rooms = tuple(dict.fromkeys(item.room for item in items))
    return Done("; ".join(replies), context.followed([i.id for i in items], rooms, statement.things.noun))


def _rotations(statement: Turn, item: SceneObject, state: SceneState, context: Context) -> list[float]:
    if statement.spot:
        straight = rotation_towards(item, faced_point(statement.spot, item, state))
        return _square_first(item, straight)
    if statement.facing is None:
        either = abs(statement.degrees) == _QUARTER and not _WAY_ROUND.search(statement.quote)
        ways = (statement.degrees, -statement.degrees) if either else (statement.degrees,)
        return [round((item.rotation + degrees) % 360.0, 4) for degrees in ways]
    facing = msgspec.structs.replace(
        statement.facing, place=statement.facing.place or Place(rooms=Rooms(words=item.room))
    )
    (target,) = things_meant(state, facing, context)[:1]
    return _square_first(item, facing_rotation(item, target))


def _asides(item: SceneObject) -> list[tuple[float, float]]:
    """Return by how much a thing may move so that it has room to turn, the least first; what lies on a top stays."""
    if item.mount != "floor":
        return [(0.0, 0.0)]
    steps = [round(0.1 * k, 1) for k in range(-_STEPS_ASIDE, _STEPS_ASIDE + 1)]
    found = [(x, y) for x in steps for y in steps if x == 0.0 or y == 0.0 or abs(x) == abs(y)]
    return sorted(found, key=lambda by: (round(math.hypot(*by), 4), by))


def _square_first(item: SceneObject, straight: float) -> list[float]:
    """Return a rotation, before it the one square to the present one where that looks nearly the same way."""
    square = round((item.rotation + 90.0 * round((straight - item.rotation) / 90.0)) % 360.0, 4)
    return [square, straight] if abs((square - straight + 180.0) % 360.0 - 180.0) <= 25.0 else [straight]


def facing_rotation(item: SceneObject, target: SceneObject) -> float:
    """Return the rotation at which the front of an object points to the middle of another, degrees."""
    return rotation_towards(item, (target.position[0], target.position[1]))
