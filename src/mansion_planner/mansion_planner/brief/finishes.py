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

__all__ = ["read_heights", "read_materials", "read_style", "room_after"]

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
    furniture fittings touch atmosphere decoration ambience ambiance mood chic
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
    """Read materials: "oak floors", "marble flooring in the lobby", "white walls", "a tiled kitchen"."""
    for i in range(len(reading.tokens)):
        surface = _SURFACES.get(reading.word(i))
        if surface is None or (surface == "floor" and not _material_ending(reading, i)):
            continue
        first = _material_ending(reading, i)
        if not first or reading.word(i + 1) in ("between", "around"):
            continue  # "glass walls between the offices" are not all walls
        words = reading.text[reading.tokens[first - 1].start : reading.tokens[i - 1].end].lower()
        if surface == "floor" and not any(m in words for m in _MATERIALS):
            continue
        room = ""
        if reading.word(i + 1) in ("in", "for", "throughout"):
            room = room_after(reading, i + 2)
        reading.facts.materials.append(
            MaterialFact(surface, words, room, reading.span(first - 1, i + 1))  # type: ignore[arg-type]
        )
        reading.take(first - 1, i + 1)


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
            return mention.room or room_of_building(mention.building, reading.knowledge)
        if reading.breaks(at) or reading.word(at) == ",":
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
