"""Read how many storeys and basements a brief asks for: "four storeys", "G+3", "all on one level"."""

from dataclasses import dataclass

from mansion_planner.brief.cellars import keeps_goods
from mansion_planner.brief.facts import FloorRef, Quantity
from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.phrase import PLAIN
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading
from mansion_planner.brief.storey_kinds import all_on_one, attic_above, has_upper_storeys, storeys_below

__all__ = [
    "ANAPHORS",
    "CLOSERS",
    "DEFINITE",
    "HOLDING",
    "STOREY_ADJECTIVES",
    "UPSTAIRS",
    "StoreyCounts",
    "settle_counts",
]

_NEGATIONS = frozenset({"no", "without", "not", "neither", "nor", "never"})
DEFINITE = frozenset(
    """
    the these those both all other remaining top upper first last bottom lower lowest uppermost middle following
    next every each
    """.split()
)
STOREY_ADJECTIVES = frozenset(
    """
    full whole habitable residential office guest typical additional more storied underground basement parking
    subterranean identical sale
    trading exhibition teaching production main equal different separate small large big classroom hotel retail
    working usable living successive consecutive more hall stack ward patient archive storage lab laboratory
    """.split()
)
UPSTAIRS = frozenset("upper other guest remaining sleeping bedroom residential".split())
"""What storeys above the ground floor are called together: "on each sleeping level"."""
ANAPHORS = frozenset({"it", "that", "them", "this", "these", "those"})
HOLDING = frozenset({"with", "holding", "containing", "housing", "for"})
"""Words between a basement and the rooms that lie in it."""

_WISHES = frozenset({"want", "need", "make", "build", "dig", "have", "require"})
_BELOW = frozenset({"underground", "basement", "subterranean", "below"})
_WITH_BASEMENT = (
    *((joint, number) for joint in ("and", "plus", ",") for number in ("a", "one")),
    ("with", "cellar"), ("with", "basement"),
)  # fmt: skip
CLOSERS = frozenset({"", ".", ",", ";", ":", "\n", ")", "!", "?", "=", "-"})


@dataclass(frozen=True)
class _Count:
    """A number of storeys, at tokens `first` to `last` (exclusive), and the adjectives before the noun."""

    value: float
    first: int
    last: int
    adjectives: tuple[str, ...]

    @property
    def with_the_first(self) -> float:
        """The number with the ground floor: "two upper floors" and "two more floors" leave it out."""
        return self.value + (not {"upper", "additional", "more"}.isdisjoint(self.adjectives))


class StoreyCounts:
    """Records numbers of storeys as facts; adds to `places` the storeys that a number names ("two floors above it")."""

    def __init__(self, reading: Reading, places: list[Place]) -> None:
        self.reading, self.places = reading, places
        self.previous: FloorRef | None = None

    def read(self, index: int, previous: FloorRef | None) -> int:
        """Read a number of storeys, or a basement that is not wanted, at token `index`.

        Parameters
        ----------
        previous : FloorRef, optional
            The storey named last.

        Returns
        -------
        int
            The token after it; `index` where there is none.
        """
        unwanted = self._unwanted_basement(index)
        if unwanted:
            return unwanted
        self.previous = previous
        reading = self.reading
        for read in (
            self._labelled_count,
            self._ground_and_more,
            self._everything_on_one,
            self._plain_count,
            self._basement_count,
        ):
            last = read(index)
            if last > index:
                return last
        word = reading.word(index)
        if (
            word in ("nothing", "none")
            and reading.words(index + 1, index + 3) in (("above", "that"), ("over", "it"), ("above", "it"))
            and self.previous is not None
            and self.previous.kind in ("number", "range")
        ):
            self._state(self.previous.last, index, index + 3)
            return index + 3
        return index

    def _state(self, value: float, first: int, last: int, *, below: bool = False) -> None:
        facts = self.reading.facts
        (facts.basements if below else facts.floors).append(Quantity(float(value), self.reading.span(first, last)))

    def _labelled_count(self, index: int) -> int:
        """Read "floors: 3", "Storeys = 3", "number of floors: 3", "basement: none"."""
        reading = self.reading
        if reading.word(index) in FLOOR_WORDS | {"basement", "cellar"} and reading.word(index + 1) in (":", "="):
            below = reading.word(index) in ("basement", "cellar")
            if reading.kind(index + 2) == "number" and reading.word(index + 3) in CLOSERS | {"and"}:
                self._state(reading.value(index + 2), index, index + 3, below=below)
                return index + 3
            if below and reading.word(index + 2) in ("no", "none", "without"):
                reading.facts.excluded.append(("basement", reading.span(index, index + 3)))
                return index + 3
        return index

    def _ground_and_more(self, index: int) -> int:
        """Read "G+3", "ground plus two", "street level and one upper floor"."""
        reading = self.reading
        word, last = reading.word(index), index + 1
        if word not in ("g", "ground", "street", "entrance"):
            return index
        last += reading.word(last) in FLOOR_WORDS
        if reading.word(last) not in ("+", "plus", "and") or reading.kind(last + 1) != "number":
            return index
        joint, value = reading.word(last), int(reading.value(last + 1))
        last += 2
        storeyed = False
        while (
            reading.word(last) in ("upper", "more", "further", "additional", "other")
            or reading.word(last) in FLOOR_WORDS
        ):
            storeyed = storeyed or reading.word(last) in FLOOR_WORDS
            last += 1
        if not storeyed and reading.word(last) in STOREY_ADJECTIVES | UPSTAIRS and reading.plural(last + 1):
            storeyed = reading.word(last + 1) in FLOOR_WORDS  # "and three bedroom storeys"
            last += 2 * storeyed
        if storeyed and reading.word(last) in ("above", "over"):
            last += 1 + (reading.word(last + 1) in ANAPHORS)
        if joint == "and" and not storeyed:
            return index
        if joint == "plus" and not storeyed and reading.word(last) not in CLOSERS | {"with", "and", "in"}:
            return index
        self._state(value + 1, index, last)
        return last

    def _everything_on_one(self, index: int) -> int:
        """Read "everything on one level", "all at grade", "ground floor only", "no other floors"."""
        reading = self.reading
        word = reading.word(index)
        above = self._nothing_above(index)
        if above:
            self._state(1, index, above)
            return above
        if word in ("no", "without") and reading.word(index + 2) in FLOOR_WORDS:
            most = self._most_below(index + 1)
            if most:
                self._state(most, index, index + 3)
                return index + 3
        pair = self._ground_and_next_only(index)
        if pair:
            self._state(2, index, pair)
            return pair
        if (
            word in ("ground", "street")
            and reading.word(index + 1) in FLOOR_WORDS
            and reading.word(index + 2) in ("only", "alone")
            and (reading.word(index + 3) in CLOSERS - {":"} or reading.word(index + 3) in ("and", "with"))
        ):
            self._state(1, index, index + 3)
            return index + 3
        level = all_on_one(reading, index)
        if level:
            self._state(1, index, level)
            return level
        if word not in ("everything", "all", "wholly", "entirely") or reading.word(index + 1) not in ("on", "at", "in"):
            return index
        last = index + 2
        last += reading.word(last) in ("the", "a")
        grade = reading.word(last) == "grade"
        ground = reading.word(last) == "ground" and (
            reading.word(last + 1) in CLOSERS or reading.word(last + 1) in ("floor", "level")
        )
        one = reading.kind(last) == "number" and reading.value(last) == 1 and reading.word(last + 1) in FLOOR_WORDS
        if not (grade or ground or one) or (word == "all" and ground and has_upper_storeys(reading)):
            return index  # "six classrooms, all on the ground floor", with others upstairs
        last += 1 + (reading.word(last + 1) in FLOOR_WORDS)
        self._state(1, index, last)
        return last

    def _nothing_above(self, index: int) -> int:
        """Return where "no floors above" and "nothing above" end beside a ground floor and no other storey, or 0."""
        reading = self.reading
        last = index + 1 + (reading.word(index + 1) in ("other", "further", "more", "upper"))
        named = {ref.last for place in self.places for ref in place.refs if ref.kind != "basement"}
        none = reading.word(index) in ("no", "without") and reading.word(last) in FLOOR_WORDS
        if not (none or reading.word(index) in ("nothing", "none")) or named != {1}:
            return 0
        if any(quantity.value > 1 for quantity in reading.facts.floors):
            return 0  # "a two-storey clinic with six wards on the ground floor, and none upstairs"
        last += none
        if reading.word(last) not in ("above", "over", "overhead", "upstair", "upstairs"):
            return 0
        last += 1 + (reading.word(last + 1) in ANAPHORS)
        return last if reading.word(last) in CLOSERS else 0

    def _most_below(self, index: int) -> int:
        """Return how many storeys there are at most without the one that is named: "no second floor", or 0."""
        reading = self.reading
        if reading.plural(index + 1):
            return int(reading.word(index) in ("other", "upper", "further"))
        if reading.word(index) in ("other", "upper", "further"):
            return 1
        value = reading.value(index) if reading.kind(index) == "ordinal" else 0.0
        named = {ref.last for place in self.places for ref in place.refs if ref.kind in ("number", "range")}
        if value not in (1.0, 2.0, 3.0, 4.0) or value in named:
            return 0
        return max(int(value) - 1, 1)

    def _ground_and_next_only(self, index: int) -> int:
        """Return where "ground and first floor only" ends, or 0."""
        reading = self.reading
        last = index + 1 + (reading.word(index + 1) in FLOOR_WORDS)
        if reading.word(index) != "ground" or reading.word(last) not in ("and", "&", "+", "plus"):
            return 0
        last += 1 + (reading.word(last + 1) in ("one", "the"))
        upper = reading.word(last) == "upper" or (reading.kind(last) == "ordinal" and reading.value(last) == 1)
        if not upper or reading.word(last + 1) not in FLOOR_WORDS or reading.word(last + 2) not in ("only", "alone"):
            return 0
        return last + 3 if reading.word(last + 3) in CLOSERS else 0

    def _of_room(self, index: int) -> bool:
        """Whether "two storeys high" is said of a room: "the lobby is two storeys high"."""
        reading = self.reading
        if reading.word(index - 1) not in ("is", "be", "are") or reading.word(index + 2) not in ("high", "tall"):
            return False
        subject = index - 2 - (reading.word(index - 2) in ("should", "must", "shall", "will", "to"))
        return any(
            mention is not None and mention.room and not mention.building and mention.last == subject + 1
            for mention in (reading.mention_at.get(at) for at in range(subject - 2, subject + 1))
        )

    def _plain_count(self, index: int) -> int:
        """Read "four storeys", "3-storey", "between two and three floors", "two more floors below ground"."""
        reading = self.reading
        if reading.word(index) == "tree" and reading.word(index + 1) in FLOOR_WORDS and reading.plural(index + 1):
            self._state(3, index, index + 2)  # the commonest misspelling of "three"
            return index + 2
        count = self._count_at(index)
        if count is None:
            return index
        for read in (
            self._basement_among_them,
            self._above_ground,
            self._above_those_named,
            self._below_ground,
            self._on_top_of_those_named,
            self._attic_over_them,
            self._of_a_use,
        ):
            last = read(count)
            if last:
                return last
        self._state(count.with_the_first, index, count.last)
        return count.last

    def _count_at(self, index: int) -> _Count | None:
        """Return the number of storeys that stands at a token, where it counts all of a building or a part."""
        reading = self.reading
        named = reading.word(index - 1) in FLOOR_WORDS and reading.word(index - 1) != "story"
        if reading.kind(index) != "number" or named or self._of_room(index):
            return None
        value, last = self._value_or_middle(index)
        if reading.word(last) in ("of", "or") and reading.word(last + 1) in ("those", "these", "the"):
            return None
        adjectives = self._adjectives(last)
        last += len(adjectives)
        if reading.word(last) not in FLOOR_WORDS or value != int(value) or not 0 < value < 10_000:
            return None
        every = reading.word(index - 1) == "all" and value > 1 and not self.places
        if reading.word(index - 1) in DEFINITE and not every:
            return None
        if not reading.plural(last) and reading.plural(last + 1) and furniture_of(reading.words(last, last + 2))[1] > 1:
            return None  # "three floor lamps"
        last += 1
        if reading.word(last) in ("up", "down", "higher", "lower", "upward", "downward") and not adjectives:
            return None  # "one floor up" tells a storey
        if value == 1 and self._measures_one(last):
            return None
        return _Count(value, index, last + (reading.word(last) in ("high", "height", "tall")), adjectives)

    def _value_or_middle(self, index: int) -> tuple[float, int]:
        """Return the number at a token, or the middle of "two to four floors", and the token after it."""
        reading = self.reading
        value, last = reading.value(index), index + 1
        ranged = reading.word(last) in ("and", "to", "or", "–", "-") and reading.kind(last + 1) == "number"
        if ranged and reading.word(last + 2) in FLOOR_WORDS and value < reading.value(last + 1) <= value + 3:
            return float(int((value + reading.value(last + 1)) / 2)), last + 2
        return value, last

    def _adjectives(self, index: int) -> tuple[str, ...]:
        """Return the words from a token on, two at most, that tell of storeys: "two full storeys"."""
        reading, last = self.reading, index
        while (
            reading.word(last) in STOREY_ADJECTIVES | PLAIN | {"upper", "only", "sleeping"}
            and (reading.word(last) not in FLOOR_WORDS or reading.word(last + 1) in FLOOR_WORDS)
            and last - index < 2
        ):
            last += 1
        return reading.words(index, last)

    def _basement_among_them(self, count: _Count) -> int:
        """Read "4 levels if you count the basement"; return where it ends, or 0, as all that read on from a count."""
        below, last = storeys_below(self.reading, count.last)
        if not last and count.value > 1:
            below, last = 1, self._included_basement(count.last)
        last = last if 0 < below < count.value else 0
        if last:
            self._state(count.value - below, count.first, last)
            self._state(below, count.last + (self.reading.word(count.last) == ","), last, below=True)
        return last

    def _above_ground(self, count: _Count) -> int:
        """Read "four storeys above ground", "three floors over the street"."""
        lead, following = self.reading.word(count.last), self.reading.words(count.last + 1, count.last + 3)
        street = lead in ("over", "above") and following in (("the", "street"), ("the", "ground"), ("ground", "level"))
        if not street and not (lead == "above" and following[0] in ("ground", "grade")):
            return 0
        self._state(count.value, count.first, count.last)
        return count.last if street else count.last + 2

    def _above_those_named(self, count: _Count) -> int:
        """Read "three floors above it"; "twelve rooms on two floors above" lie on either, as those on upper floors."""
        reading, base = self.reading, self._storey_below()
        over = reading.word(count.last) in ("over", "above")
        if not over or not base or reading.facts.floors:
            return 0
        following = reading.word(count.last + 1)
        if following in ("it", "that", "them", "this"):
            return self._state_above(base, count, count.last + 2)
        if not self.places or following not in CLOSERS:
            return 0
        self._state(base + count.value, count.first, count.last + 1)
        return count.last + 1

    def _below_ground(self, count: _Count) -> int:
        """Read "two basement levels", "two floors underground", "one level below grade"."""
        reading, last = self.reading, count.last
        placed = reading.word(last) in ("below", "underground", "under")
        placed = placed and reading.word(last + 1) in ("ground", "grade", *CLOSERS)
        if not placed and _BELOW.isdisjoint(count.adjectives):
            return 0
        last += reading.word(last) in ("below", "underground", "under")
        last += reading.word(last) in ("ground", "grade")
        self._state(count.value, count.first, last, below=True)
        return last

    def _on_top_of_those_named(self, count: _Count) -> int:
        """Read "above it are three floors", "on top of that two storeys"."""
        reading = self.reading
        lead = reading.words(count.first - 4, count.first)
        over = not {"above", "top"}.isdisjoint(lead) and not {"it", "that", "this", "them"}.isdisjoint(lead)
        if not over or not self.places or reading.facts.floors:
            return 0
        base = self.previous.first - 1 if self.previous is not None and self.previous.kind == "number" else 1
        return self._state_above(max(base, 1), count, count.last)

    def _state_above(self, base: int, count: _Count, last: int) -> int:
        """State the number of storeys with so many above storey `base`, which are a place; return `last`."""
        self._state(base + count.value, count.first, last)
        span = self.reading.span(count.first, last)
        storeys = FloorRef("range", base + 1, base + int(count.value), span)
        self.places.append(Place(count.first, last, (storeys,), led=False))
        return last

    def _attic_over_them(self, count: _Count) -> int:
        """Read "2 full floors + attic"."""
        last = attic_above(self.reading, count.last)
        if last:
            self._state(count.value + 1, count.first, last)
        return last

    def _of_a_use(self, count: _Count) -> int:
        """Read "three floors of offices"."""
        if self.reading.word(count.last) != "of" or not self._storeys_of_a_use(count.last):
            return 0
        return self._storeys_with_a_use(count.first, count.last, int(count.with_the_first))

    def _storeys_with_a_use(self, index: int, last: int, many: int) -> int:
        """Read "three floors of offices above a shop", "a bar, then four storeys of rooms", "five floors of flats".

        They lie above what is named before or after them; where nothing is, they are the whole building.
        """
        reading = self.reading
        if reading.facts.floors:
            return index
        stacked = self._lies_over(last)
        before = self._storey_below() if reading.word(index - 1) == "then" else 0
        base = 1 if stacked else before
        if base:
            span = reading.span(index, last)
            self.places.append(Place(index, last, (FloorRef("range", base + 1, base + many, span),), led=False))
            if stacked:
                if reading.word(stacked[1] - 1) not in ANAPHORS:
                    ground = FloorRef("number", 1, 1, reading.span(*stacked))
                    self.places.append(Place(*stacked, (ground,), led=False, heading=True))
                reading.take(*stacked)
            return last
        texts = {token.text for token in reading.tokens}
        if self.places or texts & {"ground", "basement", "cellar", "top", "downstair", "downstairs"}:
            return index
        self._state(many, index, last)
        return last

    def _lies_over(self, last: int) -> tuple[int, int] | None:
        """Return the tokens of "above" in "of offices above a shop", where no break stands before them."""
        reading = self.reading
        for at in range(last + 1, last + 7):
            if reading.breaks(at) or reading.word(at) in (",", "with", "and", ":"):
                return None
            end = at + (3 if reading.words(at, at + 3) == ("on", "top", "of") else 1)
            if reading.word(at) in ("above", "over", "atop") or end == at + 3:
                if reading.word(end) in ANAPHORS:
                    return at, end + 1
                outside = reading.word(end) in ("ground", "grade", "street")
                return None if outside or reading.words(end, end + 2) == ("the", "ground") else (at, end)
        return None

    def _storey_below(self) -> int:
        """Return the storey that "above it" counts from: the last one named, else the first; 0 if not numbered."""
        if self.previous is None:
            return 1
        return self.previous.last if self.previous.kind in ("number", "range") else 0

    def _included_basement(self, last: int) -> int:
        """Return where "4 levels if you count the basement", "3 floors incl. cellar" end, or 0."""
        words: list[str] = []
        for at in range(last, last + 8):
            if self.reading.breaks(at):
                return 0
            words.append(self.reading.word(at))
            if words[-1] in ("basement", "cellar"):
                counted = {"including", "incl", "count", "counting", "counted", "included", "inclusive", "include"}
                end = at + 1 + (self.reading.word(at + 1) in {"is", "being"})
                end += self.reading.word(end) in counted
                said = {*words, *self.reading.words(at + 1, end)}
                refused = not {"not", "without", "excluding", "no"}.isdisjoint(said)
                return 0 if refused or counted.isdisjoint(said) else end
        return 0

    def _measures_one(self, last: int) -> bool:
        """Whether "one floor is 330 m2" says how large each of several storeys is."""
        reading = self.reading
        end = last + 1 + (reading.word(last + 1) in ("about", "around", "approximately"))
        several = any(quantity.value > 1 for quantity in reading.facts.floors)
        is_of = reading.word(last) in ("is", "has", "have", "be", "=")
        return several and is_of and reading.kind(end) == "number" and reading.kind(end + 1) == "unit"

    def _storeys_of_a_use(self, last: int) -> bool:
        """Whether "of" leads on to a use of the storeys ("three floors of apartments"), not to their size."""
        mention = next((self.reading.mention_at[i] for i in (last + 1, last + 2) if i in self.reading.mention_at), None)
        if mention is None:
            return self.reading.word(last + 1) == "room" and self.reading.plural(last + 1)
        return mention.plural or bool(mention.building)

    def _basement_count(self, index: int) -> int:
        reading = self.reading
        if reading.word(index + 2) == "cellar" and keeps_goods(reading, index + 2):
            return index
        described = index + 2 + (reading.word(index + 2) not in ("basement", "cellar"))
        if (
            reading.word(index) in ("over", "above", "plus", "and", "with")
            and reading.word(index + 1) in ("a", "one", "full")
            and described == index + 3
            and reading.kind(index + 2) == "word"
            and reading.word(described) in ("basement", "cellar")
            and reading.word(described + 1) in CLOSERS | {"with", "for", "and"}
            and reading.word(index + 2) not in ("wine", "beer", "root", "coal")
        ):
            self._state(1, index, described + 1, below=True)
            self._place_in_basement(described, described + 1)
            return described + 1
        if (
            reading.word(index) not in ("over", "above", "on", "with")
            or reading.word(index + 2) not in ("basement", "cellar")
        ) and not (
            reading.words(index, index + 2) in _WITH_BASEMENT
            and (reading.word(index + 2) in ("basement", "cellar") or reading.word(index + 1) in ("basement", "cellar"))
        ):
            if (
                reading.word(index) in ("over", "above")
                and reading.word(index + 3) in ("basement", "cellar")
                and reading.word(index + 1) == "a"
            ):
                self._state(1, index, index + 4, below=True)
                self._place_in_basement(index + 3, index + 4)
                return index + 4
            return index
        last = index + (2 if reading.word(index + 1) in ("basement", "cellar") else 3)
        if reading.word(index) in ("on", "above") and reading.word(index + 1) == "the":
            return index
        if reading.word(last) in ("level", "floor", "storey"):
            last += 1
        if reading.word(index + 1) in ("the", "each", "no"):
            return index
        if self._names_room(last):
            return index  # "a basement gym" is a room and where it is
        self._state(1, index, last, below=True)
        self._place_in_basement(last - 1, last)
        return last

    def _names_room(self, index: int) -> bool:
        mention = self.reading.mention_at.get(index)
        return mention is not None and bool(mention.room)

    def _place_in_basement(self, first: int, last: int) -> None:
        """Read "with a basement holding the archive" as the place of what follows, besides the storey."""
        people = self.reading.word(last) == "for" and self.reading.kind(last + 1) == "number"
        if self.reading.word(last) in HOLDING and not people:
            ref = FloorRef("basement", span=self.reading.span(first, last))
            self.places.append(Place(first, last, (ref,), led=False))

    def _is_refused(self, index: int) -> bool:
        """Whether "we do not make" stands at a token: the storey before it is not to be."""
        reading = self.reading
        who, denied, verb = reading.words(index, index + 3) if reading.word(index + 2) else ("", "", "")
        return who in ("we", "i", "they") and denied == "not" and verb in _WISHES

    def _unwanted_basement(self, index: int) -> int:
        """Read "no garage or basement" and "a cellar is not needed"; return where it ends, or 0."""
        reading = self.reading
        if reading.word(index) not in ("basement", "cellar") or reading.word(index + 1) in ("room", "store"):
            return 0
        before = index - 1
        while before > index - 8 and reading.word(before) not in _NEGATIONS:
            if (
                reading.breaks(before)
                or reading.word(before) in ("but", "with", ":", "in", "on", "at")  # "no windows in the basement"
                or reading.kind(before) == "number"
            ):
                before = index - 8
            before -= 1
        last = index + 1
        last += reading.word(last) in ("is", "level", "floor")
        after = reading.words(last, last + 2) in (
            ("not", "needed"),
            ("not", "wanted"),
            ("not", "required"),
            ("not", "necessary"),
        )
        refused = last == index + 1 and self._is_refused(last)
        if before <= index - 8 and not (after or refused):
            return 0
        first = before if before > index - 8 else index
        last += 3 if refused else 2 if after else index + 1 - last
        if self._is_left_out_of_area(first, index):
            reading.take(first, last)
            return last
        reading.facts.excluded.append(("basement", reading.span(first, last)))
        return last

    def _is_left_out_of_area(self, first: int, index: int) -> bool:
        """Whether an area only does not count a basement that the brief has: "3600 m2 without the basement"."""
        reading = self.reading
        area = first - 1 - (reading.word(first - 1) in ("(", ","))
        others = any(token.text in ("basement", "cellar") for n, token in enumerate(reading.tokens) if n != index)
        return others and reading.kind(area) == "unit"


def settle_counts(reading: Reading) -> None:
    """Put the largest number of storeys first: the others count parts of the building, or do not agree."""
    facts = reading.facts
    if len(facts.floors) > 1:
        best = max(facts.floors, key=lambda quantity: quantity.value)
        facts.floors = [best, *(quantity for quantity in facts.floors if quantity.value != best.value)]
    facts.basements = (
        facts.basements[:1]
        if len({q.value for q in facts.basements}) < 2
        else [max(facts.basements, key=lambda q: q.value)]
    )
