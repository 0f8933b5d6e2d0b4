"""Find what a brief says of things outside the building, and of itself: names, places, calls, versions and labels.

"In the Alps", "at 2,600 m altitude", "the campus one is across the street", "my budget is small", "the first draft",
"label them so": none of them asks for anything that the building could have. Rooms, things, materials and styles are no
such remarks whatever stands around them.
"""

from collections.abc import Iterator

from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.idle_words import is_idle_word
from mansion_planner.brief.other_places import away_end
from mansion_planner.brief.persons import is_person
from mansion_planner.brief.phrase import FUNCTION_WORDS
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["remark_tokens"]


def remark_tokens(reading: Reading) -> Iterator[int]:
    """Yield the tokens of remarks of which no statement was made."""
    for index in range(len(reading.tokens)):
        if index in reading.taken:
            continue
        yield from _far_place(reading, index)
        yield from _introduction(reading, index)
        yield from _title(reading, index)
        yield from _subject_studied(reading, index)
        yield from _altitude(reading, index)
        yield from _call(reading, index)
        yield from _version(reading, index)
        yield from _part_of_game(reading, index)
        yield from _label(reading, index)
        yield from _predicate_of_affair(reading, index)
        yield from _weather(reading, index)
        yield from _need(reading, index)
        yield from _clients(reading, index)
        yield from _own_room(reading, index)
        yield from _sum_of_list(reading, index)
        yield from _sharing(reading, index)
    yield from _elsewhere(reading)


def _is_name(reading: Reading, index: int) -> bool:
    """Whether a token is a proper name of nothing that a building has."""
    word = reading.word(index)
    return (
        index < len(reading.tokens)
        and reading.kind(index) == "word"
        and reading.tokens[index].capital
        and not reading.starts(index)
        and index not in reading.mention_at
        and index not in reading.taken
        and word not in FLOOR_WORDS
        and not furniture_of((word,))[0]
    )


_AT = frozenset({"in", "at", "near", "on", "from", "to", "outside", "above", "below", "of", "by"})


def _far_place(reading: Reading, index: int) -> Iterator[int]:
    """Yield the name of a place: "in the Alps", "on Skye"."""
    if not _is_name(reading, index):
        return
    before, end = index - 1 - (reading.word(index - 1) == "the"), index + 1
    while _is_name(reading, end):
        end += 1  # "the Black Forest"
    closes = reading.breaks(end) or reading.word(end) in (",", ":", ")", "with", "for", "and", "in")
    if reading.word(before) in _AT and closes and index > 1:
        yield from range(before, end)


def _introduction(reading: Reading, index: int) -> Iterator[int]:
    """Yield who writes: "my name is Petra"."""
    if reading.words(index, index + 2) == ("name", "is") and reading.word(index - 1) in ("my", "our"):
        yield from range(index, index + 3 + _is_name(reading, index + 3))


def _title(reading: Reading, index: int) -> Iterator[int]:
    """Yield the name that the building is given: "a hostel called The Drowsy Otter"."""
    ends = {span.end for _, span in reading.facts.building if span.words}
    if reading.word(index) in ("called", "call", "named", "name") and reading.tokens[index - 1].end in ends:
        end = index + 1 + (reading.word(index + 1) in ("the", "a"))
        while _is_name(reading, end):
            end += 1
        yield from range(index, end)


_FIELDS = frozenset({"department", "faculty", "chair", "ministry", "division"})


def _subject_studied(reading: Reading, index: int) -> Iterator[int]:
    """Yield who is at home in a building whose kind is told: "Department of Linguistics, a university"."""
    told = any(span.words for _, span in reading.facts.building)
    if told and reading.word(index) in _FIELDS and reading.word(index + 1) == "of":
        end = index + 2
        while end < len(reading.tokens) and reading.tokens[end].capital and end not in reading.taken:
            end += 1
        if end > index + 2:
            yield from range(index, end)


def _altitude(reading: Reading, index: int) -> Iterator[int]:
    """Yield how high above the sea a building stands: "at 2,600 m altitude"."""
    if reading.kind(index) == "number" and reading.word(index + 2) in _HEIGHTS:
        yield from range(index, index + 3)
    elif reading.kind(index) == "number" and reading.words(index + 2, index + 4) == ("above", "sea"):
        yield from range(index, index + 5)


_HEIGHTS = frozenset({"altitude", "elevation", "asl"})
_CALLING = frozenset({"call", "dial", "phone", "ring"})


def _call(reading: Reading, index: int) -> Iterator[int]:
    """Yield a number that is dialled, with when: "112 calls", "dial 911 when in doubt"."""
    if reading.kind(index) != "number":
        return
    if reading.word(index + 1) == "call":
        yield index
    elif reading.word(index - 1) in _CALLING and reading.starts(index - 1):
        end = index + 1
        while not reading.breaks(end) and end not in reading.taken:
            end += 1
        yield from range(index, end)


_VERSIONS = frozenset({"draft", "post", "plan", "version", "sketch", "attempt", "idea", "try", "proposal", "message"})


def _part_of_game(reading: Reading, index: int) -> Iterator[int]:
    """Yield what game the building is a part of: "I'm building a horror game level"."""
    if reading.word(index) != "game" or reading.word(index + 1) not in (
        "level",
        "map",
        "scene",
        "world",
        "environment",
    ):
        return
    first = index
    while reading.kind(first - 1) == "word" and reading.word(first - 1) not in FUNCTION_WORDS:
        first -= 1
    yield from range(first, index + 2)


def _version(reading: Reading, index: int) -> Iterator[int]:
    """Yield which version of a text or plan this is: "in the first draft", "at first I wanted", "sorry, wrong form"."""
    if reading.kind(index) == "ordinal" and reading.word(index + 1) in _VERSIONS and index + 1 not in reading.taken:
        yield from (index, index + 1)
    elif reading.words(index - 1, index + 1) == ("at", "first") and reading.word(index + 1) not in FLOOR_WORDS:
        yield index
    elif reading.words(index, index + 2) in (("wrong", "form"), ("wrong", "list"), ("wrong", "thread")):
        yield from (index, index + 1)


_OF_DRAWINGS = frozenset(
    {("in", "the", "drawing"), ("on", "the", "drawing"), ("write", "the", "name"), ("put", "the", "name")}
)


def _label(reading: Reading, index: int) -> Iterator[int]:
    """Yield what is said of names themselves: "label them so", "its own names for rooms", "name it Hotel Schnauz"."""
    word = reading.word(index)
    if word in ("label", "name", "call") and reading.word(index + 1) in ("it", "them"):
        end = index + 2
        while _is_name(reading, end):
            end += 1
        yield from range(index, end)
    elif word == "name" and reading.words(index + 1, index + 3) == ("for", "room"):
        yield from range(index, index + 3)
    elif (*reading.words(index - 2, index), word) in _OF_DRAWINGS:
        yield index


_AFFAIRS = frozenset("budget time taste timing schedule money price rent deadline plot site".split())


def _predicate_of_affair(reading: Reading, index: int) -> Iterator[int]:
    """Yield what is said of the writer's affairs: "my budget is small"."""
    if (
        reading.word(index) in _AFFAIRS
        and reading.word(index - 1) in ("my", "our", "the")
        and reading.word(index + 1) in ("is", "are")
    ):
        end = index + 2
        while end < index + 5 and reading.kind(end) == "word" and end not in reading.taken:
            end += 1
        if reading.breaks(end) or reading.word(end) in (",", ":", "so", ")"):
            yield from range(index, end)


def _weather(reading: Reading, index: int) -> Iterator[int]:
    """Yield the climate with the word before it: "for hot climate"."""
    if reading.word(index) in ("climate", "weather"):
        if reading.kind(index - 1) == "word" and reading.word(index - 1) not in FUNCTION_WORDS:
            yield index - 1
        yield index


def _need(reading: Reading, index: int) -> Iterator[int]:
    """Yield what something is needed for: "a goods lift is needed for the sets"."""
    if reading.word(index) != "for" or reading.word(index - 1) not in ("needed", "need", "necessary", "required"):
        return
    end = index + 1
    while end - index < 5 and reading.kind(end) == "word" and end not in reading.taken:
        end += 1
    if index - 2 in reading.taken | {-1} or reading.word(index - 2) in ("is", "are", "be"):
        closes = reading.breaks(end) or reading.word(end) in (",", ")")
        yield from range(index, end if closes else index)


def _clients(reading: Reading, index: int) -> Iterator[int]:
    """Yield for whom a building is, right after its kind: "a shelter for women with children"."""
    ends = {span.end for _, span in reading.facts.building if span.words}
    if reading.word(index) != "for" or not index or reading.tokens[index - 1].end not in ends:
        return
    end = index + 1
    while _is_client(reading, end) or (reading.word(end) in ("with", "and", "or") and _is_client(reading, end + 1)):
        end += 1
    if end > index + 1 and (reading.breaks(end) or reading.word(end) in (",", ":", ")", "on", "in", "with")):
        yield from range(index, end)


_CLIENTS = frozenset({"woman", "man", "boy", "girl", "teen", "teenager", "elderly", "people", "child", "student"})


def _is_client(reading: Reading, index: int) -> bool:
    word = reading.word(index)
    return reading.kind(index) == "word" and index not in reading.taken and (word in _CLIENTS or is_person(word))


_OWN = frozenset({("in", "its", "own"), ("in", "their", "own"), ("in", "a", "separate")})


def _own_room(reading: Reading, index: int) -> Iterator[int]:
    """Yield the room that a room is itself, or any: "a learner pool in its own room", "no rug in any room"."""
    before = reading.words(index - 3, index)
    if reading.word(index) == "room" and (before in _OWN or before[1:] == ("in", "any")):
        yield index


def _sum_of_list(reading: Reading, index: int) -> Iterator[int]:
    """Yield the number of rooms that a sentence then lists, if it lists as many: "five rooms, namely ..."."""
    told = reading.kind(index) == "number" and reading.word(index + 1) == "room"
    if not told or reading.word(index + 2) not in (",", ":", "(", "-", "–", "namely"):
        return
    ends = [at for at in range(index, len(reading.tokens)) if reading.sentence[at] == reading.sentence[index]]
    first, last = reading.tokens[index + 1].end, reading.tokens[ends[-1]].end
    listed = [room.count or 1 for room in reading.facts.rooms if first < room.span.start < last]
    if sum(listed) == reading.value(index):
        yield from (index, index + 1)


_SHARED_WHOLE = frozenset("house flat home building apartment place maisonette".split())


def _sharing(reading: Reading, index: int) -> Iterator[int]:
    """Yield the verb where people share the whole, or what was named: "we share a house", "a kitchen we share"."""
    if reading.word(index) != "share":
        return
    whole = reading.word(index + 1) in ("a", "the", "this", "our") and reading.word(index + 2) in _SHARED_WHOLE
    named = reading.word(index - 1) in ("we", "they") and (reading.breaks(index + 1) or reading.word(index + 1) == ",")
    if whole or named:
        yield index
    if whole and index + 2 not in reading.taken:
        yield index + 2


def _elsewhere(reading: Reading) -> Iterator[int]:
    """Yield the clauses about what stands elsewhere: "the campus one is across the street"."""
    for index in range(len(reading.tokens)):
        end = away_end(reading, index)
        if not end:
            continue
        first = _start_of_clause(reading, index)
        words = reading.words(first, index)
        if not {"is", "are", "there's", "there"}.isdisjoint(words) and _tells_of_others(reading, first, index):
            yield from range(first, end)


def _start_of_clause(reading: Reading, index: int) -> int:
    while index > 0 and not reading.starts(index) and reading.word(index - 1) not in (",", ";", ":", "(", "–", "-"):
        index -= 1
    return index


def _tells_of_others(reading: Reading, first: int, last: int) -> bool:
    """Whether nothing was read in a clause, and no word of it belongs to the building."""
    taken = any(at in reading.taken for at in range(first, last))
    ours = {"it", "this", "which", "that", "entrance", "access", "view"}
    return (
        not taken
        and ours.isdisjoint(reading.words(first, last)[:1])
        and not all(is_idle_word(word) for word in reading.words(first, last))
    )
