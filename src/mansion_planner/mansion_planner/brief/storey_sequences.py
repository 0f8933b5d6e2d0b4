"""Read storeys that the order of a brief tells: "one down", "the floor above", "then", "the rest"."""

from collections.abc import Iterator
from dataclasses import replace

from mansion_planner.brief.facts import FloorRef
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading
from mansion_planner.brief.storey_counts import CLOSERS

__all__ = ["StoreySequence", "other_storeys", "resolve_rest"]

_UP = frozenset({"up", "above", "higher", "upward", "upwards"})
_DOWN = frozenset({"down", "below", "lower", "beneath", "under", "downward", "downwards"})
_THAT = frozenset({"that", "this", "it", "these", "those", "them", "which"})
_PLACED = frozenset("ground top upper lower next first last other every each all any middle bottom entrance".split())
"""Words that tell a storey by themselves, whatever stands after it."""
_OPENERS = frozenset({",", ":", ";", "and", "then", "-", "–", "("})
_MORE = frozenset({"also", "likewise", "too", "additionally", "further", "furthermore"})


_JOINS = frozenset({"to", "through", "until", "up", "-", "–", "and", ",", "&"})
"""Words between the ordinals of several storeys."""


class StoreySequence:
    """Follows a brief from storey to storey.

    Attributes
    ----------
    direction : int
        1 where the brief goes upwards, -1 downwards, 0 where it has not said.
    """

    def __init__(self, reading: Reading) -> None:
        self.reading = reading
        self.direction = 0
        self.numbered: FloorRef | None = None

    def read(self, index: int, base: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read a storey that is told from `base`, the storey named before it.

        Returns
        -------
        tuple of (list of FloorRef, int), optional
            What is meant, and the token after it.
        """
        return (
            self._steps(index, base)
            or self._beyond(index, base)
            or self._then(index, base)
            or self._goes_on(index, base)
            or self._next_ordinal(index, base)
            or self._relative(index, base)
        )

    def _steps(self, index: int, base: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read "one down", "two floors up", "one flight higher"."""
        reading = self.reading
        value = reading.value(index)
        if reading.kind(index) != "number" or value != int(value) or not 1 <= value <= 9:
            return None
        last = index + 1
        storeyed = reading.word(last) in FLOOR_WORDS | {"flight"}
        last += storeyed
        last += reading.word(last) == "further"
        word = reading.word(last)
        told_from = reading.word(last + 1) in ("ground", "grade") or (
            reading.word(last + 1) == "the" and word not in ("up", "down", "higher", "lower")
        )
        if word not in (_UP | _DOWN) - {"under", "beneath"} or told_from:
            return None
        opens = reading.starts(index) or reading.word(index - 1) in _OPENERS
        if not (storeyed or (opens and base is not None)):
            return None
        if not storeyed and word in ("above", "below") and reading.word(last + 1) in ("ground", "grade"):
            return None
        last += 1 + (reading.word(last + 1) in _THAT and reading.word(last + 2) in CLOSERS)
        self.direction = 1 if word in _UP else -1
        return [_moved(base, self.direction * int(value))], last

    def _beyond(self, index: int, base: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read "below that", "above these" where they open a clause."""
        reading = self.reading
        word = reading.word(index)
        if word not in _UP | _DOWN or reading.word(index + 1) not in _THAT or base is None:
            return None
        opens = reading.starts(index) or (reading.word(index - 1) in (",", "and", ";") and reading.starts(index - 1))
        told = reading.word(index - 1) == "," and reading.word(index + 2) in ("the", "a", "an", "one", "two", "three")
        opens = opens or (told and reading.word(index + 1) in ("it", "that", "this"))
        if not opens or base.kind not in ("number", "range", "top", "below_top"):
            return None
        self.direction = 1 if word in _UP else -1
        return [_moved(base, self.direction)], index + 2

    def _then(self, index: int, base: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read "then" and "next" at the start of a sentence of a brief that goes up or down."""
        reading = self.reading
        rises = reading.word(index) == "then" and self._rises_to_top(index)
        if base is None or not ((self.direction and reading.starts(index)) or (rises and base.kind == "number")):
            return None
        self.direction = self.direction or 1
        if reading.word(index) not in ("then", "next") or reading.word(index + 1) in FLOOR_WORDS | {"to", "door"}:
            return None
        return [_moved(base, self.direction)], index + 1

    def _goes_on(self, index: int, base: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read the numbers in "Storeys 1-2 a lobby, 3-11 four rooms each, 12 a bar", each above the one before."""
        reading = self.reading
        base = base if base is not None and base.kind in ("number", "range") else self.numbered
        if base is None or reading.kind(index) != "number" or reading.word(index - 1) not in (",", ";"):
            return None
        floors = int(reading.facts.floors[0].value) if reading.facts.floors else 0
        first, last = int(reading.value(index)), index + 1
        if first != base.last + 1 or first > floors or not self._is_headed_by_numbers(index):
            return None
        if reading.word(last) in ("-", "–", "to") and reading.kind(last + 1) == "number":
            top = int(reading.value(last + 1))
            self.numbered = FloorRef("range", first, top)
            return ([self.numbered], last + 2) if first < top <= floors else None
        counts = not reading.word(index).isdigit() or reading.plural(last) or reading.plural(last + 1)
        return ([FloorRef("number", first, first)], last) if first == floors and not counts else None

    def _next_ordinal(self, index: int, base: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read "third is the library" after "the second has two offices", in a brief of three storeys or more."""
        reading = self.reading
        floors = int(reading.facts.floors[0].value) if reading.facts.floors else 0
        opens = reading.kind(index) == "ordinal" and reading.starts(index) and index not in reading.taken
        if base is None or base.kind != "number" or not opens or reading.word(index + 1) in FLOOR_WORDS:
            return None
        if reading.word(index + 1) in _JOINS and "ordinal" in (reading.kind(index + 2), reading.kind(index + 3)):
            return None  # "Second to fourth floor: ..."
        value = int(reading.value(index))
        follows = value == base.last + 1 and value <= floors
        return ([FloorRef("number", value, value)], index + 1) if follows else None

    def _is_headed_by_numbers(self, index: int) -> bool:
        """Whether the sentence opens with storeys in numbers: "Storeys 1-2 ..."."""
        reading = self.reading
        first = index
        while first > 0 and not reading.starts(first):
            first -= 1
        return reading.word(first) in FLOOR_WORDS and reading.kind(first + 1) == "number"

    def _rises_to_top(self, index: int) -> bool:
        """Whether a list goes up to what is on top: "below a shop, then two flats, and a studio on top"."""
        reading = self.reading
        if reading.word(index - 1) not in (",", ";", "and") or self.direction < 0:
            return False
        end = index
        while end < len(reading.tokens) and reading.sentence[end] == reading.sentence[index]:
            end += 1
        words = reading.words(index, end)
        return any(pair == ("on", "top") and after not in ("of",) for pair, after in _pairs(words))

    def _relative(self, index: int, previous: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read "one flight up", "next storey up", "the floor above", "the one below", "two below the top"."""
        reading = self.reading
        word = reading.word(index)
        if word == "penultimate" or reading.words(index, index + 3) == ("second", "to", "last"):
            last = index + (1 if word == "penultimate" else 3)
            return [FloorRef("below_top", 1)], last + (reading.word(last) in FLOOR_WORDS)
        if reading.kind(index) == "number" and reading.words(index + 1, index + 4) == ("below", "the", "top"):
            return [FloorRef("below_top", int(reading.value(index)))], index + 4
        base = previous
        if base is None or base.kind not in ("number", "range", "top", "below_top"):
            base = FloorRef("number", 1, 1)
        if self._is_same_again(index):
            return [replace(previous) if previous is not None else base], index + 2
        if word in ("up", "down") and reading.word(index + 1) == "there" and previous is not None:
            return [replace(previous)], index + 2
        if up := self._flights(index):
            return [FloorRef("number", 1 + up, 1 + up)], index + 3
        if (
            word in ("next",)
            and reading.word(index + 1) in FLOOR_WORDS
            and reading.word(index + 2) in ("up", *CLOSERS, "above")
        ):
            return [FloorRef("number", base.last + 1, base.last + 1)], index + 2 + (
                reading.word(index + 2) in ("up", "above")
            )
        return self._beside(index, base, previous)

    def _flights(self, index: int) -> int:
        """Return how many flights of stairs "two flights up" or "up one flight" at a token tells of, or 0."""
        reading = self.reading
        at = index + (reading.word(index) == "up")
        other = index + 2 if at == index else index
        told = reading.kind(at) == "number" and reading.word(at + 1) == "flight" and reading.word(other) == "up"
        return int(reading.value(at)) if told and 0 < reading.value(at) < 20 else 0

    def _is_same_again(self, index: int) -> bool:
        """Whether "same floor" is that of what was told before: "Also a toilet, at same floor"."""
        reading = self.reading
        if reading.word(index) != "same" or reading.word(index + 1) not in FLOOR_WORDS:
            return False
        first = index
        while not reading.starts(first):
            first -= 1
        led = not {"on", "at", "in"}.isdisjoint(reading.words(index - 2, index))
        more = not _MORE.isdisjoint(reading.words(first, index))
        return led and more and reading.word(index + 2) in CLOSERS

    def _beside(self, index: int, base: FloorRef, previous: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read "the floor above", "the one just under the top", "a sleeping storey over it"."""
        reading = self.reading
        noun = index
        if reading.kind(index) == "word" and reading.word(index + 1) in FLOOR_WORDS:
            noun = index + (reading.word(index) not in _PLACED)
        lead = reading.word(index - 1)
        led = lead in ("the", "a") if noun > index else lead == "the"
        at = noun + 1
        at += reading.word(at) in ("just", "right", "directly", "immediately")
        word = reading.word(at)
        if reading.word(noun) not in FLOOR_WORDS | {"one"} or reading.plural(noun):
            return None
        if word not in ("above", "over", "below", "under", "beneath", "underneath"):
            return None
        heads = reading.starts(index) and (reading.word(at + 1) in (":", "=", "-") or noun > index)
        if not (led or heads) or (word != "above" and noun > index and reading.word(at + 1) not in _THAT):
            return None
        up, last = word in ("above", "over"), at + 1
        if reading.words(last, last + 2) in (("the", "ground"), ("ground", "level"), ("the", "street")):
            return None
        if not up and reading.words(last, last + 2) == ("the", "top"):
            return [FloorRef("below_top", 1)], last + 2 + (reading.word(last + 2) in FLOOR_WORDS | {"one"})
        if reading.word(last) in ("it", "that", "this"):
            last += 1 + (reading.word(last + 1) in FLOOR_WORDS | {"one"})
        if reading.word(noun) == "one" and previous is None:
            return None
        if base.kind in ("top", "below_top") and not up:
            return [FloorRef("below_top", base.first + 1 if base.kind == "below_top" else 1)], last
        number = base.last + (1 if up else -1)
        return [FloorRef("number", number, number)], last


def _moved(base: FloorRef | None, steps: int) -> FloorRef:
    """Return the storey some steps above a reference (below, where `steps` is negative); one below the ground is 0."""
    if base is None or base.kind not in ("number", "range", "top", "below_top", "basement"):
        base = FloorRef("number", 1, 1)
    if base.kind in ("top", "below_top"):
        below = (0 if base.kind == "top" else base.first) - steps
        return FloorRef("below_top", below) if below > 0 else FloorRef("top")
    if base.kind == "basement":
        return FloorRef("number", steps, steps) if steps > 0 else FloorRef("basement")
    number = (base.last if steps > 0 else base.first) + steps
    return FloorRef("number", number, number) if number >= 1 else FloorRef("basement")


def _pairs(words: tuple[str, ...]) -> Iterator[tuple[tuple[str, str], str]]:
    """Yield every two words that stand side by side, and the one after them."""
    for first, second, after in zip(words, words[1:], (*words[2:], "")):
        yield (first, second), after


def other_storeys(refs: tuple[FloorRef, ...], storeys: int) -> tuple[FloorRef, ...]:
    """Return the storeys that references leave out, of `storeys` above the ground; none where that is not known."""
    named: set[int] = set()
    for ref in refs:
        if ref.kind in ("number", "range"):
            named.update(range(ref.first, ref.last + 1))
        elif ref.kind in ("odd", "even"):
            named.update(range(1 if ref.kind == "odd" else 2, storeys + 1, 2))
        elif ref.kind == "top":
            named.update(range(storeys - max(ref.first, 1) + 1, storeys + 1))
        else:
            return ()
    return tuple(FloorRef("number", n, n, refs[0].span) for n in range(1, storeys + 1) if n not in named)


def resolve_rest(places: list[Place], storeys: int) -> list[Place]:
    """Replace "the rest" by the storeys that no other place names.

    Parameters
    ----------
    storeys : int
        Storeys above the ground, 0 where the brief does not say.
    """
    if not any(place.refs[0].kind == "rest" for place in places):
        return places
    named: set[int] = set()
    for place in places:
        for ref in place.refs:
            if ref.kind in ("number", "range"):
                named.update(range(ref.first, ref.last + 1))
            elif ref.kind == "top" and storeys:
                named.update(range(storeys - max(ref.first, 1) + 1, storeys + 1))
            elif ref.kind == "below_top" and storeys:
                named.add(storeys - ref.first)
    result = []
    for place in places:
        span = place.refs[0].span
        if place.refs[0].kind == "rest":
            left = [n for n in range(1, storeys + 1) if n not in named]
            refs = tuple(FloorRef("number", n, n, span) for n in left) or (FloorRef("upper", span=span),)
            result.append(replace(place, refs=refs))
        else:
            result.append(place)
    return result
