"""Checks of statements about places: Move, Swap and Turn."""

import math
import re

import msgspec

from mansion_editing.instructions.checking.differences import Differences, carried_below
from mansion_editing.instructions.checking.finding import Finding, any_number, at_shares, numbers_meant, shares_of
from mansion_editing.instructions.checking.numbers import check_add
from mansion_editing.instructions.doing.gathering import are_together, gathered
from mansion_editing.instructions.doing.moving import of_goal_room
from mansion_editing.instructions.doing.stowing import is_stowed
from mansion_editing.instructions.doing.work import listed
from mansion_editing.instructions.meaning.choices import at_home, concerned, from_there, things_meant
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import rooms_of, things_of
from mansion_editing.instructions.meaning.directions import direction_of, faced_point, rotation_towards
from mansion_editing.instructions.meaning.wording import place_words, thing_words
from mansion_editing.instructions.phrases.each_other import EACH_OTHER
from mansion_editing.instructions.phrases.storage import AWAY
from mansion_editing.instructions.statements import Add, Move, Rooms, Shift, Swap, Turn
from mansion_editing.state import SceneState
from mansion_editing.tools.relations import relation_holds
from mansion_msgs_py.scene import SceneObject

__all__ = ["check_move", "check_shift", "check_swap", "check_turn"]


def check_move(statement: Move, before: SceneState, after: SceneState, context: Context, diff: Differences) -> Finding:
    """Check that the number meant is at the place now, and that nothing else went there."""
    things, place = statement.things, statement.place
    if place.anchor == EACH_OTHER:
        return _check_gathered(statement, before, after, context, diff)
    if place == AWAY:
        return _check_stowed(statement, before, after, context, diff)
    things = of_goal_room(statement, before, context).things
    fitting = concerned(before, things, context)
    place = at_home(before, things, place, context)
    context = from_there(before, things, place, context)
    if not fitting and statement.or_new:
        new = msgspec.structs.replace(things, definite=False, place=None)
        return check_add(Add(things=new, place=place), before, after, context, diff)
    if not fitting and not diff.ids:
        shares = shares_of(place, before, after, context)
        there = set().union(*at_shares(after, things_of(after, any_number(things), context), shares, context))
        return Finding("" if there else f"there is no {thing_words(things)} {place_words(place)}")
    gone_to = diff.relocated()
    went = {item.id: gone_to[item.id] for item in fitting if item.id in gone_to}
    if place.anchor is None and place.rooms is None:
        rooms = Rooms(every=True)
        place = msgspec.structs.replace(place, rooms=rooms)
    shares = shares_of(place, before, after, context)
    now = {item.id: went.get(item.id) or _same(after, item) for item in fitting}
    there = set().union(*at_shares(after, [item for item in now.values() if item is not None], shares, context))
    missed = [name for name, item in went.items() if item.id not in there]
    arrived = sum(item is not None and item.id in there for item in now.values())
    low, high = numbers_meant(things, fitting)
    reason = ""
    if missed:
        reason = f"{listed(missed)} moved, but not {place_words(place)}"
    elif arrived < low:
        reason = f"{arrived} of {thing_words(things)} is {place_words(place)}, not {low}"
    elif len(went) > high:
        reason = f"{listed(list(went))} moved, though {high} were meant"
    carried = carried_below(before, went)
    arrivals = {item.id for item in went.values()}
    below = carried_below(after, arrivals)
    return Finding(reason, set(went) | arrivals | carried | below, makes_room=True)


def _check_gathered(
    statement: Move, before: SceneState, after: SceneState, context: Context, diff: Differences
) -> Finding:
    """Check that the things meant are beside one another, in the room where they were."""
    meant = gathered(statement, before, context)
    now = [found[1] for item in meant if (found := after.find(item.id)) is not None]
    apart = len(now) < len(meant) or len({item.room for item in now}) > 1 or not are_together(after, now)
    went = {item.id for item in meant if item.id in diff.moved}
    reason = f"{thing_words(statement.things)} are not next to each other" if apart else ""
    return Finding(reason, went | carried_below(before, went), makes_room=True)


def _check_stowed(
    statement: Move, before: SceneState, after: SceneState, context: Context, diff: Differences
) -> Finding:
    """Check that the things meant are in furniture of the room where they were."""
    meant = things_meant(before, statement.things, context)
    now = [found[1] for item in meant if (found := after.find(item.id)) is not None]
    stowed = [item for item in now if is_stowed(item, after)]
    same_room = all(one.room == item.room for one, item in zip(meant, now, strict=False))
    reason = "" if len(stowed) == len(meant) and same_room else f"{thing_words(statement.things)} is not put away"
    went = {item.id for item in meant if item.id in diff.moved}
    return Finding(reason, went | carried_below(before, went), makes_room=True)


def _same(after: SceneState, item: SceneObject) -> SceneObject | None:
    found = after.find(item.id)
    return None if found is None else found[1]


_EXACT = 0.05
"""Greatest difference between the way that something moved and the length that was asked for, metres."""


def check_shift(
    statement: Shift, before: SceneState, after: SceneState, context: Context, diff: Differences
) -> Finding:
    """Check that things moved so far, in the direction that was asked for, within their room."""
    fitting = concerned(before, statement.things, context)
    went = {item.id: diff.moved[item.id] for item in fitting if item.id in diff.moved}
    low, high = numbers_meant(statement.things, fitting)
    reason = "" if low <= len(went) <= high else f"{len(went)} of {len(fitting)} {thing_words(statement.things)} moved"
    for name, (old, new) in went.items():
        dx, dy = direction_of(statement, old, before, context)
        wanted = (old.position[0] + statement.metres * dx, old.position[1] + statement.metres * dy)
        if math.dist(new.position[:2], wanted) > _EXACT or old.room != new.room:
            reason = f"{name} did not move by {statement.metres:g} m that way"
    return Finding(reason, set(went) | carried_below(before, went))


_ASIDE = 0.75
"""Greatest distance by which a thing moves aside so that it can turn, metres."""
_WAY_ROUND = re.compile(r"clockwise|\b(left|right|counter|anti)", re.IGNORECASE)
_FACING = 30.0
"""Greatest angle between where a front points and the window, door or wall that it faces, degrees."""
_CLOSE = 1.0
"""Greatest distance between where one thing is and where that which it changed places with was, metres."""


def check_swap(statement: Swap, before: SceneState, after: SceneState, context: Context, diff: Differences) -> Finding:
    """Check that each of two things is where the other was, or that only the two rooms changed."""
    if isinstance(statement.one, Rooms) or isinstance(statement.other, Rooms):
        ends = [end for end in (statement.one, statement.other) if isinstance(end, Rooms)]
        rooms = {room for end in ends for room in rooms_of(before, end, context)}
        storeys = {f"floor {room.split('/', 1)[0].removeprefix('F')}" for room in rooms}
        inside = {name for name, item in {**diff.removed, **diff.added}.items() if item.room in rooms}
        inside |= {name for name, (old, new) in diff.moved.items() if {old.room, new.room} <= rooms}
        within = inside | {n for n, (old, _) in diff.changed.items() if old.room in rooms}
        return Finding("", within, rooms | storeys)
    gone_to = diff.relocated()
    firsts = [i for i in things_of(before, statement.one, context) if i.id in gone_to]
    seconds = [i for i in things_of(before, statement.other, context) if i.id in gone_to]
    pairs = [(a, b) for a in firsts for b in seconds if a.id != b.id]
    for one, other in pairs:
        new_one, new_other = gone_to[one.id], gone_to[other.id]
        if _took(new_one, other) and _took(new_other, one):
            ids = {one.id, other.id}
            arrived = {new_one.id, new_other.id}
            return Finding("", ids | arrived | carried_below(before, ids) | carried_below(after, arrived))
    words = f"{_words(statement.one)} and {_words(statement.other)}"
    return Finding(f"{words} have not changed places")


def _words(end: object) -> str:
    return thing_words(end) if hasattr(end, "noun") else ""  # type: ignore[arg-type]


def _took(new: SceneObject, old: SceneObject) -> bool:
    """Whether one object is where another was: near it on the same level and storey."""
    same = new.room == old.room and (new.parent is None) == (old.parent is None)
    return same and math.dist(new.position[:2], old.position[:2]) <= _CLOSE


def check_turn(statement: Turn, before: SceneState, after: SceneState, context: Context, diff: Differences) -> Finding:
    """Check that things stand where they stood and are turned as far, or to what, they should be."""
    fitting = concerned(before, statement.things, context)
    turned = [item for item in fitting if item.id in diff.moved]
    low, high = numbers_meant(statement.things, fitting)
    reason = ""
    for old in turned:
        new = diff.moved[old.id][1]
        if math.dist(old.position, new.position) > _ASIDE or old.room != new.room:
            reason = f"{old.id} is not where it stood"
        elif statement.spot:
            off = (
                new.rotation - rotation_towards(new, faced_point(statement.spot, new, after)) + 180.0
            ) % 360.0 - 180.0
            reason = "" if abs(off) <= _FACING else f"{old.id} does not face the {statement.spot}"
        elif statement.facing is None:
            either = abs(statement.degrees) == 90.0 and not _WAY_ROUND.search(statement.quote)
            ways = (statement.degrees, -statement.degrees) if either else (statement.degrees,)
            offs = [(new.rotation - old.rotation - degrees + 180.0) % 360.0 - 180.0 for degrees in ways]
            reason = (
                "" if min(map(abs, offs)) <= 1.0 else f"{old.id} is turned by {new.rotation - old.rotation:g} degrees"
            )
        if reason:
            break
    if statement.facing is not None and not reason:
        place = statement.facing.place
        marks = things_of(before, statement.facing, context)
        marks = marks if place is not None else [m for m in marks if m.room in {i.room for i in fitting}]
        good = {i.id for i in fitting if any(_faces(after, i, mark) for mark in marks)}
        if len(good) < max(1, low) or any(item.id not in good for item in turned):
            reason = f"{thing_words(statement.things)} does not face {thing_words(statement.facing)}"
    if not reason and (len(turned) > high or (not (statement.facing or statement.spot) and len(turned) < low)):
        reason = f"{len(turned)} of {len(fitting)} {thing_words(statement.things)} turned"
    ids = {item.id for item in turned}
    return Finding(reason, ids | carried_below(before, ids))


def _faces(after: SceneState, item: SceneObject, mark: SceneObject) -> bool:
    found = after.find(item.id)
    return found is not None and item.id != mark.id and relation_holds(after, found[1], facing=mark.id)
