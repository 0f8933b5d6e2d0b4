"""Tell whether an area is said of a storey: "110 m2 per floor", "three floors of 80 m2 each", "ground floor 80 m2"."""

import itertools

from mansion_planner.brief.area_words import FILLERS, TOTALS, Measure, is_filler, words_after
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["is_of_one_storey", "is_of_storey"]

_LINKS = frozenset(
    """
    of at with ( is has are each about measuring around measure have not max maximum up roughly gets should must area
    size approx
    """.split()
)
_PLATE = frozenset({"plate", "footprint"})


def is_of_one_storey(reading: Reading, measure: Measure) -> bool:
    """Whether an area stands right after the name of one storey: "ground floor 80 m2", "Upper floor (80 m2): ..."."""
    at = measure.first - 1
    while reading.word(at) in ("(", ":", ",", "of", "with", "has", "is", "about", "around", "-", "="):
        at -= 1
    named = reading.word(at) in FLOOR_WORDS and not reading.plural(at) and at in reading.taken
    lead = {reading.word(at - 1), reading.word(at - 2)}
    counted = reading.kind(at - 1) == "number" or not lead.isdisjoint(_EVERY)
    return named and not counted and at > 0


_EVERY = frozenset({"each", "every", "per", "any", "one", "single", "typical", "by", "all", "a"})


def is_of_storey(reading: Reading, measure: Measure) -> bool:
    """Whether an area is that of each storey, or of one that stands for all: "110 m2 per floor", "a 12 x 8 m plan"."""
    if _for_each_storey(reading, measure) or _for_each_of_the_storeys(reading, measure) or _of_both(reading, measure):
        return True
    after = words_after(reading, measure)
    if after[:1] and after[0] in _ABOVE_AND_BELOW and "same" in after:
        return True  # "150 m2 below and the same above"
    counted = bool(reading.facts.floors) and reading.facts.floors[0].value > 1
    if counted and tuple(after[:2]) in (("the", "floor"), ("the", "storey"), ("the", "level")):
        return True
    before = _words_before(reading, measure)
    own = before[len(before) - before[::-1].index(",") :] if "," in before else before
    if not TOTALS.isdisjoint(after[:4]) or not TOTALS.isdisjoint(own):
        return "plate" in after
    if not _PLATE.isdisjoint(after) or not _PLATE.isdisjoint(before) or _is_per_storey(after):
        return True
    if tuple(after[:2]) in _ON_EACH and not after[2:3]:
        return bool(reading.facts.floors)
    if measure.sides:
        return True
    near = any(word in FLOOR_WORDS for word in before) or before[-1:] in (["each"], ["level"])
    return near and _is_of_storeys_before(reading, measure, before, after)


_ON_EACH = (("on", "each"), ("to", "each"), ("for", "each"), ("on", "every"), ("on", "either"), ("on", "both"))
_ABOVE_AND_BELOW = frozenset({"below", "above", "downstair", "upstair", "downstairs", "upstairs"})


def _words_before(reading: Reading, measure: Measure) -> list[str]:
    """Return up to six words of the sentence right before an area."""
    near = range(measure.first - 1, max(measure.first - 7, -1), -1)
    return [reading.word(i) for i in itertools.takewhile(lambda at: not reading.breaks(at), near)][::-1]


def _is_per_storey(after: list[str]) -> bool:
    """Whether the words after an area share it out over storeys: "per floor", "gross on each level"."""
    for word, following in zip(after, [*after[1:], ""]):
        if word in ("per", "a", "each", "every", "/", "by", "one", "any") and following in FLOOR_WORDS:
            return True
        if word not in ("per", "a", "each", "every", "/", "apiece", "gross", "or", "so", "to", "on", "for"):
            break
    return False


def _is_of_storeys_before(reading: Reading, measure: Measure, before: list[str], after: list[str]) -> bool:
    """Whether storeys that stand before an area have it each: "two floors of each 110 m2", "all levels 90 m2"."""
    index = measure.first - 1
    while is_filler(reading, index) and reading.word(index) not in ("each", "floor") and index > 0:
        index -= 1
    apiece = bool({"each", "apiece"} & set(after[:2])) or reading.word(index) == "each"
    if reading.words(index - 2, index + 1) == ("each", "of", "them"):
        apiece, index = True, index - 3
    index -= reading.word(index) == "each"
    while apiece and reading.word(index) in ("of", "with", "at", "having"):
        index -= 1
    if reading.word(index) in (",", "/") and apiece:
        index -= 1
    index -= apiece and reading.word(index) in ("ground", "grade") and reading.word(index - 1) == "above"
    index -= apiece and reading.word(index) in ("above", "over", "up")  # "three floors above, of 600 m2 each"
    if apiece and reading.words(index - 1, index + 1) == ("above", "ground"):
        index -= 2
    if reading.word(index) not in FLOOR_WORDS:
        return False
    plural = reading.plural(index) or _many_before(reading, index)
    linked = reading.word(index + 1) in _LINKS or apiece
    each = any(word in ("each", "every", "per", "all") for word in before)
    return (plural or each or apiece) and linked


def _of_both(reading: Reading, measure: Measure) -> bool:
    """Whether an area is said of two storeys that stand before it: "ground floor and cellar, both circa 200 m2"."""
    index = measure.first - 1
    while is_filler(reading, index) and index > 0:
        index -= 1
    if reading.word(index) != "both":
        return False
    index -= 1 + (reading.word(index - 1) == ",")
    return reading.word(index) in FLOOR_WORDS | {"cellar", "basement"}


_AMOUNTING = frozenset({"come", "amount", "to"})
"""Verbs between a storey and its area: "each level should come to roughly 60 m2"."""


def _for_each_storey(reading: Reading, measure: Measure) -> bool:
    """Whether an area is said of each storey: "each floor 560 m2", "one floor is 330 m2", "gross 350 m2 per storey"."""
    after = words_after(reading, measure, 3)
    if (
        after[:1] in (["per"], ["by"])
        and after[1:2]
        and after[1] in FLOOR_WORDS
        and not reading.plural(measure.last + 1)
    ):
        return True
    index = measure.first - 1
    while index > 0 and reading.word(index) in (FILLERS | _AMOUNTING) - {"floor", "each", "every", "with"}:
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
    words = words_after(reading, measure, 8)
    if words[:1] not in (["on"], ["for"], ["to"]) or words[1:3] != ["each", "of"]:
        return False
    rest = [word for word in words[3:] if word not in ("the", "its", "our", "their", "these", "all")]
    number = measure.last + len(words) - len(rest)
    return bool(rest) and rest[reading.kind(number) == "number" :][:1] in [[word] for word in FLOOR_WORDS]


def _many_before(reading: Reading, index: int) -> bool:
    return any(reading.kind(i) == "number" and reading.value(i) > 1 for i in range(index - 3, index))
