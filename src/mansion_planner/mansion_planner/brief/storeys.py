"""Read which storeys a brief speaks of.

A storey is named absolutely ("the third floor", "L3", "levels 2 to 6"), from above ("the top floor", "two below the
top"), as a set ("every floor", "all but the last") or from the storey named before ("the seven storeys above").
"""

from dataclasses import replace
from itertools import pairwise

from mansion_planner.brief.elliptic_storeys import EllipticStoreys
from mansion_planner.brief.facts import FloorRef, Quantity
from mansion_planner.brief.implied_storeys import named_of_tower
from mansion_planner.brief.named_storeys import COPULAS, TOPS, NamedStoreys
from mansion_planner.brief.numbered_storeys import NumberedStoreys
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading
from mansion_planner.brief.relative_storeys import RelativeStoreys
from mansion_planner.brief.storey_counts import (
    CLOSERS,
    DEFINITE,
    STOREY_ADJECTIVES,
    UPSTAIRS,
    StoreyCounts,
    settle_counts,
)
from mansion_planner.brief.storey_forms import ABOVE_GROUND
from mansion_planner.brief.storey_sequences import StoreySequence, resolve_rest

__all__ = ["read_storeys"]

_PREPOSITIONS = frozenset(
    """
    on in at to across throughout occupying for over from under
    """.split()
)


def read_storeys(reading: Reading) -> list[Place]:
    """Record the numbers of storeys and basements; return the references to storeys from left to right."""
    scanner = _Scanner(reading)
    scanner.scan()
    if not reading.facts.floors and reading.implied_storeys:
        reading.facts.floors.append(max(reading.implied_storeys, key=lambda quantity: quantity.value))
    if not reading.facts.floors and (named := named_of_tower(reading, scanner.places)) is not None:
        reading.facts.floors.append(named)
    settle_counts(reading)
    floors = int(reading.facts.floors[0].value) if reading.facts.floors else 0
    places = [_with_edges(reading, place) if place.last > place.first else place for place in scanner.places]
    places = _below_the_top(reading, _narrowed(reading, places))
    if _ground_has_others(reading):
        places = [_above_the_ground(place) for place in places]
    return resolve_rest(places, floors)


_LIVED_IN = frozenset({"tenant", "guest", "bedroom", "patient", "student", "ward", "dormitory"})
"""Words before "floor" for those above the entrance: "every tenant floor has two meeting rooms"."""

_MAY = frozenset({"can", "may", "could", "might"})
"""Verbs of what is left open: one storey or the other, and not both."""


def _ground_has_others(reading: Reading) -> bool:
    """Whether the ground floor holds something "instead": what is on every floor is then on the others."""
    words = [token.text for token in reading.tokens]
    return any(
        words[at : at + 1] == ["ground"] and "instead" in words[at + 1 : at + 6] and "of" not in words[at + 1 : at + 7]
        for at in range(len(words))
    )


def _above_the_ground(place: Place) -> Place:
    if len(place.refs) != 1 or place.refs[0].kind != "every":
        return place
    return replace(place, refs=(replace(place.refs[0], kind="upper"),))


def _narrowed(reading: Reading, places: list[Place]) -> list[Place]:
    """Read "by floor from 2nd to 4th" and "on each floor, levels 2 to 6" as each of those storeys."""
    found: list[Place] = []
    for place in places:
        before = found[-1] if found else None
        if before is not None and _is_apposed(reading, before, place):
            found[-1] = replace(before, last=place.last)
            reading.take(before.first, place.last)
            continue
        several = len(place.refs) > 1 or place.refs[0].kind == "range"
        if before is not None and before.refs[0].kind == "every" and several:
            gap = reading.words(before.last, place.first)
            if gap in ((), ("from",), (",",), ("(",)) and not place.heading:
                found[-1] = replace(before, refs=place.refs, last=place.last)
                reading.take(before.first, place.last)
                continue
        found.append(place)
    return found


def _is_apposed(reading: Reading, before: Place, place: Place) -> bool:
    """Whether a storey only tells where the one before lies: "on the first floor, so directly above ground floor"."""
    end = reading.appositive(before.last)
    closing = reading.word(place.last)
    return 0 < place.first - end + 1 <= 2 and end > before.last and (closing in CLOSERS or closing in COPULAS)


def _below_the_top(reading: Reading, places: list[Place]) -> list[Place]:
    """Read one upper storey beside a top one as the one between: "EG: shop. OG: flat. DG: studio"."""
    kinds = {ref.kind for place in places for ref in place.refs}
    if "middle" in kinds and "top" not in kinds:
        return [_as_top(reading, place) for place in places]
    stated = reading.facts.floors and reading.facts.floors[0].value != 3
    if stated or not {"upper", "top"} <= kinds <= {"upper", "top", "basement", "number"}:
        return places
    if any(ref.kind == "number" and ref.last > 1 for place in places for ref in place.refs):
        return places

    def is_one(place: Place) -> bool:
        each = not {"each", "every"}.isdisjoint(reading.words(place.first, place.last))
        several = any(reading.plural(i) and reading.word(i) in FLOOR_WORDS for i in range(place.first, place.last))
        return place.refs[0].kind == "upper" and not place.refs[0].first and not each and not several

    return [replace(place, refs=(replace(place.refs[0], first=1),)) if is_one(place) else place for place in places]


def _as_top(reading: Reading, place: Place) -> Place:
    """Return one upper storey beside a middle one as the top one: "Lowest: a shop. Middle: a hall. Upper: a bakery"."""
    several = any(reading.plural(at) for at in range(place.first, place.last))
    one = place.refs[0].kind == "upper" and not place.refs[0].first and reading.word(place.last - 1) in _UPPER_ONE
    if not one or several or len(place.refs) > 1:
        return place
    return replace(place, refs=(replace(place.refs[0], kind="top"),))


_UPPER_ONE = FLOOR_WORDS | {"upper", "one", ":", "="}
"""What ends the name of one upper storey; "upstairs" may be several."""


def _with_edges(reading: Reading, place: Place) -> Place:
    first = place.first
    while (
        reading.word(first - 1) in ("the", "its", "our", "very", "that", "a", "this") and first - 1 not in reading.taken
    ):
        first -= 1
    led = reading.word(first - 1) in _PREPOSITIONS and first - 1 not in reading.taken
    if led:
        first -= 1
    last = place.last
    if reading.words(last, last + 2) == (",", "the") and reading.word(last + 2) in TOPS | {"lowest"}:
        last += 3 * (reading.word(last + 3) == ",")  # "on the second floor, the highest, ten offices"
    if reading.word(last) == "(" and reading.word(last + 2) == ")" and reading.kind(last + 1) == "word":
        last += 3
    each = reading.words(last, last + 3) == (",", "each", ":") and not reading.starts(first)
    last = last if each else _after_remark(reading, last)  # "four flats on every floor, each: a bedroom"
    counted = reading.kind(last + 1) == "number" and reading.words(last + 2, last + 4) == ("of", "them")
    heading = (reading.word(last) in (":", "=") and not counted) or (
        reading.starts(first) and reading.word(last) in ("\n", "-")
    )
    reading.take(first, last)
    every = place.refs[0].kind == "every" and reading.kind(place.first - 1) in ("word", "number")
    return replace(place, first=first, last=last, led=led or every, heading=heading or place.heading)


def _after_remark(reading: Reading, index: int) -> int:
    """Return where "only" and "(8 no., all alike)" end that stand between storeys and a colon; or `index`."""
    last = index
    while not reading.breaks(last) and (
        reading.word(last) in _REMARKS or (reading.kind(last) == "number" and _is_bracketed(reading, index, last))
    ):
        if reading.word(last) == ")" and reading.word(last + 1) == "," and not _is_bracketed(reading, index, last):
            return index  # "on two floors (4 per floor), each: a bedroom"
        last += 1
    return last if reading.word(last) in (":", "=") else index


def _is_bracketed(reading: Reading, first: int, index: int) -> bool:
    """Whether a bracket is open at a token that opens at token `first` or later."""
    words = reading.words(first, index)
    return words.count("(") > words.count(")")


_ALIKE = frozenset({"same", "identical", "alike", "equal", "similar"})
_REMARKS = _ALIKE | frozenset("only alone typical all each both repeated x no nos . , ( ) storey floor level".split())
"""Words between storeys and the colon of their list that only tell how many they are, or that they are alike."""
_ALL_ALIKE = _ALIKE | frozenset("is are be all both the , exactly".split())
"""Words between storeys that are said to be alike and "each" of them."""

_HOLDS = frozenset("with having each : get take accommodate comprise include consist offer".split())
"""Words after a number of storeys that what they hold follows."""
_SAID_OF_BOTH = frozenset("is are be has have hold contain there each both we should must will need with same".split())
"""Words after two storeys that are told of together."""


class _Scanner:
    """Goes over the tokens once; knows the storey named last, which others are told from."""

    def __init__(self, reading: Reading) -> None:
        self.reading = reading
        self.places: list[Place] = []
        self.counts = StoreyCounts(reading, self.places)
        self.sequence = StoreySequence(reading)
        self.previous: FloorRef | None = None
        texts = [token.text for token in reading.tokens]
        self.has_floors = not FLOOR_WORDS.isdisjoint(texts) or "ground" in texts or "upstairs" in texts
        self.has_floors = self.has_floors or {"lower", "upper"} <= {
            token.text for token, after in pairwise(reading.tokens) if after.text == ":"
        }
        self.numbered = NumberedStoreys(reading, self.places, has_floors=self.has_floors)
        self.named = NamedStoreys(reading, has_floors=self.has_floors, british=self.numbered.british)
        self.elliptic = EllipticStoreys(reading, has_floors=self.has_floors)
        self.relative = RelativeStoreys(reading, self.named, self.numbered)

    def scan(self) -> None:
        """Find all counts and references."""
        index, end = 0, len(self.reading.tokens)
        while index < end:
            if index in self.reading.taken:
                index += 1
                continue
            last = self.counts.read(index, self.previous)
            if last > index:
                self.reading.take(index, last)
                self._counted_upper(index, last)
                index = last
                continue
            refs, last = self._reference(index)
            if refs:
                self._add(Place(index, last, refs, led=False))
                self.reading.take(index, last)
                self.previous = refs[-1]
                index = last
                continue
            index += 1

    def _counted_upper(self, index: int, last: int) -> None:
        """Read "2 upper floors with ..." as the place of what follows, besides the number of storeys that it gives."""
        holds = self.reading.word(last) in COPULAS | _HOLDS
        if self._holds_each(index, last):
            every = FloorRef("every", span=self.reading.span(index, last))
            self.places.append(Place(index, last, (every,), led=True))
        words = self.reading.words(index, last)
        typical = not {"typical", "identical", "residential"}.isdisjoint(words)
        typical = typical and any(ref.kind == "number" and ref.last == 1 for place in self.places for ref in place.refs)
        if ("upper" in words or typical) and holds:
            ref = FloorRef("upper", span=self.reading.span(index, last))
            self.places.append(Place(index, last, (ref,), led=False))

    def _holds_each(self, index: int, last: int) -> bool:
        """Whether "each" closes what storeys are said to hold: "two identical storeys with five offices each"."""
        reading = self.reading
        if reading.word(last) not in ("with", "of", "having") or reading.kind(last + 1) != "number":
            return False
        end = last + 1
        while not reading.breaks(end) and reading.word(end) not in ("each", "with", ","):
            end += 1
        noun = reading.kind(end - 1) == "word" and reading.plural(end - 1)
        closes = reading.breaks(end + 1) or reading.word(end + 1) in (",", ")")
        return reading.word(end) == "each" and noun and closes and end - last < 8

    def _add(self, place: Place) -> None:
        """Add a place, to the one before it where both are named together: "on floor 2 and on floor 3"."""
        before = self.places[-1] if self.places else None
        kinds = {ref.kind for ref in (*place.refs, *(before.refs if before is not None else ()))}
        together = before is not None and self._are_together(before, place)
        if before is not None and together and kinds == {"number"}:
            self.places[-1] = replace(before, last=place.last, refs=(*before.refs, *place.refs))
        else:
            self.places.append(place)

    def _are_together(self, before: Place, place: Place) -> bool:
        """Whether two places are named as one: "second floor and third floor have ...", "on floor 2 and on floor 3"."""
        reading = self.reading
        gap = reading.words(before.last, place.first)
        if gap == ("and", "on"):
            return True
        if gap == ("=",):
            return reading.word(_after_remark(reading, place.last)) in (":", ",", "=")  # "L01 = L02: ten offices"
        if gap not in (("and",), ("&",), ("and", "the")):
            return False
        first = before.first
        while reading.word(first - 1) in ("the", "on", "in", "at", "both") and not reading.breaks(first - 1):
            first -= 1
        subject = reading.starts(first) and reading.word(place.last) in _SAID_OF_BOTH | {":", ","}
        return subject or reading.breaks(place.last)

    def _reference(self, index: int) -> tuple[tuple[FloorRef, ...], int]:
        """Read a reference at `index`: what it means, and where it ends."""
        for read in (
            self.numbered.level,
            self.named.basement,
            self._rest,
            self._relative,
            self._counted_set,
            self._in_sequence,
            self._elliptic,
            self.named.ground,
            self.named.top,
            self.named.upper,
            self._set,
            self.numbered.numbered,
            self.numbered.ordinal,
            self.numbered.heading,
            self.numbered.bare_number,
        ):
            found = read(index)
            if found is not None:
                refs, last = found
                span = self.reading.span(index, last)
                return tuple(replace(ref, span=span) for ref in refs), last
        return (), index

    def _in_sequence(self, index: int) -> tuple[list[FloorRef], int] | None:
        return self.sequence.read(index, self.previous)

    def _elliptic(self, index: int) -> tuple[list[FloorRef], int] | None:
        return self.elliptic.read(index, self.previous)

    def _relative(self, index: int) -> tuple[list[FloorRef], int] | None:
        return self.relative.read(index, self.previous)

    def _rest(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "the rest", "all the others", "the remaining floors": the storeys that the brief does not name."""
        reading = self.reading
        word, last = reading.word(index), index + 1
        if word in ("rest", "others") or (word == "other" and reading.plural(index)):
            if reading.word(index - 1) != "the" or not self.has_floors or not self.places:
                return None
            if reading.words(last, last + 2) == ("of", "the"):
                if reading.word(last + 2) not in FLOOR_WORDS:
                    return None
                return [FloorRef("rest")], last + 3
            opens = reading.starts(index - 1) or reading.word(index - 2) in ("all", "and", ",")
            return ([FloorRef("rest")], last) if opens else None
        if word == "remaining" and reading.word(last) in FLOOR_WORDS and reading.plural(last):
            return [FloorRef("rest")], last + 1
        return None

    def _counted_set(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "top two floors", "first 3 floors", "the seven storeys above", "the other four levels"."""
        reading = self.reading
        word = reading.word(index)
        lead = word if word in DEFINITE - {"the", "these", "those", "both", "all"} else ""
        at = index + bool(lead)
        while reading.word(at) in ("upper", "top", "other", "first") and not lead:
            lead, at = reading.word(at), at + 1
        if reading.kind(at) != "number" or reading.tokens[at].value > 200:
            return None
        many, last = int(reading.value(at)), at + 1
        after = ""
        while reading.word(last) in STOREY_ADJECTIVES | {"upper", "lower", "top", "middle", "other"}:
            after, last = reading.word(last), last + 1
        if reading.word(last) in FLOOR_WORDS:
            last += 1
        elif not self._elliptic_set(index, at, last, lead):
            return None
        lead = lead or (after if after in ("upper", "lower", "top", "other", "middle") else "")
        definite = bool(lead) or reading.word(index - 1) in ("the", "these", "those", "other", "all", "both")
        if not definite:
            return None
        end = self._relative_end(last)
        if end > last and lead not in ("top", "first", "last", "upper"):
            base = self.previous.last if self.previous is not None and self.previous.kind in ("number", "range") else 1
            return [FloorRef("range", base + 1, base + many)], end
        return self._led_set(index, many, lead, last), max(last, end - 1)

    def _relative_end(self, last: int) -> int:
        """Return where "above" or "over that" end that stand behind counted storeys; `last` where they do not."""
        reading = self.reading
        trailing = reading.word(last)
        if trailing not in ("above", "over", "after", "higher", "up", "following", "upstairs", "on"):
            return last
        pronoun = reading.word(last + 1) in ("it", "that", "them", "this", "top", "these")
        return last + 1 + (pronoun and trailing in ("over", "after", "above", "on"))

    def _led_set(self, index: int, many: int, lead: str, last: int) -> list[FloorRef]:
        """Return the storeys that a number means by the word that leads it: "the top two", "the other four"."""
        reading = self.reading
        if lead in ("top", "last", "upper", "uppermost"):
            return [self.relative.upper(many, last - 1) if lead == "upper" else FloorRef("top", many, many)]
        if lead in ("first", "bottom", "lower", "lowest"):
            return [FloorRef("range", 1, many)]
        if lead in ("other", "remaining"):
            return [FloorRef("upper", many)]
        if lead in ("following", "next"):
            base = self.previous.last if self.previous is not None else 1
            return [FloorRef("range", base + 1, base + many)]
        if lead == "middle":
            return [FloorRef("middle")]
        if reading.word(index - 1) in ("these", "those") and self.places:
            return self._gathered(many, index)
        floors = int(reading.facts.floors[0].value) if reading.facts.floors else 0
        if many > 1 and floors == many + 1:
            return [FloorRef("range", 2, floors)]  # "a ground floor and three floors above ... the three floors"
        return [FloorRef("every")]

    def _elliptic_set(self, index: int, at: int, last: int, lead: str) -> bool:
        """Whether "the next four", "the bottom two" speak of storeys without saying so."""
        reading = self.reading
        opens = reading.word(index - 1) == "the" and (
            reading.starts(index - 1) or reading.word(index - 2) in (";", ",", "and", "on")
        )
        goes_on = reading.word(last) in COPULAS | CLOSERS | {"repeat", "all", "with", "each", "get", "take", "for"}
        return bool(lead) and self.has_floors and opens and last == at + 1 and goes_on

    def _typical(self) -> FloorRef:
        """Return the storeys that "the typical floor" stands for: all but the ground floor, or those not named."""
        reading = self.reading
        floors = int(reading.facts.floors[0].value) if reading.facts.floors else 0
        texts = {token.text for token in reading.tokens}
        named = {ref.first for place in self.places for ref in place.refs if ref.kind in ("number", "range")}
        if floors > 1 and named <= {1} and texts & {"ground", "g", ABOVE_GROUND}:
            return FloorRef("range", 2, floors)
        return FloorRef("rest" if self.places else "middle")

    def _names_top(self) -> bool:
        """Whether the brief has words for its top storey, which is then no typical one."""
        return not {"top", "topmost", "uppermost", "roof", "penthouse", "attic"}.isdisjoint(
            token.text for token in self.reading.tokens
        )

    def _names_several(self, index: int) -> bool:
        """Whether rooms or units in the plural stand before a token in its sentence: "12 flats on 4 floors, each"."""
        reading = self.reading
        at = index - 1
        while at >= 0 and reading.sentence[at] == reading.sentence[index] and index - at < 30:
            mention = reading.mention_at.get(at)
            if mention is not None and mention.plural and (mention.room or mention.building):
                return True
            at -= 1
        return False

    def _counts(self, index: int) -> bool:
        """Whether a plural with a number stands before a token: "three small apartments"."""
        reading = self.reading
        return reading.plural(index - 1) and any(reading.kind(i) == "number" for i in range(index - 3, index - 1))

    def _gathered(self, many: int, index: int) -> list[FloorRef]:
        """Return the storeys that "those five floors" speaks of: that many, named last in the sentence."""
        refs: list[FloorRef] = []
        for place in reversed(self.places):
            if self.reading.sentence[place.first] != self.reading.sentence[index]:
                break
            refs = [*place.refs, *refs]
            if sum(ref.last - ref.first + 1 for ref in refs if ref.kind in ("number", "range")) >= many:
                break
        return refs or list(self.places[-1].refs)

    def _set(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "odd floors", "on both", "the typical floor", "every second floor", "all floors except the top"."""
        for read in (
            self._odd_or_even,
            self._all_of_those_named,
            self._typical_floor,
            self._by_floor,
            self._each_of_those_counted,
            self._by_turns,
            self._each_of_some,
            self._every,
        ):
            found = read(index)
            if found is not None:
                return found
        return None

    def _odd_or_even(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "odd floors", "the even ones", "even numbered floors"."""
        reading = self.reading
        word, last = reading.word(index), index + 1
        ones = reading.word(last) == "one" and reading.plural(last)
        if word not in ("odd", "even") or not (ones or reading.word(last) in FLOOR_WORDS | {"numbered"}):
            return None
        return [FloorRef("odd" if word == "odd" else "even")], last + 1 + (reading.word(last) == "numbered")

    def _all_of_those_named(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "on both", "on each of them": the storeys that the sentence names last, or all."""
        reading, last = self.reading, index + 1
        closed = reading.word(last) in CLOSERS or reading.words(last, last + 2) == ("of", "them")
        led = reading.word(index) in ("both", "each", "all") and reading.word(index - 1) == "on"
        if not (closed and led and self.has_floors):
            return None
        last += 2 * (reading.word(last) == "of")
        named = [p for p in self.places if reading.sentence[p.first] == reading.sentence[index]]
        several = named and (len(named[-1].refs) > 1 or named[-1].refs[0].kind == "range")
        return (list(named[-1].refs) if several else [FloorRef("every")]), last

    def _typical_floor(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "the typical floor", "typical floors 2 to 5", "typical upper floor (x3)"."""
        reading, last = self.reading, index + 1
        last += reading.word(last) in UPSTAIRS
        if reading.word(index) != "typical" or reading.word(last) not in FLOOR_WORDS:
            return None
        numbered = self.numbered.numbered(last)
        if numbered is not None:
            return numbered
        many = self.relative.bracketed_number(last + 1)
        if many:
            return [self.relative.stacked(many, self.previous, last, capped=self._names_top())], last + 1
        alike = not reading.plural(last) and not self._names_top()
        return ([self._typical()] if alike else [FloorRef("middle")]), last + 1

    def _by_floor(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "three apartments by floor"."""
        reading, last = self.reading, index + 1
        single = reading.word(last) in FLOOR_WORDS and not reading.plural(last)
        return (
            ([FloorRef("every")], last + 1) if reading.word(index) == "by" and single and self._counts(index) else None
        )

    def _each_of_those_counted(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "three floors, each with 12 rooms"."""
        reading = self.reading
        if reading.word(index) != "each" or reading.word(index - 1) != ",":
            return None
        before = self.places[-1] if self.places else None
        gap = set(reading.words(before.last, index)) if before is not None else set()
        alike = gap <= _ALL_ALIKE and not gap.isdisjoint(_ALIKE)
        if alike and before is not None and reading.sentence[before.first] == reading.sentence[index]:
            return list(before.refs), index + 1  # "the three upper floors are the same, each having two flats"
        if self._names_several(index):
            return None
        counted = reading.word(index - 2) in FLOOR_WORDS and index - 2 in reading.taken
        has = reading.word(index + 1) in ("with", "has", "having", "have", "contain", "hold")
        return ([FloorRef("every")], index + 1) if counted and has else None

    def _by_turns(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "every second floor", and after another storey "each other floor"."""
        reading = self.reading
        word, order = reading.word(index), reading.word(index + 1)
        if word not in ("every", "each") or reading.word(index + 2) not in FLOOR_WORDS:
            return None
        if word == "each" and order == "other" and self.places:
            return [FloorRef("upper")], index + 3  # "a shop on the ground floor; each other floor two flats"
        by_turns = order in ("second", "other") and not reading.plural(index + 2)
        return ([FloorRef("even")], index + 3) if by_turns else None

    def _is_quantifier(self, index: int) -> bool:
        """Whether a token tells of how many storeys something is said; in "90 m2 per floor" it belongs to the area."""
        words = ("every", "each", "all", "per", "both", "any", "either", "whole")
        if self.reading.word(index) == "either" and not _MAY.isdisjoint(self.reading.words(max(index - 5, 0), index)):
            return False  # "it can go on either storey"
        per_unit = self.reading.word(index) == "per" and self.reading.kind(index - 1) == "unit"
        return self.reading.word(index) in words and not per_unit

    def _after_of(self, index: int) -> int:
        """Return the token after "of the" in "each of the upper three"; `index` where there is no "of"."""
        reading = self.reading
        if reading.word(index) != "of":
            return index
        return index + 1 + (reading.word(index + 1) in ("the", "its", "our", "these", "those"))

    def _each_of_some(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "each of floors 2 and 3", "each of the upper three"."""
        reading, last = self.reading, self._after_of(index + 1)
        if not self._is_quantifier(index) or last == index + 1:
            return None
        if reading.word(last) in FLOOR_WORDS:
            return self.numbered.numbered(last)
        many = int(reading.value(last + 1)) if reading.kind(last + 1) == "number" else 0
        end = last + 2 + (reading.word(last + 2) in FLOOR_WORDS)
        if many and reading.word(last) in ("upper", "top", "uppermost"):
            return [FloorRef("top", many, many)], end
        if many and reading.word(last) in ("lower", "bottom", "lowest"):
            return [FloorRef("range", 1, many)], end
        return None

    def _every(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "each floor", "all three upper floors", "every floor except the top"."""
        if not self._is_quantifier(index):
            return None
        reading, last = self.reading, self._after_of(index + 1)
        last += reading.word(last) in ("the", "our", "single", "one")
        counted = reading.kind(last) == "number" and reading.word(last + 1) in FLOOR_WORDS
        if counted and reading.value(last) > 1 and not reading.facts.floors:
            reading.facts.floors.append(Quantity(reading.value(last), reading.span(last, last + 2)))
        last += reading.kind(last) == "number"
        upper = reading.word(last) in UPSTAIRS or (
            reading.word(last) in _LIVED_IN and reading.word(last + 1) in FLOOR_WORDS
        )
        repeated = reading.word(last) in ("typical", "identical")
        last += upper or repeated or reading.word(last) in ("residential", "office")
        if reading.word(last) not in FLOOR_WORDS:
            return None
        if repeated:
            return [self._typical()], last + 1
        last += 1
        if reading.words(last, last + 3) == ("in", "the", "middle"):
            return [FloorRef("middle")], last + 3
        return self._all_but(last) or ([FloorRef("upper" if upper else "every")], last)

    def _all_but(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "except the top one", "other than the ground floor"."""
        reading = self.reading
        other_than = reading.words(index, index + 2) == ("other", "than")
        if not other_than and reading.word(index) not in ("except", "without", "but", "save"):
            return None
        at = index + 1 + other_than
        at += reading.word(at) in ("for", "on")
        at += reading.word(at) == "the"
        end = at + 1 + (reading.word(at + 1) in FLOOR_WORDS | {"one"})
        if reading.word(at) in TOPS:
            return [FloorRef("not_top")], end
        return ([FloorRef("upper")], end) if reading.word(at) in ("ground", "first") else None
