"""Tell which noun phrases only speak of a room that is named elsewhere: "the kitchen", "both dormitories"."""

from collections.abc import Sequence
from dataclasses import dataclass

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.relation_rooms import Relation

__all__ = ["coreferences"]

_DEFINITE = frozenset("per the this that each every both either any these those its all".split())
_INTRODUCING = frozenset({"a", "an", "their", "my", "our", "his", "her", "your"})
"""Determiners of a room that is none of those named later: "their bedroom ... upstairs three bedrooms"."""
_GENERIC = frozenset("is has measure come get need hold contain receive comprise must should shall include".split())
"""Verbs after "a bedroom" where it stands for each of the bedrooms that are named before."""
_VERBS = frozenset({"should", "must", "is", "are", "shall", "has", "need", "face", "overlook", "adjoin", "open", "lie"})


def coreferences(
    reading: Reading, phrases: Sequence[Phrase], rooms: Sequence[int], relations: Sequence[Relation]
) -> tuple[dict[int, int], dict[int, list[int]]]:
    """Return which room each such phrase means, and the rooms that a plural one means together.

    Parameters
    ----------
    rooms : sequence of int
        Numbers of the phrases that name rooms of the building.
    relations : sequence of Relation
        What is named on the right of "next to" is as a rule a room that stands elsewhere in the brief.
    """
    same: dict[int, int] = {}
    groups: dict[int, list[int]] = {}
    named = _Relations(
        lefts=frozenset(n for relation in relations for n in relation.lefts),
        rights=frozenset(n for relation in relations for n in relation.rights),
        apart=frozenset(n for relation in relations if relation.apart for n in relation.lefts),
    )
    for number in rooms:
        phrase = phrases[number]
        longer = rooms if _may_be_short(reading, phrase) else ()
        long = next((n for n in longer if n < number and _is_short_for(phrase, phrases[n])), None)
        if long is not None:
            same[number] = long
            continue
        several = _one_of_several(reading, phrases, rooms, number, named)
        if several is not None:
            same[number] = several
            continue
        if phrase.counted and phrase.determiner not in ("the", "both", "these", "those", "all"):
            continue
        group = _group(phrases, number, rooms, placed=number in named.lefts)
        if group:
            groups[number], same[number] = group, group[-1]
            continue
        other = _other_mention(reading, phrases, [n for n in rooms if n not in same], number, named)
        if other is not None:
            same[number] = other
    return same, groups


@dataclass(frozen=True)
class _Relations:
    """Numbers of the phrases on the left and on the right of relations, and on the left of those that part rooms."""

    lefts: frozenset[int]
    rights: frozenset[int]
    apart: frozenset[int]


def _may_be_short(reading: Reading, phrase: Phrase) -> bool:
    """Whether a name may be one that was given in full before: in brackets, definite, or in capitals."""
    again = reading.word(phrase.first - 1) == "(" or phrase.determiner in _DEFINITE or phrase.label.isupper()
    return again and not phrase.counted


def _is_short_for(phrase: Phrase, other: Phrase) -> bool:
    """Whether a name is another one in short: "a network operations centre (NOC)", "the mocap stage"."""
    words, others = phrase.name.split("_"), other.name.split("_")
    if len(others) < 2:
        return False
    if len(words) == 1:
        return words[0] == "".join(word[0] for word in others if word)
    short, last = words[0], (words[-1], others[-1])
    halves = [(short[:at], short[at:]) for at in range(2, len(short) - 1)]
    blended = any(others[0].startswith(one) and others[1].startswith(two) for one, two in halves)
    return len(words) == 2 and len(others) == 3 and last[0] == last[1] and blended


def _one_of_several(
    reading: Reading, phrases: Sequence[Phrase], rooms: Sequence[int], number: int, named: _Relations
) -> int | None:
    """Return the rooms before that a phrase tells one or each of: "beside one treatment room", of the five."""
    phrase = phrases[number]
    alike = [n for n in rooms if n < number and phrases[n].name == phrase.name]
    if number in named.rights and phrase.count == 1 and phrase.counted:
        several = [n for n in alike if (phrases[n].count or 2) > 1]
        if several:
            return several[-1]
    plural = [n for n in alike if phrases[n].plural]
    of_each = bool(plural) and (_is_measured(reading, phrase) or _is_of_each(reading, phrase))
    inside = bool(plural) and _stands_in_one(reading, phrase)
    return plural[-1] if of_each or inside else None


def _stands_in_one(reading: Reading, phrase: Phrase) -> bool:
    """Whether "two beds in a double room" tells of each of the double rooms named before."""
    generic = phrase.determiner in ("a", "an") and phrase.count == 1 and not phrase.plural
    thing = reading.kind(phrase.begin - 3) == "word" and reading.kind(phrase.begin - 4) == "number"
    return generic and reading.word(phrase.begin - 2) == "in" and thing and reading.starts(phrase.begin - 4)


def _other_mention(
    reading: Reading, phrases: Sequence[Phrase], rooms: Sequence[int], number: int, named: _Relations
) -> int | None:
    """Return the room named elsewhere that a phrase only speaks of, or nothing."""
    phrase, operand = phrases[number], number in named.rights
    topical = not phrase.counted and (reading.word(phrase.last) in _VERBS or _heads_entry(reading, phrase))
    known = (number in named.lefts or topical) and phrase.determiner not in ("a", "an")
    known = known or (
        number in named.apart and phrase.determiner in ("a", "an")
    )  # "nothing such as a cafe may be near"
    if not (phrase.determiner in _DEFINITE or operand or known):
        return None
    others = [n for n in rooms if n != number and _same_name(phrase, phrases[n])]
    earlier = [n for n in others if n < number]
    if earlier:
        return _best(phrases, phrase, earlier[::-1])
    later = [n for n in others if n > number and phrases[n].determiner not in ("the", "this", "that", "its")]
    of_all = phrase.determiner == "the" and phrase.plural and not phrase.counted and "_" not in phrase.name
    if (phrase.determiner in ("each", "every", "all") or of_all) and any(phrases[n].counted for n in later):
        return next(n for n in later if phrases[n].counted)  # "a desk in each bedroom; three bedrooms"
    if later and (operand or _is_inside(reading, phrase)) and phrase.determiner not in _INTRODUCING:
        return _best(phrases, phrase, later)
    return None


_JOINED = frozenset({"dining", "diner", "living", "kitchen"})
"""What is named second of two rooms in one: "living/dining", "kitchen-diner"."""


def _heads_entry(reading: Reading, phrase: Phrase) -> bool:
    """Whether rooms in the plural open an entry that says more of them: "Partner offices: one desk each"."""
    return phrase.plural and reading.word(phrase.last) == ":" and reading.starts(phrase.begin)


def _is_of_each(reading: Reading, phrase: Phrase) -> bool:
    """Whether "a bedroom has a desk" tells of each of the bedrooms named before."""
    generic = phrase.determiner in ("a", "an") and not phrase.counted
    return generic and reading.word(phrase.last) in _GENERIC and _opens(reading, phrase)


def _is_measured(reading: Reading, phrase: Phrase) -> bool:
    """Whether "the area of one classroom is 48 m2" tells how large each of the classrooms named before is."""
    of_size = reading.words(phrase.first - 2, phrase.first) in (("area", "of"), ("size", "of"), ("surface", "of"))
    one = phrase.count == 1 and not phrase.plural
    return of_size and one and reading.word(phrase.last) in ("is", "be", "should", "must")


def _opens(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase is the subject of its clause."""
    before = min(phrase.first, phrase.begin - 1) - 1
    return reading.breaks(before) or reading.word(before) in (",", ":", "and")


def _is_inside(reading: Reading, phrase: Phrase) -> bool:
    """Whether "in the living room" leads to a room that the brief names later: "oak floor in the living room"."""
    return (
        phrase.determiner == "the"
        and phrase.count == 1
        and reading.words(phrase.begin - 2, phrase.begin) == ("in", "the")
    )


def _group(phrases: Sequence[Phrase], number: int, rooms: Sequence[int], *, placed: bool) -> list[int]:
    """Return the rooms that "the two dormitories" speaks of, where so many of the name stand before.

    Parameters
    ----------
    placed : bool
        A relation is told of the phrase, so that it needs no article: "toilets away from the kitchen".
    """
    phrase = phrases[number]
    one_of = phrase.determiner in ("either", "neither", "any") and not phrase.counted
    again = phrase.determiner in ("the", "these", "those", "both", "all") or (placed and not phrase.determiner)
    if not one_of and not (phrase.plural and again):
        return []
    before = [n for n in rooms if n < number and _same_name(phrase, phrases[n]) and phrases[n].count == 1]
    wanted = phrase.count if phrase.counted and phrase.count else len(before)
    return before[-wanted:] if 2 <= wanted <= len(before) else []


def _best(phrases: Sequence[Phrase], phrase: Phrase, others: Sequence[int]) -> int:
    exact = [n for n in others if phrases[n].name == phrase.name]
    return exact[0] if exact else others[0]


def _is_designated(phrase: Phrase, other: Phrase) -> bool:
    """Whether a room has a letter or a number of its own: "one bed per bedroom" is said of bedroom A and bedroom B."""
    return other.name.startswith(f"{phrase.name}_") and len(other.name) - len(phrase.name) <= _DESIGNATOR


_DESIGNATOR = 3
"""Letters of "_a" and "_12", at most."""


def _is_shortened(phrase: Phrase, other: Phrase) -> bool:
    """Whether a name leaves out words of another one: "the children's room" of a children's corner room."""
    words, others = phrase.name.split("_"), other.name.split("_")
    return len(words) > 1 and words[0] == others[0] and words[-1] == others[-1] and set(words) < set(others)


def _same_name(phrase: Phrase, other: Phrase) -> bool:
    if phrase.head == "unknown" or other.head == "unknown":
        return False
    if phrase.name == other.name or other.name.endswith("_" + phrase.name):
        return True
    if phrase.determiner == "the" and other.name == f"{phrase.name}_room":
        return True  # "the disco" of a disco room
    if phrase.determiner in ("per", "each", "every") and _is_designated(phrase, other):
        return True
    of_several = phrase.determiner == "the" and (other.count or 2) > 1
    if of_several and phrase.name.endswith("_" + other.name) and not {"'", "’"} & set(phrase.label):
        return True
    if phrase.determiner == "the" and _is_shortened(phrase, other):
        return True
    bare = phrase.name == phrase.room_type or (phrase.known and "_" not in phrase.name)
    if phrase.determiner == "the" and other.name.rpartition("_")[2] in _JOINED and "_" not in phrase.name:
        return other.name.startswith(f"{phrase.name}_")  # "the living" of a living/dining room
    return bare and phrase.room_type == other.room_type and phrase.determiner in ("the", "each", "every", "both")
