"""Read noun phrases: a count, modifiers and a head that names a room, a building, a core, furniture or people.

``[count] modifier* head [(count) | x3 | five of them]``; the head is the longest phrase of the lexicon that ends the
phrase, else a noun that can head a room's name ("honey room"), else a piece of furniture of the asset catalogue.
"""

from dataclasses import replace

from mansion_planner.brief.figurative_nouns import is_figurative, is_modifier
from mansion_planner.brief.furniture_words import furniture_of, own_furniture_of
from mansion_planner.brief.lexicon import Mention, lexicon_of
from mansion_planner.brief.list_entries import listed_unknowns
from mansion_planner.brief.own_names import by_own_name, with_own_names
from mansion_planner.brief.phrase import (
    FUNCTION_WORDS,
    PEOPLE,
    PLAIN,
    UNITS_OF_ROOMS,
    Head,
    Phrase,
    count_after,
    count_before,
    finished_phrase,
    name_of,
)
from mansion_planner.brief.qualifiers import is_property
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.repeated_names import further_ones, room_by_its_contents, rooms_named_again
from mansion_planner.brief.room_names import coordinated, designated_nouns, with_designators, with_purpose, with_sizes
from mansion_planner.brief.room_users import with_users, with_users_before
from mansion_planner.brief.rooms_of_staff import OFFICE_HOLDERS, with_rooms_of_staff
from mansion_planner.brief.similarity import HEAD_TYPES, room_of_building, similar_room_type, told_room_type
from mansion_planner.brief.sizes import is_size

__all__ = ["noun_phrases"]

_STAIRS = frozenset({"stair", "staircase", "stairwell", "stairway", "stairs"})
_LIFTS = frozenset({"lift", "elevator"})
_FURNITURE_TOO = frozenset({"locker", "stall"})
"""Nouns that name a room, and furniture after certain words: a bedside locker, a milking stall."""
_CARRIED = frozenset({"luggage", "bag", "coat", "gear", "equipment", "helmet", "parcel", "book", "tool", "storage"})
"""What lockers are for, where they are furniture and no changing room."""
_EQUIPMENT = frozenset(
    {
        ("emergency", "shower"),
        ("safety", "shower"),
        ("drench", "shower"),
        ("birthing", "pool"),
        ("birth", "pool"),
        ("grab", "bar"),
        ("towel", "bar"),
        ("wall", "bar"),
        ("breakfast", "bar"),
    }
)
"""What stands in a room, though its noun alone names a room."""
_VERBAL_MODIFIERS = frozenset(
    """
    live touch sleep cook sit meet walk measuring making serving meeting sharing reading facing opening making share
    sit stand look talk play round
    """.split()
)
_PARTS = frozenset("roof window door wall ceiling view light equipment furniture roofed".split())
"""Nouns that make a room before them their modifier: "flat roof", "kitchen window"."""
_FURNITURE = frozenset("desk lane checkout till counter workstation register bed seat chair".split())
"""Nouns that name a room where there is one of it ("check-in desk"), and furniture where there are many."""
_SUPERLATIVES = frozenset("largest biggest smallest only same best first last next whole entire".split())
_NO_HEADS = frozenset({"area", "space", "section", "zone", "corner", "place", "center", "centre"})


def noun_phrases(reading: Reading) -> list[Phrase]:
    """Return the noun phrases among the tokens that are not read yet, from left to right; their tokens are taken."""
    phrases: list[Phrase] = []
    chunks = _chunks(reading)
    for begin, end in chunks:
        phrases += _phrases_of(reading, begin, end)
    phrases = with_users_before(reading, phrases)
    phrases = [part for phrase in phrases for part in coordinated(reading, chunks, phrase)]
    numbered = designated_nouns(reading)
    counted = {phrase.name: phrase.first for phrase in phrases[::-1] if phrase.counted and (phrase.count or 0) > 1}
    phrases = [part for phrase in phrases for part in with_designators(reading, phrase, numbered, counted)]
    phrases = _with_own_names(reading, phrases)
    phrases = [_room_of_goods(reading, phrases, phrase) for phrase in with_rooms_of_staff(reading, phrases)]
    phrases += _with_own_names(reading, listed_unknowns(reading, chunks, phrases))
    phrases = [room_by_its_contents(reading, phrases, phrase) for phrase in phrases]
    phrases += rooms_named_again(reading, chunks, phrases)
    phrases += further_ones(reading, phrases)
    phrases = with_users(reading, phrases)
    return sorted(by_own_name(reading, with_sizes(reading, phrases)), key=lambda phrase: phrase.first)


def _room_of_goods(reading: Reading, phrases: list[Phrase], phrase: Phrase) -> Phrase:
    """Return the store that a list of rooms names by its goods alone: "dirty utility, linen, relatives' lounge"."""
    bare = phrase.head == "object" and not (phrase.counted or phrase.determiner or phrase.plural)
    if not bare or reading.words(phrase.begin, phrase.noun_end) not in _GOODS or reading.word(phrase.begin - 1) != ",":
        return phrase
    before = any(p.head == "room" and p.last == phrase.begin - 1 for p in phrases)
    after = any(p.head == "room" and p.begin == phrase.last + 1 for p in phrases)
    if not (before and after and reading.word(phrase.last) in (",", "and")):
        return phrase
    return replace(phrase, head="room", room_type="storage", category="", known=False)


_GOODS = frozenset({("linen",), ("luggage",), ("equipment",), ("mail",), ("wine",), ("medication",), ("archive",)})
"""Things that a room is called after where they are kept."""


def _with_own_names(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return the phrases under the names that the brief gives to rooms; what those names hold is no phrase."""
    found: list[Phrase] = []
    for phrase in sorted(phrases, key=lambda phrase: phrase.first):
        if found and phrase.first < found[-1].last:
            continue
        found += with_own_names(reading, with_purpose(reading, phrase))
    return found


def _chunks(reading: Reading) -> list[tuple[int, int]]:
    """Return the runs of content words that no function word, number or mark interrupts."""
    inside = _inside_mentions(reading)
    chunks, begin = [], -1
    for index in range(len(reading.tokens) + 1):
        content = (
            index < len(reading.tokens)
            and index not in reading.taken
            and reading.kind(index) == "word"
            and (
                reading.word(index) not in FUNCTION_WORDS
                or index in inside
                or _hyphenated(reading, index)
                or _is_acronym(reading, index)
                or _is_modifier(reading, index)
            )
            and (reading.word(index) not in FLOOR_WORDS or _leads_thing(reading, index))
            and reading.words(index, index + 3) != ("wall", "to", "wall")
        )
        glued = (
            index < len(reading.tokens) - 1
            and index not in reading.taken
            and reading.kind(index) == "number"
            and (not reading.tokens[index + 1].spaced or reading.tokens[index].soft)
            and reading.word(index + 1) in UNITS_OF_ROOMS | {"height"}
            and begin >= 0
        )
        named = (
            begin >= 0
            and reading.kind(index) == "number"
            and index not in reading.taken
            and not reading.tokens[index].spaced
            and reading.kind(index + 1) == "word"
            and reading.kind(index - 1) == "word"
        )
        glued = glued or named
        if begin >= 0 and _postposed(reading, index):
            chunks.append((begin, index))
            begin = -1
        soft = content or (index < len(reading.tokens) and index not in reading.taken and index in inside)
        if soft or glued:
            begin = index if begin < 0 else begin
        elif begin >= 0:
            chunks.append((begin, index))
            begin = -1
    return chunks


def _leads_thing(reading: Reading, index: int) -> bool:
    """Whether a word for a storey begins the name of a thing: "floor lamp", "deck oven"."""
    return furniture_of(reading.words(index, index + 2))[1] > 1


def _postposed(reading: Reading, index: int) -> bool:
    """Whether a bathroom is named right after the rooms that have it: "three bedrooms en suite"."""
    mention = reading.mention_at.get(index)
    return mention is not None and mention.room == "ensuite_bathroom" and reading.plural(index - 1)


def _is_modifier(reading: Reading, index: int) -> bool:
    """Whether a verb stands before a noun as its modifier: "live room", "touch pool", "cheese making room"."""
    if reading.word(index) not in _VERBAL_MODIFIERS or reading.kind(index + 1) != "word":
        return False
    if reading.word(index + 1) in FUNCTION_WORDS or reading.word(index + 1) in FLOOR_WORDS:
        return False
    before = reading.word(index - 1)
    listed = reading.starts(index) or before in (
        ",",
        ":",
        "and",
        "a",
        "an",
        "the",
        "one",
        "-",
        "(",
        "&",
        "plus",
        "with",
        "*",
    )
    counted = reading.kind(index - 1) == "number"
    joined = (
        reading.kind(index - 1) == "word" and before not in FUNCTION_WORDS and reading.word(index + 1) in HEAD_TYPES
    )
    if (
        reading.starts(index)
        and reading.word(index + 1) not in HEAD_TYPES
        and reading.word(index + 2) not in HEAD_TYPES
    ):
        return False
    described = is_size(before) or is_property(before, things=True)  # "six small round tables"
    return listed or counted or joined or described


def _is_acronym(reading: Reading, index: int) -> bool:
    """Whether a word is information technology rather than a pronoun."""
    token = reading.tokens[index]
    return token.text == "it" and reading.text[token.start : token.end] == "IT"


def _hyphenated(reading: Reading, index: int) -> bool:
    """Whether a function word is part of a compound ("write-up area", "drop-in centre")."""
    joined = index > 0 and not reading.tokens[index].spaced and reading.kind(index - 1) == "word"
    following = (
        index + 1 < len(reading.tokens) and not reading.tokens[index + 1].spaced and reading.kind(index + 1) == "word"
    )
    return joined or following


def _inside_mentions(reading: Reading) -> set[int]:
    """Tokens of phrases of several words, which may hold function words ("walk in closet")."""
    inside: set[int] = set()
    for mention in reading.mentions:
        if mention.last - mention.first > 1 and reading.free(mention.first, mention.last):
            inside.update(range(mention.first, mention.last))
    return inside


def _phrases_of(reading: Reading, begin: int, end: int) -> list[Phrase]:
    """Read a run of content words: one phrase as a rule, more where a head is followed by words that go on."""
    phrases: list[Phrase] = []
    while begin < end:
        found = None
        for stop in range(end, begin, -1):
            found = _headed(reading, begin, stop, whole=stop == end)
            if found is not None:
                break
        if found is None:
            break
        phrases.append(found)
        reading.take(found.first, found.last)
        begin = max(found.last, found.noun_end)
    return phrases


def _ends_scope(reading: Reading, begin: int, end: int) -> bool:
    """Whether the room that "in every classroom low shelves" opens with ends before a token."""
    if reading.word(begin - 1) not in ("every", "each") or reading.word(begin - 2) not in ("in", "inside"):
        return False
    mention = reading.mention_at.get(begin)
    return mention is not None and bool(mention.room) and mention.last < end and reading.starts(begin - 2)


def _headed(reading: Reading, begin: int, end: int, *, whole: bool) -> Phrase | None:
    """Return the phrase of tokens `begin` to `end` if the last of them can be its head."""
    if _ends_scope(reading, begin, end):
        return None
    if _goes_on(reading, begin, end, whole=whole) or is_figurative(reading, begin, end):
        return None
    mention = _mention_ending(reading, begin, end)
    found = _furniture_or_core(reading, begin, end, mention)
    if found is not None:
        return found
    if mention is not None:
        if mention.building and not whole and _are_people(reading, end):
            return None  # "wind farm technicians"
        if _are_book_stacks(reading, begin, end):
            return finished_phrase(reading, "object", begin, end, category="bookshelf")
        return _by_mention(reading, begin, end, mention)
    if reading.word(end - 1) == "room" and reading.word(end - 2) in _SUPERLATIVES:
        return None
    return _room_by_head(reading, begin, end) or _people_or_furniture(reading, begin, end, whole=whole)


def _goes_on(reading: Reading, begin: int, end: int, *, whole: bool) -> bool:
    """Whether the word after some tokens makes them a modifier, or stands for a noun itself."""
    if not whole and reading.word(end) in _PARTS | {"style", "styled"}:
        return True  # "chalet style" is how the building looks
    if (
        not whole
        and reading.word(end) in OFFICE_HOLDERS
        and not reading.plural(end)
        and reading.word(begin - 1) == "the"
    ):
        return True  # "an office for the station chief"
    one = reading.word(end) == "one" and reading.word(end + 1) not in FLOOR_WORDS | {"flight"}
    return one and reading.word(begin - 1) in ("a", "an")  # "two kitchens, a meat one and a dairy one"


def _furniture_or_core(reading: Reading, begin: int, end: int, mention: Mention | None) -> Phrase | None:
    """Return furniture, stairs or a lift, where these come before a room of that name; else nothing.

    Parameters
    ----------
    mention : Mention, optional
        The phrase of the lexicon that ends with the tokens.
    """
    last = reading.word(end - 1)
    if own := own_furniture_of(reading.words(begin, end)):
        return finished_phrase(reading, "object", begin, end, category=own)
    category, size = furniture_of(reading.words(begin, end))
    if last == "screen" and all(word in PLAIN for word in reading.words(begin, end - 1)) and _in_cinema(reading):
        return finished_phrase(reading, "room", begin, end, room="cinema_hall")
    if end - begin == 1 and last == "screen" and reading.words(begin - 2, begin) in (("with", "a"), ("and", "a")):
        return finished_phrase(reading, "object", begin, end, category="projection_screen")
    if last in _LIFTS and _lifts_cars(reading, begin, end):
        return finished_phrase(reading, "object", begin, end, category="car_lift")
    if last in _STAIRS | _LIFTS and size < 2:
        return finished_phrase(reading, "stair" if last in _STAIRS else "elevator", begin, end)
    longer = size > 1 and (mention is None or mention.last - mention.first < size)
    counter = last in ("counter", "desk") and size > 1 and mention is not None
    counter = counter and reading.word(count_before(reading, begin, end)[0] - 1) == "with"
    lockers = last == "locker" and reading.plural(end - 1) and not count_before(reading, begin, end)[2]
    if lockers and longer and set(reading.words(begin, end - 1)) <= PEOPLE:
        room = finished_phrase(reading, "room", begin, end, room="changing_room")
        return replace(room, count=1, plural=False)  # "staff lockers" are one room
    if lockers and longer and reading.word(end - 2) in _CARRIED:
        return finished_phrase(reading, "object", begin, end, category="locker")
    if reading.words(end - 2, end) in _EQUIPMENT:
        category = furniture_of((reading.word(end - 1),))[0] if size < 2 else category
        return finished_phrase(reading, "object", begin, end, category=category)
    if counter or (longer and last in _FURNITURE_TOO):
        return finished_phrase(reading, "object", begin, end, category=category)
    return None


def _lifts_cars(reading: Reading, begin: int, end: int) -> bool:
    """Whether lifts are what a workshop works with: "workshop with four lifts"."""
    first, _, counted, _ = count_before(reading, begin, end)
    owner = reading.word(first - 2) in ("workshop", "garage") and reading.word(first - 1) == "with"
    return owner and counted and reading.plural(end - 1) and reading.word(begin) in _LIFTS


def _by_mention(reading: Reading, begin: int, end: int, mention: Mention) -> Phrase:
    """Return the room or the building that the lexicon has, as more words before its head may tell it further."""
    last = reading.word(end - 1)
    room = mention.room or room_of_building(mention.building, reading.knowledge)
    served = reading.word(count_before(reading, begin, end)[0] - 1) == "for"
    if last in PEOPLE and reading.plural(end - 1) and (served or not (mention.room or last in _PRACTICES)):
        return finished_phrase(reading, "people", begin, end)  # "50 diners" are no eating houses
    if end - begin > 1 and mention.last - mention.first == 1:
        if last == "studio" and _names_use(reading, begin, end):
            return finished_phrase(reading, "room", begin, end, room=HEAD_TYPES[last], known=False)
        if last == "suite" and not mention.building and _names_use(reading, begin, end):
            slept = _mention_ending(reading, begin, end - 1)
            kind = slept.room if slept is not None and slept.room in _SLEPT_IN else ""
            kind = kind or told_room_type(name_of(reading, begin, end), reading.knowledge) or HEAD_TYPES[last]
            return finished_phrase(reading, "room", begin, end, room=kind, known=False)
        if last == "hall" and name_of(reading, begin, end) != "hall":
            room = _hall_of(reading, begin, end)
    head: Head = "room" if mention.room or not mention.building else "building"
    return finished_phrase(reading, head, begin, end, room=room, building=mention.building, mention=mention)


_SLEPT_IN = frozenset({"bedroom", "guest_room", "childrens_room"})
"""Types of rooms of which a suite is one, with what goes with it."""
_PRACTICES = frozenset({"dentist"})
"""Those whose practices are called after them: a mall with two dentists."""


def _room_by_head(reading: Reading, begin: int, end: int) -> Phrase | None:
    """Return a room that the lexicon does not have, by a noun that can head a room's name: "honey room"."""
    last, plural = reading.word(end - 1), reading.plural(end - 1)
    _, _, counted, determiner = count_before(reading, begin, end)
    bare = last == "room" and all(word in PLAIN or word == "guest" for word in reading.words(begin, end - 1))
    if bare and plural and (counted or count_after(reading, end)[1]):
        return finished_phrase(reading, "room", begin, end, room="study_room", known=False)
    if bare and not plural and reading.word(end) == "with" and (counted or determiner in ("a", "an")):
        return finished_phrase(
            reading, "room", begin, end, room="study_room", known=False
        )  # "one open room with desks"
    if end - begin == 1:
        if last in ("room", "corner") and _has_purpose(reading, end) and not plural:
            return finished_phrase(reading, "room", begin, end, room="study_room", known=False)
        if last in _PLACES_OF and _listed_with_purpose(reading, begin, end):
            return finished_phrase(reading, "room", begin, end, room=HEAD_TYPES[last], known=False)
        listed = determiner in ("a", "an") and reading.word(begin - 2) in ("and", ",", "plus", "&", ":")
        if last in _STANDS_ALONE and (plural or counted or determiner == "the" or listed):
            return finished_phrase(reading, "room", begin, end, room=HEAD_TYPES[last], known=False)
        return None
    if last not in HEAD_TYPES or (last in _NO_HEADS and reading.word(end - 2) in PLAIN):
        return None
    name = name_of(reading, begin, end)
    if name == last:
        return None
    if _is_of_resident(reading, begin, end):
        return finished_phrase(reading, "room", begin, end, room="bedroom")
    told = _mention_ending(reading, begin, end - 1) if last == "room" else None
    if told is not None and told.room not in ("", "reception") and not told.building and told.first == begin:
        return finished_phrase(reading, "room", begin, end, room=told.room)  # "a disco room"
    kind = similar_room_type(name, reading.knowledge)
    same = _without_plurals(name) == _without_plurals(kind)  # "childrens room"
    return finished_phrase(reading, "room", begin, end, room=kind, known=same)


def _is_of_resident(reading: Reading, begin: int, end: int) -> bool:
    """Whether a room of a home is called after who sleeps there: "Lily's room"."""
    token = reading.tokens[begin]
    owned = reading.text[token.start : token.end].endswith(("'s", "’s")) and token.capital
    buildings = reading.knowledge.buildings
    home = any(m.building in buildings and buildings[m.building].family == "home" for m in reading.mentions)
    named = any(
        token.text == other.text and other.capital and not reading.starts(at) for at, other in enumerate(reading.tokens)
    )
    return home and owned and named and end - begin == 2 and reading.word(end - 1) == "room"


def _without_plurals(name: str) -> list[str]:
    return [word.rstrip("s") for word in name.split("_")]


def _people_or_furniture(reading: Reading, begin: int, end: int, *, whole: bool) -> Phrase | None:
    """Return the people or the furniture of the asset catalogue that some tokens name."""
    last = reading.word(end - 1)
    tells_whose = not whole and last == "guest" and not reading.plural(end - 1)  # "guest Stube"
    if (last in PEOPLE and not tells_whose) or (last in OFFICE_HOLDERS and end - begin == 1):
        return finished_phrase(reading, "people", begin, end)
    category, _ = furniture_of(reading.words(begin, end))
    if last == "island" and reading.word(count_before(reading, begin, end)[0] - 1) in ("of", "on", "at"):
        return None  # "the school of a small island"
    titles = last == "table" and reading.words(end, end + 2) in (("of", "room"), ("of", "content"))
    held = not whole and reading.word(end) in _HOLDERS and not furniture_of(reading.words(begin, end + 1))[1] > 1
    if category and not titles and not held and (whole or not is_modifier(reading, end)):
        return finished_phrase(reading, "object", begin, end, category=category)
    return None


def _are_book_stacks(reading: Reading, begin: int, end: int) -> bool:
    """Whether stacks are shelves rather than rooms: "30 book stacks"."""
    return (
        reading.plural(end - 1)
        and reading.words(end - 2, end) == ("book", "stack")
        and bool(count_before(reading, begin, end)[2])
    )


def _are_people(reading: Reading, index: int) -> bool:
    """Whether a noun in the plural that follows another is of those who work or live there."""
    word = reading.word(index)
    return reading.plural(index) and (word in PEOPLE or word.endswith(("ician", "ist", "eer", "owner", "worker")))


def _in_cinema(reading: Reading) -> bool:
    """Whether the brief is about a cinema, whose halls are called screens."""
    return any(mention.building == "cinema" for mention in reading.mentions)


def _has_purpose(reading: Reading, end: int) -> bool:
    """Whether a room is called by what it is for: "a room for trainees", "room of meetings"."""
    if reading.word(end) == "for":
        return True
    after = end + 1 + (reading.word(end + 1) in ("the", "our"))
    return reading.word(end) == "of" and reading.kind(after) == "word" and reading.word(after) not in FUNCTION_WORDS


def _listed_with_purpose(reading: Reading, begin: int, end: int) -> bool:
    """Whether a list goes on with a place and what it is for: ", zone of shipping", "a post of nurses"."""
    after = end + 1 + (reading.word(end + 1) == "the")
    word = reading.word(after)
    purpose = reading.word(end) == "of" and reading.kind(after) == "word" and word not in FUNCTION_WORDS | FLOOR_WORDS
    mention = reading.mention_at.get(after)
    whole = mention is not None and bool(mention.building) and not mention.room
    first = begin - (reading.word(begin - 1) in ("a", "an", "the", "one"))
    listed = reading.starts(first) or reading.word(first - 1) in _LIST_LEADS or reading.kind(begin - 1) == "number"
    return purpose and listed and not whole and word not in _REGIONS


_PLACES_OF = frozenset({"zone", "post", "reserve", "section", "depot"})
"""Nouns that name a room by what it is for: "zone of shipping"; without that they may be anything."""
_REGIONS = frozenset("city town building house site plot land country work duty office".split())
_LIST_LEADS = frozenset({",", ":", "and", "with", "is", "are", "has", "have", "there", "&", ";", "-"})
_STANDS_ALONE = frozenset(
    {"surgery", "booth", "cabin", "cell", "chamber", "ward", "salon", "loft", "kiosk", "chapel", "atelier"}
)
"""Nouns that name a room without a word before them, where they are counted or stand in the plural."""


def _names_use(reading: Reading, begin: int, end: int) -> bool:
    """Whether the words before a studio or a suite say what is done there ("pottery studio"): nobody lives in it."""
    return name_of(reading, begin, end) not in ("studio", "flat_studio", "apartment_studio", "suite")


def _hall_of(reading: Reading, begin: int, end: int) -> str:
    """Return what a hall is for, by the words before it: a "gym hall" is a gym; a hall of a home is another thing."""
    if reading.word(end - 2) in ("entrance", "entry", "front", "stair", "little", "small", "tiny"):
        return "hallway"
    before = _mention_ending(reading, begin, end - 1)
    return before.room if before is not None and before.room else "assembly_hall"


def _mention_ending(reading: Reading, begin: int, end: int) -> Mention | None:
    """Return the longest phrase of the lexicon that ends at token `end`, whatever stands before it in the chunk."""
    lexicon = lexicon_of(reading.knowledge)
    texts = reading.words(begin, end)
    for size in range(min(lexicon.longest, end - begin), 0, -1):
        meaning = lexicon.phrases.get(texts[-size:])
        if meaning is not None and (meaning.room or meaning.building):
            return Mention(end - size, end, meaning.room, meaning.building, meaning.style, reading.plural(end - 1))
    return None


_HOLDERS = frozenset("box basket bin crate case holder bag container".split())
"""Nouns that make a thing before them what is kept there: "a shoes box"."""
