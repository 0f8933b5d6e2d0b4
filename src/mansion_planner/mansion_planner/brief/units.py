"""Find which phrases of a brief name dwellings and other units of several rooms: "four flats", "two office units"."""

from dataclasses import dataclass, field, replace

from mansion_planner.brief.facts import FloorRef
from mansion_planner.brief.groups import groups_of_rooms, named_again
from mansion_planner.brief.phrase import Phrase, finished_phrase
from mansion_planner.brief.reading import Reading

__all__ = [
    "ALL",
    "GENERAL",
    "LODGINGS",
    "TELLING",
    "Households",
    "are_dwellings",
    "are_units",
    "find_units",
    "flats_that_open",
    "is_type_of_flat",
    "put_phrase",
]

_NOUNS = {"unit": "apartment", "dwelling": "apartment", "home": "apartment", "residence": "apartment",
          "cluster": "common_room"}  # fmt: skip
"""Nouns that name a unit wherever they are counted, and the room type of its main room."""

_PARTS_OF_HOMES = frozenset({"wing", "household", "pod"})
"""Nouns that do so in homes; in other buildings they are parts that corridors join."""

_WORKPLACES = frozenset({"office", "business", "commercial", "workshop"})
LODGINGS = frozenset({"hotel_room", "hotel_suite", "resident_room", "dorm_room"})
"""Rooms for guests and residents, each of which is a unit."""

GENERAL = frozenset({"unit", "flat", "apartment", "dwelling", "home", "residence", "room"})
"""Nouns that may mean a unit of any kind."""

_HOMES = frozenset({"flat", "studio_flat", "flat_share"})
_ONE_HOME = frozenset({"flat", "studio_flat", "penthouse", "flat_share"})

_DWELLINGS = GENERAL | {"maisonette", "studio", "penthouse", "house", "bungalow", "townhouse", "villa", "duplex"}
"""Nouns of dwellings: another one that the knowledge base takes for one ("malt loft") is none by itself."""

_LISTING = frozenset({"with", "of", "having", "containing", "comprising", "including"})
"""Words between a dwelling and the list of its rooms."""

_LEVEL_THINGS = frozenset({"roof", "plan", "site", "plot", "land", "ground", "terrain", "facade"})
_ADJECTIVES = 2
"""Words between "flat" and what it is said of, at most."""

_ROWS = _ONE_HOME | {"house", "townhouse", "villa", "bungalow", "cottage"}

_BEDS = frozenset({"bed", "bedroom", "br", "bedroomed", "bedded", "bdr"})
TELLING = frozenset({"has", "consist", "consists", "contain", "contains", "comprise", "comprises", "have", "hold", "="})
"""Verbs after "a cluster" that tell what each of the clusters holds."""
ALL = frozenset({"each", "every", "all", "both", "per"})
"""Determiners that speak of all units of a kind."""


@dataclass
class Households:
    """What units hold, by the first token of the phrase that names them.

    Attributes
    ----------
    units : dict of int to list of Phrase
        Rooms of each such unit; empty for a unit of which nothing is said.
    inner : set of int
        First tokens of the phrases that name such rooms.
    again : set of int
        First tokens of the phrases that speak of units named elsewhere.
    unnumbered : set of int
        First tokens of "every flat" where no flats are counted.
    copies : dict of int to int
        Units that were parted from another one ("one has ..., the other ..."), and that other one.
    sizes : dict of int to Phrase
        The bedrooms that the noun of a unit tells ("two-bedroom flats").
    ends : dict of int to int
        Token after all that is said of a unit without a storey in between.
    floors : dict of int to tuple of FloorRef
        Storeys that stand in another form than a place ("four flats a floor").
    headed : dict of int to tuple of FloorRef
        Storeys that stand between a unit and the list of its rooms ("Flat upstairs: ...").
    """

    units: dict[int, list[Phrase]] = field(default_factory=dict)
    inner: set[int] = field(default_factory=set)
    again: set[int] = field(default_factory=set)
    unnumbered: set[int] = field(default_factory=set)
    copies: dict[int, int] = field(default_factory=dict)
    sizes: dict[int, Phrase] = field(default_factory=dict)
    ends: dict[int, int] = field(default_factory=dict)
    floors: dict[int, tuple[FloorRef, ...]] = field(default_factory=dict)
    headed: dict[int, tuple[FloorRef, ...]] = field(default_factory=dict)

    @property
    def read(self) -> set[int]:
        """First tokens of all phrases that are no rooms of the building by themselves."""
        return self.inner | self.again


def are_units(phrase: Phrase) -> bool:
    """Whether a phrase that names homes is of several in one building: "nine flats", "four houses"."""
    several = phrase.plural and phrase.counted and (phrase.count or 0) > 1
    return phrase.building in _ROWS and (several or phrase.determiner in ALL)


def is_type_of_flat(reading: Reading, phrases: list[Phrase], number: int) -> bool:
    """Whether a phrase names one of several types of flats, and no building: "two one-bed flats and a two-bed flat"."""
    phrase = phrases[number]
    sized = not _BEDS.isdisjoint(reading.words(phrase.begin, phrase.noun_end))
    others = [p for n, p in enumerate(phrases) if n != number and p.building == phrase.building]
    return phrase.building == "flat" and sized and any(are_units(other) for other in others)


def are_dwellings(phrase: Phrase) -> bool:
    """Whether the noun of a phrase is that of a dwelling, and no "chapter house" or "malt loft"."""
    first, last = phrase.name.partition("_")[0], phrase.name.rpartition("_")[2]
    return last in _DWELLINGS - {"house", "studio"} or first in _DWELLINGS


def flats_that_open(reading: Reading, phrases: list[Phrase]) -> Phrase | None:
    """Return the flats that only say what the building is, where the brief counts them later.

    "Micro-apartments for students. Five storeys ... each with sixteen apartments" has sixteen on a storey.
    """
    first = phrases[0] if phrases else None
    if first is None or first.begin > 1 or not first.plural or first.counted or not first.room_type:
        return None
    alone = all(p.head == "people" for p in phrases[1:] if reading.sentence[p.first] == reading.sentence[first.first])
    if not alone or not reading.knowledge.room(first.room_type).unit:
        return None
    later = [p for p in phrases[1:] if p.counted and p.room_type and reading.knowledge.room(p.room_type).unit]
    return first if any(p.name in GENERAL or p.name == first.name for p in later) else None


def find_units(reading: Reading, phrases: list[Phrase], building: int | None) -> Households:
    """Return the units of a brief, nothing in them yet; `phrases` gets them by their plain names.

    Parameters
    ----------
    building : int, optional
        First token of the phrase that names the building itself, which is no unit.
    """
    finder = _Units(reading, phrases, building)
    finder.run()
    return finder.found


class _Units:
    def __init__(self, reading: Reading, phrases: list[Phrase], building: int | None) -> None:
        self.reading, self.phrases, self.building = reading, phrases, building
        self.found = Households()
        self.groups: set[int] = set()
        kinds = reading.facts.building
        self.one_home = bool(kinds) and kinds[0][0] in _ONE_HOME
        self.at_home = not kinds or reading.knowledge.buildings[kinds[0][0]].family == "home"

    def run(self) -> None:
        """Find the nouns, then the units among them."""
        self._leave_out()
        self._further_nouns()
        self._groups()
        self._units()

    def _leave_out(self) -> None:
        """Leave out what stands for the whole: "a two-storey building with", "a terrace of four houses"."""
        for number, phrase in enumerate(self.phrases):
            whole = self._is_level(phrase) or (not phrase.known and phrase.name in ("building", "block"))
            row = phrase.name in ("terrace", "row") and self.reading.word(phrase.last) == "of"
            if whole or row or self._is_wing(phrase):
                self.phrases[number] = replace(phrase, head="unknown")

    def _is_wing(self, phrase: Phrase) -> bool:
        """Whether a wing is only where rooms are: "east wing with six classrooms", "the other wing: kitchen"."""
        last = phrase.name.rpartition("_")[2]
        one = not phrase.plural and phrase.determiner not in ALL
        return last in ("wing", "wings") and phrase.head == "room" and not phrase.known and one

    def _is_level(self, phrase: Phrase) -> bool:
        """Whether "flat" tells the form of something: "a flat roof", "a flat simple rectangular plan"."""
        ahead = self.reading.words(phrase.noun_end, phrase.noun_end + _ADJECTIVES + 1)
        nouns = [at for at, word in enumerate(ahead) if word in _LEVEL_THINGS]
        plain = bool(nouns) and all(self.reading.kind(phrase.noun_end + at) == "word" for at in range(nouns[0]))
        return phrase.name == "flat" and plain and _LISTING.isdisjoint(ahead[: nouns[0]])

    def _further_nouns(self) -> None:
        """Add the units that no name of the knowledge base has: "four units", "two clusters", "office units"."""
        reading = self.reading
        for index in range(len(reading.tokens)):
            kind = _NOUNS.get(reading.word(index), "")
            if reading.word(index) in _PARTS_OF_HOMES and self._is_home():
                kind = "common_room"
            if not kind or self.one_home:
                continue
            read = any(
                p.begin <= index < p.noun_end and ((p.known and p.room_type) or p.head in ("object", "people"))
                for p in self.phrases
            )
            if read:
                continue
            begin = index
            if reading.word(index - 1) in _WORKPLACES:
                begin, kind = index - 1, "team_room"
            elif reading.word(index - 1) in _BEDS and reading.kind(index - 2) == "number":
                begin = index - 2
            taken = set(reading.taken)
            for other in self.phrases:
                if other.first <= index < other.last or other.first <= begin < other.last:
                    reading.taken.difference_update(range(other.first, other.last))
            phrase = finished_phrase(reading, "room", begin, index + 1, room=kind)
            reading.taken |= taken
            counted = phrase.counted and (phrase.count or 0) > 1 and phrase.plural
            generic = phrase.determiner in ALL or (phrase.determiner in ("a", "an", "one") and self._tells(phrase))
            if counted or (generic and any(p.room_type == kind for p in self.phrases)):
                put_phrase(reading, self.phrases, phrase)

    def _tells(self, phrase: Phrase) -> bool:
        """Whether it is told what such a unit holds: "a cluster consists of six rooms"."""
        return self.reading.word(phrase.last) in TELLING

    def _is_home(self) -> bool:
        """Whether the brief is about a home."""
        own = next((phrase for phrase in self.phrases if phrase.first == self.building), None)
        record = None if own is None else self.reading.knowledge.buildings.get(own.building)
        return record is not None and record.family == "home"

    def _groups(self) -> None:
        """Add the groups of rooms that each hold the same."""
        if self._is_home() or self.one_home:
            return
        for group in groups_of_rooms(self.reading, self.phrases):
            for phrase in group:
                put_phrase(self.reading, self.phrases, phrase)
                self.groups.add(phrase.first)
                self.found.copies |= {phrase.first: group[0].first} if phrase is not group[0] else {}
            self._spoken_of(group[0])
            for name in named_again(self.reading, group):
                put_phrase(self.reading, self.phrases, name)

    def _spoken_of(self, group: Phrase) -> None:
        """Add the phrases that speak of each of some groups: "every household has a kitchen"."""
        reading = self.reading
        noun = group.name.rpartition("_")[2]
        for index in range(group.last, len(reading.tokens) - 1):
            told = reading.word(index) in ("a", "an", "one") and reading.word(index + 2) in TELLING
            if (reading.word(index) in ALL or told) and reading.word(index + 1) == noun:
                again = finished_phrase(reading, "room", index + 1, index + 2, room=group.room_type, known=False)
                put_phrase(reading, self.phrases, again)
                self.groups.add(again.first)

    def _units(self) -> None:
        for phrase in list(self.phrases):
            if not self._is_unit(phrase):
                continue
            plain = self._plain(phrase)
            self.phrases[self.phrases.index(phrase)] = plain
            self.found.units[plain.first] = []
            self._ellipses(plain)

    def _is_unit(self, phrase: Phrase) -> bool:
        if phrase.first == self.building or phrase.head not in ("room", "building") or not phrase.room_type:
            return False
        if phrase.first in self.groups:
            return True
        if phrase.room_type in LODGINGS and self._is_in_group(phrase):
            return False
        if phrase.name == "suite" and any(p.name.endswith("_suite") and p.room_type == "bedroom" for p in self.phrases):
            return False  # "six bedroom suites; each suite has a dressing room"
        several = phrase.plural and phrase.counted and (phrase.count or 0) > 1
        if phrase.room_type in LODGINGS or phrase.room_type in ("team_room", "common_room"):
            generic = (
                phrase.determiner in ("a", "an", "one") and phrase.room_type == "common_room" and self._tells(phrase)
            )
            own = phrase.head == "room" and (phrase.plural or phrase.determiner in ALL or generic)
            parts = _PARTS_OF_HOMES if self._is_home() else frozenset[str]()
            return own and (phrase.room_type in LODGINGS or phrase.name.rpartition("_")[2] in _NOUNS.keys() | parts)
        if not self.reading.knowledge.room(phrase.room_type).unit:
            return False
        if self._heads_list(phrase) and phrase.name.rpartition("_")[2] in GENERAL - {"unit", "room"}:
            return True
        if phrase.building and phrase.building not in _HOMES:
            lone = phrase.name.endswith("_residence") and not self.at_home
            return several or lone
        if self.one_home:
            return several
        if not are_dwellings(phrase) and not several:
            return False
        if phrase.determiner in ("the", "his", "her", "our", "my") and not phrase.plural:
            return "_" in phrase.name  # "the caretaker's flat", and not the flat that is planned
        if "_" in phrase.name and not phrase.plural and self._is_told_later(phrase):
            return True
        sized = self.reading.kind(phrase.begin - 1) == "number" and self.reading.word(phrase.begin) in _BEDS
        listed = phrase.determiner in ALL | {"a", "an", "another"}
        return several or phrase.plural or listed or phrase.counted or sized  # "upstairs two-bedroom flat"

    def _is_told_later(self, phrase: Phrase) -> bool:
        """Whether a later sentence lists the rooms of a dwelling by its noun: "florist's flat. ... Flat above: ..."."""
        noun = phrase.name.rpartition("_")[2]
        return any(
            p.first > phrase.last and p.name == noun and p.name in GENERAL and self._heads_list(p) for p in self.phrases
        )

    def _is_in_group(self, phrase: Phrase) -> bool:
        """Whether a group of rooms is right before a phrase and holds it: "a cluster consists of six single rooms"."""
        return any(
            group.room_type == "common_room"
            and group.last < phrase.first
            and set(self.reading.words(group.last, phrase.first)) <= TELLING | {"of", "with", "each", ","}
            for group in self.phrases
        )

    def _heads_list(self, phrase: Phrase) -> bool:
        """Whether the dwelling heads a list of rooms: "first floor is the flat: ...", "upstairs: flat with ..."."""
        reading = self.reading
        one = not phrase.plural and phrase.determiner not in ALL
        placed = phrase.last + (reading.word(phrase.last) in ("upstair", "upstairs", "above"))
        opened = one and (reading.word(phrase.last) in (":", "(") or reading.word(placed) == ":")
        headed = not phrase.determiner and reading.word(phrase.first - 1) in (":", "=")
        return opened or (headed and reading.word(phrase.last) in _LISTING)

    def _plain(self, phrase: Phrase) -> Phrase:
        """Return a unit by its noun alone; the number of bedrooms in it is kept apart."""
        reading = self.reading
        if phrase.first in self.groups:
            return phrase
        alone = phrase.first == phrase.begin and reading.kind(phrase.begin - 1) == "number"
        for index in range(phrase.first - alone, phrase.noun_end - 1):
            counting = index == phrase.first and reading.tokens[index + 1].spaced
            if reading.kind(index) == "number" and reading.word(index + 1) in _BEDS and not counting:
                self.found.sizes[phrase.first] = self._bedrooms(index)
            rooms = reading.value(index) if _counts_rooms(reading, index) else 0.0
            if rooms > 1 and phrase.room_type == "apartment":
                self.found.sizes[phrase.first] = replace(self._bedrooms(index), count=int(rooms) - 1)
            elif rooms == 1 and phrase.room_type == "apartment":
                label = f"one-room {reading.word(phrase.noun_end - 1)}"
                return replace(phrase, room_type="studio_apartment", name="one_room_flat", label=label)
        words = [
            index
            for index in range(phrase.begin, phrase.noun_end)
            if reading.kind(index) == "word" and reading.word(index) not in _BEDS | {"x", "room"}
        ]
        if not words or phrase.room_type in LODGINGS:
            return phrase
        name = "_".join(part for part in phrase.name.split("_") if part in {reading.word(i) for i in words})
        label = reading.text[reading.tokens[words[0]].start : reading.tokens[phrase.noun_end - 1].end]
        if reading.tokens[words[0]].start == reading.tokens[words[0] - 1].start:
            label = reading.word(words[0])  # a noun that the text leaves out
        return replace(phrase, name=name or reading.word(words[-1]), label=label)

    def _bedrooms(self, index: int) -> Phrase:
        """Return the phrase of "two-bedroom" at a token."""
        count = int(self.reading.value(index))
        self.reading.take(index, index + 2)
        return Phrase("room", index, index, index + 2, index + 2, "bedroom", name="bedroom", label="bedroom",
                      count=count, counted=True, plural=count > 1)  # fmt: skip

    def _ellipses(self, unit: Phrase) -> None:
        """Read "one 1-bed and two 2-bed flats" as two kinds of flats."""
        reading, end = self.reading, unit.first
        while reading.word(end - 1) in ("and", ",", "&", "/", "plus"):
            size = end - 3
            if reading.kind(size) != "number" or reading.word(size + 1) not in _BEDS:
                return
            first = size - 1 if reading.kind(size - 1) == "number" else size
            count = int(reading.value(first)) if first < size else 1
            other = replace(
                unit, first=first, begin=size, noun_end=size + 2, last=size + 2, count=count, counted=first < size,
                areas=(),
            )  # fmt: skip
            put_phrase(reading, self.phrases, other)
            self.found.units[first] = []
            self.found.sizes[first] = self._bedrooms(size)
            self.found.copies[first] = unit.first
            end = first


def _counts_rooms(reading: Reading, index: int) -> bool:
    """Whether "3-room" stands at a token: a living room and bedrooms, as flats are counted on the continent."""
    return reading.kind(index) == "number" and (
        reading.word(index + 1) == "room" and not reading.tokens[index + 1].spaced and reading.value(index) <= 8
    )


def put_phrase(reading: Reading, phrases: list[Phrase], phrase: Phrase) -> None:
    """Add a phrase in place of all that share a token with it."""
    others = [p for p in phrases if p.last <= phrase.first or p.first >= phrase.last]
    phrases[:] = sorted([*others, phrase], key=lambda p: p.first)
    reading.take(phrase.first, phrase.last)
