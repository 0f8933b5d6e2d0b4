"""What the words of an instruction mean in a scene: rooms, things and places; all functions are pure."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final, TypeAlias

import msgspec

from mansion_assets.catalogue.vocabulary import stems
from mansion_editing.instructions.nouns import called, has_colour, has_material, id_order
from mansion_editing.instructions.room_words import adjoining, best_named, room_order, room_title
from mansion_editing.instructions.statements import Place, Rooms, Things
from mansion_editing.state import SceneState
from mansion_editing.tools.perception import contents, on_top
from mansion_editing.tools.relations import relation_holds
from mansion_msgs_py.editing import Side
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject, SceneRoom

__all__ = [
    "Ambiguous",
    "Context",
    "Target",
    "all_at",
    "anchors_of",
    "carried_by",
    "concerned",
    "is_at",
    "means_one",
    "means_several",
    "new_number",
    "one_room_each",
    "place_words",
    "places_of",
    "rooms_of",
    "thing_words",
    "things_meant",
    "things_of",
]


LEAST_PLURAL: Final = 2
"""How many things a plural without a number means at least."""


class Ambiguous(MansionError):
    """Words that mean one thing fit several; `details` has the candidates."""


@dataclass(frozen=True)
class Context:
    """What was mentioned last.

    Attributes
    ----------
    things : tuple of str
        Ids of the objects.
    rooms : tuple of str
        Ids of the rooms.
    noun : str
        What the objects were called.
    kept : frozenset of str
        Ids of what the instruction says to leave as it is; not meant where words mean several things.
    """

    things: tuple[str, ...] = ()
    rooms: tuple[str, ...] = ()
    noun: str = ""
    kept: frozenset[str] = frozenset()

    def followed(self, things: Sequence[str], rooms: Sequence[str], noun: str) -> "Context":
        """Return the context after something else was mentioned; what was not stays."""
        return Context(tuple(things) or self.things, tuple(rooms) or self.rooms, noun or self.noun, self.kept)


_THERE: Final = frozenset({"", "it", "this", "that", "there", "here", "this room", "that room", "the room", "them"})


def rooms_of(state: SceneState, rooms: Rooms, context: Context) -> list[str]:
    """Return the ids of the rooms that words mean, the best fits only; empty where there is none.

    Several fits of words for one room are all returned: what else is said of the room may tell them apart.
    """
    found = _rooms_of(state, rooms, context)
    return [room.id for room in found]


def _rooms_of(state: SceneState, rooms: Rooms, context: Context) -> list[SceneRoom]:
    pool = sorted((room for floor, room in state.rooms() if not rooms.floors or floor in rooms.floors), key=room_order)
    if rooms.same and rooms.words:
        storeys = {name.split("/", 1)[0] for name in context.rooms}
        pool = [room for room in pool if not storeys or room.id.split("/", 1)[0] in storeys]
    elif rooms.same:
        last = context.rooms or tuple(dict.fromkeys(item.room for item in _existing(state, context.things)))
        if not last and rooms.floors:
            last = tuple(room.id for room in pool)
        pool = [room for room in pool if room.id in last]
    if rooms.next_to:
        beside = _next_rooms(state, rooms, context)
        pool = [room for room in pool if room.id in beside]
    if rooms.holding is not None:
        within = {item.room for item in things_of(state, rooms.holding, context)}
        pool = [room for room in pool if room.id in within]
    several = rooms.every or rooms.number > 1
    if rooms.words:
        close = best_named(pool, rooms.words, every=rooms.every)
        if several and rooms.number not in (0, len(close)):
            wide = best_named(pool, rooms.words, every=True)
            close = wide if len(wide) == rooms.number else close
        pool = close
    if rooms.size:
        pool = sorted(pool, key=lambda room: room.area, reverse=rooms.size == "largest")[:1]
    if rooms.ordinal:
        pool = _nth(pool, rooms.ordinal)
    return pool


def _next_rooms(state: SceneState, rooms: Rooms, context: Context) -> set[str]:
    words = rooms.next_to.lower().removeprefix("the ").strip()
    start = context.rooms if words in _THERE else rooms_of(state, Rooms(words=words), context)
    return {other for room in start for other in adjoining(state, room)} - set(start)


def _nth(found: list[SceneRoom], ordinal: int) -> list[SceneRoom]:
    at = ordinal if ordinal < 0 else ordinal - 1
    return [found[at]] if -len(found) <= at < len(found) else []


def _existing(state: SceneState, ids: Sequence[str]) -> list[SceneObject]:
    found = [state.find(name) for name in ids]
    return [pair[1] for pair in found if pair is not None]


Fit: TypeAlias = Callable[[str], bool]
"""Whether a room, by its id, fits the rest of a statement."""


def one_room_each(state: SceneState, rooms: Rooms, context: Context, fits: Fit | None = None) -> list[str]:
    """Return the rooms that words mean: exactly one where they mean one.

    Parameters
    ----------
    fits : callable, optional
        Tells rooms apart that the words fit equally well.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` where there is none, or not the number that the words have.
    Ambiguous
        Where words for one room fit several.
    """
    found = rooms_of(state, rooms, context)
    if not found:
        known = ", ".join(dict.fromkeys(room.name or room.room_type.replace("_", " ") for _, room in state.rooms()))
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no {_room_words(rooms)}; the rooms are {known[:600]}")
    if rooms.number > 1 and len(found) != rooms.number:
        if len(found) > rooms.number:
            raise _ambiguous(_room_words(rooms), [room_title(state, room) for room in found], found)
        message = f"there are {len(found)} rooms called {rooms.words}, not {rooms.number}: {', '.join(found)}"
        raise MansionError(ErrorCode.NOT_FOUND, message)
    if len(found) > 1 and _is_one(rooms):
        fitting = [room for room in found if fits is not None and fits(room)]
        if len(fitting) != 1:
            candidates = fitting or found
            raise _ambiguous(f"the {_room_words(rooms)}", [room_title(state, r) for r in candidates], candidates)
        return fitting
    return found


def _is_one(rooms: Rooms) -> bool:
    return not rooms.every and rooms.number < 2 and bool(rooms.words or rooms.next_to or rooms.holding or rooms.same)


def _ambiguous(words: str, candidates: Sequence[str], ids: Sequence[str]) -> Ambiguous:
    shown = " or ".join(candidates[:6]) + (f" or one of {len(candidates) - 6} more" if len(candidates) > 6 else "")
    return Ambiguous(
        ErrorCode.CONFLICT,
        f"{words!r} may be {shown}; say which",
        path="$.instruction",
        details={"words": words, "candidates": list(ids)},
    )


def things_of(state: SceneState, things: Things, context: Context) -> list[SceneObject]:
    """Return all objects that words fit, in the order of their ids; how many of them are meant is not looked at."""
    pool = [item for _, item in state.objects()]
    if things.refers and not context.things and not context.rooms:
        raise MansionError(ErrorCode.NOT_FOUND, "nothing was mentioned before that the words could refer to")
    if things.refers == "last":
        pool = _existing(state, context.things)
    elif things.refers == "others":
        rooms = {item.room for item in _existing(state, context.things)} or set(context.rooms)
        pool = [item for item in pool if item.id not in context.things and item.room in rooms]
    noun = things.noun or (context.noun if things.refers == "others" else "")
    if noun and not things.owned:
        things, noun = _with_owner(state, pool, things, noun, context)
    many = means_several(things)
    pool = [item for item in pool if _has_traits(item, things)]
    if noun or not things.refers:
        pool = called(state, pool, noun, many=True)
    if things.place is not None:
        at = _Placed(state, things.place, context)
        pool = [item for item in pool if at.holds(item)]
    if things.owned:
        pool = _owned(state, pool, things.owned, context)
    if noun and not many:
        pool = called(state, pool, noun)
    for spared in things.beside:
        out = {item.id for item in things_of(state, spared, context)}
        pool = [item for item in pool if item.id not in out]
    return _picked(sorted(pool, key=id_order), things)


def _with_owner(
    state: SceneState, pool: list[SceneObject], things: Things, noun: str, context: Context
) -> tuple[Things, str]:
    """Return the words with a room's name in front of the noun as its owner: the kitchen counter, the lobby chairs.

    Another word for a kind ("kitchen table") keeps its noun; one in the room of that name comes first.
    """
    words = noun.split()
    known = called(state, pool, noun, many=True) if len(words) > 1 else []
    if any(stems(noun) in (stems(item.category.replace("_", " ")), stems(item.name)) for item in known):
        return things, noun
    for at in range(len(words) - 1, 0, -1):
        owner, rest = " ".join(words[:at]), " ".join(words[at:])
        rooms = set(rooms_of(state, Rooms(words=owner), context))
        if known and any(item.room in rooms for item in known) and owner.lower() in _plain_names(state, rooms):
            return msgspec.structs.replace(things, owned=owner), noun
        if not known and called(state, [item for item in pool if item.room in rooms], rest, many=True):
            return msgspec.structs.replace(things, owned=owner, noun=rest), rest
    return things, noun


def _plain_names(state: SceneState, rooms: set[str]) -> set[str]:
    """Return the words by which rooms are called: their kinds and names, in small letters."""
    found = [room for _, room in state.rooms() if room.id in rooms]
    return {text.lower().replace("_", " ") for room in found for text in (room.room_type, room.name, *room.aliases)}


def _picked(pool: list[SceneObject], things: Things) -> list[SceneObject]:
    if things.size and pool:
        largest = things.size == "largest"
        pool = sorted(pool, key=lambda item: math.prod(item.size), reverse=largest)
        pool = [item for item in pool if math.isclose(math.prod(item.size), math.prod(pool[0].size), rel_tol=1e-3)]
    if things.ordinal:
        at = things.ordinal if things.ordinal < 0 else things.ordinal - 1
        pool = [pool[at]] if -len(pool) <= at < len(pool) else []
    return pool


def means_several(things: Things) -> bool:
    """Whether words mean more than one thing: the plural, a number above one, all."""
    amount = things.amount
    whole = amount.kind in ("all", "all_but", "none")
    return things.plural or whole or amount.number > 1


def new_number(things: Things) -> int:
    """Return how many things words want to be there, or want more of; a plural without a number wants two.

    Examples
    --------
    >>> new_number(Things(noun="chair", plural=True, amount=Amount(number=0))), new_number(Things(noun="chair"))
    (2, 1)
    """
    kind, number = things.amount.kind, things.amount.number
    if kind in ("exactly", "at_most", "none") or number > 1:
        return 0 if kind == "none" else number
    return LEAST_PLURAL if things.plural else 1


def means_one(things: Things) -> bool:
    """Whether words mean one certain thing ("the mug")."""
    return things.definite and not means_several(things)


def _has_traits(item: SceneObject, things: Things) -> bool:
    if things.colour and not has_colour(item, things.colour):
        return False
    if things.material and not has_material(item, things.material):
        return False
    return all(name in item.states and bool(item.states[name]) == value for name, value in things.states.items())


def _owned(state: SceneState, pool: list[SceneObject], owner: str, context: Context) -> list[SceneObject]:
    """Return those in the room that the owner's words name, else those on, in or beside a thing of that name."""
    words = owner.removesuffix("'s").removesuffix("’s")
    rooms = set(rooms_of(state, Rooms(words=words, every=True), context))
    inside = [item for item in pool if item.room in rooms]
    if inside:
        return inside
    holders = {item.id for item in called(state, (item for _, item in state.objects()), words)}
    if not rooms and not holders:
        return pool  # the baby's high chair: an owner who is no part of the building
    return [item for item in pool if item.parent in holders]


class _Placed:
    """Whether objects are at a place; its words are looked up once."""

    def __init__(self, state: SceneState, place: Place, context: Context) -> None:
        self.state, self.place = state, place
        self.rooms = None if place.rooms is None else set(rooms_of(state, place.rooms, context))
        self.anchors = [] if place.anchor is None else anchors_of(state, place, context)
        self.others = [] if place.other is None else things_of(state, place.other, context)
        self.facing = None if place.facing is None else things_of(state, place.facing, context)
        self.carried = (
            {item.id for anchor in self.anchors for item in carried_by(state, anchor, place.relation)}
            if place.relation in ("on", "in")
            else set()
        )

    def holds(self, item: SceneObject) -> bool:
        return self._is_there(item) != self.place.outside

    def _is_there(self, item: SceneObject) -> bool:
        if self.rooms is not None and item.room not in self.rooms:
            return False
        if self.place.anchor is not None and not self._is_related(item):
            return False
        if self.place.spot and not relation_holds(self.state, item, spot=self.place.spot):
            return False
        facing = self.facing
        return facing is None or any(
            item.id != one.id and relation_holds(self.state, item, facing=one.id) for one in facing
        )

    def _is_related(self, item: SceneObject) -> bool:
        relation, within = self.place.relation, self.place.within or None
        if relation in ("on", "in"):
            return item.id in self.carried
        near = [anchor for anchor in self.anchors if anchor.id != item.id and anchor.room == item.room]
        if relation == "between":
            ends = [one for one in (self.others or near) if one.id != item.id and one.room == item.room]
            return any(
                relation_holds(self.state, item, "between", one.id, other.id, within)
                for one in near
                for other in ends
                if one.id != other.id
            )
        side: Side = "" if relation in ("", "near") else relation  # type: ignore[assignment]
        return any(relation_holds(self.state, item, side, anchor.id, within=within) for anchor in near)


def is_at(state: SceneState, item: SceneObject, place: Place, context: Context) -> bool:
    """Whether an object is at a place in words, measured on the geometry of the scene."""
    return _Placed(state, place, context).holds(item)


def all_at(state: SceneState, items: Sequence[SceneObject], place: Place, context: Context) -> list[SceneObject]:
    """Return the objects that are at a place in words."""
    at = _Placed(state, place, context)
    return [item for item in items if at.holds(item)]


def carried_by(state: SceneState, holder: SceneObject, relation: str) -> list[SceneObject]:
    """Return what is on or in an object; either where its kind cannot tell them apart (a bookshelf)."""
    found = state.find(holder.id)
    if found is None:
        return []
    floor, index, asset = found[0], state.index(found[0]), state.asset(holder)
    surfaces, volumes = (bool(asset.surfaces), bool(asset.volumes)) if asset is not None else (True, True)
    out: list[SceneObject] = []
    if relation == "on" or not volumes:
        out += on_top(index, holder, asset)
    if relation == "in" or not surfaces:
        out += contents(index, holder, asset)
    mounts = {"on": ("surface",), "in": ("inside",)}.get(relation, ())
    children = state.index(floor).children.get(holder.id, [])
    out += [item for item in children if item.mount in mounts or not (surfaces and volumes)]
    return list({item.id: item for item in out if item.mount not in ("ceiling", "wall")}.values())


def anchors_of(state: SceneState, place: Place, context: Context) -> list[SceneObject]:
    """Return the objects that a place is on, in, beside, ...; only those in its rooms where it names rooms."""
    if place.anchor is None:
        return []
    anchor = place.anchor
    if place.rooms is not None and anchor.place is None:
        return things_of(state, msgspec.structs.replace(anchor, place=Place(rooms=place.rooms)), context)
    found = things_of(state, anchor, context)
    rooms = None if place.rooms is None else set(rooms_of(state, place.rooms, context))
    return [item for item in found if rooms is None or item.room in rooms]


def concerned(state: SceneState, things: Things, context: Context) -> list[SceneObject]:
    """Return the things that words fit and that a statement may change: of several, not what shall be left.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an exception that is not there.
    """
    found = things_of(state, things, context)
    loosely = things.definite and things.plural and things.amount.kind in ("some", "all") and things.place is None
    if loosely and not things.refers and not things.owned and context.rooms:
        found = [item for item in found if item.room in context.rooms] or found
    for spared in things.beside:
        if not things_of(state, spared, context):
            raise MansionError(ErrorCode.NOT_FOUND, f"there is no {_bare(spared)}{_at(spared.place)} to leave out")
    return found if means_one(things) else [item for item in found if item.id not in context.kept]


def things_meant(
    state: SceneState,
    things: Things,
    context: Context,
    prefer: Callable[[SceneObject], bool] | None = None,
    *,
    surplus: bool = False,
) -> list[SceneObject]:
    """Return the objects that words mean, their number looked at.

    Of several that may be chosen freely ("two chairs") those that carry nothing come first, then the last.

    Parameters
    ----------
    prefer : callable, optional
        Tells which is meant where words for one thing fit several.
    surplus : bool
        ``exactly`` and ``at_most`` mean those beyond the number, not the number.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` where there is none, ``INFEASIBLE`` where there are fewer than the words have.
    Ambiguous
        Where words for one thing, or for a certain number, fit more.
    """
    found = concerned(state, things, context)
    if not found:
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no {_bare(things)}{_at(things.place)}")
    if things.place is not None:
        found = _at_one_place(state, things.place, found, context)
    amount, count = things.amount, len(found)
    if amount.of and amount.of != count:
        message = f"there are {count} {_bare(things)}{_at(things.place)}, not {amount.of}: {_ids(found)}"
        raise MansionError(ErrorCode.INFEASIBLE, message)
    if amount.kind == "all":
        if amount.number > 1 and amount.number != count:
            raise _too_few(things, found)
        return found
    if amount.kind == "all_but" or (surplus and amount.kind in ("exactly", "at_most")):
        if amount.kind == "all_but" and count < amount.number:
            raise _too_few(things, found)
        return _any_of(state, found, max(0, count - amount.number))
    if amount.kind == "none":
        return []
    if things.plural and amount.number <= 1:
        return found
    if means_one(things) or (things.refers == "last" and not things.plural and things.noun):
        return _the_one(things, found, context, prefer)
    if things.refers == "last":
        return found
    number = max(1, amount.number)
    if number > count:
        raise _too_few(things, found)
    if things.definite and number < count and not amount.of:
        raise _ambiguous(thing_words(things), [_title(state, item) for item in found], [i.id for i in found])
    return _any_of(state, found, number)


def _the_one(
    things: Things, found: list[SceneObject], context: Context, prefer: Callable[[SceneObject], bool] | None
) -> list[SceneObject]:
    last = [item for item in found if item.id in context.things]
    found = last if len(last) == 1 else found
    preferred = [item for item in found if prefer is not None and prefer(item)]
    if len(found) > 1 and len({item.room for item in found}) == 1 and _names_lights(things):
        return [item for item in found if item.mount == "ceiling"] or found
    here = [item for item in found if item.room in context.rooms]
    found = preferred if len(preferred) == 1 else here if len(here) == 1 else found
    if len(found) > 1:
        raise _ambiguous(thing_words(things), [_title(None, item) for item in found], [item.id for item in found])
    return found


def _names_lights(things: Things) -> bool:
    return stems(things.noun)[-1:] == ("light",) or stems(things.noun) in (("ceiling", "lamp"), ("lighting",))


def _too_few(things: Things, found: list[SceneObject]) -> MansionError:
    only = "only " if things.amount.number >= len(found) else ""
    verb = "is" if len(found) == 1 else "are"
    message = f"there {verb} {only}{len(found)} {_bare(things)}{_at(things.place)}, not {things.amount.number}: "
    return MansionError(ErrorCode.INFEASIBLE, message + _ids(found))


def _ids(found: Sequence[SceneObject]) -> str:
    return ", ".join(item.id for item in found[:8]) + (", ..." if len(found) > 8 else "")


def _any_of(state: SceneState, found: list[SceneObject], number: int) -> list[SceneObject]:
    """Return so many of the objects: those that carry nothing first, then the last in the order of ids."""
    bearing = {item.parent for _, item in state.objects() if item.parent is not None}
    order = sorted(enumerate(found), key=lambda pair: (pair[1].id in bearing, -pair[0]))
    kept = {item.id for _, item in order[:number]}
    return [item for item in found if item.id in kept]


def _at_one_place(state: SceneState, place: Place, found: list[SceneObject], context: Context) -> list[SceneObject]:
    """Refuse things that lie at several places where the words mean one.

    Raises
    ------
    Ambiguous
    """
    if place.outside:
        return found
    rooms = sorted({item.room for item in found})
    if place.rooms is not None and _is_one(place.rooms) and len(rooms) > 1:
        raise _ambiguous(f"the {_room_words(place.rooms)}", [room_title(state, room) for room in rooms], rooms)
    if place.anchor is None or not means_one(place.anchor):
        return found
    anchors = anchors_of(state, place, context)
    if len(anchors) < 2 or any(anchor.id in context.things for anchor in anchors):
        return found
    near = {
        anchor.id: all_at(state, found, msgspec.structs.replace(place, anchor=Things(noun=anchor.id)), context)
        for anchor in anchors
    }
    having = [anchor for anchor in anchors if near[anchor.id]]
    if len(having) > 1:
        words = thing_words(place.anchor)
        raise _ambiguous(words, [_title(state, item) for item in having], [item.id for item in having])
    return found


@dataclass(frozen=True)
class Target:
    """Where something may go.

    Attributes
    ----------
    room : str
        Id of the room.
    anchor, other : SceneObject, optional
        What it goes on, in, beside, ...; `other` is the second one of ``between``.
    facing : SceneObject, optional
        What it shall face.
    """

    room: str
    anchor: SceneObject | None = None
    other: SceneObject | None = None
    facing: SceneObject | None = None


def places_of(
    state: SceneState, place: Place, context: Context, *, each: bool = False, fits: Fit | None = None
) -> list[Target]:
    """Return the places that words mean, each of which serves where the words mean one; empty where there is none.

    Parameters
    ----------
    each : bool
        The words mean all of them ("on every desk").
    fits : callable, optional
        Tells rooms apart that the words fit equally well.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for rooms that are not there.
    Ambiguous
        Where words for one place fit several, and which of them is taken matters.
    """
    if place.anchor is None:
        rooms = [] if place.rooms is None else one_room_each(state, place.rooms, context, fits)
        return [_facing(state, place, Target(room), context) for room in rooms]
    anchor, found = place.anchor, anchors_of(state, place, context)
    if not found:
        if place.rooms is not None:
            one_room_each(state, place.rooms, context, fits)
        return []
    found = _at_one_room(state, place, found)
    if means_one(anchor) and not each and len(found) > 1:
        found = _alike(state, place, anchor, found, context)
    elif anchor.definite and anchor.amount.kind == "some" and 1 < anchor.amount.number != len(found):
        if anchor.amount.number > len(found):
            raise _too_few(anchor, found)
        raise _ambiguous(thing_words(anchor), [_title(state, item) for item in found], [i.id for i in found])
    if place.relation == "between":
        return _between(state, place, found, context)
    return [_facing(state, place, Target(item.room, item), context) for item in found]


def _at_one_room(state: SceneState, place: Place, found: list[SceneObject]) -> list[SceneObject]:
    rooms = sorted({item.room for item in found})
    if place.rooms is not None and _is_one(place.rooms) and len(rooms) > 1:
        raise _ambiguous(f"the {_room_words(place.rooms)}", [room_title(state, room) for room in rooms], rooms)
    return found


def _alike(
    state: SceneState, place: Place, anchor: Things, found: list[SceneObject], context: Context
) -> list[SceneObject]:
    """Return what "the table" may be: any table of one kind in one room, where something shall lie on it."""
    last = [item for item in found if item.id in context.things]
    if last:
        return last if place.relation in ("on", "in") else last[:1]
    found = [item for item in found if item.room in context.rooms] or found
    own = {item.id for item in found if _is_of_its_room(state, item, anchor.noun)}
    found = [item for item in found if item.id in own] or found
    kinds = {(item.room, item.category) for item in found}
    if len(found) == 1:
        return found
    if place.relation in ("on", "in") and len(kinds) == 1:
        return found
    raise _ambiguous(thing_words(anchor), [_title(state, item) for item in found], [item.id for item in found])


def _is_of_its_room(state: SceneState, item: SceneObject, noun: str) -> bool:
    """Whether a room is named as the thing in it is: the dining table of the dining room."""
    room = state.room(item.room)
    first = stems(noun)[:1]
    return room is not None and len(stems(noun)) > 1 and first == stems(room[1].name or room[1].room_type)[:1]


def _between(state: SceneState, place: Place, found: list[SceneObject], context: Context) -> list[Target]:
    ends = found if place.other is None else things_of(state, place.other, context)
    pairs = [
        (math.dist(one.position[:2], other.position[:2]), one, other)
        for one in found
        for other in ends
        if one.room == other.room and one.id != other.id and (place.other is not None or one.id < other.id)
    ]
    pairs.sort(key=lambda pair: (round(pair[0], 4), pair[1].id, pair[2].id))
    return [_facing(state, place, Target(one.room, one, other), context) for _, one, other in pairs]


def _facing(state: SceneState, place: Place, target: Target, context: Context) -> Target:
    if place.facing is None:
        return target
    found = [item for item in things_of(state, place.facing, context) if item.room == target.room]
    if not found:
        message = f"there is no {_bare(place.facing)} in {target.room} to face"
        raise MansionError(ErrorCode.NOT_FOUND, message)
    if len(found) > 1 and means_one(place.facing):
        raise _ambiguous(thing_words(place.facing), [_title(state, item) for item in found], [i.id for i in found])
    return Target(target.room, target.anchor, target.other, found[0])


def _title(state: SceneState | None, item: SceneObject) -> str:
    room = None if state is None else state.room(item.room)
    name = item.room.split("/", 1)[-1].replace("_", " ") if room is None else room[1].name
    return f"{item.id} in {name or item.room.split('/', 1)[-1].replace('_', ' ')}"


def thing_words(things: Things) -> str:
    """Return words for things as a reply has them ("the two red mugs on the desk")."""
    if things.refers == "last" and not things.noun:
        return "them" if means_several(things) else "it"
    article = "the " if things.definite else ""
    number = f"{things.amount.number} " if things.amount.number > 1 else ""
    return f"{article}{number}{_bare(things)}{_at(things.place)}"


def _bare(things: Things) -> str:
    states = [f"{'' if value else 'not '}{name}" for name, value in things.states.items()]
    words = [things.size, *states, things.colour, things.material, things.owned, things.noun or "thing"]
    return " ".join(word for word in words if word)


_RELATIONS: Final = {
    "beside": "beside", "left": "to the left of", "right": "to the right of", "front": "in front of",
    "around": "around", "near": "near", "behind": "behind", "between": "between", "on": "on", "in": "in",
    "under": "under", "above": "above", "": "at",
}  # fmt: skip


def place_words(place: Place) -> str:
    """Return words for a place ("on the desk in the office on floor 2")."""
    parts = ["not"] if place.outside else []
    if place.anchor is not None:
        parts.append(f"{_RELATIONS[place.relation]} {thing_words(place.anchor)}")
    if place.other is not None:
        parts.append(f"and {thing_words(place.other)}")
    if place.spot:
        parts.append({"middle": "in the middle", "corner": "in a corner"}.get(place.spot, f"at the {place.spot}"))
    if place.rooms is not None:
        parts.append(f"in {'' if place.rooms.every else 'the '}{_room_words(place.rooms)}")
    if place.facing is not None:
        parts.append(f"facing {thing_words(place.facing)}")
    return " ".join(parts)


def _at(place: Place | None) -> str:
    return "" if place is None else f" {place_words(place)}"


def _room_words(rooms: Rooms) -> str:
    words = rooms.words or ("rooms" if rooms.every else "room")
    sized = f"{rooms.size} {words}" if rooms.size else words
    floors = f" on floor {' or '.join(map(str, rooms.floors))}" if rooms.floors else ""
    beside = f" next to {rooms.next_to}" if rooms.next_to else ""
    holding = f" with {thing_words(rooms.holding)}" if rooms.holding is not None else ""
    return f"{sized}{beside}{holding}{floors}"
