"""Read what stands below another use: "a museum and a shop under a block of flats"."""

from mansion_planner.brief.facts import FloorRef, RoomFact, UseFact
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["read_stacking"]

_UNDER = frozenset({"under", "below", "beneath", "underneath"})
_UPPER = frozenset({"apartment_building", "flat", "office", "hotel", "student_dormitory", "residential_building"})
_JOINTS = frozenset(
    """
    a an the and , small large big new
    """.split()
)


def read_stacking(reading: Reading, phrases: list[Phrase]) -> set[int]:
    """Give the ground floor to what is named before "under" and the storeys above to the use after it.

    Returns
    -------
    set of int
        Numbers of the phrases that this reads; a phrase that may be a room becomes a room of the ground floor.
    """
    used: set[int] = set()
    for number, above in enumerate(phrases):
        link = above.first - 1
        if number == 0 or above.building not in _UPPER or reading.word(link) not in _UNDER or link in reading.taken:
            continue
        below = [number - 1]
        while below[0] > 0 and set(reading.words(phrases[below[0] - 1].last, phrases[below[0]].first)) <= _JOINTS:
            below.insert(0, below[0] - 1)
        if (
            any(not phrases[n].building or "parking" in phrases[n].building for n in below)
            or phrases[number - 1].last != link
        ):
            continue
        reading.take(link, link + 1)
        used |= {number, *below}
        span = reading.span(above.first, above.last)
        name = "apartment_building" if above.building == "flat" else above.building
        reading.facts.uses.append(UseFact(name, (FloorRef("upper", span=span),), span, count=1))
        for entry in (phrases[n] for n in below):
            words = reading.span(entry.first, entry.last)
            ground = (FloorRef("number", 1, 1, words),)
            if entry.head == "room":
                count = None if entry.plural else 1
                reading.facts.rooms.append(
                    RoomFact(entry.room_type, entry.name, words, count, floors=ground, label=entry.label)
                )
            else:
                reading.facts.uses.append(UseFact(entry.building, ground, words))
    return used
