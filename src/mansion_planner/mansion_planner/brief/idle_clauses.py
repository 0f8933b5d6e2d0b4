"""Find the clauses of a brief in which no part of a building is named and nothing is wished for."""

from collections.abc import Iterator

from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.idle_words import is_idle_word
from mansion_planner.brief.persons import COLLECTIVES, PRONOUNS, ROBOTS, is_person
from mansion_planner.brief.qualifiers import is_property
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.sizes import is_size

__all__ = ["WISHES", "idle_clauses", "says_how"]

_MARKS = frozenset({",", ":", "(", ")", "–", "—", "-", "/"})
_OPENERS = frozenset("so because since where which who that while although though when whenever if but as".split())
"""Conjunctions and relative pronouns, with which another clause begins."""
_SUBJECTS = PRONOUNS | ROBOTS | COLLECTIVES | {"it", "this", "that", "these", "those"}
_OWNERS = frozenset({"our", "my", "their", "his", "her", "your"})
_VERBS = frozenset("is are was were be been being am has have had do does did will can could may might".split())
WISHES = frozenset(
    """
    want need must should shall would like love prefer wish please hope require expect ask get give make add put include
    no not without never none nothing there only with let ought necessary needed wanted required mandatory
    """.split()
)
"""Words with which something is asked for, or refused."""
_WISHING = frozenset("want need would should must wish".split())
_WHERE = frozenset(
    """
    above below beneath underneath under behind beside next near opposite surrounded share sharing overlooking
    facing face overlook between identical except unless half front back side middle centre center around same
    different window door wall roof ceiling garden courtyard light daylight view entrance
    """.split()
)
"""Words that place something, and parts of a building that are neither rooms nor furniture."""
_OPENING = 2
"""Sentences at the head of a brief that may tell which kind of building is meant."""
_OF_A_BUILDING = frozenset({"it", "this", "that", "these", "those", "house", "building", "everything", "all"})


def idle_clauses(reading: Reading) -> Iterator[int]:
    """Yield the tokens of the clauses that ask for nothing: "we shoot mostly at night", "members are fit".

    Such a clause has a subject and a verb, nothing was read in it, and none of its words names a part of a building or
    says how one is to be. A list of nouns is none: it may ask for things that are not known.
    """
    for first, last in _clauses(reading):
        if _is_idle(reading, first, last):
            yield from range(first, last)


def _clauses(reading: Reading) -> Iterator[tuple[int, int]]:
    first = 0
    for index in range(len(reading.tokens) + 1):
        word = reading.word(index)
        ends = index == len(reading.tokens) or reading.breaks(index) or word in _MARKS
        opens = word in _OPENERS or (
            word in ("and", "or") and reading.word(index + 1) in _SUBJECTS | _OWNERS | _WISHING
        )
        if ends or opens:
            if index > first:
                yield first, index
            first = index + 1 if ends else index


def _is_idle(reading: Reading, first: int, last: int) -> bool:
    words = reading.words(first, last)
    if any(at in reading.taken and not is_person(reading.word(at)) for at in range(first, last)) or any(
        reading.kind(at) != "word" for at in range(first, last)
    ):
        return False
    if not (WISHES | _WHERE | FLOOR_WORDS).isdisjoint(words) or any(map(says_how, words)):
        return False
    told = reading.facts.building or reading.facts.building_span
    opens = reading.sentence[first] < _OPENING
    owner = words[0] in _OWNERS and not any(map(is_person, words[1:3]))
    if opens and (owner or not (told or words[0] in ("i", "we"))):
        return False  # "our pavilion burnt down" may be all that says which kind of building is meant
    named = any(m.room or m.building for m in reading.mentions if first <= m.first < last)
    if named or any(furniture_of((word,))[0] for word in words):
        return False
    return _tells(words)


def says_how(word: str) -> bool:
    """Whether a word says how something is to be, in a way that could be looked up."""
    return is_property(word) or is_size(word)


def _tells(words: tuple[str, ...]) -> bool:
    """Whether the words of a clause are a subject with a verb, and not what the building itself has."""
    opened = words[1:] if words[0] in _OPENERS | {"and", "or"} else words
    plain = [word for word in opened if word not in ("the", "a", "an")]
    if len(plain) < 2:
        return False
    about_building = plain[0] in _OF_A_BUILDING and not {"has", "have", "had"}.isdisjoint(plain)
    subject = plain[0] in _SUBJECTS | _OWNERS or is_person(plain[0])
    verb = not _VERBS.isdisjoint(plain[1:]) or any(map(is_idle_word, plain[1:]))
    return not about_building and (subject or verb)
