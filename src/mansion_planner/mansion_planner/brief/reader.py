"""Read a brief: storeys, areas, building type, rooms, furniture and wishes, each from the words that state it.

The text is parsed from the smallest parts up: tokens, then areas and storey references, then noun phrases, then what
joins them (storeys, relations, negations, "each with"), and at last the facts. Every token belongs to one part at most;
content words that belong to none are reported as not understood. No step looks further than its sentence, so the time
is proportional to the length of the text.
"""

from collections.abc import Callable

from mansion_knowledge import KnowledgeBase
from mansion_planner.brief.absences import read_absent_parts
from mansion_planner.brief.accessible_parts import with_accessible_ones
from mansion_planner.brief.adverts import among_adverts, read_adverts, read_bedrooms_of_building
from mansion_planner.brief.all_but_some import place_all_others, place_some, read_all_but_some
from mansion_planner.brief.area_words import Measure
from mansion_planner.brief.background_phrases import without_bystanders
from mansion_planner.brief.bare_areas import with_bare_areas
from mansion_planner.brief.building import (
    building_phrase,
    is_asked_for,
    is_the_writer,
    own_building_name,
    unknown_building,
)
from mansion_planner.brief.building_again import leave_out_other_names
from mansion_planner.brief.building_shape import give_rooms_to_copies, read_copies, read_massing, read_shape, read_sizes
from mansion_planner.brief.changed_copies import find_changed_copies, read_changed_copies
from mansion_planner.brief.clutter import read_clutter_words, read_things_about
from mansion_planner.brief.coreference import coreferences
from mansion_planner.brief.distant_counts import (
    read_counts_by_group,
    read_counts_by_person,
    read_counts_by_room,
    read_counts_by_storey,
    read_halves,
    read_late_counts,
    without_totals,
)
from mansion_planner.brief.en_suite import with_bathrooms_by_name, with_some_en_suite
from mansion_planner.brief.exclusions import negated_phrases, read_completeness
from mansion_planner.brief.facts import BriefFacts, Span
from mansion_planner.brief.finishes import read_floorings, read_heights, read_materials, read_style
from mansion_planner.brief.fittings import leave_out_containers, read_fittings
from mansion_planner.brief.furnishings import read_furnishings
from mansion_planner.brief.groups import with_room_of_group
from mansion_planner.brief.households import read_households
from mansion_planner.brief.implied_storeys import put_on_ground
from mansion_planner.brief.later_mentions import (
    elsewhere_by_another_word,
    give_areas_of_mentions,
    place_by_mentions,
    tell_rooms_within,
)
from mansion_planner.brief.measures import find_measures, give_measures
from mansion_planner.brief.niches import read_niches
from mansion_planner.brief.noun_phrases import noun_phrases
from mansion_planner.brief.occupants import read_occupants, tell_users
from mansion_planner.brief.one_sized import with_one_sized
from mansion_planner.brief.outside import read_outside
from mansion_planner.brief.phrase import BARE_BUILDINGS, Phrase
from mansion_planner.brief.qualifiers import unheeded_words
from mansion_planner.brief.reading import Place, Reading, start_reading
from mansion_planner.brief.relations import read_relations, state_relations
from mansion_planner.brief.retractions import without_retractions, without_taken_back
from mansion_planner.brief.room_facts import RoomStatements
from mansion_planner.brief.room_groups import (
    desks_as_places,
    read_desk_areas,
    rooms_by_name,
    with_blocks,
    without_announced,
)
from mansion_planner.brief.room_names import told_by_its_words
from mansion_planner.brief.rooms_by_building import room_for_building
from mansion_planner.brief.sanitary_rooms import by_what_else_is_named, read_washing_fittings
from mansion_planner.brief.shared_places import read_shares
from mansion_planner.brief.shared_rooms import as_studio_flat, rooms_of_several_uses
from mansion_planner.brief.shared_sizes import with_shared_sizes
from mansion_planner.brief.sizes import sized
from mansion_planner.brief.some_rooms import furniture_of_each
from mansion_planner.brief.storey_attachment import Attachment
from mansion_planner.brief.storeys import read_storeys
from mansion_planner.brief.suites import read_suites
from mansion_planner.brief.told_by_size import told_by_size
from mansion_planner.brief.unit_storeys import attach_units, give_rooms_to_flat
from mansion_planner.brief.units import are_units, flats_that_open, is_type_of_flat
from mansion_planner.brief.unread_words import leave_unread
from mansion_planner.brief.uses import read_stacking, read_storey_uses, read_trade
from mansion_planner.brief.vertical_facts import read_stairs_and_lifts

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
    read_outside(reading)
    read_things_about(reading)
    read_style(reading, named=True)
    read_shape(reading)
    measures = find_measures(reading)
    exception = read_all_but_some(reading)
    places = read_storeys(reading)
    place_some(reading, places, exception)
    read_massing(reading)
    reading.go_on()
    phrases = _Reader(reading, places).read(measures)
    place_all_others(reading, exception)
    reading.go_on()
    read_copies(reading, places)
    reading.facts.rooms = [with_room_of_group(with_bathrooms_by_name(fact)) for fact in reading.facts.rooms]
    give_rooms_to_copies(reading.facts)
    put_on_ground(reading)
    read_clutter_words(reading, phrases)
    read_style(reading, named=False)
    read_floorings(reading)
    reading.facts.unheeded += unheeded_words(reading, phrases, reading.facts)
    leave_unread(reading)
    return reading.facts


class _Reader:
    """Joins the parts of a brief into facts."""

    def __init__(self, reading: Reading, places: list[Place]) -> None:
        self.reading, self.facts, self.places = reading, reading.facts, places
        self.changed = find_changed_copies(reading, places)

    def read(self, measures: list[Measure]) -> list[Phrase]:
        """Read everything that noun phrases are part of; return them."""
        self._find_phrases(measures)
        self.reading.go_on()
        self._find_groups()
        self.reading.go_on()
        self._join()
        self.reading.go_on()
        self._tell_what_is_the_same()
        self._state()
        return self.phrases

    def _find_phrases(self, measures: list[Measure]) -> None:
        """Find the noun phrases and the building among them, and give each phrase its areas."""
        reading = self.reading
        read_adverts(reading, self.places)
        read_trade(reading)
        self.opening = unknown_building(reading, self.places)
        named = without_retractions(reading, noun_phrases(reading))
        own = without_bystanders(reading, named)
        left = {old.last for old, new in zip(named, own, strict=True) if old.head != new.head}
        if self.opening is not None and self.opening[3] in left:
            self.opening = None  # "the flat is bursting: we want a house"
        phrases = rooms_of_several_uses(reading, without_announced(reading, own))
        phrases = with_some_en_suite(reading, with_blocks(reading, phrases))
        phrases = with_accessible_ones(reading, desks_as_places(reading, rooms_by_name(reading, phrases)))
        read_shares(reading, phrases)
        reading.go_on()
        stacked = read_stacking(reading, phrases)
        phrases = [phrase for number, phrase in enumerate(phrases) if number not in stacked]
        self.building = self._name_building(phrases)
        as_studio_flat(reading, phrases)
        phrases = with_one_sized(reading, measures, with_shared_sizes(reading, measures, phrases))
        own = [room_for_building(reading, phrase) for phrase in give_measures(reading, measures, phrases)]
        self.phrases = by_what_else_is_named([told_by_its_words(reading, phrase) for phrase in own])
        one_of_several = told_by_size(reading, with_bare_areas(reading, self.phrases))
        self.phrases, self.others = sized(reading, one_of_several.phrases, self.building), one_of_several.others

    def _find_groups(self) -> None:
        """Find what belongs together: late counts, what each flat holds, what only holds or furnishes another room."""
        reading = self.reading
        read_washing_fittings(reading, self.phrases)
        read_niches(reading, self.phrases, self.building)
        read_late_counts(reading, self.phrases)
        read_counts_by_room(reading, self.phrases)
        self.phrases, self.households = read_households(reading, self.phrases, self.places, self.building)
        self._find_building()
        leave_out_containers(reading, self.phrases, self.places)
        read_fittings(reading, self.phrases)
        self.shared = read_counts_by_storey(reading, self.phrases, self.places, self.households)
        self._find_building()

    def _join(self) -> None:
        """Find what joins the phrases: relations, negations, and the storeys that they are on."""
        reading = self.reading
        relations = read_relations(reading, self.phrases, set() if self.building is None else {self.building})
        self.relations = without_taken_back(reading, self.phrases, relations)
        self.negated = negated_phrases(reading, self.phrases)
        self.attached = attach_units(reading, self.places, self.phrases, self.building, self.households)
        for number, phrase in enumerate(self.phrases):
            if phrase.first in self.shared and number in self.attached:
                self.attached[number] = Attachment(self.attached[number].refs)
        read_storey_uses(reading, self.places, self.phrases, self.attached, self.building)
        read_halves(reading, self.phrases, self.places, self.attached)
        self._place_with(self.others)
        leave_out_other_names(reading, self.phrases, self.building, self.attached, self.negated)

    def _tell_what_is_the_same(self) -> None:
        """Find which phrases name the same rooms, and give those what each of their mentions says."""
        reading, wanted = self.reading, self._wanted_rooms()
        self.same, self.groups = coreferences(reading, self.phrases, wanted, self.relations)
        operands = {n for relation in self.relations for n in (*relation.lefts, *relation.rights)}
        for number in elsewhere_by_another_word(self.phrases, self.same, self.attached):
            if number not in operands:
                del self.same[number]
        tell_rooms_within(reading, self.phrases, self.same)
        give_areas_of_mentions(reading, self.phrases, self.same, wanted)
        place_by_mentions(reading, self.phrases, self.attached, self.same, wanted, self.relations)
        without_totals(reading, self.phrases, self.attached, [n for n in self._wanted_rooms() if n not in self.same])
        read_counts_by_group(reading, self.phrases, self.households)

    def _state(self) -> None:
        """Make facts of the phrases and of what joins them."""
        reading, facts = self.reading, self.facts
        rooms = [
            n
            for n in self._wanted_rooms()
            if self.phrases[n].head == "room" and self.phrases[n].first not in self.households.read
        ]
        read_counts_by_person(reading, self.phrases, rooms, self.same, self.households.inner)
        reading.go_on()
        suites = read_suites(reading, self.phrases, rooms, self.same, self.households.inner)
        reading.go_on()
        read_occupants(reading, self.phrases, self.building, self.attached)
        read_stairs_and_lifts(reading, self.phrases, self.negated)
        facts.objects += read_furnishings(reading, self.phrases, self.attached, self.negated, self.same, self.relations)
        tell_users(reading, self.phrases)
        self._further_ones()
        adverts = tuple(facts.rooms)
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
        facts.objects = furniture_of_each(facts)
        among_adverts(facts, adverts)
        read_changed_copies(reading, self.changed)
        give_rooms_to_flat(reading)
        read_desk_areas(facts)
        state_relations(reading, self.phrases, self.relations, self.same, self.groups)
        read_completeness(reading, self.places, self.phrases)
        read_absent_parts(reading)
        facts.excluded.sort(key=lambda entry: entry[1].end)
        self._take_capacities()

    def _take_capacities(self) -> None:
        """Take how many people a room with an area is for: "a hall of 120 m2 for 80"."""
        reading = self.reading
        sized_rooms = {p.last for p in self.phrases if p.head == "room" and p.areas}
        for index, token in enumerate(reading.tokens):
            if token.kind == "number" and reading.word(index - 1) == "for" and index - 1 in sized_rooms:
                reading.take(index, index + 1)

    def _name_building(self, phrases: list[Phrase]) -> int | None:
        reading = self.reading
        if (flats := flats_that_open(reading, phrases)) is not None:
            self.facts.building.append(("apartment_building", reading.span(flats.begin, flats.noun_end)))
            phrases.remove(flats)
            return None
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
            wanted = number is not None and (
                is_asked_for(reading, phrases[number].first) or self._opens_as_building(phrases[number])
            )
            asked = wanted and is_the_writer(reading, opening[2])
            if known or asked or rooms_before or not (number is None or opening[1]):
                opening = None
        if opening is not None and opening[0] in BARE_BUILDINGS:
            reading.take(opening[2], opening[3])
            opening = None
        if opening is not None:
            name, like, first, last = opening
            if name in reading.knowledge.buildings:
                self.facts.building.append((name, reading.span(first, last)))
            else:
                self.facts.building_name, self.facts.building_like = name, like
                self.facts.building_span.append(reading.span(first, last))
            reading.take(first, last)
            phrases[:] = [p for p in phrases if p.last <= first or p.first >= last]
            number = None
        if number is None:
            read_sizes(reading, 0, 0)
            return None
        number = self._without_the_writer(phrases, number)
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

    def _opens_as_building(self, phrase: Phrase) -> bool:
        """Whether a sentence begins with what is asked for: "Our lab tests robots. Office building, three floors"."""
        return self.reading.word(phrase.noun_end - 1) in BARE_BUILDINGS and self.reading.starts(phrase.first)

    def _without_the_writer(self, phrases: list[Phrase], number: int) -> int:
        """Leave out who asks for the building: "We are a bank. We need an office"; return its number then."""
        reading, building = self.reading, phrases[number]
        if not is_asked_for(reading, building.first):
            return number
        writers = [p for p in phrases[:number] if p.building and is_the_writer(reading, p.first)]
        for phrase in writers:
            reading.take(phrase.first, phrase.last)
        phrases[:] = [p for p in phrases if p not in writers]
        return phrases.index(building)

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

    def _are_alike(self, one: Phrase, other: Phrase) -> bool:
        """Whether two rooms count as the same kind: a main bedroom and a second one."""
        kinds = [self.reading.knowledge.room(p.room_type).counts_as if p.room_type else "" for p in (one, other)]
        return one.room_type == other.room_type or (kinds[0] == kinds[1] != "")

    def _wanted_rooms(self) -> list[int]:
        """Return the phrases that name rooms of the building."""
        return [
            n
            for n, p in enumerate(self.phrases)
            if p.head in ("room", "building") and n != self.building and n not in self.negated
        ]

    def _further_ones(self) -> None:
        """Take the ordinal of one more room of a kind: "an en-suite bathroom ... a second bathroom"."""
        for number, phrase in enumerate(self.phrases):
            ordinal = phrase.begin - 1
            if phrase.head != "room" or self.reading.kind(ordinal) != "ordinal" or ordinal in self.reading.taken:
                continue
            before = [p for p in self.phrases[:number] if p.head == "room" and self._are_alike(p, phrase)]
            leads = self.reading.word(ordinal - 1) in ("a", "the", "and", ",", ":", "(") or self.reading.starts(ordinal)
            if leads and before and number not in self.same:
                self.reading.take(ordinal, ordinal + 1)
