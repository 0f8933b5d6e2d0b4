"""Read where all rooms are but some: "everything on the ground floor except the bedrooms, which are upstairs".

Those that an earlier sentence puts elsewhere are excepted too: "Bedrooms upstairs, all else downstairs".
"""

from dataclasses import dataclass, replace

from mansion_knowledge import is_class
from mansion_planner.brief.facts import FloorRef, Span
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading

__all__ = ["AllButSome", "place_all_others", "place_some", "read_all_but_some"]

_ALL = frozenset({"everything", "all"})
_OTHERS = frozenset({"else", "other", "rest", "others", "remaining", "remainder"})
"""Words that mean the rooms of which nothing was said."""
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
    """That all rooms are on the ground floor, or on the upper one, but those after token `last`, or told elsewhere."""

    others: FloorRef
    some: FloorRef | None
    first: int
    last: int
    span: Span


def read_all_but_some(reading: Reading) -> AllButSome | None:
    """Take the words that put all rooms but some on a storey, before the storeys of the brief are read."""
    for index in range(len(reading.tokens)):
        rest = reading.word(index) in _OTHERS and reading.word(index - 1) == "the"
        first = index - rest
        opens = reading.starts(first) or reading.word(first - 1) in (",", ":", "with", "and", ";")
        if not (rest or reading.word(index) in _ALL) or not opens:
            continue
        at = index + 1
        while reading.word(at) in _BETWEEN and at - index < _REACH:
            rest = rest or reading.word(at) in _OTHERS
            at += 1
        storey = _PLACES.get(reading.word(at), 0)
        at += 1 + (storey > 0 and reading.word(at + 1) in FLOOR_WORDS)
        at += reading.word(at) == ","
        words = next((words for words in _EXCEPT if reading.words(at, at + len(words)) == words), ())
        ends = rest and (reading.breaks(at) or at >= len(reading.tokens))
        if not storey or not (words or ends) or index in reading.taken:
            continue
        last = at + len(words)
        span = reading.span(first, last)
        reading.take(first, last)
        ground, upper = FloorRef("number", 1, 1, span), FloorRef("upper", span=span)
        others, some = (ground, upper) if storey == 1 else (upper, ground)
        return AllButSome(others, some if words else None, first, last, span)
    return None


def place_some(reading: Reading, places: list[Place], found: AllButSome | None) -> None:
    """Put what follows the exception on the other storey, where its sentence does not say itself where it is."""
    if found is None or found.some is None:
        return
    sentence = reading.sentence[found.first]
    if not any(reading.sentence[place.first] == sentence and place.first >= found.last for place in places):
        places.append(Place(found.last, found.last, (found.some,), led=False, heading=True))
        places.sort(key=lambda place: place.first)


def place_all_others(reading: Reading, found: AllButSome | None) -> None:
    """Put the rooms whose storey is not said where all but some are, and state that the other has the rest alone."""
    if found is None:
        return
    facts, upstairs = reading.facts, found.others.kind == "upper"
    entrances = {room.name for room in facts.rooms if is_class(room.room_type, "circulation")} if upstairs else set()
    facts.rooms[:] = [
        room if room.floors or room.name in entrances else replace(room, floors=(found.others,)) for room in facts.rooms
    ]
    if found.some is not None and found.some.kind == "upper":
        facts.only_on.append((found.span, (found.some,)))
