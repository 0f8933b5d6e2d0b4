"""Read which rooms are to be side by side or apart: "the kitchen next to the dining room", "away from the nursery".

A relation joins the room named last before it and the rooms named right after it; pronouns stand for the room before.
"""

import itertools
from bisect import bisect_left
from dataclasses import dataclass, replace

from mansion_planner.brief.phrase import FUNCTION_WORDS, PLAIN, Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["Relation", "read_relations"]

_TO = ("to", "onto", "into", "on", "off", "from", "with", "up")
_BESIDE = [
    ("next", "to"),
    ("next", "door", "to"),
    ("right", "next", "to"),
    ("adjacent", "to"),
    ("adjacent", "with"),
    ("beside",),
    ("besides",),
    ("alongside",),
    ("close", "to"),
    ("near", "to"),
    ("near",),
    ("by", "the"),
    ("adjoining",),
    ("adjoin",),
    ("bordering",),
    ("border",),
    ("abut",),
    ("abutting",),
    ("touch",),
    ("touching",),
    ("against",),
    ("neighbouring",),
    ("neighboring",),
    ("behind",),
    ("in", "front", "of"),
    ("directly", "off"),
    ("off", "the"),
    ("off", "a"),
    ("off", "it"),
    *[
        (verb, *article, *kind, "wall", "with")
        for verb in ("share", "sharing")
        for article in (("a",), ("one",), ("the",), ("any",), ())
        for kind in ((), ("common",), ("same",))
    ],
    ("reached", "through"),
    ("reached", "from"),
    ("accessed", "from"),
    ("accessible", "from"),
    ("entered", "from"),
    ("entered", "through"),
    ("entered", "via"),
    ("reached", "via"),
    ("visible", "from"),
    *[
        (word, to)
        for word in ("contiguous", "connection", "passage", "neighbour", "neighbor", "beside", "contact", "bordering")
        for to in ("to", "with", "of")
    ],
    ("adjoining", "to"),
    ("adjoining", "with"),
    ("touch", "with"),
    ("next", "of"),
    *[(noun, to) for noun in ("side", "hatch") for to in ("to", "into", "towards", "toward")],
    ("common", "wall", "with"),
    ("wall", "in", "common", "with"),
    ("wall", "to", "wall", "with"),
    ("opposite",),
    *[
        (verb, to)
        for verb in (
            "open",
            "opening",
            "lead",
            "leading",
            "connected",
            "connect",
            "connecting",
            "attached",
            "linked",
            "joined",
            "link",
            "belonging",
            "communicate",
            "communicating",
            "direct",
            "directly",
            "straight",
            "access",
        )
        for to in _TO
    ],
    *[
        (verb, adverb, to)
        for verb in ("open", "connected", "attached", "opening", "connect", "linked", "leading", "lead", "access")
        for adverb in ("directly", "straight", "direct", "internally")
        for to in _TO
    ],
]
_APART = [
    ("away", "from"),
    ("apart", "from"),
    ("far", "from"),
    ("far", "away", "from"),
    ("separated", "from"),
    ("remote", "from"),
    ("distance", "from"),
    ("clear", "of"),
    ("well", "clear", "of"),
    ("well", "away", "from"),
    ("out", "of", "reach", "of"),
    ("isolated", "from"),
    ("separate", "from"),
    ("distant", "from"),
    *[
        (verb, "no", *kind, "wall", "with")
        for verb in ("share", "sharing", "have", "has", "having")
        for kind in ((), ("common",), ("party",))
    ],
    ("as", "far", "as", "you", "can", "from"),
    ("as", "far", "as", "possible", "from"),
    ("far", "as", "possible", "from"),
]
_MUTUAL = [
    ("wall", "to", "wall"),
    ("next", "to", "each", "other"),
    ("beside", "each", "other"),
    ("side", "by", "side"),
    ("adjacent", "to", "each", "other"),
    ("back", "to", "back"),
    ("next", "to", "one", "another"),
    ("neighbour",),
    ("neighbor",),
    ("adjoin",),
    ("adjacent",),
    ("adjoining",),
    ("beside", "one", "another"),
    ("connected", "to", "each", "other"),
    ("together",),
    ("touch",),
    ("opening", "to", "each", "other"),
    *[
        (verb, *other)
        for verb in ("adjoin", "touch", "border", "abut", "adjoining", "touching", "neighbouring", "facing", "connect")
        for other in (("each", "other"), ("one", "another"), ("to", "each", "other"))
    ],
    ("next", "door"),
    *[("meet", to, article, "corner") for to in ("at", "in") for article in ("the", "a", "one")],
    ("at", "its", "side"),
    ("at", "the", "side"),
    ("common", "wall"),
    ("touching",),
    ("share", "a", "wall"),
    ("share", "wall"),
    ("share", "one", "wall"),
    ("share", "any", "wall"),
    ("connected",),
    ("attached",),
    ("alongside",),
    ("beside",),
]


def _by_first(patterns: list[tuple[str, ...]]) -> dict[str, list[tuple[str, ...]]]:
    """Return patterns by their first word."""
    found: dict[str, list[tuple[str, ...]]] = {}
    for pattern in patterns:
        found.setdefault(pattern[0], []).append(pattern)
    return found


_BESIDE_AT, _APART_AT, _MUTUAL_AT = _by_first(_BESIDE), _by_first(_APART), _by_first(_MUTUAL)
_LEADS = frozenset(
    {"between", "wall", "each", "to", "of", "from", *(words[0] for words in (*_BESIDE, *_APART, *_MUTUAL))}
)
"""Words that a relation can begin with."""
_NEGATIONS = frozenset({"none", "nothing", "not", "no", "never", "neither", "nor", "without", "nowhere", "avoid"})
_PRONOUNS = frozenset({"it", "them", "this", "that", "which", "these", "those"})


@dataclass(frozen=True)
class Relation:
    """Rooms that are to be side by side, or apart.

    Attributes
    ----------
    lefts, rights : tuple of int
        Numbers of the phrases; every one on the left with some one on the right.
    apart : bool
    first, last : int
        Tokens of the words of the relation.
    """

    lefts: tuple[int, ...]
    rights: tuple[int, ...]
    apart: bool
    first: int
    last: int


def read_relations(reading: Reading, phrases: list[Phrase], excluded_phrases: set[int]) -> list[Relation]:
    """Return the relations from left to right; the tokens of their words are taken.

    Parameters
    ----------
    excluded_phrases : set of int
        Phrases that are no rooms of the building (the building itself).
    """
    rooms = [
        n
        for n, phrase in enumerate(phrases)
        if phrase.head in ("room", "building", "elevator", "stair") and n not in excluded_phrases
    ]
    relations: list[Relation] = []
    index = 0
    while index < len(reading.tokens):
        found = _relation_at(reading, phrases, rooms, index)
        if found is None:
            index += 1
            continue
        relation, last = found
        relation = _of_subject(reading, phrases, relation, relations[-1] if relations else None)
        relations.append(relation)
        reading.take(_with_adverbs(reading, relation.first), relation.last)
        index = max(last, index + 1)
    return relations


def _with_adverbs(reading: Reading, first: int) -> int:
    """Return where a relation begins with the adverbs that strengthen it: "right beside", "immediately next to"."""
    while reading.word(first - 1) in _STRENGTHS and first - 1 not in reading.taken:
        first -= 1
    return first


_STRENGTHS = frozenset(
    "right immediately directly just straight close closely well very conveniently handily situated".split()
)
"""Adverbs before a relation that ask for nothing more than it does."""


def _of_subject(reading: Reading, phrases: list[Phrase], relation: Relation, before: Relation | None) -> Relation:
    """Return a relation that goes on after a comma as of the same room: "beside the dock, away from the boiler"."""
    if before is None or relation.lefts != before.rights[-1:] or before.lefts == before.rights:
        return relation
    between = reading.words(phrases[relation.lefts[0]].last, relation.first)
    joined = between in ((",",), (",", "and"), (",", "but"), ("but",), ("and",))
    return replace(relation, lefts=before.lefts) if joined else relation


def _relation_at(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int) -> tuple[Relation, int] | None:
    if reading.word(index) not in _LEADS or _follows_unknown(reading, index):
        return None
    if reading.word(index) == "between" and index not in reading.taken:
        return _between(reading, phrases, rooms, index)
    if reading.word(index) == "from":
        return _reached_from(reading, phrases, rooms, index)
    if reading.words(index, index + 2) == ("wall", "between"):
        return _wall_between(reading, phrases, rooms, index)
    if reading.words(index, index + 3) == ("each", "leading", "into") or reading.words(index, index + 3) == (
        "each",
        "opening",
        "into",
    ):
        before = _in_sentence(reading, phrases, rooms, index, before=True)
        pairs = list(itertools.pairwise(before))
        if pairs:
            return Relation(tuple(a for a, _ in pairs), tuple(b for _, b in pairs), False, index, index + 5), index + 5
    mutual = max(
        (p for p in _MUTUAL_AT.get(reading.word(index), ()) if reading.words(index, index + len(p)) == p),
        key=len,
        default=None,
    )
    longer = max(
        (p for p in _BESIDE_AT.get(reading.word(index), ()) if reading.words(index, index + len(p)) == p),
        key=len,
        default=(),
    )
    directed = (
        mutual is not None
        and len(longer) > len(mutual)
        and (reading.word(index + len(longer)) in _PRONOUNS or _right(reading, phrases, rooms, index + len(longer)))
    )
    if mutual is not None and not directed and _closes(reading, index + len(mutual), phrases, rooms):
        found = _mutual(reading, phrases, rooms, index, index + len(mutual)) or _postposed(
            reading, phrases, rooms, index, index + len(mutual)
        )
        if found is not None:
            return found, index + len(mutual)
    if reading.words(index, index + 2) in (("to", "the"), ("of", "the")) and index not in reading.taken:
        return _belonging(reading, phrases, rooms, index)
    apart = next((p for p in _APART_AT.get(reading.word(index), ()) if reading.words(index, index + len(p)) == p), None)
    beside = apart or max(
        (p for p in _BESIDE_AT.get(reading.word(index), ()) if reading.words(index, index + len(p)) == p),
        key=len,
        default=None,
    )
    if reading.word(index) == "besides" and reading.word(index - 1) in ("nothing", "anything", "everything", ","):
        return None  # "in addition to"
    if beside is None or (index in reading.taken and reading.word(index) not in ("direct", "open")):
        return None
    return _directed(reading, phrases, rooms, index, index + len(beside), apart=apart is not None)


def _reached_from(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int) -> tuple[Relation, int] | None:
    """Read "from the kitchen one enters the pantry" and "a corridor; from it open all rooms: a kitchen, a bath"."""
    before = [n for n in rooms if phrases[n].last <= index]
    following = _in_sentence(reading, phrases, rooms, index, before=False)
    if reading.word(index + 1) in ("it", "which", "there", "this") and before:
        origin, at = before[-1], index + 2
    elif following and phrases[following[0]].begin - index <= 2:
        origin, at = following[0], phrases[following[0]].last
    else:
        return None
    verb = next((i for i in range(at, at + 4) if reading.word(i) in _WAYS_IN), None)
    if verb is None or any(reading.kind(i) == "mark" or reading.word(i) == "and" for i in range(at, verb)):
        return None
    if not (_NEGATIONS | {"cannot"}).isdisjoint(reading.words(index - 2, verb)):
        return None
    reached, last = [], verb + 1
    for number in (n for n in following if phrases[n].begin > verb):
        if not _LISTING.issuperset(reading.words(last, phrases[number].first)):
            break
        reached.append(number)
        last = phrases[number].last
    if not reached:
        return None
    return Relation((origin,) * len(reached), tuple(reached), False, index, verb + 1), last


_WAYS_IN = frozenset("enter enters go goes open opens lead leads reach reaches get gets branch access".split())
"""Verbs of who goes from a room into another, and of rooms that lie off one."""
_LISTING = frozenset(
    "in into to off away also directly the a an all room our and as well plus , : one each own separate".split()
)
"""Words between the rooms that are reached from another."""


def _follows_unknown(reading: Reading, index: int) -> bool:
    """Whether a relation is said of a noun that nothing is read of: "sterilizers between two of the surgeries"."""
    token = reading.tokens[index - 1] if index else None
    if token is None or token.kind != "word" or index - 1 in reading.taken or index in reading.taken:
        return False
    if reading.word(index - 2) not in (",", "and", ":", ";", "a", "an", "the", "with", "plus", ""):
        return False
    described = token.text.endswith(("ly", "ed", "ing")) or token.text in FUNCTION_WORDS | PLAIN | FLOOR_WORDS
    return not described and token.text not in _ADVERBS


_ADVERBS = frozenset(
    "direct right well far side door distance wall contact access there stay stays kept lie close".split()
)
"""Words right before a relation that are part of it."""


def _belonging(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int) -> tuple[Relation, int] | None:
    """Read "an ensuite to the master bedroom"."""
    at = bisect_left(rooms, index, key=lambda n: phrases[n].last)
    if at + 1 >= len(rooms):
        return None
    owned, owner = rooms[at], rooms[at + 1]
    if phrases[owned].last != index or phrases[owned].room_type not in _OWNED:
        return None
    if phrases[owner].begin != index + 2 or phrases[owner].head != "room":
        return None
    return Relation((owned,), (owner,), False, index, index + 2), phrases[owner].last


_OWNED = frozenset({"ensuite_bathroom", "walk_in_closet", "dressing_room"})
"""Rooms that belong to another."""


def _closes(reading: Reading, last: int, phrases: list[Phrase], rooms: list[int]) -> bool:
    """Whether nothing that could be the second room follows before the clause ends."""
    return reading.breaks(last) or reading.word(last) in (
        *(",", ")", "and", "on", "in", "at", ":", "if", "to"),
        *("go", "is", "are", "but", "plus", "which", "take", "occupy", "so"),
    )


def _in_sentence(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int, *, before: bool) -> list[int]:
    sentence = reading.sentence[index]
    return [
        n
        for n in rooms
        if reading.sentence[phrases[n].first] == sentence
        and (phrases[n].last <= index if before else phrases[n].begin >= index)
    ]


def _negated(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int) -> bool:
    """Whether a negation stands before the relation, after the room on its left or before its sentence's first one."""
    sentence = reading.sentence[index]
    before = _in_sentence(reading, phrases, rooms, index, before=True)
    start = index
    while (
        start > 0
        and reading.sentence[start - 1] == sentence
        and index - start < 9
        and reading.word(start - 1) not in (",", "but", "(", ":")
    ):
        start -= 1
        if reading.word(start) in _NEGATIONS - {"nor"}:
            break
    window = range(start, index)
    hits = [i for i in window if reading.word(i) in _NEGATIONS]
    if not hits:
        return False
    # "no lift next to the stairs" negates the lift; "must not be next to" and "neither A nor B" the relation.
    if before and hits[-1] < phrases[before[-1]].first and reading.word(hits[-1]) in ("no", "without"):
        return False
    for hit in hits:
        reading.take(hit, hit + 1)
    return True


def _directed(
    reading: Reading, phrases: list[Phrase], rooms: list[int], index: int, last: int, *, apart: bool
) -> tuple[Relation, int] | None:
    rights = (
        []
        if reading.word(last) in _PRONOUNS or reading.word(last - 1) == "it"
        else _right(reading, phrases, rooms, last)
    )
    before = _in_sentence(reading, phrases, rooms, index, before=True)
    negated = apart or _negated(reading, phrases, rooms, index)
    if negated:
        rights = _with_alternatives(reading, phrases, rooms, rights)
    if not before and rights:  # "Next to the kitchen: the pantry", "beside the library a writing room"
        following = [n for n in _in_sentence(reading, phrases, rooms, last, before=False) if n not in rights]
        if following and phrases[following[0]].first - phrases[rights[-1]].last <= 6:
            return Relation((following[0],), tuple(rights), negated, index, last), phrases[following[0]].last
        return None
    if not rights and _is_relative(reading, phrases, before, last):
        return Relation((before[-1],), (before[-2],), negated, index, last), last
    if not rights:
        of_them = reading.words(last, last + 2) in (("one", "of"), ("each", "of"), ("either", "of"), ("any", "of"))
        reach = last + 2 + 2 * of_them
        pronoun = next((i for i in range(last - 1, reach) if reading.word(i) in _PRONOUNS), None)
        if pronoun is None:
            return None
        earlier = [n for n in rooms if phrases[n].last <= index]
        after_it = next((n for n in rooms if 0 <= phrases[n].first - pronoun - 1 <= 1), None)
        if before and after_it is not None and reading.word(index - 1) in (",", "and"):
            # "the mayor's office, next to it the archive"
            return Relation((after_it,), (before[-1],), negated, index, last), last
        if (
            before and reading.word(pronoun + 1) == "," and reading.word(index - 1) in (",", "and")
        ):  # "a preparation room and, adjoining it, the cold room"
            after = [
                n for n in _in_sentence(reading, phrases, rooms, last, before=False) if phrases[n].first - pronoun <= 3
            ]
            if after:
                return Relation((after[0],), (before[-1],), negated, index, last), last
        following = _in_sentence(reading, phrases, rooms, last, before=False)
        if following and earlier and (not before or reading.starts(index)):
            return Relation((following[0],), (_subject(reading, phrases, rooms, index),), negated, index, last), last
        lefts = _lefts(reading, phrases, before, index)
        others = [n for n in earlier if n < min(lefts, default=0)]
        if lefts and others:
            return Relation(tuple(lefts), (_referent(reading, phrases, others, lefts),), negated, index, last), last
        return None
    lefts = _lefts(reading, phrases, before, index)
    if lefts and not negated and _inverted(reading, phrases, before, index):
        following = [n for n in _in_sentence(reading, phrases, rooms, last, before=False) if n not in rights]
        if (
            following
            and phrases[following[0]].first - phrases[rights[-1]].last <= 4
            and not _joint(reading, phrases, rights[-1], following[0])
        ):
            lefts = [following[0]]
    return (Relation(tuple(lefts), tuple(rights), negated, index, last), last) if lefts else None


def _is_relative(reading: Reading, phrases: list[Phrase], before: list[int], last: int) -> bool:
    """Whether a clause says of the room before it where another lies: "a kitchen that the lounge opens onto"."""
    if len(before) < 2 or not (reading.breaks(last) or reading.word(last) in (",", ")", "and")):
        return False
    return reading.words(phrases[before[-2]].last, phrases[before[-1]].begin)[:1] in (("that",), ("which",))


def _referent(reading: Reading, phrases: list[Phrase], others: list[int], lefts: list[int]) -> int:
    """Return which room "it" is: the one that has the room on the left ("a hall with a shoe room in front of it")."""
    sentence = reading.sentence[phrases[lefts[0]].first]
    for number in reversed(others):
        if reading.sentence[phrases[number].first] != sentence:
            break
        following = phrases[number + 1].first if number + 1 < len(phrases) else len(reading.tokens)
        having = reading.words(phrases[number].last, phrases[number].last + 2)
        if having in (("that", "has"), ("which", "has"), ("that", "have")) or having[0] in ("having", "has"):
            return number  # "a dining room that has the kitchen right beside it"
        if "with" in reading.words(phrases[number].last, min(following, phrases[number].last + 6)):
            return number
    return others[-1]


def _inverted(reading: Reading, phrases: list[Phrase], before: list[int], index: int) -> bool:
    """Whether the relation opens its clause: ", and next to the kitchen the pantry"."""
    return reading.word(index - 1) in (",", "and") and phrases[before[-1]].last < index


def _joint(reading: Reading, phrases: list[Phrase], one: int, other: int) -> bool:
    return any(word in ("and", ",", "or") for word in reading.words(phrases[one].last, phrases[other].first))


def _subject(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int) -> int:
    return next(n for n in reversed(rooms) if phrases[n].last <= index)


def _lefts(reading: Reading, phrases: list[Phrase], before: list[int], index: int) -> list[int]:
    """Return the rooms on the left: the last one, and those joined to it by "and" where the verb is of several."""
    if not before:
        return []
    lefts = [before[-1]]
    both = reading.word(index - 1) == "both"
    if len(before) > 1 and _is_plural_subject(reading, phrases[before[-2]], phrases[before[-1]]):
        return before[-2:]
    for number in reversed(before[:-1]):
        between = reading.words(phrases[number].last, phrases[lefts[-1]].first)
        if (
            "nor" in between
            or (both and set(between) <= {"and", "the", "a", "an"})
            or ("or" in between and "," not in between)
        ):
            lefts.append(number)
            continue
        break
    return lefts[::-1]


def _is_plural_subject(reading: Reading, one: Phrase, other: Phrase) -> bool:
    """Whether two rooms are what a clause in the plural is about: "A and B have no wall in common with C"."""
    if set(reading.words(one.last, other.begin)) - {"the", "a"} != {"and"} or reading.word(other.last) not in _PLURALS:
        return False
    return reading.starts(min(one.first, one.begin - (one.determiner == "the"))) or one.determiner == "both"


_PLURALS = frozenset({"have", "are", "adjoin", "share", "do", "touch", "lie", "stand", "border", "must", "should"})
"""Verbs of a subject in the plural; "must" and "should" where two rooms open the sentence."""


def _right(reading: Reading, phrases: list[Phrase], rooms: list[int], last: int) -> list[int]:
    """Return the rooms right after a relation: one, and those joined to it by "and the"."""
    following = list(_in_sentence(reading, phrases, rooms, last, before=False)) if last < len(reading.tokens) else []
    if not following or phrases[following[0]].begin - last > 5:
        return []
    if reading.breaks(last - 1) or any(
        word in (",", ":", ")", "with", "and") for word in reading.words(last, phrases[following[0]].first)
    ):
        return []
    rights = [following[0]]
    if len(following) > 1:
        first, second = (phrases[number] for number in following[:2])
        joined = reading.words(first.last, second.begin) in (("and",), ("and", "the"), ("and", "to", "the"))
        ends = reading.breaks(second.last) or reading.word(second.last) in (",", ")")
        if joined and ends and first.determiner in ("the", "both") and second.determiner in ("the", ""):
            rights.append(following[1])
    return rights


def _with_alternatives(reading: Reading, phrases: list[Phrase], rooms: list[int], rights: list[int]) -> list[int]:
    """Return the rooms that another is to be apart from, with those that "or" adds: "not next to A, B or C"."""
    following = [n for n in rooms if rights and n > rights[-1]]
    listed = list(rights)
    for number in following:
        gap = reading.words(phrases[listed[-1]].last, phrases[number].begin)
        if reading.sentence[phrases[number].first] != reading.sentence[phrases[listed[0]].first]:
            break
        if not gap or not set(gap) <= {",", "or", "nor", "the", "any", "to", "on", "with", "from"}:
            break
        listed.append(number)
        if not {"or", "nor"}.isdisjoint(gap):
            return listed
    return rights


def _between(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int) -> tuple[Relation, int] | None:
    alone = reading.word(index - 1) == "in" and (reading.breaks(index + 1) or reading.word(index + 1) in (",", ")"))
    if alone or reading.word(index + 1) == "them" or reading.words(index + 1, index + 3) == ("the", "two"):
        unread = reading.kind(index + 3) == "word" and index + 3 not in reading.taken
        elided = reading.word(index + 2) == "two" and not (unread and reading.word(index + 3) not in FUNCTION_WORDS)
        last = index + 2 - alone + (elided and not alone)
        return _between_them(phrases, [n for n in rooms if phrases[n].last <= index], index, last)
    following = _in_sentence(reading, phrases, rooms, index, before=False)[:2]
    before = _in_sentence(reading, phrases, rooms, index, before=True)
    if not following or not before or (reading.kind(index + 1) == "number" and not phrases[following[0]].plural):
        return None
    if len(following) > 1 and "and" not in reading.words(phrases[following[0]].last, phrases[following[1]].first):
        following = following[:1]
    if phrases[following[0]].first - index > 4:
        return None
    lefts = (before[-1],)
    if len(following) == 1 and not phrases[following[0]].plural:
        return None
    # One room between two: both are its neighbours, so each is a pair of its own.
    return Relation(lefts * len(following), tuple(following), False, index, index + 1), phrases[following[-1]].last


def _wall_between(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int) -> tuple[Relation, int] | None:
    """Read "no common wall between the bedroom and the kitchen"; a wall that is not shared only parts the two."""
    if reading.word(index - 1) not in ("common", "shared", "party"):
        return None
    them = reading.word(index + 2) in ("them", "both") or reading.words(index + 2, index + 4) in _THE_TWO
    if them:
        named = _in_sentence(reading, phrases, rooms, index, before=True)[-2:]
        last = index + 3 + (reading.word(index + 3) == "two")
        if len(named) < 2:
            return None
        return Relation((named[0],), (named[1],), _negated(reading, phrases, rooms, index - 1), index - 1, last), last
    pair = _in_sentence(reading, phrases, rooms, index, before=False)[:2]
    if len(pair) < 2 or phrases[pair[0]].begin - index > 4:
        return None
    if "and" not in reading.words(phrases[pair[0]].last, phrases[pair[1]].first):
        return None
    negated = _negated(reading, phrases, rooms, index - 1)
    return Relation((pair[0],), (pair[1],), negated, index - 1, index + 2), phrases[pair[1]].last


_THE_TWO = (("the", "two"), ("these", "two"), ("those", "two"))
"""Words for two rooms that are named before."""


def _between_them(phrases: list[Phrase], before: list[int], index: int, last: int) -> tuple[Relation, int] | None:
    """Read "two bedrooms, the bathroom is between them" and "a bedroom, a bathroom, a cupboard between them"."""
    if len(before) < 2:
        return None
    subject, others = before[-1], before[:-1]
    several = [n for n in others if (phrases[n].count or 2) > 1]
    if phrases[others[-1]].count == 1 and len(others) > 1 and not (several and several[-1] == others[-1]):
        return Relation((subject, subject), tuple(others[-2:]), False, index, last), last
    owner = several[-1] if several else others[-1]
    return Relation((subject,), (owner,), False, index, last), last


def _postposed(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int, last: int) -> Relation | None:
    """Read "live room, control room adjacent": the room before is meant."""
    before = _in_sentence(reading, phrases, rooms, index, before=True)
    side = reading.word(index) in ("adjacent", "adjoining", "attached", "beside", "alongside", "next", "at")
    if len(before) < 2 or not side:
        return None
    if phrases[before[-1]].last != index:
        return None
    return Relation((before[-1],), (before[-2],), False, index, last)


def _of_the_two(reading: Reading, first: int, last: int) -> bool:
    """Whether "these two", "the two rooms" or "they" stand between rooms and what is said of them both."""
    words = reading.words(first, last)
    return "they" in words or any(
        pair in (("these", "two"), ("the", "two"), ("those", "two")) for pair in itertools.pairwise(words)
    )


def _mutual(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int, last: int) -> Relation | None:
    before = _in_sentence(reading, phrases, rooms, index, before=True)
    if not before:
        return None
    pair = before[-2:]
    if len(pair) == 1:
        if not phrases[pair[0]].plural and phrases[pair[0]].count in (1, None):
            return None
        pair = pair * 2
    elif (
        phrases[pair[-1]].counted
        and (phrases[pair[-1]].count or 0) > 1
        and phrases[pair[-1]].determiner in ("the", "both", "these")
    ):
        pair = [pair[-1]] * 2
    elif not (
        set(reading.words(phrases[pair[0]].last, phrases[pair[1]].first)) & {"and", "with", "or", "plus", "&"}
        or _of_the_two(reading, phrases[pair[1]].last, index)
    ):
        return None
    negated = _negated(reading, phrases, rooms, index)
    return Relation((pair[0],), (pair[1],), negated, index, last)
