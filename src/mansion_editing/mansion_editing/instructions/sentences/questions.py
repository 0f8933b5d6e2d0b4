"""Questions about a building, and orders to answer them ("count the chairs")."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.places import merged
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import (
    AFTER_COUNTED,
    AFTER_WHAT,
    AFTER_WHERE,
    AFTER_WHICH_ROOMS,
    BEFORE_ASKED_STATES,
    BEFORE_COUNTED,
    GOING_OR_WAYS,
    HAVING,
    OPEN_QUESTIONS,
)
from mansion_editing.instructions.phrases.words import BE, MODALS, PERSONS, STATE_WORDS, Word
from mansion_editing.instructions.statements import Amount, Ask, Place, Rooms, Things

__all__ = ["further_question", "read_question"]

_OPENINGS: Final = (
    ("tell", "me"), ("let", "me", "know"), ("can", "you", "tell", "me"), ("could", "you", "tell", "me"), ("say",),
    ("please", "tell", "me"), ("do", "you", "know"), ("i", "want", "to", "know"), ("i", "would", "like", "to", "know"),
    ("show", "me"), ("find", "out"), ("check",), ("i", "wonder"), ("please",), ("hi",), ("hello",), ("and",), (",",),
    ("whether",), ("if",), ("so",), ("ok",), ("hey",), ("sorry",), ("but",), ("just", "tell", "me"), ("also",),
    ("quick", "question"),
    (":",), ("we", "want", "to", "know"), ("would", "you", "tell", "me"), ("could", "you", "please", "tell", "me"),
    ("can", "you", "check"), ("could", "you", "check"),
)  # fmt: skip


def read_question(reader: ClauseReader, words: Sequence[Word], at: int, *, marked: bool) -> tuple[Ask, int] | None:
    """Read the question at a place; None where the words ask nothing.

    Parameters
    ----------
    marked : bool
        The sentence ends with a question mark.
    """
    start = at
    moved = True
    opened = False
    while moved:
        moved = False
        for opening in _OPENINGS:
            if tuple(w.text for w in words[at : at + len(opening)]) == opening:
                if opening == ("check",) and reader.text(at + 1) not in ("if", "whether", "how", "where", "what"):
                    continue
                asked = ("how", "where", "what", "if", "whether")
                if opening == ("check",) and not marked and reader.text(at + 1) not in asked:
                    return None
                at += len(opening)
                moved = True
                opened = opened or len(opening) > 1 or opening[0] in ("whether", "if")
    for form in (_how_many, _where, _what, _how_large, _yes_or_no, _count):
        found = form(reader, at, marked=marked, opened=opened)
        if found is not None:
            ask, end = found
            return msgspec.structs.replace(ask, quote=reader.quote(start, end)), end
    return None


def further_question(reader: ClauseReader, first: tuple[Ask, int], *, marked: bool) -> tuple[Ask, int] | None:
    """Read a question that is joined to the one before it: ``... and how many in the hall``; None where none is.

    Raises
    ------
    NotUnderstood
    """
    ask, before = first
    at = reader.skip(before)
    if not (reader.text(at) in ("and", "or") or reader.text(at - 1) in (",", "and")) or at >= len(reader.words):
        return None
    if ask.about == "count" and ask.place is not None and reader.text(at + 1) == "many":
        place, end = _rest(reader, at + 2)
        if place is not None and place != Place():
            return msgspec.structs.replace(ask, place=place, quote=reader.quote(at, end)), end
    found = read_question(reader, reader.words, at, marked=marked)
    return found if found is not None and found[1] > at else None


def _place_of(item: Item) -> Place | None:
    things = item.things()
    return things.place


def _plain(item: Item) -> Things:
    """Return the things of a question: as many as there are."""
    return msgspec.structs.replace(item.phrase.things(), amount=Amount(kind="all", number=0), place=None)


def _rest(reader: ClauseReader, at: int) -> tuple[Place | None, int]:
    """Read ``are there in the lobby`` after what is asked for."""
    while reader.text(at) in BE or reader.text(at) in MODALS or reader.text(at) in AFTER_COUNTED:
        if reader.text(at) in ("in", "at", "right", "the") and reader.text(at + 1) not in (
            "total",
            "moment",
            "the",
            "now",
        ):
            break
        if reader.text(at) in ("in", "at", "the") and reader.places(at)[0]:
            break
        at += 1
    places, end = reader.places(at)
    place: Place | None = None
    for read in places:
        place = read.place if place is None else merged(place, read.place)
    while reader.text(end) in BE or reader.text(end) in ("there", "now", "currently", "have", "has", "altogether"):
        end += 1
    return place, end


def _how_many(reader: ClauseReader, at: int, *, marked: bool, opened: bool) -> tuple[Ask, int] | None:
    if (reader.text(at), reader.text(at + 1)) not in (("how", "many"), ("how", "much"), ("number", "of")):
        return None
    item = reader.item(at + 2)
    if item is None and (reader.text(at + 2) in BE or reader.text(at + 2) in ("do", "does", "remain")):
        where, end = _rest(reader, at + 2)
        while reader.text(end) in ("left", "remain", "still", "it", "we", "have", "over", "now"):
            end += 1
        them = Things(refers="last", definite=True, plural=True, amount=Amount(kind="all", number=0))
        return Ask(about="count", things=them, place=where), end
    if item is None:
        raise NotUnderstood(at, reader.boundary(at))
    subject_end = item.end
    place, end = _rest(reader, subject_end)
    where = _place_of(item)
    if where is not None:
        place = where if place is None else merged(place, where)
    if place is None and reader.text(subject_end) in ("do", "does"):
        owner = reader.item(subject_end + 1)
        if owner is not None:
            place, end = Place(rooms=owner.rooms()), owner.end
            end += reader.text(end) in ("have", "contain", "hold")
    if item.is_room:
        return Ask(about="rooms", rooms=item.rooms(), place=place), end
    if item.phrase.noun.kind == "both" and place is None:
        return Ask(about="rooms", rooms=item.rooms()), end
    states = _trailing_state(reader, end)
    things = _plain(item)
    if states is not None:
        things = msgspec.structs.replace(things, states=states[0])
        end = states[1]
    return Ask(about="count", things=things, place=place), end


def _trailing_state(reader: ClauseReader, at: int) -> tuple[dict[str, bool], int] | None:
    place = at
    while reader.text(place) in ("switched", "turned", "currently", "still"):
        place += 1
    if reader.text(place) in STATE_WORDS and reader.phrase(place + 1) is None:
        name, value = STATE_WORDS[reader.text(place)]
        return {name: value}, place + 1
    return None


def _count(reader: ClauseReader, at: int, *, marked: bool, opened: bool) -> tuple[Ask, int] | None:
    if reader.text(at) not in ("count", "list"):
        return None
    place = at + 1
    while reader.text(place) in BEFORE_COUNTED:
        if reader.text(place) in ("what", "everything", "thing", "object"):
            where, end = _rest(reader, place + 1)
            return (Ask(about="what", place=where), end) if where is not None else None
        place += 1
    item = reader.item(place)
    if item is None:
        raise NotUnderstood(at, reader.boundary(at))
    if item.is_room:
        return Ask(about="rooms", rooms=item.rooms()), item.end
    return Ask(about="count", things=_plain(item), place=_place_of(item)), item.end


def _where(reader: ClauseReader, at: int, *, marked: bool, opened: bool) -> tuple[Ask, int] | None:
    first = reader.text(at)
    if first not in ("where", "which", "in", "on", "what"):
        return None
    if first == "which" or (
        first in ("in", "on", "what") and reader.text(at + (first != "what")) in ("which", "what", "room", "floor")
    ):
        return _which_rooms(reader, at)
    if first != "where":
        return None
    place = at + 1
    while reader.text(place) in BE or reader.text(place) in AFTER_WHERE:
        place += 1
    item = reader.item(place)
    if item is None:
        raise NotUnderstood(at, reader.boundary(at))
    end = item.end
    while reader.text(end) in BE or reader.text(end) in ("located", "kept"):
        end += 1
    if item.is_room or reader.lexicon.is_own_room(item.phrase.noun.words):
        return Ask(about="where", rooms=item.rooms()), end
    return Ask(about="where", things=_plain(item), place=_place_of(item)), end


def _which_rooms(reader: ClauseReader, at: int) -> tuple[Ask, int] | None:
    """Read ``which rooms have a piano?``, ``on which floor is the library?``."""
    place = at
    while reader.text(place) in ("in", "on", "which", "what", "of", "the"):
        place += 1
    noun = reader.text(place)
    if noun not in ("room", "floor"):
        item = reader.item(place)
        if item is None or not item.is_room:
            return None
        holder: Rooms | None = item.rooms()
        place = item.end
    else:
        holder = None
        place += 1
    where, after = reader.places(place)
    if where:
        place = after
    while reader.text(place) in BE or reader.text(place) in AFTER_WHICH_ROOMS:
        place += 1
    if place >= len(reader.words):
        named = where[0].place.rooms if where else None
        return Ask(about="rooms", rooms=named or holder or Rooms(every=True)), place
    item = reader.item(place)
    if item is None:
        return None
    end = item.end
    while reader.text(end) in BE or reader.text(end) in ("located", "in", "on"):
        end += 1
    if item.is_room or (noun == "floor" and reader.lexicon.is_own_room(item.phrase.noun.words)):
        return Ask(about="where", rooms=item.rooms()), end
    if noun == "room" or holder is not None:
        wanted = msgspec.structs.replace(_plain(item), definite=False)
        floors = where[0].place.rooms.floors if where and where[0].place.rooms is not None else ()
        base = holder or Rooms(every=True, floors=floors)
        return Ask(about="rooms", rooms=msgspec.structs.replace(base, every=True, holding=wanted)), end
    return Ask(about="where", things=_plain(item)), end


def _what(reader: ClauseReader, at: int, *, marked: bool, opened: bool) -> tuple[Ask, int] | None:
    if reader.text(at) != "what":
        return None
    place = at + 1
    if reader.text(place) in ("colour", "color"):
        place += 1
        while reader.text(place) in BE:
            place += 1
        item = reader.item(place)
        if item is None:
            raise NotUnderstood(at, reader.boundary(at))
        end = item.end + (reader.text(item.end) in BE)
        return Ask(about="colour", things=_plain(item), place=_place_of(item)), end
    while reader.text(place) in BE or reader.text(place) in AFTER_WHAT:
        place += 1
    where, end = _rest(reader, place)
    if where is None:
        return None
    return Ask(about="what", place=where), end


def _how_large(reader: ClauseReader, at: int, *, marked: bool, opened: bool) -> tuple[Ask, int] | None:
    if reader.text(at) == "how" and reader.text(at + 1) in ("large", "big", "spacious", "small"):
        place = at + 2
    elif reader.text(at) == "what" and {reader.text(at + 1), reader.text(at + 2), reader.text(at + 3)} & {
        "area",
        "size",
    }:
        place = next(k for k in range(at, at + 4) if reader.text(k) in ("area", "size")) + 1
        place += reader.text(place) in ("of",)
    else:
        return None
    while reader.text(place) in BE:
        place += 1
    item = reader.item(place)
    if item is None or item.phrase.noun.kind not in ("room", "both"):
        return None
    end = item.end + (reader.text(item.end) in BE)
    return Ask(about="area", rooms=item.rooms()), end


def _asks_somebody(reader: ClauseReader, at: int) -> bool:
    """Whether somebody is asked to do something with a thing: ``could somebody move the laptop to the desk``."""
    verb = verb_at(reader.words, at + 1, reader.lexicon)
    item = None if verb is None or reader.text(at) not in PERSONS else reader.item(verb[1])
    return item is not None and not item.is_room


def _yes_or_no(reader: ClauseReader, at: int, *, marked: bool, opened: bool) -> tuple[Ask, int] | None:
    """Read ``is the fridge closed?``, ``are there chairs in the lobby?``, ``does the kitchen have a sink?``."""
    first = reader.text(at)
    if first not in OPEN_QUESTIONS:
        if not (opened and reader.item(at) is not None):
            return None
    elif not (marked or opened):
        return None
    if first in ("can", "could"):
        return None if _asks_somebody(reader, at + 1) else _reach(reader, at)
    if (first in ("is", "are") and reader.text(at + 1) == "there") or first in ("there", "any"):
        place = at + 1 + (first in ("is", "are"))
        place -= first == "any"
        while reader.text(place) in BE:
            place += 1
        return _exists(reader, at, place)
    if first in ("do", "does", "has", "have"):
        return _has(reader, at)
    place = at + (first in BE)
    item = reader.item(place)
    if item is None:
        raise NotUnderstood(at, reader.boundary(at))
    end = item.end
    while reader.text(end) in BE or reader.text(end) in BEFORE_ASKED_STATES:
        end += 1
    if reader.text(end) in STATE_WORDS:
        name, value = STATE_WORDS[reader.text(end)]
        end += 1
        while reader.text(end) in ("or",) and reader.text(end + 1) in (*STATE_WORDS, "not"):
            end += 2
        where, end = _rest(reader, end)
        own = _place_of(item)
        place_ = own if where is None else where if own is None else merged(where, own)
        return Ask(
            about="state", things=_plain(item), place=place_, state="open" if name == "open" else "on", value=value
        ), end
    where, end = _rest(reader, end)
    own = _place_of(item)
    if reader.text(end) == "reachable":
        return Ask(about="reach", rooms=item.rooms()), end + 1
    if item.is_room:
        return Ask(about="where", rooms=item.rooms()), end
    place_ = own if where is None else where if own is None else merged(where, own)
    return Ask(about="exists", things=item.phrase.things(), place=place_), end


def _exists(reader: ClauseReader, at: int, place: int) -> tuple[Ask, int] | None:
    if reader.text(place) in ("anything", "something"):
        where, end = _rest(reader, place + 1)
        if where is None:
            raise NotUnderstood(at, reader.boundary(at))
        return Ask(about="what", place=where), end
    if reader.text(place) in ("a", "any", "the") and reader.text(place + 1) in ("way", "path", "route"):
        return _reach(reader, place + 1)
    item = reader.item(place)
    if item is None:
        raise NotUnderstood(at, reader.boundary(at))
    where, end = _rest(reader, item.end)
    own = _place_of(item)
    if item.is_room:
        return Ask(about="rooms", rooms=item.rooms()), end
    place_ = own if where is None else where if own is None else merged(where, own)
    state = _trailing_state(reader, end)
    things = item.phrase.things()
    if state is not None:
        things, end = msgspec.structs.replace(things, states=state[0]), state[1]
    return Ask(about="exists", things=things, place=place_), end


def _has(reader: ClauseReader, at: int) -> tuple[Ask, int] | None:
    """Read ``do we have a printer on floor 2?``, ``does the kitchen have a sink?``."""
    place = at + 1
    holder: Place | None = None
    if reader.text(place) in ("we", "you", "i", "they", "it", "any"):
        place += reader.text(place) != "any"
    else:
        item = reader.item(place)
        if item is None:
            return None
        holder = Place(rooms=item.rooms()) if item.is_room else Place(relation="on", anchor=item.phrase.things())
        place = item.end
    while reader.text(place) in HAVING:
        place += 1
    thing = reader.item(place)
    if thing is None:
        return None
    end = thing.end
    own = _place_of(thing)
    where = holder if own is None else own if holder is None else merged(holder, own)
    if thing.is_room:
        return Ask(about="rooms", rooms=thing.rooms()), end
    return Ask(about="exists", things=thing.phrase.things(), place=where), end


def _reach(reader: ClauseReader, at: int) -> tuple[Ask, int] | None:
    """Read ``can a robot get from the lobby to the lab?``."""
    place = at
    while place < len(reader.words) and reader.text(place) not in ("from", "to", "reach", "into", "enter", "upstairs"):
        if place > at + 7:
            return None
        place += 1
    if place >= len(reader.words):
        return None
    if (
        reader.text(at + 1) in ("you", "we")
        and reader.text(place) == "to"
        and reader.text(at + 2) not in ("get", "go", "walk", "drive")
    ):
        return None
    going = GOING_OR_WAYS
    if reader.text(place) not in ("reach", "enter") and not any(w.text in going for w in reader.words[at:place]):
        return None
    place += reader.text(place) in ("reach", "enter")
    try:
        statements, end = reader._way(at, place)
    except NotUnderstood:
        return None
    reach = statements[0]
    start, goal = getattr(reach, "start", None), getattr(reach, "end", None)
    rooms = goal if isinstance(goal, Rooms) else None
    things = goal if isinstance(goal, Things) else None
    return Ask(about="reach", start=start if isinstance(start, Rooms) else None, rooms=rooms, things=things), end
