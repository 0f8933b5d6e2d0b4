"""Read rooms named again: by a pronoun, "a second one just for cats", or a part of their names, "the dock"."""

from dataclasses import replace

from mansion_language import singular
from mansion_planner.brief.phrase import FUNCTION_WORDS, PLAIN, Phrase, finished_phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.similarity import HEAD_TYPES
from mansion_planner.brief.told_by_size import COMPARATIVES

__all__ = ["further_ones", "room_by_its_contents", "rooms_named_again"]

_FURTHER = frozenset({"second", "third", "fourth", "another", "further", "smaller", "larger", "separate", "different"})
_JOINTS = frozenset({",", "and", "plus", "&", "+", "with", ";", "as"})


def further_ones(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return a room for each "a second one", "another one for cats" that follows a room in its sentence."""
    found: list[Phrase] = []
    for index in range(len(reading.tokens)):
        elided = reading.word(index + 1) == "for" and reading.word(index) in ("another", "second", "further")
        one = reading.word(index) == "one" and reading.word(index - 1) in _FURTHER
        if not (elided or one) or index in reading.taken:
            continue
        begin = index - one
        told = one and reading.word(index - 1) in COMPARATIVES and reading.word(index - 2) == "the"
        begin -= told or reading.word(begin - 1) in ("a", "an")
        if reading.word(begin - 1) not in _JOINTS or reading.word(index + 1) in FLOOR_WORDS:
            continue
        before = _one_of_several(reading, phrases, begin) if told else _before(reading, phrases, begin)
        if before is None:
            continue
        last, user = _user(reading, index + 1)
        reading.take(begin, last)
        again = replace(
            before, first=begin, begin=begin, noun_end=last, last=last, count=1, counted=True, plural=False, areas=()
        )
        if told:
            size = reading.word(index - 1)
            label = f"{size} {singular(before.label)}"
            again = replace(again, head="room", building="")
            found.append(replace(again, name=f"{size}_{before.name}", label=label, counted=False, determiner="the"))
            continue
        head = before.name.rpartition("_")[2] if not user else _kind(before)
        label = reading.span(before.begin, before.noun_end).words
        named = replace(again, name=f"{user}_{head}"[:60], label=f"{label} for {user}s") if user else again
        found.append(replace(named, determiner="a"))
    return found


def _before(reading: Reading, phrases: list[Phrase], index: int) -> Phrase | None:
    """Return the room named last before a token in its sentence, if it is one room close by."""
    near = [
        p for p in phrases if p.last <= index and reading.sentence[p.first] == reading.sentence[index] and p.room_type
    ]
    last = max(near, key=lambda phrase: phrase.first, default=None)
    if last is None or reading.word(last.last) == "for":
        return None  # "an ablution room for men and another for women" is read with who uses it
    return last if index - last.last <= 8 and last.head == "room" else None


def _one_of_several(reading: Reading, phrases: list[Phrase], index: int) -> Phrase | None:
    """Return the rooms that "the larger one" is one of: the last ones of its sentence that are counted."""
    sentence = reading.sentence[index]
    return next(
        (
            phrase
            for phrase in sorted(phrases, key=lambda phrase: -phrase.first)
            if phrase.last <= index and reading.sentence[phrase.first] == sentence and phrase.room_type
            if phrase.head in ("room", "building") and phrase.counted and (phrase.count or 0) > 1
        ),
        None,
    )


def _kind(phrase: Phrase) -> str:
    """Return the name of a room without its user: "waiting_area" of "dog_waiting_area"."""
    words = phrase.label.lower().partition(" for ")[0].split()
    return "_".join(word for word in words if word.isalnum())


def _user(reading: Reading, index: int) -> tuple[int, str]:
    """Return where "just for cats" ends that begins at a token, and for what."""
    at = index + (reading.word(index) in ("just", "only", "solely", "reserved", "meant"))
    noun = at + 1 + (reading.word(at + 1) in ("the", "our"))
    named = reading.word(at) == "for" and reading.kind(noun) == "word" and reading.word(noun) not in FUNCTION_WORDS
    return (noun + 1, reading.word(noun)) if named else (index, "")


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
