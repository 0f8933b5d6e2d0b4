"""Read what each flat, suite or other unit holds: "four flats a floor, each of two bedrooms, a bathroom and a kitchen".

A unit is a dwelling or another group of rooms with a door of its own; the brief may have many alike. What it holds is
said in the noun ("two-bedroom flats"), after it ("with", "consisting of", "(each 2 bedrooms)"), of all units in a
sentence of its own ("Every flat has ..."), or before it ("a bathroom in each flat").
"""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from mansion_planner.brief.attachment import Attachment, attach_storeys
from mansion_planner.brief.facts import FloorRef, RoomFact
from mansion_planner.brief.phrase import Phrase, finished_phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading

__all__ = ["Households", "are_dwellings", "are_units", "attach_units", "read_households", "told_apart"]

_NOUNS = {"unit": "apartment", "dwelling": "apartment", "home": "apartment", "residence": "apartment",
          "cluster": "common_room"}  # fmt: skip
"""Nouns that name a unit wherever they are counted, and the room type of its main room."""

_WORKPLACES = frozenset({"office", "business", "commercial", "workshop"})
_LODGINGS = frozenset({"hotel_room", "hotel_suite", "resident_room", "dorm_room"})
_GENERAL = frozenset({"unit", "flat", "apartment", "dwelling", "home", "residence", "room"})
_HOMES = frozenset({"flat", "studio_flat", "flat_share"})
_ONE_HOME = frozenset({"flat", "studio_flat", "penthouse", "flat_share"})

_DWELLINGS = _GENERAL | {"maisonette", "studio", "penthouse", "house", "bungalow", "townhouse", "villa", "duplex"}
"""Nouns of dwellings: another one that the knowledge base takes for one ("malt loft") is none by itself."""

_ROWS = _ONE_HOME | {"house", "townhouse", "villa", "bungalow", "cottage"}

_BEDS = frozenset({"bed", "bedroom", "br", "bedroomed", "bedded", "bdr"})
_ALL = frozenset({"each", "every", "all", "both", "per"})
_LINKS = frozenset(
    """
    with of having has have consist consisting comprise comprising contain containing include including hold holding
    offer offering feature featuring get : ( = made
    """.split()
)
_STRONG = frozenset({"each", "every", "apiece"})
_BETWEEN = frozenset(
    """
    , which that them one is are there to should must will shall also just in its up by of all both they come need
    needs and - –
    """.split()
)
_VERBS = frozenset(
    """
    has have with contain consist comprise include hold offer feature get should must will shall need also of comes
    come having containing comprising consisting
    """.split()
)
_JOINTS = frozenset(
    """
    , and & a an the one its their own plus + / with as well separate also both second third another further small
    large sharing share shared around - – one private
    """.split()
)
_SHARED_ROOMS = frozenset(
    """
    laundry_room bike_storage mail_room lobby waste_room common_room gym parking shared_kitchen garage shop cafe
    reception roof_terrace staff_room mechanical_room corridor housekeeping_room restaurant bar
    """.split()
)
"""Rooms of the whole house: they end a list of what a flat holds, unless the list is plainly of each."""

_OF_GUESTS = frozenset(
    """
    bathroom ensuite_bathroom toilet kitchen living_room bedroom walk_in_closet dressing_room home_office study_room
    entrance_hall
    """.split()
)
"""Rooms that a hotel room or another room for guests may have for itself."""

_READ_AS = {"kitchenette": "kitchen", "wet_room": "bathroom", "shower": "bathroom", "living_area": "living_room",
            "living_space": "living_room", "lounge": "living_room"}  # fmt: skip
"""Names that mean another room inside a unit than in a workplace."""

_REACH = 14
"""Tokens that may stand between a unit and the first of its rooms."""


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
    ends : dict of int to int
        Token after all that is said of a unit without a storey in between.
    floors : dict of int to tuple of FloorRef
        Storeys that stand in another form than a place ("four flats a floor").
    """

    units: dict[int, list[Phrase]] = field(default_factory=dict)
    inner: set[int] = field(default_factory=set)
    again: set[int] = field(default_factory=set)
    unnumbered: set[int] = field(default_factory=set)
    copies: dict[int, int] = field(default_factory=dict)
    ends: dict[int, int] = field(default_factory=dict)
    floors: dict[int, tuple[FloorRef, ...]] = field(default_factory=dict)

    @property
    def read(self) -> set[int]:
        """First tokens of all phrases that are no rooms of the building by themselves."""
        return self.inner | self.again


def are_units(phrase: Phrase) -> bool:
    """Whether a phrase that names homes is of several in one building: "nine flats", "four houses"."""
    several = phrase.plural and phrase.counted and (phrase.count or 0) > 1
    return phrase.building in _ROWS and (several or phrase.determiner in _ALL)


def are_dwellings(phrase: Phrase) -> bool:
    """Whether the noun of a phrase is that of a dwelling, and no "chapter house" or "malt loft"."""
    first, last = phrase.name.partition("_")[0], phrase.name.rpartition("_")[2]
    return last in _DWELLINGS - {"house", "studio"} or first in _DWELLINGS


def read_households(
    reading: Reading, phrases: list[Phrase], places: Sequence[Place], building: int | None
) -> tuple[list[Phrase], Households]:
    """Return the phrases, those of units by their plain names, and what each unit holds.

    Parameters
    ----------
    building : int, optional
        Number of the phrase that names the building itself, which is no unit.
    """
    reader = _Households(reading, phrases, places, None if building is None else phrases[building].first)
    reader.run()
    return reader.phrases, reader.found


class _Households:
    def __init__(self, reading: Reading, phrases: list[Phrase], places: Sequence[Place], building: int | None) -> None:
        self.reading, self.phrases, self.places, self.building = reading, phrases, places, building
        self.found = Households()
        self.sizes: dict[int, Phrase] = {}
        self.listed: set[int] = set()
        kinds = reading.facts.building
        self.one_home = bool(kinds) and kinds[0][0] in _ONE_HOME
        self.at_home = not kinds or reading.knowledge.buildings[kinds[0][0]].family == "home"

    def run(self) -> None:
        """Find the units, then the rooms that each statement gives them."""
        self._leave_out()
        self._further_nouns()
        self._units()
        for phrase in [p for p in self.phrases if p.first in self.found.units]:
            every = phrase.determiner in _ALL and (phrase.determiner == "each" or not phrase.counted)
            those = phrase.determiner in ("the", "these", "those") and phrase.plural and self._named_before(phrase)
            if every or those:
                self._of_all(phrase)
            else:
                self._of_one(phrase)
        self._halves()
        self._pronouns()
        for first, size in self.sizes.items():
            rooms = self.found.units.get(first)
            if rooms is not None and not any(room.room_type.endswith("bedroom") for room in rooms):
                rooms.insert(0, size)
        self._counts_behind()

    # Units ----------------------------------------------------------------------------------------------------------

    def _leave_out(self) -> None:
        """Leave out what stands for the whole: "a two-storey building with", "a terrace of four houses"."""
        for number, phrase in enumerate(self.phrases):
            roof = phrase.name == "flat" and self.reading.word(phrase.noun_end) == "roof"
            whole = roof or (not phrase.known and phrase.name in ("building", "block"))
            row = phrase.name in ("terrace", "row") and self.reading.word(phrase.last) == "of"
            if whole or row:
                self.phrases[number] = replace(phrase, head="unknown")

    def _further_nouns(self) -> None:
        """Add the units that no name of the knowledge base has: "four units", "two clusters", "office units"."""
        reading = self.reading
        for index in range(len(reading.tokens)):
            kind = _NOUNS.get(reading.word(index), "")
            read = any(
                p.begin <= index < p.noun_end and ((p.known and p.room_type) or p.head in ("object", "people"))
                for p in self.phrases
            )
            if not kind or read or self.one_home:
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
            if counted or (phrase.determiner in _ALL and any(p.room_type == kind for p in self.phrases)):
                self._put(phrase)

    def _put(self, phrase: Phrase) -> None:
        """Add a phrase in place of all that share a token with it."""
        others = [p for p in self.phrases if p.last <= phrase.first or p.first >= phrase.last]
        self.phrases[:] = sorted([*others, phrase], key=lambda p: p.first)
        self.reading.take(phrase.first, phrase.last)

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
        several = phrase.plural and phrase.counted and (phrase.count or 0) > 1
        if phrase.room_type in _LODGINGS or phrase.room_type in ("team_room", "common_room"):
            own = phrase.head == "room" and (phrase.plural or phrase.determiner in _ALL)
            return own and (phrase.room_type in _LODGINGS or phrase.name.rpartition("_")[2] in _NOUNS)
        if not self.reading.knowledge.room(phrase.room_type).unit:
            return False
        if phrase.building and phrase.building not in _HOMES:
            lone = phrase.name.endswith("_residence") and not self.at_home
            return several or lone
        if self.one_home:
            return several
        if not are_dwellings(phrase) and not several:
            return False
        if phrase.determiner in ("the", "his", "her", "our", "my") and not phrase.plural:
            return "_" in phrase.name  # "the caretaker's flat", and not the flat that is planned
        return several or phrase.plural or phrase.determiner in _ALL | {"a", "an", "another"} or phrase.counted

    def _plain(self, phrase: Phrase) -> Phrase:
        """Return a unit by its noun alone; the number of bedrooms in it is kept apart."""
        reading = self.reading
        for index in range(phrase.first, phrase.noun_end - 1):
            counting = index == phrase.first and reading.tokens[index + 1].spaced
            if reading.kind(index) == "number" and reading.word(index + 1) in _BEDS and not counting:
                self.sizes[phrase.first] = self._bedrooms(index)
        words = [
            index
            for index in range(phrase.begin, phrase.noun_end)
            if reading.kind(index) == "word" and reading.word(index) not in _BEDS | {"x", "room"}
        ]
        if not words or phrase.room_type in _LODGINGS:
            return phrase
        name = "_".join(part for part in phrase.name.split("_") if part in {reading.word(i) for i in words})
        label = reading.text[reading.tokens[words[0]].start : reading.tokens[phrase.noun_end - 1].end]
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
            self._put(other)
            self.found.units[first] = []
            self.sizes[first] = self._bedrooms(size)
            self.found.copies[first] = unit.first
            end = first

    # Statements -----------------------------------------------------------------------------------------------------

    def _of_one(self, unit: Phrase) -> None:
        """Read what follows a unit that the brief asks for."""
        rooms, end = self._list_after(unit.last, always=False, guests=unit.room_type in _LODGINGS)
        if rooms:
            self._give(self._same_noun(unit.first), rooms)
            if not any(unit.last <= place.first < rooms[0].first for place in self.places):
                self.found.ends[unit.first] = end
        reading = self.reading
        index = max(unit.last, unit.noun_end)
        if reading.word(index) in ("a", "per", "/") and reading.word(index + 1) in FLOOR_WORDS:
            span = reading.span(index, index + 2)
            self.found.floors[unit.first] = (FloorRef("every", span=span),)
            reading.take(index, index + 2)

    def _same_noun(self, first: int) -> list[int]:
        """Return the units that share their noun with one, itself among them."""
        noun = self.found.copies.get(first, first)
        return [noun, *(copy for copy, other in self.found.copies.items() if other == noun)]

    def _of_all(self, unit: Phrase) -> None:
        """Read "Every flat has ..." and "a bathroom in each flat"."""
        owners = self._owners(unit)
        self.found.again.add(unit.first)
        before = self.reading.word(unit.first - 1)
        rooms: list[Phrase] = []
        if unit.determiner == "per" or before in ("in", "for", "per", "to"):
            rooms = self._list_before(unit.first - (before in ("in", "for", "per", "to")))
        if not rooms:
            rooms, _ = self._list_after(unit.last, always=True, guests=unit.room_type in _LODGINGS)
        if not rooms:
            return
        if not owners:
            self.found.again.discard(unit.first)
            self.found.unnumbered.add(unit.first)
            self._give([unit.first], rooms)
        else:
            self._give(owners, rooms)

    def _named_before(self, unit: Phrase) -> bool:
        return any(p.first < unit.first and p.first in self.found.units and _alike(unit, p) for p in self.phrases)

    def _owners(self, unit: Phrase) -> list[int]:
        """Return the units that "each flat" means: those before it that nothing was said of, or all, else others."""
        reading = self.reading
        others = [
            p for p in self.phrases
            if p.first in self.found.units and p.first != unit.first and _alike(unit, p)
            and p.first not in self.found.again | self.found.unnumbered
            and not (p.determiner in _ALL and not p.counted)
        ]  # fmt: skip
        sized = self.sizes.get(unit.first)
        if sized is not None:
            others = [p for p in others if p.first in self.sizes and self.sizes[p.first].count == sized.count] or others
        earlier = [p for p in others if p.first < unit.first]
        near = [p for p in earlier if reading.sentence[p.first] == reading.sentence[unit.first]]
        bare = [p for p in earlier if p.first not in self.listed]
        return [p.first for p in near or bare or earlier or others]

    def _pronouns(self) -> None:
        """Read "Each has ...", "all of them with ..." and "they have ... each" of the units named last."""
        reading = self.reading
        for index, token in enumerate(reading.tokens):
            if (
                token.text not in ("each", "all", "both", "they", "every")
                or index in reading.taken
                or any(p.first <= index < p.last for p in self.phrases if p.first in self.found.units)
            ):
                continue
            if not (reading.starts(index) or reading.word(index - 1) in (",", ";", "and", ":", "-")):
                continue
            verb = next((i for i in range(index + 1, index + 5) if reading.word(i) in _VERBS), None)
            if verb is None or any(p.first < verb and p.last > index + 1 for p in self.phrases if p.head == "room"):
                continue
            owners = self._last_units(index)
            if not owners:
                continue
            guests = any(p.first in owners and p.room_type in _LODGINGS for p in self.phrases)
            rooms, _ = self._list_after(verb, always=True, guests=guests)
            self._give(owners, rooms)
            if rooms:
                reading.take(index, verb)

    def _last_units(self, index: int) -> list[int]:
        """Return the units named last before a token, in its sentence or the two before, if nothing else is meant."""
        reading = self.reading
        for phrase in reversed([p for p in self.phrases if p.last <= index]):
            if phrase.first in self.found.inner or phrase.head not in ("room", "building"):
                continue
            if reading.sentence[index] - reading.sentence[phrase.first] > 2:
                return []
            if phrase.first in self.found.again:
                return self._owners(phrase)
            if phrase.first in self.found.units:
                return self._same_noun(phrase.first)
            if phrase.first == self.building or not phrase.plural:
                continue
            return []
        return []

    def _halves(self) -> None:
        """Read "One has one bedroom and the other has three" of two flats."""
        reading = self.reading
        for index in range(len(reading.tokens)):
            one = reading.kind(index) == "number" and reading.value(index) == 1 and reading.starts(index)
            if not one or reading.word(index + 1) not in ("has", "have", "with", "of"):
                continue
            owners = self._last_units(index)
            unit = next((p for p in self.phrases if owners and p.first == owners[0]), None)
            rooms, end = self._list_after(index + 1, always=True)
            other = next((i for i in range(end, end + 4) if reading.word(i) == "other"), None)
            if unit is None or not rooms or other is None or (unit.count or 0) < 2:
                continue
            later, _ = self._list_after(other + 1, always=True)
            common = list(self.found.units[unit.first])
            part = replace(unit, first=index, begin=index, noun_end=index + 1, last=index + 1, count=1)
            self._put(part)
            number = next(n for n, p in enumerate(self.phrases) if p.first == unit.first)
            self.phrases[number] = replace(unit, count=(unit.count or 2) - 1)
            self.found.copies[index] = unit.first
            self.found.units[index] = common
            self._give([index], rooms)
            self._give([unit.first], later)

    def _counts_behind(self) -> None:
        """Read "flats of two bedrooms and a bathroom, three on each floor": the number stands behind."""
        reading = self.reading
        for number, phrase in enumerate(self.phrases):
            if phrase.first not in self.found.units or phrase.counted or not phrase.plural:
                continue
            index = self.found.ends.get(phrase.first, phrase.last)
            if reading.word(index) in (",", ":", "-", "("):
                index += 1
            if reading.kind(index) == "number" and any(place.first == index + 1 for place in self.places):
                self.phrases[number] = replace(phrase, count=int(reading.value(index)), counted=True)
                self.found.ends[phrase.first] = index + 1
                reading.take(index, index + 1)

    def _give(self, owners: Sequence[int], rooms: Sequence[Phrase]) -> None:
        for owner in owners:
            held = self.found.units.setdefault(owner, [])
            held += [room for room in rooms if all(room.first != other.first for other in held)]
            self.listed.add(owner)
        self.found.inner |= {room.first for room in rooms}

    # Lists of rooms -------------------------------------------------------------------------------------------------

    def _list_after(self, start: int, *, always: bool, guests: bool = False) -> tuple[list[Phrase], int]:
        """Return the rooms listed behind a token, and where the list ends.

        Parameters
        ----------
        always : bool
            The words before say already that the list is of each unit.
        guests : bool
            The units are rooms for guests, which hold few other rooms.
        """
        index, linked, strong, placed = self._linked(start)
        rooms: list[Phrase] = []
        closed = trailing = False
        while True:
            begin, joined = self._joints(index, first=not rooms)
            if len(rooms) == 1 and not always and self.reading.words(index, index + 2) == (",", "and"):
                break  # a list of two has no comma: what follows is a statement of its own
            room = self._room_at(begin)
            if room is None or (rooms and begin == index):
                break
            kind = _READ_AS.get(room.name, room.room_type)
            if guests and kind not in _OF_GUESTS:
                break
            if not always and (kind in _SHARED_ROOMS or (rooms and closed and not strong)):
                break
            if rooms and self._is_elsewhere(room, placed=placed):
                break
            closed = closed or (joined and bool(rooms))
            rooms.append(replace(room, room_type=kind, known=room.known or room.name in _READ_AS))
            index, each = self._after_room(room.last)
            trailing = trailing or each
            living = self._living_at(index)
            if living is not None:
                rooms.append(living)
                index = living.last
        if not (linked or strong or always or trailing) or not rooms:
            return [], start
        self.reading.take(start, index)
        return rooms, index

    def _linked(self, start: int) -> tuple[int, bool, bool, bool]:
        """Return where a list may begin, and whether a link, a word for each and a storey stand before it."""
        reading, index = self.reading, start
        linked = strong = placed = False
        opened = self._opened_list(start)
        if opened:
            return opened, True, strong, placed
        while index < len(reading.tokens) and index - start < _REACH:
            place = next((p for p in self.places if p.first <= index < p.last), None)
            if place is not None:
                index, placed = place.last, True
                continue
            word, kind = reading.word(index), reading.kind(index)
            floor = word in ("a", "per") and reading.word(index + 1) in FLOOR_WORDS
            if floor:
                index, placed = index + 2, True
                continue
            if kind == "unit" or (kind == "number" and self._in_measure(index)):
                index += 1
                continue
            if self._room_at(index) is not None or not (word in _LINKS or word in _STRONG or word in _BETWEEN):
                break
            linked = linked or (word in _LINKS and not self._before_measure(index))
            of_area = word in _STRONG and reading.kind(index - 1) == "unit"
            strong = strong or (word in _STRONG and not of_area and reading.word(index + 1) != ",")
            index += 1
        return index, linked, strong, placed

    def _opened_list(self, start: int) -> int:
        """Return where the list of "a flat for the caretaker: ..." or of "ABOVE: flat. ..." begins, or 0."""
        reading = self.reading
        if reading.word(start) == "for":
            colon = next((i for i in range(start + 1, start + 6) if reading.word(i) == ":"), 0)
            return colon + 1 if colon and self._room_at(colon + 1) is not None else 0
        headed = reading.word(start) == "." and any(
            reading.word(i) == ":"
            for i in range(max(start - 5, 0), start)
            if reading.sentence[i] == reading.sentence[start]
        )
        return start + 1 if headed and self._room_at(start + 1) is not None else 0

    def _in_measure(self, index: int) -> bool:
        return any(self.reading.kind(i) == "unit" for i in range(index + 1, index + 3))

    def _before_measure(self, index: int) -> bool:
        """Whether "of" or "with" leads to an area: "three flats of about 65 m2"."""
        ahead = range(index + 1, index + 4)
        number = next((i for i in ahead if self.reading.kind(i) == "number"), None)
        return number is not None and self._in_measure(number) and self._room_at(index + 1) is None

    def _joints(self, index: int, *, first: bool) -> tuple[int, bool]:
        """Return the token after words that join the rooms of a list, and whether "and" is among them."""
        joined = False
        for _ in range(5):
            if self._room_at(index) is not None:
                break
            word = self.reading.word(index)
            ordinal = self.reading.kind(index) == "ordinal"
            if not (word in _JOINTS or ordinal) or self.reading.breaks(index):
                break
            joined = joined or word in ("and", "&")
            index += 1
        return index, joined and not first

    def _room_at(self, index: int) -> Phrase | None:
        """Return the room that a phrase names at a token."""
        return next(
            (
                p for p in self.phrases
                if p.first <= index < p.noun_end and p.head == "room" and p.room_type
                and p.first not in self.found.units and p.first != self.building
            ),
            None,
        )  # fmt: skip

    def _after_room(self, index: int) -> tuple[int, bool]:
        """Return the token after the area and the "each" that follow a room, and whether there is an "each"."""
        reading = self.reading
        ahead = next((i for i in range(index, index + 4) if reading.kind(i) == "number"), None)
        if ahead is not None and self._in_measure(ahead) and all(
            reading.word(i) in ("of", "about", "with", "(", "around", "circa") for i in range(index, ahead)
        ):  # fmt: skip
            index = next(i for i in range(ahead, ahead + 3) if reading.kind(i) == "unit") + 1
            index += reading.word(index) == ")"
        each = reading.word(index) in _STRONG and not self._room_at(index)
        return index + each, each

    def _living_at(self, index: int) -> Phrase | None:
        """Return the living room of "open kitchen-living", which has no noun of its own."""
        reading = self.reading
        index += reading.word(index) in ("/", "-", "–", "+", "&", "and")
        if reading.word(index) != "living" or self._room_at(index) is not None:
            return None
        last = index + 1 + (reading.word(index + 1) in ("area", "space"))
        reading.take(index, last)
        return Phrase("room", index, index, last, last, "living_room", name="living_room", label="living room")

    def _is_elsewhere(self, room: Phrase, *, placed: bool) -> bool:
        """Whether a storey of its own follows a room, so that it is none of the unit's."""
        behind = next((p for p in self.places if 0 <= p.first - room.last <= 1 and p.led), None)
        if behind is None or behind.refs[0].kind == "every":
            return False
        return placed or room.room_type in _SHARED_ROOMS

    def _list_before(self, end: int) -> list[Phrase]:
        """Return the rooms listed right before a token."""
        rooms: list[Phrase] = []
        while True:
            room = next(
                (p for p in self.phrases if p.last == end and p.head == "room" and p.first not in self.found.units),
                None,
            )
            if room is None or room.first == self.building or room.first in self.found.inner:
                return rooms[::-1]
            rooms.append(replace(room, room_type=_READ_AS.get(room.name, room.room_type)))
            end = room.first
            while self.reading.word(end - 1) in ("and", ",", "&", "a", "an", "one") and not self.reading.breaks(
                end - 1
            ):
                end -= 1


def _alike(first: Phrase, second: Phrase) -> bool:
    """Whether "each flat" may mean units that are called otherwise."""
    if first.room_type == "team_room" or second.room_type == "team_room":
        return first.room_type == second.room_type
    return first.name == second.name or first.name.rpartition("_")[2] in _GENERAL


def attach_units(
    reading: Reading, places: list[Place], phrases: list[Phrase], building: int | None, households: Households
) -> dict[int, Attachment]:
    """Return the storeys of phrases, by number, where the rooms of units have those of their unit.

    See `mansion_planner.brief.attachment.attach_storeys`, which reads the other phrases.
    """
    outer = [
        n for n, p in enumerate(phrases)
        if p.first not in households.inner and (p.first not in households.copies or n == building)
    ]  # fmt: skip
    shown = [replace(phrases[n], last=households.ends.get(phrases[n].first, phrases[n].last)) for n in outer]
    named = outer.index(building) if building in outer else None
    found = {outer[n]: entry for n, entry in attach_storeys(reading, places, shown, named).items()}
    numbers = {p.first: n for n, p in enumerate(phrases)}
    for first in households.units:
        number = numbers.get(first)
        if number is None or first in households.copies:
            continue
        if first in households.floors and number not in found:
            found[number] = Attachment(households.floors[first], each=True)
        if number in found:
            found[number] = _narrowed(reading, places, phrases[number], found[number])
    for first, other in households.copies.items():
        if numbers.get(other) in found:
            found[numbers[first]] = found[numbers[other]]
    return found


def _narrowed(reading: Reading, places: list[Place], unit: Phrase, given: Attachment) -> Attachment:
    """Return "four flats per floor" for the storeys that its clause opens with ("Floors 1 to 6: ...")."""
    if [ref.kind for ref in given.refs] != ["every"] or not any(given.refs == place.refs for place in places):
        return given
    every = next(place for place in places if given.refs == place.refs)
    if "all" in reading.words(every.first, every.last):
        return given
    if 0 <= every.first - unit.last <= 1 and reading.word(every.first) == "per":
        given = replace(given, each=True)
    openers = [
        place for place in places
        if place.last <= unit.first and reading.sentence[place.first] == reading.sentence[unit.first]
        and (place.heading or reading.starts(place.first)) and place.refs[0].kind != "every"
    ]  # fmt: skip
    if openers:
        return replace(given, refs=openers[-1].refs, each=True)
    rest = _remaining(reading, places, unit)
    return given if rest is None else replace(given, refs=(rest,), each=True)


def _remaining(reading: Reading, places: list[Place], unit: Phrase) -> FloorRef | None:
    """Return the storeys above all that are named before, for "the remaining floors"."""
    sentence = reading.sentence[unit.first]
    words = [i for i in range(unit.first) if reading.sentence[i] == sentence]
    if not any(reading.word(i) in ("remaining", "other", "rest") for i in words) or not reading.facts.floors:
        return None
    below = [ref.last for p in places if p.last <= words[0] for ref in p.refs if ref.kind in ("number", "range")]
    top = int(reading.facts.floors[0].value)
    if not below or max(below) >= top:
        return None
    span = reading.span(words[0], unit.last)
    return FloorRef("range", max(below) + 1, top, span)


_NUMBERS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")


def told_apart(facts: Sequence[RoomFact]) -> list[RoomFact]:
    """Return room facts; units of one name and the same storeys that hold different rooms get names of their own."""
    told = list(facts)
    units = [n for n, fact in enumerate(told) if fact.unit]
    for n, m in itertools.combinations(units, 2):
        if facts[n].name != facts[m].name or _where(facts[n]) != _where(facts[m]):
            continue
        if _holding(facts[n]) != _holding(facts[m]):
            told[n], told[m] = _by_size(facts[n]), _by_size(facts[m])
            if told[n].name == told[m].name:
                told[m] = replace(told[m], name=f"other_{told[m].name}", label=f"other {told[m].label}")
    return told


def _where(fact: RoomFact) -> list[tuple[str, int, int]]:
    return [(ref.kind, ref.first, ref.last) for ref in fact.floors]


def _holding(fact: RoomFact) -> list[tuple[str, int | None]]:
    return sorted((room.room_type, room.count) for room in fact.suite)


def _by_size(fact: RoomFact) -> RoomFact:
    """Return a unit named by how many sleep there: no name with "bedroom", which is another room's."""
    beds = sum(room.count or 1 for room in fact.suite if room.room_type.endswith("bedroom"))
    number = _NUMBERS[beds] if beds < len(_NUMBERS) else "many"
    return replace(fact, name=f"{number}_bed_{fact.name}", label=f"{number}-bed {fact.label}")
