"""Rooms and things that fit a description."""

import math
from collections.abc import Callable, Sequence
from typing import Final

import msgspec
from shapely import Polygon

from mansion_assets.catalogue.vocabulary import stems
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.distances import by_distance
from mansion_editing.instructions.meaning.nouns import called, has_colour, has_material, id_order, looks_like
from mansion_editing.instructions.meaning.numbers import means_several, of_one_kind
from mansion_editing.instructions.meaning.room_words import adjoining, best_named, room_order
from mansion_editing.instructions.meaning.vacated import stands_where, vacated_by
from mansion_editing.instructions.phrases.lexicon import ANYTHING
from mansion_editing.instructions.phrases.places import SUPERLATIVES
from mansion_editing.instructions.statements import JOINED, Amount, Place, Rooms, Things
from mansion_editing.state import SceneState
from mansion_editing.tools.perception import contents, on_top
from mansion_editing.tools.relations import relation_holds
from mansion_editing.tools.tops import carries_on_top
from mansion_knowledge.object_kinds import substitutes
from mansion_msgs_py.editing.objects import Side
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.scene import SceneObject, SceneRoom

__all__ = ["all_at", "anchors_of", "carried_by", "is_at", "rooms_of", "things_of"]

_THERE: Final = frozenset({"", "it", "this", "that", "there", "here", "this room", "that room", "the room", "them"})


def rooms_of(state: SceneState, rooms: Rooms, context: Context) -> list[str]:
    """Return the ids of the rooms that words mean, the best fits only; empty where there is none.

    Several fits of words for one room are all returned: what else is said of the room may tell them apart.
    """
    found = _rooms_of(state, rooms, context)
    return [room.id for room in found]


def _rooms_of(state: SceneState, rooms: Rooms, context: Context) -> list[SceneRoom]:
    if rooms.but:
        spared = {room.id for one in rooms.but for room in _rooms_of(state, one, context)}
        return [
            room for room in _rooms_of(state, msgspec.structs.replace(rooms, but=()), context) if room.id not in spared
        ]
    if JOINED in rooms.words:
        names = rooms.words.split(JOINED)
        each = [msgspec.structs.replace(rooms, words=words, every=False, number=0) for words in names]
        return list({room.id: room for one in each for room in _rooms_of(state, one, context)}.values())
    pool = sorted((room for floor, room in state.rooms() if not rooms.floors or floor in rooms.floors), key=room_order)
    if rooms.same and rooms.words:
        storeys = {name.split("/", 1)[0] for name in context.rooms}
        pool = [room for room in pool if not storeys or room.id.split("/", 1)[0] in storeys]
    elif rooms.same:
        last = context.rooms or tuple(dict.fromkeys(item.room for item in _existing(state, context.things)))
        if not last and rooms.floors:
            last = tuple(room.id for room in pool)
        pool = [room for room in pool if room.id in last]
    if rooms.up:
        pool = _storeys_away(state, rooms, context, pool)
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
    if rooms.others:
        pool = _others(state, pool, rooms, context)
    if rooms.size:
        pool = sorted(pool, key=lambda room: room.area, reverse=rooms.size == "largest")[:1]
    if rooms.ordinal:
        pool = _nth(pool, rooms.ordinal)
    return pool


def _others(state: SceneState, pool: list[SceneRoom], rooms: Rooms, context: Context) -> list[SceneRoom]:
    """Return the rooms of a kind but the one that was mentioned; none where none of the kind was."""
    last = context.rooms or tuple(dict.fromkeys(item.room for item in _existing(state, context.things)))
    numbered = rooms.words.rpartition(" ")[2].isdecimal()
    mentioned = any(room.id in last for room in pool)
    return [room for room in pool if room.id not in last] if mentioned or numbered else []


def _storeys_away(state: SceneState, rooms: Rooms, context: Context, pool: list[SceneRoom]) -> list[SceneRoom]:
    """Return the rooms so many storeys above or below a room, the last one that was mentioned, or the entrance's."""
    bases = [found for name in _bases(state, rooms, context) if (found := state.room(name)) is not None]
    wanted = {floor + rooms.up for floor, _ in bases}
    there = [room for room in pool if (found := state.room(room.id)) is not None and found[0] in wanted]
    if not rooms.over:
        return there
    shapes = [Polygon(room.polygon) for _, room in bases]
    shared = {room.id: sum(Polygon(room.polygon).intersection(shape).area for shape in shapes) for room in there}
    return [room for room in there if shared[room.id] >= _SHARED * max(shared.values(), default=0.0) > 0.0]


_SHARED: Final = 0.5
"""Least share of the greatest overlap from which a room lies above another."""


def _bases(state: SceneState, rooms: Rooms, context: Context) -> Sequence[str]:
    if rooms.base:
        return rooms_of(state, Rooms(words=rooms.base), context)
    if context.rooms:
        return context.rooms[-1:]
    return [room.id for floor, room in state.rooms() if floor == 1][:1]


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


def things_of(state: SceneState, things: Things, context: Context) -> list[SceneObject]:
    """Return all objects that words fit, in the order of their ids; how many of them are meant is not looked at.

    Certain things that are there may be of about a colour ("the brown bench" of oak) where none is just of it, and on
    furniture where they are told to be in it.
    """
    found = _things_of(state, things, context, has_colour)
    if found or not (things.definite and things.noun):
        return found
    found = _things_of(state, things, context, looks_like) if things.colour else found
    place = things.place
    if found:
        return found
    if place is None or place.anchor is None or place.relation not in ("on", "in") or place.outside:
        return found
    either = msgspec.structs.replace(things, place=msgspec.structs.replace(place, relation=""))
    return [item for item in _things_of(state, either, context, has_colour) if item.parent is not None]


def _things_of(
    state: SceneState, things: Things, context: Context, coloured: Callable[[SceneObject, str], bool]
) -> list[SceneObject]:
    pool = [item for _, item in state.objects()]
    if things.refers and not context.things and not context.rooms:
        raise MansionError(ErrorCode.NOT_FOUND, "nothing was mentioned before that the words could refer to")
    if things.refers == "last":
        pool = _existing(state, context.things)
    elif not things.refers:
        pool = _in_rooms(state, pool, things.place, context)
    else:
        rooms = {item.room for item in _existing(state, context.things)} or set(context.rooms)
        pool = [item for item in pool if item.id not in context.things and item.room in rooms]
    noun = things.noun or (context.noun if things.refers == "others" else "")
    if noun and not things.owned:
        things, noun = _with_owner(state, pool, things, noun, context)
    many = means_several(things)
    if things.colour or things.material or things.states:
        pool = [item for item in pool if _has_traits(item, things, coloured)]
    apart = not many and things.place is not None and _are_several(things.place.rooms)
    if noun or not things.refers:
        pool = _called(state, pool, noun, apart=apart, many=True, every=things.amount.kind == "all")
    superlative = things.place is not None and things.place.relation in SUPERLATIVES
    if things.place is not None and not superlative:
        at = _Placed(state, things.place, context)
        pool = [item for item in pool if at.holds(item)]
        if not noun or noun in ANYTHING:
            pool = _lying_there(pool, things.place)
    if things.owned:
        pool = _owned(state, pool, things.owned, context)
    if noun and not many:
        named = _called(state, pool, noun, apart=apart)
        pool = pool if things.size and len(named) == 1 else named
    if things.bearing is not None:
        pool = _bearing(state, pool, things.bearing, context)
    for spared in things.beside:
        out = {item.id for item in things_of(state, spared, context)}
        pool = [item for item in pool if item.id not in out]
    if things.place is not None and superlative:
        pool = by_distance(state, pool, things, anchors_of(state, things.place, context))
    return _picked(sorted(pool, key=id_order), things)


def _lying_there(pool: list[SceneObject], place: Place) -> list[SceneObject]:
    """Return what lies on the floor or on furniture, not what stands there: ``everything from the coffee table``."""
    if place.on_floor:
        return [item for item in pool if item.pickupable]
    carried = place.anchor is not None and place.relation == ""
    return [item for item in pool if item.parent is not None] if carried else pool


def _bearing(state: SceneState, pool: list[SceneObject], borne: Things, context: Context) -> list[SceneObject]:
    """Return the furniture that has certain things on or in it."""
    kind = msgspec.structs.replace(borne, amount=Amount(kind="all", number=0), plural=True)
    ids = {item.id for item in things_of(state, kind, context)}
    return [item for item in pool if ids.intersection(one.id for one in carried_by(state, item, ""))]


def _in_rooms(state: SceneState, pool: list[SceneObject], place: Place | None, context: Context) -> list[SceneObject]:
    """Return those in the rooms that a place names; all where it names none."""
    if place is None or place.rooms is None or place.outside:
        return pool
    rooms = set(rooms_of(state, place.rooms, context))
    return [item for item in pool if item.room in rooms]


def _are_several(rooms: Rooms | None) -> bool:
    return rooms is not None and (rooms.every or rooms.number > 1)


def _called(
    state: SceneState, pool: list[SceneObject], noun: str, *, apart: bool, many: bool = False, every: bool = False
) -> list[SceneObject]:
    """Return what a noun names; `apart`, in each room for itself: "the toilet" of every bathroom."""
    if not apart:
        return called(state, pool, noun, many=many, every=every)
    groups: dict[str, list[SceneObject]] = {}
    for item in pool:
        groups.setdefault(item.room, []).append(item)
    return [item for group in groups.values() for item in called(state, group, noun, many=many)]


def _with_owner(
    state: SceneState, pool: list[SceneObject], things: Things, noun: str, context: Context
) -> tuple[Things, str]:
    """Return the words with a room's name in front of the noun as its owner: the kitchen counter, the lobby chairs.

    Another word for a kind ("kitchen table") keeps its noun; one in the room of that name comes first.
    """
    words = noun.split()
    known = called(state, pool, noun, many=True) if len(words) > 1 else []
    named = [item for item in known if stems(noun) in (stems(item.category.replace("_", " ")), stems(item.name))]
    if named:
        return _of_room_named_so(state, named, things, noun, context), noun
    for at in range(len(words) - 1, 0, -1):
        owner, rest = " ".join(words[:at]), " ".join(words[at:])
        rooms = set(rooms_of(state, Rooms(words=owner), context))
        if known and any(item.room in rooms for item in known) and owner.lower() in _plain_names(state, rooms):
            return msgspec.structs.replace(things, owned=owner), noun
        if not known and called(state, [item for item in pool if item.room in rooms], rest, many=True):
            return msgspec.structs.replace(things, owned=owner, noun=rest), rest
        if not known and not rooms and _around(state, called(state, pool, rest, many=True), called(state, pool, owner)):
            return msgspec.structs.replace(things, owned=owner, noun=rest), rest
    return things, noun


def _of_room_named_so(
    state: SceneState, named: list[SceneObject], things: Things, noun: str, context: Context
) -> Things:
    """Return ``the cafe tables`` as those of the cafe, where there are such tables and others elsewhere too."""
    owner = noun.rpartition(" ")[0]
    if not (things.definite and means_several(things)) or things.place is not None or owner in _OF_KINDS:
        return things
    rooms = set(rooms_of(state, Rooms(words=owner), context))
    inside = [item for item in named if item.room in rooms]
    told = bool(inside) and len(inside) < len(named) and owner.lower() in _plain_names(state, rooms)
    return msgspec.structs.replace(things, owned=owner) if told else things


_OF_KINDS: Final = frozenset(["office", "kitchen", "garden"])
"""Rooms whose name begins names of furniture that stands in many others: office chairs, office desks."""


def _plain_names(state: SceneState, rooms: set[str]) -> set[str]:
    """Return the words by which rooms are called: their kinds and names, in small letters."""
    found = [room for _, room in state.rooms() if room.id in rooms]
    return {text.lower().replace("_", " ") for room in found for text in (room.room_type, room.name, *room.aliases)}


def _picked(pool: list[SceneObject], things: Things) -> list[SceneObject]:
    if things.size and pool:
        high = things.size in ("tallest", "shortest")
        sizes = {item.id: item.size[2] if high else math.prod(item.size) for item in pool}
        extreme = max(sizes.values()) if things.size in ("largest", "tallest") else min(sizes.values())
        pool = [item for item in pool if math.isclose(sizes[item.id], extreme, rel_tol=1e-3)]
    if things.ordinal:
        at = things.ordinal if things.ordinal < 0 else things.ordinal - 1
        pool = [pool[at]] if -len(pool) <= at < len(pool) else []
    return pool


def _has_traits(item: SceneObject, things: Things, coloured: Callable[[SceneObject, str], bool]) -> bool:
    if things.colour and not coloured(item, things.colour):
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
    holders = called(state, (item for _, item in state.objects()), words)
    if not rooms and not holders:
        return pool  # the baby's high chair: an owner who is no part of the building
    return [item for item in pool if item.parent in {one.id for one in holders}] or _around(state, pool, holders)


def _around(state: SceneState, pool: list[SceneObject], marks: Sequence[SceneObject]) -> list[SceneObject]:
    """Return what stands beside one of some things, or on what does; else the only one of the room that has them."""
    by_room: dict[str, list[SceneObject]] = {}
    for mark in marks:
        by_room.setdefault(mark.room, []).append(mark)
    here = [item for item in pool if item.room in by_room]
    near = [item for item in here if any(_is_beside(state, item, mark) for mark in by_room[item.room])]
    return near or ([] if len({item.room for item in here}) != len(here) else here)


def _is_beside(state: SceneState, item: SceneObject, mark: SceneObject) -> bool:
    """Whether a thing, or the furniture that carries it, stands beside another."""
    carrier = None if item.parent is None else state.find(item.parent)
    standing = item if carrier is None else carrier[1]
    return standing.id != mark.id and relation_holds(state, standing, "beside", mark.id)


class _Placed:
    """Whether objects are at a place; its words are looked up once."""

    def __init__(self, state: SceneState, place: Place, context: Context) -> None:
        self.state, self.place = state, place
        self.rooms = None if place.rooms is None else set(rooms_of(state, place.rooms, context))
        self.doors = _doors_at(state, place, context)
        self.anchors = [] if place.anchor is None or self.doors is not None else anchors_of(state, place, context)
        self.others = [] if place.other is None else things_of(state, place.other, context)
        self.facing = None if place.facing is None else things_of(state, place.facing, context)
        self.former = None if place.former is None else vacated_by(state, place.former, context)
        self.carried = (
            {item.id for anchor in self.anchors for item in carried_by(state, anchor, place.relation)}
            if place.relation in ("on", "in", "")
            else set()
        )

    def holds(self, item: SceneObject) -> bool:
        return self._is_there(item) != self.place.outside

    def _is_there(self, item: SceneObject) -> bool:
        if self.rooms is not None and item.room not in self.rooms:
            return False
        if self.former is not None and not stands_where(item, self.former):
            return False
        if self.place.on_floor and not (item.mount == "floor" and item.parent is None):
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
        if self.doors is not None:
            return any(relation_holds(self.state, item, spot="door", door=door) for door in self.doors)
        if relation == "" and item.mount == "floor" and item.parent is None:
            return any(_is_beside(self.state, item, anchor) for anchor in self.anchors)  # the chairs from the table
        if relation in ("on", "in", ""):
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
        side: Side = "" if relation == "near" else relation  # type: ignore[assignment]
        apart = self.place.apart or None
        return any(relation_holds(self.state, item, side, anchor.id, within=within, apart=apart) for anchor in near)


def _doors_at(state: SceneState, place: Place, context: Context) -> list[str] | None:
    """Return the ids of the doors that a place is at, None where it is at something else."""
    with importing:
        from mansion_editing.instructions.meaning.doors import doors_at, means_doors  # which asks for rooms here
    if place.anchor is None or not means_doors(place.anchor):
        return None
    return [door.id for door in doors_at(state, place, context)]


def is_at(state: SceneState, item: SceneObject, place: Place, context: Context) -> bool:
    """Whether an object is at a place in words, measured on the geometry of the scene."""
    return _Placed(state, place, context).holds(item)


def all_at(state: SceneState, items: Sequence[SceneObject], place: Place, context: Context) -> list[SceneObject]:
    """Return the objects that are at a place in words."""
    at = _Placed(state, place, context)
    return [item for item in items if at.holds(item)]


def carried_by(state: SceneState, holder: SceneObject, relation: str) -> list[SceneObject]:
    """Return what is on or in an object; either without a relation, or where its kind cannot tell them apart."""
    found = state.find(holder.id)
    if found is None:
        return []
    floor, index, asset = found[0], state.index(found[0]), state.asset(holder)
    surfaces, volumes = (carries_on_top(asset), bool(asset.volumes)) if asset is not None else (True, True)
    out: list[SceneObject] = []
    if relation != "in" or not volumes:
        out += on_top(index, holder, asset)
    if relation != "on" or not surfaces:
        out += contents(index, holder, asset)
    mounts = {"on": ("surface",), "in": ("inside",)}.get(relation, ("surface", "inside"))
    children = state.index(floor).children.get(holder.id, [])
    out += [item for item in children if item.mount in mounts or not (surfaces and volumes)]
    return list({item.id: item for item in out if item.mount not in ("ceiling", "wall")}.values())


def anchors_of(state: SceneState, place: Place, context: Context) -> list[SceneObject]:
    """Return the objects that a place is on, in, beside, ...; only those in its rooms where it names rooms."""
    if place.anchor is None:
        return []
    anchor = place.anchor
    if anchor.refers == "last" and not anchor.noun and place.relation in ("on", "in", "under", ""):
        return _receptacles_meant(state, anchor, context)
    if place.rooms is not None and anchor.place is None:
        within = Place(rooms=place.rooms)
        return _as_many(things_of(state, msgspec.structs.replace(anchor, place=within), context), anchor)
    if place.rooms is not None and anchor.place is not None and anchor.place.rooms is None:
        within = msgspec.structs.replace(anchor.place, rooms=place.rooms)
        anchor = msgspec.structs.replace(anchor, place=within)
    found = things_of(state, anchor, context)
    rooms = None if place.rooms is None else set(rooms_of(state, place.rooms, context))
    found = found if rooms is not None else _kind_in_same_room(state, anchor, found, context)
    if (
        rooms is None
        and anchor.definite
        and means_several(anchor)
        and not (anchor.refers or anchor.owned or anchor.place)
    ):
        found = [item for item in found if item.room in context.rooms] or found
    return _as_many([item for item in found if rooms is None or item.room in rooms], anchor)


def _kind_in_same_room(
    state: SceneState, anchor: Things, found: list[SceneObject], context: Context
) -> list[SceneObject]:
    """Return the display fridge of the room that was mentioned before as ``the fridge``, where it has no other."""
    named = bool(anchor.noun) and anchor.definite and not (anchor.plural or anchor.refers or anchor.owned)
    told = anchor.place is not None or anchor.colour or anchor.material or anchor.ordinal or anchor.size
    if not named or told or len(context.rooms) != 1 or any(item.room in context.rooms for item in found):
        return found
    kind = anchor.noun.replace(" ", "_")
    known = {category for category in substitutes(kind) if category.endswith(f"_{kind}")}  # a dog bed is no bed
    return [i for _, i in state.objects() if i.room in context.rooms and i.category in known] or found


def _as_many(found: list[SceneObject], anchor: Things) -> list[SceneObject]:
    """Return the kind of which there are as many as words say, where there are more of several kinds."""
    number = anchor.amount.of or anchor.amount.number
    told = anchor.definite or anchor.amount.of
    return (of_one_kind(found, number) if told and anchor.amount.kind in ("some", "all") else None) or found


def _receptacles_meant(state: SceneState, anchor: Things, context: Context) -> list[SceneObject]:
    """Return what ``on it`` means: what was mentioned last that can carry things, else what carries that.

    After "two apples on the table" one ``it`` is the table; ``them`` are the apples, or what carries them.
    """
    last = things_of(state, anchor, context)
    if context.holders:
        return _existing(state, context.holders) or last
    bearing = [item for item in last if (asset := state.asset(item)) is not None and (asset.surfaces or asset.volumes)]
    if bearing and (len(last) == 1 or anchor.plural or means_several(anchor)):
        return bearing
    carriers = list(dict.fromkeys(item.parent for item in last if item.parent is not None))
    return _existing(state, carriers) or last
