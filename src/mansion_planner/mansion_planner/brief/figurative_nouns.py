"""Tell nouns that name nothing to build: verbs, pictures, modifiers of another noun."""

from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.phrase import FUNCTION_WORDS, PLAIN, PREDICATES
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["is_figurative", "is_modifier"]


def is_figurative(reading: Reading, begin: int, end: int) -> bool:
    """Whether a noun names nothing to build: "see table", "ten sofas on display", "they sold the car"."""
    noun, lead = reading.word(begin), reading.word(begin - 1)
    if end - begin > 1:
        return False
    if lead in ("the", "our", "my", "their") and reading.word(begin - 2) in ("sold", "sell"):
        return True
    if lead in ("they", "we", "you", "people") or lead in _MODALS:
        return True  # "they slide down a pole", "where a robot can vacuum": a verb
    if noun == "present" and lead in _COPULAS:
        return True  # "a lift is present"
    if noun == "storage" and lead == "with" and furniture_of(reading.words(begin - 2, begin - 1))[0]:
        return True  # "a sofa with storage underneath"
    if noun == "snug" and (lead in _COPULAS or (lead in ("and", ",") and reading.word(begin - 2) in PLAIN)):
        return True  # "the bedrooms should be warm and snug"
    if noun == "flat" and not reading.plural(begin) and (_is_level(reading, end) or _has_no_steps(reading, begin)):
        return True
    if noun in _PICTURES and reading.word(end) in ("for", "of") and not reading.plural(begin):
        first = begin - (lead in ("a", "an", "the", "our", "my"))
        return first == 0 or reading.word(first - 1) in _MADE  # "a map for a stealth game"
    if noun == "table" and not reading.plural(begin):
        return lead == "see" or (lead == "the" and reading.word(begin - 2) in ("see", "per"))
    return noun == "display" and lead == "on"


def _is_level(reading: Reading, index: int) -> bool:
    """Whether "flat" before a token says that something is level: "a flat simple rectangular plan", "a flat site"."""
    at = index
    while at < index + 4 and reading.word(at) not in _LEVEL_THINGS:
        if reading.word(at) not in PLAIN | {","} and at not in reading.taken:
            return False
        at += 1
    return reading.word(at) in _LEVEL_THINGS


def _has_no_steps(reading: Reading, index: int) -> bool:
    """Whether "flat" alone says that a building is level: "Flat, no stairs!", "all flat, without steps"."""
    lead, at = reading.word(index - 1), index + 1
    alone = reading.breaks(index - 1) or lead in _COPULAS | _QUITE | {","}
    marked = reading.word(at) in (",", "(", "-", "–", ":") or reading.word(at) in ("and", "so", "with")
    return alone and marked and reading.words(at + 1, at + 3) in _STEPLESS


_QUITE = frozenset("all completely totally entirely everything fully absolutely".split())
_STEPS = frozenset({"stair", "step", "staircase", "threshold", "storey", "level", "lift"})
_STEPLESS = frozenset((no, noun) for no in ("no", "without", "not") for noun in _STEPS) | {
    ("all", "on"), ("one", "level"), ("one", "floor"), ("step", "free"), ("on", "one"), ("single", "storey"),
}  # fmt: skip
"""What is said of a building that is called flat because nobody climbs in it."""
_LEVEL_THINGS = frozenset("plan roof site plot ground land terrain layout meadow country facade".split())
"""What can be flat."""
_MODALS = frozenset({"can", "could", "will", "would", "may", "might", "shall", "cannot"})
_COPULAS = frozenset("is are be feel feels look looks very so stay keep".split())
"""Words after which an adjective stands."""
_PICTURES = frozenset({"map", "model", "picture", "drawing", "globe"})
_MADE = frozenset("make create build generate want need design draw plan".split())
"""What a brief asks to be made, of which the whole building is the picture."""


def is_modifier(reading: Reading, end: int) -> bool:
    """Whether furniture only tells apart the noun after it: "a computer game", "a chess club"."""
    counted = reading.plural(end - 1) or reading.kind(end - 2) == "number"
    noun = (
        reading.kind(end) == "word"
        and reading.word(end) not in FUNCTION_WORDS | PLAIN | PREDICATES | FLOOR_WORDS | _NO_NOUNS
    )
    done = reading.word(end).endswith("ing") and (reading.breaks(end + 1) or reading.word(end + 1) == ",")
    return not counted and noun and (done or not reading.word(end).endswith(("ly", "ed", "ing")))


_NO_NOUNS = frozenset("ea too instead somewhere optional ready available kit set piece".split())
"""Words after a piece of furniture that it is not the modifier of."""
