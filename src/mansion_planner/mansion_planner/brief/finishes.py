"""Read what a brief says of style, materials, and how high ceilings are to be."""

import itertools

from mansion_language.units import LENGTH
from mansion_planner.brief.corrections import taken_back_by
from mansion_planner.brief.facts import HeightFact, MaterialFact
from mansion_planner.brief.lexicon import Mention
from mansion_planner.brief.phrase import FUNCTION_WORDS
from mansion_planner.brief.qualifiers import is_property
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.similarity import room_of_building

__all__ = ["read_floorings", "read_heights", "read_materials", "read_style", "room_after"]

_MATERIALS = (
    "oak",
    "walnut",
    "pine",
    "maple",
    "birch",
    "bamboo",
    "cherry",
    "ash",
    "parquet",
    "hardwood",
    "wooden",
    "wood",
    "timber",
    "laminate",
    "marble",
    "granite",
    "limestone",
    "travertine",
    "slate",
    "stone",
    "terrazzo",
    "concrete",
    "tile",
    "tiled",
    "ceramic",
    "porcelain",
    "carpet",
    "carpeted",
    "vinyl",
    "linoleum",
    "rubber",
    "cork",
    "brick",
    "plaster",
    "wallpaper",
    "stucco",
    "glass",
    "terracotta",
    "mosaic",
    "epoxy",
    "panelled",
    "paneled",
    "panelling",
)

_COLOURS = (
    "white",
    "black",
    "gray",
    "grey",
    "beige",
    "blue",
    "green",
    "red",
    "yellow",
    "cream",
    "dark",
    "light",
    "polished",
    "exposed",
    "warm",
    "brown",
    "pink",
    "painted",
    "glossy",
    "matte",
    "pale",
    "orange",
    "navy",
    "turquoise",
    "purple",
    "ivory",
    "charcoal",
    "herringbone",
)

_SURFACES = {"floor": "floor", "flooring": "floor", "wall": "wall"}


_STYLE_NOUNS = frozenset(
    """
    style look feel feeling character design interior manner spirit flavour flavor aesthetic vibe taste decor theme
    colour color palette furniture fittings touch atmosphere decoration ambience ambiance mood chic
    """.split()
)


_OF_THE_COUNTRY = frozenset(
    {"house", "manor", "home", "estate", "hotel", "inn", "villa", "retreat", "club", "pub", "school"}
)


def read_style(reading: Reading, *, named: bool) -> None:
    """Read the style; a style word inside a room's name ("modern kitchen") counts as well.

    Parameters
    ----------
    named : bool
        Whether to read only those that are called a style ("industrial loft look"), or all others.
    """
    for mention in reading.mentions:
        modifies = not named and reading.modifiers.issuperset(range(mention.first, mention.last))
        if not mention.style or not (modifies or reading.free(mention.first, mention.last)):
            continue
        if modifies and _is_of_a_room(reading, mention):
            continue  # "two bright bedrooms" and "a grand hall" say nothing of the building
        if reading.word(mention.last) in ("rectangle", "rectangular", "box", "outline", "art"):
            continue
        if reading.word(mention.first) == "country" and reading.word(mention.last) in _OF_THE_COUNTRY:
            continue  # where it stands
        if _is_too_much(reading, mention.first):
            reading.take(mention.first - 2, mention.last)
            continue
        if reading.word(mention.first) == "modern" and _ends_style(reading, mention.first):
            reading.take(mention.first, mention.last)
            continue  # "mid-century modern" is one style
        if not named and _tells_no_style(reading, mention, modifies=modifies):
            continue
        last = mention.last
        while last < mention.last + 2 and reading.kind(last) == "word" and reading.word(last) not in _STYLE_NOUNS:
            last += 1
        called = reading.word(last) in _STYLE_NOUNS or "style" in reading.words(mention.first - 3, mention.first)
        if named and not called:
            continue
        if reading.word(last) in _STYLE_NOUNS:
            reading.take(last, last + 1)
        following = reading.mention_at.get(mention.last)
        terrace = following is not None and following.room == "roof_terrace" and reading.word(following.last) != "house"
        if not called and _is_subject(reading, mention):
            continue
        if not called and (mention.room or mention.building or terrace or reading.word(mention.first) == "green"):
            continue
        _replace_style(reading, mention.first)
        reading.facts.styles.append((mention.style, reading.span(mention.first, mention.last)))
        reading.take(mention.first, mention.last)
        lead = mention.first - 1
        while reading.word(lead) in ("is", "be", "should", "must", "will", ":", "="):
            lead -= 1
        if reading.word(lead) == "style":
            reading.take(lead, lead + 1)  # "the style is neoclassicism"
    # A style with a name of its own says more than "plain" or "traditional".
    reading.facts.styles.sort(
        key=lambda style: (is_property(style[1].words.lower()), reading.knowledge.styles[style[0]].like == "")
    )


def _is_too_much(reading: Reading, index: int) -> bool:
    """Whether a style word says how the building is not to be: "nothing too modern", "not too rustic"."""
    return reading.word(index - 2) in ("nothing", "not", "never") and reading.word(index - 1) in (
        "too",
        "very",
        "overly",
    )


def _ends_style(reading: Reading, index: int) -> bool:
    """Whether the style of the middle of a century was read right before a token."""
    return any(
        style == "mid_century" and span.end == reading.tokens[index - 1].end for style, span in reading.facts.styles
    )


def _replace_style(reading: Reading, index: int) -> None:
    """Leave out the style before a token if the words between take it back: "modern - no, rustic"."""
    styles = reading.facts.styles
    ends = {token.end: at + 1 for at, token in enumerate(reading.tokens[:index])}
    before = ends.get(styles[-1][1].end) if styles else None
    sign = taken_back_by(reading.tokens, before, index) if before is not None else None
    if sign is not None:
        styles.pop()
        reading.take(sign, index)


_CLAIMS = frozenset({"bright", "green", "sustainable"})
"""Style words that before the building say more than how it looks."""


def _is_of_a_room(reading: Reading, mention: Mention) -> bool:
    """Whether a style's word before a noun is a property of what that names, rather than the style of the building."""
    word, at = reading.word(mention.first), mention.last
    while at in reading.modifiers and at not in reading.mention_at:
        at += 1
    following = reading.mention_at.get(at)
    building = following is not None and following.building and not following.room
    if building and word not in _CLAIMS:
        return False
    return is_property(word) or word == "grand"


def _is_subject(reading: Reading, mention: Mention) -> bool:
    """Whether a style's word is part of what a building is about: "a museum of natural history"."""
    noun = reading.kind(mention.last) == "word" and reading.word(mention.last) not in FUNCTION_WORDS
    return reading.word(mention.first - 1) == "of" and noun and mention.last not in reading.mention_at


def _tells_no_style(reading: Reading, mention: Mention, *, modifies: bool) -> bool:
    """Whether a word that can be a style tells what a room is for, or where the building stands.

    "Raw material storage" and "an industrial kitchen" are rooms, "in an industrial park" is a place.
    """
    following = reading.mention_at.get(mention.last)
    if following is None and reading.word(mention.last) in _SITES:
        return True
    building = following is not None and bool(following.building)  # "an industrial loft apartment" looks so
    return modifies and not building and reading.word(mention.first) in _PURPOSES


_PURPOSES = frozenset("raw industrial urban natural organic green sterile hygienic sustainable fun country".split())
"""Styles that are words for a use or a substance before a noun."""
_SITES = frozenset("park estate zone area district region site town city village quarter street road side".split())


def read_materials(reading: Reading) -> None:
    """Read materials: "oak floors", "marble flooring in the lobby", "white walls", "the walls are light grey"."""
    last, rooms = -1, [""]
    for i in range(len(reading.tokens)):
        surface = _SURFACES.get(reading.word(i))
        if surface is None:
            continue
        found = _attributive(reading, i) or _predicative(reading, i) or _laid_on(reading, i)
        first, end, words = found or (0, 0, "")
        if not words or (surface == "floor" and not any(m in words for m in _MATERIALS)):
            continue
        goes_on = not last < 0 and all(word in _JOINING for word in reading.words(last, first))
        rooms = _rooms_meant(reading, first, i, end) or (rooms if goes_on and last < first else [""])
        throughout = not _EVERYWHERE.isdisjoint((reading.word(first - 1), reading.word(end)))
        for room in rooms:
            reading.facts.materials.append(
                MaterialFact(surface, words, room, reading.span(first, end), throughout)  # type: ignore[arg-type]
            )
        reading.take(first, end)
        last = end


def read_floorings(reading: Reading) -> None:
    """Read floors that are called by their own name, where nothing else was read from it: "a study in oak parquet"."""
    for index in range(len(reading.tokens)):
        if reading.word(index) in _FLOORINGS and index not in reading.taken:
            _read_flooring(reading, index)


def _read_flooring(reading: Reading, index: int) -> None:
    if not (reading.breaks(index + 1) or reading.word(index + 1) in _AFTER_FLOORINGS):
        return
    first = _material_ending(reading, index) or index + 1
    if reading.word(first - 2) not in ("with", "in"):
        return
    here = [m for m in reading.mentions if m.last < first and reading.sentence[m.first] == reading.sentence[index]]
    rooms = [m.room for m in here[-1:] if m.room and not m.building]
    if rooms:
        words, span = _text(reading, first - 1, index + 1), reading.span(first - 1, index + 1)
        reading.facts.materials.append(MaterialFact("floor", words, rooms[0], span))
        reading.take(first - 1, index + 1)


_FLOORINGS = frozenset({"parquet", "laminate", "linoleum", "lino", "terrazzo", "floorboard"})
"""Nouns for a floor, which need no other."""
_AFTER_FLOORINGS = frozenset({",", "and", ";", ")", "in", "throughout", "or", "with"})
_JOINING = frozenset({"and", ",", "a", "an", "the", "with"})
_EVERYWHERE = frozenset({"all", "every", "throughout", "everywhere"})
_HAVING = frozenset("has have get gets need needs with should must will a an the its their : would want".split())
"""Words between a room and what its floor or walls are made of: "the kitchen should have a marble floor"."""
_COPULAS = frozenset({"is", "are", "be", "should", "must", "shall", "in", "made", "of", "painted", ":", "=", "all"})
"""Words between walls or floors and what they are made of: "the walls should be painted in light grey"."""
_OF_COLOUR = frozenset({"colour", "color"})


def _attributive(reading: Reading, noun: int) -> tuple[int, int, str] | None:
    """Return where "black marble floor" begins and ends, and its material; nothing where no material leads the noun."""
    first = _material_ending(reading, noun)
    if not first or reading.word(noun + 1) in ("between", "around"):
        return None  # "glass walls between the offices" are not all walls
    return first - 1, noun + 1, _text(reading, first - 1, noun)


def _predicative(reading: Reading, noun: int) -> tuple[int, int, str] | None:
    """Return the same of "the walls of the lobby are white", "colour of the walls: light grey"."""
    at = noun + 1 + (reading.word(noun + 1) in _OF_COLOUR)
    if reading.word(at) in ("of", "in") and reading.word(at + 1) in ("the", "all", "every", "each"):
        mention = reading.mention_at.get(at + 2)
        at = mention.last if mention is not None and (mention.room or mention.building) else at
    start = at
    while reading.word(at) in _COPULAS:
        at += 1
    end = at
    while reading.word(end) in _MATERIALS or reading.word(end) in _COLOURS:
        end += 1
    end += end > at and reading.word(end) in _OF_COLOUR  # "walls all white color"
    closed = reading.breaks(end) or reading.word(end) in (",", ")", "and", "in", "throughout", "everywhere", "please")
    if at == start or end == at or not closed:
        return None
    first = noun
    while reading.word(first - 1) in ("the", "of") or reading.word(first - 1) in _OF_COLOUR:
        first -= 1
    return first, end, _text(reading, at, end - (reading.word(end - 1) in _OF_COLOUR))


def _laid_on(reading: Reading, noun: int) -> tuple[int, int, str] | None:
    """Return the same of "terracotta tiles on the floor", "white tiles on the walls"."""
    at = noun - 1 - (reading.word(noun - 1) in ("the", "all"))
    first = _material_ending(reading, at)
    tiled = reading.word(at - 1) in _MATERIALS
    return (
        (first - 1, noun + 1, _text(reading, first - 1, at)) if first and tiled and reading.word(at) == "on" else None
    )


def _text(reading: Reading, first: int, last: int) -> str:
    return reading.text[reading.tokens[first].start : reading.tokens[last - 1].end].lower()


def _rooms_meant(reading: Reading, first: int, noun: int, end: int) -> list[str]:
    """Return the room types that a material is said of, before its words or after them; nothing where none is named."""
    after = end if end == noun + 1 else noun + 1  # "the walls of the lobby are white"
    if reading.word(after) in ("in", "for", "throughout", "of"):
        found, at = [room_after(reading, after + 1)], after + 1
        while found[0] and (joint := _joint_after(reading, at)):
            found.append(room_after(reading, joint))
            at = joint
        if found[0]:
            units = [room for room in found if room and reading.knowledge.room(room).unit]
            return [""] if units else [room for room in found if room]  # a flat is more than the room it is entered by
    at = first
    while reading.word(at - 1) in _HAVING:
        at -= 1
    named = [m for m in reading.mentions if m.last == at and m.room and not m.building]
    if not named and "on" in reading.words(noun - 2, noun):  # "a kitchen with a stove, tiles on the floor"
        here = [m for m in reading.mentions if m.last <= first and reading.sentence[m.first] == reading.sentence[first]]
        named = [m for m in here[-1:] if m.room and not m.building]
    return [named[0].room] if named else []


def _joint_after(reading: Reading, index: int) -> int:
    """Return what follows "and" behind the room at a token ("in the kitchen and the hall"); 0 where nothing does."""
    for at in range(index, index + 4):
        mention = reading.mention_at.get(at)
        if mention is not None:
            return mention.last + 1 if reading.word(mention.last) == "and" else 0
    return 0


def _material_ending(reading: Reading, end: int) -> int:
    """Return one more than the first token of the material words that end before `end`, or 0."""
    first = end
    while (
        first > 0 and (reading.word(first - 1) in _MATERIALS or reading.word(first - 1) in _COLOURS) and end - first < 4
    ):
        first -= 1
    return first + 1 if first < end else 0


def room_after(reading: Reading, index: int) -> str:
    """Return the room type named within four words from `index`, in the same clause; empty for none."""
    for at in range(index, index + 4):
        mention = reading.mention_at.get(at)
        if mention is not None and (mention.room or mention.building):
            whole = not mention.room and reading.word(at - 1) in ("the", "whole", "entire") and not reading.plural(at)
            return "" if whole else mention.room or room_of_building(mention.building, reading.knowledge)
        if reading.breaks(at) or reading.word(at) in (",", "and", "with"):
            break
    return ""


def read_heights(reading: Reading) -> None:
    """Read "ceilings 5 m high", "a ceiling height of 3.5 m in the hall", "4.5 m ceiling"."""
    for index, token in enumerate(reading.tokens):
        if token.text not in ("ceiling", "headroom") or index in reading.taken:
            continue
        number = _height_near(reading, index)
        if number is None:
            continue
        height = reading.value(number) * LENGTH[reading.word(number + 1)]
        first, last = min(index, number), max(index + 1, number + 2)
        last += reading.word(last) in ("high", "height")
        room = room_after(reading, last + 1) if reading.word(last) in ("in", "for") else ""
        reading.facts.heights.append(HeightFact(height, room, reading.span(first, last)))
        reading.take(first, last)


def _height_near(reading: Reading, index: int) -> int | None:
    """Return the number of metres or feet that is said of a ceiling: after it in its sentence, else before it."""
    after = itertools.takewhile(lambda number: not reading.breaks(number), range(index + 1, index + 7))
    for number in (*after, *range(index - 1, index - 5, -1)):
        if reading.kind(number) == "number" and reading.word(number + 1) in LENGTH and number not in reading.taken:
            height = reading.value(number) * LENGTH[reading.word(number + 1)]
            return number if 1.8 <= height <= 30 else None
    return None
