"""Read areas, and tell whose they are: a room's, a storey's or the whole building's."""

import itertools
from dataclasses import replace

from mansion_language.units import AREA, LENGTH
from mansion_planner.brief.area_words import FILLERS, PLOT, TOTALS, Measure, is_of_each, words_after
from mansion_planner.brief.bounds import limit_of
from mansion_planner.brief.facts import Quantity, Span
from mansion_planner.brief.idle_words import is_idle_word
from mansion_planner.brief.phrase import FUNCTION_WORDS, Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.room_areas import is_building, joined_alike, room_of, said_of_each
from mansion_planner.brief.storey_areas import is_of_one_storey, is_of_storey

__all__ = ["find_measures", "give_measures"]


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
        index = _leave_out_basement(reading, measure)
    return found


_LEAVING_OUT = (
    ("without",), ("excluding",), ("excl",), ("excl", "."), ("exclusive", "of"), ("not", "including"), ("plus",),
    ("not", "counting"), ("without", "counting"), ("not", "incl"), ("besides",), ("apart", "from"),
)  # fmt: skip
"""Words between an area and the basement that is no part of it."""


def _leave_out_basement(reading: Reading, measure: Measure) -> int:
    """Record and take "without the basement" or "above ground" after an area; return where the next one may begin."""
    start = measure.last + (reading.word(measure.last) in (",", "("))
    if reading.words(start, start + 2) in (("above", "ground"), ("above", "grade")):
        reading.take(measure.last, start + 2)
        reading.facts.above_ground.append(reading.span(measure.first, start + 2))
        return start + 2
    for words in sorted(_LEAVING_OUT, key=len, reverse=True):
        at = start + len(words)
        at += reading.word(at) in ("the", "a", "its")
        if reading.words(start, start + len(words)) != words or reading.word(at) not in ("basement", "cellar"):
            continue
        counted = words == ("without",) and reading.word(at - 1) != "the"
        if counted or reading.kind(at + 1) in ("number", "unit"):
            break  # "200 m2 without basement" has none
        reading.take(measure.last, at + 1)
        reading.facts.above_ground.append(reading.span(measure.first, at + 1))
        return at + 1
    return measure.last


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
        if measure.first in reading.named_areas or _given_to_room(reading, measure, result):
            continue
        if len(measure.values) > 1:
            _give_to_several(reading, measure, result)
            continue
        owner = _room_before(
            reading, measure, result, told=bool(reading.facts.area or reading.facts.floor_area or single)
        )
        if owner is not None:
            result[owner] = replace(result[owner], areas=measure.values, limit=measure.limit)
            continue
        fact = Quantity(measure.values[0], reading.span(measure.first, measure.last), measure.limit)
        if is_of_one_storey(reading, measure):
            single.append(fact)
        elif measure.sides and not PLOT.isdisjoint(reading.words(max(measure.first - 6, 0), measure.first)):
            plots.append(fact)
        elif is_of_storey(reading, measure):
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


def _given_to_room(reading: Reading, measure: Measure, phrases: list[Phrase]) -> bool:
    """Give an area to the rooms that it is of; return whether there are any."""
    target = room_of(reading, measure, phrases)
    again = said_of_each(reading, measure, phrases)
    if again is not None:
        number, target = again
        phrases[number] = replace(phrases[number], head="unknown")
    if target is None:
        return False
    areas = phrases[target].areas + measure.values
    for number in (target, *joined_alike(reading, measure, phrases, target)):
        phrases[number] = replace(phrases[number], areas=areas, limit=measure.limit)
    return True


def _room_before(reading: Reading, measure: Measure, phrases: list[Phrase], *, told: bool) -> int | None:
    """Return the room named last before an area that cannot be the building's, in its sentence; none where it can be.

    "Twelve rooms each, 22 m2" is of the rooms; so is "a kitchen where all can eat (20 m2)" if the building's is told.
    """
    near = reading.words(max(measure.first - 4, 0), measure.last + 4)
    if measure.sides or measure.limit or not TOTALS.isdisjoint(near):
        return None
    sentence = reading.sentence[measure.first]
    before = [n for n, p in enumerate(phrases) if p.last <= measure.first and reading.sentence[p.first] == sentence]
    if not before or phrases[before[-1]].head != "room" or phrases[before[-1]].areas:
        return None
    room, value = phrases[before[-1]], measure.values[0]
    gap = set(reading.words(room.last, measure.first))
    each = bool(gap & {"each", "apiece", "per"}) and gap <= _EACH_TIME
    opened = reading.word(measure.first - 1) == "("
    fits = bool(room.room_type) and value <= _ROOMY * reading.knowledge.room(room.room_type).most
    return before[-1] if each or (told and opened and fits) else None


_EACH_TIME = frozenset({"each", "apiece", "per", "floor", "storey", "level", ",", "(", "-", "–"})
"""Words between rooms and the area that each of them has: "eight rooms per floor, 24 m2"."""
_ROOMY = 1.6
"""Share of the most area of its kind that a room may have and still be meant."""


def _give_to_several(reading: Reading, measure: Measure, phrases: list[Phrase]) -> None:
    """Give a list of areas to the rooms in the plural that the sentence names last before it."""
    several = [
        n
        for n, p in enumerate(phrases)
        if p.last <= measure.first
        and p.head == "room"
        and p.plural
        and reading.sentence[p.first] == reading.sentence[measure.first]
        and not p.areas
    ]
    if several:
        phrases[several[-1]] = replace(phrases[several[-1]], areas=measure.values)


def _settle_storeys(reading: Reading, single: list[Quantity]) -> None:
    """Take the areas of storeys that are all alike for that of each; others cannot be met, and are told of."""
    facts = reading.facts
    if not single:
        return
    alike = max(q.value for q in single) <= 1.15 * min(q.value for q in single)
    start, end = single[0].span.start, single[-1].span.end
    whole = Span(reading.text[start:end], start, end)
    if alike and not facts.floor_area:
        same = len({q.value for q in single}) == 1
        facts.floor_area.append(single[0] if same else Quantity(sum(q.value for q in single) / len(single), whole))
    elif not (alike or facts.area):
        # Storeys have one area each: the sum is kept, and that it is shared out otherwise stays with the wish.
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
    return not TOTALS.isdisjoint(near)


def _of_something_else(reading: Reading, measure: Measure, phrases: list[Phrase]) -> bool:
    """Whether "of 65 m2" and "12 m2 each" follow rooms, so that they are not said of the building."""
    before_it = measure.first - 1
    while before_it >= 0 and reading.word(before_it) in FILLERS:
        before_it -= 1
    if reading.word(before_it) in _OTHERS:
        return True  # "the largest 80 m2, the others 30 m2 each"
    said = reading.word(measure.first - 1) == "of" or words_after(reading, measure, 1) == ["each"]
    sentence = reading.sentence[measure.first]
    before = [p for p in phrases if p.last <= measure.first and reading.sentence[p.first] == sentence]
    near = bool(before) and measure.first - before[-1].last <= 4
    counted = near and before[-1].head == "room" and before[-1].counted and (before[-1].count or 0) > 1
    return said and counted and TOTALS.isdisjoint(words_after(reading, measure, 3))


def _of_unread_noun(reading: Reading, measure: Measure, phrases: list[Phrase]) -> bool:
    """Whether an area is said of something that the brief names and that nothing is read of: "Nave Two (90 m2)"."""
    if is_of_each(reading, measure):
        return True
    sentence = reading.sentence[measure.first]
    before = [p for p in phrases if reading.sentence[p.first] == sentence and p.last < measure.first]
    dwelling = [p for p in before if p.building == "flat" and is_building(reading, p)]  # a flat may be a room too
    rooms = any(p.head == "room" and p not in dwelling for p in before)
    if sentence == 0 and not rooms and not reading.facts.area:
        return False
    if not TOTALS.isdisjoint(words_after(reading, measure, 3)):
        return False
    clause = itertools.takewhile(
        lambda at: not reading.breaks(at) and reading.word(at) not in (",", ":", "("),
        range(measure.first - 1, max(measure.first - 25, -1), -1),
    )
    if not TOTALS.isdisjoint(map(reading.word, clause)):
        return False
    index = measure.first - 1
    while index >= 0 and reading.word(index) in FILLERS:
        index -= 1
    named = reading.kind(index) in ("word", "number")
    unread = index >= 0 and index not in reading.taken and reading.sentence[index] == reading.sentence[measure.first]
    named = named and not is_idle_word(reading.word(index))
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
