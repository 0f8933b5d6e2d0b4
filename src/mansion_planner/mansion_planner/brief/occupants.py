"""Read for how many people a building is: "a family of four", "for twelve guests"."""

from collections.abc import Mapping

from mansion_planner.brief.facts import OccupantFact
from mansion_planner.brief.furnishings import people_served, seats_at_tables
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.storey_attachment import Attachment

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
            p.head == "room" and n != building and 0 <= phrase.first - p.last <= 3
            for n, p in enumerate(phrases[:number])
        )
        furnished = number and (
            people_served(reading, phrases, number - 1) or seats_at_tables(reading, phrases, number - 1)
        )
        if phrase.counted and phrase.count and not (after_room or furnished or number in attached):
            reading.facts.occupants.append(OccupantFact(phrase.count, noun, reading.span(phrase.first, phrase.last)))
    for index in range(len(reading.tokens)):
        if (
            reading.kind(index) == "number"
            and index not in reading.taken
            and reading.word(index - 1) == "of"
            and reading.word(index - 2) in ("family", "household", "group")
        ):
            reading.facts.occupants.append(
                OccupantFact(int(min(reading.value(index), 1e6)), "family", reading.span(index - 2, index + 1))
            )
            reading.take(index - 2, index + 1)
        elif reading.word(index) == "couple" and reading.word(index + 1) != "of" and not reading.facts.occupants:
            reading.facts.occupants.append(OccupantFact(2, "family", reading.span(index, index + 1)))
            reading.take(index, index + 1)


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
