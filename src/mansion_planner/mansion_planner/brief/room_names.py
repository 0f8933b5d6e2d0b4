"""Read what rooms are called beyond their kind: numbers, what they are for, and kinds that nobody knows."""

from collections.abc import Mapping
from dataclasses import replace

from mansion_language import singular
from mansion_planner.brief.lexicon import Mention, lexicon_of
from mansion_planner.brief.list_entries import LIST_STARTS, NO_ROOMS
from mansion_planner.brief.phrase import FUNCTION_WORDS, PEOPLE, PLAIN, Phrase
from mansion_planner.brief.qualifiers import taken_for_its_head
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.room_users import PEOPLE_APART, one_of
from mansion_planner.brief.similarity import HEAD_TYPES, elliptic_room_type, similar_room_type, told_room_type

__all__ = [
    "CONTRASTS",
    "coordinated",
    "designated_nouns",
    "told_by_its_words",
    "with_designators",
    "with_purpose",
    "with_sizes",
]


def coordinated(reading: Reading, chunks: list[tuple[int, int]], phrase: Phrase) -> list[Phrase]:
    """Read "chemistry and physics labs" and "men's and women's changing rooms" as a room of each kind."""
    shared = _with_both_modifiers(reading, chunks, phrase)
    if shared is not None:
        return [shared]
    if (
        phrase.head != "room"
        or not phrase.plural
        or phrase.noun_end - phrase.begin < 2
        or phrase.count not in (None, 2)
    ):
        return [phrase]
    if phrase.counted or phrase.first != phrase.begin or reading.word(phrase.begin - 1) not in ("and", "&"):
        return [phrase]
    other = next(((a, b) for a, b in chunks if b == phrase.begin - 1), None)
    if other is None or not reading.free(*other) or not 1 <= other[1] - other[0] <= 2:
        return [phrase]
    before = reading.word(other[0] - 1)
    if not (reading.starts(other[0]) or before in LIST_STARTS) or reading.word(other[1] - 1) in NO_ROOMS | PLAIN:
        return [phrase]
    head = reading.word(phrase.noun_end - 1)
    first = "_".join([*reading.words(*other), head])
    label = f"{reading.span(*other).words} {singular(head)}"
    reading.take(*other)
    kind = similar_room_type(first, reading.knowledge)
    room_type = kind if kind != "study_room" else phrase.room_type
    return [
        replace(one_of(phrase, *other), name=first[:60], label=label, room_type=room_type),
        replace(phrase, count=1, counted=True, plural=False),
    ]


def _with_both_modifiers(reading: Reading, chunks: list[tuple[int, int]], phrase: Phrase) -> Phrase | None:
    """Return one room with all that it is called after: "a tools and pots shop"; nothing for other phrases."""
    if phrase.head != "room" or phrase.plural or phrase.first != phrase.begin or phrase.noun_end - phrase.begin < 2:
        return None
    if reading.word(phrase.begin - 1) not in ("and", "&"):
        return None
    first = next((a for a, b in chunks if b == phrase.begin - 1 and b - a == 1 and reading.free(a, b)), None)
    if first is None or not reading.plural(first) or reading.word(first - 1) not in ("a", "an", "one"):
        return None
    reading.take(first - 1, phrase.last)
    name = f"{reading.word(first)}_and_{phrase.name}"[:60]
    label = reading.span(first, phrase.noun_end).words
    return replace(phrase, first=first - 1, begin=first, name=name, label=label, determiner="a")


def designated_nouns(reading: Reading) -> frozenset[str]:
    """Return the nouns that a brief tells apart by numbers or letters: "Bedroom 1 ... Bedroom 2", "Studio A"."""
    found: dict[tuple[str, str], set[str]] = {}
    for index in range(1, len(reading.tokens)):
        length = _designator(reading, index)
        noun = reading.tokens[index - 1]
        if length and noun.kind == "word" and noun.text not in FUNCTION_WORDS and noun.text not in FLOOR_WORDS:
            key = noun.text, _kind_of_room(reading, index - 1)
            found.setdefault(key, set()).add("".join(reading.words(index, index + length)))
            if _next_designator(reading, index + length) or _lettered(reading, index, length):
                found[key].add("more")
    apart = [noun for noun, names in _named_apart(reading).items() if len(names) > 1]
    return frozenset([*apart, *(noun for (noun, _), names in found.items() if len(names) > 1)])


def _kind_of_room(reading: Reading, index: int) -> str:
    """Return which kind of room "room" at a token names: rooms of several kinds are not told apart by numbers."""
    before = reading.word(index - 1)
    named = reading.word(index) == "room" and reading.kind(index - 1) == "word"
    return before if named and before not in FUNCTION_WORDS else ""


def _named_apart(reading: Reading) -> dict[str, set[str]]:
    """Return room nouns with the proper names after them, where a brief tells several so: "Courtroom Alder"."""
    names: dict[str, set[str]] = {}
    for index in range(1, len(reading.tokens)):
        noun = reading.tokens[index - 1]
        if not _proper(reading, index) or noun.kind != "word" or noun.plural:
            continue
        if noun.text in HEAD_TYPES or noun.text == "screen" or reading.mention_at.get(index - 1, _NOTHING).room:
            names.setdefault(noun.text, set()).add(reading.word(index))
    return {noun: found for noun, found in names.items() if len(found) > 1}


def _proper(reading: Reading, index: int) -> int:
    """Return how many tokens a proper name has that begins at a token, or 0."""
    token = reading.tokens[index] if index < len(reading.tokens) else None
    if token is None or index in reading.taken or index in reading.mention_at or not token.capital:
        return 0
    written = reading.text[token.start : token.end]
    spelt = token.kind == "number" and token.text.isalpha()
    if (token.kind != "word" and not spelt) or len(written) < 3 or written.isupper():
        return 0
    if token.text in FUNCTION_WORDS | FLOOR_WORDS | PLAIN | HEAD_TYPES.keys() or reading.starts(index):
        return 0
    return 1


def _lettered(reading: Reading, index: int, length: int) -> bool:
    """Whether "2B" or a final "A" is a name by itself, and "1 to 6" are several."""
    return length == 2 or bool(_range_end(reading, index)) or (reading.kind(index) == "word" and _ends(reading, index))


def _ends(reading: Reading, index: int) -> bool:
    following = reading.tokens[index + 1] if index + 1 < len(reading.tokens) else None
    return following is None or following.kind == "mark" or following.text in _AFTER_DESIGNATOR


def _range_end(reading: Reading, index: int) -> int:
    """Return the last number of the designators "1 to 6" that begin at a token, or 0."""
    if reading.word(index + 1) not in ("to", "–", "through") or not reading.plural(index - 1):
        return 0
    first, last = reading.value(index), reading.value(index + 2)
    numbers = reading.kind(index) == reading.kind(index + 2) == "number" and 0 < first < last <= first + 40
    return int(last) if numbers and last == int(last) and _ends(reading, index + 2) else 0


def _range_to(reading: Reading, index: int) -> bool:
    """Whether "1 to 4" stands at a token."""
    first, last = reading.value(index), reading.value(index + 2)
    return reading.word(index + 1) in ("to", "–", "through", "-") and 0 < first < last <= first + 60


def _designator(reading: Reading, index: int) -> int:
    """Return how many tokens a designator has ("2", "B", "2B"), or 0."""
    token = reading.tokens[index] if index < len(reading.tokens) else None
    if token is None or index in reading.taken:
        return 0
    if token.kind == "number":
        if token.value != int(token.value) or not 0 < token.value < 100 or token.text.isalpha():
            return 0
        following = reading.tokens[index + 1] if index + 1 < len(reading.tokens) else None
        if following is not None and following.kind == "word" and not following.spaced:
            return 2 if len(following.text) == 1 else 0
        if following is not None and following.text in ("to", "through"):
            return int(bool(_range_end(reading, index)))
        ends = following is None or following.kind == "mark" or index + 1 in reading.taken
        return int(ends or (following is not None and following.text in _AFTER_DESIGNATOR))
    written = reading.text[token.start : token.end]
    return int(token.kind == "word" and len(written) == 1 and written.isupper() and written != "I")


def _next_designator(reading: Reading, index: int) -> int:
    """Return where "2B" begins in "class 2A, 2B and 2C" after the first, or 0."""
    step = 2 if reading.words(index, index + 2) == (",", "and") else int(reading.word(index) in (",", "and", "&"))
    length = _designator(reading, index + step) if step else 0
    letter = length == 2 or (length == 1 and reading.kind(index + step) == "word")
    return index + step if letter else 0


def with_designators(
    reading: Reading, phrase: Phrase, nouns: frozenset[str], counted: Mapping[str, int]
) -> list[Phrase]:
    """Read "Bedroom 1" and "class 1A and 1B" as rooms of these names, or as one of those that are `counted` before."""
    noun = reading.word(phrase.noun_end - 1)
    number = phrase.noun_end + 1
    if phrase.head == "room" and reading.word(number - 1) == "numbered" and _range_to(reading, number):
        last = number + 3
        reading.take(number - 1, last)
        count = int(reading.value(last - 1) - reading.value(number)) + 1
        return [replace(phrase, count=count, counted=True, last=last)]
    if phrase.head not in ("room", "building") or phrase.counted or noun not in nouns:
        return [phrase]
    named = _designator(reading, phrase.noun_end) or _proper(reading, phrase.noun_end)
    if phrase.building and noun in HEAD_TYPES and named:
        phrase = replace(phrase, head="room", building="", room_type=HEAD_TYPES[noun])
    if counted.get(phrase.name, len(reading.tokens)) < phrase.first and not _proper(reading, phrase.noun_end):
        length = _designator(reading, phrase.noun_end)
        reading.take(phrase.noun_end, phrase.noun_end + length)
        return [replace(phrase, determiner="the", last=phrase.noun_end + length)]
    found, index = [], phrase.noun_end
    first = phrase.first
    final = _range_end(reading, index)
    if final and not phrase.counted:
        reading.take(index, index + 3)
        return [replace(phrase, count=final - int(reading.value(index)) + 1, counted=True, last=index + 3)]
    while index:
        length = _designator(reading, index) or _proper(reading, index)
        if not length:
            break
        end = index + length
        figure = length == 1 and reading.kind(index) == "number" and reading.word(index).isdigit()
        own = reading.word(index) if figure else reading.span(index, end).words
        reading.take(index, end)
        room = one_of(phrase, first, end)
        found.append(replace(room, name=f"{phrase.name}_{own.lower()}", label=f"{phrase.label} {own}", counted=False))
        index = first = _next_designator(reading, end)
    return found or [phrase]


_AFTER_DESIGNATOR = frozenset("and with has have is are on in at next of which for".split())

_PURPOSEFUL = frozenset(
    """
    room store storage workshop hall area space shop studio office lab cellar storeroom corner atelier zone
    post reserve depot
    """.split()
)


CONTRASTS = frozenset("big large small little main mini secondary".split())
"""Adjectives that tell two rooms of a kind apart."""


def with_sizes(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Tell rooms apart by their size where a brief names two of a kind so: "big studio ... small studio"."""

    def size_of(phrase: Phrase) -> str:
        words = [reading.word(at) for at in range(phrase.begin, phrase.noun_end)]
        own = [word for word in words if word in CONTRASTS and word not in phrase.name.split("_")]
        return own[0] if phrase.head in ("room", "building") and phrase.room_type and own else ""

    sizes: dict[str, set[str]] = {}
    for phrase in phrases:
        if size_of(phrase):
            sizes.setdefault(phrase.name, set()).add(size_of(phrase))
    apart = {name for name, found in sizes.items() if len(found) > 1}
    return [
        replace(phrase, name=f"{size_of(phrase)}_{phrase.name}") if phrase.name in apart and size_of(phrase) else phrase
        for phrase in phrases
    ]


_NOTHING = Mention(0, 0)


def _is_name(reading: Reading, index: int) -> bool:
    """Whether what follows "of" tells whose it is, rather than how much: "the office of the director"."""
    return reading.kind(index) == "word" and reading.word(index) not in _MEASURING


_MEASURING = frozenset("about around approximately approx roughly nearly at up over under several some".split())


_RESIDENTS = frozenset("grandmother grandfather grandma grandpa granny mother father mum dad son daughter".split())
"""Those of a family who sleep in the rooms that are theirs."""
_ROOMED = frozenset({"child", "kid", "guest"})
"""Those whose rooms are called after them: "three rooms for children"."""


def with_purpose(reading: Reading, phrase: Phrase) -> Phrase:
    """Add what a room is for to its name: "a room for the bicycles" is a bicycle room."""
    last = phrase.last
    owned = reading.word(last) == "of" and _is_name(reading, last + 1)
    if phrase.head == "building" and phrase.name == "office" and owned:
        phrase = replace(phrase, head="room", building="", room_type="private_office")  # "the office of the director"
    if (
        phrase.head != "room"
        or reading.word(phrase.noun_end - 1) not in _PURPOSEFUL
        or reading.word(last) not in ("for", "of")
    ):
        return phrase
    after = reading.word(last + 1 + (reading.word(last + 1) in ("the", "our")))
    if reading.word(last) == "of" and phrase.noun_end - phrase.begin > 1 and after not in PEOPLE_APART:
        return phrase
    if reading.word(last) == "for" and reading.word(last + 1) in PEOPLE_APART:
        return phrase
    two = reading.word(last + 2) == "and" and reading.plural(last + 1) and reading.plural(last + 3)
    if two and phrase.plural and "separate" in reading.words(phrase.first - 1, phrase.noun_end):
        return phrase  # "separate waiting rooms for cats and dogs"
    begin = last + 1 + (reading.word(last + 1) in ("the", "our", "all", "my", "a"))
    if reading.word(last + 1) in ("our", "my") and reading.mention_at.get(begin, _NOTHING).building:
        return phrase  # "a robotics lab for our institute"
    end = begin
    while end < begin + 3 and reading.kind(end) == "word" and reading.word(end) not in FUNCTION_WORDS:
        end += 1
    if end == begin:
        return phrase
    own_rooms = phrase.counted and end - last == 2 and reading.word(end - 1) in _ROOMED
    if phrase.name == "room" and phrase.plural and reading.word(end - 1) in PEOPLE and not own_rooms:
        return phrase  # "a flat of three rooms for a young family"
    purpose = "_".join(reading.words(begin, end))
    name = f"{purpose}_{phrase.name}"[:60]
    generic = phrase.name in _PURPOSEFUL
    room = (
        similar_room_type(name, reading.knowledge)
        if generic and phrase.name in ("hall", "room", "space", "area", "corner", "zone", "post", "section")
        else phrase.room_type
    )
    left_out = reading.tokens[phrase.begin].start == reading.tokens[phrase.begin].end
    label = reading.span(phrase.begin, end).words
    label = f"{phrase.label} {reading.span(last, end).words}" if left_out else label
    same = _kind_named(reading, begin, end, phrase.name)
    known = bool(same) or phrase.known
    if phrase.name == "room" and reading.word(end - 1) in _RESIDENTS and not own_rooms:
        same, known = "bedroom", True  # "the room of grandmother"
    known = known or bool(own_rooms and elliptic_room_type(reading.words(begin, end), reading.knowledge))
    reading.take(last, end)
    return replace(phrase, name=name, label=label, last=end, room_type=same or room or phrase.room_type, known=known)


def _kind_named(reading: Reading, begin: int, end: int, noun: str) -> str:
    """Return the room type that the lexicon has for a purpose before its noun; empty for none.

    The "hall of the luggage claim" is a luggage claim, the "room for the treatments" a treatment room.
    """
    if noun not in _PURPOSEFUL:
        return ""
    phrases, words = lexicon_of(reading.knowledge).phrases, reading.words(begin, end)
    found = phrases.get((*words, noun)) or (phrases.get(words) if noun == "hall" else None)
    return found.room if found is not None else ""


def told_by_its_words(reading: Reading, phrase: Phrase) -> Phrase:
    """Return a room of an unknown kind as the kind that the words of its name tell: "a bouldering area"."""
    if phrase.head != "room" or not phrase.room_type or (phrase.known and not taken_for_its_head(reading, phrase)):
        return phrase
    told = told_room_type(phrase.name, reading.knowledge)
    return replace(phrase, room_type=told, known=False) if told and told != phrase.room_type else phrase
