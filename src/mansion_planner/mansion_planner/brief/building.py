"""Find which noun phrase of a brief names the building itself."""

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading

__all__ = ["building_phrase", "unknown_building"]

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


def _score(reading: Reading, phrases: list[Phrase], places: list[Place], phrase: Phrase, number: int) -> float:
    """How likely the phrase is the building: 0 for a part of it."""
    sentence = reading.sentence[phrase.first]
    start = next(i for i, s in enumerate(reading.sentence) if s == sentence)
    before = reading.words(start, phrase.first)
    is_room = phrase.head == "room" or phrase.building == "office"
    score = 6.0 - min(sentence, 4) - 0.1 * number
    owner = reading.word(phrase.first - 1) == "of" and any(place.last == phrase.first - 1 for place in places)
    if owner:  # "on the first floor of a library"
        return score + 2.0
    if any(
        place.first < phrase.first and reading.sentence[place.first] == sentence and not _about_all(place)
        for place in places
    ):
        return 0.0
    placed = any(
        0 <= place.first - phrase.last <= 1 and place.led and place.refs[0].kind not in ("every", "upper")
        for place in places
    )
    if placed and is_room and number > 0:
        return 0.0
    if not _OPENERS.isdisjoint(before) and not ({"we", "i"} & set(before) and number == 0):
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
    lead = reading.word(phrase.first - 1)
    if lead in ("in", "inside", "into"):
        return 0.0
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


def _about_all(place: Place) -> bool:
    return place.refs[0].kind in ("every",)


def unknown_building(reading: Reading) -> tuple[str, int, int] | None:
    """Return the opening words where they can name an unknown kind of building, and their tokens."""
    index = 0
    while index < min(len(reading.tokens), 12) and (
        reading.word(index)
        in (
            "a",
            "an",
            "the",
            "i",
            "we",
            "want",
            "need",
            "like",
            "please",
            "design",
            "build",
            "create",
            "make",
            "would",
            "our",
            "my",
            "small",
            "big",
            "large",
            "new",
            "local",
            "to",
            "plan",
            "generate",
            "me",
            "us",
            "give",
            "two",
            "three",
            "tiny",
            "modern",
        )
        or reading.kind(index) in ("number", "ordinal")
        or reading.word(index) in FLOOR_WORDS
    ):
        index += 1
    first = index
    while (
        index < len(reading.tokens)
        and reading.kind(index) == "word"
        and index not in reading.taken
        and reading.word(index) not in ("with", "for", "of", "on", "in", "and", "to", "that", "is", "has", "at", "by")
    ):
        index += 1
    if index == first or index - first > 4:
        return None
    words = reading.words(first, index)
    return "_".join(words), first, index
