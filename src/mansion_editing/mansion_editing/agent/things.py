"""Noun phrases: number, colour, coldness and the noun itself, as the catalogue knows it."""

import re
from dataclasses import dataclass
from difflib import SequenceMatcher
from typing import Final

from mansion_assets.catalogue import Asset
from mansion_assets.catalogue.search import search_assets
from mansion_editing.agent.facts import Thing
from mansion_editing.agent.limits import EXAMPLES
from mansion_editing.references import find_rooms
from mansion_editing.state import SceneState
from mansion_editing.vocabulary import COLOUR_WORDS, stems
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["MOST_THINGS", "NUMBERS", "ThingWords", "is_known", "known_noun", "read_thing", "unknown", "untold"]

MOST_THINGS: Final = 20
"""Most copies of one thing that an instruction may ask for."""

_COUNTING: Final = [
    "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve", "thirteen",
    "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen", "twenty",
]  # fmt: skip
NUMBERS: Final = {
    **{word: number for number, word in enumerate(_COUNTING, start=1)},
    "a": 1, "an": 1, "another": 1, "single": 1, "couple": 2, "pair": 2, "dozen": 12,
    "hundred": 100, "thousand": 1000, "million": 10**6, "billion": 10**9,
}  # fmt: skip
"""Number words; those of many copies are there to be refused."""

_EVERY: Final = frozenset(["the", "all", "every", "each", "any", "everything", "both", "whatever"])
_COLD: Final = frozenset(["cold", "chilled", "cool", "cooled", "refrigerated", "iced"])
_IDLE: Final = frozenset([
    "fresh", "clean", "new", "small", "large", "big", "nice", "full", "empty", "least", "at", "please", "more",
    "exactly", "of", "these", "those", "that", "this", "is", "are", "which", "my", "our", "your", "their",
    "its", "his", "her", "some", "only", "just", "additional", "extra", "further", "other", "precisely",
    "coloured", "colored", "painted", "to", "be", "there", "atmost", "it", "them",
])  # fmt: skip
_BOUND: Final = frozenset([
    "to", "from", "with", "without", "and", "or", "not", "no", "the", "off", "out", "run", "delete", "all",
    "wall", "door", "room", "floor", "building", "house", "system",
])  # fmt: skip
"""Words that are never a mere description of the noun after them."""

_OF_ROOMS: Final = frozenset(["room", "floor", "building", "house", "system"])
"""Those of them that a room's name may hold."""

MOST_BEFORE: Final = 2
LIKE: Final = 0.8
_OPENING: Final = frozenset(["door", "doors", "lid"])
"""What of a thing opens: the microwave door is the microwave."""

_ANYTHING: Final = frozenset([
    "thing", "object", "stuff", "item", "content", "everything", "anything",
])  # fmt: skip


@dataclass(frozen=True)
class ThingWords:
    """A thing as it is said.

    Attributes
    ----------
    before : str
        Words before the noun that are not its own; a room's, perhaps.
    exact, more, most : bool
        Neither more nor less than the number; so many besides those that are there; no more than the number.
    """

    thing: Thing
    before: str = ""
    exact: bool = False
    more: bool = False
    most: bool = False


def unknown(what: str) -> MansionError:
    """Return the error for words that name nothing here."""
    return MansionError(
        ErrorCode.NOT_FOUND,
        f"not understood: {what[:80]!r} names no room of this building and nothing that the catalogue knows; "
        f"{EXAMPLES}",
        details={"words": what[:200]},
    )


def untold(state: SceneState, words: str, noun: str) -> MansionError | None:
    """Return the error for adjectives that nothing tells; None where every such thing of the catalogue is so.

    Parameters
    ----------
    words : str
        What stands before the noun and names no room (``slightly dented``).
    """
    assets = [asset for kind in state.vocabulary.nouns(noun) for asset in state.catalogue.by_category(kind)]
    for word in words.split():
        own = [word, word.removesuffix("en"), *stems(word)]
        if not assets or any(not _described(asset, own) for asset in assets):
            name = re.sub(r"^(?:the|an?) ", "", noun)[:60]
            return MansionError(
                ErrorCode.NOT_FOUND,
                f"not understood: {words[:60]!r}: no {name} is known to be so; say the {name} alone, or with a "
                f"colour; {EXAMPLES}",
                details={"words": words[:200]},
            )
    return None


def _described(asset: Asset, words: list[str]) -> bool:
    """Whether an asset's names, tags or materials have one of some words."""
    texts = (asset.name, asset.category, *asset.synonyms, *asset.tags, asset.material)
    told = {part for text in texts for part in stems(text.replace("_", " "))}
    return not told.isdisjoint(words)


def is_known(state: SceneState, noun: str) -> bool:
    """Whether a noun names things, rather than a room."""
    words = state.vocabulary
    snake = noun.lower().replace(" ", "_")
    if snake in state.catalogue.room_types and snake not in words.categories:
        return False
    return state.find(noun) is not None or bool(words.nouns(noun))


def known_noun(state: SceneState, words: list[str]) -> tuple[list[str], str]:
    """Return the words that are left over before a noun, and the noun by a name that the catalogue knows.

    Notes
    -----
    The longest ending of the words that names something; what comes before it (wooden, tasty, kitchen) only tells
    more about it. Words that name nothing are looked up by likeness, for spelling.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when no ending names anything.
    """
    if words[-1] in _OPENING and _opens(state, " ".join(words[:-1])):
        words = words[:-1]
    if "of" in words[1:-1]:
        at = words.index("of", 1)
        head, tail = words[:at], [w for w in words[at + 1 :] if w not in _EVERY]
        for order in ([*tail, *head], tail, head):
            if is_known(state, " ".join(order)):
                return [], " ".join(order)
    for start in range(len(words)):
        noun = " ".join(words[start:])
        bound = set(words[:start]) & _BOUND or start > MOST_BEFORE
        named = not set(words[:start]) & (_BOUND - _OF_ROOMS)
        if bound and not (named and find_rooms(state, " ".join(words[:start]))):
            break
        if is_known(state, noun):
            return words[:start], noun
    alike = _alike(state, words)
    if alike:
        return [], alike
    if 1 < len(words) <= MOST_BEFORE + 1 and not set(words) & _BOUND:
        alike = _alike(state, words[-1:])
        if alike:
            return words[:-1], alike
    raise unknown(" ".join(words))


def _opens(state: SceneState, noun: str) -> bool:
    """Whether a noun names things that can be open."""
    kinds = state.vocabulary.exact(stems(noun))
    return any(state.catalogue.by_category(kind)[0].openable for kind in kinds)


def _alike(state: SceneState, words: list[str]) -> str:
    """Return the name of the category that search finds for words, when each of them is like a word of it."""
    hits = search_assets(state.catalogue, " ".join(words), 1)
    if not hits:
        return ""
    asset = hits[0].asset
    wanted = stems(" ".join(words))
    names = [stems(text) for text in (asset.name, asset.category.replace("_", " "), *asset.synonyms)]
    close = any(wanted and name and _like(wanted[-1], name[-1]) and all(_in(w, name) for w in wanted) for name in names)
    return asset.category.replace("_", " ") if close else ""


def _in(word: str, name: tuple[str, ...]) -> bool:
    return any(_like(word, part) for part in name)


def _like(one: str, other: str) -> bool:
    return SequenceMatcher(None, one, other).ratio() >= LIKE


def read_thing(state: SceneState, text: str) -> ThingWords:
    """Read a noun with number, colour and coldness.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown noun, ``INFEASIBLE`` for more copies than allowed.
    """
    bare = text.strip(" ,.;!?\"'")
    if "/" in bare:
        name = bare.split()[-1]
        return ThingWords(Thing(_object_id(state, name[0].upper() + name[1:]), 0))
    words = re.findall(r"[a-z0-9_'\-]+", bare.lower())
    exact = bool({"exactly", "only", "just", "precisely"} & set(words))
    more = bool({"more", "another", "additional", "extra", "further"} & set(words))
    count, colour, cold, every = 0, "", False, False
    kept: list[str] = []
    for place, word in enumerate(words):
        if not kept and (word in NUMBERS or word.isdecimal()):
            number = int(word[:9]) if word.isdecimal() else NUMBERS[word]
            count = number if number < 100 or not count else count * number
        elif word in _COLD:
            cold = True
        elif word in COLOUR_WORDS and (place < len(words) - 1 or kept):
            colour = COLOUR_WORDS[word]
        elif word in _EVERY and not kept:
            every = every or word not in ("the", "any")
        elif word == "each":
            continue
        elif word not in _IDLE or (word == "of" and kept):
            kept.append(word)
    if count > MOST_THINGS:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"the instruction asks for {count} of one thing; at most {MOST_THINGS} can be provided",
        )
    while kept and kept[-1] == "of":
        kept.pop()
    if not kept or (len(kept) == 1 and (stems(kept[0]) or ("",))[0] in _ANYTHING):
        return ThingWords(Thing("", count, colour, cold, every))
    if len(kept) == 1 and kept[0] in COLOUR_WORDS and not is_known(state, kept[0]):
        return ThingWords(Thing("", count, COLOUR_WORDS[kept[0]], cold, every))
    before, noun = known_noun(state, kept)
    plural = _is_plural(kept[-1])
    thing = Thing(noun, count, colour, cold, every or plural)
    return ThingWords(thing, " ".join(before), exact, more, "atmost" in words)


def _is_plural(word: str) -> bool:
    single = stems(word)
    return bool(single) and single[0] != word and word not in ("scissors", "glasses", "headphones")


def _object_id(state: SceneState, name: str) -> str:
    """Return an id that is or may have been an object's."""
    for floor in state.floors:
        scene = state.scenes[floor]
        fixed = [wall.id for wall in scene.walls] + [door.id for door in scene.doors]
        fixed += [window.id for window in scene.windows] + [room.id for room in scene.rooms]
        for part in (*fixed, *(core.id for core in scene.cores)):
            if part == name:
                raise MansionError(
                    ErrorCode.INFEASIBLE, f"{name} is part of the building itself; the editor changes objects alone"
                )
    if state.room(name.rsplit("/", 1)[0]) is None:
        raise unknown(name)
    return name
