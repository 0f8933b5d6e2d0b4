"""Verdicts on wishes for rooms: how many, where, how large and beside which others, and those that are not wanted."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Final

from mansion_bringup.building.judged_building import JudgedBuilding, JudgedRoom
from mansion_bringup.building.verdicts import BOUNDS, Judge, Verdict, comma_separated, keeps_to, met_if
from mansion_knowledge.room_kinds import is_one_of
from mansion_msgs_py.wishes import Wish
from mansion_msgs_py.wording import in_words

__all__ = ["ROOM_JUDGES"]


_TOLERANCE: Final = 0.1
"""Share by which a finished room may miss the area that is asked for and still have it."""
_TOLERANCE_OF_PLAN: Final = 0.15
"""The same of a planned room: the solver makes most of them better."""
_SMALLEST: Final = 0.25
"""Square metres by which any room may miss it: the thickness of a wall."""


def _room(wish: Wish, state: JudgedBuilding) -> Verdict:
    value, floors = wish.value, wish.scope.floors
    if wish.scope.unit:
        return _held(wish, state)
    rooms = state.called(value.name, value.type, floors)
    rooms = [room for room in rooms if room.full_id not in state.private] or rooms
    rooms = [room for room in rooms if not state.has_own_name(room, value.name)] or rooms
    if value.whole:
        rooms = [replace(room, area=room.area + sum(other.area for other in state.behind(room))) for room in rooms]
    ids = [room.full_id for room in rooms]
    if not rooms:
        elsewhere = state.called(value.name, value.type)
        if elsewhere:
            where = comma_separated(sorted({room.floor for room in elsewhere}))
            return Verdict("partly", f"on storey {where} instead", [room.full_id for room in elsewhere])
        return Verdict("not_met", "no room of this kind found a place")
    wanted = _wanted(wish, state)
    if wish.scope.each and floors:
        counts = Counter(room.floor for room in rooms)
        short = [floor for floor in floors if counts[floor] != (wanted or max(counts[floor], 1))]
        if short:
            return Verdict(
                "partly", f"storey {comma_separated(short)} has {comma_separated([counts[f] for f in short])}", ids
            )
    elif wanted is None and len(rooms) < 2:
        return Verdict("partly", "one room where several are asked for", ids)
    elif wanted is not None and (len(rooms) < wanted or (len(rooms) > wanted and not _may_be_more(wish))):
        return Verdict("partly", f"{len(rooms)} of {wanted}", ids)
    owners = state.called(wish.scope.room, wish.scope.room_type, floors) if wish.scope.room else []
    bare = [owner.full_id for owner in owners if not any(state.near(owner, room) for room in rooms)]
    if bare:
        return Verdict("partly", f"{comma_separated(bare[:3])} has none beside it", ids)
    if value.area is not None:
        close = [
            room
            for room in rooms
            if (keeps_to(wish, room.area) if value.limit else _close(room.area, value.area, state))
        ]
        if len(close) < min(_of_that_area(wish, state, len(rooms)), len(rooms)):
            sizes = ", ".join(f"{room.area:.3g}" for room in rooms[:4])
            return Verdict("partly", f"{sizes} m2 instead of {BOUNDS[value.limit]}{value.area:.3g} m2", ids)
    lack = _unusable(rooms, state) or _shut_off(rooms, state) or _outranked(wish, rooms, state)
    return met_if(not lack, lack, partly=True, rooms=ids)


def _outranked(wish: Wish, rooms: Sequence[JudgedRoom], state: JudgedBuilding) -> str:
    """Say which room of the type is larger than the one that is to be the largest, or smaller than the smallest."""
    if not wish.value.rank:
        return ""
    large = wish.value.rank == "largest"
    others = [room for room in state.rooms if room.type == wish.value.type and room not in rooms]
    sign = 1 if large else -1
    beyond = [other for other in others if any(sign * (other.area - room.area) > _SMALLEST for room in rooms)]
    return f"{beyond[0].full_id} is {'larger' if large else 'smaller'}: {beyond[0].area:.3g} m2" if beyond else ""


def _shut_off(rooms: Sequence[JudgedRoom], state: JudgedBuilding) -> str:
    """Say which open kitchen is reached from a passage alone; empty where each is open to another room.

    A plan has no doors yet but those that rooms are reached by, so that of its kitchens nothing is said.
    """
    others = [room for room in state.rooms if room.type not in _WAYS]
    kitchens = [room for room in rooms if room.type == "open_kitchen" and not state.planned]
    shut = [room for room in kitchens if not any(state.joined(room, other) for other in others)]
    return f"{shut[0].full_id} is open to no other room" if shut else ""


def _may_be_more(wish: Wish) -> bool:
    """Whether a building may have more of a room than asked for: ways on other storeys, or what others have too."""
    return bool(wish.scope.room) or (wish.value.type in _WAYS and not wish.scope.floors)


def _unusable(rooms: Sequence[JudgedRoom], state: JudgedBuilding) -> str:
    """Say what the first rooms that cannot be used have not; empty where all can."""
    lacks = [(room.full_id, room.equipment.lack(_unwanted_in(room, state))) for room in rooms]
    return "; ".join(f"{name} {lack}" for name, lack in [entry for entry in lacks if entry[1]][:2])


def _unwanted_in(room: JudgedRoom, state: JudgedBuilding) -> list[str]:
    """Return the categories of which the brief wants none in a room."""
    wishes = [wish for wish in state.program.wishes if wish.kind == "no_object" and wish.value.type]
    return [wish.value.type for wish in wishes if _is_about(wish, room, state)]


def _is_about(wish: Wish, room: JudgedRoom, state: JudgedBuilding) -> bool:
    scope = wish.scope
    if scope.room:
        return room.full_id in {other.full_id for other in state.called(scope.room, scope.room_type, scope.floors)}
    return not scope.floors or room.floor in scope.floors


def _held(wish: Wish, state: JudgedBuilding) -> Verdict:
    """Judge what each flat or other unit is to hold: the room itself and those behind it count."""
    owners = state.called(wish.scope.unit, wish.scope.unit_type, wish.scope.floors)
    if not owners:
        return Verdict("not_met", f"there is no {in_words(wish.scope.unit)}")
    wanted, ids, other, small = _wanted(wish, state), [], [], []
    for owner in owners:
        there = [owner, *state.behind(owner)]
        rooms = [room for room in there if wish.value.name in room.names]
        rooms = rooms or [room for room in there if room.type == wish.value.type]
        ids += [room.full_id for room in rooms]
        if len(rooms) != wanted and (wanted is not None or len(rooms) < 2):
            other.append(f"{owner.full_id} has {len(rooms)}")
        close = [room for room in rooms if _close(room.area, wish.value.area, state)]
        needed = len(rooms) if len(_alike(wish, state)) < 2 else min(wish.value.count or 1, len(rooms))
        if len(close) < needed:
            small.append(f"{owner.full_id} has {comma_separated([f'{room.area:.3g}' for room in rooms])} m2")
    if other:
        return Verdict("partly" if ids else "not_met", comma_separated(other[:3]), ids)
    held = [room for room in state.rooms if room.full_id in ids]
    lack = comma_separated(small[:3]) or _unusable(held, state)
    return met_if(not lack, lack, partly=True, rooms=ids)


def _close(area: float, wanted: float | None, state: JudgedBuilding) -> bool:
    """Whether a room has the area that is asked for, if any is."""
    share = _TOLERANCE_OF_PLAN if state.planned else _TOLERANCE
    return wanted is None or abs(area - wanted) <= max(share * wanted, _SMALLEST) + 1e-6


def _wanted(wish: Wish, state: JudgedBuilding) -> int | None:
    """How many rooms of the name the brief wants in the wish's scope, over all wishes that share both."""
    counts = [other.value.count for other in _alike(wish, state)]
    return None if any(count is None for count in counts) else sum(count or 0 for count in counts)


def _of_that_area(wish: Wish, state: JudgedBuilding, there: int) -> int:
    """How many rooms are to have the wish's area: all of the name, or its share where several wishes ask for some."""
    if len(_alike(wish, state)) < 2:
        return there
    storeys = len(wish.scope.floors) if wish.scope.each and wish.scope.floors else 1
    return (wish.value.count or 1) * storeys


def _alike(wish: Wish, state: JudgedBuilding) -> list[Wish]:
    return [
        other
        for other in state.program.wishes
        if other.kind == "room"
        and other.value.name == wish.value.name
        and (other.scope.floors, other.scope.unit) == (wish.scope.floors, wish.scope.unit)
    ]


def _no_room(wish: Wish, state: JudgedBuilding) -> Verdict:
    if wish.value.type == "basement":
        return met_if(all(floor.index >= 1 for floor in state.program.floors), "the building has a basement")
    rooms = [
        room
        for room in state.rooms
        if is_one_of(room.type, wish.value.type) and (not wish.scope.floors or room.floor in wish.scope.floors)
    ]
    return met_if(not rooms, f"{rooms[0].full_id if rooms else ''} is one", rooms=[room.full_id for room in rooms])


def _adjacent(wish: Wish, state: JudgedBuilding) -> Verdict:
    firsts, seconds = (
        state.called(name, kind)
        for name, kind in ((wish.value.name, wish.value.type), (wish.value.other, wish.value.other_type))
    )
    pairs = [(a, b) for a in firsts for b in seconds if state.near(a, b)]
    ids = [room.full_id for pair in pairs[:1] for room in pair]
    if not firsts or not seconds:
        return Verdict("not_met", f"there is no {in_words(wish.value.name if not firsts else wish.value.other)}")
    lonely = [a.full_id for a in firsts if a.full_id not in {first.full_id for first, _ in pairs}]
    if wish.scope.each and pairs and lonely:
        return Verdict("partly", f"{comma_separated(lonely[:3])} lies beside none", ids)
    sides = max(Counter(first.full_id for first, _ in pairs).values(), default=0)
    if pairs and sides < (wish.value.count or 1):
        return Verdict("partly", f"it lies beside {sides} of {wish.value.count}", ids)
    joined = {first.full_id for first, second in pairs if state.joined(first, second)}
    if wish.value.door and pairs and not joined:
        return Verdict("partly", "no door or opening joins them", ids)
    shut = [first.full_id for first, _ in pairs if first.full_id not in joined]
    if wish.value.door and wish.scope.each and shut:
        return Verdict("partly", f"no door or opening joins {comma_separated(shut[:3])} to one", ids)
    same = any(a.floor == b.floor for a in firsts for b in seconds)
    return met_if(bool(pairs), "they share no wall" if same else "they are on different storeys", rooms=ids)


def _apart(wish: Wish, state: JudgedBuilding) -> Verdict:
    firsts, seconds = (
        _all_called(name, kind, state)
        for name, kind in ((wish.value.name, wish.value.type), (wish.value.other, wish.value.other_type))
    )
    pairs = [(a, b) for a in firsts for b in seconds if state.near(a, b)]
    ids = [room.full_id for pair in pairs[:1] for room in pair]
    both = f"{in_words(wish.value.name)} and {in_words(wish.value.other)}"
    return met_if(not pairs, f"{both} share a wall", rooms=ids)


def _all_called(name: str, kind: str, state: JudgedBuilding) -> list[JudgedRoom]:
    """Return the rooms that a name means; "the toilets" are those of every type, under whatever name."""
    if kind not in _TOILETS or "_" in name:
        return state.called(name, kind)
    return [room for room in state.rooms if room.type in _TOILETS or name in room.names]


_TOILETS = frozenset({"toilet", "restroom", "accessible_toilet"})


def _only(wish: Wish, state: JudgedBuilding) -> Verdict:
    """Judge that a storey, or all, has no room but those of the brief, ways and what is reached through them alone."""
    named = {w.value.type for w in state.program.wishes if w.kind == "room"}
    here = [room for room in state.rooms if not wish.scope.floors or room.floor in wish.scope.floors]
    asked = [room for room in here if room.type in named]
    theirs = {other.full_id for room in asked for other in state.behind(room)}
    extra = [room.full_id for room in here if room.type not in named | _WAYS and room.full_id not in theirs]
    return met_if(not extra, f"{comma_separated(extra[:3])} were added", rooms=extra)


_WAYS = frozenset({"corridor", "hallway", "lobby", "stair", "elevator"})


ROOM_JUDGES: Final[Mapping[str, Judge]] = {
    "room": _room,
    "no_room": _no_room,
    "adjacent": _adjacent,
    "apart": _apart,
    "only": _only,
}
"""For each kind of wish for rooms, what judges it."""
