"""Read storeys that a brief names by a word for their place alone: "Lower: ...", "the last one", "in between"."""

from mansion_planner.brief.facts import FloorRef, Quantity
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.storey_counts import CLOSERS, STOREY_ADJECTIVES

__all__ = ["EllipticStoreys"]

_GROUND = FloorRef("number", 1, 1)
_EDGES = {
    **dict.fromkeys(("ground", "lower", "lowest", "bottom", "bottommost", "lowermost", "entrance"), _GROUND),
    **dict.fromkeys(("top", "uppermost", "topmost", "highest", "last"), FloorRef("top")),
    "upper": FloorRef("upper"),
    "middle": FloorRef("middle"),
}
_SUPERLATIVES = frozenset("lowest bottommost lowermost uppermost topmost highest".split())
_TITLE = 4
"""Words of a title before a storey, at most."""
_VERBS = frozenset(
    """
    is are be has have hold contain house carry take get keep go stay belong comprise accommodate offer include feature
    """.split()
)
_OPENS_LIST = frozenset({"a", "an", "the", "there", "with", "for", "we", "our", "my", "only", "just"})
_PLACING = frozenset({"take", "occupy", "fill", "share", "on", "in", "at", "to"})
_ARRIVING = frozenset({"arrive", "enter", "come", "walk", "step"})
_BETWEEN = frozenset({"between", "in-between"})
_BOTH = frozenset({"them", "these", "those", "both", "the"})


class EllipticStoreys:
    """Reads such storeys: each method returns what is meant at a token and the token after it, if anything.

    Parameters
    ----------
    has_floors : bool
        The brief has a word for storeys; else such words speak of something else.
    """

    def __init__(self, reading: Reading, *, has_floors: bool) -> None:
        self.reading, self.has_floors = reading, has_floors
        self.basement = not {"basement", "cellar"}.isdisjoint(token.text for token in reading.tokens)

    def read(self, index: int, previous: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read a storey at a token; `previous` is the one named last."""
        if not self.has_floors:
            return None
        return (
            self._from_top(index, previous)
            or self._first_of(index, previous)
            or self._next(index, previous)
            or self._edge(index)
            or self._ordinal(index)
            or self._further_ordinal(index, previous)
            or self._entered(index)
            or self._between(index, previous)
        )

    def _edge(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "Lower: ...", "the last one has ...", "on the uppermost a dome", "take the upper one"."""
        reading = self.reading
        ref = _EDGES.get(reading.word(index))
        if ref is None or index in reading.mention_at:
            return None
        one = reading.word(index + 1) == "one"
        last = index + 1 + one
        of_them = reading.words(index + 1, index + 3) == ("of", "the") and reading.value(index + 3) in (2.0, 3.0)
        if of_them and reading.word(index + 4) in FLOOR_WORDS and reading.word(index - 1) == "the":
            return [ref], index + 5  # "on the lower of the two floors"
        if reading.starts(index) and (reading.word(last) in (":", "=") or (reading.word(last) == "-" and not one)):
            return [ref], last
        if reading.word(index) in _SUPERLATIVES and reading.word(last) == ":" and self._follows_title(index):
            return [ref], last
        if one and reading.word(last) == ":" and reading.word(index - 1) == ",":
            return [ref], last
        lead = index - 1 - (reading.word(index - 1) == "very")
        if reading.word(lead) != "the":
            return None
        if not one and reading.word(index) not in _SUPERLATIVES:
            return None
        opens = reading.starts(lead) or reading.word(lead - 1) in (",", "and", ";", ":", "while", "but", "–", "-")
        following = reading.word(last)
        goes_on = following in _VERBS | _OPENS_LIST | {":", ","} or reading.kind(last) == "number"
        placed = reading.word(lead - 1) in _PLACING
        if (opens and goes_on and following != ",") or (placed and (goes_on or following in CLOSERS | {"and"})):
            return [ref], last
        return None

    def _follows_title(self, index: int) -> bool:
        """Whether only a title of what a storey is for stands before a token: "Quiet functions topmost: ..."."""
        first = index
        while not self.reading.starts(first) and self.reading.kind(first - 1) == "word" and index - first < _TITLE:
            first -= 1
        return first < index and self.reading.starts(first)

    def _ordinal(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "first one: ...", "they take the second."; storeys that count from the ground are no concern here."""
        reading = self.reading
        value = reading.value(index)
        if reading.kind(index) != "ordinal" or not 1 <= value <= 40 or value != int(value):
            return None
        one = reading.word(index + 1) == "one"
        if one and (reading.starts(index) or reading.word(index - 1) == ",") and reading.word(index + 2) == ":":
            return [FloorRef("number", int(value), int(value))], index + 2
        taken = reading.word(index - 1) == "the" and reading.word(index - 2) in ("take", "occupy", "fill")
        if taken and reading.word(index + 1) in CLOSERS and self._after_storey(index):
            return [FloorRef("number", int(value), int(value))], index + 1
        return None

    def _further_ordinal(self, index: int, previous: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read "the second storey has a cold room and the third an instrument room"."""
        reading = self.reading
        value = reading.value(index)
        if reading.kind(index) != "ordinal" or previous is None or previous.kind not in ("number", "range"):
            return None
        led = reading.word(index - 1) == "the" and reading.word(index - 2) in (",", "and", ";")
        room = reading.word(index + 1) in ("a", "an") or reading.kind(index + 1) == "number"
        if not (led and room) or value != previous.last + 1 or not self._after_storey(index):
            return None
        return [FloorRef("number", int(value), int(value))], index + 1

    def _first_of(self, index: int, previous: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read "the two floors on top hold, first, ..., then, at the very top, ...": the lower of them."""
        reading = self.reading
        ranged = previous is not None and previous.kind == "range" and previous.last > previous.first
        alone = reading.word(index + 1) == "," and reading.word(index - 1) in (",", ":")
        if previous is None or not ranged or reading.word(index) != "first" or not alone:
            return None
        return [FloorRef("number", previous.first, previous.first)], index + 1

    def _next(self, index: int, previous: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read "three guest rooms on the next;", "the next one: ...": the storey above the one named last."""
        reading = self.reading
        if reading.word(index) != "next" or reading.word(index - 1) != "the" or previous is None:
            return None
        last = index + 1 + (reading.word(index + 1) == "one")
        placed = reading.word(index - 2) == "on" and reading.word(last) in CLOSERS | {"and"}
        heads = reading.starts(index - 1) and reading.word(last) == ":"
        if not (placed or heads) or previous.kind not in ("number", "range"):
            return None
        return [FloorRef("number", previous.last + 1, previous.last + 1)], last

    def _from_top(self, index: int, previous: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read "counting from the top: ... on the first, ... on the next, ... on the one after that"."""
        reading = self.reading
        if not self._counts_down(index) or reading.word(index - 1) != "the" or reading.word(index - 2) != "on":
            return None
        value = reading.value(index)
        if reading.kind(index) == "ordinal" and 1 <= value <= 40:
            last = index + 1 + (reading.word(index + 1) in FLOOR_WORDS | {"one"})
            return [FloorRef("top") if value == 1 else FloorRef("below_top", int(value) - 1)], last
        further = previous is not None and previous.kind in ("top", "below_top")
        following = reading.word(index) == "next" or reading.words(index, index + 2) == ("one", "after")
        if previous is None or not (further and following):
            return None
        last = index + 1 + (reading.word(index + 1) in FLOOR_WORDS | {"one", "after"})
        last += reading.word(last) in ("that", "it")
        return [FloorRef("below_top", (0 if previous.kind == "top" else previous.first) + 1)], last

    def _counts_down(self, index: int) -> bool:
        """Whether the sentence of a token counts storeys from the top."""
        reading, at = self.reading, index
        while at > 2 and reading.sentence[at] == reading.sentence[index] and index - at < 60:
            if reading.words(at - 2, at + 1) == ("from", "the", "top"):
                return reading.word(at - 3) in ("counting", "counted", "numbered", "numbering", "down", "starting")
            at -= 1
        return False

    def _after_storey(self, index: int) -> bool:
        """Whether a storey with a noun stands before a token in its sentence or in the one before."""
        reading = self.reading
        at = index - 1
        while at >= 0 and reading.sentence[index] - reading.sentence[at] <= 1:
            if reading.word(at) in FLOOR_WORDS:
                return True
            at -= 1
        return False

    def _entered(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "the storey you arrive on", "the floor where visitors come in"."""
        reading = self.reading
        if reading.word(index) not in FLOOR_WORDS or reading.plural(index) or reading.word(index - 1) != "the":
            return None
        at = index + 1
        while reading.word(at) in ("where", "that", "which", "on", "at", "through", "by"):
            at += 1
        if reading.kind(at) != "word" or reading.word(at + 1) not in _ARRIVING:
            return None
        at += 2
        while reading.word(at) in ("in", "on", "at", "from", "into", "through", "by", "first"):
            at += 1
        return [_GROUND], at

    def _between(self, index: int, previous: FloorRef | None) -> tuple[list[FloorRef], int] | None:
        """Read "between them a storey with ...", "in between come two floors", "the storey in between"."""
        reading = self.reading
        opens = reading.words(index, index + 2) == ("in", "between") and reading.starts(index)
        if opens or (reading.word(index) in _BETWEEN and reading.word(index + 1) in _BOTH):
            at = index + 2 + (not opens and reading.word(index + 2) in ("two", "both"))
            while reading.word(at) in _THERE_ARE and at - index < 6:
                at += 1
            counted = reading.kind(at) == "number"
            if reading.word(at) in ("a", "one", "the") or counted:
                storeyed = at + 1
                while reading.word(storeyed) in STOREY_ADJECTIVES | {"single", "middle"} and storeyed - at < 4:
                    storeyed += 1
                if reading.word(storeyed) in FLOOR_WORDS:
                    many = reading.value(at) if counted and reading.plural(storeyed) else 0.0
                    return [self._middle(int(many), previous)], storeyed + 1
        if reading.word(index) in FLOOR_WORDS | {"one"} and reading.word(index - 1) in ("the", "a"):
            at = index + 1 + (reading.word(index + 1) == "in")
            if reading.word(at) == "between" and reading.word(at + 1) in CLOSERS | _VERBS | {"with", "them", "these"}:
                return [FloorRef("middle")], at + 1 + (reading.word(at + 1) in ("them", "these"))
        if opens and reading.word(index + 2) in (":", ",", "="):
            return [FloorRef("middle")], index + 2
        return None

    def _middle(self, many: int, previous: FloorRef | None) -> FloorRef:
        """Return so many storeys between the ground floor and the top one, or all of these where no number is told."""
        if not many:
            return FloorRef("middle")
        below = previous.last if previous is not None and previous.kind == "number" and previous.last > 0 else 1
        floors = self.reading.facts.floors
        if previous is not None and previous.kind == "top":
            self.reading.implied_storeys.append(Quantity(float(below + many + 1), previous.span))
        high = floors and below == floors[0].value  # the top storey was named last
        return FloorRef("range", 2, many + 1) if high else FloorRef("range", below + 1, below + many)


_THERE_ARE = frozenset({",", "is", "are", "lie", "come", "there", "we", "have", "sit"})
"""Words between "between them" and the storeys that are meant."""
