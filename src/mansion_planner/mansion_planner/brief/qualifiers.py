"""Find the words that say how a room, a thing or the building is to be, and that nothing is made of.

"A soundproof music room" is planned as a music room; that it keeps sound in is a property that no plan has. Such words
stay with the wish that they qualify, which is met in part at best. Words of praise ("nice", "elegant") ask for nothing
that anybody could look up, and words of a kind's own name ("cold room", "shared kitchen") are met by the kind.
"""

from collections.abc import Sequence

from mansion_planner.brief.facts import BriefFacts, Span
from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.sizes import is_size

__all__ = ["is_property", "unheeded_words"]

_PROPERTIES = frozenset(
    """
    bright dark sunny sunlit sunlight airy daylight panoramic quiet silent noisy acoustic secure bulletproof safe
    secret hidden accessible barrier wheelchair sterile hygienic hermetic humid waterproof watertight airtight cool
    warm gated movable mobile modular flexible foldable sliding rotating revolving retractable narrow long tall high
    low wide spiral winding straight curved circular round oval octagonal hexagonal triangular domed arched corner
    north south east west northern southern eastern western northeast northwest southeast southwest passive
    sustainable solar ecological marble oak walnut wooden red blue yellow orange purple pink brown black white grey
    gray beige turquoise golden medieval baroque futuristic steampunk ancient roman egyptian tudor colonial
    automatic electric smart antique floating shallow deep steep kosher halal antistatic double-height
    """.split()
)
_SUBSTANCES = frozenset(
    "glass brick concrete timber wood stone bamboo leather steel metal velvet silver square rectangular green".split()
)
"""Words that before a room rather say what is done or kept there: a wood shop, a green bean store."""
_ENDINGS = ("proof", "proofed", "less", "able", "ible", "resistant", "friendly", "facing", "lit", "ceilinged", "walled")
_JOINED = frozenset("proof free friendly resistant facing lit height ceilinged walled shaped conditioned".split())
"""Words that make a property of the word that a hyphen joins to them: "sound-proof", "barrier-free", "L-shaped"."""
_FREE = frozenset({"barrier", "smoke", "dust", "allergy", "column", "step", "noise", "draught"})
"""What "-free" says of a room itself, rather than of what is sold there."""
_NO_PROPERTIES = frozenset(
    """
    table stable cable vegetable bed shed seed feed speed reed shared combined dedicated detached attached mixed
    terraced semidetached integrated enclosed fitted built sized need used furnished equipped needed wanted required
    separated united limited advanced embedded hundred kindred sacred listed unlimited assisted supervised gifted
    disabled injured retired homeless wireless related stepped recessed closed mirrored covered
    """.split()
)
_ORIGINS = frozenset(
    """
    american arab brazilian british chinese danish dutch english finnish french german greek indian irish italian
    korean mexican moorish moroccan norwegian polish portuguese russian scottish spanish swedish swiss thai turkish
    """.split()
)
"""Where a building is usual, of which no plan is made but by the styles that are called so."""
_KINDS = frozenset({"room", "building", "object", "stair", "elevator"})


def unheeded_words(reading: Reading, phrases: Sequence[Phrase], facts: BriefFacts) -> list[Span]:
    """Return the properties that noun phrases ask for and that nothing is made of, each as it is written.

    Parameters
    ----------
    phrases : sequence of Phrase
        All noun phrases; those of people and of unread things are passed over.
    """
    heeded = [span for _, span in facts.styles] + [m.span for m in facts.materials] + [s for _, s in facts.shapes]
    found: list[Span] = []
    for phrase in phrases:
        if phrase.head not in _KINDS:
            continue
        for first, last in _properties(reading, phrase):
            span = reading.span(first, last)
            if not any(span.start < other.end and other.start < span.end for other in heeded):
                found.append(span)
    return sorted(dict.fromkeys(found), key=lambda span: span.start)


def _properties(reading: Reading, phrase: Phrase) -> list[tuple[int, int]]:
    """Return the tokens of a phrase's properties: those before the words that name its kind."""
    core = _core(reading, phrase)
    found: list[tuple[int, int]] = []
    index = phrase.first
    while index < core:
        last = index + 1
        glued = _joined(reading, last) and last < core
        if glued and reading.word(last) in _JOINED and (reading.word(last) != "free" or reading.word(index) in _FREE):
            found.append((index, last + 1))
            last += 1
        elif not glued and _is_own(reading, phrase, index):
            found.append((index, last))
        index = last
    return found


def _is_own(reading: Reading, phrase: Phrase, index: int) -> bool:
    """Whether a word is a property of what its phrase names: not "corner" in "children's corner room"."""
    if reading.kind(index) != "word" or (reading.word(index) == "corner" and index > phrase.begin):
        return False
    if is_size(reading.word(index)):
        return not phrase.size and not _is_measured(reading, phrase)
    if phrase.head == "building" and reading.word(index) in _ORIGINS:
        return True
    return is_property(reading.word(index), things=phrase.head == "object")


def _is_measured(reading: Reading, phrase: Phrase) -> bool:
    """Whether an area says how large a thing is that is called large or small."""
    return bool(phrase.areas) or (phrase.head == "building" and bool(reading.facts.area or reading.facts.floor_area))


def _core(reading: Reading, phrase: Phrase) -> int:
    """Return the first of the tokens that name the kind of thing."""
    if phrase.head == "object":
        _, size = furniture_of(reading.words(phrase.begin, phrase.noun_end))
        return phrase.noun_end - max(size, 1)
    plain = [i for i in range(phrase.begin, phrase.noun_end) if i not in reading.modifiers]
    return plain[0] if plain and phrase.head in ("room", "building") else phrase.noun_end - 1


def _joined(reading: Reading, index: int) -> bool:
    return index < len(reading.tokens) and not reading.tokens[index].spaced


def is_property(word: str, *, things: bool = False) -> bool:
    """Whether a word says how something is, in a way that could be looked up.

    Parameters
    ----------
    things : bool
        Of furniture, of which form and substance are properties too.

    Examples
    --------
    >>> [is_property(word) for word in ("soundproof", "windowless", "locked", "guest", "nice")]
    [True, True, True, False, False]
    """
    if word in _PROPERTIES or (things and word in _SUBSTANCES):
        return True
    if word in _NO_PROPERTIES or len(word) < 5:
        return False
    return word.endswith(_ENDINGS) or (word.endswith("ed") and not word.endswith("eed"))
