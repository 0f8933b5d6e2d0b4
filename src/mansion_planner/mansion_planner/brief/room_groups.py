"""Read rooms told as a group, "a cell block of 20 cells", or named, "three game rooms (tomb, attic)", and desks."""

from dataclasses import replace

from mansion_planner.brief.facts import BriefFacts, ObjectFact
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["desks_as_places", "read_desk_areas", "rooms_by_name", "with_blocks", "without_announced"]

_GROUPS = frozenset({"block", "wing", "cluster"})
_LISTS = frozenset({"of", "with", "containing", "holding", "having", ":", "("})


def with_blocks(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return the phrases, those of blocks left out where their rooms are counted, else as several rooms.

    "Two cell blocks of ten cells each" are twenty cells, "a toilet block" is at least two toilets.
    """
    found: list[Phrase] = []
    blocks = 1
    for number, phrase in enumerate(phrases):
        if blocks > 1:
            found.append(replace(phrase, count=(phrase.count or 0) * blocks))
            reading.take(phrase.last, phrase.last + (reading.word(phrase.last) == "each"))
            blocks = 1
            continue
        group = phrase.last
        if phrase.head != "room" or reading.word(group) not in _GROUPS or reading.plural(phrase.noun_end - 1):
            found.append(phrase)
            continue
        reading.take(group, group + 1)
        later = phrases[number + 1 :]
        counted = [
            p for p in later if _counts_rooms_of(p, phrase) and reading.sentence[p.first] == reading.sentence[group]
        ]
        if counted:  # also of "one cell block with two levels: 15 cells per level"
            linked = reading.word(group + 1) in _LISTS and counted[0].first == group + 2 and phrase.counted
            blocks = (phrase.count or 1) if linked else 1
            continue
        found.append(replace(phrase, last=group + 1, count=None, counted=False, plural=True))
    return found


def _counts_rooms_of(phrase: Phrase, block: Phrase) -> bool:
    return phrase.head == "room" and phrase.counted and phrase.room_type == block.room_type


_PLACES = frozenset({"desk", "workstation", "workplace"})


def read_desk_areas(facts: BriefFacts) -> None:
    """Replace several rooms that are called desks by one area on each storey that is meant, and its desks."""
    for number, room in enumerate(facts.rooms):
        if room.name.rpartition("_")[2] not in _PLACES or room.count == 1:
            continue
        name = f"{room.name}_area"
        facts.rooms[number] = replace(room, name=name, label=f"{room.label} area", count=1, suite=())
        facts.objects.append(
            ObjectFact(
                words=room.span.words,
                category="desk",
                span=room.span,
                count=room.count,
                room=name,
                room_type=room.room_type,
                each=room.each,
                floors=room.floors,
                noun=room.label,
            )
        )


_ADJECTIVES = frozenset({"single", "one", "only", "big", "large", "small", "test"})
_PURPOSE = 8
"""Words between a room and the colon after which it is named, at most: "a room for testing a robot: a kitchen"."""


def without_announced(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return phrases without a room that is named right after it: "one single room: a kitchen" is a kitchen."""
    out = list(phrases)
    for number, phrase in enumerate(phrases[:-1]):
        named = phrases[number + 1]
        bare = phrase.first + (reading.word(phrase.first) in _ADJECTIVES)
        plain = reading.word(bare) == "room" and not phrase.plural
        if phrase.head != "room" or not plain or named.head != "room" or not named.known or named.plural:
            continue
        colon = next((at for at in range(phrase.last, phrase.last + _PURPOSE) if reading.word(at) == ":"), 0)
        between = range(phrase.last, colon)
        led = (
            colon
            and named.begin - colon <= _LED
            and not any(reading.breaks(at) or reading.word(at) == "," for at in between)
        )
        others = any(
            p.head == "room" and p is not named and reading.sentence[p.first] == reading.sentence[named.first]
            for p in phrases[number + 2 :]
        )
        if led and not others:
            out[number] = replace(phrase, head="unknown")
            reading.take(phrase.first - (reading.kind(phrase.first - 1) == "number"), colon)
    return out


_LED = 3
"""Tokens from the colon to the noun of the room that it leads to, at most."""


def rooms_by_name(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return phrases of which a number of rooms is replaced by as many that brackets after it name.

    Names that are all known rooms themselves are left: they say what the rooms are rather than what they are called.
    """
    out = list(phrases)
    for phrase in phrases:
        if phrase.head != "room" or not phrase.counted or (phrase.count or 0) < 2 or reading.word(phrase.last) != "(":
            continue
        entries, end = _entries(reading, phrase.last + 1)
        inner = [p for p in out if phrase.last < p.first < end]
        known = [p for p in inner if p.head == "room" and p.known and (p.begin, p.noun_end) in entries]
        if len(entries) != phrase.count or len(known) == len(entries):
            continue
        names = [
            replace(
                phrase,
                first=first,
                begin=first,
                noun_end=last,
                last=last,
                name="_".join(w.replace("'s", "").replace("'", "") for w in reading.words(first, last)),
                label=reading.span(first, last).words,
                count=1,
                plural=False,
                determiner="",
            )
            for first, last in entries
        ]
        at = out.index(phrase)
        out = [*out[:at], *names, *(p for p in out[at + 1 :] if p not in inner)]
        reading.take(phrase.first, phrase.last)
        for first, last in entries:
            reading.take(first, last)
    return out


def _entries(reading: Reading, first: int) -> tuple[list[tuple[int, int]], int]:
    """Return the parts of a list in brackets as tokens, and where it ends; nothing where it holds more than names."""
    entries: list[tuple[int, int]] = []
    start = index = first
    while index < len(reading.tokens) and index - first < 60:
        word = reading.word(index)
        if word in (",", ")", "and"):
            if index > start:
                entries.append((start, index))
            start = index + 1
            if word == ")":
                return (entries, index) if all(last - at <= 4 for at, last in entries) else ([], index)
        elif reading.kind(index) != "word":
            return [], index
        index += 1
    return [], index


_DESKS = frozenset({"desk", "counter"})
_BESIDE = (("next", "to"), ("beside",), ("adjacent", "to"), ("adjoining",), ("alongside",))


def desks_as_places(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return phrases of which a desk of a kind that is to be beside a room is a place of its own.

    "The custody desk next to the cells" has to have a wall in common with them.
    """
    out = list(phrases)
    for number, phrase in enumerate(phrases[:-1]):
        following = phrases[number + 1]
        beside = next((b for b in _BESIDE if reading.words(phrase.last, phrase.last + len(b)) == b), None)
        if (
            phrase.head == "object"
            and not phrase.plural
            and phrase.noun_end - phrase.begin > 1
            and reading.word(phrase.noun_end - 1) in _DESKS
            and beside is not None
            and following.head == "room"
            and following.begin - phrase.last - len(beside) <= 1
        ):
            name = "_".join(reading.words(phrase.begin, phrase.noun_end))
            out[number] = replace(phrase, head="room", category="", room_type="reception", name=name, known=False)
    return out
