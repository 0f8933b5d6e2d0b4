"""Read rooms as advertisements of homes write them: "3 bed / 2 bath", "4BR", "three-bedroom house"."""

from collections.abc import Sequence
from dataclasses import replace

from mansion_planner.brief.facts import BriefFacts, OccupantFact, RoomFact
from mansion_planner.brief.phrase import Phrase, is_whole_count
from mansion_planner.brief.reading import Place, Reading

__all__ = ["among_adverts", "read_adverts", "read_bedrooms_of_building"]

_NEAR_START = 14
"""An advertisement has its rooms among so many tokens."""


def read_adverts(reading: Reading, places: Sequence[Place]) -> None:
    """Read "3 bed / 2 bath" and "4BR" at the start of a brief, but not as what a storey holds."""
    stated = {reading.sentence[place.first]: place.first for place in reversed(places)}
    for index in range(min(len(reading.tokens) - 1, _NEAR_START)):
        word = reading.word(index + 1)
        if reading.kind(index) != "number" or index in reading.taken or reading.plural(index + 2):
            continue
        if stated.get(reading.sentence[index], index) < index:
            continue
        if reading.word(index) in _SIZES_OF_BEDS and word == "bed":
            continue  # a piece of furniture
        if word == "bed" and _counts_guests(reading, index):
            continue
        one_more = reading.word(index - 1) in ("a", "an") and reading.word(index - 2) in ("and", ",", "plus")
        if reading.word(index + 2) == "flat" and (one_more or reading.kind(index - 1) == "number"):
            continue  # "two 2BR flats"
        singular = not reading.plural(index + 1)
        several = reading.value(index) > 1 or index + 2 in reading.mention_at
        beds = word == "bed" and (several if singular else _lists_baths(reading, index + 2))
        if word in ("br", "bhk") or beds:
            _state(reading, "bedroom", index)
        elif word in ("bath", "ba", "bathroom") and singular and _follows_bedrooms(reading, index):
            _state(reading, "bathroom", index)


_FOR_MANY = frozenset({"ward", "unit", "hospice", "shelter", "dormitory", "infirmary", "clinic"})
"""Nouns of houses with many beds, whose kind of building may not be known."""


def _counts_guests(reading: Reading, index: int) -> bool:
    """Read "a 40-bed hospital" as one for 40 patients, who have no bedroom each; whether it was so."""
    joined = not reading.tokens[index + 1].spaced and not reading.plural(index + 1)
    mention = next((m for at in (index + 2, index + 3) if (m := reading.mention_at.get(at)) and m.building), None)
    record = reading.knowledge.buildings.get(mention.building) if mention is not None else None
    nouns = set(reading.words(index + 2, index + 4))
    if not joined or not (nouns & _FOR_MANY or (record is not None and record.family not in ("home", ""))):
        return False
    ill = record is None or record.family == "health"
    span = reading.span(index, index + 2)
    reading.facts.occupants.append(OccupantFact(int(reading.value(index)), "patient" if ill else "guest", span))
    reading.take(index, index + 2)
    return True


_SIZES_OF_BEDS = frozenset({"single", "double", "twin", "triple"})


def read_bedrooms_of_building(reading: Reading, phrase: Phrase) -> None:
    """Read "three-bedroom" before the building's name."""
    for index in range(max(phrase.begin - 6, 0), phrase.noun_end - 1):
        if (
            reading.kind(index) == "number"
            and reading.word(index + 1) in ("bedroom", "bed", "br")
            and not reading.tokens[index + 1].spaced
            and all(fact.span.start != reading.tokens[index].start for fact in reading.facts.occupants)
        ) and reading.sentence[index] == reading.sentence[phrase.begin]:
            _state(reading, "bedroom", index, inside=True)


def _lists_baths(reading: Reading, index: int) -> bool:
    """Whether "2 baths" stands right after "3 beds", which are bedrooms then."""
    index += reading.word(index) in ("/", ",", "+", "and", "&")
    return reading.kind(index) == "number" and reading.word(index + 1) in ("bath", "ba", "bathroom")


def _follows_bedrooms(reading: Reading, index: int) -> bool:
    """Whether "2 bath" stands right after "3 bed"."""
    before = index - 1 - (reading.word(index - 1) in ("/", ",", "+", "and", "&"))
    return reading.word(before) in ("bed", "br", "bedroom", "bhk") and not (
        reading.word(before) == "bedroom" and reading.word(before - 2) == ":"
    )


def _state(reading: Reading, room_type: str, first: int, *, inside: bool = False) -> None:
    last = first + 2
    span = reading.span(first, last)
    if not is_whole_count(reading.value(first)):
        return
    if (not inside and not reading.free(first, last)) or any(room.span == span for room in reading.facts.rooms):
        return
    reading.facts.rooms.append(RoomFact(room_type, room_type, span, int(reading.value(first)), label=room_type))
    reading.take(first, last)


_AMONG = {
    "bedroom": frozenset({"bedroom", "master_bedroom", "childrens_room"}),
    "bathroom": frozenset({"bathroom", "ensuite_bathroom"}),
}
"""Room types that an advertisement counts together."""


def among_adverts(facts: BriefFacts, adverts: Sequence[RoomFact]) -> None:
    """Count the rooms that a brief names among those that its advertisement counts.

    "A three-bedroom house with a master bedroom and two children's bedrooms" has three of them. What is left of the
    number stays as it is advertised; more rooms than advertised are kept, and the advertisement is told of.

    Parameters
    ----------
    adverts : sequence of RoomFact
        What `read_adverts` and `read_bedrooms_of_building` stated, the first of `facts.rooms`.
    """
    for advert in adverts:
        kinds = _AMONG.get(advert.room_type, frozenset())
        others = [room for room in facts.rooms if room.span != advert.span]
        rooms = [(room, 1) for room in others]
        rooms += [(inner, (room.count or 1) * _storeys(room)) for room in others for inner in room.suite]
        named = [
            (room, many) for room, many in rooms if room.room_type in kinds or room.name.endswith(f"_{advert.name}")
        ]
        if not named:
            continue
        counted = sum((room.count or 1) * _storeys(room) * many for room, many in named)
        left = (advert.count or 0) - counted
        at = next(n for n, room in enumerate(facts.rooms) if room.span == advert.span)
        open_ended = next((n for n, room in enumerate(facts.rooms) if room.count is None and (room, 1) in named), None)
        if left > 0 and open_ended is not None:
            facts.rooms[open_ended] = replace(facts.rooms[open_ended], count=1 + left)
            left = 0
        if left > 0:
            facts.rooms[at] = replace(advert, count=left)
            continue
        del facts.rooms[at]
        if left < 0:
            facts.unheeded.append(advert.span)


def _storeys(room: RoomFact) -> int:
    """Return on how many storeys so many rooms are, as far as the brief numbers them."""
    return sum(ref.last - ref.first + 1 for ref in room.floors) if room.each else 1
