"""Tell which room an area is of: the one right after it, or the one that it is said of."""

import itertools
from collections.abc import Sequence

from mansion_planner.brief.area_words import ABOUT, FILLERS, PLOT, TOTALS, Measure, is_of_each, lead_of, words_after
from mansion_planner.brief.phrase import BARE_BUILDINGS, Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.sizes import is_size

__all__ = ["is_building", "joined_alike", "room_of", "said_of_each"]

_HOLDS_ALL = frozenset({"in", "within", "on", "across"})
"""Words that put all that a sentence lists into one area: "a kitchen, a bedroom and a bathroom in 87 m2"."""
_STOREYS = frozenset({"upstairs", "upstair", "downstairs", "downstair"})
"""Storeys between a room and the area in brackets behind it."""
_SURFACE = frozenset({"surface", "occupy", "occupies", "take", "takes", "cover", "covers"})
"""Words between a room and its area: "the hall has a surface of 95 m2"."""


def joined_alike(reading: Reading, measure: Measure, phrases: list[Phrase], target: int) -> list[int]:
    """Return the rooms of a kind that share an area with the last of them: "Lab A and Lab B, 40 m2 each"."""
    found: list[int] = []
    while target > 0 and is_of_each(reading, measure):
        one, other = phrases[target - 1], phrases[target]
        joints = set(reading.words(one.last, other.begin))
        alike = one.room_type == other.room_type and joints <= {"and", ",", "the"}
        joined = one.head == "room" and one.name != other.name and (alike or joints <= {"and", "a", "an"})
        if not (joined and joints) or one.areas or one.count != 1 or other.count != 1:
            break
        target -= 1
        found.append(target)
    return found


def room_of(reading: Reading, measure: Measure, phrases: list[Phrase]) -> int | None:
    """Return which phrase an area belongs to: the room right after it, or the one that it is said of."""
    after = words_after(reading, measure, 4)
    if _is_of_all(reading, measure, phrases, after):
        return None
    following = _room_after(reading, measure, phrases)
    if following is not None:
        return following
    per_storey = any(word in ("per", "a", "/") and nxt in FLOOR_WORDS for word, nxt in itertools.pairwise(after))
    if per_storey and after[:1] != ["each"] and not _of_counted(reading, measure, phrases):
        return None
    end, comma = _end_of_what_is_measured(reading, measure, phrases)
    if {"total", "area"} <= set(reading.words(end - 1, measure.first)):
        return None
    candidates = (
        _ending_at(phrases, end)
        or _described(reading, measure, phrases)
        or _placed(reading, measure, phrases)
        or _bracketed(reading, measure, phrases)
        or _with_complement(reading, measure, phrases)
        or _shared_out(reading, measure, phrases)
    )
    if not candidates:
        return None
    phrase = phrases[candidates[-1]]
    if is_building(reading, phrase) or (phrase.areas and len(measure.values) == 1):
        return None
    if after[:2] == ["on", "each"] and not after[2:] and _fills_storeys(reading, phrase):
        return None  # "three floors of offices with 450 m2 on each"
    if comma and phrase.last == end and not _listed(reading, measure, phrase, after):
        return None
    return candidates[-1]


def _fills_storeys(reading: Reading, phrase: Phrase) -> bool:
    """Whether rooms are what storeys are of: "two floors of offices"."""
    return reading.word(phrase.begin - 1) == "of" and reading.word(phrase.begin - 2) in FLOOR_WORDS


def _is_of_all(reading: Reading, measure: Measure, phrases: list[Phrase], after: list[str]) -> bool:
    """Whether an area is a total, that of all rooms of a list, or a plot's."""
    total = not TOTALS.isdisjoint(after[:3]) and not _is_of_one(reading, measure, phrases)
    if "each" not in after and (total or _of_all_listed(reading, measure, phrases)):
        return True
    before = reading.words(max(measure.first - 6, 0), measure.first)
    return measure.sides and not (PLOT | {"footprint"}).isdisjoint(before)


def _is_of_one(reading: Reading, measure: Measure, phrases: list[Phrase]) -> bool:
    """Whether a total is too small for as many rooms, so that it is of each: "twelve cells of 10 m2 in all"."""
    end, _ = _end_of_what_is_measured(reading, measure, phrases)
    counts = [phrases[n].count or 1 for n in _ending_at(phrases, end) if phrases[n].head == "room"]
    return bool(counts) and counts[-1] > 1 and measure.values[0] < _LEAST_ROOM * counts[-1]


_LEAST_ROOM = 2.0
"""Square metres below which no room is; a total that is less for each room is the area of one."""


def _room_after(reading: Reading, measure: Measure, phrases: list[Phrase]) -> int | None:
    """Return the room without an area yet that is named right after an area: "20 m2 kitchen", "20 m2 of office"."""
    for number, phrase in enumerate(phrases):
        if phrase.head != "room" or not 0 <= phrase.first - measure.last <= 2:
            continue
        gap = reading.words(measure.last, phrase.first)
        joined = not gap or (gap[0] == "of" and set(gap) <= {"of", "for", "-", "each"})
        if joined and not phrase.areas and not is_building(reading, phrase):
            return number
    return None


def _says_size(reading: Reading, index: int) -> bool:
    """Whether a word only says before an area how large a room is: "the kitchen is big, 25 m2"."""
    return is_size(reading.word(index)) and reading.word(index - 1) in ("is", "are", "be")


def _end_of_what_is_measured(reading: Reading, measure: Measure, phrases: list[Phrase]) -> tuple[int, bool]:
    """Return the token after the words that an area is said of, and whether a comma stands between the two."""
    before, comma = measure.first - 1, False
    ends = {phrase.last for phrase in phrases}
    while (
        before >= 0
        and before + 1 not in ends
        and not (reading.word(before) in FLOOR_WORDS and reading.kind(before - 1) == "number")
        and (
            reading.word(before) in FILLERS | _SURFACE
            or (reading.word(before) in _STOREYS and reading.word(before + 1) == "(")
            or (reading.word(before) == "," and not comma)
            or (reading.word(before) == "." and not reading.breaks(before))
            or _says_size(reading, before)
            or (reading.word(before) in ("can", "could", "may") and reading.word(before + 1) == "be")
        )
    ):
        comma = (comma or reading.word(before) == ",") and not _says_size(reading, before)
        before -= 1
    before += reading.word(before) == "per" and reading.word(before + 1) in FLOOR_WORDS
    if reading.word(before) in FLOOR_WORDS and reading.word(before - 1) in ("per", "by", "each", "every"):
        at = before - 1 - (reading.word(before - 2) in ("on", "in", "at"))
        if at in ends:
            return at, comma  # "6 classrooms per level, of 55 m2 each"
    return before + 1, comma


def _shared_out(reading: Reading, measure: Measure, phrases: list[Phrase]) -> list[int]:
    """Return the rooms of "three galleries, one on each of its storeys and each 110 m2", whose number stands before."""
    at = measure.first - 1
    while reading.word(at) in FILLERS - FLOOR_WORDS - {"each"}:
        at -= 1
    if reading.word(at) != "each" or reading.word(at - 1) not in ("and", ","):
        return []
    at -= 1
    while reading.word(at) in _ON_STOREYS or reading.word(at) in FLOOR_WORDS or reading.kind(at) == "number":
        at -= 1
    apiece = reading.kind(at + 2) == "number" and reading.word(at + 1) == "," and reading.word(at + 3) in ("on", "per")
    return [n for n in _ending_at(phrases, at + 1) if apiece and phrases[n].plural]


_ON_STOREYS = frozenset("on each every of its the our per and ,".split())
"""Words of "one on each of its three storeys", which shares rooms out."""


def _ending_at(phrases: list[Phrase], end: int) -> list[int]:
    """Return the rooms and buildings whose phrases, or the nouns of these, end at a token."""
    return [
        n
        for n, p in enumerate(phrases)
        if p.noun_end <= end <= p.last and (p.head == "building" or (p.head == "room" and p.room_type))
    ]


def _with_complement(reading: Reading, measure: Measure, phrases: list[Phrase]) -> list[int]:
    """Return the rooms of which more is said before their area: "the bay for three engines (180 m2)"."""
    if reading.word(lead_of(reading, measure)) not in ("(", "of"):
        return []
    sentence = reading.sentence[measure.first]
    return [
        n
        for n, p in enumerate(phrases)
        if p.head == "room"
        and 0 <= measure.first - p.last <= 7
        and reading.sentence[p.first] == sentence
        and reading.word(p.last) in ("for", "of", "with")
    ]


def _bracketed(reading: Reading, measure: Measure, phrases: list[Phrase]) -> list[int]:
    """Return the rooms that brackets describe: "18 apartments per floor (1 bed, 40 m2)"."""
    opening = measure.first - 1
    while opening > measure.first - 8 and reading.word(opening) not in ("(", ")") and not reading.breaks(opening):
        opening -= 1
    if reading.word(opening) != "(" or reading.word(measure.last) not in (")", ","):
        return []
    if "one" in reading.words(opening + 1, measure.first):
        return []  # "two courtrooms (one large 120 m2, one small 60 m2)"
    last = opening
    if reading.word(last - 1) in FLOOR_WORDS and reading.word(last - 2) in ("per", "each", "every", "a"):
        last -= 2 + (reading.word(last - 3) in ("on", "in", "at"))
    named = [n for n, p in enumerate(phrases) if p.last == last and p.head in ("room", "building")]
    return [n for n in named if phrases[n].counted and (phrases[n].count or 0) > 1 and phrases[n].room_type]


def _of_counted(reading: Reading, measure: Measure, phrases: list[Phrase]) -> bool:
    """Whether an area is that of each of several rooms: "six apartments of 70 m2 per floor"."""
    lead = lead_of(reading, measure)
    return reading.word(lead) == "of" and any(
        phrase.last == lead and phrase.counted and (phrase.count or 0) > 1 and phrase.room_type for phrase in phrases
    )


def _of_all_listed(reading: Reading, measure: Measure, phrases: list[Phrase]) -> bool:
    """Whether an area is that of all rooms which the sentence lists before it."""
    lead = lead_of(reading, measure)
    if reading.word(lead) not in _HOLDS_ALL:
        return False
    sentence = reading.sentence[measure.first]
    listed = [p for p in phrases if p.head == "room" and reading.sentence[p.first] == sentence and p.first < lead]
    return len(listed) > 1 and listed[-1].noun_end == lead and not any(p.areas for p in listed)


def said_of_each(reading: Reading, measure: Measure, phrases: list[Phrase]) -> tuple[int, int] | None:
    """Read "three courtrooms, 110 m2 a courtroom" and "200 m2 each hall"; return who is named again, and the room."""
    last = measure.last + (reading.word(measure.last) == "." and not reading.breaks(measure.last))
    if reading.word(last) not in ("a", "an", "per", "each", "every", "/"):
        return None
    number = next((n for n, p in enumerate(phrases) if p.begin == last + 1 and p.head in ("room", "building")), None)
    if number is None or phrases[number].counted or phrases[number].plural:
        return None
    name = phrases[number].name
    before = [
        n
        for n, p in enumerate(phrases[:number])
        if p.head == "room"
        and not p.areas
        and (p.name == name or p.name.endswith(f"_{name}"))
        and reading.sentence[measure.first] - reading.sentence[p.first] <= 1
    ]
    return (number, before[-1]) if before else None


_BESIDE_PLACE = (("at", "the"), ("on", "the"), ("in", "the"), ("by", "the"), ("to", "the"))
"""Words of where rooms are, before a comma and the area of each: "two shops at the front, 60 m2 each"."""


def _described(reading: Reading, measure: Measure, phrases: list[Phrase]) -> list[int]:
    """Return the room that is described before its area: "a hall for men, 180 m2", "a loft above of 15 m2"."""
    sentence = reading.sentence[measure.first]
    before = [n for n, p in enumerate(phrases) if p.last <= measure.first and reading.sentence[p.first] == sentence]
    rooms = [
        n
        for n in before
        if phrases[n].head in ("room", "building")
        and phrases[n].room_type
        and phrases[n].name != "room"
        and not is_building(reading, phrases[n])
    ]
    if not rooms or phrases[rooms[-1]].areas:
        return []
    gap = reading.words(phrases[rooms[-1]].last, measure.first)
    people = len(gap) >= 3 and gap[0] == "for" and gap[-1] == "," and len(gap) <= 5
    above = gap[:1] in (("above",), ("below",), ("upstairs",), ("downstairs",)) and set(gap[1:]) <= FILLERS
    above = above or (gap[:2] in _BESIDE_PLACE and gap[-1] == "," and len(gap) <= 4 and is_of_each(reading, measure))
    relative = gap[:2] == (",", "which") and gap[-1] == "," and "room" in gap and ";" not in gap
    return rooms[-1:] if people or above or relative or _is_clause_of_room(gap) else []


def _placed(reading: Reading, measure: Measure, phrases: list[Phrase]) -> list[int]:
    """Return the room whose storey stands between it and its area: "a gallery on the upper floor 80 m2"."""
    at = measure.first - 1
    while reading.word(at) in ABOUT | {"("}:
        at -= 1
    if reading.word(at) not in FLOOR_WORDS or at not in reading.taken or reading.plural(at):
        return []
    at -= 1 + (reading.word(at - 2) == "the")
    if reading.word(at - 1) not in ("on", "in", "at"):
        return []
    return [
        n for n, p in enumerate(phrases)
        if p.last == at - 1 and p.head == "room" and p.count == 1 and not p.plural and not p.areas
    ]  # fmt: skip


def _is_clause_of_room(gap: Sequence[str]) -> bool:
    """Whether only a relative clause stands between a room and its area: "the kitchen where we eat, 25 m2"."""
    words = list(gap)
    while words and words[-1] in ABOUT:
        words.pop()
    return 3 <= len(words) <= 9 and words[0] in ("where", "that", "who") and words[-1] == "," and words.count(",") == 1


def is_building(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase names the whole building: by its kind, or as "the building"."""
    if not phrase.known and phrase.name in BARE_BUILDINGS:
        return True
    return any(
        span.start == reading.tokens[phrase.begin].start
        or span.start <= reading.tokens[phrase.noun_end - 1].start < span.end
        for _, span in reading.facts.building
    )


def _listed(reading: Reading, measure: Measure, phrase: Phrase, after: list[str]) -> bool:
    """Whether a comma joins an area to the room before it: "rooms, 15 m2 each", "hall, 320 m2 |", an item of a list."""
    if is_of_each(reading, measure):
        return True
    gap = reading.words(phrase.last, measure.first)
    alike = not {"alike", "same", "equal", "identical", "namely"}.isdisjoint(gap)
    if len(measure.values) > 1 or alike or not {("all", "of"), ("all", "at")}.isdisjoint(itertools.pairwise(gap)):
        return True
    alone = reading.word(measure.last) in ("|", "\n", "", ")", ";")
    if reading.sentence[measure.first] > 0 and reading.word(phrase.last) == ",":
        return True
    return alone and (reading.starts(phrase.first) or reading.word(phrase.first - 1) == "|")
