"""Find which noun phrase of a brief names the building itself."""

from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.lexicon import lexicon_of
from mansion_planner.brief.phrase import FUNCTION_WORDS, PEOPLE, PLAIN, Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading
from mansion_planner.brief.room_names import CONTRASTS
from mansion_planner.brief.similarity import HEAD_TYPES

__all__ = ["MADE_INTO", "building_phrase", "is_compound", "own_building_name", "unknown_building"]

_OPENERS = frozenset(
    """
    with containing including featuring contain include housing has have there comprising
    """.split()
)
_INNER = frozenset(
    """
    and or next no without beside near above over under plus in inside into on from old former behind
    """.split()
)
_WISHES = frozenset(
    """
    want need design build make create plan like generate give for of as is run are have search bought please
    needing buy get
    """.split()
)


MADE_INTO = frozenset({"turned", "converted", "transformed", "adapted", "remodelled", "remodeled", "made", "rebuilt"})
"""Participles between what a building was and what it becomes."""


def building_phrase(reading: Reading, phrases: list[Phrase], places: list[Place]) -> int | None:
    """Return the number of the phrase that names the building: the likeliest of the first sentences, or none.

    "A four-storey office with a cafeteria" is an office; "a gym on the third floor" leaves the type open.
    """
    best: tuple[float, int] | None = None
    for number, phrase in enumerate(phrases):
        if not phrase.building:
            continue
        score = _score(reading, phrases, places, phrase, number)
        if score > 0 and (best is None or score > best[0]):
            best = (score, number)
    return best[1] if best is not None else None


def own_building_name(reading: Reading, phrase: Phrase) -> str:
    """Return what the brief calls a known kind of building, in snake case; empty where that is the kind's own name.

    "A beach house" is planned like a manor and stays a beach house; "an infill building" says nothing of its use.
    """
    lexicon = lexicon_of(reading.knowledge)
    words = reading.words(phrase.begin, phrase.noun_end)
    for size in range(min(lexicon.longest, len(words)), 0, -1):
        meaning = lexicon.phrases.get(words[-size:])
        if meaning is not None and meaning.building:
            name = "_".join(words[-size:])
            plain = name.endswith("_building") and phrase.building.endswith("_building")
            return "" if plain or name == phrase.building or phrase.plural else name
    return ""


def _score(reading: Reading, phrases: list[Phrase], places: list[Place], phrase: Phrase, number: int) -> float:
    """How likely the phrase is the building: 0 for a part of it."""
    sentence = reading.sentence[phrase.first]
    start = next(i for i, s in enumerate(reading.sentence) if s == sentence)
    before = reading.words(start, phrase.first)
    is_room = phrase.head == "room" or phrase.building == "office"
    if reading.word(phrase.last) in MADE_INTO and reading.word(phrase.last + 1) in ("into", "to"):
        return 0.0  # "an old mill turned into a home"
    if any(_are_told_apart(phrase, other) for other in phrases):
        return 0.0  # "big studio ... small studio"
    if (
        phrase.building == "office"
        and _has_owner(reading, phrase)
        and any(other is not phrase and other.building == "office" and _has_owner(reading, other) for other in phrases)
    ):
        return 0.0  # "Dr. Meyer's office and Dr. Lee's office"
    if phrase.counted and (phrase.count or 0) > 1 and phrase.plural and is_compound(reading, phrase):
        return 0.0  # "6 styling stations"
    if reading.word(phrase.last) == "one" and reading.word(phrase.first - 1) in ("a", "the", "and"):
        return 0.0  # "two kitchens, a meat one and a dairy one"
    score = 6.0 - min(sentence, 4) - 0.1 * number
    owner = reading.word(phrase.first - 1) == "of" and any(place.last == phrase.first - 1 for place in places)
    owner = owner and not (phrase.plural and not phrase.determiner)  # "three floors of offices" are a part
    if owner:  # "on the first floor of a library"
        return score + 2.0
    if any(
        place.first < phrase.first and reading.sentence[place.first] == sentence and not _about_all(place)
        for place in places
    ):
        return 0.0
    reach = 4 if reading.word(phrase.last) == "for" else 1
    placed = any(
        0 <= place.first - phrase.last <= reach and place.led and place.refs[0].kind not in ("every", "upper")
        for place in places
    )
    if placed and (is_room or (phrase.building == "flat" and not phrase.plural)) and number > 0:
        return 0.0
    if any(word in _OPENERS and not _is_perfect(reading, start + at) for at, word in enumerate(before)) and not (
        {"we", "i"} & set(before) and number == 0
    ):
        return 0.0
    if phrase.plural and is_room and "each" in reading.words(phrase.last, phrase.last + 5):
        return 0.0
    if phrase.plural and is_room:
        score -= 5.0 if phrase.building not in ("flat", "shop_building") or phrase.counted else 3.0
    if phrase.counted and (phrase.count or 0) > 1:
        score -= 4.0
    earlier = [p for p in phrases[:number] if p.head in ("room", "building") and reading.sentence[p.first] == sentence]
    if earlier:
        score -= 2.0 if not is_room else 4.0
    if phrase.building == "studio_flat" and not {"share", "shared", "pottery", "work", "working"}.isdisjoint(
        reading.words(phrase.begin, phrase.noun_end)
    ):
        return 0.0
    if is_room and ":" in before and any(p.head in ("room", "building") for p in phrases[:number]):
        return 0.0  # an entry of a list
    if is_room and earlier and phrase.first == phrase.begin and phrase.name == "office" and not (set(before) & _WISHES):
        return 0.0  # "a showroom, a workshop, an office upstairs"
    if is_room and before[-3:-1] in (("it", "need"), ("they", "need")):
        return 0.0  # "it needs a shop" speaks of a part
    lead = reading.word(phrase.first - 1)
    if lead == "into" and not is_room:
        return score + 2.5  # "turn the barn into a home"
    if lead in ("in", "inside", "into"):
        return 0.0
    if not is_room and not {"need", "want", "design", "build", "generate", "create"}.isdisjoint(before[-5:]):
        score += 1.5
    if lead in _INNER and phrase.first - 1 > 0:
        score -= 3.0
    if phrase.determiner == "the" and is_room:
        score -= 2.0
    if placed and is_room:
        score -= 4.0
    if is_room and sentence > 0:
        score -= 3.0
    if is_room and number and not earlier and not ({*before} & _WISHES):
        score -= 1.0
    following = reading.word(phrase.last)
    if following in ("block", "building", "tower", "house", "complex"):
        score += 2.0
    if not is_room:
        score += 1.5
    if phrase.areas and is_room:
        score += 0.0
    return max(score, 0.0)


def _has_owner(reading: Reading, phrase: Phrase) -> bool:
    return any(mark in reading.span(phrase.begin, phrase.noun_end).words for mark in ("'s", "’s"))


def is_compound(reading: Reading, phrase: Phrase) -> bool:
    """Whether a word that nobody knows stands before the name of a kind of building of one word."""
    known = lexicon_of(reading.knowledge).phrases
    words = reading.words(phrase.begin, phrase.noun_end)
    if len(words) < 2 or any(words[-size:] in known for size in range(2, len(words) + 1)):
        return False
    return words[-2] not in PLAIN | _ROOMS_OF_FLATS


_ROOMS_OF_FLATS = frozenset({"bed", "bedroom", "room", "br", "bdr"})
"""What "two-bed flats" are counted by: they are flats all the same."""


def _are_told_apart(phrase: Phrase, other: Phrase) -> bool:
    """Whether two phrases name buildings of one kind by their sizes, so that both are rooms."""
    sizes = {phrase.name.partition("_")[0], other.name.partition("_")[0]}
    return phrase.building == other.building and len(sizes) == 2 and sizes <= CONTRASTS


def _is_perfect(reading: Reading, index: int) -> bool:
    """Whether "has" only forms the perfect: "our town has saved for a theatre"."""
    return reading.word(index) in ("has", "have") and reading.word(index + 1).endswith(("ed", "en"))


def _about_all(place: Place) -> bool:
    return place.refs[0].kind in ("every",)


def unknown_building(reading: Reading) -> tuple[str, str, int, int] | None:
    """Return a kind of building that nobody knows: its name, the kind that its head is most like, and its tokens.

    A noun phrase of the first two sentences that ends in the head of a kind of building ("advertising agency"), or the
    words that open the brief where they stand alone ("Houseboat with two decks").
    """
    found: list[tuple[bool, tuple[str, str, int, int]]] = []
    first = -1
    for index in range(len(reading.tokens) + 1):
        if index < len(reading.tokens) and reading.sentence[index] > 1:
            break
        if _is_part_of_name(reading, index):
            first = index if first < 0 else first
            continue
        if first >= 0 and _stands_as_building(reading, first) and index - first <= 5:
            like = "" if reading.plural(index - 1) else _kind_by_head(reading, first, index)
            sized = reading.kind(first - 1) == "number" and reading.word(first) in _ROOMS_OF_FLATS  # "a two-bed flat"
            if sized or _names_part(reading, first, index, like):
                first = -1
                continue
            opens = _opens_brief(reading, first) and (
                reading.word(index) in _AFTER_NAME and not reading.plural(index - 1)
            )
            one_of_two = reading.word(first - 1) in CONTRASTS and (
                [token.text for token in reading.tokens].count(reading.word(index - 1)) > 1
            )
            if (like or opens) and not one_of_two:
                wished = not _WISHES.isdisjoint(reading.words(max(first - 3, 0), first))
                found.append((wished, ("_".join(reading.words(first, index)), like, first, index)))
        first = -1
    return max(found, key=lambda entry: (entry[0], -entry[1][2]))[1] if found else None


def _kind_by_head(reading: Reading, first: int, last: int) -> str:
    """Return the kind of building that a name's last noun is most like, of "canteen building" the noun before."""
    heads = _heads(reading)
    plain = reading.word(last - 1) == "building" and last - 1 > first
    return (plain and heads.get(reading.word(last - 2), "")) or heads.get(reading.word(last - 1), "")


def _names_part(reading: Reading, first: int, last: int, like: str) -> bool:
    """Whether words name a room, a thing or people and no building: "Ward with 12 beds", "Half of the offices"."""
    word = reading.word(last - 1)
    whole = lexicon_of(reading.knowledge).phrases.get(reading.words(first, last))
    listed = reading.word(first - 1) == ":" and whole is not None and whole.room and not whole.building
    if listed and last - first > 1:
        return True  # "Ground floor: entrance hall, ..."
    if like:
        return False
    if word in _PARTS or word in PEOPLE or word in HEAD_TYPES or furniture_of(reading.words(first, last))[0]:
        return True
    return any(mention.room and not mention.building and mention.last == last for mention in reading.mentions)


_PARTS = frozenset(
    """
    half third quarter part list everything everywhere room entrance lift elevator stair staircase wall floor roof
    door window requirement wish programme program schedule note dr mr mrs ms prof
    """.split()
)


def _heads(reading: Reading) -> dict[str, str]:
    kinds = reading.knowledge.buildings.values()
    return {head: kind.name for kind in kinds if not kind.like for head in kind.heads}


def _is_part_of_name(reading: Reading, index: int) -> bool:
    word = reading.word(index)
    return (
        reading.kind(index) == "word"
        and index not in reading.taken
        and word not in FUNCTION_WORDS
        and word not in _SIZES
        and word not in _WISHES | _GREETINGS
        and word not in FLOOR_WORDS
    )


def _stands_as_building(reading: Reading, first: int) -> bool:
    """Whether what leads up to a noun phrase lets it name the building, rather than a person or a part of it."""
    lead = first - 1 - (reading.word(first - 1) in ("a", "an", "the"))
    if reading.word(lead) in ("above", "over", "of") and lead in reading.taken:
        return False  # "three floors of offices above a shop"
    if reading.word(first - 1) in ("are", "is") and first - 2 in reading.taken:
        return False  # "on the street floor are a flower shop and a barber"
    before = [reading.word(i) for i in range(first - 1, max(first - 4, -1), -1)]
    while before and (before[0] in _SIZES or before[0] in ("a", "an", "the", "our", "my", "new", "of")):
        before = before[1:]
    if not before or before[0] in _WISHES | {"for", "into", "is", "this", "me", "us", "like", ".", ":", "\n"}:
        return True
    at = first - 1
    while at >= 0 and reading.word(at) in _SIZES | {"a", "an", "the"}:
        at -= 1
    return at < 0 or reading.kind(at) in ("number", "unit") or reading.word(at) in FLOOR_WORDS or at in reading.taken


def _opens_brief(reading: Reading, first: int) -> bool:
    return all(
        reading.word(i)
        in _SIZES | _WISHES | _GREETINGS | {"a", "an", "the", "our", "my", "i", "we", "us", "me", "to", "would"}
        or reading.kind(i) in ("number", "ordinal", "mark")
        or reading.word(i) in FLOOR_WORDS
        or i in reading.taken
        for i in range(first)
    )


_SIZES = frozenset(
    """
    small big large new local tiny modern single two three one storey compact little old simple typical medium sized
    """.split()
)
_AFTER_NAME = frozenset({",", ":", ";", ".", "-", "\n", "with", "on", "of", "in", "at", "for", "over"})
_GREETINGS = frozenset("hi hello hey dear sir madam good morning greetings thanks scene".split())
