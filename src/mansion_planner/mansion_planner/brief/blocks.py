"""Read groups of rooms that are called after one of them: "a cell block of 20 cells", "a toilet block"."""

from dataclasses import replace

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["with_blocks"]

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
