"""Tell noun phrases that name what stands elsewhere: the station nine minutes away, the church that is converted."""

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["is_elsewhere"]

_AWAY = frozenset({"minute", "km", "kilometre", "mile", "walk", "drive", "hour"})
"""How far something is from the building."""
_FROM = frozenset({"from", "to", "of"})
_ARTICLES = frozenset({"a", "an", "the", "our", "my", "its"})
_MARKS = frozenset({":", ".", ",", ";", "(", "-", "\n", ""})
_WHOLES = frozenset({"house", "home", "flat", "building", "place", "villa"})
_OPENING = 8
"""Tokens from the start in which the building is named with whom it is for."""
_STATES = frozenset({"emergency", "accident", "fire"})
"""What a room is kept for, and no room itself: "stays open for emergencies"."""

_OUTSIDE = frozenset({("outside",), ("outdoors",), ("in", "front"), ("at", "front"), ("out", "front")})
_OUTDOOR = frozenset({"outdoor", "outside", "surface"})
"""What stands behind and before parking that is no room."""


def is_elsewhere(reading: Reading, phrases: list[Phrase], number: int) -> bool:
    """Whether a phrase names no part of the building, but what is around it, whom it is for or what it was."""
    phrase = phrases[number]
    if phrase.name in _STATES and reading.word(phrase.first - 1) in ("for", "in", "of") and not phrase.counted:
        return True
    if number > 0 and _is_parking_outside(reading, phrase):
        return True
    if number == 1 and not phrase.counted and _is_client(reading, phrases):
        return True
    if not (phrase.building or phrase.room_type) or phrase.counted or phrase.plural:
        return False
    return (
        (bool(phrase.building) and _is_away(reading, phrase))
        or (number > 0 and _is_predicate(reading, phrase))
        or _is_seen(reading, phrases, phrase)
        or (number == 1 and _is_shell(reading, phrases))
        or (number > 0 and bool(phrase.building) and _has_the_floor(reading, phrase))
    )


def _is_parking_outside(reading: Reading, phrase: Phrase) -> bool:
    """Whether cars are left before the building, where every plot has places for them: "parking outside"."""
    words = reading.words(phrase.begin, phrase.last)
    told_of = reading.word(phrase.last) in ("is", "are")  # "outside parking is not part of it" refuses it
    if told_of or ("parking" not in words and words[-2:] != ("car", "park")):
        return False
    behind = reading.words(phrase.last, phrase.last + 2)
    return (
        behind[:1] in _OUTSIDE
        or behind in _OUTSIDE
        or not _OUTDOOR.isdisjoint((*words, reading.word(phrase.begin - 1)))
    )


def _before(reading: Reading, phrase: Phrase) -> int:
    """Return the token before a phrase and its article."""
    return phrase.begin - 1 - (reading.word(phrase.begin - 1) in _ARTICLES)


def _is_away(reading: Reading, phrase: Phrase) -> bool:
    """Whether "nine minutes from" or "a short walk to" leads to a building."""
    lead = _before(reading, phrase)
    return reading.word(lead) in _FROM and not _AWAY.isdisjoint(reading.words(max(lead - 3, 0), lead))


def _is_predicate(reading: Reading, phrase: Phrase) -> bool:
    """Whether the whole is only called something once more: "this is a home that photographs well"."""
    lead = reading.words(phrase.begin - 3, phrase.begin)
    said = lead in (("this", "is", "a"), ("this", "is", "an"), ("it", "is", "a"), ("it", "is", "an"))
    return said and bool(phrase.building) and reading.word(phrase.last) in ("that", "which", "where")


def _is_seen(reading: Reading, phrases: list[Phrase], phrase: Phrase) -> bool:
    """Whether another room only looks out on a hall that is named nowhere else: "with a view over the hall"."""
    lead = reading.words(phrase.begin - 3, phrase.begin)
    seen = lead[-1:] == ("the",) and ("view" in lead or "overlooking" in lead)
    return seen and not any(p is not phrase and phrase.name in p.name for p in phrases)


def _is_client(reading: Reading, phrases: list[Phrase]) -> bool:
    """Whether the second phrase is whom the building is for: "office for a law chambers", "for an animation studio"."""
    whole, client = phrases[0], phrases[1]
    bare = bool(whole.building) and reading.word(client.begin - 1) == "for" and client.noun_end - client.begin == 1
    led = reading.word(_before(reading, client)) == "for" and (bare or reading.word(client.begin - 1) in ("a", "an"))
    opens = client.first <= _OPENING and whole.last == _before(reading, client)
    plain = reading.word(whole.noun_end - 1) in _WHOLES
    return led and opens and not plain and reading.word(client.last) in _MARKS


def _is_shell(reading: Reading, phrases: list[Phrase]) -> bool:
    """Whether the second phrase is the building that the first is made in: "coworking in a church. ..."."""
    whole, shell = phrases[0], phrases[1]
    led = reading.words(whole.last, shell.begin) in (("in", "a"), ("in", "an"), ("inside", "a"), ("inside", "an"))
    return led and bool(shell.building) and whole.begin <= 2 and reading.word(shell.last) in _MARKS


def _has_the_floor(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase is the building in which the plan takes a storey: "second floor of a shopping arcade"."""
    lead = _before(reading, phrase)
    opens = any(reading.starts(at) for at in range(max(lead - 4, 0), lead))
    return (
        opens
        and reading.word(lead) == "of"
        and reading.word(lead - 1) in FLOOR_WORDS
        and not reading.plural(lead - 1)
        and reading.word(phrase.begin - 1) in ("a", "an")
    )
