"""Read sets of storeys told from another one: "each of the four floors above", "all levels over the ground floor"."""

from mansion_planner.brief.facts import FloorRef, Quantity
from mansion_planner.brief.named_storeys import NamedStoreys
from mansion_planner.brief.numbered_storeys import NumberedStoreys
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.storey_counts import ANAPHORS, DEFINITE, STOREY_ADJECTIVES

__all__ = ["RelativeStoreys"]

_EACH = frozenset({"each", "every", "all", "both", "any"})
_FURTHER = frozenset({"other", "upper", "further", "remaining", "higher", "following", "next"})
_THERE_ARE = frozenset(": there is are come lie sit rise follow just only we i want have need also another".split())
"""Words between "above the ground floor" and what is there."""
_GOING_ON = frozenset("i we you he she they there is are come lie sit , : a an".split())
"""What follows "over the shop" where that opens a clause about the storey above."""
_AFTER_NUMBER = frozenset({"x", "no", "nos", ",", ")"})
"""What follows the number of storeys in a bracket behind them."""
_ABOVE = (
    ("further", "up"),
    ("higher", "up"),
    ("on", "top"),
    ("above",),
    ("over",),
    ("overhead",),
    ("upward",),
    ("up",),
)
_STREET = frozenset({"ground", "street", "grade", "lobby", "entrance"})


class RelativeStoreys:
    """Reads such sets; `named` and `numbered` read the storey that they are told from."""

    def __init__(self, reading: Reading, named: NamedStoreys, numbered: NumberedStoreys) -> None:
        self.reading, self.named, self.numbered = reading, named, numbered

    def read(self, index: int, previous: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Return the storeys meant at a token and the token after them; `previous` is the storey named last."""
        reading = self.reading
        opening = self._headed(index, previous) or self._beyond_storey(index) or self._beyond_room(index, previous)
        if opening is not None:
            return opening
        each = reading.word(index) in _EACH
        if not each and reading.word(index - 1) not in DEFINITE:
            return None
        at = index + each
        at += each and reading.word(at) == "one"
        at += reading.word(at) == "of"
        at += reading.word(at) in ("the", "its", "our", "these", "those")
        upper, at = self._adjectives(at)
        many = int(reading.value(at)) if reading.kind(at) == "number" and 1 < reading.value(at) < 200 else 0
        at += bool(many)
        more, at = self._adjectives(at)
        if reading.word(at) not in FLOOR_WORDS or not (each or many):
            return None
        told = self._told_from(at + 1, previous)
        if told is None:
            return ([self.upper(many, at)], at + 1) if each and many and (upper or more) else None
        base, last = told
        floors = int(reading.facts.floors[0].value) if reading.facts.floors else 0
        if not many:
            ranged = FloorRef("range", base + 1, floors) if base < floors else None
            return None if ranged is None and base != 1 else ([ranged or FloorRef("upper")], last)
        return [self.stacked(many, FloorRef("number", base, base), at)], last

    def _headed(self, index: int, previous: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read "Floors above: ..." and "Storeys above (8 no., all alike): ..." where they head a list."""
        reading = self.reading
        if reading.word(index) not in FLOOR_WORDS or not reading.plural(index) or not reading.starts(index):
            return None
        told = self._told_from(index + 1, previous)
        if told is None or reading.word(told[1]) not in (":", "=", "("):
            return None
        many = self.bracketed_number(told[1])
        below = FloorRef("number", told[0], told[0])
        return [self.stacked(many, below, index) if many else self._all_above(told[0])], told[1]

    def _beyond_storey(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "Above the ground floor there is one more floor with ..." and "over the first floor are two offices"."""
        reading = self.reading
        bare = reading.word(index + 1) in ANAPHORS or not self._opens_clause(index)
        told = None if bare or reading.word(index) not in ("above", "over") else self._told_from(index, None)
        if told is None or told[1] < index + 3:
            return None
        base, last = told
        at = last
        while reading.word(at) in _THERE_ARE and at - last < 6:
            at += 1
        counted = reading.kind(at) == "number" and 0 < reading.value(at) < 200
        _, noun = self._adjectives(at + 1)
        if counted and reading.word(noun) in FLOOR_WORDS:
            return [self.stacked(int(reading.value(at)), FloorRef("number", base, base), at)], noun + 1
        return [self._all_above(base)], last

    def _beyond_room(self, index: int, previous: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read "Over the shop I live myself: ..." after a brief has told a storey and what is on it."""
        reading = self.reading
        if reading.word(index) not in ("above", "over") or reading.word(index + 1) not in ("the", "our", "my"):
            return None
        mention = reading.mention_at.get(index + 2)
        if previous is None or previous.kind != "number" or not reading.starts(index) or mention is None:
            return None
        goes_on = reading.word(mention.last) in _GOING_ON or reading.kind(mention.last) == "number"
        if not (mention.room or mention.building) or not goes_on:
            return None
        return [self._all_above(previous.last)], mention.last

    def _opens_clause(self, index: int) -> bool:
        """Whether a clause begins at a token, and no storey stands right before it: "the first floor, above it"."""
        storey = self.reading.word(index - 2) in FLOOR_WORDS
        return self.reading.starts(index) or (self.reading.word(index - 1) in (",", "and", "–", "-") and not storey)

    def _all_above(self, base: int) -> FloorRef:
        """Return the storeys above one."""
        floors = self.reading.facts.floors
        top = int(floors[0].value) if floors else 0
        if base == 1:
            return FloorRef("upper")
        return FloorRef("range", base + 1, max(top, base + 1)) if base < top or not top else FloorRef("top")

    def bracketed_number(self, index: int) -> int:
        """Return the number of "(x4, identical)" and "(8 no., all alike)" at a token, or 0."""
        reading = self.reading
        at = index + 1 + (reading.word(index + 1) == "x")
        counts = reading.word(index) == "(" and reading.kind(at) == "number"
        closed = reading.word(at + 1) in _AFTER_NUMBER or reading.word(at + 1) in FLOOR_WORDS
        return int(reading.value(at)) if counts and closed and 0 < reading.value(at) < 200 else 0

    def upper(self, many: int, index: int) -> FloorRef:
        """Return so many upper storeys, whose noun is at a token; they imply one more below them.

        "The three upper floors" make four storeys where the brief does not say how many it has.
        """
        self.reading.implied_storeys.append(Quantity(float(many + 1), self.reading.span(index, index + 1)))
        return FloorRef("top", many, many)

    def stacked(self, many: int, below: FloorRef | None, index: int, *, capped: bool = False) -> FloorRef:
        """Return so many storeys above another one, the uppermost ones where the brief does not have as many above it.

        Parameters
        ----------
        index : int
            Token of their noun.
        capped : bool
            One more storey lies on top of them.
        """
        floors, base = self.reading.facts.floors, self._number_of(below)
        if floors and base + many > floors[0].value > many:
            base = int(floors[0].value) - many
        total = Quantity(float(base + many + capped), self.reading.span(index, index + 1))
        self.reading.implied_storeys.append(total)
        return FloorRef("range", base + 1, base + many)

    def _adjectives(self, index: int) -> tuple[bool, int]:
        """Return whether words tell storeys from the lowest, and the token after all their adjectives."""
        upper = False
        while self.reading.word(index) in _FURTHER | STOREY_ADJECTIVES:
            upper = upper or self.reading.word(index) in ("upper", "further", "higher")
            index += 1
        return upper, index

    def _told_from(self, index: int, previous: FloorRef | None) -> tuple[int, int] | None:
        """Return the number of the storey below the set, and the token after the words that tell it."""
        reading = self.reading
        above = next((words for words in _ABOVE if reading.words(index, index + len(words)) == words), None)
        if above is None:
            return None
        last = index + len(above)
        if reading.kind(last) == "number" and above in (("over",), ("above",), ("up",)):
            nouns = reading.words(last + 1, last + 3)
            if reading.kind(last + 1) == "unit" or nouns[:1] == ("x",):
                return None  # "each of the floors above 300 m2"
        last += above == ("on", "top") and reading.word(last) == "of"
        if reading.word(last) in ANAPHORS:
            return self._number_of(previous), last + 1
        at = last + (reading.word(last) in ("the", "our"))
        for read in (self.named.ground, self.numbered.level, self.numbered.numbered, self.numbered.ordinal):
            found = read(at)
            if found is not None and found[0][-1].kind in ("number", "range"):
                return found[0][-1].last, found[1]
        if reading.kind(at) == "ordinal" and at > last:
            return int(reading.value(at)) + int(self.numbered.british), at + 1  # "all floors above the first"
        if at == last and reading.word(at) in ("ground", "grade"):
            return 0, at + 1  # "each of the three floors above ground"
        if at > last and reading.word(at) in _STREET:
            return 1, at + 1 + (reading.word(at + 1) in FLOOR_WORDS)
        return self._number_of(previous), last

    def _number_of(self, previous: FloorRef | None) -> int:
        numbered = previous is not None and previous.kind in ("number", "range")
        return previous.last if previous is not None and numbered else 1
