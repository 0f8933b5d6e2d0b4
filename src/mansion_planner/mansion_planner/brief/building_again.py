"""Leave out phrases that only name the building again, or what it was before."""

from collections.abc import Mapping
from dataclasses import replace

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.storey_attachment import Attachment

__all__ = ["leave_out_other_names"]

_HOMES = frozenset({"house", "home", "building", "villa", "cottage", "cabin", "bungalow"})
"""Nouns that with "the" mean the whole building."""


def leave_out_other_names(
    reading: Reading,
    phrases: list[Phrase],
    building: int | None,
    attached: Mapping[int, Attachment],
    negated: Mapping[int, tuple[int, int]],
) -> None:
    """Leave out what only names the building again: "penthouse-style flat", "an old barn to turn into a home".

    Parameters
    ----------
    building : int, optional
        Number of the phrase that names the building itself.
    attached, negated : mapping
        Phrases whose storey is said, and those that a negation reaches.
    """
    named = phrases[building] if building is not None else None
    for number, phrase in enumerate(phrases):
        if number == building:
            continue
        placed = number in attached or number in negated
        if _is_where_it_stands(reading, phrase, named) or (
            _could_name_it(phrase)
            and (_is_said_of_it(reading, phrase, named) or (not placed and _names_it(reading, phrase, named)))
        ):
            phrases[number] = replace(phrase, head="unknown")


def _could_name_it(phrase: Phrase) -> bool:
    """Whether a phrase is of one building, with neither a number nor an area of its own."""
    return bool(phrase.building) and not (phrase.plural or phrase.counted or phrase.areas)


def _is_where_it_stands(reading: Reading, phrase: Phrase, named: Phrase | None) -> bool:
    """Whether a phrase is what holds the building, or what it was: "inside one flat", "a riad turned hotel"."""
    if named is None:
        return False
    storey = reading.word(phrase.first - 1) == "of" and reading.word(phrase.first - 2) in FLOOR_WORDS
    if phrase.building and storey and phrase.determiner in ("a", "an") and phrase.first > named.first:
        return True  # "a gym ... all on the first floor of a shopping centre"
    turned = {"turned", "converted", "cum"} & set(reading.words(phrase.begin, phrase.noun_end))
    return bool(turned) or (phrase.count == 1 and _holds_all(reading, phrase, named))


def _is_said_of_it(reading: Reading, phrase: Phrase, named: Phrase | None) -> bool:
    """Whether a phrase is the building's look, its shop or "the house", wherever in the text it stands."""
    if named is not None and phrase.head == "building" and _is_alone(reading, phrase):
        return True  # "Modern farmhouse." is how it looks
    if _is_of_trade(reading, phrase):
        return True  # "over the shop we live ourselves"
    if named is not None and _WHOLE & set(reading.words(phrase.first, phrase.noun_end)):
        return True  # "only one sofa in the whole flat"
    return phrase.determiner == "the" and phrase.name in _HOMES  # "all over the house"


_WHOLE = frozenset({"whole", "entire"})


def _names_it(reading: Reading, phrase: Phrase, named: Phrase | None) -> bool:
    """Whether a phrase in the sentence that names the building is another name of it, rather than one of its rooms."""
    if named is None or reading.sentence[phrase.first] != reading.sentence[named.first]:
        return False
    if _stands_in_apposition(reading, phrase, named):
        return True  # "a guest house, victorian house, ..."
    if reading.word(named.last) == "for" and 0 < phrase.first - named.last <= 2:
        return True  # "a hostel for an engineering college"
    before = {phrase.determiner, reading.word(phrase.first - 1), reading.word(phrase.first - 2)}
    if phrase.first > named.first and before & _LEADS_TO_PARTS:
        return False
    buildings = reading.knowledge.buildings
    same_family = buildings[phrase.building].family == buildings[named.building].family
    return same_family or phrase.first < named.first


_LEADS_TO_PARTS = frozenset({"with", "and", ",", ":", "plus", "containing", "has", "have", "a"})
"""Words before a part of the building that is named after it."""


def _is_of_trade(reading: Reading, phrase: Phrase) -> bool:
    """Whether "the shop" of who sells something is the building, or what is below, rather than another room."""
    trades = {kind for kind, _ in reading.facts.trades}
    return phrase.determiner == "the" and phrase.name == "shop" and phrase.building in trades


def _stands_in_apposition(reading: Reading, phrase: Phrase, named: Phrase) -> bool:
    """Whether a home named right after the building, with no article and between commas, is the building again."""
    bare = phrase.head == "building" and not phrase.determiner and reading.starts(named.first)
    after = reading.word(named.last) == "," and phrase.first == named.last + 1
    last = reading.word(phrase.noun_end - 1)
    return bare and after and last in ("house", "home", "building") and reading.word(phrase.last) in (",", ":", ".")


def _holds_all(reading: Reading, phrase: Phrase, named: Phrase) -> bool:
    """Whether "inside one flat" speaks of the building, as "in an old factory" does of where it is."""
    before = reading.word(phrase.first - 1)
    buildings = reading.knowledge.buildings
    if not phrase.building or phrase.first < named.first:
        return False
    old = {"old", "former", "rented", "existing", "disused"} & set(reading.words(phrase.first, phrase.noun_end))
    first = phrase.first - (reading.word(phrase.first - 1) in ("a", "an"))
    if old and reading.word(first - 1) in ("in", "inside", "within", "into"):
        return reading.sentence[phrase.first] == reading.sentence[named.first]
    alike = buildings[phrase.building].family == buildings[named.building].family
    return before in ("inside", "within") and alike


def _is_alone(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase of a style and a noun is a sentence of its own."""
    sentence = reading.sentence[phrase.first]
    others = [i for i, s in enumerate(reading.sentence) if s == sentence]
    styled = any(m.style and m.first == others[0] and m.last == phrase.noun_end - 1 for m in reading.mentions)
    return styled and others[-1] <= phrase.noun_end
