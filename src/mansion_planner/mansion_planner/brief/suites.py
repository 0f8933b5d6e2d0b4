"""Read which rooms others have for themselves: "bedrooms, each with a bathroom", "a suite with its own pantry"."""

import itertools
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["PRIVATE", "SLEEPING", "Suites", "read_suites"]

SLEEPING = frozenset(
    """
    bedroom master_bedroom guest_room childrens_room hotel_room hotel_suite resident_room patient_room dorm_room
    apartment studio_apartment
    """.split()
)
"""Types of rooms that people sleep in, which may have rooms for themselves."""
_SHARED = frozenset({"shared", "common", "communal"})
PRIVATE = frozenset(
    {"bathroom", "ensuite_bathroom", "toilet", "walk_in_closet", "dressing_room", "shower_area", "restroom", "pantry"}
)
"""Types of rooms that others have for themselves as a rule."""


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
        before = rooms[:position]
        named = _named_before(reading, phrases, before, number)
        if phrases[number].determiner == "per" or number in same or named is None:
            continue
        owner = same.get(named, named)
        pair = _Pair(reading, phrases[named], phrases[owner], phrases[number], again=named in same)
        if (
            any(pair.named.last <= first < pair.phrase.first for first in inner)
            or pair.is_of_others()
            or pair.is_closed()
        ):
            continue
        if named not in suites and pair.list_goes_on(phrases[named + 1 : number]):
            continue
        if pair.counted_with_furniture() and phrases[number - 1].head == "object":
            continue
        if pair.again and pair.is_generic():
            kind = pair.named.name
            alike = [n for n in before if phrases[n].name == kind or phrases[n].name.endswith(f"_{kind}")]
            twins_of[number] = [n for n in alike if n not in same]
        if owner in suites:
            if pair.adds_to(phrases[suites[owner]]):
                suites[number] = suites[owner]
        elif len(twins := _twins(pair, phrases, before)) > 1:
            twin_rooms[number], suites[number] = twins, owner
        elif pair.belongs():
            suites[number] = owner
    twin_rooms |= {n: others for n, others in twins_of.items() if n in suites and len(others) > 1}
    return Suites({n: o for n, o in suites.items() if n not in same}, twin_rooms)


def _named_before(reading: Reading, phrases: Sequence[Phrase], before: Sequence[int], number: int) -> int | None:
    """Return the last of the rooms before one that its sentence names."""
    sentence = reading.sentence[phrases[number].first]
    return next((n for n in reversed(before) if reading.sentence[phrases[n].first] == sentence), None)


@dataclass(frozen=True)
class _Pair:
    """A room and the one named before it in its sentence, which may have it for itself.

    Attributes
    ----------
    named : Phrase
        What stands before the room.
    owner : Phrase
        The same, or the phrase that it speaks of.
    phrase : Phrase
        The room that may be the owner's.
    again : bool
        What stands before only speaks of another phrase.
    """

    reading: Reading
    named: Phrase
    owner: Phrase
    phrase: Phrase
    again: bool

    @cached_property
    def words(self) -> tuple[str, ...]:
        """The words between the two."""
        return self.reading.words(self.named.last, self.phrase.begin)

    @cached_property
    def gap(self) -> set[str]:
        """The words between the two, without an "each" that is said of an area."""
        gap = set(self.words)
        return gap - {"each"} if _measures_each(self.reading, self.named.last, self.phrase.begin) else gap

    def is_of_others(self) -> bool:
        """Whether only some of the rooms before, or groups of them, have the room."""
        if (
            "of" in self.gap
            and not {"which", "them", "these", "those", "whom"}.isdisjoint(self.gap)
            and not self._counts_all()
        ):
            return True  # "six rooms, three of which have a bathroom"
        first = self.named.first
        if self.reading.words(first - 2, first) == ("of", "the") and self.reading.kind(first - 3) == "number":
            return True  # "two of the three bedrooms en suite"
        # "ten offices in two groups, each group with a kitchenette"
        return not {("each", "group"), ("per", "group")}.isdisjoint(itertools.pairwise(self.words))

    def _counts_all(self) -> bool:
        """Whether "four of them" are all there are: "all bedrooms are upstairs, four of them, each with a bathroom"."""
        of = self.named.last + self.words.index("of")
        told = self.reading.kind(of - 1) == "number" and self.reading.value(of - 1) == self.owner.count
        return told and self.reading.words(of + 2, of + 4) == (",", "each")

    def is_closed(self) -> bool:
        """Whether "each" closes what stands before: "meeting rooms with a screen each, a nap room with a sofa"."""
        ends = self.words[-2:] == ("each", ",") or self.words[-3:-1] == ("each", ",")
        if self.phrase.determiner in ("both", "all") and self.phrase.room_type == "ensuite_bathroom":
            return False  # "nine rooms each, all en suite"
        if self._is_bracketed():
            return False
        return ends and {"with", "has", "have", "get"}.isdisjoint(self.words[-1:])

    def list_goes_on(self, between: Sequence[Phrase]) -> bool:
        """Whether a comma after furniture only leads on to the next room: "a bedroom with bunk beds, one bathroom"."""
        if "," not in self.gap or not any(phrase.head == "object" for phrase in between) or self._is_bracketed():
            return False
        every = self.named.determiner in ("each", "every")
        if every and self.reading.word(self.named.last) in ("get", "has", "need"):
            return False
        if (every or "each" in self.words[:2]) and self._ends_list_of_furniture(between):
            return False
        after = self.words[len(self.words) - self.words[::-1].index(",") :]
        return {"with", "each", "own", "its", "has", "have"}.isdisjoint(after)

    def _ends_list_of_furniture(self, between: Sequence[Phrase]) -> bool:
        """Whether a private room is the last of what each room has: "each room with a bed, a desk and a balcony"."""
        private = self.phrase.room_type in PRIVATE | {"balcony_room"}
        last = between[-1]
        return private and last.head == "object" and self.reading.word(last.last) == "and" and not self.phrase.counted

    def counted_with_furniture(self) -> bool:
        """Whether "each" may be said of furniture: "dormitories with 6 beds each and two shower rooms"."""
        first = self.phrase.first
        return self.phrase.counted and self.reading.words(first - 2, first) == ("each", "and")

    def is_generic(self) -> bool:
        """Whether what stands before means any room of its kind."""
        return self.named.determiner in ("a", "an", "each", "every")

    def has(self) -> bool:
        """Whether a word between the two says that one has the other."""
        return not {
            "with",
            "having",
            "has",
            "have",
            "own",
            "get",
            "plus",
            "its",
            "contain",
            "belong",
            "belongs",
        }.isdisjoint(self.gap)

    def is_distributed(self) -> bool:
        """Whether the sentence speaks of each of several owners."""
        return self.named.determiner in ("each", "every", "both", "all") or (self.is_generic() and self.again)

    def is_several(self) -> bool:
        """Whether there are several owners."""
        return (self.owner.count or 2) > 1 or self.is_distributed()

    def adds_to(self, holder: Phrase) -> bool:
        """Whether the room is one more that `holder` has: "a bedroom with a bathroom and a closet"."""
        return (
            _SHARED.isdisjoint(self.reading.words(self.phrase.first, self.phrase.noun_end))
            and holder.last != self.owner.begin
            and _outside_brackets(self.words) <= {"and", "a", "an", "its", "own", ",", "the", "one"}
            and "and" in self.gap
            and not ("," in self.words and (self.phrase.determiner == "the" or self.phrase.room_type not in PRIVATE))
            and not self._stands_beside_own()
        )

    def _stands_beside_own(self) -> bool:
        """Whether a single room follows those that owners have: "bedrooms with their own bathrooms and a sauna"."""
        own = "own" in self.reading.words(self.named.first - 1, self.named.noun_end)
        return own and self.named.plural and self.words in (("and", "a"), ("and", "an"))

    def belongs(self) -> bool:
        """Whether the owner has the room, or each of the owners one."""
        shared = not _SHARED.isdisjoint(self.reading.words(self.phrase.first, self.phrase.noun_end))
        if self._shares_each_with_others() or (shared and self._is_only_beside()):
            return False  # "every room with a desk, and one common lounge"
        after = self.reading.words(self.phrase.last, self.phrase.last + 2)
        if after[:1] in (("in",), ("between",)) and not {"between", "them"}.isdisjoint(after):
            return False  # "two laboratories with a preparation room in between"
        if self._is_for_all():
            return False
        both = self.phrase.determiner in ("both", "all", "each") and self.phrase.room_type == "ensuite_bathroom"
        postposed = not self.words and self.phrase.room_type == "ensuite_bathroom"  # "three bedrooms en suite"
        private = self.phrase.room_type in PRIVATE and self.owner.room_type in SLEEPING
        if private and self._is_bracketed() and self.is_several():
            return True  # "ten patient rooms (two beds each, ensuite bathroom)"
        return self._is_shared_out() or both or postposed or self._is_own() or self._is_private() or self._are_ensuite()

    def _is_for_all(self) -> bool:
        """Whether several rooms are named after several owners, and not of each: "five bedrooms with two bathrooms"."""
        many = self.phrase.counted and (self.phrase.count or 0) > 1 and self.owner.plural
        near = self.reading.words(self.phrase.first - 2, self.phrase.first)
        each = {"each", "every", "all", "both"} & {*near, self.reading.word(self.phrase.last), self.owner.determiner}
        return many and self.phrase.room_type in ("bathroom", "toilet", "restroom") and not each

    def _is_only_beside(self) -> bool:
        """Whether a room that is shared is named after others which share it: "four bedrooms with a shared bath"."""
        return "and" in self.gap or _outside_brackets(self.words) <= {"with", "a", "the", "one", "("}

    def _is_bracketed(self) -> bool:
        """Whether the room stands in a bracket behind the owner: "ten rooms (two beds each, own bathroom)"."""
        return "(" in self.words and ")" not in self.words

    def _are_ensuite(self) -> bool:
        """Whether rooms to sleep in have as many rooms that are called en suite: "bedrooms with en-suite bathrooms"."""
        attached = self.reading.word(self.phrase.begin) in ("attached", "private") and self.phrase.room_type in PRIVATE
        ensuite = self.phrase.room_type == "ensuite_bathroom" or self.phrase.name.startswith("ensuite_") or attached
        several = self.phrase.plural and not self.phrase.counted and self.owner.plural
        return ensuite and several and self.owner.room_type in SLEEPING and self.gap <= {"with", "having", "and"}

    def _ends_in_each(self) -> bool:
        return self.reading.word(self.phrase.last) == "each"

    def _shares_each_with_others(self) -> bool:
        """Whether "each" at the end is said of storeys, or of what stands before as well."""
        if not self._ends_in_each():
            return False
        if self.reading.word(self.owner.last) == "each":
            return True  # "floors with 30 desks each and 4 offices each"
        # "levels 3 and 4: ten patient rooms and a nurses' station each"
        listed = not {"and", ","}.isdisjoint(self.gap)
        return not self.has() and listed and _of_storeys(self.reading, self.owner.begin)

    def _is_shared_out(self) -> bool:
        """Whether each of several owners has one: "bedrooms, each with a bathroom"."""
        last = self.phrase.last
        said = (
            not {"each", "every", "apiece"}.isdisjoint(self.gap)
            or self.reading.word(last) == "apiece"
            or self.reading.words(last, last + 2) == ("for", "each")
            or self.is_distributed()
        )
        return self.is_several() and (self._ends_in_each() or (self.has() and said))

    def _is_own(self) -> bool:
        """Whether the brief calls the room the owner's: "a suite with its own pantry"."""
        mine = "own" in self.gap or self.phrase.determiner == "own"
        mine = mine or self.reading.word(self.phrase.begin) in ("own", "private")
        its = "its" in self.gap or self.phrase.determiner == "its"
        return self.has() and (mine or (its and self.phrase.room_type in PRIVATE))

    def _without_area(self) -> tuple[str, ...]:
        """Return the words between the two without the area of the owner: "20 rooms at 24 m2 with shower"."""
        if not self.owner.areas:
            return self.words
        between = zip(range(self.named.last, self.phrase.begin), self.words, strict=True)
        measures = ("number", "unit")
        return tuple(
            w for at, w in between if self.reading.kind(at) not in measures and w not in ("at", "of", "each", ",")
        )

    def _is_private(self) -> bool:
        """Whether a room to sleep in has a room that is private as a rule: "a bedroom with a bathroom"."""
        private = self.phrase.room_type in PRIVATE and self.owner.room_type in SLEEPING
        said = self._without_area()
        bare = said == ("with",) and not (self.phrase.determiner or self.phrase.counted or self.phrase.plural)
        # "fourteen patient rooms with shower" have one each
        return private and not {"with", "having"}.isdisjoint(self.gap) and (bare or not self.is_several())


def _twins(pair: _Pair, phrases: Sequence[Phrase], before: Sequence[int]) -> list[int]:
    """Return the rooms like the owner that "each" is said of: "a bedroom and another bedroom, each with a bathroom"."""
    if not pair.has() or "each" not in pair.gap or pair.is_several():
        return []
    sentence = pair.reading.sentence
    return [
        n
        for n in before
        if phrases[n].room_type == pair.owner.room_type and sentence[phrases[n].first] == sentence[pair.phrase.first]
    ]


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


def _outside_brackets(words: tuple[str, ...]) -> set[str]:
    """Return the words that do not stand in brackets."""
    found, depth = set(), 0
    for word in words:
        depth += (word == "(") - (word == ")")
        if depth == 0 and word != ")":
            found.add(word)
    return found
