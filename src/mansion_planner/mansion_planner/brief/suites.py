"""Read which rooms others have for themselves: "bedrooms, each with a bathroom", "a suite with its own pantry"."""

import itertools
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["Suites", "read_suites"]

_SLEEPING = frozenset(
    """
    bedroom master_bedroom guest_room childrens_room hotel_room hotel_suite resident_room patient_room dorm_room
    apartment studio_apartment
    """.split()
)
_SHARED = frozenset({"shared", "common", "communal"})
_PRIVATE = frozenset(
    {"bathroom", "ensuite_bathroom", "toilet", "walk_in_closet", "dressing_room", "shower_area", "restroom", "pantry"}
)


@dataclass(frozen=True)
class Suites:
    """Rooms that others have for themselves.

    Attributes
    ----------
    owners : dict of int to int
        Numbers of their phrases, and of the phrase of the room that has each.
    twins : dict of int to list of int
        All rooms that have each, where there are several ("a bedroom and another bedroom, each with a bathroom").
    """

    owners: dict[int, int]
    twins: dict[int, list[int]]


def read_suites(
    reading: Reading, phrases: Sequence[Phrase], rooms: Sequence[int], same: Mapping[int, int], inner: Collection[int]
) -> Suites:
    """Return the rooms that others have for themselves, and of which.

    Parameters
    ----------
    rooms : sequence of int
        Numbers of the phrases that name rooms of the building.
    same : mapping of int to int
        Phrases that only speak of another one, and that one.
    inner : collection of int
        First tokens of the phrases that name rooms of units.
    """
    suites: dict[int, int] = {}
    twin_rooms: dict[int, list[int]] = {}
    twins_of: dict[int, list[int]] = {}
    for position, number in enumerate(rooms):
        phrase = phrases[number]
        if phrase.determiner == "per" or number in same:
            continue
        owner = next(
            (
                n
                for n in reversed(rooms[:position])
                if reading.sentence[phrases[n].first] == reading.sentence[phrase.first]
            ),
            None,
        )
        if owner is None or any(phrases[owner].last <= first < phrase.first for first in inner):
            continue
        gap_words = reading.words(phrases[owner].last, phrase.begin)
        gap = set(gap_words)
        if "of" in gap and not {"which", "them", "these", "those", "whom"}.isdisjoint(gap):
            continue  # "six rooms, three of which have a bathroom"
        if reading.words(phrases[owner].first - 2, phrases[owner].first) == ("of", "the") and reading.kind(
            phrases[owner].first - 3
        ) in ("number",):
            continue  # "two of the three bedrooms en suite"
        every = phrases[owner].determiner in ("each", "every") and reading.word(phrases[owner].last) in (
            "get",
            "has",
            "need",
        )
        if "," in gap and owner not in suites and not every and _list_goes_on(phrases, owner, number, gap_words):
            continue
        if ("each", "group") in itertools.pairwise(gap_words) or ("per", "group") in itertools.pairwise(gap_words):
            continue  # "ten offices in two groups, each group with a kitchenette"
        lead = reading.words(phrase.first - 2, phrase.first)
        if phrase.counted and lead == ("each", "and") and phrases[number - 1].head == "object":
            continue  # "dormitories with 6 beds each and two shower rooms"
        if _measures_each(reading, phrases[owner].last, phrase.begin):
            gap.discard("each")
        tail = reading.words(phrase.last, phrase.last + 1)
        has = bool(gap & {"with", "having", "has", "have", "own", "get", "plus", "its", "contain"})
        distributed = phrases[owner].determiner in ("each", "every", "both", "all")
        generic = phrases[owner].determiner in ("a", "an", "each", "every")
        if generic and owner in same:
            twins_of[number] = [n for n in rooms[:position] if phrases[n].name == phrases[owner].name and n not in same]
        distributed = distributed or (generic and owner in same)
        owner = same.get(owner, owner)
        several = (phrases[owner].count or 2) > 1 or distributed
        if owner in suites:
            shared = not _SHARED.isdisjoint(reading.words(phrase.first, phrase.noun_end))
            joined = (
                not shared
                and phrases[suites[owner]].last != phrases[owner].begin
                and _outside_brackets(gap_words) <= {"and", "a", "an", "its", "own", ",", "the", "one"}
                and "and" in gap
                and not (phrase.determiner == "the" and "," in gap_words)
            )
            if joined:
                suites[number] = suites[owner]
            continue
        distributive = has and (
            bool(gap & {"each", "every", "apiece"})
            or tail in (("each",), ("apiece",))
            or reading.words(phrase.last, phrase.last + 2) == ("for", "each")
            or distributed
        )
        both = phrase.determiner in ("both", "all", "each") and phrase.room_type == "ensuite_bathroom"
        mine = "own" in gap or phrase.determiner == "own" or reading.word(phrase.begin) in ("own", "private")
        own = has and (mine or (("its" in gap or phrase.determiner == "its") and phrase.room_type in _PRIVATE))
        plain = (
            has
            and phrase.room_type in _PRIVATE
            and not several
            and "with" in gap
            and phrases[owner].room_type in _SLEEPING
        )
        if has and "each" in gap and not several:
            twins = [
                n
                for n in rooms[:position]
                if phrases[n].room_type == phrases[owner].room_type
                and reading.sentence[phrases[n].first] == reading.sentence[phrase.first]
            ]
            if len(twins) > 1:
                twin_rooms[number] = twins
                suites[number] = owner
                continue
        if tail == ("each",) and reading.word(phrases[owner].last) == "each":
            continue  # "floors with 30 desks each and 4 offices each"
        if tail == ("each",) and not has and "and" in gap and _of_storeys(reading, phrases[owner].begin):
            continue  # "levels 3 and 4: ten patient rooms and a nurses' station each"
        postposed = not gap_words and phrase.room_type == "ensuite_bathroom"  # "three bedrooms en suite"
        shared_out = several and (distributive or tail == ("each",))
        if shared_out or both or postposed or own or plain:
            suites[number] = owner
    twin_rooms |= {n: others for n, others in twins_of.items() if n in suites and len(others) > 1}
    return Suites({n: o for n, o in suites.items() if n not in same}, twin_rooms)


def _of_storeys(reading: Reading, index: int) -> bool:
    """Whether the sentence speaks of several storeys before a token: they share out what has "each" at its end."""
    return any(
        reading.word(at) in FLOOR_WORDS and reading.plural(at)
        for at in range(index)
        if reading.sentence[at] == reading.sentence[index]
    )


def _measures_each(reading: Reading, first: int, last: int) -> bool:
    """Whether "each" only says how large rooms are: "3 rooms with each 13 m2, a bathroom"."""
    return any(
        reading.word(at) == "each" and reading.kind(at + 1) == "number" and reading.kind(at + 2) == "unit"
        for at in range(first, last)
    )


def _list_goes_on(phrases: Sequence[Phrase], owner: int, number: int, gap: tuple[str, ...]) -> bool:
    """Whether a comma after furniture only leads on to the next room: "a bedroom with bunk beds, one bathroom"."""
    after = gap[len(gap) - gap[::-1].index(",") :]
    between = any(p.head == "object" for p in phrases[owner + 1 : number])
    return between and {"with", "each", "own", "its", "has", "have"}.isdisjoint(after)


def _outside_brackets(words: tuple[str, ...]) -> set[str]:
    """Return the words that do not stand in brackets."""
    found, depth = set(), 0
    for word in words:
        depth += (word == "(") - (word == ")")
        if depth == 0 and word != ")":
            found.add(word)
    return found
