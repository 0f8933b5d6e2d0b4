"""Read what is said not to be there in ways of its own: "lifts were unknown then", "no pergola", "no TV anywhere"."""

from mansion_planner.brief.phrase import FUNCTION_WORDS, Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.similarity import elliptic_room_type

__all__ = ["absence_end", "is_nowhere_wanted", "read_absent_parts", "time_end"]

_COPULAS = frozenset("is are was were be been had have has do does did could can".split())
_NEVER = frozenset({"not", "never"})
_THERE = frozenset("exist existed existing invented known available there heard built around".split())
_ABSENT = frozenset("unknown absent unheard nonexistent uninvented lacking".split())
_AFTER_ABSENT = frozenset({"of", "yet", "still"})
_TIMES = frozenset("day time era age period century year".split())
_POINTERS = frozenset({"those", "that", "these", "this", "the", "his", "her", "their"})
_ONCE = frozenset({"then", "yet", "back", "already", "anymore"})

_DENIALS = frozenset({"no", "without", "not", "nor", "neither", "any", "or", "never"})
_PARTS = frozenset(
    """
    balcony pergola porch portico annexe annex extension pond fountain moat turret tower helipad escalator travelator
    drawbridge gazebo driveway fence pavilion outbuilding dormer fire-escape ramp mezzanine lawn
    """.split()
)
"""Parts of a house and its grounds that no plan has unless a room is called so."""
_ENDS = frozenset({"", ".", ",", ";", ")", "\n", "!", "and", "or", "nor", "please", "but", "for", "at", "in", "on"})


def absence_end(reading: Reading, index: int) -> int:
    """Return where "did not exist then", "were unknown in those days" end that begin at a token; it, where not so."""
    at, denied = index, False
    while reading.word(at) in _COPULAS | _NEVER | {"yet"}:
        denied = denied or reading.word(at) in _NEVER
        at += 1
    word = reading.word(at)
    if at == index or not ((denied and word in _THERE) or (not denied and word in _ABSENT)):
        return index
    at += 1
    while reading.word(at) in _AFTER_ABSENT:
        at += 1
    return time_end(reading, at)


def time_end(reading: Reading, index: int) -> int:
    """Return where words end that begin at a token and say when: "existed in those days", "back then", "yet"."""
    at = index + (reading.word(index) in ("exist", "existed", "there", "available"))
    while reading.word(at) in _ONCE:
        at += 1
    noun = at + 2 + (reading.word(at + 2) in ("old", "same"))
    led = reading.word(at) in ("in", "at", "during", "of") and reading.word(at + 1) in _POINTERS
    return noun + 1 if led and reading.word(noun) in _TIMES else at


def read_absent_parts(reading: Reading) -> None:
    """Read "no balcony", "without porch or pergola" as of parts that the building is not to have."""
    denied = -1
    for index in range(len(reading.tokens)):
        word = reading.word(index)
        if reading.breaks(index) or word in ("but", "with", ":"):
            denied = -1
        elif word in ("no", "without", "nor", "neither") or (word == "not" and reading.word(index - 1) in _COPULAS):
            denied = index
        kind = "balcony_room" if word == "balcony" else word
        known = elliptic_room_type((word,), reading.knowledge) if word not in _PARTS else kind
        if denied < 0 or index in reading.taken or word in FUNCTION_WORDS or not known:
            continue
        if reading.word(index + 1) not in _ENDS or (word not in _PARTS and index - denied > 2):
            continue
        between = set(reading.words(denied, index)) - _DENIALS - {",", "and", "a", "an", "have", "has", "want", "need"}
        free = all(at in reading.taken for at in range(denied, index) if reading.word(at) in between)
        if free:
            first = denied if index - denied < 12 else index
            reading.facts.excluded.append((known, reading.span(first, index + 1)))
            reading.take(index, index + 1)


def is_nowhere_wanted(reading: Reading, phrase: Phrase) -> bool:
    """Whether furniture is not wanted in any room, whatever room was named before: "no TV anywhere"."""
    index = phrase.last
    while index < len(reading.tokens) and not reading.breaks(index) and reading.word(index) not in (",", ")", "("):
        if reading.words(index, index + 3) in _ANYWHERE:
            reading.take(index, index + 3)
            return True
        if reading.word(index) in ("anywhere", "whatsoever"):
            return True
        index += 1
    return False


_ANYWHERE = {("in", "any", "room"), ("in", "the", "house"), ("in", "the", "building"), ("in", "all", "room")}
