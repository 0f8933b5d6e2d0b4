"""Read how much is to lie about: "crammed with stuff", "a cluttered kitchen", "keep it tidy", "no knick-knacks"."""

from collections.abc import Sequence

from mansion_msgs_py.program import Clutter
from mansion_planner.brief.facts import ClutterFact
from mansion_planner.brief.finishes import room_after
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["read_clutter_words", "read_things_about"]

_FILLED = frozenset("crammed packed stuffed filled full littered overflowing cluttered strewn jammed bursting".split())
_THINGS = frozenset("stuff thing clutter mess knickknack knack trinket belonging junk possession bric end".split())
"""Nouns for small things of any kind; the last ones head the pieces of "bric-a-brac" and "odds and ends"."""
_ANY_THINGS = frozenset({"object", "item"})
"""Nouns for small things where an adjective calls them small."""
_MANY = frozenset("lot plenty many load heap ton pile much".split())
_FEW = frozenset({"no", "few", "little", "hardly", "without", "minimal", "less"})
_CLUTTERED = frozenset({"cluttered", "messy", "untidy", "crammed"})
_TIDY = frozenset({"uncluttered", "decluttered", "tidy"})
_NOT = frozenset({"not", "never", "n't"})
_BE = frozenset("is are be look feel looks feels".split())
_LYING = frozenset({"lying", "lie", "lies", "standing"})
_SMALL = frozenset({"small", "little", "tiny"})
_LINKS = frozenset(
    "of all sort kind with any very everyday personal other the a an his her their our my lots so too up in to knick -"
    " and odd".split()
)
_MOST_LINKS = 6


def read_things_about(reading: Reading) -> None:
    """Read what fills a place and how many things there are, before noun phrases are made of the same words."""
    for index in range(len(reading.tokens)):
        word = reading.word(index)
        if index in reading.taken or not (word in _FILLED or word in _MANY | _FEW):
            continue
        last = _things_after(reading, index)
        if not last or (word in _FEW and reading.word(index - 1) == "a"):
            continue
        room = _room_of(reading, index, last)
        _record(reading, "sparse" if word in _FEW else "dense", room, index, _after_lying(reading, last))


def read_clutter_words(reading: Reading, phrases: Sequence[Phrase]) -> None:
    """Read the adjectives: those before a room are said of such rooms, all others of the whole building."""
    for index in range(len(reading.tokens)):
        word = reading.word(index)
        if word not in _CLUTTERED | _TIDY and not _is_clutter_free(reading, index):
            continue
        inside = next((phrase for phrase in phrases if phrase.begin <= index < phrase.noun_end), None)
        if inside is None and not reading.free(index, index + 1):
            continue
        first, last = index, index + (1 if word in _CLUTTERED | _TIDY else 2)
        dense = word in _CLUTTERED
        negation = next((at for at in range(index - 1, index - 4, -1) if reading.word(at) in _NOT), -1)
        if negation >= 0 and reading.sentence[negation] == reading.sentence[index]:
            first, dense = negation, not dense
        is_room = inside is not None and inside.head == "room" and not _is_unit(reading, inside)
        room = inside.room_type if inside is not None and is_room else ""
        _record(reading, "dense" if dense else "sparse", room or _subject(reading, first), first, last)


def _record(reading: Reading, clutter: Clutter, room: str, first: int, last: int) -> None:
    reading.facts.clutter.append(ClutterFact(clutter, room, reading.span(first, last)))
    reading.take(first, last)


def _things_after(reading: Reading, index: int) -> int:
    """Return the token after the small things that a word says something of; 0 where it says it of another noun."""
    at = index + 1
    small = False
    while at - index <= _MOST_LINKS and reading.word(at) in _LINKS | _SMALL | _MANY:
        small = small or reading.word(at) in _SMALL
        at += 1
    if reading.word(at) in _THINGS:
        if reading.word(at) == "bric":
            while reading.word(at + 1) in ("-", "a", "brac"):
                at += 1
        return at + 1
    return at + 1 if small and reading.word(at) in _ANY_THINGS else 0


def _after_lying(reading: Reading, last: int) -> int:
    """Return the token after words that only say that things lie somewhere: "lots of stuff lying around"."""
    if reading.word(last) in _LYING:
        last += 1 + (reading.word(last + 1) in ("about", "around", "everywhere"))
    if reading.words(last, last + 3) == ("on", "the", "furniture"):
        last += 3
    return last


def _is_clutter_free(reading: Reading, index: int) -> bool:
    return reading.words(index, index + 2) == ("clutter", "free")


def _room_of(reading: Reading, first: int, last: int) -> str:
    """Return the type of the room that is full of things: "a kitchen full of stuff", "lots of stuff in the kitchen"."""
    if reading.word(last) in ("in", "on", "around"):
        return room_after(reading, last + 1)
    return _subject(reading, first)


def _subject(reading: Reading, first: int) -> str:
    """Return the type of the room that words right before a token name, "is" and the like aside."""
    at = first
    while reading.word(at - 1) in _BE | {"should", "must", "to"}:
        at -= 1
    if reading.word(at - 1) == "place" and at < first:
        reading.take(at - 1, at)
    mention = next((m for m in reading.mentions if m.last == at and m.room and not m.building), None)
    if mention is None or reading.knowledge.room(mention.room).unit:
        return ""
    return mention.room


def _is_unit(reading: Reading, phrase: Phrase) -> bool:
    return bool(phrase.room_type) and reading.knowledge.room(phrase.room_type).unit
