"""Checks of statements about numbers: Add, Ensure, Remove, Clear and Replace."""

import msgspec

from mansion_editing.instructions.checking.differences import Differences, carried_below
from mansion_editing.instructions.checking.finding import (
    Finding,
    any_number,
    at_shares,
    joined_by_room,
    numbers_meant,
    shares_of,
)
from mansion_editing.instructions.doing.work import listed
from mansion_editing.instructions.meaning.choices import concerned
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import all_at, anchors_of, carried_by, things_of
from mansion_editing.instructions.meaning.measured import compares
from mansion_editing.instructions.meaning.nouns import is_loose
from mansion_editing.instructions.meaning.numbers import (
    is_shared_out,
    means_any_in_each_room,
    means_several,
    new_number,
)
from mansion_editing.instructions.meaning.sparing import is_movable, spared_among, spares_furniture
from mansion_editing.instructions.meaning.wording import place_words, thing_words
from mansion_editing.instructions.statements import Add, Clear, Ensure, Place, Remove, Replace, Things
from mansion_editing.state import SceneState
from mansion_msgs_py.scene import SceneObject

__all__ = ["check_add", "check_clear", "check_ensure", "check_remove", "check_replace"]


def _new_carriers(place: Place, before: SceneState, after: SceneState, context: Context, diff: Differences) -> set[str]:
    """Return new furniture that answers to the words for what new things are on or in, where there was none."""
    if place.anchor is None:
        return set()
    having = {item.room for item in anchors_of(before, place, context)}
    if having and not means_any_in_each_room(place):
        return set()
    new = [item for item in things_of(after, any_number(place.anchor), context) if item.id in diff.added]
    return {item.id for item in new if item.room not in having}


def _named(things: Things, context: Context) -> Things:
    if things.refers and not things.noun:
        return msgspec.structs.replace(things, noun=context.noun)
    return things


def _whole(things: Things, place: Place) -> Place:
    """Return the place that a statement means; with none of its own, the one of its things."""
    own = things.place
    if own is None or place == Place():
        return own or place
    return msgspec.structs.replace(place, rooms=place.rooms or own.rooms) if place.anchor else place


def _for_each(place: Place, *, each: bool) -> bool:
    if each:
        return True
    if place.anchor is not None:
        return place.anchor.amount.kind == "all"
    return place.rooms is not None and place.rooms.every and bool(place.rooms.words)


def check_add(statement: Add, before: SceneState, after: SceneState, context: Context, diff: Differences) -> Finding:
    """Check that so many things more than before are at the place."""
    things, place = _named(statement.things, context), _whole(statement.things, statement.place)
    alike = [item for item in things_of(after, any_number(things), context) if item.id in diff.added]
    shares = shares_of(place, before, after, context)
    at = joined_by_room(place, shares, at_shares(after, alike, shares, context))
    new = set().union(*at)
    number = new_number(things)
    if number == 0:
        return Finding("none is wanted there, and that adds nothing: say what is to be removed")
    counts = [len(ids) for ids in at]
    if is_shared_out(things, place, each=statement.each):
        holds = len(new) == number
    elif _for_each(place, each=statement.each):
        holds = bool(counts) and all(count >= number for count in counts) and len(new) == number * len(counts)
    else:
        holds = number in counts and len(new) % number == 0
    carriers = _new_carriers(place, before, after, context, diff)
    words = f"{number} new {thing_words(any_number(things))} {place_words(place)}"
    reason = "" if holds else f"there are not {words}, but {len(new)}"
    return Finding(reason, new | (carriers - new), makes_room=True)


def check_ensure(
    statement: Ensure, before: SceneState, after: SceneState, context: Context, diff: Differences
) -> Finding:
    """Check the number at the place, that no more came than were missing, and that none left unasked."""
    things, place = _named(statement.things, context), _whole(statement.things, statement.place)
    kind = things.amount.kind
    if kind == "more":
        return check_add(Add(things=things, place=place, each=statement.each), before, after, context, diff)
    number = new_number(things)
    words = any_number(things)
    shares = shares_of(place, before, after, context)
    olds = joined_by_room(place, shares, at_shares(before, things_of(before, words, context), shares, context))
    news = joined_by_room(place, shares, at_shares(after, things_of(after, words, context), shares, context))
    if place.anchor is None and not _for_each(place, each=statement.each):
        olds, news = [set().union(*olds)], [set().union(*news)]
    good = [_is_number(kind, len(ids), number) for ids in news]
    whole = _for_each(place, each=statement.each) or kind in ("at_most", "none")
    holds = all(good) if whole else any(good)
    if not whole and kind in ("some", "at_least"):
        holds = holds or len(set().union(*news)) >= number
    came = {name for ids in news for name in ids} & set(diff.added)
    gone = {name for ids in olds for name in ids} & set(diff.removed)
    most = sum(max(0, number - len(ids)) for ids in olds)
    if is_shared_out(things, place, each=statement.each):
        most = max(0, number - len(set().union(*olds)))
    reason = ""
    if not holds:
        counts = ", ".join(str(len(ids) or "none") for ids in news) or "none"
        reason = f"{thing_words(things)} {place_words(place)}: there are {counts}"
    elif len(came) > most or (gone and kind not in ("exactly", "at_most", "none")):
        reason = f"{len(came)} came and {len(gone)} left, though {most} were missing"
    carriers = _new_carriers(place, before, after, context, diff)
    return Finding(reason, came | gone | carriers | carried_below(before, gone), makes_room=True)


def _is_number(kind: str, count: int, number: int) -> bool:
    if kind in ("exactly", "none"):
        return count == number
    return count <= number if kind == "at_most" else count >= number


def check_remove(
    statement: Remove, before: SceneState, after: SceneState, context: Context, diff: Differences
) -> Finding:
    """Check that the number meant left, and that what else left stood on it."""
    things = statement.things
    fitting = concerned(before, things, context)
    gone = [item for item in fitting if item.id in diff.removed]
    roots = {item.id for item in gone}
    low, high = numbers_meant(things, fitting, surplus=True)
    reason = ""
    if fitting and not low <= len(gone) <= high:
        reason = f"{len(gone)} of {len(fitting)} {thing_words(things)} left"
    carried = carried_below(before, {item.id for item in gone if item.parent is None})
    settled = {name for name, (old, new) in diff.moved.items() if old.parent in roots and new.room == old.room}
    return Finding(reason, roots | (carried & set(diff.removed)) | settled)


def check_clear(
    statement: Clear, before: SceneState, after: SceneState, context: Context, diff: Differences
) -> Finding:
    """Check that nothing loose is left but what is spared, and that only loose things left."""
    whole = spares_furniture(before, statement, context)
    there = _loose_at(statement.place, before, after, before, context, furniture=whole)
    spared = spared_among(before, statement.spare, there, context) | context.kept
    left = [
        item
        for item in _loose_at(statement.place, before, after, after, context, furniture=whole)
        if item.id not in spared
    ]
    bearing = {found[1].parent for name in spared if (found := after.find(name)) is not None}
    left = [item for item in left if item.id not in bearing]
    lost = sorted(spared & set(diff.removed))
    reason = f"{listed(left)} is still {place_words(statement.place)}" if left else ""
    reason = f"{listed(lost)} should have stayed" if lost else reason
    roots = {item.id for item in there if item.id in diff.removed}
    return Finding(reason, roots | (carried_below(before, roots) & set(diff.removed)))


def _loose_at(
    place: Place, before: SceneState, after: SceneState, state: SceneState, context: Context, *, furniture: bool = False
) -> list[SceneObject]:
    """Return what is loose at a place of which something was cleared; all that it may be where nothing was."""
    if place.anchor is None or place.relation not in ("on", "in", ""):
        pool = all_at(state, [i for _, i in state.objects()], place, context)
        return [item for item in pool if is_loose(item) or (furniture and is_movable(item))]
    holders = anchors_of(before, place, context)
    emptied = {item.parent for _, item in before.objects() if after.find(item.id) is None}
    holders = [item for item in holders if item.id in emptied] or holders[
        : 1 if not means_several(place.anchor) else None
    ]
    relations = (place.relation,) if place.relation else ("on", "in")
    now = [found[1] for item in holders if (found := state.find(item.id)) is not None]
    return [item for holder in now for rel in relations for item in carried_by(state, holder, rel) if is_loose(item)]


def check_replace(
    statement: Replace, before: SceneState, after: SceneState, context: Context, diff: Differences
) -> Finding:
    """Check that things left and that new ones of the other kind came into the same rooms, onto the same furniture."""
    fitting = concerned(before, statement.things, context)
    low, high = numbers_meant(statement.things, fitting)
    alike = {item.id: item for item in things_of(after, any_number(statement.by), context)}
    # A new thing of the same kind may get the id that the old one leaves.
    taken = [item.id for item in fitting if item.id in alike and item.id in {*diff.moved, *diff.changed}]
    gone = [item for item in fitting if item.id in diff.removed or item.id in taken]
    came = [item for name, item in alike.items() if name in diff.added or name in taken]
    rooms, parents = {item.room for item in gone}, {item.parent for item in gone}
    lain = None not in parents
    stray = [item for item in came if item.room not in rooms or (lain and item.parent and item.parent not in parents)]
    number = new_number(statement.by)
    reason = ""
    if not low <= len(gone) <= high:
        reason = f"{len(gone)} of {len(fitting)} {thing_words(statement.things)} left"
    elif len(came) not in (number, len(gone)) or not came:
        reason = f"{len(came)} {thing_words(any_number(statement.by))} came for {len(gone)}"
    elif stray:
        reason = f"{listed(stray)} is not where the old ones were"
    elif not all(compares(statement.by.hints, new.size, old.size) for new in came for old in gone):
        reason = f"{listed(came)} is not {' and '.join(statement.by.hints)}"
    roots = {item.id for item in gone}
    carried = carried_below(before, roots) & {*diff.removed, *diff.moved}
    return Finding(reason, roots | {item.id for item in came} | carried, makes_room=True)
