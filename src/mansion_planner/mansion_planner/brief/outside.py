"""Read what a brief says of the outside: what the building is built of, its roof, and what lies on its plot.

The words are taken before noun phrases are found, so that "a red-brick school" is a school and "a garden with a pool"
has no pool indoors.
"""

from collections.abc import Mapping
from typing import Final, TypeVar

from mansion_knowledge.outside_words import outside_words
from mansion_msgs_py.outside import GroundUse
from mansion_planner.brief.facts import OutsideFact
from mansion_planner.brief.lexicon import Mention
from mansion_planner.brief.reading import Reading

__all__ = ["read_outside"]

_Value = TypeVar("_Value", bound=str)

LONGEST: Final = 5
"""Most words of a phrase of the outside."""

MOST_PLACES: Final = 400
"""Most places to park on a plot."""

_RULED_OUT = frozenset({"no", "not", "n't", "isn't", "without", "never", "instead", "rather", "avoid"})
"""Words right before or after a phrase by which it is not wanted."""

_WALLS = frozenset({"facade", "exterior", "cladding", "frontage"})
"""Nouns that mean the outer walls wherever they stand."""
_OUTER = frozenset({"outer", "outside", "exterior", "external"})
_CLAD = frozenset("clad built faced rendered painted made constructed wrapped dressed cladded sheathed".split())
_PARTS = frozenset("floor beam frame framed stair door window column structure furniture table ceiling roof".split())
"""Nouns that a substance before them belongs to, not to the walls."""
_LEADS = frozenset({"in", "with", "of", "from", "out"})
_COPULAS = frozenset("is are be should must shall in of made : = a an the all completely entirely fully".split())
_BEFORE_KIND = frozenset("tall long small large big low single double detached new old modern little single".split())
"""Words that may stand between a building's colour and its kind: "a white detached house"."""
_MADE_THERE = frozenset("museum gallery factory workshop shop store studio centre center market yard plant".split())
"""Kinds of buildings before which a bare substance says what they are about: "a glass museum"."""
_SUBJECTS = frozenset("glass stone wood wooden timber metal steel concrete brick log terracotta plaster".split())
_ECOLOGICAL = frozenset({"green", "black", "red", "blue"})
"""Colours that before a kind of building often mean something else: "a green office", "a black box theatre"."""
_PAINTED_HOMES = frozenset({"house", "cottage", "villa", "cabin", "farmhouse", "bungalow", "barn", "townhouse"})

_ROOFED = frozenset({"roofed", "roof"})
_OF_A_ROOF_NOUN = frozenset("terrace garden deck bar pool top light window lounge space level floor storey".split())
_OUTDOORS = frozenset("outdoors outside outdoor".split())
_YARDS = frozenset("garden backyard yard".split())
_BESIDE = frozenset("behind beside around at along next before".split())
_WHOLE = frozenset("building house plot site property villa hotel school garden block entrance premises home".split())
_SITES = (("in", "front"), ("in", "the", "front"), ("on", "the", "plot"), ("on", "the", "site"), ("at", "the", "back"))
_SEVERAL = 3
"""Number of cars from which on parking is no garage of a home."""
_BELOW = frozenset("basement underground cellar garage semi sub multi subterranean".split())
"""Words for places to park indoors, wherever they stand in a sentence."""
_OF_STOREYS = frozenset("floor storey level ground below above top first second third deck".split())
"""Words beside parking that make it part of a storey."""
_ARTICLES = frozenset(
    {"a", "an", "its", "own", "with", "and", ",", "plu", "plus", "+", "&", ":", "has", "have", "needs"}
)
_AFTER_GROUNDS = frozenset(
    """with and , . ; : ! ? ( ) in at on for behind around to that which where of or but by beside along next outside
    please facing all big is are should must front""".split()
)


def read_outside(reading: Reading) -> None:
    """Read walls, roof and grounds, and take their words."""
    _read_walls(reading)
    _read_building_words(reading)
    _read_roof(reading)
    _read_grounds(reading)


def _phrase_ending(reading: Reading, end: int, known: Mapping[str, _Value]) -> tuple[int, _Value] | None:
    """Return where the longest known phrase that ends before a token begins, and what it stands for."""
    for first in range(max(0, end - LONGEST), end):
        value = known.get(" ".join(reading.words(first, end)))
        if value is not None and reading.free(first, end):
            return first, value
    return None


def _phrase_at(reading: Reading, first: int, known: Mapping[str, _Value]) -> tuple[int, _Value] | None:
    """Return where the longest known phrase that begins at a token ends, and what it stands for."""
    for end in range(min(len(reading.tokens), first + LONGEST), first, -1):
        value = known.get(" ".join(reading.words(first, end)))
        if value is not None and reading.free(first, end):
            return end, value
    return None


def _record(reading: Reading, first: int, last: int, fact: OutsideFact) -> None:
    """Record a fact, and take its words from all that is read later; what is ruled out is left to other readers."""
    before, after = reading.words(first - 2, first), reading.words(last, last + 2)
    if not (_RULED_OUT.isdisjoint(before) and _RULED_OUT.isdisjoint(after)):
        return
    reading.facts.outside.append(fact)
    reading.take(first, last)
    for index in range(first, last):
        reading.mention_at.pop(index, None)
    reading.mentions[:] = [m for m in reading.mentions if m.last <= first or m.first >= last]


def _record_walls(reading: Reading, first: int, last: int, material: str) -> None:
    _record(reading, first, last, OutsideFact("facade", material, reading.span(first, last)))


def _read_walls(reading: Reading) -> None:
    """Read "red brick facade", "the facade is glass", "clad in timber", "outer walls of stone", "zinc-clad"."""
    known = {**outside_words().colours, **outside_words().substances}
    for index in range(len(reading.tokens)):
        word = reading.word(index)
        if index in reading.taken:
            continue
        outer = word == "wall" and (reading.word(index - 1) in _OUTER or reading.word(index + 1) == "outside")
        front = word == "front" and _phrase_ending(reading, index, outside_words().substances) is not None
        if word in _WALLS or outer or (front and reading.word(index + 1) not in ("door", "desk", "room", "garden")):
            _walls_at(reading, index - (outer and reading.word(index - 1) in _OUTER), index + 1, known)
        elif word in _CLAD and not _clad_before(reading, index):
            _clad_after(reading, index)


def _walls_at(reading: Reading, first: int, last: int, known: Mapping[str, str]) -> None:
    """Read what is said of outer walls whose noun has tokens `first` to `last` (exclusive)."""
    before = _phrase_ending(reading, first, known)
    if before is not None:
        _record_walls(reading, before[0], last, before[1])
        return
    last += reading.word(last) in _OUTER
    at = last
    while reading.word(at) in _COPULAS | _CLAD | _LEADS:
        at += 1
    after = _phrase_at(reading, at, known) if at > last else None
    if after is not None:
        _record_walls(reading, first, after[0], after[1])


def _clad_before(reading: Reading, index: int) -> bool:
    """Read "timber-clad", "brick-built"; whether that stands there."""
    before = _phrase_ending(reading, index, outside_words().substances)
    joined = not reading.tokens[index].spaced
    if before is None or not (joined or reading.word(index) == "clad"):
        return False
    _record_walls(reading, before[0], index + 1, before[1])
    return True


def _clad_after(reading: Reading, index: int) -> None:
    """Read "clad in timber", "built of brick", "rendered in white"; what a room is clad in is not meant."""
    at = index + 1
    while reading.word(at) in _LEADS or reading.word(at) in ("a", "the"):
        at += 1
    coloured = reading.word(index) in ("rendered", "painted")
    known = {**outside_words().colours, **outside_words().substances} if coloured else outside_words().substances
    after = _phrase_at(reading, at, known) if at > index + 1 else None
    part = after is None or reading.word(after[0]) in _PARTS or after[0] in reading.mention_at
    if after is not None and not part and _is_said_of_building(reading, index):
        first = index - (reading.word(index - 1) in ("is", "be", "all"))
        _record_walls(reading, first, after[0], after[1])


def _is_said_of_building(reading: Reading, index: int) -> bool:
    """Whether the last noun before a token is a kind of building, or the building itself."""
    at = index - 1
    while at >= 0 and not reading.breaks(at):
        named = next((m for m in reading.mentions if m.last == at + 1), None)
        if named is not None:
            return bool(named.building) and not (named.room and named.first not in _heads(reading))
        if reading.word(at) in ("building", "it", "house", "block"):
            return True
        at -= 1
    return at < 0


def _heads(reading: Reading) -> set[int]:
    """Return where the first kind of building of the brief is named."""
    first = next((m.first for m in reading.mentions if m.building), -1)
    return {first}


def _read_building_words(reading: Reading) -> None:
    """Read what stands before the kind of building: "a red-brick school", "a white two-storey villa"."""
    for mention in list(reading.mentions):
        if not mention.building or mention.first in reading.taken or reading.plural(mention.last - 1):
            continue
        end = mention.first
        while end > 0 and _may_stand_between(reading, end - 1):
            end -= 1
        for at in range(mention.first, end - 1, -1):
            found = _of_building(reading, mention, at)
            if found is not None:
                _record_walls(reading, found[0], at, found[1])
                return
        if mention.building:
            return


def _may_stand_between(reading: Reading, index: int) -> bool:
    word = reading.word(index)
    counted = reading.kind(index) == "number" or word in ("storey", "story", "storied", "storeyed", "level", "floor")
    styled = any(m.style and m.first <= index < m.last for m in reading.mentions)
    return index not in reading.taken and (counted or styled or word in _BEFORE_KIND or word == "building")


def _of_building(reading: Reading, mention: Mention, at: int) -> tuple[int, str] | None:
    """Return where the material of a building begins that ends before a token, and its name."""
    substance = _phrase_ending(reading, at, outside_words().substances)
    if substance is not None:
        bare = at - substance[0] == 1 and reading.word(at - 1) in _SUBJECTS
        about = bare and reading.word(mention.last - 1) in _MADE_THERE
        return None if about else substance
    colour = _phrase_ending(reading, at, outside_words().colours)
    if colour is None or reading.word(at - 2) in ("and", "/"):
        return None
    usual = reading.word(at - 1) not in _ECOLOGICAL or reading.word(mention.last - 1) in _PAINTED_HOMES
    return colour if usual else None


def _read_roof(reading: Reading) -> None:
    """Read "a pitched slate roof", "flat-roofed", "the roof is hipped", "a green roof", "roof: tiles"."""
    for index in range(len(reading.tokens)):
        if reading.word(index) not in _ROOFED or index in reading.taken or reading.word(index - 1) == "under":
            continue
        if reading.word(index + 1) in _OF_A_ROOF_NOUN and not reading.breaks(index + 1):
            continue
        form, covering, first = _roof_before(reading, index)
        last = index + 1
        if not (form or covering):
            form, covering, last = _roof_after(reading, index)
        more_form, more, after = _roof_after(reading, last - 1)
        if (more and not covering) or (more_form and not form):
            form, covering, last = form or more_form, covering or more, after
        if form or covering:
            _record(reading, first, last, OutsideFact("roof", form, reading.span(first, last), covering=covering))


def _roof_before(reading: Reading, index: int) -> tuple[str, str, int]:
    """Return the form and the covering that stand before a roof, and where their words begin."""
    words, form, covering, at = outside_words(), "", "", index
    while at > 0:
        found = _phrase_ending(reading, at, {**words.coverings, **words.roofs})
        if found is None:
            break
        first, _ = found
        phrase = " ".join(reading.words(first, at))
        form, covering = form or words.roofs.get(phrase, ""), covering or words.coverings.get(phrase, "")
        at = first
        if reading.word(at - 1) in (",", "and") and _phrase_ending(reading, at - 1, {**words.coverings, **words.roofs}):
            at -= 1
    return form, covering, at


def _roof_after(reading: Reading, index: int) -> tuple[str, str, int]:
    """Return the same of what is said after a roof, and where that ends."""
    words, at = outside_words(), index + 1
    while reading.word(at) in _COPULAS or reading.word(at) in ("covered", "with", "and"):
        at += 1
    found = _phrase_at(reading, at, {**words.coverings, **words.roofs}) if at > index + 1 else None
    if found is None:
        return "", "", index + 1
    last = found[0]
    phrase = " ".join(reading.words(at, last))
    closed = reading.breaks(last) or reading.word(last) in (",", "and", ")", "roof", "with", "please")
    if not closed:
        return "", "", index + 1
    return words.roofs.get(phrase, ""), words.coverings.get(phrase, ""), last


def _read_grounds(reading: Reading) -> None:
    """Read gardens, places to park, playgrounds, hedges, fences, and pools and parking that are outdoors."""
    index = 0
    while index < len(reading.tokens):
        own = _phrase_at(reading, index, outside_words().grounds)
        if own is not None and _is_wanted(reading, index, own[0]):
            index = _record_ground(reading, index, own[0], own[1])
            continue
        shared = _phrase_at(reading, index, outside_words().outdoor)
        if shared is not None and (last := _outdoors_until(reading, index, shared[0], shared[1])):
            index = _record_ground(reading, index, last, shared[1])
            continue
        index += 1


def _record_ground(reading: Reading, first: int, last: int, use: GroundUse) -> int:
    """Record a part of the plot, with the number of places before or after it; return where its words end."""
    count = 0
    if use == "parking":
        if reading.kind(first - 1) == "number" and reading.free(first - 1, first):
            first, count = first - 1, int(reading.value(first - 1))
        elif reading.word(last) in ("for", "with") and reading.kind(last + 1) == "number":
            count = int(reading.value(last + 1))
            last += 2
            while reading.word(last) in ("car", "vehicle", "space", "place", "spot", "bay", "parking"):
                last += 1
    last = _site_after(reading, last)
    span = reading.span(first, last)
    _record(reading, first, last, OutsideFact("grounds", "", span, count=min(count, MOST_PLACES), use=use))
    return last


def _site_after(reading: Reading, last: int) -> int:
    """Return where words end that say where on the plot something lies: "behind the house", "in front", "outside"."""
    at = last + (reading.word(last) in ("all", "right", "directly"))
    if reading.words(at, at + 3) == ("in", "front", "of"):
        at += 3
    elif reading.word(at) in _BESIDE:
        at += 1 + (reading.words(at, at + 2) == ("next", "to"))
    if at > last and reading.word(at) in ("the", "it"):
        at += reading.word(at) == "the"
        if reading.word(at) in _WHOLE or reading.word(at) == "it":
            return at + 1
    for site in _SITES:
        if reading.words(last, last + len(site)) == site:
            return last + len(site)
    return last + (reading.word(last) in _OUTDOORS)


def _is_wanted(reading: Reading, first: int, last: int) -> bool:
    """Whether a part of the plot is asked for, not a place or a part of another noun: "view of the garden"."""
    before, after = reading.word(first - 1), reading.word(last)
    closed = last >= len(reading.tokens) or after in _AFTER_GROUNDS or reading.breaks(last)
    closed = closed or (
        reading.word(first) == "fenced" and _phrase_at(reading, last, outside_words().grounds) is not None
    )
    led = first == 0 or before in _ARTICLES or reading.breaks(first - 1) or reading.kind(first - 1) == "number"
    qualified = not led and reading.word(first - 2) in ("a", "an", "its", "own") and reading.kind(first - 1) == "word"
    joined = before == "and" and reading.word(first - 2) in ("view", "to")
    if "around" in reading.words(first - 3, first):
        return False  # "U-shaped around a little garden" is a courtyard
    return closed and (led or (qualified and first - 1 not in reading.mention_at)) and not joined


def _outdoors_until(reading: Reading, first: int, last: int, use: GroundUse) -> int:
    """Return where the words of a pool or of parking end that is outdoors; 0 where it is a room."""
    here = _clause(reading, first)
    if use == "parking":
        near = reading.words(max(here[0], first - 2), min(here[1], last + 4))
        if not (_BELOW.isdisjoint(reading.words(*here)) and _OF_STOREYS.isdisjoint(near)):
            return 0
        behind = reading.value(last + 1) if reading.word(last) == "for" else 0.0
        counted = max(reading.value(first - 1), behind)
        sited = any(reading.words(last, last + len(site)) == site for site in _SITES)
        sited = sited or reading.word(last) in _OUTDOORS or reading.word(last) in ("behind", "beside")
        return last if counted >= _SEVERAL or sited else 0
    if reading.word(last) in _OUTDOORS:
        return last
    if reading.words(last, last + 2) in (("in", "the"), ("in", "a"), ("in", "its")):
        at = last + 2 + (reading.word(last + 2) in ("back", "front", "own", "large", "small"))
        return at + 1 if reading.word(at) in _YARDS else 0
    garden = any(reading.word(at) in _YARDS and at in reading.taken for at in range(max(here[0], first - 4), first))
    joined = reading.word(first - 1) in ("a", "an", "with") and "with" in reading.words(first - 3, first)
    return last if garden and joined else 0


def _clause(reading: Reading, index: int) -> tuple[int, int]:
    """Return the tokens of the sentence around one."""
    first = last = index
    while first > 0 and not reading.breaks(first - 1):
        first -= 1
    while last < len(reading.tokens) and not reading.breaks(last):
        last += 1
    return first, last
