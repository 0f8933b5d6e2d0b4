"""Find groups of rooms that a brief has several alike of: "three households called Rose, Oak and Lake", "six wards".

A group is no room by itself: what each of them holds is said of it, as of a flat.
"""

from dataclasses import replace

from mansion_planner.brief.facts import RoomFact
from mansion_planner.brief.own_names import capitals
from mansion_planner.brief.phrase import Phrase, finished_phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.room_users import one_of

__all__ = ["groups_of_rooms", "named_again", "with_room_of_group"]

_NOUNS = frozenset(
    {"household", "group", "department", "practice", "section", "wing", "pod", "team", "unit", "family", "station"}
)
_SHARING = frozenset({"each", "every", "per"})
_PARTS = frozenset({"with", "has", "have", "contain", "comprise", "get", ":", "consist", "include", "of", "having"})
"""Words that lead from a group to its rooms."""
_REACH = 14
"""Tokens between a group and the "each" that shares out its rooms, at most."""


def groups_of_rooms(reading: Reading, phrases: list[Phrase]) -> list[list[Phrase]]:
    """Return the groups, several phrases for those that have names of their own."""
    found = []
    for index in range(1, len(reading.tokens)):
        if reading.word(index) not in _NOUNS or not reading.plural(index):
            continue
        begin = index - (reading.kind(index - 1) == "word" and reading.kind(index - 2) == "number")
        count = int(reading.value(begin - 1)) if reading.kind(begin - 1) == "number" else 0
        if not 2 <= count <= 40 or _is_part_of_another(phrases, index) or not _holds_rooms(reading, begin, index):
            continue
        found.append(_named_apart(reading, begin, index, count))
    return found


def _is_part_of_another(phrases: list[Phrase], index: int) -> bool:
    """Whether the noun belongs to a phrase that names something known: "three family rooms", "three office units"."""
    return any(p.begin <= index < p.noun_end and p.head == "room" and p.known and p.room_type for p in phrases)


def _holds_rooms(reading: Reading, begin: int, index: int) -> bool:
    """Whether the brief says what each of the groups holds; "three groups of twelve" hold people."""
    noun = reading.word(index)
    again = any(
        reading.word(at) in _SHARING and reading.word(at + 1) == noun and not reading.plural(at + 1)
        for at in range(len(reading.tokens) - 1)
    )
    near = range(index + 1, min(index + _REACH, len(reading.tokens)))
    same = [at for at in near if reading.sentence[at] == reading.sentence[index]]
    shared = any(reading.word(at) in ("each", "every") and _leads_on(reading, index, at) for at in same)
    return again or (shared and reading.word(begin - 2) not in ("in", "into", "for"))


def _leads_on(reading: Reading, index: int, each: int) -> bool:
    """Whether "each with" follows a group, or "with eight bedrooms each"."""
    if reading.word(each + 1) in _PARTS:
        return True
    return any(reading.word(at) in ("with", "of") for at in range(index + 1, each))


def _named_apart(reading: Reading, begin: int, index: int, count: int) -> list[Phrase]:
    """Return one phrase for the groups, or one for each of their names: "called Rose, Oak and Lake"."""
    taken = set(reading.taken)
    reading.taken.difference_update(range(begin - 1, index + 1))
    whole = finished_phrase(reading, "room", begin, index + 1, room="common_room", known=False)
    reading.taken |= taken
    lead = index + 1 + (reading.word(index + 1) in ("are", ","))
    called = reading.word(lead) in ("called", "named") or reading.word(lead) in ("(", ":")
    names = capitals(reading, lead + 1) if called else []
    if len(names) != count:
        return [whole]
    end = names[-1][1] + (reading.word(lead) == "(" and reading.word(names[-1][1]) == ")")
    reading.take(lead, end)
    rooms = []
    for first, last in names:
        own = reading.span(first, last).words
        name = "_".join(reading.words(first, last))
        room = replace(whole, name=f"{name}_{whole.name}"[:60], label=f"{own} {whole.name}")
        rooms.append(one_of(room, first, last))
    rooms[0] = replace(rooms[0], first=whole.first)
    rooms[-1] = replace(rooms[-1], last=end)
    return rooms


def named_again(reading: Reading, group: list[Phrase]) -> list[Phrase]:
    """Return the later mentions of groups by their own names alone: "Rose and Oak are downstairs"."""
    found = []
    for room in group if len(group) > 1 else []:
        words = reading.words(room.begin, room.noun_end)
        for index in range(group[-1].last, len(reading.tokens) - len(words) + 1):
            end = index + len(words)
            if reading.words(index, end) == words and reading.tokens[index].capital and reading.free(index, end):
                found.append(
                    replace(room, first=index, begin=index, noun_end=end, last=end, counted=False, determiner="the")
                )
    return found


_MAIN_ROOMS = frozenset({"playroom", "kindergarten_classroom"})
"""Rooms in which a group spends its day: it has no other room beside them."""


def with_room_of_group(fact: RoomFact) -> RoomFact:
    """Return the rooms of groups that are told by the one in which they play, what else each has beside that one."""
    own = [room for room in fact.suite if room.room_type in _MAIN_ROOMS]
    if fact.known or fact.room_type != "common_room" or len(own) != 1 or own[0].count != 1:
        return fact
    beside = tuple(room for room in fact.suite if room is not own[0])
    return replace(own[0], count=fact.count, floors=fact.floors, each=fact.each, exact=fact.exact, suite=beside)
