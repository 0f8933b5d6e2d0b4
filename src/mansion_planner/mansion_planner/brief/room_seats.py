"""Read for how many people a room is, as the seats or beds that it needs: "a hall for 80 guests", "a 6-bed dorm"."""

from dataclasses import replace

from mansion_planner.brief.area_words import after_area
from mansion_planner.brief.facts import ObjectFact
from mansion_planner.brief.phrase import FUNCTION_WORDS, PEOPLE, Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["is_whole_building", "places_for_people", "sleeping_in_bunks"]


def places_for_people(reading: Reading, phrases: list[Phrase], negated: dict[int, tuple[int, int]]) -> list[ObjectFact]:
    """Return the seats and beds that rooms need for those whom the brief counts.

    Parameters
    ----------
    negated : dict of int to (int, int)
        Phrases that are not wanted.
    """
    return _seats(reading, phrases, negated) + _numbered_places(reading, phrases, negated)


def sleeping_in_bunks(things: list[ObjectFact]) -> list[ObjectFact]:
    """Return furniture with the beds of a room for so many as half of them bunk beds, where it is to have such."""
    bunked = {thing.room for thing in things if thing.category == "bunk_bed" and thing.count is None}
    return [
        replace(thing, category="bunk_bed", count=-(-(thing.count or 0) // 2), noun="bunk beds")
        if thing.room in bunked and thing.noun == "beds" and thing.words.startswith("for ")
        else thing
        for thing in things
    ]


def is_whole_building(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase names the building that the brief is about."""
    return any(span == reading.span(phrase.begin, phrase.noun_end) for _, span in reading.facts.building)


_SEATED = PEOPLE | {"seat", "chair"}


def _seats(reading: Reading, phrases: list[Phrase], negated: dict[int, tuple[int, int]]) -> list[ObjectFact]:
    """Read how many people a room is for as the seats that it needs: "a dining room for 48 guests", "seating 50"."""
    found = []
    for number, phrase in enumerate(phrases):
        named = phrase.head == "room" or (phrase.head == "building" and not is_whole_building(reading, phrase))
        bedded = phrase.room_type in _DORMITORIES
        if not named or not phrase.room_type or number in negated or (phrase.room_type in _UNSEATED and not bedded):
            continue
        end = _after_storey(reading, after_area(reading, phrase.last))
        begin = end + (reading.word(end) == ",")
        begin = begin + 1 if reading.word(begin) in ("each", "every") else end
        link, at = reading.word(begin), begin + 1
        at += reading.word(at) in ("about", "around", "up", "at", "some")
        at += reading.word(at) in ("to", "least")
        seated = reading.word(at + 1) in _SEATED
        bracketed = link == "(" and seated and reading.words(at + 1, at + 3) not in (("seat", ")"), ("chair", ")"))
        apiece = reading.word(at + 2) in ("each", "apiece")
        bracketed = bracketed and reading.word(at + 2 + apiece) == ")"
        if not (bracketed or link in ("for", "seating", "seat")) or reading.kind(at) != "number":
            continue
        if not 1 < reading.value(at) <= 500:
            continue
        last = at + 1 + seated + (bracketed and not apiece)
        if last == at + 1 and reading.kind(last) == "word" and reading.word(last) not in FUNCTION_WORDS:
            continue  # "for 150 stacking chairs" is about what is kept there
        each = begin > end or reading.word(last) in ("each", "apiece")
        each = each or _is_for_each(phrase, reading.value(at))
        last += (reading.word(last) in ("each", "apiece")) + (bracketed and apiece)
        span = reading.span(begin - (begin > end), last)
        found.append(ObjectFact(
            words=f"for {reading.value(at):.0f}", category="bed" if bedded else "chair", span=span,
            count=int(reading.value(at)), room=phrase.name, room_type=phrase.room_type, each=each,
            noun="beds" if bedded else "seats", exact=bedded,
        ))  # fmt: skip
        reading.take(begin - (begin > end), last)
    return found


def _is_for_each(room: Phrase, people: float) -> bool:
    """Whether a number of people is that of each of several rooms: so few, or a number that cannot be shared out."""
    rooms = (room.count or 1) if room.counted else 1
    return rooms > 1 and (people % rooms != 0 or people < _SHARED * rooms)


_SHARED = 4
"""People to a room from which on their number may be that of all rooms together."""


def _after_storey(reading: Reading, index: int) -> int:
    """Return where a storey ends that stands at a token: "an office upstairs for 15 people"."""
    if reading.word(index) in _STAIRS:
        return index + 1
    if reading.word(index) not in ("on", "at", "in") or reading.word(index + 1) != "the":
        return index
    return next((at + 1 for at in range(index + 2, index + 4) if reading.word(at) in FLOOR_WORDS), index)


_STAIRS = frozenset({"upstairs", "upstair", "downstairs", "downstair"})


def _numbered_places(reading: Reading, phrases: list[Phrase], negated: dict[int, tuple[int, int]]) -> list[ObjectFact]:
    """Read "three 6-bed dorms" and "a 12-seat boardroom" as the furniture that each such room needs."""
    found = []
    for number, phrase in enumerate(phrases):
        named = phrase.head == "room" or (phrase.head == "building" and not is_whole_building(reading, phrase))
        if not named or not phrase.room_type or number in negated or reading.knowledge.room(phrase.room_type).unit:
            continue  # "two-bed flats" have two bedrooms
        for index in range(max(phrase.first - 2, 0), phrase.noun_end - 1):
            category = _PLACES.get(reading.word(index + 1))
            joined = not reading.tokens[index + 1].spaced and reading.kind(index) == "number"
            if category is None or not joined or not 1 < reading.value(index) <= 100:
                continue
            span = reading.span(index, index + 2)
            found.append(ObjectFact(
                words=f"for {reading.value(index):.0f}", category=category, span=span, count=int(reading.value(index)),
                room=phrase.name, room_type=phrase.room_type, each=True, noun=_PLACES_AS[category],
            ))  # fmt: skip
            reading.take(index, index + 2)
    return found


_PLACES = {"bed": "bed", "seat": "chair", "seater": "chair", "desk": "desk", "person": "chair"}
"""What a hyphen joins to a number before a room: "6-bed", "12-seat"."""
_PLACES_AS = {"bed": "beds", "chair": "seats", "desk": "desks"}

_DORMITORIES = frozenset({"dorm_room", "hostel_dorm", "bunk_room"})
"""Rooms of which "for 8" says how many sleep there."""

_UNSEATED = frozenset(
    """
    bedroom storage garage parking bike_storage bathroom toilet cloakroom apparatus_bay dorm_room hostel_dorm
    bunk_room hotel_room archive warehouse apartment holding_cell gym spinning_room yoga_studio sports_hall
    climbing_room dance_studio indoor_pool sauna changing_room shower_area
    """.split()
)
