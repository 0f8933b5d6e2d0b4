"""Read rooms that are only fittings of another room, or only hold the rooms that are counted after them."""

import itertools
from collections.abc import Sequence
from dataclasses import replace

from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Place, Reading

__all__ = ["leave_out_containers", "read_fittings"]

_ROOMS_WITH_BARS = frozenset({"bar", "lounge", "common_room", "nightclub_floor"})
"""Rooms whose bar is the counter in them: a club room with a bar."""
_FIXTURES = frozenset({"shower", "bath", "walk_in_shower", "loo"})
_BATHROOMS = frozenset({"bathroom", "ensuite_bathroom", "accessible_toilet"})


def leave_out_containers(reading: Reading, phrases: list[Phrase], places: Sequence[Place]) -> None:
    """Leave out what only holds rooms that are counted themselves: "wards with twelve patient rooms"."""
    for number, phrase in enumerate(phrases[:-1]):
        following = phrases[number + 1]
        if (
            phrase.head == "room"
            and phrase.plural
            and not phrase.counted
            and (_holds(reading, phrase, following) or _is_spelt_out(reading, phrase, following, places))
            and following.head == "room"
            and following.counted
            and (following.count or 0) > 2
        ):
            phrases[number] = replace(phrase, head="unknown")


def _holds(reading: Reading, phrase: Phrase, following: Phrase) -> bool:
    """Whether rooms hold those that come after them: "wards with twelve patient rooms"."""
    return reading.words(phrase.last, following.first) in (("with",), ("of",))


def _is_spelt_out(reading: Reading, phrase: Phrase, following: Phrase, places: Sequence[Place]) -> bool:
    """Whether rooms of the same kind are counted after a colon: "the labs: per storey four wet labs"."""
    colon = phrase.determiner == "the" and reading.word(phrase.last) == ":"
    placed = any(place.first <= phrase.last + 1 and place.last == following.first for place in places)
    near = following.first == phrase.last + 1 or placed
    return colon and near and f"_{following.name}".endswith(f"_{phrase.name}")


def read_fittings(reading: Reading, phrases: list[Phrase]) -> None:
    """Read "every cell fitted with bunk, toilet and desk" as furniture, though a toilet can be a room as well."""
    fitted = {
        reading.sentence[index]: index
        for index in reversed(range(len(reading.tokens)))
        if reading.word(index) in ("fitted", "equipped", "furnished") and reading.word(index + 1) == "with"
    }
    for number, phrase in enumerate(phrases):
        if number and _goes_on_furniture(reading, phrases[number - 1], phrase):
            reading.taken.difference_update(range(phrase.begin, phrase.last))
            phrases[number] = replace(phrase, head="unknown", room_type="")
            continue
        if phrase.head == "elevator" and number and _is_lift_of_bay(reading, phrases[number - 1], phrase):
            phrases[number] = replace(phrase, head="object", category="car_lift")
            continue
        workplaces = phrase.name == "workplace" and phrase.counted
        if (phrase.head != "room" and not workplaces) or phrase.areas:
            continue
        category, _ = furniture_of(reading.words(phrase.begin, phrase.noun_end))
        before = phrases[number - 1] if number else None
        fit = fitted.get(reading.sentence[phrase.first], phrase.first)
        listed = fit < phrase.first and (",", "plus") not in itertools.pairwise(reading.words(fit, phrase.first))
        listed_thing = phrase.name in _THINGS_TOO and before is not None and _is_listed_thing(reading, before, phrase)
        counter = before is not None and _is_counter_of(reading, before, phrase)
        if counter or (
            category and (listed or listed_thing or (before is not None and _is_fixture(reading, before, phrase)))
        ):
            category = "bar_counter" if counter else category
            phrases[number] = replace(phrase, head="object", category=category, room_type="")


def _goes_on_furniture(reading: Reading, before: Phrase, phrase: Phrase) -> bool:
    """Whether an unknown name that may be no room goes on with furniture: "two fume hoods and an eye wash"."""
    doubtful = phrase.head == "room" and not phrase.known and reading.word(phrase.noun_end - 1) in _DOUBTFUL
    return (
        doubtful
        and before.head == "object"
        and reading.words(before.last, phrase.begin) in (("and", "a"), ("and", "an"))
    )


def _is_lift_of_bay(reading: Reading, room: Phrase, phrase: Phrase) -> bool:
    """Whether a lift is what cars are raised on: "four bays, each with a lift"."""
    gap = set(reading.words(room.last, phrase.first))
    return room.room_type == "car_workshop" and "with" in gap and gap <= {",", "each", "every", "with", "a", "one"}


_DOUBTFUL = frozenset({"wash", "post", "pool", "booth", "station"})
"""Nouns that head names of rooms and of things alike."""


def _is_fixture(reading: Reading, room: Phrase, phrase: Phrase) -> bool:
    """Whether "a bathroom with a shower" and "a staff room with lockers" speak of what stands in the room."""
    between = reading.words(room.last, phrase.begin)
    if room.head != "room" or between not in (("with",), ("with", "a"), ("with", "the")):
        return False
    return phrase.name.rpartition("_")[2] in ("locker", "workplace") or (
        room.room_type in _BATHROOMS and phrase.name in _FIXTURES
    )


def _is_counter_of(reading: Reading, room: Phrase, phrase: Phrase) -> bool:
    """Whether "a taproom with its long bar" speaks of the counter of a room where drinks are served."""
    between = reading.words(room.last, phrase.begin)
    counter = phrase.name == "bar" and room.head == "room" and room.room_type in _ROOMS_WITH_BARS
    return counter and between in (("with", "its"), ("and", "its"), ("with", "a"), ("with",))


def _is_listed_thing(reading: Reading, before: Phrase, phrase: Phrase) -> bool:
    """Whether "eight lockers" and "20 shelves and the till" are furniture: several counted, or named with furniture."""
    between = set(reading.words(before.last, phrase.begin))
    counted = phrase.name == "locker" and phrase.counted and phrase.plural
    return counted or (before.head == "object" and between <= {"and", "+", "a", ",", "one", "the"})


_THINGS_TOO = frozenset({"locker", "till", "checkout", "cash_register", "register"})
"""Furniture whose noun names a room as well."""
