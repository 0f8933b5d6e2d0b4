"""Read the own names of rooms: the party room "Typhoon", game rooms named Submarine and Moon Base."""

import re
from dataclasses import replace

from mansion_language import singular
from mansion_language.units import AREA
from mansion_planner.brief.lexicon import lexicon_of
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.room_users import one_of
from mansion_planner.brief.similarity import elliptic_room_type

__all__ = ["by_own_name", "with_own_names"]


def with_own_names(reading: Reading, phrase: Phrase) -> list[Phrase]:
    """Read the names that rooms are given: the party room "Typhoon"; private rooms called Sapporo, Kobe and Nagoya."""
    if phrase.head != "room":
        return [phrase]
    last = phrase.last
    listed = _listed_names(reading, phrase)
    if listed:
        return listed
    last = _calling(reading, last)
    called = reading.word(last) in ("called", "named") or (reading.word(last) == "(" and reading.word(last + 1) == '"')
    if reading.word(last) == '"' or (called and reading.word(last + 1) == '"'):
        begin = last + 1 + called
        end = next((i for i in range(begin, min(begin + 6, len(reading.tokens))) if reading.word(i) == '"'), begin)
        if end > begin:
            reading.take(last, end + 1)
            return [replace(_named(phrase, reading.span(begin, end).words), last=end + 1)]
    if not called:
        return [phrase]
    names = capitals(reading, last + 1)
    if not names:
        return [phrase]
    end = names[-1][1]
    reading.take(last, end)
    areas = _areas_between(reading, phrase.last, last) or _areas_of_all(reading, end, len(names))
    phrase = replace(phrase, areas=areas)
    named = [_named(phrase, reading.span(*name).words) for name in names]
    if len(names) == 1:
        return [replace(named[0], count=1, plural=False, last=end)]
    return [one_of(room, *name) for name, room in zip(names, named)]


def capitals(reading: Reading, index: int) -> list[tuple[int, int]]:
    """Return a list of names in capitals as pairs of tokens: "Pharaoh's Tomb, Submarine and Moon Base"."""
    names: list[tuple[int, int]] = []
    while reading.kind(index) in ("word", "number", "ordinal") and reading.tokens[index].capital:
        begin = index
        while index < len(reading.tokens) and reading.tokens[index].capital and index - begin < 4:
            index += 1
        names.append((begin, index))
        step = int(reading.word(index) in (",", "and")) + (reading.words(index, index + 2) == (",", "and"))
        if not step:
            break
        index += step
    return names


def _areas_of_all(reading: Reading, index: int, many: int) -> tuple[float, ...]:
    """Return the area after the names of several rooms: "Alder and Birch, each 30 m2", "A and B (20 m2 each)"."""
    at = index
    while reading.word(at) in (",", "(", "of", "with", "at", "about", "each", "all", "both", "measuring", "-"):
        at += 1
    said = {*reading.words(index, at), *reading.words(at + 2, at + 3)}
    if many < 2 or at - index > 4 or said.isdisjoint({"each", "all", "both", "apiece", "of"}):
        return ()
    return _areas_between(reading, at, at + 1)


def _calling(reading: Reading, last: int) -> int:
    """Return where rooms are named after their area: "6 classrooms of 25 m2 that are called Oslo and Lisbon"."""
    index = last
    while index - last < 9 and (
        reading.kind(index) in ("number", "unit")
        or reading.word(index) in ("of", "each", "that", "which", "are", "is", ",")
    ):
        index += 1
    return index if reading.word(index) in ("called", "named") else last


def _areas_between(reading: Reading, first: int, last: int) -> tuple[float, ...]:
    """Return the area that stands between rooms and their names."""
    for index in range(first, last):
        if reading.kind(index) == "number" and reading.word(index + 1) in AREA:
            reading.named_areas.add(index)
            return (reading.value(index) * AREA[reading.word(index + 1)],)
    return ()


def by_own_name(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return the phrases, with "classroom Oslo" read as the room that is called so."""
    own = {p.name: p for p in phrases if p.label.endswith(")")}
    found = []
    for phrase in phrases:
        named = own.get(reading.word(phrase.last)) if phrase.head in ("room", "building") else None
        if named is not None and named.room_type == phrase.room_type and reading.free(phrase.last, phrase.last + 1):
            reading.take(phrase.last, phrase.last + 1)
            phrase = replace(
                phrase, name=named.name, label=named.label, determiner="the", head="room", last=phrase.last + 1
            )
        found.append(phrase)
    return found + _spoken_of(reading, list(own.values()))


def _spoken_of(reading: Reading, named: list[Phrase]) -> list[Phrase]:
    """Return later mentions of rooms by their own names alone: "keep the workshop away from Submarine"."""
    found = []
    for phrase in named:
        words = reading.words(phrase.begin, phrase.noun_end)
        for index in range(phrase.last, len(reading.tokens) - len(words) + 1):
            end = index + len(words)
            if reading.words(index, end) != words or not reading.tokens[index].capital or not reading.free(index, end):
                continue
            reading.take(index, end)
            again = replace(phrase, first=index, begin=index, noun_end=end, last=end, determiner="the", areas=())
            found.append(replace(again, counted=False))
    return found


def _listed_names(reading: Reading, phrase: Phrase) -> list[Phrase]:
    """Read "three science labs (physics, chemistry, biology)": as many names as rooms."""
    last, count = phrase.last, phrase.count or 0
    while reading.word(last) in ("of", "each") or reading.kind(last) in ("number", "unit"):
        last += 1
    if reading.word(last) not in ("(", "-", ":", "–") or not phrase.counted or not 2 <= count <= 12:
        return []
    closers = (")",) if reading.word(last) == "(" else ("\n", ".", ";")
    items: list[tuple[int, int]] = []
    begin = index = last + 1
    while index < len(reading.tokens) and index - last < 40:
        ends = reading.word(index) in closers
        if ends or reading.word(index) in (",", "and"):
            if index > begin:
                items.append((begin, index))
            begin = index + 1
            if ends:
                break
        elif reading.kind(index) != "word" or (index in reading.taken and reading.word(last) == "("):
            return []
        elif index == begin and reading.word(index) in ("the", "a", "an"):
            begin += 1
        index += 1
    if len(items) != count or any(b - a > 3 for a, b in items):
        return []
    phrase = replace(phrase, areas=_areas_between(reading, phrase.last, last))
    reading.take(last, index + (reading.word(index) == ")"))
    found = []
    for a, b in items:
        own = reading.span(a, b).words
        name = "_".join(re.findall(r"[a-z0-9]+", own.lower().replace("'s", "").replace("’s", "")))
        room = one_of(phrase, a, b)
        kind = _kind_of_entry(reading, a, b) if phrase.name == "room" else ""
        if kind:  # "five rooms: kitchen, bath, ..."
            found.append(replace(room, name=name[:60], label=own, room_type=kind, known=True))
            continue
        label = f"{own} {singular(phrase.label.lower())}"
        found.append(replace(room, name=f"{name}_{phrase.name}"[:60], label=label))
    return found


def _kind_of_entry(reading: Reading, first: int, last: int) -> str:
    """Return the room type that an entry of a list of rooms names, in full or without its head; empty for none."""
    words = reading.words(first, last)
    whole = lexicon_of(reading.knowledge).phrases.get(words)
    named = whole.room if whole is not None else ""
    return named or elliptic_room_type(words, reading.knowledge)


def _named(phrase: Phrase, own: str) -> Phrase:
    """Return a phrase under its own name: the party room "Typhoon" is the "Typhoon (party room)"."""
    words = "_".join(re.findall(r"[a-z0-9]+", own.lower()))
    return replace(phrase, name=words or phrase.name, label=f"{own} ({singular(phrase.label.lower())})")
