"""Find later mentions of rooms by a part of their names: "the dock" of a loading dock, "the preparation"."""

from dataclasses import replace

from mansion_planner.brief.phrase import PLAIN, Phrase, finished_phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.similarity import HEAD_TYPES

__all__ = ["room_by_its_contents", "rooms_named_again"]


def rooms_named_again(reading: Reading, chunks: list[tuple[int, int]], phrases: list[Phrase]) -> list[Phrase]:
    """Return later mentions of rooms of unknown kinds: "keep the scriptorium apart from the kitchen"."""
    unknown = {
        reading.words(p.begin, p.noun_end): p
        for p in phrases
        if p.head == "room" and (not p.known or p.begin not in reading.mention_at)
    }
    heads = _by_head(phrases)
    found = []
    for begin, end in chunks:
        first = unknown.get(reading.words(begin, end))
        first = first or _by_its_modifier(reading, phrases, begin, end) or _by_its_head(reading, heads, begin, end)
        if first is not None and reading.free(begin, end):
            phrase = finished_phrase(reading, "room", begin, end, room=first.room_type, known=first.known)
            reading.take(phrase.first, phrase.last)
            one_of = phrase.determiner in ("each", "every", "all", "both", "either")
            found.append(replace(phrase, name=first.name, determiner=phrase.determiner if one_of else "the"))
    return found


def room_by_its_contents(reading: Reading, phrases: list[Phrase], phrase: Phrase) -> Phrase:
    """Return the room that a thing stands for as the subject of a sentence: "percussion must not be next to ..."."""
    bare = phrase.head == "object" and not (phrase.determiner or phrase.counted) and reading.starts(phrase.begin)
    if not bare or phrase.noun_end - phrase.begin != 1 or reading.word(phrase.last) not in ("must", "should", "shall"):
        return phrase
    named = _by_its_modifier(reading, phrases, phrase.begin, phrase.noun_end)
    if named is None:
        return phrase
    room = finished_phrase(reading, "room", phrase.begin, phrase.noun_end, room=named.room_type, known=named.known)
    return replace(room, name=named.name, determiner="the")


def _by_its_modifier(reading: Reading, phrases: list[Phrase], begin: int, end: int) -> Phrase | None:
    """Return the one room of an earlier sentence that some words are short for: "the preparation", "sterilisation"."""
    sentence = reading.sentence[begin]
    words = reading.words(begin, end)
    elided = reading.word(begin - 1) == "the" and reading.word(end) in ("and", "or") and reading.word(end + 1) == "the"
    named = [
        phrase
        for phrase in phrases
        if phrase.head == "room"
        and phrase.count == 1
        and (reading.sentence[phrase.first] < sentence or (elided and phrase.last <= begin))
        and set(words) < set(phrase.name.split("_"))
        and words[-1] not in HEAD_TYPES
        and not PLAIN.issuperset(words)
    ]
    return named[0] if len({phrase.name for phrase in named}) == 1 else None


def _by_head(phrases: list[Phrase]) -> dict[str, Phrase]:
    """Return rooms by the last word of their names, where no two of other names share it."""
    named: dict[str, dict[str, Phrase]] = {}
    for phrase in phrases:
        if phrase.head == "room" and "_" in phrase.name:
            named.setdefault(phrase.name.rpartition("_")[2], {}).setdefault(phrase.name, phrase)
    return {head: next(iter(rooms.values())) for head, rooms in named.items() if len(rooms) == 1}


def _by_its_head(reading: Reading, heads: dict[str, Phrase], begin: int, end: int) -> Phrase | None:
    """Return the one room of an earlier sentence that "the dock" is short for: the loading dock."""
    if end - begin != 1 or reading.word(begin - 1) != "the":
        return None
    phrase = heads.get(reading.word(begin))
    earlier = phrase is not None and (reading.sentence[phrase.first] < reading.sentence[begin] or phrase.last <= begin)
    return phrase if earlier else None
