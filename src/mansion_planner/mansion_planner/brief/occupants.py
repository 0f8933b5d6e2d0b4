"""Read for how many people a building is: "a family of four", "for twelve guests"."""

from collections.abc import Mapping

from mansion_planner.brief.area_words import after_area
from mansion_planner.brief.facts import OccupantFact
from mansion_planner.brief.furnishings import people_served
from mansion_planner.brief.persons import COLLECTIVES
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.storey_attachment import Attachment
from mansion_planner.brief.table_seats import seats_at_tables

__all__ = ["read_occupants", "tell_users"]

_PAIR = 2
"""Users that any room has place for."""


def read_occupants(
    reading: Reading, phrases: list[Phrase], building: int | None, attached: Mapping[int, Attachment]
) -> None:
    """State how many people the building is for, where these are no users of one of its rooms.

    Parameters
    ----------
    building : int, optional
        Number of the phrase that names the building itself.
    attached : mapping of int to Attachment
        Storeys by phrase.
    """
    for number, phrase in enumerate(phrases):
        if phrase.head != "people":
            continue
        noun = reading.word(phrase.noun_end - 1)
        after_room = any(
            p.head == "room" and n != building and 0 <= phrase.first - after_area(reading, p.last) <= 3
            for n, p in enumerate(phrases[:number])
        )
        furnished = number and (
            people_served(reading, phrases, number - 1) or seats_at_tables(reading, phrases, number - 1)
        )
        if phrase.counted and phrase.count and not (after_room or furnished or number in attached):
            reading.facts.occupants.append(OccupantFact(phrase.count, noun, reading.span(phrase.first, phrase.last)))
    for index in range(len(reading.tokens)):
        _read_group(reading, index)


def _read_group(reading: Reading, index: int) -> None:
    """State how many people come together, where that is said at a token: "a team of twenty", "we are five"."""
    first = _group_counted(reading, index)
    if _is_for_persons(reading, index):
        count = int(min(reading.value(index), 1e6))
        reading.facts.occupants.append(OccupantFact(count, "person", reading.span(index, index + 2)))
        reading.take(index, index + 2)
    elif first >= 0:
        kin = reading.word(index - 2) in _KIN or reading.word(index - 1) in ("are", "be")
        count = int(min(reading.value(index), 1e6))
        span = reading.span(first, index + 1)
        reading.facts.occupants.append(OccupantFact(count, "family" if kin else "person", span))
        reading.take(first, index + 1)
    elif reading.word(index) == "couple" and reading.word(index + 1) != "of" and not reading.facts.occupants:
        reading.facts.occupants.append(OccupantFact(2, "family", reading.span(index, index + 1)))
        reading.take(index, index + 1)


def _is_for_persons(reading: Reading, index: int) -> bool:
    """Whether a number says for how many people a building is: "a one-person studio flat"."""
    joined = index + 1 < len(reading.tokens) and not reading.tokens[index + 1].spaced
    if not (reading.kind(index) == "number" and joined and reading.word(index + 1) == "person"):
        return False
    at = reading.tokens[index + 1].start
    return any(span.start <= at < span.end for _, span in reading.facts.building)


def _group_counted(reading: Reading, index: int) -> int:
    """Return the first token of the words for some people, whose number a token is; -1 where it is none of these."""
    if reading.kind(index) != "number" or index in reading.taken:
        return -1
    if reading.word(index - 1) == "of" and reading.word(index - 2) in _KIN | COLLECTIVES:
        return index - 2
    after = reading.word(index + 1)
    if reading.word(index - 1) in ("sleep", "sleeping") and reading.kind(index + 1) not in ("unit", "number"):
        return index - 1 if not reading.plural(index + 1) else -1
    ends = after in _AFTER or reading.breaks(index + 1)
    if ends and (reading.words(index - 2, index) == ("we", "are") or _follows_building(reading, index)):
        return index - 2 if reading.word(index - 1) == "are" else index - 1
    return -1


def _follows_building(reading: Reading, index: int) -> bool:
    """Whether a number says for whom a building is whose words end before it: "a flat for two"."""
    if reading.word(index - 1) != "for" or index < _PAIR:
        return False
    last = reading.tokens[index - 2]
    return any(span.start <= last.start and last.end == span.end for _, span in reading.facts.building)


_KIN = frozenset({"family", "household", "group"})
_AFTER = frozenset({"and", ",", ":", ";", "-", "–", "so", "people", "in", "with"})
"""Words after a number of people that is the whole of them: "we are five and need a flat"."""


def tell_users(reading: Reading, phrases: list[Phrase]) -> None:
    """Give back how many a room is for where nothing stands there for each of them: "a cell for four detainees"."""
    read = [fact.span for fact in reading.facts.objects] + [fact.span for fact in reading.facts.occupants]
    for number, phrase in enumerate(phrases[1:], 1):
        room = phrases[number - 1]
        span = reading.span(phrase.first, phrase.last)
        users = phrase.head == "people" and phrase.counted and (phrase.count or 0) > _PAIR
        if not users or room.head != "room" or reading.words(room.last, phrase.first) != ("for",):
            continue
        if not any(other.start <= span.start < other.end for other in read):
            reading.taken.difference_update(range(phrase.first, phrase.last))
