"""Read groups of rooms and of places to work: "a cell block of 20 cells", "a toilet block", "30 hot desks"."""

from dataclasses import replace

from mansion_planner.brief.facts import BriefFacts, ObjectFact
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["read_desk_areas", "with_blocks"]

_GROUPS = frozenset({"block", "wing", "cluster"})
_LISTS = frozenset({"of", "with", "containing", "holding", "having", ":", "("})


def with_blocks(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return the phrases, those of blocks left out where their rooms are counted, else as several rooms.

    "Two cell blocks of ten cells each" are twenty cells, "a toilet block" is at least two toilets.
    """
    found: list[Phrase] = []
    blocks = 1
    for number, phrase in enumerate(phrases):
        if blocks > 1:
            found.append(replace(phrase, count=(phrase.count or 0) * blocks))
            reading.take(phrase.last, phrase.last + (reading.word(phrase.last) == "each"))
            blocks = 1
            continue
        group = phrase.last
        if phrase.head != "room" or reading.word(group) not in _GROUPS or reading.plural(phrase.noun_end - 1):
            found.append(phrase)
            continue
        reading.take(group, group + 1)
        later = phrases[number + 1 :]
        counted = [
            p for p in later if _counts_rooms_of(p, phrase) and reading.sentence[p.first] == reading.sentence[group]
        ]
        if counted:  # also of "one cell block with two levels: 15 cells per level"
            linked = reading.word(group + 1) in _LISTS and counted[0].first == group + 2 and phrase.counted
            blocks = (phrase.count or 1) if linked else 1
            continue
        found.append(replace(phrase, last=group + 1, count=None, counted=False, plural=True))
    return found


def _counts_rooms_of(phrase: Phrase, block: Phrase) -> bool:
    return phrase.head == "room" and phrase.counted and phrase.room_type == block.room_type


_PLACES = frozenset({"desk", "workstation", "workplace"})


def read_desk_areas(facts: BriefFacts) -> None:
    """Replace several rooms that are called desks by one area on each storey that is meant, and its desks."""
    for number, room in enumerate(facts.rooms):
        if room.name.rpartition("_")[2] not in _PLACES or room.count == 1:
            continue
        name = f"{room.name}_area"
        facts.rooms[number] = replace(room, name=name, label=f"{room.label} area", count=1, suite=())
        facts.objects.append(
            ObjectFact(
                words=room.span.words,
                category="desk",
                span=room.span,
                count=room.count,
                room=name,
                room_type=room.room_type,
                each=room.each,
                floors=room.floors,
                noun=room.label,
            )
        )
