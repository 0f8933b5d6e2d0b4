"""Read areas, and tell whose they are: a room's, a storey's or the whole building's."""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace

from mansion_language.units import AREA, LENGTH
from mansion_planner.brief.bounds import Limit, limit_of
from mansion_planner.brief.facts import Quantity, Span
from mansion_planner.brief.phrase import FUNCTION_WORDS, Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["Measure", "find_measures", "give_measures"]

_FILLERS = frozenset(
    """
    of with ( about around at least measuring is has approximately be should covering roughly an area size sized
    each : having = a must will exactly occupying minimum than more floor something like the region in circa ca
    approx some apiece over for maybe nearly almost are being up to each one - – every max maximum no less not under
    total below every measure have has some shall larger bigger smaller greater exceed exceeding within limited
    capped min pass surpass all alike identical equal same
    """.split()
)
_TOTALS = frozenset(
    """
    total overall altogether gross gfa together whole all gia net
    """.split()
)
_LINKS = frozenset(
    """
    of at with ( is has are each about measuring around measure have not max maximum up roughly gets should must area
    size approx
    """.split()
)
_ABOUT = frozenset("about around approx roughly ca circa some".split())
_HOLDS_ALL = frozenset({"in", "within", "on", "across"})
"""Words that put all that a sentence lists into one area: "a kitchen, a bedroom and a bathroom in 87 m2"."""

_SURFACE = frozenset({"surface", "occupy", "occupies"})
"""Words between a room and its area: "the hall has a surface of 95 m2"."""

_PLOT = frozenset({"plot", "site", "lot"})
_PLATE = frozenset({"plate", "footprint"})


@dataclass(frozen=True)
class Measure:
    """Areas in the text: tokens `first` to `last` (exclusive), square metres; several for a list."""

    first: int
    last: int
    values: tuple[float, ...]
    sides: bool = False
    limit: Limit = ""


def find_measures(reading: Reading) -> list[Measure]:
    """Return all areas from left to right, and take their tokens."""
    found: list[Measure] = []
    index = 0
    while index < len(reading.tokens):
        measure = None if index in reading.taken else _measure_at(reading, index)
        if measure is None:
            index += 1
            continue
        reading.take(measure.first, measure.last)
        if reading.words(measure.last, measure.last + 2) == ("each", "one"):
            reading.take(measure.last + 1, measure.last + 2)
        found.append(replace(measure, limit=limit_of(reading, measure.first, measure.last)))
        index = measure.last
    return found


def _measure_at(reading: Reading, index: int) -> Measure | None:
    if reading.kind(index) != "number" or reading.value(index) <= 0:
        return None
    sides = _sides_at(reading, index)
    if sides is not None:
        return sides
    values, last = [reading.value(index)], index + 1
    while reading.word(last) in (",", "and", "&", "/") or (reading.word(last) in ("–", "to", "-") and len(values) == 1):
        ranged = reading.word(last) in ("–", "to", "-")
        if reading.word(last) == "-" and reading.kind(index - 1) == "word" and reading.value(index) < 10:
            break  # "Bedroom 2 - 12 m2"
        step = 2 if reading.word(last) == "," and reading.word(last + 1) == "and" else 1
        if reading.kind(last + step) != "number":
            break
        values.append(reading.value(last + step))
        last += step + 1
        if ranged or reading.word(index - 1) == "between":
            values = [sum(values) / 2]
            break
    if reading.kind(last) != "unit" or reading.word(last) not in AREA:
        return None
    if len(values) > 1 and values[0] < 5 and reading.word(index + 1) == ",":
        return None
    factor = AREA[reading.word(last)]
    return Measure(index, last + 1, tuple(value * factor for value in values))


def _sides_at(reading: Reading, index: int) -> Measure | None:
    """Read "20 x 15 m" and "5 by 8 metres" as an area."""
    link = index + 1 + (reading.kind(index + 1) == "unit" and reading.word(index + 1) in LENGTH)
    if reading.word(link) not in ("x", "by") or reading.kind(link + 1) != "number":
        return None
    unit = reading.word(link + 2)
    if unit not in LENGTH:
        return None
    area = reading.value(index) * reading.value(link + 1) * LENGTH[unit] ** 2
    return Measure(index, link + 3, (area,), sides=True)


def give_measures(reading: Reading, measures: list[Measure], phrases: list[Phrase]) -> list[Phrase]:
    """Give each area to the room, the storeys or the building that it is of; return the phrases with their areas."""
    result = list(phrases)
    plots: list[Quantity] = []
    single: list[Quantity] = []
    for measure in measures:
        if measure.first in reading.named_areas:
            continue
        target = _room_of(reading, measure, result)
        again = _said_of_each(reading, measure, result)
        if again is not None:
            number, target = again
            result[number] = replace(result[number], head="unknown")
        if target is not None:
            areas = result[target].areas + measure.values
            for number in (target, *_joined_alike(reading, measure, result, target)):
                result[number] = replace(result[number], areas=areas, limit=measure.limit)
            continue
        if len(measure.values) > 1:
            several = [
                n
                for n, p in enumerate(result)
                if p.last <= measure.first
                and p.head == "room"
                and p.plural
                and reading.sentence[p.first] == reading.sentence[measure.first]
                and not p.areas
            ]
            if several:
                result[several[-1]] = replace(result[several[-1]], areas=measure.values)
            continue
        fact = Quantity(measure.values[0], reading.span(measure.first, measure.last), measure.limit)
        if _of_one_storey(reading, measure):
            single.append(fact)
            continue
        if measure.sides and not _PLOT.isdisjoint(reading.words(max(measure.first - 6, 0), measure.first)):
            plots.append(fact)
        elif _of_storey(reading, measure):
            reading.facts.floor_area.append(fact)
        elif _of_something_else(reading, measure, result) or _of_unread_noun(reading, measure, result):
            reading.taken.difference_update(range(measure.first, measure.last))
        elif not _of_part(reading, measure):
            reading.facts.area.append(fact)
    _settle_storeys(reading, single)
    if not (reading.facts.floor_area or reading.facts.area):
        reading.facts.floor_area += plots  # all that is said of the size
    _settle(reading)
    return result


def _is_of_each(reading: Reading, measure: Measure) -> bool:
    """Whether an area is said of each of several: "each 30 m2", "30 m2 each"."""
    return "each" in reading.words(_lead(reading, measure), measure.first) or _after(reading, measure, 1) in (
        ["each"],
        ["apiece"],
    )


def _joined_alike(reading: Reading, measure: Measure, phrases: list[Phrase], target: int) -> list[int]:
    """Return the rooms of a kind that share an area with the last of them: "Lab A and Lab B, 40 m2 each"."""
    found: list[int] = []
    while target > 0 and _is_of_each(reading, measure):
        one, other = phrases[target - 1], phrases[target]
        joints = set(reading.words(one.last, other.begin))
        alike = one.room_type == other.room_type and joints <= {"and", ",", "the"}
        joined = one.head == "room" and one.name != other.name and (alike or joints <= {"and", "a", "an"})
        if not (joined and joints) or one.areas or one.count != 1 or other.count != 1:
            break
        target -= 1
        found.append(target)
    return found


def _of_one_storey(reading: Reading, measure: Measure) -> bool:
    """Whether an area stands right after the name of one storey: "ground floor 80 m2", "Upper floor (80 m2): ..."."""
    at = measure.first - 1
    while reading.word(at) in ("(", ":", ",", "of", "with", "has", "is", "about", "around", "-", "="):
        at -= 1
    named = reading.word(at) in FLOOR_WORDS and not reading.plural(at) and at in reading.taken
    lead = {reading.word(at - 1), reading.word(at - 2)}
    counted = reading.kind(at - 1) == "number" or not lead.isdisjoint(_EVERY)
    return named and not counted and at > 0


_EVERY = frozenset({"each", "every", "per", "any", "one", "single", "typical", "by", "all", "a"})


def _settle_storeys(reading: Reading, single: list[Quantity]) -> None:
    """Take the areas of storeys that are all alike for that of each; others cannot be met, and are told of."""
    facts = reading.facts
    if not single:
        return
    alike = max(q.value for q in single) <= 1.15 * min(q.value for q in single)
    if alike and not facts.floor_area:
        facts.floor_area.append(single[0])
    elif not (alike or facts.area):
        # Storeys have one area each: the sum is kept, and that it is shared out otherwise stays with the wish.
        start, end = single[0].span.start, single[-1].span.end
        whole = Span(reading.text[start:end], start, end)
        facts.area.append(Quantity(sum(q.value for q in single), whole))
        facts.unheeded += [q.span for q in single]
    else:
        _leave(reading, single)


def _settle(reading: Reading) -> None:
    """Keep the total that is called so where a brief gives two areas of the building."""
    facts = reading.facts
    if len(facts.area) > 1:
        called = [q for q in facts.area if _called_total(reading, q)]
        _leave(reading, facts.area, (called or facts.area)[0])
        facts.area = (called or facts.area)[:1]
    _leave(reading, facts.floor_area, *facts.floor_area[:1])
    facts.floor_area = facts.floor_area[:1]


def _leave(reading: Reading, quantities: list[Quantity], *kept: Quantity) -> None:
    """Give back the words of areas that nothing is made of, so that they are told of."""
    others = [q.span for q in quantities if all(abs(q.value - other.value) > 0.5 for other in kept)]
    starts = {span.start: span.end for span in others}
    for index, token in enumerate(reading.tokens):
        if token.start in starts:
            last = next(
                (i for i in range(index, len(reading.tokens)) if reading.tokens[i].end >= starts[token.start]), index
            )
            reading.taken.difference_update(range(index, last + 1))


def _called_total(reading: Reading, quantity: Quantity) -> bool:
    index = next(i for i, token in enumerate(reading.tokens) if token.start >= quantity.span.start)
    near = reading.words(max(index - 4, 0), index + 6)
    return not _TOTALS.isdisjoint(near)


def _after(reading: Reading, measure: Measure, count: int = 5) -> list[str]:
    words = []
    for index in range(measure.last, measure.last + count):
        joined = reading.words(index, index + 2) == ("together", "with")  # what follows is measured apart
        if reading.breaks(index) or reading.word(index) in (",", ":", "with") or joined:
            break
        words.append(reading.word(index))
    return words


def _of_storey(reading: Reading, measure: Measure) -> bool:
    after = _after(reading, measure)
    before = [reading.word(i) for i in range(measure.first - 6, measure.first) if i >= 0]
    for cut in (".", ";", "\n"):
        if cut in before:
            before = before[len(before) - before[::-1].index(cut) :]
    own = before[len(before) - before[::-1].index(",") :] if "," in before else before
    if _for_each_storey(reading, measure) or _for_each_of_the_storeys(reading, measure):
        return True
    counted = bool(reading.facts.floors) and reading.facts.floors[0].value > 1
    if (
        after[:1]
        and after[0] in ("below", "above", "downstair", "upstair", "downstairs", "upstairs")
        and "same" in after
    ):
        return True  # "150 m2 below and the same above"
    if counted and tuple(after[:2]) in (("the", "floor"), ("the", "storey"), ("the", "level")):
        return True
    if not _TOTALS.isdisjoint(after[:4]) or not _TOTALS.isdisjoint(own):
        return "plate" in after
    if not _PLATE.isdisjoint(after) or not _PLATE.isdisjoint(before):
        return True
    for word, following in zip(after, [*after[1:], ""]):
        if word in ("per", "a", "each", "every", "/", "by", "one", "any") and following in FLOOR_WORDS:
            return True
        if word not in ("per", "a", "each", "every", "/", "apiece", "gross", "or", "so", "to", "on", "for"):
            break
    if tuple(after[:2]) in (("on", "each"), ("to", "each"), ("for", "each"), ("on", "every")) and not after[2:3]:
        return bool(reading.facts.floors)
    if measure.sides:
        return True
    if any(word in FLOOR_WORDS for word in before) or (before and before[-1] in ("each", "level")):
        index = measure.first - 1
        while reading.word(index) in _FILLERS and reading.word(index) not in ("each", "floor") and index > 0:
            index -= 1
        apiece = bool({"each", "apiece"} & set(after[:2])) or reading.word(index) == "each"
        if reading.words(index - 2, index + 1) == ("each", "of", "them"):
            apiece, index = True, index - 3
        index -= reading.word(index) == "each"
        while apiece and reading.word(index) in ("of", "with", "at", "having"):
            index -= 1  # "two floors of each 110 m2"
        if reading.word(index) == "," and apiece:
            index -= 1
        index -= apiece and reading.word(index) in ("above", "over", "up")  # "three floors above, of 600 m2 each"
        if reading.word(index) in FLOOR_WORDS:
            plural = reading.plural(index) or _many_before(reading, index)
            linked = reading.word(index + 1) in _LINKS or apiece
            each = any(word in ("each", "every", "per", "all") for word in before)
            return (plural or each or apiece) and linked
    return False


def _for_each_storey(reading: Reading, measure: Measure) -> bool:
    """Whether an area is said of each storey: "each floor 560 m2", "one floor is 330 m2", "gross 350 m2 per storey"."""
    after = _after(reading, measure, 3)
    if (
        after[:1] in (["per"], ["by"])
        and after[1:2]
        and after[1] in FLOOR_WORDS
        and not reading.plural(measure.last + 1)
    ):
        return True
    index = measure.first - 1
    while index > 0 and reading.word(index) in _FILLERS - {"floor", "each", "every", "with"}:
        index -= 1
    if reading.word(index) not in FLOOR_WORDS or reading.plural(index):
        return False
    index -= 1
    while reading.word(index) in ("single", "typical", "upper", "full"):
        index -= 1
    one = reading.word(index) == "one" and reading.word(index + 2) in ("is", "has", "be", "=", "have")
    return reading.word(index) in ("each", "every", "per", "any") or one


def _for_each_of_the_storeys(reading: Reading, measure: Measure) -> bool:
    """Whether an area is "on each of the three floors", with the area in front."""
    words = _after(reading, measure, 8)
    if words[:1] not in (["on"], ["for"], ["to"]) or words[1:3] != ["each", "of"]:
        return False
    rest = [word for word in words[3:] if word not in ("the", "its", "our", "their", "these", "all")]
    number = measure.last + len(words) - len(rest)
    return bool(rest) and rest[reading.kind(number) == "number" :][:1] in [[word] for word in FLOOR_WORDS]


def _many_before(reading: Reading, index: int) -> bool:
    return any(reading.kind(i) == "number" and reading.value(i) > 1 for i in range(index - 3, index))


def _of_something_else(reading: Reading, measure: Measure, phrases: list[Phrase]) -> bool:
    """Whether "of 65 m2" and "12 m2 each" follow rooms, so that they are not said of the building."""
    before_it = measure.first - 1
    while before_it >= 0 and reading.word(before_it) in _FILLERS:
        before_it -= 1
    if reading.word(before_it) in _OTHERS:
        return True  # "the largest 80 m2, the others 30 m2 each"
    said = reading.word(measure.first - 1) == "of" or _after(reading, measure, 1) == ["each"]
    sentence = reading.sentence[measure.first]
    before = [p for p in phrases if p.last <= measure.first and reading.sentence[p.first] == sentence]
    near = bool(before) and measure.first - before[-1].last <= 4
    counted = near and before[-1].head == "room" and before[-1].counted and (before[-1].count or 0) > 1
    return said and counted and _TOTALS.isdisjoint(_after(reading, measure, 3))


def _of_unread_noun(reading: Reading, measure: Measure, phrases: list[Phrase]) -> bool:
    """Whether an area is said of something that the brief names and that nothing is read of: "Nave Two (90 m2)"."""
    if _is_of_each(reading, measure):
        return True
    sentence = reading.sentence[measure.first]
    before = [p for p in phrases if reading.sentence[p.first] == sentence and p.last < measure.first]
    dwelling = [p for p in before if p.building == "flat" and _is_building(reading, p)]  # a flat may be a room too
    rooms = any(p.head == "room" and p not in dwelling for p in before)
    if sentence == 0 and not rooms and not reading.facts.area:
        return False
    if not _TOTALS.isdisjoint(_after(reading, measure, 3)):
        return False
    clause = itertools.takewhile(
        lambda at: not reading.breaks(at) and reading.word(at) not in (",", ":", "("),
        range(measure.first - 1, max(measure.first - 25, -1), -1),
    )
    if not _TOTALS.isdisjoint(map(reading.word, clause)):
        return False
    index = measure.first - 1
    while index >= 0 and reading.word(index) in _FILLERS:
        index -= 1
    named = reading.kind(index) in ("word", "number")
    unread = index >= 0 and index not in reading.taken and reading.sentence[index] == reading.sentence[measure.first]
    return unread and named and reading.word(index) not in _BUILDINGS | FUNCTION_WORDS


_BUILDINGS = frozenset(
    """
    building house home size area surface space footprint plot site lot it everything place we i you they need want
    budget available use property premise unit object project and or so but while because
    """.split()
)
"""Words before an area that is the building's own."""
_OTHERS = frozenset("largest biggest smallest other others rest remaining larger smaller bigger".split())


def _of_part(reading: Reading, measure: Measure) -> bool:
    """Whether an area is of a part of the building that is no room ("45 m2 on the ground"); such areas are left."""
    return bool(reading.facts.area) and reading.word(measure.last) in ("on", "in") and not measure.sides


def _room_of(reading: Reading, measure: Measure, phrases: list[Phrase]) -> int | None:
    """Return which phrase an area belongs to: the room right after it, or the one that it is said of."""
    after = _after(reading, measure, 4)
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
        or _bracketed(reading, measure, phrases)
        or _with_complement(reading, measure, phrases)
    )
    if not candidates:
        return None
    phrase = phrases[candidates[-1]]
    if _is_building(reading, phrase) or (phrase.areas and len(measure.values) == 1):
        return None
    if comma and phrase.last == end and not _listed(reading, measure, phrase, after):
        return None
    return candidates[-1]


def _is_of_all(reading: Reading, measure: Measure, phrases: list[Phrase], after: list[str]) -> bool:
    """Whether an area is a total, that of all rooms of a list, or a plot's."""
    total = not _TOTALS.isdisjoint(after[:3])
    if "each" not in after and (total or _of_all_listed(reading, measure, phrases)):
        return True
    before = reading.words(max(measure.first - 6, 0), measure.first)
    return measure.sides and not (_PLOT | {"footprint"}).isdisjoint(before)


def _room_after(reading: Reading, measure: Measure, phrases: list[Phrase]) -> int | None:
    """Return the room without an area yet that is named right after an area: "20 m2 kitchen", "20 m2 of office"."""
    for number, phrase in enumerate(phrases):
        if phrase.head != "room" or not 0 <= phrase.first - measure.last <= 2:
            continue
        gap = reading.words(measure.last, phrase.first)
        joined = not gap or (gap[0] == "of" and set(gap) <= {"of", "for", "-", "each"})
        if joined and not phrase.areas and not _is_building(reading, phrase):
            return number
    return None


def _end_of_what_is_measured(reading: Reading, measure: Measure, phrases: list[Phrase]) -> tuple[int, bool]:
    """Return the token after the words that an area is said of, and whether a comma stands between the two."""
    before, comma = measure.first - 1, False
    ends = {phrase.last for phrase in phrases}
    while (
        before >= 0
        and before + 1 not in ends
        and not (reading.word(before) in FLOOR_WORDS and reading.kind(before - 1) == "number")
        and (
            reading.word(before) in _FILLERS | _SURFACE
            or (reading.word(before) == "," and not comma)
            or (reading.word(before) == "." and not reading.breaks(before))
        )
    ):
        comma = comma or reading.word(before) == ","
        before -= 1
    if reading.word(before) in FLOOR_WORDS and reading.word(before - 1) in ("per", "by", "each", "every"):
        at = before - 1 - (reading.word(before - 2) in ("on", "in", "at"))
        if at in ends:
            return at, comma  # "6 classrooms per level, of 55 m2 each"
    return before + 1, comma


def _ending_at(phrases: list[Phrase], end: int) -> list[int]:
    """Return the rooms and buildings whose phrases, or the nouns of these, end at a token."""
    return [
        n
        for n, p in enumerate(phrases)
        if p.noun_end <= end <= p.last and (p.head == "building" or (p.head == "room" and p.room_type))
    ]


def _with_complement(reading: Reading, measure: Measure, phrases: list[Phrase]) -> list[int]:
    """Return the rooms of which more is said before their area: "the bay for three engines (180 m2)"."""
    if reading.word(_lead(reading, measure)) not in ("(", "of"):
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
    lead = _lead(reading, measure)
    return reading.word(lead) == "of" and any(
        phrase.last == lead and phrase.counted and (phrase.count or 0) > 1 and phrase.room_type for phrase in phrases
    )


def _lead(reading: Reading, measure: Measure) -> int:
    """Return the token before an area and the words that only make it approximate."""
    lead = measure.first - 1
    while reading.word(lead) in _ABOUT:
        lead -= 1
    return lead


def _of_all_listed(reading: Reading, measure: Measure, phrases: list[Phrase]) -> bool:
    """Whether an area is that of all rooms which the sentence lists before it."""
    lead = _lead(reading, measure)
    if reading.word(lead) not in _HOLDS_ALL:
        return False
    sentence = reading.sentence[measure.first]
    listed = [p for p in phrases if p.head == "room" and reading.sentence[p.first] == sentence and p.first < lead]
    return len(listed) > 1 and listed[-1].noun_end == lead and not any(p.areas for p in listed)


def _said_of_each(reading: Reading, measure: Measure, phrases: list[Phrase]) -> tuple[int, int] | None:
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
        and not _is_building(reading, phrases[n])
    ]
    if not rooms or phrases[rooms[-1]].areas:
        return []
    gap = reading.words(phrases[rooms[-1]].last, measure.first)
    people = len(gap) >= 3 and gap[0] == "for" and gap[-1] == "," and len(gap) <= 5
    above = gap[:1] in (("above",), ("below",), ("upstairs",), ("downstairs",)) and set(gap[1:]) <= _FILLERS
    relative = gap[:2] == (",", "which") and gap[-1] == "," and "room" in gap and ";" not in gap
    return rooms[-1:] if people or above or relative or _is_clause_of_room(gap) else []


def _is_clause_of_room(gap: Sequence[str]) -> bool:
    """Whether only a relative clause stands between a room and its area: "the kitchen where we eat, 25 m2"."""
    words = list(gap)
    while words and words[-1] in _ABOUT:
        words.pop()
    return 3 <= len(words) <= 9 and words[0] in ("where", "that", "who") and words[-1] == "," and words.count(",") == 1


def _is_building(reading: Reading, phrase: Phrase) -> bool:
    return any(
        span.start == reading.tokens[phrase.begin].start
        or span.start <= reading.tokens[phrase.noun_end - 1].start < span.end
        for _, span in reading.facts.building
    )


def _listed(reading: Reading, measure: Measure, phrase: Phrase, after: list[str]) -> bool:
    """Whether a comma joins an area to the room before it: "rooms, 15 m2 each", "hall, 320 m2 |", an item of a list."""
    if _is_of_each(reading, measure):
        return True
    gap = reading.words(phrase.last, measure.first)
    alike = not {"alike", "same", "equal", "identical"}.isdisjoint(gap)
    if len(measure.values) > 1 or alike or not {("all", "of"), ("all", "at")}.isdisjoint(itertools.pairwise(gap)):
        return True
    alone = reading.word(measure.last) in ("|", "\n", "", ")", ";")
    if reading.sentence[measure.first] > 0 and reading.word(phrase.last) == ",":
        return True
    return alone and (reading.starts(phrase.first) or reading.word(phrase.first - 1) == "|")
