"""Read parts of a room that are named for what stands there: "a lounge with a TV corner", "a hall with a stage"."""

from collections.abc import Sequence
from dataclasses import replace

from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["NICHES", "THING_FOR", "read_niches"]

NICHES = frozenset({"corner", "nook", "alcove", "niche"})
"""Nouns for a part of a room."""
_RECESSES = NICHES | {"recess"}
THING_FOR = {
    **dict.fromkeys(("reading", "sitting", "seating", "lounge", "cosy", "cozy", "relaxing"), "armchair"),
    **dict.fromkeys(("dining", "breakfast", "eating", "lunch"), "dining_table"),
    **dict.fromkeys(("sleeping", "bed", "sleep"), "bed"),
    **dict.fromkeys(("work", "working", "study", "office", "homework", "desk", "computer", "writing"), "desk"),
    **dict.fromkeys(("play", "kid", "child", "toy", "children"), "toy_shelf"),
    **dict.fromkeys(("tv", "television", "media"), "television"),
    **dict.fromkeys(("coffee", "espresso"), "coffee_machine"),
    **dict.fromkeys(("dressing", "make-up", "makeup", "vanity"), "vanity_table"),
    "music": "piano",
    "laundry": "washing_machine",
    "library": "bookshelf",
    "book": "bookshelf",
    "prayer": "prayer_rug",
    "plant": "house_plant",
    "yoga": "yoga_mat",
}
"""What stands in a part of a room that is called so."""
_ONE_ROOM = frozenset({"studio_flat", "tiny_house", "cabin"})
"""Buildings of one room, whose parts are parts of that."""
_JOINTS = frozenset(
    {"with", "a", "an", "and", ",", "the", "its", "has", "have", "plus", "&", "also", "(", "each", "every"}
)
_STAGE = "stage"
"""A room, and what stands in a hall that has it."""
_OF_SIZE = frozenset(
    {"of", "m2", "m²", "sqm", "qm", "square", "metre", "metres", "meter", "meters", "sq", "ft", "foot", "feet"}
)
"""Words of an area that a phrase has before what the room is said to have."""
_INTO = frozenset({"in", "inside", "within", "of", "at"})
_POINTING = frozenset({"the", "a", "each", "every", "our"})


def read_niches(reading: Reading, phrases: list[Phrase], building: int | None) -> None:
    """Make furniture of the parts of a room that a brief names with it; those that stand alone are rooms.

    Parameters
    ----------
    building : int, optional
        The phrase that names the building.
    """
    for number, phrase in enumerate(phrases):
        if _is_desk_within(reading, phrases, number):
            category = furniture_of(reading.words(phrase.noun_end - 1, phrase.noun_end))[0]
            phrases[number] = replace(phrase, head="object", category=category, room_type="")
            continue
        stage = _is_bare_stage(phrase)
        if not (stage or _is_niche(reading, phrase)) or not _is_part(reading, phrases, number, building):
            continue
        front = reading.words(phrase.begin, phrase.noun_end - 1)
        category = _STAGE if stage else THING_FOR.get(front[-1], "") or furniture_of(front)[0]
        if category:
            label = phrase.label if stage else phrase.label.rpartition(" ")[0] or phrase.label
            phrases[number] = replace(phrase, head="object", category=category, room_type="", label=label)


_DESKS = frozenset({"desk", "counter", "till", "checkout"})


def _is_desk_within(reading: Reading, phrases: Sequence[Phrase], number: int) -> bool:
    """Whether a desk that would be a place of its own stands in a room: "a ticket desk in the foyer"."""
    phrase = phrases[number]
    if phrase.head != "room" or phrase.areas or reading.word(phrase.noun_end - 1) not in _DESKS:
        return False
    after = phrases[number + 1] if number + 1 < len(phrases) else None
    within = after is not None and after.head == "room"
    return within and reading.words(phrase.last, after.begin if after else 0) in (
        ("in", "the"),
        ("in", "a"),
        ("inside", "the"),
    )


def _is_bare_stage(phrase: Phrase) -> bool:
    """Whether a phrase names a stage without a size of its own, which a hall has as it has its chairs."""
    return phrase.head == "room" and phrase.room_type == _STAGE and not phrase.areas and not phrase.plural


def _is_niche(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase names a corner of a room, and the brief makes no room of it."""
    if phrase.head != "room" or phrase.areas or phrase.plural or phrase.noun_end - phrase.begin < 2:
        return False
    last = phrase.noun_end
    rest = reading.text[reading.tokens[last - 1].end : reading.tokens[last].start] if last < len(reading.tokens) else ""
    return reading.word(last - 1) in _RECESSES and not rest.strip()  # "a reading corner as its own room"


def _joints(reading: Reading, first: Phrase, second: Phrase) -> set[str]:
    """Return the words between two phrases, without those that state the first one's area."""
    words = set(reading.words(first.last, second.first))
    return {word for word in words if not (first.areas and (word in _OF_SIZE or word[0].isdigit()))}


def _is_part(reading: Reading, phrases: Sequence[Phrase], number: int, building: int | None) -> bool:
    """Whether a phrase is told with the room that it is a part of: "lounge with a TV corner", "a nook in the den"."""
    phrase = phrases[number]
    after = phrases[number + 1] if number + 1 < len(phrases) else None
    leads = reading.word(phrase.last) in _INTO and after is not None and after.head == "room"
    if leads and after and set(reading.words(phrase.last, after.first)) <= _INTO | _POINTING:
        return True
    at, led = number, False
    while at > 0 and (joints := _joints(reading, phrases[at - 1], phrases[at])) <= _JOINTS:
        led = bool({"with", "has", "have"} & joints)
        at -= 1
        if led or not (phrases[at].head == "object" or reading.word(phrases[at].noun_end - 1) in _RECESSES):
            break
    if not led:
        return False
    if at == building or phrases[at].head == "building":
        return phrases[at].building in _ONE_ROOM
    return phrases[at].head == "room"
