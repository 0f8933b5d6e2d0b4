"""Read counts that stand away from the rooms they count: "six of them", "four on the third", "each group has"."""

import itertools
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from mansion_planner.brief.facts import FloorRef, Quantity, Span
from mansion_planner.brief.phrase import Phrase, is_whole_count, tells_some
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading
from mansion_planner.brief.storey_attachment import Attachment
from mansion_planner.brief.suites import SLEEPING, read_suites
from mansion_planner.brief.units import Households

__all__ = [
    "read_counts_by_group",
    "read_counts_by_person",
    "read_counts_by_room",
    "read_counts_by_storey",
    "read_halves",
    "read_late_counts",
    "without_totals",
]


def read_late_counts(reading: Reading, phrases: list[Phrase]) -> None:
    """Read counts away from their noun: "offices of 14 m2 each, six of them", "four bedrooms, no sorry, five"."""
    for index, token in enumerate(reading.tokens):
        if token.kind != "number" or index in reading.taken or not is_whole_count(token.value):
            continue
        following = _of_which(reading, phrases, index)
        if following is not None:
            phrases[following] = replace(phrases[following], count=int(token.value), counted=True)
            reading.take(index, index + 1)
            continue
        if _counts_list(reading, phrases, index):
            continue
        apiece = reading.word(index - 1) == "(" and reading.words(index + 1, index + 3) in (
            ("each", ")"),
            ("apiece", ")"),
        )
        if apiece and _count_apiece(reading, phrases, index):
            continue
        if _counts_on_each(reading, phrases, index):
            continue
        of_them = reading.words(index + 1, index + 3) == ("of", "them") and not tells_some(reading, index)
        corrects = not {"sorry", "mean", "correction"}.isdisjoint(reading.words(index - 3, index))
        if not of_them and not corrects:
            continue
        before = [n for n, p in enumerate(phrases) if p.last <= index and p.head in ("room", "building", "object")]
        several = bool(before) and (phrases[before[-1]].plural or phrases[before[-1]].determiner in ("every", "each"))
        if several and phrases[before[-1]].counted == corrects:
            phrases[before[-1]] = replace(phrases[before[-1]], count=int(token.value), counted=True)
            reading.take(index, index + (3 if of_them else 1))


def _counts_list(reading: Reading, phrases: list[Phrase], index: int) -> bool:
    """Read "server halls, 2 each", "offices on the mezzanine (5)" and "cells in the basement, 6." as so many rooms.

    Returns whether it was so.
    """
    before = [n for n, p in enumerate(phrases) if p.last <= index and p.head != "unknown"]
    room = phrases[before[-1]] if before else None
    if room is None or room.head not in ("room", "building") or room.counted or not (room.plural and room.room_type):
        return False
    if reading.sentence[room.first] != reading.sentence[index]:
        return False
    bracketed = reading.word(index - 1) == "(" and reading.word(index + 1) == ")" and index - room.last <= _NEAR
    each = reading.word(index - 1) == "," and reading.word(index + 1) == "each" and room.last == index - 1
    each = each and (reading.breaks(index + 2) or reading.word(index + 2) == ",")
    behind = reading.word(index - 1) == "," and reading.breaks(index + 1) and 1 < index - room.last <= _NEAR
    if not (bracketed or each or behind):
        return False
    phrases[before[-1]] = replace(room, count=int(reading.value(index)), counted=True)
    reading.take(index, index + 1 + each)
    return True


def _counts_on_each(reading: Reading, phrases: list[Phrase], index: int) -> bool:
    """Read "WC on each floor, at least two" as so many on each; whether it was so."""
    least = reading.words(index - 3, index) == (",", "at", "least")
    closed = reading.breaks(index + 1) or reading.word(index + 1) in (",", ")")
    before = [n for n, p in enumerate(phrases) if p.last <= index and p.head == "room"]
    if not ((least or reading.word(index - 1) == ",") and closed and before):
        return False
    room = phrases[before[-1]]
    between = reading.words(room.last, index)
    every = {"each", "every", "per"} & set(between) and FLOOR_WORDS & set(between)
    if room.counted or not every or len(between) > _NEAR or reading.sentence[room.first] != reading.sentence[index]:
        return False
    phrases[before[-1]] = replace(room, count=int(reading.value(index)), counted=True)
    reading.take(index - 2 * least, index + 1)
    return True


_NEAR = 6
"""Tokens between rooms and their number in a bracket behind their storey, at most."""


def read_counts_by_room(reading: Reading, phrases: list[Phrase]) -> None:
    """Read "three screens and a projection room for each screen" as three projection rooms."""
    for number, (phrase, of_each) in enumerate(itertools.pairwise(list(phrases))):
        lead = reading.words(phrase.last, of_each.begin)
        single = phrase.head == "room" and phrase.count == 1 and not phrase.plural and phrase.determiner != "the"
        counted = _counted_alike(reading, phrases[:number], of_each) if single else []
        beside = not _BESIDE.isdisjoint(lead) and of_each.determiner in ("each", "every") and len(lead) < 5
        earlier = [n for n, p in enumerate(phrases[:number]) if p.name == phrase.name and p.plural and not p.counted]
        if single and beside and len(counted) == 1 and earlier:
            phrases[earlier[-1]] = replace(phrases[earlier[-1]], count=counted[0].count, counted=True)
            phrases[number] = replace(phrase, counted=False, determiner="each")
            continue
        if (
            single
            and beside
            and len(counted) == 1
            and phrase.determiner in ("a", "an", "one", "")
            and of_each.head == "room"
        ):
            phrases[number] = replace(phrase, count=counted[0].count, counted=True)
            continue
        if not single or of_each.head != "room" or lead not in (("for", "each"), ("for", "every"), ("per",)):
            continue
        if len(counted) == 1:
            phrases[number] = replace(phrase, count=counted[0].count, counted=True)


def _counted_alike(reading: Reading, phrases: Sequence[Phrase], room: Phrase) -> list[Phrase]:
    """Return the counted rooms that "each courtroom" means: those of its name, or "smaller courtrooms" near it."""
    several = [p for p in phrases if p.counted and (p.count or 0) > 1]
    named = [p for p in several if p.name == room.name]
    sentence = reading.sentence[room.first]
    near = [
        p for p in several
        if p.name.endswith(f"_{room.name}") and p.room_type == room.room_type and reading.sentence[p.first] == sentence
    ]  # fmt: skip
    return named or near


_BESIDE = frozenset({"touching", "next", "beside", "adjoining", "adjacent", "attached", "behind", "by", "bordering"})


def _count_apiece(reading: Reading, phrases: list[Phrase], index: int) -> bool:
    """Read "wet labs on the odd storeys (three each)"; whether it was so."""
    sentence = reading.sentence[index]
    before = [n for n, p in enumerate(phrases) if p.last <= index and reading.sentence[p.first] == sentence]
    if (
        not before
        or phrases[before[-1]].head != "room"
        or phrases[before[-1]].counted
        or not phrases[before[-1]].plural
    ):
        return False
    phrases[before[-1]] = replace(phrases[before[-1]], count=int(reading.value(index)), counted=True)
    reading.take(index, index + 1)
    return True


def _of_which(reading: Reading, phrases: list[Phrase], index: int) -> int | None:
    """Return the rooms that some of those named before have one of each: "three of which have a bathroom"."""
    if reading.words(index + 1, index + 3) == ("of", "the"):
        return _of_the(reading, phrases, index)
    if reading.word(index + 1) != "of" or reading.word(index + 2) not in ("which", "them", "these", "those"):
        return None
    if reading.word(index + 3) not in ("have", "has", "with", "having", "get", "need"):
        return None
    after = next((n for n, p in enumerate(phrases) if p.first >= index + 4), None)
    if after is None or phrases[after].head != "room" or phrases[after].counted or phrases[after].begin > index + 6:
        return None
    return after


def _of_the(reading: Reading, phrases: list[Phrase], index: int) -> int | None:
    """Return what some rooms have that are named with the number: "two of the three bedrooms have a bathroom"."""
    owner = next((n for n, p in enumerate(phrases) if p.first >= index + 3), len(phrases))
    if owner + 1 >= len(phrases) or phrases[owner].first > index + 3 or phrases[owner].head != "room":
        return None
    had = phrases[owner + 1]
    gap = reading.words(phrases[owner].last, had.begin)
    has = len(gap) < 4 and set(gap) <= {"with", "have", "has", "having", "a", "an", "their", "own"}
    return owner + 1 if has and had.head == "room" and not had.counted else None


def read_counts_by_storey(
    reading: Reading, phrases: list[Phrase], places: Sequence[Place], households: Households
) -> set[int]:
    """Read "five on the second floor, four on the third" and "four per floor" as of the rooms named before.

    Returns
    -------
    set of int
        First tokens of the phrases whose number is shared out over storeys.
    """
    starts = {place.first: place for place in places}
    shared: set[int] = set()
    parts: list[tuple[int, Phrase]] = []
    among: set[int] = set()
    for index, token in enumerate(reading.tokens):
        if token.kind != "number" or index in reading.taken or not is_whole_count(token.value):
            continue
        if reading.word(index - 1) in _LEFT_OVER and index - 1 not in reading.taken:
            reading.take(index - 1 - (reading.word(index - 2) == "the"), index)
        last = _end_of_count(reading, index)
        number = _counted_before(reading, phrases, households, index) if last in starts else None
        if number is None:
            continue
        total, many = phrases[number], int(token.value)
        reading.take(index, last)
        if starts[last].refs[0].kind == "every" and total.plural and not total.counted and total.head == "room":
            phrases[number] = replace(total, count=many, counted=True)  # "classrooms on all floors, five on each"
            continue
        if starts[last].refs[0].kind == "every":
            shared.add(total.first)
            _state_storeys(reading, total, many, reading.span(index, starts[last].last))
            continue
        if reading.words(index - 2, index) == _OF_WHICH or reading.words(last - 2, last) in _OF_THEM:
            among.add(number)
        part = replace(total, first=index, begin=index, noun_end=index + 1, last=last)
        parts.append((number, replace(part, count=many, counted=True, determiner="")))
    _leave_out_what_is_shared_out(phrases, parts, among)
    phrases[:] = sorted([*phrases, *(p for _, p in parts)], key=lambda p: p.first)
    return shared


def _end_of_count(reading: Reading, index: int) -> int:
    """Return the token after a number and "of them" or "more"."""
    last = index + 1
    if reading.words(last, last + 2) in _OF_THEM:
        last += 2
    return last + (reading.word(last) in ("more", "other", "others", "further"))


def _counted_before(reading: Reading, phrases: list[Phrase], households: Households, index: int) -> int | None:
    """Return which rooms or units of its sentence a number without a noun counts, if it opens a clause."""
    before = [
        n
        for n, p in enumerate(phrases)
        if p.last <= index
        and (p.head == "room" or p.first in households.units or (p.room_type and p.plural and p.counted))
        and reading.sentence[p.first] == reading.sentence[index]
        and p.first not in households.inner
    ]
    lead = index - 1
    while lead in reading.taken and reading.word(lead) in ("the", *_LEFT_OVER):
        lead -= 1
    opens = reading.word(lead) in (",", ":", "and", "-", "(", "–", ";") or reading.words(lead - 1, index) == _OF_WHICH
    things = [p for p in phrases if p.last <= index and p.head in ("object", "people") and p.counted]
    others = before and any(p.first > phrases[before[-1]].first for p in things)  # "60 seats here and 20 upstairs"
    return before[-1] if before and opens and not others else None


def _state_storeys(reading: Reading, total: Phrase, many: int, span: Span) -> None:
    """State how many storeys "6 flats, two per floor" takes, where the brief does not say so itself."""
    if not reading.facts.floors and total.counted and total.count and many and total.count % many == 0:
        reading.facts.floors.append(Quantity(float(total.count // many), span))


def _leave_out_what_is_shared_out(
    phrases: list[Phrase], parts: Sequence[tuple[int, Phrase]], among: Collection[int]
) -> None:
    """Leave out the phrases whose rooms the numbers after them (`parts`, by the phrase's number) count again.

    Of those in `among` the numbers count some: "five bedrooms, one of them downstairs" leave four elsewhere.
    """
    for number in {n for n, _ in parts}:
        total = phrases[number]
        counts = [p.count or 0 for n, p in parts if n == number]
        whole = total.counted and sum(counts) >= (total.count or 0) and len(counts) > 1
        left = (total.count or 0) - sum(counts)
        if whole or (not total.counted and total.plural):
            phrases[number] = replace(total, head="unknown")
        elif number in among and total.counted and total.room_type and left > 0:
            phrases[number] = replace(total, count=left)


_OF_WHICH = ("of", "which")
_OF_THEM = (("of", "them"), ("of", "these"), ("of", "those"), _OF_WHICH)

_LEFT_OVER = frozenset({"remaining", "other", "last", "further"})
"""Words before the number of the rooms that are left: "and the remaining three on level 4"."""


def read_halves(
    reading: Reading, phrases: list[Phrase], places: Sequence[Place], attached: dict[int, Attachment]
) -> None:
    """Read "twelve classrooms, half of them on either storey" and "half upstairs, half downstairs"."""
    _read_even_shares(reading, phrases, attached)
    index = 0
    while index < len(reading.tokens):
        if reading.word(index) not in ("half", "halves") or index in reading.taken:
            index += 1
            continue
        sentence = reading.sentence[index]
        rooms = [
            n
            for n, p in enumerate(phrases)
            if p.last <= index and p.room_type and p.counted and reading.sentence[p.first] == sentence
        ]
        named = [p for p in places if index < p.first and reading.sentence[p.first] == sentence][:2]
        count = phrases[rooms[-1]].count or 0 if rooms else 0
        index += 1
        if not rooms or not named or count % 2 or named[0].first - index > 4:
            continue
        refs = named[0].refs
        both = refs[0].kind == "every" or len(refs) == 2
        if not both:
            halves = [at for at in range(named[0].last, named[-1].first) if _is_other_half(reading, at)]
            if len(named) < 2 or not halves:
                continue
            refs = (*refs, *named[1].refs)
        attached[rooms[-1]] = Attachment(refs, each=True)
        phrases[rooms[-1]] = replace(phrases[rooms[-1]], count=count // 2)
        reading.take(index - 1, (named[0] if both else named[1]).first)


def _read_even_shares(reading: Reading, phrases: list[Phrase], attached: dict[int, Attachment]) -> None:
    """Read "12 classrooms split evenly over the floors" as so many on each storey."""
    storeys = int(reading.facts.floors[0].value) if reading.facts.floors else 0
    for index in range(len(reading.tokens)):
        if reading.word(index) not in _EVENLY or index in reading.taken or storeys < 2:
            continue
        last = index + 1
        while reading.word(last) in _OVER_ALL or (reading.kind(last) == "number" and reading.value(last) == storeys):
            last += 1
        rooms = [n for n, p in enumerate(phrases) if p.last <= index and p.room_type and p.counted]
        room = phrases[rooms[-1]] if rooms else None
        if reading.word(last) not in FLOOR_WORDS or room is None or index - room.last > _NEAR:
            continue
        count = room.count or 0
        if count % storeys or reading.sentence[room.first] != reading.sentence[index]:
            continue
        span = reading.span(index, last + 1)
        attached[rooms[-1]] = Attachment((FloorRef("every", span=span),), each=True)
        phrases[rooms[-1]] = replace(room, count=count // storeys)
        reading.take(room.last, last + 1)


_EVENLY = frozenset({"evenly", "equally"})
_OVER_ALL = frozenset(
    {"over", "across", "between", "among", "on", "the", "both", "all", "divided", "split", "shared", "spread", "its"}
)
"""Words between "evenly" and the storeys over which rooms are shared out."""


def _is_other_half(reading: Reading, index: int) -> bool:
    """Whether a token says what the other of two halves is."""
    return reading.word(index) in ("half", "other", "rest", "others")


def without_totals(
    reading: Reading, phrases: list[Phrase], attached: Mapping[int, Attachment], rooms: Sequence[int]
) -> None:
    """Leave out totals that phrases of the same name share out: "48 rooms, twelve rooms on each of floors 2 to 5"."""
    floors = int(reading.facts.floors[0].value) if reading.facts.floors else 0
    for position, number in enumerate(rooms):
        total = phrases[number]
        _leave_code(reading, phrases, number, rooms[position + 1 :])
        if not total.counted or (total.count or 0) < 2 or number in attached:
            continue
        sentence = reading.sentence[total.first]
        parts = [n for n in rooms[position + 1 :] if reading.sentence[phrases[n].first] == sentence]
        placed = [n for n in parts if phrases[n].name == total.name and phrases[n].counted and n in attached]
        end = _bracket_end(reading, total.last)
        within = enumerate(phrases) if end > total.last else ()
        named = [n for n, p in within if total.last < p.first < end and p.name.startswith(f"{total.name}_")]
        shared = sum((phrases[n].count or 0) * _storeys(attached[n], floors) for n in placed)
        bracketed = len(named) == total.count
        if placed and shared == total.count:
            named = []
        elif not bracketed:
            continue
        for n in named:
            phrases[n] = replace(phrases[n], areas=phrases[n].areas or total.areas)
        phrases[number] = replace(total, head="unknown")


def _leave_code(reading: Reading, phrases: list[Phrase], number: int, rooms: Sequence[int]) -> None:
    """Leave out the bedrooms of "4LDK" where the brief names the rooms to sleep in; a rest of them is told."""
    code = phrases[number]
    if not _CODES.search(reading.span(code.first, code.last).words.lower()):
        return
    named = [phrases[n] for n in rooms if phrases[n].room_type in SLEEPING or phrases[n].name == "tatami_room"]
    if not named:
        return
    phrases[number] = replace(code, head="unknown")
    if sum(phrase.count or 2 for phrase in named) != code.count:
        reading.taken.difference_update(range(code.first, code.last))


_CODES = re.compile(r"\d\s*(ldk|bhk)$")
"""Short forms of flats by their number of bedrooms."""


def _bracket_end(reading: Reading, index: int) -> int:
    """Return where the bracket ends that opens at a token; the token itself where none does."""
    if reading.word(index) != "(":
        return index
    return next((at for at in range(index, min(index + 40, len(reading.tokens))) if reading.word(at) == ")"), index)


def _storeys(place: Attachment, floors: int) -> int:
    """Return for how many storeys the number of a phrase holds."""
    if not place.each:
        return 1
    ranged = [ref for ref in place.refs if ref.kind in ("number", "range")]
    if len(ranged) < len(place.refs):
        return floors if place.refs[0].kind == "every" else 0
    return sum(ref.last - ref.first + 1 for ref in ranged)


def read_counts_by_group(reading: Reading, phrases: list[Phrase], households: Households) -> None:
    """Read "Each group has a playroom" as one for every group, where the brief has a number of groups."""
    counts: dict[str, int] = {}
    for index, token in enumerate(reading.tokens[:-1]):
        if token.kind == "number" and token.value == int(token.value) and 1 < token.value <= 60:
            for noun in (index + 1, index + 2):
                if reading.plural(noun) and reading.word(noun) not in FLOOR_WORDS:
                    counts.setdefault(reading.word(noun), int(token.value))
    for index, token in enumerate(reading.tokens[:-1]):
        if token.text not in ("each", "every") or not (
            reading.starts(index) or reading.word(index - 1) in (",", "and", ":")
        ):
            continue
        subject = reading.word(index + 1)
        if reading.word(index + 2) in FLOOR_WORDS:
            continue  # "every tenant floor" is a storey
        if subject in _HAVING and reading.word(index - 1) == "," and reading.kind(index - 3) == "number":
            subject = reading.word(index - 2)  # "60 children in 3 groups, each with a toilet"
            if any(p.begin <= index - 2 < p.noun_end and p.head in ("room", "building", "object") for p in phrases):
                continue
        if subject not in counts or any(p.begin <= index + 1 < p.noun_end and p.head == "room" for p in phrases):
            continue
        for number, phrase in enumerate(phrases):
            if (
                phrase.head == "room"
                and subject != "room"
                and not (
                    phrase.determiner in ("its", "own") and number and phrases[number - 1].count == counts[subject]
                )
                and phrase.first > index
                and reading.sentence[phrase.first] == reading.sentence[index]
                and phrase.count == 1
                and phrase.determiner not in ("the",)
                and phrase.first not in households.read
                and _SHARED.isdisjoint(reading.words(phrase.first, phrase.noun_end))
            ):
                phrases[number] = replace(phrase, count=counts[subject], counted=True)
        reading.take(index, index + 2)
        _take_number(reading, subject, counts[subject])


def _take_number(reading: Reading, noun: str, count: int) -> None:
    """Take the number that groups were counted by: "60 children in three groups"."""
    for at in range(len(reading.tokens) - 1):
        if reading.value(at) == count and reading.kind(at) == "number" and reading.word(at + 1) == noun:
            reading.take(at, at + 2)


_SHARED = frozenset({"shared", "common", "communal"})
_HAVING = frozenset({"with", "has", "have", "want", "need", "get", "having"})
"""What "each" can go on with: "two doctors, each with a consulting room"."""


def read_counts_by_person(
    reading: Reading, phrases: list[Phrase], rooms: Sequence[int], same: Mapping[int, int], inner: Collection[int]
) -> None:
    """Read "Each of us needs a bedroom with a bathroom" as one for each of the people named before.

    See `mansion_planner.brief.suites.read_suites` for the parameters: what a room has for itself is not multiplied.
    """
    for index in range(len(reading.tokens) - 2):
        if reading.word(index) not in ("each", "every") or index in reading.taken:
            continue
        of_them = reading.words(index + 1, index + 3) in (("of", "us"), ("of", "them"), ("of", "these"))
        noun = reading.word(index + 1)
        people = [p for p in phrases if p.head == "people" and p.counted and p.first < index and (p.count or 0) > 1]
        alone = noun in _HAVING and reading.word(index - 1) in (",", ":", ".", "-")
        if alone:
            people = [p for p in people if index - p.last <= 2]
        elif not of_them:
            people = [p for p in people if reading.word(p.noun_end - 1) == noun]
        if not people or not (people[-1].count or 99) <= 40:
            continue
        count, suites = people[-1].count, read_suites(reading, phrases, rooms, same, inner).owners
        for number, phrase in enumerate(phrases):
            own = phrase.determiner in ("a", "an", "own", "his", "her", "their", "one", "") or phrase.count == 1
            if (
                phrase.head == "room"
                and phrase.first > index
                and reading.sentence[phrase.first] == reading.sentence[index]
                and phrase.count == 1
                and own
                and phrase.determiner != "the"
                and number not in suites
            ):
                phrases[number] = replace(phrase, count=count, counted=True)
        reading.take(index, index + (3 if of_them else 2))
        if alone:
            reading.take(people[-1].first, people[-1].last)
