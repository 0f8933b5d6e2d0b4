"""Read which storeys a brief speaks of.

A storey is named absolutely ("the third floor", "L3", "levels 2 to 6"), from above ("the top floor", "two below the
top"), as a set ("every floor", "all but the last") or from the storey named before ("the seven storeys above").
"""

from dataclasses import replace

from mansion_planner.brief.facts import FloorRef
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading
from mansion_planner.brief.storey_counts import CLOSERS, DEFINITE, STOREY_ADJECTIVES, StoreyCounts, settle_counts
from mansion_planner.brief.storey_numbering import counts_above_ground, counts_from_ground, written_after
from mansion_planner.brief.storey_sequences import StoreySequence, resolve_rest

__all__ = ["read_storeys"]

_PREPOSITIONS = frozenset(
    """
    on in at to across throughout occupying for over from under
    """.split()
)
_STREET = frozenset(
    """
    ground gnd street entrance entry garden courtyard water lobby arrival bottom lowest lower public shop pavement
    """.split()
)
_TOPS = frozenset({"top", "uppermost", "topmost", "highest", "last", "final"})
_COPULAS = frozenset(
    """
    is are be has have hold contain house carry belong will stay
    """.split()
)


def read_storeys(reading: Reading) -> list[Place]:
    """Record the numbers of storeys and basements; return the references to storeys from left to right."""
    scanner = _Scanner(reading)
    scanner.scan()
    settle_counts(reading)
    floors = int(reading.facts.floors[0].value) if reading.facts.floors else 0
    places = [_with_edges(reading, place) if place.last > place.first else place for place in scanner.places]
    return resolve_rest(places, floors)


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
    if reading.word(last) == "(" and reading.word(last + 2) == ")" and reading.kind(last + 1) == "word":
        last += 3
    heading = reading.word(last) in (":", "=") or (reading.starts(first) and reading.word(last) in ("\n", "-"))
    reading.take(first, last)
    each = place.refs[0].kind == "every" and reading.kind(place.first - 1) in ("word", "number")
    return replace(place, first=first, last=last, led=led or each, heading=heading)


class _Scanner:
    """Goes over the tokens once; knows the storey named last, which others are told from."""

    def __init__(self, reading: Reading) -> None:
        self.reading = reading
        self.places: list[Place] = []
        self.counts = StoreyCounts(reading, self.places)
        self.british = counts_from_ground(reading)
        self.sequence = StoreySequence(reading)
        self.previous: FloorRef | None = None
        self.zero_based = any(
            reading.value(i) == 0
            and (
                reading.kind(i) == "level"
                or (reading.kind(i) == "number" and reading.word(i - 1) in ("level", "floor", "storey"))
            )
            for i in range(len(reading.tokens))
        )
        if counts_above_ground(reading):
            self.british = self.zero_based = True
        texts = [token.text for token in reading.tokens]
        self.has_floors = not FLOOR_WORDS.isdisjoint(texts) or "ground" in texts or "upstairs" in texts
        self.numbered_headings = sum(
            reading.kind(i) == "number" and reading.word(i + 1) == ":" and reading.starts(i) for i in range(len(texts))
        )

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
                index = last
                continue
            floors = self.reading.facts.floors
            listed = self.sequence.listed(index, int(floors[0].value) if floors else 0)
            if listed:
                self.places += listed
                index = listed[0].first
                continue
            refs, last = self._reference(index)
            if refs:
                self.places.append(Place(index, last, refs, led=False))
                self.reading.take(index, last)
                self.previous = refs[-1]
                index = last
                continue
            index += 1

    def _reference(self, index: int) -> tuple[tuple[FloorRef, ...], int]:
        """Read a reference at `index`: what it means, and where it ends."""
        for read in (
            self._level,
            self._basement,
            self._rest,
            self._counted_set,
            self._in_sequence,
            self._relative,
            self._ground,
            self._top,
            self._upper,
            self._set,
            self._numbered,
            self._ordinal,
            self._number_heading,
        ):
            found = read(index)
            if found is not None:
                refs, last = found
                span = self.reading.span(index, last)
                return tuple(replace(ref, span=span) for ref in refs), last
        return (), index

    def _in_sequence(self, index: int) -> tuple[list[FloorRef], int] | None:
        return self.sequence.read(index, self.previous)

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

    def _level(self, index: int) -> tuple[list[FloorRef], int] | None:
        reading = self.reading
        if reading.kind(index) != "level":
            return None
        shift = int(self.zero_based or (self.british and written_after(reading, index)))
        numbers, last = [int(reading.value(index)) + shift], index + 1
        while reading.word(last) in ("to", "–", "-", ",", "and", "&", "+", "through"):
            step = 2 if reading.word(last) == "," and reading.word(last + 1) == "and" else 1
            value = int(reading.value(last + step)) + shift
            if reading.kind(last + step) != "level" and not (
                reading.word(last) in ("–", "to") and reading.kind(last + step) == "number"
            ):
                break
            if reading.word(last) in ("to", "–", "-", "through"):
                return [FloorRef("range", min(numbers[-1], value), max(numbers[-1], value))], last + step + 1
            numbers.append(value)
            last += step + 1
        return [FloorRef("number", n, n) for n in numbers], last

    def _basement(self, index: int) -> tuple[list[FloorRef], int] | None:
        reading = self.reading
        word, following = reading.word(index), reading.word(index + 1)
        mention = reading.mention_at.get(index)
        if (word in ("below", "under") and following in ("ground", "grade")) or (
            word == "under" and following == "the" and reading.word(index + 2) == "ground"
        ):
            return [FloorRef("basement")], index + (2 if following != "the" else 3)
        if word not in ("basement", "cellar", "underground", "souterrain", "subterranean", "b1") or following == "car":
            return None
        last = index + 2 if following in FLOOR_WORDS else index + 1
        if mention is not None and mention.last > last:
            return None
        if reading.word(index - 1) in ("wine", "beer", "root", "coal", "finished"):
            return None
        if word in ("underground", "subterranean") and following not in FLOOR_WORDS:
            return None
        return [FloorRef("basement")], last

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
        trailing = reading.word(last)
        relative = trailing in ("above", "over", "after", "higher", "up", "following", "upstairs", "on")
        if (
            relative
            and trailing in ("over", "after", "above", "on")
            and reading.word(last + 1) in ("it", "that", "them", "this", "top", "these")
        ):
            last += 1
        if relative and lead not in ("top", "first", "last", "upper"):
            last += 1
            base = self.previous.last if self.previous is not None and self.previous.kind in ("number", "range") else 1
            return [FloorRef("range", base + 1, base + many)], last
        if lead in ("top", "last", "upper", "uppermost"):
            return [FloorRef("top", many, many)], last
        if lead in ("first", "bottom", "lower", "lowest"):
            return [FloorRef("range", 1, many)], last
        if lead in ("other", "remaining"):
            return [FloorRef("upper", many)], last
        if lead in ("following", "next"):
            base = self.previous.last if self.previous is not None else 1
            return [FloorRef("range", base + 1, base + many)], last
        if lead == "middle":
            return [FloorRef("middle")], last
        if reading.word(index - 1) in ("these", "those") and self.places:
            return self._gathered(many, index), last
        return [FloorRef("every")], last

    def _elliptic_set(self, index: int, at: int, last: int, lead: str) -> bool:
        """Whether "the next four", "the bottom two" speak of storeys without saying so."""
        reading = self.reading
        opens = reading.word(index - 1) == "the" and (
            reading.starts(index - 1) or reading.word(index - 2) in (";", ",", "and", "on")
        )
        goes_on = reading.word(last) in _COPULAS | CLOSERS | {"repeat", "all", "with", "each", "get", "take", "for"}
        return bool(lead) and self.has_floors and opens and last == at + 1 and goes_on

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

    def _relative(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "one flight up", "next storey up", "the floor above", "the one below", "two below the top"."""
        reading = self.reading
        word = reading.word(index)
        if word == "penultimate" or reading.words(index, index + 3) == ("second", "to", "last"):
            last = index + (1 if word == "penultimate" else 3)
            return [FloorRef("below_top", 1)], last + (reading.word(last) in FLOOR_WORDS)
        if reading.kind(index) == "number" and reading.words(index + 1, index + 4) == ("below", "the", "top"):
            return [FloorRef("below_top", int(reading.value(index)))], index + 4
        base = self.previous
        if base is None or base.kind not in ("number", "range", "top", "below_top"):
            base = FloorRef("number", 1, 1)
        if word in ("up", "down") and reading.word(index + 1) == "there" and self.previous is not None:
            return [replace(self.previous)], index + 2
        if reading.words(index, index + 3) == ("one", "flight", "up"):
            return [FloorRef("number", 2, 2)], index + 3
        if (
            word in ("next",)
            and reading.word(index + 1) in FLOOR_WORDS
            and reading.word(index + 2) in ("up", *CLOSERS, "above")
        ):
            return [FloorRef("number", base.last + 1, base.last + 1)], index + 2 + (
                reading.word(index + 2) in ("up", "above")
            )
        if (
            word in FLOOR_WORDS | {"one"}
            and (
                reading.word(index - 1) == "the"
                or (reading.starts(index) and reading.word(index + 2) in (":", "=", "-"))
            )
            and reading.word(index + 1) in ("above", "over", "below", "under", "beneath")
        ):
            up = reading.word(index + 1) in ("above", "over")
            last = index + 2 + (reading.word(index + 2) in ("it", "that", "this"))
            if word == "one" and self.previous is None:
                return None
            if base.kind in ("top", "below_top") and not up:
                return [FloorRef("below_top", base.first + 1 if base.kind == "below_top" else 1)], last
            return [FloorRef("number", base.last + (1 if up else -1), base.last + (1 if up else -1))], last
        return None

    def _ground(self, index: int) -> tuple[list[FloorRef], int] | None:
        reading = self.reading
        word, following = reading.word(index), reading.word(index + 1)
        ground = [FloorRef("number", 1, 1)]
        if word in _STREET and following in FLOOR_WORDS and not reading.plural(index + 1):
            return ground, index + 2
        if reading.words(index, index + 4) == ("level", "of", "the", "street"):
            return ground, index + 4
        if word == "lower" and following in (":", ",") and reading.word(index - 1) == "the":
            return ground, index + 1
        if word in ("downstair", "downstairs"):
            return ground, index + 1
        if (
            word in ("eg", "gnd")
            and following in CLOSERS | {"has", "with"}
            and reading.word(index - 1) in ("the", "in", "")
        ):
            return ground, index + 1
        if word in ("gf", "g/f", "gnd") and following in CLOSERS | {"has", "with"}:
            return ground, index + 1
        if word == "ff" and following in CLOSERS and self.british:
            return [FloorRef("number", 2, 2)], index + 1
        if word == "at" and following == "grade":
            return ground, index + 2
        if (
            word == "ground"
            and (following in CLOSERS or following in ("and", "there", "has", "is"))
            and (reading.word(index - 1) in ("the", "on", "at") or reading.starts(index))
        ):
            return ground, index + 1
        if (
            word == "bottom"
            and following in CLOSERS | _COPULAS | {"with", "and"}
            and reading.word(index - 1) in ("the", "at", "from")
        ):
            return None if reading.word(index - 2) == "from" else (ground, index + 1)
        if word == "bottom" and following == ":":
            return ground, index + 1
        if word == "bottom" and reading.word(index - 1) == "very" and reading.word(index - 2) in ("the", "at"):
            return ground, index + 1
        if word == "lowest" and self._names_storey(index):
            return ground, index + 1
        if word == "below" and (
            (reading.starts(index) and following in (":", "is", "are", "there", ",", "the", "we", "i", "you", "a"))
            or (following in CLOSERS and self._is_storeyed_adverb(index))
        ):
            return ground, index + 1
        if (
            word == "down"
            and self.has_floors
            and following in CLOSERS
            and reading.word(index - 1) in ("stay", "is", "are", "go")
        ):
            return ground, index + 1
        return None

    def _is_storeyed_adverb(self, index: int) -> bool:
        """Whether a final "above" or "below" is an adverb of place: its opposite stands in the brief too."""
        texts = {token.text for token in self.reading.tokens}
        return bool(
            {"above", "below"} <= texts or ("below" in texts and texts & {"upstair", "middle", "uppermost", "top"})
        )

    def _top(self, index: int) -> tuple[list[FloorRef], int] | None:
        reading = self.reading
        word, following = reading.word(index), reading.word(index + 1)
        if word in _TOPS and following in FLOOR_WORDS and not reading.plural(index + 1):
            return [FloorRef("top")], index + 2
        if word in ("rooftop", "roof") and following in FLOOR_WORDS:
            return [FloorRef("top")], index + 2
        if word == "roof" and reading.words(index - 2, index) == ("under", "the") and following not in FLOOR_WORDS:
            # "under the roof on the third": the storey that is named counts.
            return [FloorRef("top")], index + 1
        if (
            word in ("rooftop", "roof")
            and following not in ("terrace", "garden", "bar", "deck")
            and (
                index not in reading.mention_at
                and reading.word(index - 1) in ("the", "on")
                and reading.word(index - 2) in ("on", "")
            )
        ):
            return [FloorRef("top")], index + 1
        led = reading.word(index - 1) in ("the", "on", "very", "at") or reading.starts(index)
        if (
            word in ("top", "topp")
            and led
            and (
                following
                in CLOSERS
                | _COPULAS
                | {"with", "and", "there", "nothing", "only", "two", "one", "become", "we", "the", "sit", "come"}
            )
        ):
            return [FloorRef("top")], index + 1
        if word in ("attic", "loft") and following == ":":
            return [FloorRef("top")], index + 1
        if word in ("uppermost", "topmost", "highest") and self._names_storey(index):
            return [FloorRef("top")], index + 1
        return None

    def _names_storey(self, index: int) -> bool:
        """Whether "the lowest", "the middle one", "the uppermost" open a clause of a brief of several storeys."""
        reading = self.reading
        opens = reading.starts(index - 1) or reading.word(index - 2) in (";", ",", "and", "with", ":")
        following = reading.word(index + 1)
        return (
            reading.word(index - 1) == "the"
            and opens
            and self.has_floors
            and (following in _COPULAS | {"a", "an", "the", "get", "for", ":"} or reading.kind(index + 1) == "number")
        )

    def _upper(self, index: int) -> tuple[list[FloorRef], int] | None:
        reading = self.reading
        word, following = reading.word(index), reading.word(index + 1)
        upper = [FloorRef("upper")]
        if word in ("upstair", "upstairs"):
            return upper, index + 1
        if word == "upper" and following in (":", ",") and reading.word(index - 1) == "the":
            return upper, index + 1
        if word in ("upper", "higher", "other") and following in FLOOR_WORDS:
            return upper, index + 2
        if word in ("lower",) and following in FLOOR_WORDS and reading.plural(index + 1):
            return [FloorRef("lower")], index + 2
        if word == "higher" and following == "up":
            return upper, index + 2
        if word == "above" and (
            (reading.starts(index) and following in (":", ",", "are", "is", "there", "we", "i", "you", "a"))
            or (following in CLOSERS | {"with"} and (self._is_storeyed_adverb(index) or reading.word(index - 1) == ","))
        ):
            return upper, index + 1
        if word in ("upper", "og") and reading.starts(index) and following in (":", "-", "–"):
            return upper, index + 1
        if word == "og" and following in CLOSERS:
            return upper, index + 1
        if word == "up" and reading.starts(index) and following == ":":
            return upper, index + 1
        if word == "middle" and (following in FLOOR_WORDS or (following == "one" and self._names_storey(index + 1))):
            return [FloorRef("middle")], index + 2
        if word == "middle" and following in (":", "=") and reading.starts(index):
            return [FloorRef("middle")], index + 1
        if (
            word == "middle"
            and reading.words(index - 2, index) == ("in", "the")
            and following in CLOSERS | {"with", "there", "are", "is", "come", "we"}
            and self.has_floors
        ):
            return [FloorRef("middle")], index + 1
        return None

    def _set(self, index: int) -> tuple[list[FloorRef], int] | None:
        reading = self.reading
        word, last = reading.word(index), index + 1
        if word in ("odd", "even") and reading.word(last) in FLOOR_WORDS | {"numbered"}:
            return [FloorRef("odd" if word == "odd" else "even")], last + 1 + (reading.word(last) == "numbered")
        if (
            word in ("both", "each", "all")
            and reading.word(last) in CLOSERS
            and reading.word(index - 1) == "on"
            and self.has_floors
        ):
            named = [p for p in self.places if reading.sentence[p.first] == reading.sentence[index]]
            several = named and (len(named[-1].refs) > 1 or named[-1].refs[0].kind == "range")
            return (list(named[-1].refs) if several else [FloorRef("every")]), last
        if word == "typical" and reading.word(last) in FLOOR_WORDS:
            numbered = self._numbered(last)
            return numbered if numbered is not None else ([FloorRef("middle")], last + 1)
        if word == "per" and reading.kind(index - 1) == "unit":
            return None
        if word not in ("every", "each", "all", "per", "both", "any", "either", "whole"):
            return None
        if reading.word(last) == "of":
            last += 1 + (reading.word(last + 1) in ("the", "its", "our", "these", "those"))
        last += reading.word(last) in ("the", "our", "single", "one")
        last += reading.kind(last) == "number"
        upper = reading.word(last) in ("upper", "other", "guest", "remaining")
        last += upper or reading.word(last) in ("residential", "office", "typical")
        if reading.word(last) not in FLOOR_WORDS:
            return None
        last += 1
        if reading.word(last) in ("except", "without", "but", "save") or reading.words(last, last + 2) == (
            "other",
            "than",
        ):
            at = last + 1 + (reading.word(last) == "other")
            at += reading.word(at) in ("for", "on")
            at += reading.word(at) == "the"
            if reading.word(at) in _TOPS:
                at += 1 + (reading.word(at + 1) in FLOOR_WORDS | {"one"})
                return [FloorRef("not_top")], at
            if reading.word(at) in ("ground", "first"):
                return [FloorRef("upper")], at + 1 + (reading.word(at + 1) in FLOOR_WORDS | {"one"})
        return [FloorRef("upper" if upper else "every")], last

    def _number(self, index: int, kind: str) -> int | None:
        reading = self.reading
        if reading.kind(index) != kind or index in reading.taken or reading.tokens[index].soft:
            return None
        value = reading.value(index)
        shift = int(self.zero_based and kind == "number")
        return int(value) + shift if value == int(value) and abs(value) <= 1000 else None

    def _numbered(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "floor 3", "floors 3 to 8", "levels 2 and 3", "floors 2, 3 and 5"."""
        reading = self.reading
        if reading.word(index) not in FLOOR_WORDS or reading.word(index) == "storie":
            return None
        first = self._number(index + 1, "number")
        if first is None or reading.kind(index + 2) == "unit" or reading.word(index + 2) in ("people", "person"):
            return None
        last = index + 2
        link, second = reading.word(last), self._number(last + 1, "number")
        if link in ("to", "through", "until", "–", "-", "thru") and second is not None:
            return [FloorRef("range", min(first, second), max(first, second))], last + 2
        if reading.kind(last) == "word" and not reading.plural(index) and reading.plural(last):
            return None  # "level 2 bedrooms" has no plural room of one level: the number counts the rooms
        numbers = [first]
        while reading.word(last) in (",", "and", "&"):
            step = 2 if reading.word(last) == "," and reading.word(last + 1) == "and" else 1
            more = self._number(last + step, "number")
            if more is None or not reading.plural(index) or more <= numbers[-1]:
                break
            if reading.kind(last + step + 1) == "unit" or reading.plural(last + step + 1):
                break
            numbers.append(more)
            last += step + 1
        return [FloorRef("number", number, number) for number in numbers], last

    def _ordinal(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "third floor", "second and third floors", "third to eighth floors", "second:", "on the second"."""
        reading = self.reading
        number = self._number(index, "ordinal")
        mention = reading.mention_at.get(index)
        if number is None or (mention is not None and mention.last - index > 1 and mention.room):
            return None  # "first aid"
        numbers, last, ranged = [number], index + 1, False
        while reading.word(last) in ("and", ",", "&", "to", "through", "–", "floor", "-"):
            link = reading.word(last)
            if link == "floor" and reading.word(last + 1) not in ("to", "through", "–"):
                break
            step = 2 if link == "floor" or (link == "," and reading.word(last + 1) == "and") else 1
            step += reading.word(last + step) == "the"
            more = self._number(last + step, "ordinal")
            if more is None:
                break
            ranged = ranged or link in ("to", "through", "–", "floor", "-")
            numbers.append(more)
            last += step + 1
        following = reading.word(last)
        if following in FLOOR_WORDS:
            last += 1
            if reading.words(last, last + 3) == ("from", "the", "top"):
                return [FloorRef("below_top", number - 1)], last + 3
        elif not self._bare_ordinal(index, last):
            return None
        shift = int(self.british)
        numbers = [value + shift for value in numbers]
        if ranged and len(numbers) == 2:
            return [FloorRef("range", min(numbers), max(numbers))], last
        return [FloorRef("number", value, value) for value in numbers], last

    def _bare_ordinal(self, index: int, last: int) -> bool:
        """Whether an ordinal without "floor" means one: a heading, or the end of "on the second"."""
        reading = self.reading
        following = reading.word(last)
        if not self.has_floors and not self.places:
            return False
        if reading.starts(index):
            return following in (":", "\n", "(", "=", "-") or (following == "is" and reading.word(index - 1) == "the")
        if reading.word(index - 1) != "the":
            return False
        if reading.word(index - 2) in ("on", "to", "and", "in", "at") or reading.starts(index - 1):
            led = reading.word(index - 2) in ("on", "to", "and", "in", "at")
            return (following in CLOSERS | {"and", "with", "is", "has", "are"}) or (
                led and reading.word(index - 2) == "on"
            )
        return False

    def _number_heading(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "1: lobby", "4, 5 and 6: wards" where such headings number the storeys."""
        reading = self.reading
        if self.numbered_headings < 2 or reading.kind(index) != "number" or not reading.starts(index):
            return None
        numbers, last = [int(reading.value(index))], index + 1
        while reading.word(last) in (",", "and", "&", "–", "to"):
            if reading.kind(last + 1) != "number":
                return None
            if reading.word(last) in ("–", "to"):
                numbers += range(numbers[-1] + 1, int(reading.value(last + 1)) + 1)
            else:
                numbers.append(int(reading.value(last + 1)))
            last += 2
        if reading.word(last) != ":" or max(numbers) > 200:
            return None
        return [FloorRef("number", number, number) for number in numbers], last
