"""Read what stands below another use: "a museum and a shop under a block of flats"."""

from mansion_planner.brief.facts import FloorRef, RoomFact, UseFact
from mansion_planner.brief.lexicon import Mention
from mansion_planner.brief.reading import Reading

__all__ = ["read_stacking"]

_UNDER = frozenset({"under", "below", "beneath", "underneath"})
_UPPER = frozenset({"apartment_building", "flat", "office", "hotel", "student_dormitory"})
_BETWEEN = frozenset({"a", "an", "the", "and", "small", "large", "big", "new"})


def read_stacking(reading: Reading) -> None:
    """Give the ground floor to the uses named before "under" and the storeys above to the one after it.

    A phrase that may be a room ("a shop") becomes a room of the ground floor where another one gives it its use.
    """
    for index in range(1, len(reading.tokens)):
        if reading.word(index) not in _UNDER or index in reading.taken:
            continue
        above = _mention_after(reading, index + 1)
        below = _mentions_before(reading, index)
        if above is None or not below:
            continue
        ground = (FloorRef("number", 1, 1, reading.span(below[0].first, below[-1].last)),)
        upper = (FloorRef("upper", 0, 0, reading.span(above.first, above.last)),)
        name = "apartment_building" if above.building == "flat" else above.building
        reading.facts.uses.append(UseFact(name, upper, reading.span(above.first, above.last), count=1))
        for mention in below:
            span = reading.span(mention.first, mention.last)
            if mention.room:
                room = RoomFact(mention.room, mention.room, span, None if mention.plural else 1, floors=ground)
                reading.facts.rooms.append(room)
            else:
                reading.facts.uses.append(UseFact(mention.building, ground, span))
        reading.take(below[0].first, above.last)


def _mention_after(reading: Reading, index: int) -> Mention | None:
    while reading.word(index) in _BETWEEN:
        index += 1
    mention = reading.mention_at.get(index)
    return mention if mention is not None and mention.building in _UPPER else None


def _mentions_before(reading: Reading, index: int) -> list[Mention]:
    """Return the joined phrases that end at a token, from left to right; all of them name a building."""
    found: list[Mention] = []
    while index > 0:
        mention = reading.mention_ending.get(index)
        if mention is None or not mention.building or "parking" in mention.building:
            break
        found.insert(0, mention)
        index = mention.first
        while index > 0 and reading.word(index - 1) in _BETWEEN | {","}:
            index -= 1
    return found
