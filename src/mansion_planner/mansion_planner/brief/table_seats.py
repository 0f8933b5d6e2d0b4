"""Read how many people sit at tables: "20 tables for four persons each", "a table for eight"."""

from collections.abc import Sequence

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["end_of_seats", "seats_at_tables"]

_TABLES = frozenset({"dining_table", "cafe_table", "cafeteria_table", "restaurant_table", "conference_table"})
_SEATS = frozenset({"chair", "dining_chair", "stool", "bar_stool", "bench", "armchair"})
_AT_A_TABLE = 20
"""People who sit at one table at most."""


def seats_at_tables(reading: Reading, phrases: list[Phrase], number: int) -> int:
    """Return how many people sit at some tables: 80 at "20 tables for 4 persons each"; 0 where the brief does not say.

    More than a table seats are those of all tables, where nothing says "each".
    """
    table = phrases[number]
    bare = _bare_number(reading, table)
    if bare:
        return int(reading.value(bare)) * ((table.count or 1) if table.counted else 1)
    people = phrases[number + 1] if number + 1 < len(phrases) else None
    if table.category not in _TABLES or people is None or people.head != "people" or not people.counted:
        return 0
    sentence = reading.sentence[table.first]
    if any(phrase.category in _SEATS and reading.sentence[phrase.first] == sentence for phrase in phrases):
        return 0  # "a table for twelve people and 12 chairs"
    if not table.counted and table.plural:
        return 0
    if reading.words(table.last, people.first) not in (("for",), ("of",), ("each", "for"), (",", "each", "for")):
        return 0
    around = {reading.word(people.last), reading.word(table.last), reading.word(table.last + 1)}
    each = not around.isdisjoint({"each", "apiece"})
    many = people.count or 0
    if not each and many > _AT_A_TABLE:
        return many
    return many * ((table.count or 1) if table.counted else 1)


def end_of_seats(reading: Reading, phrases: Sequence[Phrase], number: int) -> int:
    """Return the token after the words that say how many people sit at some tables, where they do."""
    bare = _bare_number(reading, phrases[number])
    return bare + 1 if bare else phrases[number + 1].last


def _bare_number(reading: Reading, table: Phrase) -> int:
    """Return the token of "eight" in "a table for eight", after which no noun comes; or 0."""
    at = table.last + 1
    single = table.category in _TABLES and (table.counted or not table.plural)
    told = reading.word(table.last) == "for" and reading.kind(at) == "number" and 1 < reading.value(at) <= _AT_A_TABLE
    closes = reading.breaks(at + 1) or reading.word(at + 1) in (",", "and", ")", "in", "by", "with")
    return at if single and told and closes else 0
