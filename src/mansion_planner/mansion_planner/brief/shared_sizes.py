"""Read areas that are shared out over rooms named before: "two halls, one of 50 m2 and the other 35 m2"."""

from dataclasses import replace

from mansion_language.units import AREA
from mansion_planner.brief.area_words import Measure
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["with_shared_sizes"]

_ONE = frozenset(
    """
    other another second third fourth last first larger smaller largest smallest bigger biggest big small large one next
    """.split()
)
_LINKS = frozenset(
    {
        "them",
        "these",
        "those",
        "of",
        "with",
        "at",
        "is",
        "are",
        "has",
        "have",
        "about",
        "around",
        ":",
        "measure",
        "be",
        "should",
    }
)
_JOINTS = frozenset({",", "and", "&", ";", "plus"})
_LEADS = frozenset({",", "(", ":", "-", "–", "with"})


def with_shared_sizes(reading: Reading, measures: list[Measure], phrases: list[Phrase]) -> list[Phrase]:
    """Return the phrases with the areas that the entries of such lists give to one or some of their rooms.

    A list has as many rooms as the phrase that it follows; the areas read are added to `reading.named_areas`. A further
    entry without a noun, "one meeting room of 30 m2 and two of 15 m2 each", becomes a phrase of its own.
    """
    out = list(phrases)
    for number, phrase in enumerate(phrases):
        if phrase.head not in ("room", "building") or not phrase.room_type:
            continue
        areas = _shares(reading, measures, phrase)
        if areas:
            out[number] = replace(phrase, areas=areas)
    return _with_elided(reading, measures, out)


def _shares(reading: Reading, measures: list[Measure], phrase: Phrase) -> tuple[float, ...]:
    """Return the areas of rooms that a list shares out; none where it does not give one to each."""
    count = phrase.count or 0
    if not phrase.counted or not 2 <= count <= 40 or phrase.areas:
        return ()
    listed = _listed_areas(reading, measures, phrase)
    if len(listed) == count:
        reading.named_areas.update(listed)
        reading.take(phrase.last, listed[-1])
        return tuple(_area(reading, at) for at in listed)
    sentence = reading.sentence[phrase.first]
    starts = [
        index
        for index in range(phrase.last, min(phrase.last + 12, len(reading.tokens)))
        if reading.word(index) in _LEADS and reading.sentence[index] == sentence
    ]
    for start in starts:
        parts = reading.word(start + 1) == "of" and reading.word(start + 2) in ("which", "them", "these")
        entries, end = _entries(reading, measures, start + 1 + 2 * parts)
        if (len(entries) > 1 and sum(many for many, _ in entries) in (0, count)) or _fills(entries, count):
            return _settled(reading, entries, count, start, end)
    return ()


def _listed_areas(reading: Reading, measures: list[Measure], phrase: Phrase) -> list[int]:
    """Return the tokens of areas that follow rooms one after the other: "two halls, of 120 m2 and 80 m2"."""
    begins = {measure.first for measure in measures if len(measure.values) == 1}
    found: list[int] = []
    index = phrase.last
    while index < len(reading.tokens) and len(found) < 40:
        while reading.word(index) in _LINKS | _JOINTS | {"(", "one"} - {";"}:
            index += 1
        if index not in begins:
            break
        found.append(index)
        index += 2
    return found


def _fills(entries: list[tuple[int, int]], count: int) -> bool:
    """Whether "the rest" (0) takes the rooms that the other entries leave."""
    open_ended = sum(many == 0 for many, _ in entries)
    return len(entries) > 1 and open_ended == 1 and sum(many for many, _ in entries) < count


def _settled(reading: Reading, entries: list[tuple[int, int]], count: int, start: int, end: int) -> tuple[float, ...]:
    left = count - sum(many for many, _ in entries)
    areas: list[float] = []
    for many, at in entries:
        reading.named_areas.add(at)
        areas += [_area(reading, at)] * (many or left)
    reading.take(start + 1, end)
    return tuple(areas)


def _area(reading: Reading, index: int) -> float:
    unit = reading.word(index + 1)
    return reading.value(index) * AREA.get(unit, 1.0)


def _entries(reading: Reading, measures: list[Measure], index: int) -> tuple[list[tuple[int, int]], int]:
    """Return for each entry of a list its number of rooms (0: all others) and the token of its area; and the end."""
    begins = {measure.first for measure in measures if len(measure.values) == 1}
    entries: list[tuple[int, int]] = []
    end = index
    while index < len(reading.tokens) and len(entries) < 12:
        many, at = _how_many(reading, index)
        if many < 0:
            break
        while reading.word(at) in _LINKS:
            at += 1
        bare = reading.kind(at) == "number" and at not in reading.taken and reading.word(at + 1) in (*_JOINTS, "each")
        if at not in begins and not (bare and begins and reading.word(at - 1) in ("of", "one")):
            break
        entries.append((many, at))
        end = at + 1 + (reading.kind(at + 1) == "unit")
        end += reading.word(end) in ("each", "apiece")
        index = end
        while reading.word(index) in _JOINTS:
            index += 1
        if index == end:
            break
    return entries, end


def _how_many(reading: Reading, index: int) -> tuple[int, int]:
    """Return how many rooms an entry speaks of (0: the others, -1: it is no entry), and the token after its words."""
    value = reading.value(index)
    if reading.kind(index) == "number" and index not in reading.taken and 1 <= value <= 40 and value == int(value):
        return int(value), index + 1 + (reading.word(index + 1) in _ONE - {"one"})  # "one big with 40 m2"
    at = index + (reading.word(index) in ("the", "a", "an"))
    word = reading.word(at)
    left = reading.value(at + 1) if word in ("other", "remaining", "last") else 0.0
    if left and left == int(left) and reading.kind(at + 2) != "unit":
        return int(left), at + 2
    if word in ("other", "others", "rest", "remaining") and (reading.plural(at) or word != "other"):
        return 0, at + 1
    if reading.kind(at) == "ordinal" or word in _ONE:
        return 1, at + 1 + (reading.word(at + 1) == "one" and word != "one")
    return -1, index


def _with_elided(reading: Reading, measures: list[Measure], phrases: list[Phrase]) -> list[Phrase]:
    """Return the phrases, and one for each "and two of 15 m2 each" after a room whose area the brief gives so too."""
    out = list(phrases)
    for phrase in phrases:
        if phrase.head != "room" or not phrase.room_type or phrase.areas:
            continue
        at = phrase.last
        while reading.word(at) in _LINKS:
            at += 1
        if reading.kind(at) != "number" or at == phrase.last:
            continue
        joint = at + 1 + (reading.kind(at + 1) == "unit")
        joint += reading.word(joint) in ("each", "apiece")
        if reading.word(joint) not in _JOINTS:
            continue
        first = joint + 1 + (reading.word(joint + 1) in _JOINTS)
        entries, end = _entries(reading, measures, first)
        if not entries or any(many == 0 for many, _ in entries) or reading.kind(first) != "number":
            continue
        if at not in {measure.first for measure in measures}:
            if at in reading.taken or reading.kind(at + 1) == "unit":
                continue
            out[out.index(phrase)] = replace(phrase, areas=(reading.value(at),))
            reading.take(at, at + 1)
        for many, number in entries:
            reading.named_areas.add(number)
            extra = replace(phrase, first=first, begin=first, noun_end=first + 1, last=end, count=many, counted=True)
            out.append(replace(extra, areas=(_area(reading, number),), plural=many > 1, determiner=""))
        reading.take(first, end)
    return sorted(out, key=lambda phrase: phrase.first)
