"""Find the words that say how a room, a thing or the building is to be, and that nothing is made of.

"A soundproof music room" is planned as a music room; that it keeps sound in is a property that no plan has. Such words
stay with the wish that they qualify, which is met in part at best. Words of praise ("nice", "elegant") ask for nothing
that anybody could look up, and words of a kind's own name ("cold room", "shared kitchen") are met by the kind.
"""

from collections.abc import Sequence

from mansion_knowledge.object_kinds import of_one_kind
from mansion_knowledge.stand_ins import is_for_another_subject
from mansion_planner.brief.facts import BriefFacts, Span
from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.phrase import FUNCTION_WORDS, PLAIN, UNITS_OF_ROOMS, Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.sizes import is_size

__all__ = ["is_property", "subject_of_building", "taken_for_its_head", "unheeded_words"]

_PROPERTIES = frozenset(
    """
    bright dark sunny sunlit sunlight airy daylight panoramic quiet silent noisy acoustic secure bulletproof safe
    secret hidden accessible barrier wheelchair sterile hygienic hermetic humid waterproof watertight airtight cool
    warm gated movable mobile modular flexible foldable sliding rotating revolving retractable narrow long tall high
    low wide spiral winding straight curved circular round oval octagonal hexagonal triangular domed arched corner
    north south east west northern southern eastern western northeast northwest southeast southwest passive
    sunken vaulted
    sustainable solar ecological marble oak walnut wooden red blue yellow orange purple pink brown black white grey
    gray beige turquoise golden medieval baroque futuristic steampunk ancient roman egyptian tudor colonial
    composting waterless
    ceiling-high automatic electric smart antique floating shallow deep steep kosher halal antistatic double-height
    """.split()
)
_SUBSTANCES = frozenset(
    """
    glass brick concrete timber wood stone bamboo leather steel metal velvet silver square rectangular green
    wicker rattan cane teak pine birch maple cherry mahogany beech plywood acrylic plastic perspex chrome brass copper
    aluminium aluminum suede linen cotton jute ceramic porcelain granite wrought iron cast
    """.split()
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
_SETTINGS = frozenset(
    """
    local regional municipal district village rural urban town city country countryside provincial neighborhood
    neighbourhood suburban suburb roadside corner street riverside lakeside lake lakefront seaside sea coastal beach
    mountain alpine hillside forest island family holiday vacation weekend summer winter national public private
    community communal company corporate charity volunteer state federal central county royal international university
    campus model sample demo fantasy imaginary typical traditional style styled type cum look inspired themed storey
    research
    multifamily family-run group test pilot future small-town mixed use multi generation generational cute pretty lovely
    tower mini walk ish rise mid slim youth boy girl student staff health charming
    run owned managed occupied
    stunning spectacular magnificent superb impressive exclusive prestigious
    unique exceptional head stylish fancy posh custom grand stately luxury luxurious budget starter ideal
    """.split()
)
"""Words before a kind of building for where it stands, whose it is or how it pleases, which no plan could answer, and
for its height ("high-rise"), which its storeys answer."""
_KINDS = frozenset({"room", "building", "object", "stair", "elevator"})


def unheeded_words(reading: Reading, phrases: Sequence[Phrase], facts: BriefFacts) -> list[Span]:
    """Return the properties that noun phrases ask for and that nothing is made of, each as it is written.

    Parameters
    ----------
    phrases : sequence of Phrase
        All noun phrases; those of people and of unread things are passed over.
    """
    heeded = [span for _, span in (*facts.styles, *facts.shapes, *facts.size)]
    heeded += [fact.span for fact in facts.materials] + [fact.span for fact in facts.clutter]
    starts = {span.start for name, span in facts.building if span.words}
    found: list[Span] = []
    for phrase in phrases:
        if phrase.head not in _KINDS:
            continue
        properties = _properties(reading, phrase) + _widths_of_beds(reading, phrase) + _loads(reading, phrase)
        if reading.tokens[phrase.begin].start in starts and not phrase.plural:
            told = {at for first, last in properties for at in range(first, last)}
            properties += [run for run in subject_of_building(reading, phrase) if told.isdisjoint(range(*run))]
        for first, last in properties:
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


def _widths_of_beds(reading: Reading, phrase: Phrase) -> list[tuple[int, int]]:
    """Return the token that says for how many a bed is wide: "double", "king-size"; beds are drawn of any width."""
    if phrase.head != "object" or phrase.category != "bed":
        return []
    return [(at, at + 1) for at in range(phrase.first, phrase.noun_end) if reading.word(at) in _WIDTHS_OF_BEDS]


def _loads(reading: Reading, phrase: Phrase) -> list[tuple[int, int]]:
    """Return the token that says what a lift carries besides people: "goods lift"; all lifts are alike."""
    if phrase.head != "elevator":
        return []
    return [(at, at + 1) for at in range(phrase.first, phrase.noun_end - 1) if reading.word(at) in _LOADS]


_LOADS = frozenset("good goods freight cargo bed stretcher car vehicle service food platform".split())
_WIDTHS_OF_BEDS = frozenset({"single", "double", "king", "queen"})


def subject_of_building(reading: Reading, phrase: Phrase) -> list[tuple[int, int]]:
    """Return the tokens that say what a building is about, before those of its kind: "bike" of "a bike shop".

    Words for where it stands or whose it is are left out, and so are names: "the Miller house".
    """
    runs: list[tuple[int, int]] = []
    kind = reading.knowledge.buildings.get(phrase.building)
    at_home = kind is not None and kind.family in ("home", "lodging")
    if kind is not None and kind.name in _DESK_WORK:
        return []  # "an insurance office" has the desks of any other
    for index in range(phrase.begin, _core(reading, phrase)):
        for_cars = "car" in phrase.building or "garage" in phrase.building
        vehicle = reading.word(index) == "car" and reading.kind(index - 1) != "number" and not for_cars
        if not (_is_subject(reading, index) or vehicle) or (at_home and _owns(reading, index)):
            continue
        first = index
        while first > phrase.begin and _joined(reading, first) and reading.kind(first) == "word":
            first -= 1  # "black-box theatre"
        if runs and runs[-1][1] >= first:
            runs[-1] = (runs[-1][0], index + 1)
        else:
            runs.append((first, index + 1))
    return runs


_DESK_WORK = frozenset({"office", "startup_office", "coworking"})
"""Buildings that are alike, whatever those who sit there work on."""


def _owns(reading: Reading, index: int) -> bool:
    words = reading.span(index, index + 1).words
    return "'" in words or "’" in words


def _is_subject(reading: Reading, index: int) -> bool:
    word, token = reading.word(index), reading.tokens[index]
    if not token.spaced and reading.kind(index - 1) in ("number", "ordinal"):
        return False  # "a second-hand bookshop"
    called = reading.text[token.start].isupper() and not reading.starts(index) and not word.endswith(_ADJECTIVAL)
    return (
        reading.kind(index) == "word"
        and len(word) > 1
        and word not in FUNCTION_WORDS | PLAIN | UNITS_OF_ROOMS | _SETTINGS | _DWELLINGS
        and not is_size(word)
        and not is_property(word)
        and not called
        and not any(m.style and m.first <= index < m.last for m in reading.mentions)
    )


_ADJECTIVAL = ("an", "ese", "ish", "tine", "rine")
_DWELLINGS = frozenset("apartment flat house home penthouse duplex triplex maisonette studio loft building".split())


def taken_for_its_head(reading: Reading, phrase: Phrase) -> bool:
    """Whether a room of a known kind is called after something that the kind has nothing of: "a turbine hall"."""
    if phrase.head != "room" or not phrase.known or not phrase.room_type:
        return False
    noun, synonyms = phrase.noun_end - 1, reading.knowledge.room(phrase.room_type).synonyms
    if any(" ".join(reading.words(first, noun + 1)) in synonyms for first in range(phrase.begin, noun)):
        return False
    *before, last = phrase.name.split("_")
    if phrase.begin == noun and last != reading.word(noun):  # "galleries (coral, jellyfish)"
        return any(is_for_another_subject(phrase.room_type, last, word) and len(word) > 1 for word in before)
    return any(
        is_for_another_subject(phrase.room_type, reading.word(noun), reading.word(index))
        and (_is_subject(reading, index) or reading.word(index) == "car")  # which else counts the places of a garage
        for index in range(phrase.begin, noun)
    )


def _is_own(reading: Reading, phrase: Phrase, index: int) -> bool:
    """Whether a word is a property of what its phrase names: not "corner" in "children's corner room"."""
    if reading.kind(index) != "word" or (reading.word(index) == "corner" and index > phrase.begin):
        return False
    if is_size(reading.word(index)):
        return phrase.head == "object" or (not phrase.size and not _is_measured(reading, phrase))
    if reading.word(index) == "central":
        return phrase.room_type in _WAYS or phrase.head == "stair"
    if phrase.head == "building" and reading.word(index) in _ORIGINS:
        return True
    if phrase.head == "object" and _tells_kind(reading, phrase, index):
        return True
    return is_property(reading.word(index), things=phrase.head == "object")


_WAYS = frozenset({"hallway", "corridor", "atrium", "living_room"})
"""Rooms that may be asked to lie in the middle; a central kitchen or store is one for all."""
_FORMS_OF_THINGS = frozenset(
    """
    recliner reclining rocking swivel folding extendable extending convertible canopy poster sectional freestanding
    gas induction hanging mounted stacking telescopic roll rolling wheeled tilting adjustable heated upholstered padded
    """.split()
)
"""Words for the form of furniture, of which assets have none but their category's."""
_USUAL = {
    "table": frozenset("kitchen dining breakfast family guest farmhouse lunch dinner eating restaurant cafe".split()),
    "bed": frozenset("guest child kid family hotel parent visitor twin sleeping".split()),
}
"""What tables and beds that are like any other are for, by the noun."""


def _tells_kind(reading: Reading, phrase: Phrase, index: int) -> bool:
    """Whether a word before a thing's name tells a kind of it that its category does not: "a treatment table"."""
    word, noun = reading.word(index), reading.word(phrase.noun_end - 1)
    if word in _FORMS_OF_THINGS:
        return True
    category, _ = furniture_of((word,))
    if category and category != phrase.category and of_one_kind(category, phrase.category):
        return True
    plain = word in FUNCTION_WORDS | PLAIN | {"size", "sized"} or is_size(word) or word.endswith("ly")
    return noun in _USUAL and _core(reading, phrase) == phrase.noun_end - 1 and not plain and word not in _USUAL[noun]


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
