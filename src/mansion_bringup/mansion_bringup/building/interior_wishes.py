"""Verdicts on wishes for what rooms hold and are like: furniture, ceiling heights and materials."""

import math
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Final

from mansion_bringup.building.judged_building import JudgedBuilding, JudgedRoom
from mansion_bringup.building.verdicts import Judge, Verdict, comma_separated, met_if
from mansion_knowledge.object_kinds import answers, noun_of
from mansion_knowledge.object_qualities import has_quality
from mansion_language import is_plural
from mansion_msgs_py.wishes import Wish, WishStatus
from mansion_msgs_py.wording import in_words

__all__ = ["INTERIOR_JUDGES"]

_CEILING = 0.1
"""Metres by which a ceiling may miss the height that is asked for and still meet it."""

_CLUTTERED, _TIDY = 5.0, 1.5
"""Things on a square metre of furniture, at least where many and at most where few are wanted; 2.5 to 4.5 are usual."""

_SUBSTANCES = {
    "wood": "wood wooden hardwood timber parquet plank planks laminate panelling deck decking herringbone"
    " oak walnut pine maple birch bamboo cherry ash beech mahogany",
    "carpet": "carpet carpeted carpeting",
    "tiles": "tile tiles tiled ceramic porcelain terracotta",
    "marble": "marble",
    "granite": "granite",
    "stone": "stone slate limestone",
    "terrazzo": "terrazzo",
    "concrete": "concrete cement",
    "vinyl": "vinyl linoleum lino",
    "rubber": "rubber",
    "resin": "resin epoxy",
    "brick": "brick bricks",
    "plaster": "plaster plastered drywall",
}
"""What surfaces are made of, and the words that say so in a wish, a program or a scene."""


def _object(wish: Wish, state: JudgedBuilding) -> Verdict:
    if not wish.value.type:
        return Verdict("not_met", "the catalogue has nothing of this kind")
    rooms = _object_rooms(wish, state)
    if not rooms:
        return Verdict("not_met", f"there is no {in_words(wish.scope.room)}")
    if wish.scope.some:
        return _in_some(wish, rooms, planned=state.planned)
    counts: Counter[object] = Counter()
    for room in rooms:
        counts[room.full_id if wish.scope.room else room.floor] += _count(wish, room)
    having = [room for room in rooms if _count(wish, room)]
    found = [name for room in having for kind, names in room.object_ids.items() if _is(kind, wish) for name in names]
    wanted = _wanted(wish)
    least = min(counts.values()) if wish.scope.each else counts.total()
    status: WishStatus = "met" if least >= wanted else "partly" if having else "not_met"
    where = f" in a {'room' if wish.scope.room else 'storey'}" if wish.scope.each else ""
    reason = "" if status == "met" else f"{least} of {wanted} found a place{where}"
    bounded = wish.value.exact and (wish.scope.room or wish.value.limit == "most")
    most = _of_that_noun(wish, having) if bounded else 0
    if status == "met" and most > wanted:
        status, reason = "partly", f"{most} instead of {wanted} are there{where}"
    lost = [word for word in wish.value.unheeded if not _all_are(wish, rooms, word, wanted, planned=state.planned)]
    if status == "met" and lost:
        status, reason = "partly", f"nothing was made of {comma_separated([repr(word) for word in lost])}"
    return Verdict(status, reason, [room.full_id for room in having], found)


def _wanted(wish: Wish) -> int:
    """Return how many pieces are wanted: several where no number is told, one of what is a set: "coat hooks"."""
    several = 1 if is_plural(wish.value.type.rpartition("_")[2]) else 2
    return several if wish.value.count is None else wish.value.count


def _in_some(wish: Wish, rooms: Sequence[JudgedRoom], *, planned: bool) -> Verdict:
    """Judge what a number of several rooms are to have, each as many; what stands in the others is of no account."""
    wanted = -(-_wanted(wish) // wish.scope.some)
    enough = [room for room in rooms if _count(wish, room) >= wanted]
    fitting = [room for room in enough if not (wish.value.exact and _of_that_noun(wish, [room]) > wanted)]
    words = wish.value.unheeded
    good = [room for room in fitting if all(_all_are(wish, [room], word, wanted, planned=planned) for word in words)]
    chosen = (good or fitting or enough or [room for room in rooms if _count(wish, room)])[: wish.scope.some]
    found = [name for room in chosen for kind, names in room.object_ids.items() if _is(kind, wish) for name in names]
    reason = ""
    if len(enough) < wish.scope.some:
        reason = f"{len(enough)} of {wish.scope.some} rooms have {wanted}"
    elif len(fitting) < wish.scope.some:
        reason = f"more than {wanted} are there in a room"
    elif len(good) < wish.scope.some:
        reason = f"nothing was made of {comma_separated([repr(word) for word in words])}"
    status: WishStatus = "met" if not reason else "partly" if chosen else "not_met"
    return Verdict(status, reason, [room.full_id for room in chosen], found)


def _all_are(wish: Wish, rooms: Sequence[JudgedRoom], word: str, wanted: int, *, planned: bool) -> bool:
    """Whether as many objects as are wanted are as a word says, in each place where the count is for each."""
    there: Counter[object] = Counter()
    fitting: Counter[object] = Counter()
    for room in rooms:
        place = (room.full_id if wish.scope.room else room.floor) if wish.scope.each else ""
        for category, looks in room.looks.items():
            if _is(category, wish):
                there[place] += len(looks)
                fitting[place] += sum(has_quality(category, size, material, word) for size, material in looks)
    if planned:
        return any(fitting.values())  # the catalogue has such things
    return all(fitting[place] >= min(wanted, count) for place, count in there.items() if count)


def _of_that_noun(wish: Wish, rooms: Sequence[JudgedRoom]) -> int:
    """Return how many objects are called by the wish's noun: in all rooms, or the most in one for a count of each."""
    noun = noun_of(wish.value.type)
    counts = [
        sum(n for c, n in room.objects.items() if answers(wish.value.type, c) and noun_of(c) == noun) for room in rooms
    ]
    return max(counts, default=0) if wish.scope.each else sum(counts)


def _no_object(wish: Wish, state: JudgedBuilding) -> Verdict:
    laid = "carpet" in wish.value.name.rstrip("s").split("_")  # which covers floors as well
    rooms = [
        room
        for room in _object_rooms(wish, state)
        if _count(wish, room) or (laid and "carpet" in _substances(room.surfaces["floor"]))
    ]
    return met_if(not rooms, f"{rooms[0].full_id if rooms else ''} has one", rooms=[room.full_id for room in rooms])


def _count(wish: Wish, room: JudgedRoom) -> int:
    return sum(count for category, count in room.objects.items() if _is(category, wish))


def _is(category: str, wish: Wish) -> bool:
    """Whether objects of a category are what a wish calls so: an office desk is a desk, a reading table a table.

    Where the wish's own kind is a special one, what has its noun is so too: a coffee table is a table, but a high chair
    for a child is none of the chairs.
    """
    kind, name = wish.value.type, wish.value.name
    if not kind:
        return False
    last = category.rpartition("_")[2]
    return answers(kind, category) or ("_" in kind and name in (last, f"{last}s", f"{last}es"))


def _object_rooms(wish: Wish, state: JudgedBuilding) -> list[JudgedRoom]:
    if wish.scope.room:
        rooms = state.called(wish.scope.room, wish.scope.room_type, wish.scope.floors)
        return [room for room in rooms if not state.has_own_name(room, wish.scope.room)] or rooms
    return [room for room in state.rooms if not wish.scope.floors or room.floor in wish.scope.floors]


def _height(wish: Wish, state: JudgedBuilding) -> Verdict:
    wanted = wish.value.height or 0.0
    heights = [room.height for room in _of_type(wish, state)]
    if not heights:
        return Verdict("not_met", f"there is no {in_words(wish.scope.room_type) or 'room'}")
    good = [height for height in heights if abs(height - wanted) <= _CEILING + 1e-6]
    low, high = f"{min(heights):.2f}", f"{max(heights):.2f}"
    have = low if low == high else f"{low} to {high}"
    return met_if(len(good) == len(heights), f"ceilings are {have} m high", partly=bool(good))


def _material(wish: Wish, state: JudgedBuilding) -> Verdict:
    surface = "wall" if wish.value.type == "wall" else "floor"
    like = [other for other in state.program.wishes if (other.kind, other.value.type) == ("material", wish.value.type)]
    own = {other.scope.room_type for other in like} - {"", wish.scope.room_type}
    rooms = [room for room in _of_type(wish, state) if room.type not in own]
    have = [room for room in rooms if _is_of(room.surfaces[surface], wish.value.name)]
    every = wish.scope.each or wish.scope.room_type
    other = next((room for room in rooms if room not in have), None)
    if other is None or (not every and 2 * len(have) > len(rooms)):
        return met_if(bool(have), "there is no such room")
    near = have or [room for room in rooms if _is_of(room.surfaces[surface], wish.value.name, coloured=False)]
    return met_if(False, f"{other.full_id} has {in_words(other.surfaces[surface])}", partly=bool(near))


def _clutter(wish: Wish, state: JudgedBuilding) -> Verdict:
    others = {other.scope.room_type for other in state.program.wishes if other.kind == "clutter"}
    others.discard(wish.scope.room_type)
    rooms = [room for room in _of_type(wish, state) if room.receptacles and room.type not in others]
    if not rooms:
        return Verdict("not_met", "there is nothing that things could lie on")
    density = sum(room.things for room in rooms) / sum(room.receptacles for room in rooms)
    many = wish.value.name == "dense"
    good = density >= _CLUTTERED if many else density <= _TIDY
    bound = f"at least {_CLUTTERED:g}" if many else f"at most {_TIDY:g}"
    amount = "" if math.isinf(density) else f": {density:.1f} per square metre of furniture, {bound} expected"
    return met_if(good, f"too {'few' if many else 'many'} things lie about{amount}", partly=True)


def _is_of(surface: str, wanted: str, *, coloured: bool = True) -> bool:
    """Whether a surface is of the substance and, if `coloured`, of one of the colours that are wanted."""
    substances, colours = _substances(wanted), _colours(wanted) if coloured else set()
    if not substances:
        return not _material_words(wanted).isdisjoint(_material_words(surface))
    woods = _material_words(wanted) & _WOODS if coloured else set()
    said = _material_words(surface)
    same = all(not named or not named.isdisjoint(said) for named in (colours, woods))
    return same and not substances.isdisjoint(_substances(surface))


_COLOURS = frozenset(
    "white black grey beige blue green red yellow cream brown pink orange navy turquoise purple ivory charcoal".split()
)
_WOODS = frozenset("oak walnut pine maple birch bamboo cherry ash beech mahogany".split())
_SHADES = frozenset({"dark", "light", "pale"})


def _colours(text: str) -> set[str]:
    """Return the colours that a text names; its shades where it names none: "dark oak" is no oak of another kind."""
    words = _material_words(text)
    return words & _COLOURS or words & _SHADES


def _substances(text: str) -> set[str]:
    words = _material_words(text)
    return {name for name, known in _SUBSTANCES.items() if not words.isdisjoint(known.split())}


def _material_words(text: str) -> set[str]:
    return set(re.findall("[a-z]+", in_words(text.lower()).replace("gray", "grey")))


def _of_type(wish: Wish, state: JudgedBuilding) -> list[JudgedRoom]:
    """Return the rooms of the wish's storeys that have its room type; all where it names none."""
    kind, floors = wish.scope.room_type, wish.scope.floors
    return [room for room in state.rooms if kind in ("", room.type) and (not floors or room.floor in floors)]


INTERIOR_JUDGES: Final[Mapping[str, Judge]] = {
    "object": _object,
    "no_object": _no_object,
    "height": _height,
    "material": _material,
    "clutter": _clutter,
}
"""For each kind of wish for what rooms hold and are like, what judges it."""
