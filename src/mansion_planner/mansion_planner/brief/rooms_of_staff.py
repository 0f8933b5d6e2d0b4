"""Read the rooms of staff whom a list names in their place: "head teacher, sick bay", "ten offices plus the dean"."""

from dataclasses import replace

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.similarity import elliptic_room_type

__all__ = ["OFFICE_HOLDERS", "with_rooms_of_staff"]

_HAVE_ROOMS = frozenset("staff teacher nurse doctor consultant priest judge officer technician".split())
"""Who has a room of their own in a building."""
_BESIDE = frozenset({"beside", "adjoining", "alongside"})
_NEAR = 4
"""Words that may stand between a room and the comma after it: "an open office for 24 officers"."""
_THE_ONE = frozenset({"", "the", "a", "an", "her", "his", "its", "their", "our", "one"})
OFFICE_HOLDERS = frozenset(
    """
    director manager dean principal headmaster headmistress headteacher rector registrar bursar secretary assistant
    treasurer president chairman chairwoman mayor editor ceo boss receptionist caretaker warden janitor
    accountant clerk deputy bookkeeper curator commander captain chief sergeant
    """.split()
)
"""Who has an office of their own where a list of rooms adds them: "ten offices plus the dean"."""


def with_rooms_of_staff(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return the phrases with the rooms of staff, and of those whom "the director and her assistant" joins to them."""
    found: list[Phrase] = []
    for phrase in sorted(phrases, key=lambda phrase: phrase.first):
        around = [*found, *(p for p in phrases if p.first > phrase.first)]
        found.append(_room_of_staff(reading, around, phrase))
    named = {phrase.name for phrase, old in zip(found, sorted(phrases, key=lambda p: p.first)) if phrase is not old}
    return [
        replace(p, head="room", room_type="private_office", known=False)
        if p.head == "people" and p.determiner == "the" and p.name in named
        else p
        for p in found
    ]


def _is_amid(rooms: list[Phrase], last: int) -> bool:
    """Whether a room ends shortly before token `last`."""
    return any(0 <= last - room.last <= _NEAR for room in rooms)


def _room_of_staff(reading: Reading, phrases: list[Phrase], phrase: Phrase) -> Phrase:
    """Return the room of those whom a list of rooms names in its place: "head teacher, sick bay, plus the dean"."""
    one = phrase.determiner in _THE_ONE and phrase.count in (None, 1) and not phrase.plural
    alone = phrase.head == "people" and one and (not phrase.counted or phrase.determiner == "one")
    word = reading.word(phrase.noun_end - 1)
    if not alone or word not in _HAVE_ROOMS | OFFICE_HOLDERS:
        return phrase
    lead = phrase.begin - 1
    lead -= reading.word(lead) in _THE_ONE
    before, after = reading.word(lead), reading.word(phrase.last)
    sentence = reading.sentence[phrase.first]
    closed = after in (",", ";", ".", "\n", "", ")") or (after in ("and", "plus", "+", "&") and before != ":")
    rooms = [p for p in phrases if p.head == "room" or (p.head == "building" and p.counted and p.room_type)]
    joined = before in ("and", "&") and any(p.last == lead for p in rooms)
    beside = reading.word(phrase.begin - 1) == "the" and reading.words(lead - 1, lead + 1) == ("next", "to")
    beside = (beside or (before in _BESIDE and phrase.determiner == "the")) and not any(
        room.name.startswith(f"{word}_") for room in rooms
    )
    added = beside or before in ("plus", "+", "additionally", "furthermore", "likewise") or joined
    plain = not phrase.determiner and word in _HAVE_ROOMS
    ends = after in (",", ";", ".", "and", "&", "+")
    amid = before == "," and ends and not phrase.determiner and _is_amid(rooms, lead)  # "an office, commander, armoury"
    headed = word in OFFICE_HOLDERS and before in FLOOR_WORDS | {":"} and after == "," and not phrase.determiner
    listed = closed and (added or amid or headed or (plain and before in (",", ":", ";")))
    if not listed or not any(abs(reading.sentence[p.first] - sentence) <= 1 for p in rooms):
        return phrase
    kind = elliptic_room_type(reading.words(phrase.begin, phrase.noun_end), reading.knowledge)
    return replace(phrase, head="room", room_type=kind or "private_office", known=bool(kind))
