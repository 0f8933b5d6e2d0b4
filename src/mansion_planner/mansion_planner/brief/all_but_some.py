"""Read where all rooms are but some: "everything on the ground floor except the bedrooms, which are upstairs"."""

from dataclasses import dataclass, replace

from mansion_planner.brief.facts import FloorRef, Span
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading

__all__ = ["AllButSome", "place_all_others", "place_some", "read_all_but_some"]

_ALL = frozenset({"everything", "all"})
_BETWEEN = frozenset("the rooms room other else should must be is are goes go to on in at lies stays".split())
_EXCEPT = (
    ("except", "for"),
    ("except",),
    ("apart", "from"),
    ("but", "for"),
    ("other", "than"),
    ("save", "for"),
    ("bar",),
)
_PLACES = {"downstairs": 1, "downstair": 1, "ground": 1, "upstairs": 2, "upstair": 2}
_REACH = 9


@dataclass(frozen=True)
class AllButSome:
    """That all rooms are on the ground floor, or on the upper one, but those after token `last`."""

    others: FloorRef
    some: FloorRef
    first: int
    last: int
    span: Span


def read_all_but_some(reading: Reading) -> AllButSome | None:
    """Take the words that put all rooms but some on a storey, before the storeys of the brief are read."""
    for index in range(len(reading.tokens)):
        if reading.word(index) not in _ALL or not (
            reading.starts(index) or reading.word(index - 1) in (",", ":", "with")
        ):
            continue
        at = index + 1
        while reading.word(at) in _BETWEEN and at - index < _REACH:
            at += 1
        storey = _PLACES.get(reading.word(at), 0)
        at += 1 + (storey > 0 and reading.word(at + 1) in FLOOR_WORDS)
        at += reading.word(at) == ","
        words = next((words for words in _EXCEPT if reading.words(at, at + len(words)) == words), ())
        if not storey or not words or index in reading.taken:
            continue
        last = at + len(words)
        span = reading.span(index, last)
        reading.take(index, last)
        ground, upper = FloorRef("number", 1, 1, span), FloorRef("upper", span=span)
        others, some = (ground, upper) if storey == 1 else (upper, ground)
        return AllButSome(others, some, index, last, span)
    return None


def place_some(reading: Reading, places: list[Place], found: AllButSome | None) -> None:
    """Put what follows the exception on the other storey, where its sentence does not say itself where it is."""
    if found is None:
        return
    sentence = reading.sentence[found.first]
    if not any(reading.sentence[place.first] == sentence and place.first >= found.last for place in places):
        places.append(Place(found.last, found.last, (found.some,), led=False, heading=True))
        places.sort(key=lambda place: place.first)


def place_all_others(reading: Reading, found: AllButSome | None) -> None:
    """Put the rooms whose storey is not said where all but some are, and state that the other has the rest alone."""
    if found is None:
        return
    facts = reading.facts
    facts.rooms[:] = [room if room.floors else replace(room, floors=(found.others,)) for room in facts.rooms]
    if found.some.kind == "upper":
        facts.only_on.append((found.span, (found.some,)))
