"""A brief while it is read: its tokens, the phrases found in them, and which tokens a statement was read from."""

from collections.abc import Callable
from dataclasses import dataclass, field

from mansion_knowledge import KnowledgeBase
from mansion_language import Token, tokenize
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_planner.brief.activities import activities, entrances
from mansion_planner.brief.alternatives import chosen
from mansion_planner.brief.building_capacities import children_groups, garages
from mansion_planner.brief.conversions import without_conversions
from mansion_planner.brief.corrections import corrected_numbers
from mansion_planner.brief.count_forms import count_forms
from mansion_planner.brief.counted_compounds import BUILDING_HEADS, counted_compounds
from mansion_planner.brief.counted_parts import counted_parts
from mansion_planner.brief.earlier_briefs import without_recalled_wishes, without_withdrawn_briefs
from mansion_planner.brief.excepted_storeys import excepted_storeys
from mansion_planner.brief.facts import BriefFacts, FloorRef, Quantity, Span
from mansion_planner.brief.furniture_words import furniture_vocabulary
from mansion_planner.brief.glosses import without_glosses
from mansion_planner.brief.groups_of_people import groups_of_people
from mansion_planner.brief.labelled_rooms import kinds_of_rooms, labelled_rooms
from mansion_planner.brief.lexicon import Mention, lexicon_of
from mansion_planner.brief.masters_bathroom import masters_bathroom
from mansion_planner.brief.mezzanines import mezzanines
from mansion_planner.brief.missing_units import with_units
from mansion_planner.brief.numbered_units import numbered_units
from mansion_planner.brief.numerals_in_turn import numerals_in_turn
from mansion_planner.brief.paired_nouns import paired_nouns
from mansion_planner.brief.relative_areas import relative_areas
from mansion_planner.brief.rooms_by_number import in_digits, rooms_by_number
from mansion_planner.brief.rooms_by_person import rooms_by_person
from mansion_planner.brief.rooms_by_sex import rooms_by_sex
from mansion_planner.brief.seated_people import seated_people
from mansion_planner.brief.shortened_nouns import flat_types, shortened_nouns
from mansion_planner.brief.single_floors import single_flats, single_floors, single_units
from mansion_planner.brief.spelling import corrected, without_slips
from mansion_planner.brief.spoken_turns import spoken_turns
from mansion_planner.brief.stacked_flats import stacked_flats
from mansion_planner.brief.storey_forms import added_storeys, storey_forms, storey_tables
from mansion_planner.brief.storey_headings import storey_headings
from mansion_planner.brief.storeys_by_use import storeys_by_use
from mansion_planner.brief.storeys_in_full import storeys_in_full
from mansion_planner.brief.storeys_in_order import storeys_in_order
from mansion_planner.brief.token_forms import (
    abbreviated_storeys,
    areas_behind_capacities,
    capacities,
    compounds,
    decades,
    equal_rooms,
    foreign_storeys,
    gross_areas,
    kinds_of_area,
    metering,
    open_decks,
    owned_by_each,
    parts_before_of_which,
    to_the_ceiling,
    upward_ranges,
    workplaces,
)
from mansion_planner.brief.told_again import without_asides
from mansion_planner.brief.twin_homes import twin_homes
from mansion_planner.brief.unit_totals import unit_totals

__all__ = ["FLOOR_WORDS", "Place", "Reading", "start_reading"]

_APPOSITIVE = frozenset(
    "so i e . that is which meaning means lies directly right just immediately one the above over below under".split()
)
"""Words that lead from a storey to the one that tells where it lies."""

FLOOR_WORDS = frozenset(
    """
    floor storey story level storied storeyed floored leveled levelled deck storie
    """.split()
)
_BREAKS = frozenset({".", ";", "\n", "!", "?"})
_ABBREVIATIONS = frozenset(
    """
    approx ca dr incl max min no nr sq etc st vs eg resp
    """.split()
)


@dataclass(frozen=True)
class Place:
    """A reference to storeys: tokens `first` to `last` (exclusive).

    Attributes
    ----------
    refs : tuple of FloorRef
    led : bool
        A preposition leads it ("on the top floor"), so it may belong to what stands before it.
    heading : bool
        It stands alone before a colon or a line break: all that follows belongs to it.
    """

    first: int
    last: int
    refs: tuple[FloorRef, ...]
    led: bool
    heading: bool = False


@dataclass
class Reading:
    """The state that the readers share.

    Attributes
    ----------
    taken : set of int
        Indices of tokens that are part of a statement.
    mention_at : dict of int to Mention
        Phrases of the lexicon by their first token.
    modifiers : set of int
        Indices of tokens that stand before the head of a room or a building, and may say of its style.
    named_areas : set of int
        Indices of numbers whose area was given to rooms together with their names.
    implied_storeys : list of Quantity
        Numbers of storeys that follow from other words ("the six upper floors"): they count where none is stated.
    differing : set of int
        Indices of tokens that say that a storey is like another one, but for what follows.
    cancelled : callable
        Whether the reading is not wanted any more.
    sentence : list of int
        For each token the number of its sentence; lines, semicolons and full stops end one.
    """

    text: str
    tokens: list[Token]
    mentions: list[Mention]
    knowledge: KnowledgeBase
    facts: BriefFacts = field(default_factory=BriefFacts)
    taken: set[int] = field(default_factory=set)
    mention_at: dict[int, Mention] = field(default_factory=dict)
    named_areas: set[int] = field(default_factory=set)
    sentence: list[int] = field(default_factory=list)
    modifiers: set[int] = field(default_factory=set)
    implied_storeys: list[Quantity] = field(default_factory=list)
    differing: set[int] = field(default_factory=set)
    cancelled: Callable[[], bool] = lambda: False

    def go_on(self) -> None:
        """Go on, unless the reading is cancelled; called between the steps, none of which takes long.

        Raises
        ------
        MansionError
            ``CANCELED``.
        """
        if self.cancelled():
            raise MansionError(ErrorCode.CANCELED, "the reading of the description was cancelled")

    def word(self, index: int) -> str:
        """Return the normal form of a token, or an empty string outside the brief."""
        return self.tokens[index].text if 0 <= index < len(self.tokens) else ""

    def kind(self, index: int) -> str:
        """Return the kind of a token, or an empty string outside the brief."""
        return self.tokens[index].kind if 0 <= index < len(self.tokens) else ""

    def value(self, index: int) -> float:
        """Return the number of a token, or 0."""
        return self.tokens[index].value if 0 <= index < len(self.tokens) else 0.0

    def plural(self, index: int) -> bool:
        """Whether a token is a noun in the plural."""
        return 0 <= index < len(self.tokens) and self.tokens[index].plural

    def words(self, first: int, last: int) -> tuple[str, ...]:
        """Return the normal forms of tokens `first` to `last` (exclusive)."""
        return tuple(self.word(index) for index in range(first, last))

    def breaks(self, index: int) -> bool:
        """Whether a token ends a sentence (or lies outside the brief)."""
        if not 0 <= index < len(self.tokens):
            return True
        return self.word(index) in _BREAKS and not self._abbreviated(index) and not self._goes_on(index)

    def _goes_on(self, index: int) -> bool:
        """Whether a full stop is one of several after which the sentence goes on: "with glass... next to the hall"."""
        if self.word(index) != "." or "." not in (self.word(index - 1), self.word(index + 1)):
            return False
        last = index
        while self.word(last + 1) == ".":
            last += 1
        after = last + 1
        return index < last or (
            after < len(self.tokens) and not self.tokens[after].capital and self.word(after) != "\n"
        )

    def _abbreviated(self, index: int) -> bool:
        """Whether a full stop belongs to an abbreviation: "approx.", "sq.m. each"."""
        if self.word(index) != "." or self.tokens[index].spaced:
            return False
        if self.word(index - 1) == "no" and self.kind(index + 1) != "number":
            return self.kind(index - 2) == "number"  # "2 no. meeting rooms", not "lift: no. Stairs"
        unit = self.kind(index - 1) == "unit" and self.text[self.tokens[index - 1].end - 1] in "mt"
        lower = index + 1 < len(self.tokens) and self.text[self.tokens[index + 1].start].islower()
        return self.word(index - 1) in _ABBREVIATIONS or (unit and lower)

    def starts(self, index: int) -> bool:
        """Whether a token is the first of its sentence, bullets and numbering of a list aside."""
        before = index - 1
        if self.word(before) == "/" and self.tokens[before].spaced and self.tokens[index].spaced:
            return True
        while self.word(before) in ("*", "-", "(", ")") and before >= 0:
            before -= 1
        numbered = self.kind(before) == "number" and self.word(before + 1) in (".", ")")
        return self.breaks(before) or (numbered and self.breaks(before - 1))

    def span(self, first: int, last: int) -> Span:
        """Return the piece of the brief from token `first` to `last` (exclusive), which need not be in its order."""
        tokens = self.tokens[first:last] or [self.tokens[first], self.tokens[last - 1]]
        start, end = min(token.start for token in tokens), max(token.end for token in tokens)
        return Span(self.text[start:end], start, end)

    def take(self, first: int, last: int) -> None:
        """Mark tokens as part of a statement."""
        self.taken.update(range(first, last))

    def appositive(self, index: int) -> int:
        """Return where words like ", so directly above" end, which lead to the storey that one lies above; or 0."""
        if self.word(index) not in (",", "(", "–", "-"):
            return 0
        end = index + 1
        while end - index < 8 and self.word(end) in _APPOSITIVE:
            end += 1
        end -= self.word(end - 1) == "the"
        return end if end > index + 1 and self.word(end - 1) in ("above", "over", "below", "under") else 0

    def free(self, first: int, last: int) -> bool:
        """Whether no token from `first` to `last` (exclusive) is part of a statement yet."""
        return self.taken.isdisjoint(range(first, last))


def start_reading(text: str, knowledge: KnowledgeBase, cancelled: Callable[[], bool] = lambda: False) -> Reading:
    """Tokenise `text`, correct misspelt words and find the phrases of the knowledge base."""
    lexicon = lexicon_of(knowledge)
    tokens = with_units(without_withdrawn_briefs(without_slips(tokenize(text.replace("@", "à")))))
    tokens = parts_before_of_which(to_the_ceiling(tokens))
    tokens = chosen(without_conversions(without_recalled_wishes(without_glosses(tokens))))
    tokens = spoken_turns(kinds_of_rooms(rooms_by_sex(shortened_nouns(tokens))))
    tokens, corrections = corrected_numbers(without_asides(tokens))
    tokens = labelled_rooms(
        paired_nouns(entrances(rooms_by_person(twin_homes(children_groups(masters_bathroom(tokens)), FLOOR_WORDS))))
    )
    tokens = groups_of_people(numbered_units(tokens, lexicon.heads))
    tokens = storey_tables(abbreviated_storeys(text, decades(equal_rooms(tokens, FLOOR_WORDS))), FLOOR_WORDS)
    tokens = rooms_by_number(added_storeys(in_digits(tokens), FLOOR_WORDS))
    tokens = counted_parts(numerals_in_turn(tokens, FLOOR_WORDS))
    tokens = excepted_storeys(storeys_in_full(tokens, FLOOR_WORDS), FLOOR_WORDS)
    tokens = unit_totals(storeys_in_order(tokens, FLOOR_WORDS), FLOOR_WORDS)
    tokens = mezzanines(storey_headings(storey_forms(text, tokens), FLOOR_WORDS), FLOOR_WORDS)
    tokens = flat_types(count_forms(storeys_by_use(tokens, FLOOR_WORDS)))
    tokens = compounds(corrected(tokens, lexicon.words, furniture_vocabulary()), lexicon.words)
    tokens = workplaces(
        foreign_storeys(open_decks(kinds_of_area(gross_areas(areas_behind_capacities(metering(tokens))))))
    )
    tokens = stacked_flats(relative_areas(tokens), FLOOR_WORDS)
    tokens = activities(tokens)
    tokens = counted_compounds(
        single_floors(single_flats(single_units(tokens)), BUILDING_HEADS | lexicon.building_heads),
        lexicon.building_heads,
    )
    tokens = seated_people(garages(tokens, lexicon.building_heads))
    tokens = capacities(owned_by_each(upward_ranges(tokens, FLOOR_WORDS)), lexicon.heads)
    mentions = lexicon.find(tokens)
    reading = Reading(
        text=text,
        tokens=tokens,
        mentions=mentions,
        knowledge=knowledge,
        mention_at={mention.first: mention for mention in mentions},
        cancelled=cancelled,
    )
    reading.facts.corrections += [Span(text[start:end], start, end) for start, end in corrections]
    number = 0
    for index in range(len(tokens)):
        reading.sentence.append(number)
        number += reading.breaks(index)
    return reading
