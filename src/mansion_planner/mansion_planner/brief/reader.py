"""Read a brief: storeys, areas, building type, rooms, furniture and wishes, each from the words that state it.

The text is parsed from the smallest parts up: tokens, then areas and storey references, then noun phrases, then what
joins them (storeys, relations, negations, "each with"), and at last the facts. Every token belongs to one part at most;
content words that belong to none are reported as not understood. No step looks further than its sentence, so the time
is proportional to the length of the text.
"""

import itertools
from collections.abc import Callable
from dataclasses import replace

from mansion_knowledge import KnowledgeBase
from mansion_planner.brief.absences import read_absent_parts
from mansion_planner.brief.accessible_parts import with_accessible_ones
from mansion_planner.brief.adverts import among_adverts, read_adverts, read_bedrooms_of_building
from mansion_planner.brief.background_phrases import without_bystanders
from mansion_planner.brief.bare_areas import with_bare_areas
from mansion_planner.brief.blocks import with_blocks
from mansion_planner.brief.building import building_phrase, own_building_name, unknown_building
from mansion_planner.brief.building_shape import read_copies, read_massing, read_shape, read_sizes
from mansion_planner.brief.coreference import coreferences
from mansion_planner.brief.desk_areas import read_desk_areas
from mansion_planner.brief.distant_counts import (
    read_counts_by_group,
    read_counts_by_person,
    read_counts_by_storey,
    read_halves,
    read_late_counts,
    without_totals,
)
from mansion_planner.brief.exclusions import negated_phrases, read_completeness
from mansion_planner.brief.facts import AdjacencyFact, BriefFacts, OccupantFact, Quantity, Span
from mansion_planner.brief.finishes import read_materials, read_style
from mansion_planner.brief.furnishings import people_served, read_furnishings, seats_at_tables
from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.heights import read_heights
from mansion_planner.brief.households import read_households
from mansion_planner.brief.measures import Measure, find_measures, give_measures
from mansion_planner.brief.named_rooms import desks_as_places, rooms_by_name
from mansion_planner.brief.noun_phrases import noun_phrases
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.qualifiers import unheeded_words
from mansion_planner.brief.reading import Place, Reading, start_reading
from mansion_planner.brief.relations import Relation, read_relations
from mansion_planner.brief.retractions import without_retractions
from mansion_planner.brief.room_facts import RoomStatements, identifier
from mansion_planner.brief.room_names import told_by_its_words
from mansion_planner.brief.rooms_by_building import room_for_building
from mansion_planner.brief.shared_places import read_shares
from mansion_planner.brief.shared_rooms import as_studio_flat, rooms_of_several_uses
from mansion_planner.brief.shared_sizes import with_shared_sizes
from mansion_planner.brief.sizes import sized
from mansion_planner.brief.some_en_suite import with_some_en_suite
from mansion_planner.brief.stacked_uses import read_stacking
from mansion_planner.brief.storey_attachment import Attachment
from mansion_planner.brief.storey_uses import read_storey_uses
from mansion_planner.brief.storeys import read_storeys
from mansion_planner.brief.suites import read_suites
from mansion_planner.brief.told_by_size import told_by_size
from mansion_planner.brief.trades import read_trade
from mansion_planner.brief.unit_storeys import attach_units
from mansion_planner.brief.units import are_units, is_type_of_flat
from mansion_planner.brief.unread_words import leave_unread
from mansion_planner.brief.washing_and_resting import by_what_else_is_named

__all__ = ["read_brief"]


def read_brief(text: str, knowledge: KnowledgeBase, *, cancelled: Callable[[], bool] = lambda: False) -> BriefFacts:
    """Return what `text` states, whatever the text is.

    Parameters
    ----------
    text : str
        English, any length; words of other scripts are passed over.
    knowledge : KnowledgeBase
        Gives the names of rooms, buildings and styles.
    cancelled : callable
        Asked between the steps whether the reading is not wanted any more.

    Raises
    ------
    MansionError
        ``CANCELED``, of nothing else.

    Examples
    --------
    >>> from mansion_knowledge import default_knowledge
    >>> facts = read_brief("A two-storey house with three bedrooms", default_knowledge())
    >>> [quantity.value for quantity in facts.floors], facts.building[0][0]
    ([2.0], 'house')
    >>> [(room.room_type, room.count) for room in facts.rooms]
    [('bedroom', 3)]
    """
    reading = start_reading(text, knowledge, cancelled)
    reading.go_on()
    read_materials(reading)
    read_heights(reading)
    read_style(reading, named=True)
    read_shape(reading)
    measures = find_measures(reading)
    places = read_storeys(reading)
    read_massing(reading)
    reading.go_on()
    phrases = _Reader(reading, places).read(measures)
    reading.go_on()
    read_copies(reading, places)
    read_style(reading, named=False)
    reading.facts.unheeded += unheeded_words(reading, phrases, reading.facts)
    leave_unread(reading)
    return reading.facts


class _Reader:
    """Joins the parts of a brief into facts."""

    def __init__(self, reading: Reading, places: list[Place]) -> None:
        self.reading, self.facts, self.places = reading, reading.facts, places

    def read(self, measures: list[Measure]) -> list[Phrase]:
        """Read everything that noun phrases are part of; return them."""
        reading = self.reading
        read_adverts(reading, self.places)
        read_trade(reading)
        self.opening = unknown_building(reading, self.places)
        named = without_retractions(reading, noun_phrases(reading))
        phrases = rooms_of_several_uses(reading, without_bystanders(reading, named))
        phrases = with_some_en_suite(reading, with_blocks(reading, phrases))
        phrases = with_accessible_ones(reading, desks_as_places(reading, rooms_by_name(reading, phrases)))
        read_shares(reading, phrases)
        reading.go_on()
        stacked = read_stacking(reading, phrases)
        phrases = [phrase for number, phrase in enumerate(phrases) if number not in stacked]
        self.building = self._name_building(phrases)
        as_studio_flat(reading, phrases)
        phrases = with_shared_sizes(reading, measures, phrases)
        own = [room_for_building(reading, phrase) for phrase in give_measures(reading, measures, phrases)]
        self.phrases = by_what_else_is_named([told_by_its_words(reading, phrase) for phrase in own])
        one_of_several = told_by_size(reading, with_bare_areas(reading, self.phrases))
        self.phrases = sized(reading, one_of_several.phrases, self.building)
        reading.go_on()
        read_late_counts(reading, self.phrases)
        self.phrases, self.households = read_households(reading, self.phrases, self.places, self.building)
        self._find_building()
        self._containers()
        self._fittings()
        shared = read_counts_by_storey(reading, self.phrases, self.places, self.households)
        self._find_building()
        reading.go_on()
        self.relations = read_relations(reading, self.phrases, set() if self.building is None else {self.building})
        self.negated = negated_phrases(reading, self.phrases)
        self.attached = attach_units(reading, self.places, self.phrases, self.building, self.households)
        for number, phrase in enumerate(self.phrases):
            if phrase.first in shared and number in self.attached:
                self.attached[number] = Attachment(self.attached[number].refs)
        read_storey_uses(reading, self.places, self.phrases, self.attached, self.building)
        read_halves(reading, self.phrases, self.places, self.attached)
        self._place_with(one_of_several.others)
        self._other_names_of_building()
        reading.go_on()
        self.same, self.groups = coreferences(reading, self.phrases, self._wanted_rooms(), self.relations)
        self._tell_rooms_within()
        self._said_with_area()
        self._placed_later()
        self._placed_again()
        without_totals(reading, self.phrases, self.attached, [n for n in self._wanted_rooms() if n not in self.same])
        read_counts_by_group(reading, self.phrases, self.households)
        rooms = [
            n
            for n in self._wanted_rooms()
            if self.phrases[n].head == "room" and self.phrases[n].first not in self.households.read
        ]
        read_counts_by_person(reading, self.phrases, rooms, self.same, self.households.inner)
        reading.go_on()
        suites = read_suites(reading, self.phrases, rooms, self.same, self.households.inner)
        reading.go_on()
        self._occupants()
        self._vertical()
        self.facts.objects += read_furnishings(
            reading, self.phrases, self.attached, self.negated, self.same, self.relations
        )
        self._tell_users()
        self._further_ones()
        adverts = tuple(self.facts.rooms)
        RoomStatements(
            reading,
            self.places,
            self.phrases,
            self.building,
            self.households,
            self.attached,
            self.negated,
            self.same,
            suites,
        ).record()
        among_adverts(self.facts, adverts)
        read_desk_areas(self.facts)
        self._relations()
        read_completeness(reading, self.places, self.phrases)
        read_absent_parts(reading)
        self.facts.excluded.sort(key=lambda entry: entry[1].end)
        for index, token in enumerate(reading.tokens):
            if (
                token.kind == "number"
                and reading.word(index - 1) == "for"
                and any(p.last == index - 1 and p.head == "room" and p.areas for p in self.phrases)
            ):
                reading.take(index, index + 1)  # how many a room is for
        return self.phrases

    # The building ---------------------------------------------------------------------------------------------------

    def _name_building(self, phrases: list[Phrase]) -> int | None:
        reading = self.reading
        number = building_phrase(reading, phrases, self.places)
        if number is not None and are_units(phrases[number]):
            number = None
        if number is not None and is_type_of_flat(reading, phrases, number):
            self.facts.building.append(("apartment_building", Span("", 0, 0)))
            number = None
        opening = self.opening
        if opening is not None:
            rooms_before = any(p.begin < opening[2] for p in phrases if p.head == "room")
            known = number is not None and reading.sentence[phrases[number].first] <= reading.sentence[opening[2]]
            if known or rooms_before or not (number is None or opening[1]):
                opening = None
        if opening is not None and opening[0] in _BARE:
            reading.take(opening[2], opening[3])
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
        if phrase.building == "flat" and phrase.counted and (phrase.count or 0) > 1:
            self.facts.building[-1] = (name, self.reading.span(phrase.begin, phrase.noun_end))
            return None  # "two flats side by side" are a building and its rooms
        return number

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
        fitted = {
            reading.sentence[index]: index
            for index in reversed(range(len(reading.tokens)))
            if reading.word(index) in ("fitted", "equipped", "furnished") and reading.word(index + 1) == "with"
        }
        for number, phrase in enumerate(self.phrases):
            workplaces = phrase.name == "workplace" and phrase.counted
            if (phrase.head != "room" and not workplaces) or phrase.areas:
                continue
            category, _ = furniture_of(reading.words(phrase.begin, phrase.noun_end))
            before = self.phrases[number - 1] if number else None
            fit = fitted.get(reading.sentence[phrase.first], phrase.first)
            listed = fit < phrase.first and (",", "plus") not in itertools.pairwise(reading.words(fit, phrase.first))
            locker = phrase.name == "locker" and before is not None and self._is_locker(before, phrase)
            counter = before is not None and self._is_counter_of(before, phrase)
            if counter or (
                category and (listed or locker or (before is not None and self._is_fixture(before, phrase)))
            ):
                category = "bar_counter" if counter else category
                self.phrases[number] = replace(phrase, head="object", category=category, room_type="")

    def _is_fixture(self, room: Phrase, phrase: Phrase) -> bool:
        """Whether "a bathroom with a shower" and "a staff room with lockers" speak of what stands in the room."""
        between = self.reading.words(room.last, phrase.begin)
        if room.head != "room" or between not in (("with",), ("with", "a"), ("with", "the")):
            return False
        return phrase.name.rpartition("_")[2] in ("locker", "workplace") or (
            room.room_type in _BATHROOMS and phrase.name in _FIXTURES
        )

    def _is_counter_of(self, room: Phrase, phrase: Phrase) -> bool:
        """Whether "a taproom with its long bar" speaks of the counter of a room where drinks are served."""
        between = self.reading.words(room.last, phrase.begin)
        counter = phrase.name == "bar" and room.head == "room" and room.room_type in _ROOMS_WITH_BARS
        return counter and between in (("with", "its"), ("and", "its"), ("with", "a"), ("with",))

    def _is_locker(self, before: Phrase, phrase: Phrase) -> bool:
        """Whether "eight lockers" and "a bed and a locker" are furniture: those counted, or named with furniture."""
        between = set(self.reading.words(before.last, phrase.begin))
        return (phrase.counted and phrase.plural) or (
            before.head == "object" and between <= {"and", "+", "a", ",", "one"}
        )

    # Phrases that stand for others ----------------------------------------------------------------------------------

    def _place_with(self, others: dict[int, int]) -> None:
        """Put a room that is told by its size, whose storey is not said, where the others of its kind are."""
        numbers = {phrase.first: number for number, phrase in enumerate(self.phrases)}
        for first, other in others.items():
            held = self.attached.get(numbers[other]) if other in numbers else None
            if first in numbers and numbers[first] not in self.attached and held is not None:
                self.attached[numbers[first]] = Attachment(held.refs)

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
            again = named is not None and phrase.count == 1 and self._holds_all(phrase, named)
            turned = {"turned", "converted", "cum"} & set(self.reading.words(phrase.begin, phrase.noun_end))
            again = again or (named is not None and bool(turned))  # "a riad in Marrakech turned guest house"
            if again and number != self.building:
                self.phrases[number] = replace(phrase, head="unknown")  # "two levels inside one flat"
                continue
            if number == self.building or not phrase.building or phrase.plural or phrase.counted or phrase.areas:
                continue
            if named is not None and phrase.head == "building" and self._is_alone(phrase):
                self.phrases[number] = replace(phrase, head="unknown")  # "Modern farmhouse." is how it looks
                continue
            if self._is_of_trade(phrase):
                self.phrases[number] = replace(phrase, head="unknown")  # "over the shop we live ourselves"
                continue
            if phrase.determiner == "the" and not phrase.areas and phrase.name in _HOMES:
                self.phrases[number] = replace(phrase, head="unknown")  # "all over the house"
                continue
            if self.reading.sentence[phrase.first] != sentence or number in self.attached or number in self.negated:
                continue
            if named is None:
                continue
            if self._stands_in_apposition(phrase, named):
                self.phrases[number] = replace(phrase, head="unknown")  # "a guest house, victorian house, ..."
                continue
            if self.reading.word(named.last) == "for" and 0 < phrase.first - named.last <= 2:
                self.phrases[number] = replace(phrase, head="unknown")  # "a hostel for an engineering college"
                continue
            before = {phrase.determiner, self.reading.word(phrase.first - 1), self.reading.word(phrase.first - 2)}
            if phrase.first > named.first and before & {
                "with",
                "and",
                ",",
                ":",
                "plus",
                "containing",
                "has",
                "have",
                "a",
            }:
                continue
            same_family = buildings[phrase.building].family == buildings[named.building].family
            if same_family or phrase.first < named.first:
                self.phrases[number] = replace(phrase, head="unknown")

    def _is_of_trade(self, phrase: Phrase) -> bool:
        """Whether "the shop" of who sells something is the building, or what is below, rather than another room."""
        trades = {kind for kind, _ in self.facts.trades}
        return phrase.determiner == "the" and phrase.name == "shop" and phrase.building in trades

    def _stands_in_apposition(self, phrase: Phrase, named: Phrase) -> bool:
        """Whether a home named right after the building, with no article and between commas, is the building again."""
        reading = self.reading
        bare = phrase.head == "building" and not phrase.determiner and reading.starts(named.first)
        after = reading.word(named.last) == "," and phrase.first == named.last + 1
        last = reading.word(phrase.noun_end - 1)
        return bare and after and last in ("house", "home", "building") and reading.word(phrase.last) in (",", ":", ".")

    def _holds_all(self, phrase: Phrase, named: Phrase) -> bool:
        """Whether "inside one flat" speaks of the building, as "in an old factory" does of where it is."""
        reading, before = self.reading, self.reading.word(phrase.first - 1)
        buildings = reading.knowledge.buildings
        if not phrase.building or phrase.first < named.first:
            return False
        old = {"old", "former", "rented", "existing", "disused"} & set(reading.words(phrase.first, phrase.noun_end))
        first = phrase.first - (reading.word(phrase.first - 1) in ("a", "an"))
        if old and reading.word(first - 1) in ("in", "inside", "within", "into"):
            return reading.sentence[phrase.first] == reading.sentence[named.first]
        alike = buildings[phrase.building].family == buildings[named.building].family
        return before in ("inside", "within") and alike

    def _said_with_area(self) -> None:
        """Give a room the area that another mention of it has: "beside the live room (70 m2) ... The live room"."""
        self._said_of_all()
        for number, named in self.same.items():
            phrase, room = self.phrases[number], self.phrases[named]
            if phrase.areas and not room.areas and phrase.name == room.name:
                self.phrases[named] = replace(room, areas=phrase.areas)
                if phrase.determiner in ("a", "an", "each", "every"):
                    self._give_to_all(number, phrase)

    def _give_to_all(self, number: int, phrase: Phrase) -> None:
        """Give the area of "a bedroom is 22 m2" to all bedrooms that are named before."""
        for other in self._wanted_rooms():
            room = self.phrases[other]
            if other < number and room.name == phrase.name and not room.areas:
                self.phrases[other] = replace(room, areas=phrase.areas, limit=phrase.limit)

    def _said_of_all(self) -> None:
        """Read "four classrooms ... six classrooms. Classrooms around 50 m2" as of all that are named before."""
        before: dict[str, list[int]] = {}
        for number in self._wanted_rooms():
            phrase = self.phrases[number]
            named = before.setdefault(phrase.name, [])
            if phrase.plural and not phrase.counted and phrase.areas and named and number not in self.same:
                for other in named:
                    room = self.phrases[other]
                    self.phrases[other] = room if room.areas else replace(room, areas=phrase.areas, limit=phrase.limit)
                self.same[number] = named[-1]
            elif number not in self.same:
                named.append(number)

    def _tell_rooms_within(self) -> None:
        """Give back the room that another is to be in: "an attic ... a drying room in the attic"."""
        for number in self.same:
            inner, outer = self.phrases[number - 1], self.phrases[number]
            inside = number and inner.head == outer.head == "room" and inner.last == outer.begin - 2
            if inside and self.reading.words(inner.last, outer.begin) == ("in", "the"):
                self.reading.taken.difference_update(range(outer.begin, outer.noun_end))

    def _is_alone(self, phrase: Phrase) -> bool:
        """Whether a phrase of a style and a noun is a sentence of its own."""
        sentence = self.reading.sentence[phrase.first]
        others = [i for i, s in enumerate(self.reading.sentence) if s == sentence]
        styled = any(m.style and m.first == others[0] and m.last == phrase.noun_end - 1 for m in self.reading.mentions)
        return styled and others[-1] <= phrase.noun_end

    def _placed_later(self) -> None:
        """Read "wood shop, metal shop. ... Wood shop and metal shop both on level 1" as of the rooms named before."""
        reading = self.reading
        rooms = [n for n in self._wanted_rooms() if n not in self.same]
        for number in rooms:
            phrase = self.phrases[number]
            if number not in self.attached or phrase.counted or phrase.plural or phrase.determiner not in ("", "the"):
                continue
            if not _FURTHER.isdisjoint(reading.words(phrase.first - 1, phrase.begin + 1)):
                continue
            earlier = next(
                (
                    n
                    for n in rooms
                    if n < number
                    and n not in self.attached
                    and self.phrases[n].name == phrase.name
                    and self.phrases[n].count == 1
                    and reading.sentence[self.phrases[n].first] < reading.sentence[phrase.first]
                ),
                None,
            )
            if earlier is not None:
                self.attached[earlier] = Attachment(self.attached[number].refs)
                self.same[number] = earlier

    def _placed_again(self) -> None:
        """Read "a brewery with a taproom ... the floor above is the taproom with a bar" as where the taproom is."""
        operands = {n for relation in self.relations for n in (*relation.lefts, *relation.rights)}
        mentioned = {n for relation in self.relations for n in relation.rights if self.phrases[n].determiner == "the"}
        for number, named in self.same.items():
            phrase, room = self.phrases[number], self.phrases[named]
            open_yet = named not in self.attached or named in mentioned  # "away from the toilets" puts them nowhere
            placed = number in self.attached and open_yet and number not in operands
            again = phrase.name == room.name and room.count in (1, None) and not phrase.counted and named < number
            if placed and again:
                place = self.attached[number]
                self.attached[named] = place if room.plural else Attachment(place.refs)

    def _wanted_rooms(self) -> list[int]:
        """Return the phrases that name rooms of the building."""
        return [
            n
            for n, p in enumerate(self.phrases)
            if p.head in ("room", "building") and n != self.building and n not in self.negated
        ]

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
            furnished = number and (
                people_served(reading, self.phrases, number - 1) or seats_at_tables(reading, self.phrases, number - 1)
            )
            if phrase.counted and phrase.count and not (after_room or furnished or number in self.attached):
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

    def _tell_users(self) -> None:
        """Give back how many a room is for where nothing stands there for each of them: "a cell for four detainees"."""
        read = [fact.span for fact in self.facts.objects] + [fact.span for fact in self.facts.occupants]
        for number, phrase in enumerate(self.phrases[1:], 1):
            room = self.phrases[number - 1]
            span = self.reading.span(phrase.first, phrase.last)
            users = phrase.head == "people" and phrase.counted and (phrase.count or 0) > _PAIR
            if not users or room.head != "room" or self.reading.words(room.last, phrase.first) != ("for",):
                continue
            if not any(other.start <= span.start < other.end for other in read):
                self.reading.taken.difference_update(range(phrase.first, phrase.last))

    def _further_ones(self) -> None:
        """Take the ordinal of one more room of a kind: "an en-suite bathroom ... a second bathroom"."""
        for number, phrase in enumerate(self.phrases):
            ordinal = phrase.begin - 1
            if phrase.head != "room" or self.reading.kind(ordinal) != "ordinal" or ordinal in self.reading.taken:
                continue
            before = [p for p in self.phrases[:number] if p.head == "room" and p.room_type == phrase.room_type]
            if self.reading.word(ordinal - 1) in ("a", "the", "and") and before and number not in self.same:
                self.reading.take(ordinal, ordinal + 1)

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
            enough = self.reading.word(phrase.last + (self.reading.word(phrase.last) in _COPULAS)) in _ENOUGH
            if enough:
                self.reading.take(phrase.last, phrase.last + 1 + (self.reading.word(phrase.last) in _COPULAS))
            only = "only" in (self.reading.word(phrase.last), self.reading.word(phrase.first - 1))
            if enough or (only and not phrase.counted):  # "only one lift" is a number
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

    def _relations(self) -> None:
        for relation in self.relations:
            held = self.facts.apart if relation.apart else self.facts.adjacent
            many = len(held)
            for pair in self._pairs(relation):
                first, second = (self.phrases[self.same.get(n, n)] for n in pair)
                if not first.room_type or not second.room_type or "unknown" in (first.head, second.head):
                    continue
                span = self._span_of_relation(relation, *(self.phrases[n] for n in pair))
                held.append(
                    AdjacencyFact(
                        first.room_type,
                        second.room_type,
                        span,
                        identifier(first.name),
                        identifier(second.name),
                        each=pair[0] != pair[1] and (first.count or 2) > 1 and not relation.apart,
                    )
                )
            if len(held) == many:
                self._tell(relation)

    def _span_of_relation(self, relation: Relation, first: Phrase, second: Phrase) -> Span:
        """Return the words of a relation, with those of the rooms that stand close by."""
        begin = min(first.begin, second.begin, relation.first)
        begin = begin if relation.first - begin <= _CLOSE else relation.first
        last = max(first.noun_end, second.noun_end, relation.last)
        return self.reading.span(begin, last if last - begin <= _WORDS else relation.last)

    def _tell(self, relation: Relation) -> None:
        """Give back the words of a relation that no statement was made of."""
        self.reading.taken.difference_update(range(relation.first, relation.last))

    def _pairs(self, relation: Relation) -> list[tuple[int, int]]:
        whole = relation.lefts[0]
        if relation.lefts == relation.rights == (whole,) and whole in self.groups:
            group = self.groups[whole]
            return [(a, b) for n, a in enumerate(group) for b in group[n + 1 :]]
        lefts, rights = (
            [m for n in side for m in self.groups.get(n, [n])] for side in (relation.lefts, relation.rights)
        )
        if relation.apart:
            return [(left, right) for left in lefts for right in rights if left != right]
        if len(relation.lefts) == len(relation.rights) and len(relation.lefts) > 1:
            return list(zip(relation.lefts, relation.rights))
        return [(left, right) for left in relation.lefts for right in relation.rights]


_FURTHER = frozenset("second third another further additional extra".split())
"""Words for one more of a room that is named before."""

_COPULAS = frozenset({"is", "are", "be", "will"})
_ENOUGH = frozenset({"suffice", "sufficient", "enough", "do"})
"""What is said of stairs where no lift is wanted: "stairs suffice", "stairs will do"."""

_HOMES = frozenset({"house", "home", "building", "villa", "cottage", "cabin", "bungalow"})
"""Nouns that with "the" mean the whole building."""

_ROOMS_WITH_BARS = frozenset({"bar", "lounge", "common_room", "nightclub_floor"})
"""Rooms whose bar is the counter in them: a club room with a bar."""

_FIXTURES = frozenset({"shower", "bath", "walk_in_shower", "loo"})
_BATHROOMS = frozenset({"bathroom", "ensuite_bathroom", "accessible_toilet"})

_PAIR = 2
"""Users that any room has place for."""

_CLOSE = 8
_WORDS = 12
"""Tokens between a relation and a room that its statement names, and of a statement, at most."""

_BARE = frozenset({"building", "complex"})
"""Names of a building that say nothing of its use: its rooms do."""
