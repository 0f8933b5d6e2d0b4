"""Find which noun phrase of a brief names the building itself."""

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.lexicon import lexicon_of
from mansion_planner.brief.phrase import BARE_BUILDINGS, FUNCTION_WORDS, PEOPLE, PLAIN, Phrase
from mansion_planner.brief.qualifiers import subject_of_building
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading
from mansion_planner.brief.room_names import CONTRASTS
from mansion_planner.brief.similarity import HEAD_TYPES

__all__ = [
    "MADE_INTO",
    "building_phrase",
    "is_asked_for",
    "is_compound",
    "is_the_writer",
    "own_building_name",
    "unknown_building",
]

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
    candidates = [
        _Candidate(reading, phrases, places, phrase, number) for number, phrase in enumerate(phrases) if phrase.building
    ]
    scores = [_score(candidate) for candidate in candidates]
    if any(score > 0 for score in scores):
        return candidates[scores.index(max(scores))].number
    return next((candidate.number for candidate in candidates if _is_dwelt_in(candidate)), None)


def _is_dwelt_in(candidate: "_Candidate") -> bool:
    """Whether the phrase is where a brief's first sentence says somebody lives or works: "we live in a townhouse".

    So is what closes a list of rooms: "two bedrooms and a kitchen, in a flat".
    """
    indefinite = candidate.phrase.determiner in ("a", "an", "our", "my")
    ends = candidate.reading.breaks(candidate.phrase.last)
    verb = candidate.before[-2:-1]
    dwelt = candidate.lead in ("in", "inside") and verb and (verb[0] in _DWELLING or (verb[0] == "," and ends))
    return candidate.sentence == 0 and indefinite and bool(dwelt) and not (candidate.phrase.plural or candidate.placed)


def own_building_name(reading: Reading, phrase: Phrase) -> str:
    """Return what the brief calls a known kind of building, in snake case; empty where that is the kind's own name.

    "A beach house" is planned like a manor and stays a beach house, "a maritime museum" is not any museum; "an infill
    building" says nothing of its use.
    """
    lexicon = lexicon_of(reading.knowledge)
    words = reading.words(phrase.begin, phrase.noun_end)
    for size in range(min(lexicon.longest, len(words)), 0, -1):
        meaning = lexicon.phrases.get(words[-size:])
        if meaning is not None and meaning.building:
            subject = [word for run in subject_of_building(reading, phrase) for word in reading.words(*run)]
            name = "_".join((*subject, *words[-size:])).replace("&", "_and_")
            plain = name.endswith("_building") and phrase.building.endswith("_building")
            return "" if plain or name == phrase.building or phrase.plural else name
    return ""


@dataclass(frozen=True)
class _Candidate:
    """A phrase that may name the building: number `number` of the phrases, and what stands around it."""

    reading: Reading
    phrases: Sequence[Phrase]
    places: Sequence[Place]
    phrase: Phrase
    number: int

    @property
    def sentence(self) -> int:
        """The number of its sentence."""
        return self.reading.sentence[self.phrase.first]

    @cached_property
    def start(self) -> int:
        """The first token of its sentence."""
        return self.reading.sentence.index(self.sentence)

    @cached_property
    def before(self) -> tuple[str, ...]:
        """The words of its sentence that stand before it."""
        return self.reading.words(self.start, self.phrase.first)

    @property
    def lead(self) -> str:
        """The word right before it."""
        return self.reading.word(self.phrase.first - 1)

    @property
    def is_room(self) -> bool:
        """Whether it can be a room as well: an office, a workshop."""
        whole = self.reading.word(self.phrase.noun_end - 1) in BARE_BUILDINGS  # "an office building"
        return not whole and (self.phrase.head == "room" or self.phrase.building == "office")

    @cached_property
    def earlier(self) -> bool:
        """Whether its sentence names a room or a building before it."""
        return any(
            phrase.head in ("room", "building") and self.reading.sentence[phrase.first] == self.sentence
            for phrase in self.phrases[: self.number]
        )

    @cached_property
    def placed(self) -> bool:
        """Whether a storey follows it: "a gym on the third floor"."""
        reach = 4 if self.reading.word(self.phrase.last) == "for" else 1
        return any(
            0 <= place.first - self.phrase.last <= reach and place.led and place.refs[0].kind not in ("every", "upper")
            for place in self.places
        )

    @property
    def counted(self) -> bool:
        """Whether there are several of it, in numbers."""
        return self.phrase.counted and (self.phrase.count or 0) > 1


def _score(candidate: _Candidate) -> float:
    """Return how likely the phrase is the building: 0 for a part of it."""
    score = 6.0 - min(candidate.sentence, 4) - 0.1 * candidate.number
    if _is_told_as_part(candidate):
        return 0.0
    if _has_storey(candidate):
        return score + 2.0
    if _is_placed_part(candidate) or _is_listed_part(candidate):
        return 0.0
    for weight in _weights(candidate):
        score += weight
    return max(score, 0.0)


def _is_told_as_part(candidate: _Candidate) -> bool:
    """Whether the words of the phrase alone, or others like it, tell that it is a part or what the building was."""
    reading, phrase = candidate.reading, candidate.phrase
    if reading.word(phrase.last) in MADE_INTO and reading.word(phrase.last + 1) in ("into", "to"):
        return True  # "an old mill turned into a home"
    if reading.words(phrase.last, phrase.last + 2) in (("ask", "for"), ("asks", "for"), ("request", "a")):
        return True  # "the ministry asks for a police station"
    if reading.word(phrase.last) == "into" and _conversion_before(reading, phrase.first):
        return True  # "converting a church into a climbing centre"
    if any(_are_told_apart(phrase, other) for other in candidate.phrases):
        return True  # "big studio ... small studio"
    if is_the_writer(reading, phrase.first) and _asks_for_another(candidate):
        return True  # "We are a theatre company. Please plan a theatre"
    if phrase.building == "office" and _has_owner(reading, phrase):
        offices = (other for other in candidate.phrases if other is not phrase and other.building == "office")
        if any(_has_owner(reading, other) for other in offices):
            return True  # "Dr. Meyer's office and Dr. Lee's office"
    if candidate.counted and phrase.plural and is_compound(reading, phrase):
        return True  # "6 styling stations"
    # "two kitchens, a meat one and a dairy one"
    return reading.word(phrase.last) == "one" and candidate.lead in ("a", "the", "and")


def is_the_writer(reading: Reading, index: int) -> bool:
    """Whether a noun phrase that begins at a token says who writes: "we are a bank", "our library is too small"."""
    start = reading.sentence.index(reading.sentence[index])
    before = reading.words(start, index)
    return before[:2] in _WE_ARE or (not before and reading.word(index) == "our") or before == ("our",)


def _asks_for_another(candidate: _Candidate) -> bool:
    """Whether a later sentence asks for a building."""
    reading, first = candidate.reading, candidate.phrase.first
    return any(
        other.building and other.first > first and is_asked_for(reading, other.first)
        for other in candidate.phrases
        if reading.sentence[other.first] > candidate.sentence
    )


def is_asked_for(reading: Reading, index: int) -> bool:
    """Whether the noun phrase that begins at a token is the first that a verb of its sentence asks for."""
    at = index - 1
    while reading.word(at) in _BEFORE_ASKED or reading.kind(at) == "number":
        at -= 1
    return reading.sentence[index] == reading.sentence[at] and reading.word(at) in _ASKING if at >= 0 else False


_WE_ARE = frozenset({("we", "are"), ("i", "am"), ("we", "run"), ("i", "run"), ("we", "operate")})
_BEFORE_ASKED = frozenset({"a", "an", "new", "-", "storey", "story", "floor", "level"})
_ASKING = frozenset("plan design draw build need want generate create make imagine like".split())


def _conversion_before(reading: Reading, index: int) -> bool:
    """Whether a verb of making one building of another stands within a few words before a token."""
    near = range(index - 1, max(index - _NEAR_VERB, -1), -1)
    return any(reading.word(at) in _CONVERTING for at in itertools.takewhile(lambda at: not reading.breaks(at), near))


_CONVERTING = frozenset("convert converting turn turning transform transforming remake remaking rebuild".split())
_NEAR_VERB = 7


def _has_storey(candidate: _Candidate) -> bool:
    """Whether a storey is said to be its: "on the first floor of a library"."""
    first = candidate.phrase.first
    if candidate.lead != "of" or not any(place.last == first - 1 for place in candidate.places):
        return False
    return not candidate.phrase.plural or bool(candidate.phrase.determiner)  # "three floors of offices" are a part


def _is_placed_part(candidate: _Candidate) -> bool:
    """Whether the phrase is what the sentence puts on a storey or into the building."""
    phrase, is_room = candidate.phrase, candidate.is_room
    if any(
        place.first < phrase.first
        and candidate.reading.sentence[place.first] == candidate.sentence
        and not _about_all(place)
        for place in candidate.places
    ):
        return True
    if candidate.placed and candidate.number > 0 and (is_room or (phrase.building == "flat" and not phrase.plural)):
        return True
    if candidate.lead in ("in", "inside"):
        return not _holds_what_happens(candidate)
    return candidate.lead == "into" and is_room and not _conversion_before(candidate.reading, phrase.first)


def _holds_what_happens(candidate: _Candidate) -> bool:
    """Whether the phrase is where a brief's first sentence has something done: "to evaluate a robot in a care home"."""
    parts = ("room", "building", "stair", "elevator")
    first = candidate.sentence == 0 and not candidate.is_room and not candidate.phrase.plural
    before = [phrase for phrase in candidate.phrases[: candidate.number] if phrase.head in parts]
    definite = candidate.phrase.determiner in ("the", "our", "my", "this", "their")
    old = not _OUTGROWN.isdisjoint(candidate.reading.words(candidate.phrase.first, candidate.phrase.noun_end))
    done = not _DONE.isdisjoint(candidate.before) and _DWELLING.isdisjoint(candidate.before)
    return first and done and not (before or definite or old)


_DWELLING = frozenset("live lives living work works working sit sits based".split())
"""Verbs of what the writer does in another building than the one wanted."""
_DONE = frozenset("to test tests testing evaluate train trial trials robot must should experiment".split())
"""Words of what is to be done in a building."""
_OUTGROWN = frozenset({"old", "former", "existing", "disused", "rented"})
"""Adjectives of a building that is there before."""


def _is_listed_part(candidate: _Candidate) -> bool:
    """Whether the phrase is one of the things that a sentence lists or asks for in the building."""
    reading, phrase, before = candidate.reading, candidate.phrase, candidate.before
    opened = any(word in _OPENERS and not _is_perfect(reading, candidate.start + at) for at, word in enumerate(before))
    if opened and (candidate.number or {"we", "i"}.isdisjoint(before)):
        return True
    words = reading.words(phrase.begin, phrase.noun_end)
    if phrase.building == "studio_flat" and not _STUDIOS_TO_WORK_IN.isdisjoint(words):
        return True
    if not candidate.is_room:
        return False
    if phrase.plural and "each" in reading.words(phrase.last, phrase.last + 5):
        return True
    if ":" in before and any(p.head in ("room", "building") for p in candidate.phrases[: candidate.number]):
        return True
    bare = phrase.name == "office" and phrase.first == phrase.begin
    if bare and candidate.earlier and _WISHES.isdisjoint(before):
        return True  # "a showroom, a workshop, an office upstairs"
    return before[-3:-1] in (("it", "need"), ("they", "need"))  # "it needs a shop" speaks of a part


_STUDIOS_TO_WORK_IN = frozenset({"share", "shared", "pottery", "work", "working"})


def _weights(candidate: _Candidate) -> Iterator[float]:
    """Give what speaks for the phrase as the building, and what against it."""
    phrase, is_room, lead = candidate.phrase, candidate.is_room, candidate.lead
    if phrase.plural and is_room:
        yield -5.0 if phrase.building not in ("flat", "shop_building") or phrase.counted else -3.0
    if candidate.counted:
        yield -4.0
    if candidate.earlier:
        yield -4.0 if is_room else -2.0
    if lead == "into":
        yield 2.5  # "turn the barn into a home", whatever else stands there
        return
    if not is_room and not {"need", "want", "design", "build", "generate", "create"}.isdisjoint(candidate.before[-5:]):
        yield 1.5
    if lead in _INNER and phrase.first - 1 > 0:
        yield -3.0
    if is_room:
        yield from _weights_of_room(candidate)
    if candidate.reading.word(phrase.last) in ("block", "building", "tower", "house", "complex"):
        yield 2.0
    if not is_room:
        yield 1.5


def _weights_of_room(candidate: _Candidate) -> Iterator[float]:
    """Give what speaks against a phrase as the building that can be a room as well."""
    if candidate.phrase.determiner == "the":
        yield -2.0
    if candidate.placed:
        yield -4.0
    if candidate.sentence > 0:
        yield -3.0
    if candidate.number and not candidate.earlier and _WISHES.isdisjoint(candidate.before):
        yield -1.0


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
    return reading.word(index) in ("has", "have") and reading.word(index + 1).endswith(("ed", "en", "own"))


def _about_all(place: Place) -> bool:
    return place.refs[0].kind in ("every",)


def unknown_building(reading: Reading, places: Sequence[Place]) -> tuple[str, str, int, int] | None:
    """Return a kind of building that nobody knows: its name, the kind that its head is most like, and its tokens.

    A noun phrase of the first two sentences that ends in the head of a kind of building ("advertising agency"), or the
    words that open the brief where they stand alone ("Houseboat with two decks").
    """
    found: list[tuple[bool, tuple[str, str, int, int]]] = []
    first = -1
    headed = {place.last + place.heading for place in places}  # "Basement: car park", "Ground floor clinic: ..."
    headed |= {place.last + 1 for place in places if reading.word(place.last) in ("a", "an", "the")}
    for index in range(len(reading.tokens) + 1):
        if index < len(reading.tokens) and reading.sentence[index] > 1:
            break
        if _is_part_of_name(reading, index):
            first = index if first < 0 else first
            continue
        if first >= 0 and first not in headed and _stands_as_building(reading, first) and index - first <= 5:
            like = "" if reading.plural(index - 1) else _kind_by_head(reading, first, index)
            sized = reading.kind(first - 1) == "number" and reading.word(first) in _ROOMS_OF_FLATS  # "a two-bed flat"
            tried = reading.words(first, index) in _TRIED
            if sized or tried or _names_part(reading, first, index, like):
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


_TRIED = frozenset(("test", place) for place in ("scene", "scenario", "environment", "world", "setup", "level"))
"""What opens a brief that is about a robot, and names no building: "test world for a delivery robot"."""
_PARTS_OF_BUILDINGS = frozenset({"building", "wing", "block", "annex", "annexe", "extension", "pavilion"})
"""Nouns after that of a building, which is of the same kind as a whole."""


def _kind_by_head(reading: Reading, first: int, last: int) -> str:
    """Return the kind of building that a name's last noun is most like, of "canteen building" the noun before."""
    heads = _heads(reading)
    plain = reading.word(last - 1) in _PARTS_OF_BUILDINGS and last - 1 > first
    return (plain and heads.get(reading.word(last - 2), "")) or heads.get(reading.word(last - 1), "")


def _names_part(reading: Reading, first: int, last: int, like: str) -> bool:
    """Whether words name a room, a thing or people and no building: "Ward with 12 beds", "Half of the offices"."""
    word = reading.word(last - 1)
    whole = lexicon_of(reading.knowledge).phrases.get(reading.words(first, last))
    listed = reading.word(first - 1) == ":" and whole is not None and whole.room and not whole.building
    sized = reading.sentence[first] > 0 and reading.kind(last) == "number" and reading.kind(last + 1) == "unit"
    listed = listed or (sized and whole is not None and bool(whole.room) and not whole.building)
    if listed and last - first > 1:
        return True  # "Ground floor: entrance hall, ...", "We brew cider. Production hall 200 m2, ..."
    if like:
        return False
    if word in _PARTS or word in PEOPLE or word in HEAD_TYPES or furniture_of(reading.words(first, last))[0]:
        return True
    return any(mention.room and not mention.building and mention.last == last for mention in reading.mentions)


_PARTS = frozenset(
    """
    half third quarter part list everything everywhere room entrance lift elevator stair staircase wall floor roof
    door window requirement wish programme program schedule note dr mr mrs ms prof brief description
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
