"""Places: chains of prepositional phrases, such as ``on the desk next to the window in the study upstairs``."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import msgspec

from mansion_editing.instructions.phrases.distances import read_distance, read_within
from mansion_editing.instructions.phrases.each_other import EACH_OTHER, end_of_each_other
from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.noun_phrases import NounPhrase, noun_phrase
from mansion_editing.instructions.phrases.storeys import read_relative_storey, read_storeys
from mansion_editing.instructions.phrases.unnamed_places import (
    end_of_building,
    end_of_same_room,
    goes_on_with_noun,
    read_former_spot,
)
from mansion_editing.instructions.phrases.word_sets import (
    BEFORE_PLACES,
    BEFORE_SPOTS,
    BESIDE_RELATIONS,
    NEAR_SPOTS,
    OUTER_DOORS,
)
from mansion_editing.instructions.phrases.words import BE, MODALS, PREPOSITIONS, Word, text_at
from mansion_editing.instructions.statements import JOINED, Amount, Place, Relation, Rooms, Spot, Things

__all__ = ["SAME_FLOOR", "SUPERLATIVES", "ReadPlace", "merged", "read_place", "with_place"]

SAME_FLOOR: Final = -99
"""Number of the storey that was mentioned last, until the whole instruction is read."""


@dataclass(frozen=True)
class ReadPlace:
    """A place and its end.

    Attributes
    ----------
    goal : bool
        It tells where something goes ("to", "into").
    source : bool
        It tells where something comes from ("from", "off", "out of").
    each : bool
        Every one of several places is meant ("on each desk").
    relative : bool
        In a relative clause ("that is on the desk"): where the thing is now.
    """

    place: Place
    start: int
    end: int
    goal: bool = False
    source: bool = False
    each: bool = False
    relative: bool = False


_ON: Final = ("on", "onto", "atop")
_PREPOSITIONS: Final[tuple[tuple[tuple[str, ...], Relation], ...]] = (
    (("on", "top", "of"), "on"), (("on", "the", "top", "of"), "on"), (("on", "to"), "on"),
    (("in", "to"), "in"), (("inside", "of"), "in"),
    (("in", "front", "of"), "front"), (("on", "either", "side", "of"), "around"),
    (("on", "both", "side", "of"), "around"),
    (("to", "the", "left", "and", "right", "of"), "around"), (("on", "the", "left", "and", "right", "of"), "around"),
    (("left", "and", "right", "of"), "around"), (("on", "each", "side", "of"), "around"),
    (("to", "both", "side", "of"), "around"),
    (("to", "the", "left", "of"), "left"), (("left", "of"), "left"), (("to", "the", "right", "of"), "right"),
    (("right", "of"), "right"), (("on", "the", "left", "of"), "left"), (("on", "the", "right", "of"), "right"),
    (("on", "the", "left", "side", "of"), "left"), (("on", "the", "right", "side", "of"), "right"),
    (("right", "next", "to"), "beside"), (("next", "to"), "beside"), (("close", "to"), "near"),
    (("near", "to"), "near"),
    (("by", "the", "side", "of"), "beside"), (("at", "the", "side", "of"), "beside"), (("side", "of"), "beside"),
    (("out", "of"), "in"), (("out", "from"), "in"), (("off", "of"), "on"), (("from", "under"), "under"),
    (("from", "on"), "on"),
    (("from", "inside"), "in"), (("from", "off"), "on"), (("away", "from"), ""), (("from", "in"), "in"),
    (("from", "behind"), "behind"), (("from", "the", "top", "of"), "on"), (("in", "the", "middle", "of"), "in"),
    (("back", "to"), ""), (("back", "in"), "in"), (("back", "on"), "on"), (("back", "into"), "in"),
    (("over", "from"), ""), (("up", "from"), ""), (("down", "from"), ""), (("back", "from"), ""),
    (("over", "to"), ""), (("over", "in"), "in"), (("up", "to"), ""), (("down", "to"), ""), (("down", "in"), "in"),
    (("up", "in"), "in"), (("across", "from"), "front"), (("around",), "around"), (("round",), "around"),
    (("on",), "on"), (("onto",), "on"), (("atop",), "on"), (("in",), "in"), (("into",), "in"), (("inside",), "in"),
    (("within",), "in"), (("at",), "beside"), (("by",), "beside"), (("beside",), "beside"), (("besides",), "beside"),
    (("near",), "near"), (("nearby",), "near"), (("alongside",), "beside"), (("under",), "under"),
    (("underneath",), "under"), (("beneath",), "under"), (("below",), "under"), (("above",), "above"),
    (("over",), "above"), (("behind",), "behind"), (("between",), "between"), (("among",), "between"),
    (("opposite", "to"), "front"), (("opposite", "of"), "front"),
    (("opposite",), "front"), (("against",), "beside"), (("along",), "beside"), (("from",), ""), (("off",), "on"),
    (("to",), ""), (("towards",), ""), (("toward",), ""), (("of",), ""), (("for",), ""), (("throughout",), "in"),
    (("across",), "in"), (("left",), "left"), (("right",), "right"),
)  # fmt: skip
_ALL_OVER: Final = ("over", "across")
_EXISTENCE: Final = BE | MODALS | frozenset(["need", "has", "have"])
"""After ``there`` they say that something is, not where."""

_ENDS: Final = ("", ",", ".", ";", "and", "then", "please", "!")
"""What may follow a preposition that stands alone: ``put a yogurt inside``."""

_GOAL_JOINTS: Final = ("to", "into", "onto")
_OWNERS: Final = frozenset("his her their my your our".split())
_SOURCES: Final = frozenset(["from", "off", "out", "away"])
_GOALS: Final = frozenset(["to", "into", "onto", "back", "over", "up", "down", "towards", "toward"])
_SPOTS: Final[dict[str, Spot]] = {
    "wall": "wall", "corner": "corner", "window": "window", "door": "door", "doorway": "door", "entrance": "door",
    "middle": "middle", "centre": "middle", "center": "middle", "entry": "door",
}  # fmt: skip


def read_place(words: Sequence[Word], at: int, lexicon: Lexicon, floors: Sequence[int]) -> ReadPlace | None:
    """Read one prepositional phrase, or a storey alone; None where there is none."""
    start = at
    place = at
    if text_at(words, place) in ("there", "away") and text_at(words, place + 1) in ("in", "on", "at", "by", "into"):
        place += 1
    while text_at(words, place) in BEFORE_PLACES and place < at + 3:
        if text_at(words, place) == "right" and text_at(words, place + 1) == "of":
            break
        if text_at(words, place) == "all" and text_at(words, place + 1) not in ("over", "around", "along", "across"):
            break
        place += 1
    bracket = text_at(words, place) == "("
    place += bracket
    if text_at(words, place) == "," and read_storeys(words, place + 1, floors) is not None:
        place += 1
    found = _unbracketed(words, place, lexicon, floors)
    if found is None:
        return None
    end = found.end + (bracket and text_at(words, found.end) == ")")
    return _between_ends(found, start, end)


def _between_ends(found: ReadPlace, start: int, end: int) -> ReadPlace:
    """Return a place with the ends of its words."""
    return ReadPlace(found.place, start, end, found.goal, found.source, found.each)


def _relative(words: Sequence[Word], at: int, lexicon: Lexicon, floors: Sequence[int]) -> ReadPlace | None:
    """Read ``one flight up``, ``on the floor below the kitchen``, ``right above the cafe``."""
    found = read_relative_storey(words, at)
    if found is None:
        return None
    up, end = found
    joint = end + (text_at(words, end) in ("from", "of", "than"))
    base = noun_phrase(words, joint, lexicon, floors)
    if base is not None and base.noun.kind in ("room", "both") and not base.noun.unknown and base.definite:
        rooms = Rooms(up=up, base=base.rooms().words)
        return ReadPlace(Place(rooms=rooms), at, base.end)
    goal = "up" in (text_at(words, at), text_at(words, end - 1)) or "down" in (
        text_at(words, at),
        text_at(words, end - 1),
    )
    return None if joint > end else ReadPlace(Place(rooms=Rooms(up=up)), at, end, goal=goal)


def _unbracketed(words: Sequence[Word], at: int, lexicon: Lexicon, floors: Sequence[int]) -> ReadPlace | None:
    former = read_former_spot(words, at, lexicon, floors)
    if former is not None:
        return ReadPlace(Place(former=former[0]), at, former[1], goal=True)
    relative = _relative(words, at, lexicon, floors)
    if relative is not None:
        return relative
    onwards = text_at(words, at) in ("up", "over", "down") and text_at(words, at - 1) in ("it", "them")
    if text_at(words, at) in ("up", "over", "down", "right") and text_at(words, at + 1) == "there":
        at += 1
    if text_at(words, at) in ("there", "here"):
        if text_at(words, at + 1) in _EXISTENCE or words[at].raw in ("there's", "theres"):
            return None
        return ReadPlace(Place(rooms=Rooms(same=True)), at, at + 1, goal=onwards)
    if text_at(words, at) == "everywhere" and text_at(words, at + 1) != "else":
        return ReadPlace(Place(rooms=Rooms(every=True)), at, at + 1)
    if text_at(words, at) in ("upstairs", "downstairs") or (at < len(words) and words[at].kind == "level"):
        return _storey(words, at, at, floors)
    if text_at(words, at) in ("ground", "first", "second", "third", "top") or (
        at < len(words) and words[at].kind == "ordinal"
    ):
        return _storey(words, at, at, floors)
    if text_at(words, at) in ("floor", "level"):
        return _storey(words, at, at, floors)
    if text_at(words, at) == "same" and text_at(words, at + 1) in ("floor", "room"):
        same = Rooms(same=True) if text_at(words, at + 1) == "room" else Rooms(floors=(SAME_FLOOR,))
        return ReadPlace(Place(rooms=same), at, at + 2)
    if text_at(words, at) == "facing":
        target = noun_phrase(words, at + 1, lexicon, floors)
        if target is None:
            return None
        spot = _SPOTS.get(target.noun.words[-1] if target.noun.words else "", "")
        if spot in ("window", "door", "wall"):
            return ReadPlace(Place(spot=spot), at, target.end)
        return ReadPlace(Place(facing=target.things()), at, target.end)
    if text_at(words, at) == "inside" and text_at(words, at + 1) in _ENDS:
        last = Things(refers="last", definite=True, amount=Amount(number=0))
        return ReadPlace(Place(relation="in", anchor=last), at, at + 1)
    if (text_at(words, at), text_at(words, at + 1)) == ("on", "top") and text_at(words, at + 2) in _ENDS:
        last = Things(refers="last", definite=True, amount=Amount(number=0))
        return ReadPlace(Place(relation="on", anchor=last), at, at + 2)
    end = end_of_each_other(words, at)
    if end:
        return ReadPlace(Place(relation="beside", anchor=EACH_OTHER), at, end)
    measured = read_distance(words, at, lexicon, floors)
    if measured is not None:
        return ReadPlace(measured[0], at, measured[1])
    which = _superlative(words, at, lexicon, floors)
    if which is not None:
        return which
    for phrase, relation in _PREPOSITIONS:
        if tuple(w.text for w in words[at : at + len(phrase)]) != phrase:
            continue
        found = _after_preposition(words, at, at + len(phrase), phrase, relation, lexicon, floors)
        if found is not None:
            return found
    return None


def _storey(words: Sequence[Word], start: int, at: int, floors: Sequence[int]) -> ReadPlace | None:
    storeys = read_storeys(words, at, floors)
    if storeys is None:
        return None
    numbers, every, end = storeys
    return ReadPlace(Place(rooms=Rooms(floors=numbers, every=every)), start, end, each=every)


def _after_preposition(
    words: Sequence[Word],
    start: int,
    at: int,
    phrase: tuple[str, ...],
    relation: Relation,
    lexicon: Lexicon,
    floors: Sequence[int],
) -> ReadPlace | None:
    goal, source = _direction(phrase)
    if phrase == ("within",):
        near = read_within(words, at, lexicon, floors)
        if near is not None:
            return ReadPlace(near[0], start, near[1])
    if text_at(words, at) in ("there", "here"):
        held: Relation = relation if relation in ("on", "in") else ""
        return ReadPlace(Place(relation=held, rooms=Rooms(same=True)), start, at + 1, goal, source)
    storeys = read_storeys(words, at, floors)
    nth = _ordinal_alone(words, at)
    if nth and relation in BESIDE_RELATIONS:
        one = Things(noun="one", amount=Amount(number=0), definite=True, ordinal=nth)
        return ReadPlace(Place(relation=relation, anchor=one), start, at + 2)  # "next to the first"
    if storeys is not None and not goes_on_with_noun(words, storeys[2], lexicon):
        numbers, every, end = storeys
        rooms = Rooms(floors=numbers, every=every)
        if phrase == ("off",) and text_at(words, at) in ("upstairs", "downstairs"):
            return None
        return ReadPlace(Place(rooms=rooms), start, end, goal, source, each=every)
    spot = _spot(words, start, at, phrase, relation, lexicon, floors)
    if spot is not None:
        return spot
    if phrase[0] in (*_ON, *_ALL_OVER, "off", "from"):
        floor = _on_floor(words, at, lexicon, floors)
        if floor is not None and (phrase[0] not in _ALL_OVER or floor[0].rooms is not None):
            return ReadPlace(floor[0], start, floor[1], goal, source, each=floor[2])
        if floor is not None:
            return None
    if text_at(words, at) == "the" and text_at(words, at + 1) == "same" and text_at(words, at + 2) == "floor":
        return ReadPlace(Place(rooms=Rooms(floors=(SAME_FLOOR,))), start, at + 3, goal, source)
    whole = end_of_building(words, at, lexicon)
    if whole:
        return ReadPlace(Place(), start, whole) if relation in ("in", "") and not goal else None
    same = end_of_same_room(words, at)
    if same:
        return ReadPlace(Place(rooms=Rooms(same=True)), start, same, goal, source)
    target = noun_phrase(words, at, lexicon, floors)
    if target is None or target.noun.unknown or target.amount.kind == "half":
        return None
    if text_at(words, at) in _OWNERS and target.noun.words == ("room",) and target.end == at + 2:
        return None  # nobody knows which room is his
    if relation == "between":
        return _between(words, start, target, lexicon, floors)
    read = _at_noun(words, start, phrase, relation, target, lexicon, floors, goal=goal, source=source)
    return _at_door(words, read, lexicon, floors) if target.noun.words[-1:] == ("door",) else read


def _on_floor(
    words: Sequence[Word], at: int, lexicon: Lexicon, floors: Sequence[int]
) -> tuple[Place, int, bool] | None:
    """Read ``the floor of the hall``, ``the kitchen floor``: a place, its end, and whether each is meant."""
    if text_at(words, at) != "the":
        return None
    if text_at(words, at + 1) == "floor":
        inner = _after_preposition(words, at + 2, at + 3, ("in",), "in", lexicon, floors)
        room = inner is not None and text_at(words, at + 2) in ("of", "in") and inner.place.anchor is None
        if inner is not None and room and inner.place.rooms is not None:
            return Place(rooms=inner.place.rooms, on_floor=True), inner.end, inner.each
        return Place(on_floor=True), at + 2, False
    end = next((k for k in range(at + 2, min(at + 5, len(words))) if words[k].text == "floor"), 0)
    name = tuple(word.text for word in words[at + 1 : end])
    if not end or not lexicon.is_room(name) or (end + 1 < len(words) and words[end + 1].kind == "number"):
        return None
    return Place(rooms=Rooms(words=" ".join(name)), on_floor=True), end + 1, False


def _ordinal_alone(words: Sequence[Word], at: int) -> int:
    """Return which one ``the first``, without a noun, means; 0 for other words."""
    if text_at(words, at) != "the" or at + 1 >= len(words) or words[at + 1].kind != "ordinal":
        return 0
    following = text_at(words, at + 2)
    ends = not following or words[at + 2].kind == "mark" or following in PREPOSITIONS | {"and", "please"}
    return int(words[at + 1].value) if ends else 0


def _at_door(words: Sequence[Word], read: ReadPlace, lexicon: Lexicon, floors: Sequence[int]) -> ReadPlace:
    """Return a place at a door with the rooms that tell which: ``next to the door to the kitchen``."""
    anchor, at = read.place.anchor, read.end
    if anchor is None or text_at(words, at) not in ("to", "of", "into", "between"):
        return read
    joint, relation = (text_at(words, at),), "between" if text_at(words, at) == "between" else "in"
    inner = _after_preposition(words, at, at + 1, joint, relation, lexicon, floors)  # type: ignore[arg-type]
    if inner is None or (inner.place.anchor is not None and relation == "in"):
        return read
    place = msgspec.structs.replace(read.place, anchor=with_place(anchor, inner.place))
    return ReadPlace(place, read.start, inner.end, read.goal, read.source, read.each)


def _direction(phrase: tuple[str, ...]) -> tuple[bool, bool]:
    """Return whether a preposition tells where something goes, and whether it tells where it comes from."""
    source = phrase[0] in _SOURCES or (phrase[0] in _GOALS and phrase[-1] == "from")
    return phrase[0] in _GOALS and not source, source


_DISTANCES: Final[dict[str, Relation]] = {
    "nearest": "nearest", "closest": "nearest", "furthest": "farthest", "farthest": "farthest",
}  # fmt: skip


SUPERLATIVES: Final = frozenset(_DISTANCES.values())
"""Relations that tell which of several things is meant, not where it is."""


def _superlative(words: Sequence[Word], at: int, lexicon: Lexicon, floors: Sequence[int]) -> ReadPlace | None:
    """Read ``nearest to the door``, ``furthest from the sofa``, which tells which of several things is meant."""
    relation = _DISTANCES.get(text_at(words, at))
    if relation is None:
        return None
    place = at + 1 + (text_at(words, at + 1) == "away")
    place += text_at(words, place) in ("to", "from")
    spot = place + (text_at(words, place) in ("the", "a"))
    named = (text_at(words, spot), text_at(words, spot + 1))
    plain = _SPOTS.get(named[0]) if not lexicon.is_object(named) else None
    if plain is not None:
        inner = None
        if text_at(words, spot + 1) == "of":
            inner = _after_preposition(words, spot + 1, spot + 2, ("in",), "in", lexicon, floors)
        rooms = inner.place.rooms if inner is not None and inner.place.anchor is None else None
        end = spot + 1 if inner is None or rooms is None else inner.end
        return ReadPlace(Place(relation=relation, spot=plain, rooms=rooms), at, end)
    target = noun_phrase(words, place, lexicon, floors)
    if target is None or target.noun.unknown or target.noun.kind == "room":
        return None
    return ReadPlace(Place(relation=relation, anchor=target.things()), at, target.end)


def _spot(
    words: Sequence[Word],
    start: int,
    at: int,
    phrase: tuple[str, ...],
    relation: Relation,
    lexicon: Lexicon,
    floors: Sequence[int],
) -> ReadPlace | None:
    """Read ``in the corner``, ``against the wall``, ``by the window``, ``in the middle of the room``."""
    goal, source = _direction(phrase)
    if phrase == ("in", "the", "middle", "of"):
        inner = _after_preposition(words, start, at, ("in",), "in", lexicon, floors)
        if inner is None or inner.place.anchor is not None:
            return None
        return ReadPlace(msgspec.structs.replace(inner.place, spot="middle"), start, inner.end)
    place = at
    while text_at(words, place) in BEFORE_SPOTS:
        place += 1
    word = text_at(words, place)
    room = _window_of_room(words, place, lexicon) if phrase[0] in NEAR_SPOTS else None
    if room is not None:
        return ReadPlace(Place(spot="window", rooms=room[0]), start, room[1], goal, source)
    if text_at(words, place - 1) == "one" and word == "of":
        place += 1 + (text_at(words, place + 1) == "the")
        word = text_at(words, place)
    if word not in _SPOTS or (place == at and word not in ("middle",)):
        return None
    named = (word, text_at(words, place + 1))
    if lexicon.is_room(named) or lexicon.is_object(named):
        return None
    spot = _SPOTS[word]
    if spot == "door" and word == "door" and text_at(words, place - 1) in OUTER_DOORS:
        return None  # one door of the building, not any of the room
    ceiling_or_wall = phrase[0] in _ON and spot == "wall"
    if relation in ("", "above", "under", "behind") and not goal:
        return None
    if spot in ("window", "door") and phrase[0] not in NEAR_SPOTS:
        return None
    if spot == "door" and text_at(words, place + 1) in ("to", "between", "of"):
        return None
    if spot == "wall" and not ceiling_or_wall and phrase[0] not in ("against", "along", "at", "by", "to", "next"):
        return None
    end = place + 1
    rooms = None
    if text_at(words, end) == "of":
        inner = _after_preposition(words, end, end + 1, ("in",), "in", lexicon, floors)
        if inner is not None and inner.place.anchor is None:
            rooms, end = inner.place.rooms, inner.end
        elif inner is not None:
            return None
    return ReadPlace(Place(spot=spot, rooms=rooms), start, end, goal, source)


def _window_of_room(words: Sequence[Word], at: int, lexicon: Lexicon) -> tuple[Rooms, int] | None:
    """Read ``kitchen window``, ``bedroom 2 window``: the window of a room that the building has."""
    end = next((k for k in range(at + 1, min(at + 5, len(words))) if words[k].text == "window"), 0)
    name = tuple(word.text for word in words[at:end])
    if not end or not lexicon.is_own_room(name) or lexicon.is_object((*name[-1:], "window")):
        return None
    return Rooms(words=" ".join(name)), end + 1


def _between(
    words: Sequence[Word], start: int, first: NounPhrase, lexicon: Lexicon, floors: Sequence[int]
) -> ReadPlace | None:
    if text_at(words, first.end) == "and":
        second = noun_phrase(words, first.end + 1, lexicon, floors)
        if second is not None and not second.noun.unknown:
            place = Place(relation="between", anchor=first.things(), other=second.things())
            return ReadPlace(place, start, second.end)
    if first.plural:
        return ReadPlace(Place(relation="between", anchor=first.things()), start, first.end)
    return None


def _at_noun(
    words: Sequence[Word],
    start: int,
    phrase: tuple[str, ...],
    relation: Relation,
    target: NounPhrase,
    lexicon: Lexicon,
    floors: Sequence[int],
    *,
    goal: bool,
    source: bool,
) -> ReadPlace:
    """Return the place that a preposition and a noun make: in a room, or in a relation to a thing."""
    noun = target.noun
    if target.refers == "last" and target.amount.kind == "all" and relation == "in" and not noun.words:
        rooms = Rooms(same=True, every=True, number=target.amount.number)
        return ReadPlace(Place(rooms=rooms), start, target.end, goal, source, each=True)
    if noun.words in (("ceiling",), ("wall",)) and noun.owned:
        spot: Spot = "wall" if noun.words == ("wall",) else ""
        return ReadPlace(Place(rooms=Rooms(words=noun.owned), spot=spot), start, target.end, goal, source)
    inward = relation in ("in", "") or phrase[0] in ("at", "throughout", "across")
    inward = inward or (relation in ("above", "under") and text_at(words, start - 1) == "room")
    room = noun.kind == "room" or (noun.kind == "both" and inward and lexicon.means_own_room(noun.words))
    if noun.kind == "both" and text_at(words, target.start) in ("a", "an") and lexicon.is_short_for_room(noun.words):
        room = False  # "in a locker"
    if (
        noun.kind == "both"
        and not inward
        and relation in ("on", "under", "beside", "near", "behind", "front")
        and phrase[0] != "at"
    ):
        room = False
    if target.refers and relation == "" and noun.kind == "anything":
        room = False
    if room:
        rooms = target.rooms()
        if relation in ("in", "") and not rooms.every and noun.kind == "room":
            rooms, target = _and_rooms(words, rooms, target, lexicon, floors)
        if target.refers:
            rooms = msgspec.structs.replace(rooms, same=False)
        if relation in ("above", "under"):
            up = 1 if relation == "above" else -1
            rooms = Rooms(up=up, base=rooms.words, over=True, floors=())
        elif relation in ("beside", "near", "front") and phrase[0] != "at" and phrase[0] != "by":
            rooms = Rooms(next_to=rooms.words, floors=rooms.floors)
        return ReadPlace(Place(rooms=rooms), start, target.end, goal, source, each=target.each or rooms.every)
    own: Relation = "" if phrase == ("from",) else relation or "on"
    if phrase == ("for",) and target.each and lexicon.lies_beside_others(noun.words):
        own = "beside"  # "a glass for every plate"
    if phrase[-1] == "to" and own == "on" and goal and lexicon.encloses(noun.words):
        own = "in"  # "move the milk to the fridge"
    outside = phrase == ("away", "from")
    place = Place(relation=own, anchor=target.things(), outside=outside)
    return ReadPlace(place, start, target.end, goal, source, each=target.each)


def _and_rooms(
    words: Sequence[Word], rooms: Rooms, target: NounPhrase, lexicon: Lexicon, floors: Sequence[int]
) -> tuple[Rooms, NounPhrase]:
    """Read ``and the bathroom`` after a room, where the clause ends with it."""
    names, last = [rooms.words], target
    while text_at(words, last.end) in ("and", ",", "&"):
        at = last.end + 1 + (text_at(words, last.end) == "," and text_at(words, last.end + 1) == "and")
        more = noun_phrase(words, at, lexicon, floors)
        if more is None or more.noun.kind != "room" or more.noun.unknown or more.refers or more.noun.plural:
            break
        names.append(more.rooms().words)
        last = more
    following = text_at(words, last.end)
    ends = last.end >= len(words) or words[last.end].kind == "mark" or following in ("please", "too", *_GOAL_JOINTS)
    if len(names) < 2 or not ends or not all(names):
        return rooms, target
    return Rooms(words=JOINED.join(names), floors=rooms.floors, every=True, number=len(names)), last


def merged(outer: Place, inner: Place) -> Place:
    """Return a place that a further phrase tells more of: ``on the desk`` and ``in the study``."""
    rooms = _merged_rooms(outer.rooms, inner.rooms)
    if inner.relation in SUPERLATIVES and outer.anchor is not None:
        anchor = with_place(outer.anchor, msgspec.structs.replace(inner, rooms=None))
        return msgspec.structs.replace(outer, anchor=anchor, rooms=rooms)  # "on the desk nearest the door"
    if inner.anchor is None and inner.relation in SUPERLATIVES:
        return msgspec.structs.replace(inner, rooms=rooms)
    if inner.anchor is None:
        return msgspec.structs.replace(
            outer,
            rooms=rooms,
            spot=outer.spot or inner.spot,
            facing=outer.facing or inner.facing,
            within=outer.within or inner.within,
            apart=outer.apart or inner.apart,
            on_floor=outer.on_floor or inner.on_floor,
        )
    if outer.anchor is None:
        return msgspec.structs.replace(
            inner,
            rooms=rooms,
            spot=outer.spot or inner.spot,
            facing=outer.facing or inner.facing,
            on_floor=outer.on_floor or inner.on_floor,
        )
    plain = msgspec.structs.replace(inner, rooms=None)
    anchor = with_place(outer.anchor, plain)
    return msgspec.structs.replace(outer, anchor=anchor, rooms=rooms)


def _merged_rooms(one: Rooms | None, other: Rooms | None) -> Rooms | None:
    if one is None or other is None:
        return one or other
    if other.words and not one.words:
        one, other = other, one
    here = (SAME_FLOOR,) if other.same and not other.every and one.words and not (one.floors or one.up) else ()
    both = tuple(floor for floor in one.floors if floor in other.floors)  # "upstairs on 2"
    return msgspec.structs.replace(
        one,
        floors=both or one.floors or other.floors or here,
        every=one.every or (other.every and not other.words),
        same=one.same or (other.same and not here and not one.up and not (one.words and other.every)),
        number=one.number or other.number,
        next_to=one.next_to or other.next_to or ("" if _says_the_same(one, other) else other.words),
        up=one.up or other.up,
        base=one.base or other.base,
        over=one.over or other.over,
        others=one.others or other.others,
        but=one.but or other.but,
    )


def _says_the_same(one: Rooms, other: Rooms) -> bool:
    """Whether words for a room only repeat those for another: the director's, and the director's office."""
    return not one.words or set(other.words.split()) <= set(one.words.split())


def with_place(things: Things, place: Place) -> Things:
    """Return things that are at a place; one of several rooms is one in each of them."""
    one = things.definite and not things.plural and things.amount.kind == "some" and things.amount.number <= 1
    if one and not things.refers and place.rooms is not None and JOINED in place.rooms.words:
        things = msgspec.structs.replace(things, amount=Amount(kind="all", number=0), plural=True)
    return msgspec.structs.replace(things, place=place if things.place is None else merged(things.place, place))
