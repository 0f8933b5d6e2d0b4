"""Read a brief: storeys, areas, building type, rooms, furniture and wishes, each from the words that state it.

The text is parsed from the smallest parts up: tokens, then areas and storey references, then noun phrases, then what
joins them (storeys, relations, negations, "each with"), and at last the facts. Every token belongs to one part at most;
content words that belong to none are reported as not understood. No step looks further than its sentence, so the time
is proportional to the length of the text.
"""

from dataclasses import replace

from mansion_knowledge import KnowledgeBase
from mansion_planner.brief.adverts import read_adverts, read_bedrooms_of_building
from mansion_planner.brief.attachment import Attachment
from mansion_planner.brief.building import building_phrase, own_building_name, unknown_building
from mansion_planner.brief.coreference import coreferences
from mansion_planner.brief.exclusions import negated_phrases, read_completeness
from mansion_planner.brief.facts import AdjacencyFact, BriefFacts, OccupantFact, Quantity, RoomFact, Span, UseFact
from mansion_planner.brief.finishes import read_materials, read_style
from mansion_planner.brief.furnishings import read_furnishings
from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.households import read_households, told_apart
from mansion_planner.brief.measures import Measure, find_measures, give_measures, read_heights
from mansion_planner.brief.noun_phrases import noun_phrases
from mansion_planner.brief.phrase import FUNCTION_WORDS, PLAIN, Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading, start_reading
from mansion_planner.brief.relations import Relation, read_relations
from mansion_planner.brief.similarity import similar_room_type
from mansion_planner.brief.stacking import read_stacking
from mansion_planner.brief.storey_sequences import other_storeys
from mansion_planner.brief.storeys import read_storeys
from mansion_planner.brief.unit_storeys import attach_units
from mansion_planner.brief.units import are_dwellings, are_units
from mansion_planner.brief.wishes import read_copies, read_massing, read_shape, read_sizes

__all__ = ["read_brief"]


def read_brief(text: str, knowledge: KnowledgeBase) -> BriefFacts:
    """Return what `text` states; never raises, whatever the text.

    Parameters
    ----------
    text : str
        English, any length; words of other scripts are passed over.
    knowledge : KnowledgeBase
        Gives the names of rooms, buildings and styles.

    Examples
    --------
    >>> from mansion_knowledge import default_knowledge
    >>> facts = read_brief("A two-storey house with three bedrooms", default_knowledge())
    >>> [quantity.value for quantity in facts.floors], facts.building[0][0]
    ([2.0], 'house')
    >>> [(room.room_type, room.count) for room in facts.rooms]
    [('bedroom', 3)]
    """
    reading = start_reading(text, knowledge)
    read_materials(reading)
    read_heights(reading)
    read_style(reading, named=True)
    read_shape(reading)
    measures = find_measures(reading)
    places = read_storeys(reading)
    read_massing(reading)
    _Reader(reading, places).read(measures)
    read_copies(reading, places)
    read_style(reading, named=False)
    _leave_unread(reading)
    return reading.facts


class _Reader:
    """Joins the parts of a brief into facts."""

    def __init__(self, reading: Reading, places: list[Place]) -> None:
        self.reading, self.facts, self.places = reading, reading.facts, places

    def read(self, measures: list[Measure]) -> None:
        """Read everything that noun phrases are part of."""
        reading = self.reading
        self.shared: set[int] = set()
        read_adverts(reading)
        self.opening = unknown_building(reading)
        phrases = noun_phrases(reading)
        stacked = read_stacking(reading, phrases)
        phrases = [phrase for number, phrase in enumerate(phrases) if number not in stacked]
        self.building = self._name_building(phrases)
        self.phrases = [self._plain_rooms(phrase) for phrase in give_measures(reading, measures, phrases)]
        self._late_counts()
        self.phrases, self.households = read_households(reading, self.phrases, self.places, self.building)
        self._find_building()
        self._containers()
        self._fittings()
        self._elliptical()
        self.relations = read_relations(reading, self.phrases, set() if self.building is None else {self.building})
        self.negated = negated_phrases(reading, self.phrases)
        self.attached = attach_units(reading, self.places, self.phrases, self.building, self.households)
        for number, phrase in enumerate(self.phrases):
            if phrase.first in self.shared and number in self.attached:
                self.attached[number] = Attachment(self.attached[number].refs)
        self._other_names_of_building()
        self.same, self.groups = coreferences(reading, self.phrases, self._wanted_rooms(), self.relations)
        self._placed_later()
        self._multiply()
        self._people_of_each()
        self.suites = self._suites()
        self._occupants()
        self._vertical()
        self.facts.objects += read_furnishings(reading, self.phrases, self.attached, self.negated, self.same)
        self._rooms()
        self._relations()
        read_completeness(reading)
        self.facts.excluded.sort(key=lambda entry: entry[1].end)
        for index, token in enumerate(reading.tokens):
            if (
                token.kind == "number"
                and reading.word(index - 1) == "for"
                and any(p.last == index - 1 and p.head == "room" for p in self.phrases)
            ):
                reading.take(index, index + 1)  # how many a room is for

    # The building ---------------------------------------------------------------------------------------------------

    def _name_building(self, phrases: list[Phrase]) -> int | None:
        reading = self.reading
        number = building_phrase(reading, phrases, self.places)
        if number is not None and are_units(phrases[number]):
            number = None
        opening = self.opening
        if opening is not None:
            rooms_before = any(p.begin < opening[2] for p in phrases if p.head == "room")
            known = number is not None and reading.sentence[phrases[number].first] <= reading.sentence[opening[2]]
            if known or rooms_before or not (number is None or opening[1]):
                opening = None
        if opening is not None:
            self.facts.building_name, self.facts.building_like, first, last = opening
            self.facts.building_span.append(reading.span(first, last))
            reading.take(first, last)
            phrases[:] = [p for p in phrases if p.last <= first or p.first >= last]
            number = None
        if number is None:
            read_sizes(reading, 0, 0)
            return None
        phrase = phrases[number]
        name = "apartment_building" if phrase.building == "flat" and phrase.plural else phrase.building
        self.facts.building.append((name, self.reading.span(phrase.begin, phrase.noun_end)))
        self.facts.building_name = own_building_name(self.reading, phrase)
        read_bedrooms_of_building(self.reading, phrase)
        read_sizes(self.reading, phrase.first, phrase.noun_end)
        return number

    def _plain_rooms(self, phrase: Phrase) -> Phrase:
        """Read "40 rooms" in a hotel, hospital or dormitory as the rooms that it is for; elsewhere they stay unread."""
        if phrase.head == "building" and not phrase.room_type:
            return replace(phrase, room_type=similar_room_type(phrase.name, self.reading.knowledge), known=False)
        if phrase.name == "hall" and phrase.room_type == "hallway" and sum(phrase.areas[:1]) >= 40.0:
            return replace(phrase, room_type="assembly_hall")
        if phrase.head != "room" or phrase.name not in ("room", "guest_room") or not phrase.counted:
            return phrase
        kind = self.facts.building[0][0] if self.facts.building else ""
        record = self.reading.knowledge.buildings.get(kind)
        room = _PLAIN.get(kind) or _PLAIN.get(record.like if record is not None else "")
        if room is not None:
            return replace(phrase, room_type=room, known=True)
        return replace(phrase, head="unknown") if phrase.name == "room" else phrase

    def _late_counts(self) -> None:
        """Read counts away from their noun: "offices of 14 m2 each, six of them", "four bedrooms, no sorry, five"."""
        reading = self.reading
        for index, token in enumerate(reading.tokens):
            if token.kind != "number" or index in reading.taken or token.value < 1 or token.value != int(token.value):
                continue
            of_them = reading.words(index + 1, index + 3) == ("of", "them")
            corrects = not {"sorry", "mean", "correction"}.isdisjoint(reading.words(index - 3, index))
            if not of_them and not corrects:
                continue
            before = [
                n for n, p in enumerate(self.phrases) if p.last <= index and p.head in ("room", "building", "object")
            ]
            several = bool(before) and (
                self.phrases[before[-1]].plural or self.phrases[before[-1]].determiner in ("every", "each")
            )
            if several and self.phrases[before[-1]].counted == corrects:
                self.phrases[before[-1]] = replace(self.phrases[before[-1]], count=int(token.value), counted=True)
                reading.take(index, index + (3 if of_them else 1))

    def _containers(self) -> None:
        """Leave out what only holds rooms that are counted themselves: "wards with twelve patient rooms"."""
        for number, phrase in enumerate(self.phrases[:-1]):
            following = self.phrases[number + 1]
            if (
                phrase.head == "room"
                and phrase.plural
                and not phrase.counted
                and self.reading.words(phrase.last, following.first) in (("with",), ("of",))
                and following.head == "room"
                and following.counted
                and (following.count or 0) > 2
            ):
                self.phrases[number] = replace(phrase, head="unknown")

    def _fittings(self) -> None:
        """Read "every cell fitted with bunk, toilet and desk" as furniture, though a toilet can be a room as well."""
        reading = self.reading
        for number, phrase in enumerate(self.phrases):
            if phrase.head != "room" or phrase.areas:
                continue
            start = phrase.first
            while start > 0 and reading.sentence[start - 1] == reading.sentence[phrase.first]:
                start -= 1
                if reading.word(start) in ("fitted", "equipped", "furnished") and reading.word(start + 1) == "with":
                    category, _ = furniture_of(reading.words(phrase.begin, phrase.noun_end))
                    if category:
                        self.phrases[number] = replace(phrase, head="object", category=category, room_type="")
                    break

    # Phrases that stand for others ----------------------------------------------------------------------------------

    def _elliptical(self) -> None:
        """Read "five on the second floor, four on the third" and "four per floor" as of the rooms named before."""
        reading = self.reading
        starts = {place.first: place for place in self.places}
        extra: list[tuple[int, Phrase]] = []
        for index, token in enumerate(reading.tokens):
            if token.kind != "number" or index in reading.taken or token.value != int(token.value):
                continue
            place = index + 1
            if reading.words(place, place + 2) in (("of", "them"), ("of", "these"), ("of", "those")):
                place += 2
            place += reading.word(place) in ("more", "other", "others", "further")
            if place not in starts:
                continue
            before = [
                n
                for n, p in enumerate(self.phrases)
                if p.last <= index
                and (p.head == "room" or p.first in self.households.units)
                and reading.sentence[p.first] == reading.sentence[index]
                and p.first not in self.households.inner
            ]
            if not before or reading.word(index - 1) not in (",", ":", "and", "-", "(", "–"):
                continue
            total = self.phrases[before[-1]]
            reading.take(index, place)
            if starts[place].refs[0].kind == "every":
                self.shared.add(total.first)
                continue
            extra.append(
                (
                    before[-1],
                    replace(
                        total,
                        first=index,
                        begin=index,
                        noun_end=index + 1,
                        last=place,
                        count=int(token.value),
                        counted=True,
                        determiner="",
                    ),
                )
            )
        for number in {n for n, _ in extra}:
            total = self.phrases[number]
            parts = [p for n, p in extra if n == number]
            whole = total.counted and sum(p.count or 0 for p in parts) >= (total.count or 0) and len(parts) > 1
            if whole or (not total.counted and total.plural):
                self.phrases[number] = replace(total, head="unknown")
        self.phrases = sorted([*self.phrases, *(p for _, p in extra)], key=lambda p: p.first)
        self._find_building()

    def _find_building(self) -> None:
        """Find the phrase that names the building again, after phrases were added or left out."""
        if self.building is not None:
            span = self.facts.building[0][1]
            self.building = next(
                n for n, p in enumerate(self.phrases) if self.reading.tokens[p.begin].start == span.start
            )

    def _other_names_of_building(self) -> None:
        """Leave out what only names the building again: "penthouse-style flat", "an old barn to turn into a home"."""
        named = self.phrases[self.building] if self.building is not None else None
        sentence = self.reading.sentence[named.first] if named is not None else -1
        buildings = self.reading.knowledge.buildings
        for number, phrase in enumerate(self.phrases):
            if number == self.building or not phrase.building or phrase.plural or phrase.counted or phrase.areas:
                continue
            if phrase.determiner == "the" and not phrase.areas and phrase.name in _HOMES:
                self.phrases[number] = replace(phrase, head="unknown")  # "all over the house"
                continue
            if self.reading.sentence[phrase.first] != sentence or number in self.attached or number in self.negated:
                continue
            if named is None:
                continue
            before = {phrase.determiner, self.reading.word(phrase.first - 1), self.reading.word(phrase.first - 2)}
            if phrase.first > named.first and before & {"with", "and", ",", "plus", "containing", "has", "have", "a"}:
                continue
            same_family = buildings[phrase.building].family == buildings[named.building].family
            if same_family or phrase.first < named.first:
                self.phrases[number] = replace(phrase, head="unknown")

    def _placed_later(self) -> None:
        """Read "wood shop, metal shop. ... Wood shop and metal shop both on level 1" as of the rooms named before."""
        rooms = [n for n in self._wanted_rooms() if n not in self.same]
        for number in rooms:
            phrase = self.phrases[number]
            if number not in self.attached or phrase.counted or phrase.plural or phrase.determiner not in ("", "the"):
                continue
            earlier = next(
                (
                    n
                    for n in rooms
                    if n < number
                    and n not in self.attached
                    and self.phrases[n].name == phrase.name
                    and self.phrases[n].count == 1
                    and self.reading.sentence[self.phrases[n].first] < self.reading.sentence[phrase.first]
                ),
                None,
            )
            if earlier is not None:
                self.attached[earlier] = Attachment(self.attached[number].refs)
                self.same[number] = earlier

    def _people_of_each(self) -> None:
        """Read "Each of us needs a bedroom with a bathroom" as one for each of the people named before."""
        reading = self.reading
        for index in range(len(reading.tokens) - 2):
            if reading.word(index) not in ("each", "every") or index in reading.taken:
                continue
            of_them = reading.words(index + 1, index + 3) in (("of", "us"), ("of", "them"), ("of", "these"))
            noun = reading.word(index + 1)
            people = [
                p for p in self.phrases if p.head == "people" and p.counted and p.first < index and (p.count or 0) > 1
            ]
            if not of_them:
                people = [p for p in people if reading.word(p.noun_end - 1) == noun]
            if not people or not (people[-1].count or 99) <= 40:
                continue
            count, suites = people[-1].count, self._suites()
            for number, phrase in enumerate(self.phrases):
                own = phrase.determiner in ("a", "an", "own", "his", "her", "their", "one", "") or phrase.count == 1
                if (
                    phrase.head == "room"
                    and phrase.first > index
                    and reading.sentence[phrase.first] == reading.sentence[index]
                    and phrase.count == 1
                    and own
                    and phrase.determiner != "the"
                    and number not in suites
                ):
                    self.phrases[number] = replace(phrase, count=count, counted=True)
            reading.take(index, index + (3 if of_them else 2))

    def _multiply(self) -> None:
        """Read "Each group has a playroom" as one for every group, where the brief has a number of groups."""
        reading = self.reading
        counts: dict[str, int] = {}
        for index, token in enumerate(reading.tokens[:-1]):
            if token.kind == "number" and token.value == int(token.value) and 1 < token.value <= 60:
                for noun in (index + 1, index + 2):
                    if reading.plural(noun) and reading.word(noun) not in FLOOR_WORDS:
                        counts.setdefault(reading.word(noun), int(token.value))
        for index, token in enumerate(reading.tokens[:-1]):
            if token.text not in ("each", "every") or not (
                reading.starts(index) or reading.word(index - 1) in (",", "and", ":")
            ):
                continue
            subject = reading.word(index + 1)
            if subject not in counts or any(
                p.begin <= index + 1 < p.noun_end and p.head == "room" for p in self.phrases
            ):
                continue
            for number, phrase in enumerate(self.phrases):
                if (
                    phrase.head == "room"
                    and phrase.first > index
                    and reading.sentence[phrase.first] == reading.sentence[index]
                    and phrase.count == 1
                    and phrase.determiner not in ("the",)
                    and phrase.first not in self.households.read
                ):
                    self.phrases[number] = replace(phrase, count=counts[subject], counted=True)
            reading.take(index, index + 2)

    def _wanted_rooms(self) -> list[int]:
        """Return the phrases that name rooms of the building."""
        return [
            n
            for n, p in enumerate(self.phrases)
            if p.head in ("room", "building") and n != self.building and n not in self.negated
        ]

    def _suites(self) -> dict[int, int]:
        """Return the rooms that others have for themselves ("bedrooms, each with a bathroom"), and of which."""
        suites: dict[int, int] = {}
        self.twins: dict[int, list[int]] = {}
        reading = self.reading
        rooms = [
            n
            for n, p in enumerate(self.phrases)
            if p.head == "room" and n != self.building and n not in self.negated and p.first not in self.households.read
        ]
        for position, number in enumerate(rooms):
            phrase = self.phrases[number]
            if phrase.determiner == "per" or number in self.same:
                continue
            owner = next(
                (
                    n
                    for n in reversed(rooms[:position])
                    if reading.sentence[self.phrases[n].first] == reading.sentence[phrase.first]
                ),
                None,
            )
            if owner is None or any(
                self.phrases[owner].last <= first < phrase.first for first in self.households.inner
            ):
                continue
            gap_words = reading.words(self.phrases[owner].last, phrase.begin)
            gap = set(gap_words)
            if "," in gap and owner not in suites and self._list_goes_on(owner, number, gap_words):
                continue
            tail = reading.words(phrase.last, phrase.last + 1)
            has = bool(gap & {"with", "having", "has", "have", "own", "get", "plus", "its", "contain"})
            distributed = self.phrases[owner].determiner in ("each", "every", "both", "all")
            owner = self.same.get(owner, owner)
            several = (self.phrases[owner].count or 2) > 1 or distributed
            if owner in suites:
                joined = (
                    _outside_brackets(gap_words) <= {"and", "a", "an", "its", "own", ",", "the", "one"} and "and" in gap
                )
                if joined:
                    suites[number] = suites[owner]
                continue
            distributive = has and (
                bool(gap & {"each", "every", "apiece"}) or tail in (("each",), ("apiece",)) or distributed
            )
            both = phrase.determiner in ("both", "all", "each") and phrase.room_type == "ensuite_bathroom"
            mine = "own" in gap or phrase.determiner == "own" or reading.word(phrase.begin) in ("own", "private")
            own = has and (mine or (("its" in gap or phrase.determiner == "its") and phrase.room_type in _PRIVATE))
            plain = (
                has
                and phrase.room_type in _PRIVATE
                and not several
                and "with" in gap
                and self.phrases[owner].room_type in _SLEEPING
            )
            if has and "each" in gap and not several:
                twins = [
                    n
                    for n in rooms[:position]
                    if self.phrases[n].room_type == self.phrases[owner].room_type
                    and reading.sentence[self.phrases[n].first] == reading.sentence[phrase.first]
                ]
                if len(twins) > 1:
                    self.twins[number] = twins
                    suites[number] = owner
                    continue
            if (several and distributive) or both or own or plain or (several and tail == ("each",)):
                suites[number] = owner
        return {n: o for n, o in suites.items() if n not in self.same}

    def _list_goes_on(self, owner: int, number: int, gap: tuple[str, ...]) -> bool:
        """Whether a comma after furniture only leads on to the next room: "a bedroom with bunk beds, one bathroom"."""
        after = gap[len(gap) - gap[::-1].index(",") :]
        between = any(p.head == "object" for p in self.phrases[owner + 1 : number])
        return between and {"with", "each", "own", "its", "has", "have"}.isdisjoint(after)

    # Facts ----------------------------------------------------------------------------------------------------------

    def _occupants(self) -> None:
        reading = self.reading
        for number, phrase in enumerate(self.phrases):
            if phrase.head != "people":
                continue
            noun = reading.word(phrase.noun_end - 1)
            after_room = any(
                p.head == "room" and n != self.building and 0 <= phrase.first - p.last <= 3
                for n, p in enumerate(self.phrases[:number])
            )
            if phrase.counted and phrase.count and not after_room and number not in self.attached:
                self.facts.occupants.append(OccupantFact(phrase.count, noun, reading.span(phrase.first, phrase.last)))
        for index in range(len(reading.tokens)):
            if (
                reading.kind(index) == "number"
                and index not in reading.taken
                and reading.word(index - 1) == "of"
                and reading.word(index - 2) in ("family", "household", "group")
            ):
                self.facts.occupants.append(
                    OccupantFact(int(min(reading.value(index), 1e6)), "family", reading.span(index - 2, index + 1))
                )
                reading.take(index - 2, index + 1)
            elif reading.word(index) == "couple" and reading.word(index + 1) != "of" and not self.facts.occupants:
                self.facts.occupants.append(OccupantFact(2, "family", reading.span(index, index + 1)))
                reading.take(index, index + 1)

    def _vertical(self) -> None:
        for number, phrase in enumerate(self.phrases):
            if phrase.head not in ("stair", "elevator"):
                continue
            span = self.reading.span(phrase.first, phrase.last)
            if number in self.negated:
                first, last = self.negated[number]
                self.facts.vertical.append(
                    (f"no_{phrase.head}", self.reading.span(min(first, phrase.first), max(last, phrase.last)))
                )
                continue
            if self.reading.word(phrase.last) == "only" or self.reading.word(phrase.first - 1) == "only":
                self.facts.vertical.append(("no_elevator" if phrase.head == "stair" else "no_stair", span))
            self.facts.vertical.append((phrase.head, span))
            if phrase.counted and phrase.count is not None and phrase.determiner not in ("the", "both"):
                held = self.facts.stairs if phrase.head == "stair" else self.facts.lifts
                held.append(Quantity(float(phrase.count), span))
        reading = self.reading
        for index in range(len(reading.tokens) - 1):
            if (
                reading.word(index) in ("walk", "stair")
                and reading.word(index + 1) == "up"
                and not reading.tokens[index + 1].spaced
            ):
                self.facts.vertical.append(("no_elevator", reading.span(index, index + 2)))

    def _rooms(self) -> None:
        for number, phrase in enumerate(self.phrases):
            if (
                phrase.head not in ("room", "building")
                or number == self.building
                or (number in self.same and phrase.first not in self.households.units)
                or number in self.suites
                or phrase.first in self.households.read
            ):
                continue
            if phrase.first in self.households.unnumbered:
                self.facts.households += self._room_facts(number, replace(phrase, count=None), Attachment())
                continue
            place = self.attached.get(number, Attachment())
            if number in self.negated:
                self._exclude(number, phrase, place)
                continue
            if not phrase.room_type or (phrase.determiner in ("each", "every", "all") and not phrase.known):
                continue
            if self._is_use(phrase, place):
                name = _AS_USE.get(phrase.building, phrase.building)
                self.facts.uses.append(UseFact(name, place.refs, self.reading.span(phrase.first, phrase.last)))
                continue
            self.facts.rooms += self._room_facts(number, phrase, place)
            self._only_there(phrase, place)
        self.facts.rooms[:] = told_apart(self.facts.rooms)

    def _only_there(self, phrase: Phrase, place: Attachment) -> None:
        """Read "toilets on the odd floors only" as no toilets on the others."""
        found = next((p for p in self.places if p.refs == place.refs and 0 <= p.first - phrase.last <= 4), None)
        if found is None or not self.facts.floors:
            return
        if self.reading.word(found.last) != "only" and self.reading.word(found.first - 1) != "only":
            return
        others = other_storeys(place.refs, int(self.facts.floors[0].value))
        span = self.reading.span(phrase.begin, found.last)
        self.facts.excluded_on += [(phrase.room_type, ref, span) for ref in others]

    def _exclude(self, number: int, phrase: Phrase, place: Attachment) -> None:
        first, last = self.negated[number]
        span = self.reading.span(min(first, phrase.first), max(last, phrase.last))
        if not phrase.room_type:
            return
        if place.refs and self._is_placed(phrase):
            self.facts.excluded_on += [(phrase.room_type, ref, span) for ref in place.refs]
        else:
            self.facts.excluded.append((phrase.room_type, span))

    def _is_placed(self, phrase: Phrase) -> bool:
        """Whether a negated room is unwanted on some storeys only: named after it, or it is wanted elsewhere."""
        after = any(0 <= place.first - phrase.last <= 2 for place in self.places)
        other = any(
            p.room_type == phrase.room_type and n not in self.negated and p is not phrase
            for n, p in enumerate(self.phrases)
        )
        return after or other or "there" in self.reading.words(phrase.last, phrase.last + 2)

    def _is_use(self, phrase: Phrase, place: Attachment) -> bool:
        """Whether a plural is the use of whole storeys: "offices on floors 2 to 5"."""
        return (
            bool(phrase.building) and bool(place.refs) and phrase.plural and phrase.count is None and not phrase.areas
        )

    def _room_facts(self, number: int, phrase: Phrase, place: Attachment) -> list[RoomFact]:
        """Return a phrase's rooms: one fact, or one for each of several areas."""
        span = self._span(phrase)
        children = [
            self.phrases[n] for n, owner in self.suites.items() if owner == number or number in self.twins.get(n, ())
        ]
        held = self.households.units.get(phrase.first, [])
        suite = tuple(
            RoomFact(
                child.room_type,
                child.name or child.room_type,
                self._span(child),
                child.count or 1,
                child.areas[0] if child.areas else None,
                label=child.label,
                known=child.known,
            )
            for child in (*held, *children)
            if child.room_type
        )
        fact = RoomFact(
            room_type=phrase.room_type,
            name=_identifier(phrase.name) or phrase.room_type,
            span=span,
            count=phrase.count,
            area=phrase.areas[0] if phrase.areas else None,
            floors=place.refs,
            each=place.each or (phrase.determiner in ("each", "every") and False),
            label=phrase.label,
            suite=suite,
            known=phrase.known,
            unit=bool(held) or (self.reading.knowledge.room(phrase.room_type).unit and are_dwellings(phrase)),
        )
        if self._said_before(fact, phrase):
            return []
        if len(phrase.areas) > 1:
            return [replace(fact, count=1, area=area) for area in phrase.areas]
        return [fact]

    def _span(self, phrase: Phrase) -> Span:
        """Return the words of a phrase, its article left out."""
        return self.reading.span(phrase.first if phrase.counted else min(phrase.begin, phrase.last - 1), phrase.last)

    def _said_before(self, fact: RoomFact, phrase: Phrase) -> bool:
        """Whether an unnumbered room only says again what the brief wants already ("a library ... library")."""
        if phrase.counted or fact.count not in (None, 1) or phrase.determiner in ("a", "an", "another"):
            return False
        for number, other in enumerate(self.facts.rooms):
            if (other.name, other.count, other.each) == (fact.name, fact.count, fact.each) and [
                (r.kind, r.first, r.last) for r in other.floors
            ] == [(r.kind, r.first, r.last) for r in fact.floors]:
                if fact.area and not other.area:
                    self.facts.rooms[number] = replace(other, area=fact.area)
                return True
        return False

    def _relations(self) -> None:
        for relation in self.relations:
            held = self.facts.apart if relation.apart else self.facts.adjacent
            for pair in self._pairs(relation):
                first, second = (self.phrases[self.same.get(n, n)] for n in pair)
                if not first.room_type or not second.room_type:
                    continue
                span = self.reading.span(min(first.begin, relation.first), relation.last)
                if relation.last <= second.begin and second.noun_end - first.begin < 14:
                    span = self.reading.span(min(first.begin, relation.first), second.noun_end)
                elif relation.first - first.begin > 10:
                    span = self.reading.span(relation.first, relation.last)
                held.append(
                    AdjacencyFact(
                        first.room_type, second.room_type, span, _identifier(first.name), _identifier(second.name)
                    )
                )

    def _pairs(self, relation: Relation) -> list[tuple[int, int]]:
        whole = relation.lefts[0]
        if relation.lefts == relation.rights == (whole,) and whole in self.groups:
            group = self.groups[whole]
            return [(a, b) for n, a in enumerate(group) for b in group[n + 1 :]]
        if len(relation.lefts) == len(relation.rights) and len(relation.lefts) > 1:
            return list(zip(relation.lefts, relation.rights))
        return [(left, right) for left in relation.lefts for right in relation.rights]


_HOMES = frozenset({"house", "home", "building", "villa", "cottage", "cabin", "bungalow"})
"""Nouns that with "the" mean the whole building."""

_PLAIN = {
    "hotel": "hotel_room",
    "hospital": "patient_room",
    "hostel": "hostel_dorm",
    "student_dormitory": "dorm_room",
    "nursing_home": "resident_room",
}
_AS_USE = {
    "flat": "apartment_building",
    "studio_flat": "apartment_building",
    "shop_building": "shopping_mall",
    "house": "apartment_building",
    "penthouse": "apartment_building",
}
_SLEEPING = frozenset(
    """
    bedroom master_bedroom guest_room childrens_room hotel_room hotel_suite resident_room patient_room dorm_room
    apartment studio_apartment
    """.split()
)
_PRIVATE = frozenset(
    {"bathroom", "ensuite_bathroom", "toilet", "walk_in_closet", "dressing_room", "shower_area", "restroom", "pantry"}
)


def _outside_brackets(words: tuple[str, ...]) -> set[str]:
    """Return the words that do not stand in brackets."""
    found, depth = set(), 0
    for word in words:
        depth += (word == "(") - (word == ")")
        if depth == 0 and word != ")":
            found.add(word)
    return found


def _identifier(name: str) -> str:
    """Return a snake-case identifier that starts with a letter."""
    return name if name[:1].isalpha() else f"room_{name}" if name else ""


def _leave_unread(reading: Reading) -> None:
    """Record the runs of content words that nothing was read from."""
    first = -1
    for index in range(len(reading.tokens) + 1):
        open_word = index < len(reading.tokens) and index not in reading.taken and _is_content(reading, index)
        if open_word and first < 0:
            first = index
        elif not open_word and first >= 0:
            reading.facts.unread.append(reading.span(first, min(index, first + 12)))
            first = -1


_REQUESTS = frozenset(
    "design generate imagine think thank suppose assume kindly hereby attach attached regards".split()
)
"""Words that ask for a building and say nothing of it."""


def _is_content(reading: Reading, index: int) -> bool:
    token = reading.tokens[index]
    if token.kind == "number":
        return True
    return (
        token.kind == "word"
        and token.text not in FUNCTION_WORDS
        and token.text not in PLAIN
        and token.text not in FLOOR_WORDS
        and token.text not in _REQUESTS
        and len(token.text) > 1
    )
