"""Noun phrases: objects with number and colour, their places, and what moves from where to where."""

import re
from collections.abc import Iterator
from dataclasses import KW_ONLY, dataclass, replace
from difflib import SequenceMatcher
from typing import Final

from mansion_assets.catalogue import Asset
from mansion_assets.catalogue.search import search_assets
from mansion_assets.catalogue.vocabulary import stems, vocabulary_of
from mansion_editing.agent.facts import ObjectDescription, Scope
from mansion_editing.agent.sentence_patterns import EXAMPLES, MOVED, STATES
from mansion_editing.state import SceneState
from mansion_editing.tools.perception import find_floor, find_rooms
from mansion_language.colours import COLOUR_WORDS
from mansion_language.numbers import CARDINALS, SOFT_NUMBERS
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = [
    "MOST_COPIES",
    "NUMBERS",
    "NounPhrase",
    "QuantifiedNoun",
    "is_known",
    "has_state",
    "known_noun",
    "typical_asset",
    "read_move",
    "read_noun_phrase",
    "read_place",
    "read_noun",
    "rooms_named",
    "unknown_words",
    "unknown_adjectives",
]

MOST_COPIES: Final = 20
"""Greatest number of one object that an instruction may ask for."""

NUMBERS: Final = {
    **{word: number for word, number in CARDINALS.items() if number <= MOST_COPIES and word not in SOFT_NUMBERS},
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

MOST_MODIFIERS: Final = 2
LEAST_SIMILARITY: Final = 0.8
_OPENING: Final = frozenset(["door", "doors", "lid"])
"""Parts that open: the microwave door means the microwave."""

_ANYTHING: Final = frozenset([
    "thing", "object", "stuff", "item", "content", "everything", "anything",
])  # fmt: skip


@dataclass(frozen=True)
class QuantifiedNoun:
    """A noun with its quantifier.

    Attributes
    ----------
    before : str
        Modifiers before the noun that do not belong to its name, perhaps the name of a room.
    exact, more, most : bool
        Exactly the number; the number besides those that are there; at most the number.
    """

    object: ObjectDescription
    before: str = ""
    _: KW_ONLY
    exact: bool = False
    more: bool = False
    most: bool = False


def unknown_words(what: str) -> MansionError:
    """Return the error for words that name no room and no object."""
    return MansionError(
        ErrorCode.NOT_FOUND,
        f"not understood: {what[:80]!r} names neither a room of this building nor an object of the catalogue; "
        f"{EXAMPLES}",
        details={"words": what[:200]},
    )


def unknown_adjectives(state: SceneState, words: str, noun: str) -> MansionError | None:
    """Return the error for adjectives that do not describe a noun; None where they describe all its assets.

    Parameters
    ----------
    words : str
        What stands before the noun and names no room (``slightly dented``).
    """
    categories = vocabulary_of(state.catalogue).nouns(noun)
    assets = [asset for name in categories for asset in state.catalogue.by_category(name)]
    for word in words.split():
        own = [word, word.removesuffix("en"), *stems(word)]
        if not assets or any(not _described(asset, own) for asset in assets):
            name = re.sub(r"^(?:the|an?) ", "", noun)[:60]
            return MansionError(
                ErrorCode.NOT_FOUND,
                f"not understood: {words[:60]!r}: no {name} of the catalogue is described so; name the {name} "
                f"alone, or with a colour; {EXAMPLES}",
                details={"words": words[:200]},
            )
    return None


def _described(asset: Asset, words: list[str]) -> bool:
    """Whether an asset's names, tags or materials have one of some words."""
    texts = (asset.name, asset.category, *asset.synonyms, *asset.tags, asset.material)
    told = {part for text in texts for part in stems(text.replace("_", " "))}
    return not told.isdisjoint(words)


def is_known(state: SceneState, noun: str) -> bool:
    """Whether a noun names objects rather than a room."""
    words = vocabulary_of(state.catalogue)
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
        bound = set(words[:start]) & _BOUND or start > MOST_MODIFIERS
        named = not set(words[:start]) & (_BOUND - _OF_ROOMS)
        if bound and not (named and find_rooms(state, " ".join(words[:start]))):
            break
        if is_known(state, noun):
            return words[:start], noun
    alike = _misspelt(state, words)
    if alike:
        return [], alike
    if 1 < len(words) <= MOST_MODIFIERS + 1 and not set(words) & _BOUND:
        alike = _misspelt(state, words[-1:])
        if alike:
            return words[:-1], alike
    raise unknown_words(" ".join(words))


def _opens(state: SceneState, noun: str) -> bool:
    """Whether a noun names objects that can be open."""
    kinds = vocabulary_of(state.catalogue).exact(stems(noun))
    return any(state.catalogue.by_category(kind)[0].openable for kind in kinds)


def _misspelt(state: SceneState, words: list[str]) -> str:
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
    return SequenceMatcher(None, one, other).ratio() >= LEAST_SIMILARITY


def read_noun(state: SceneState, text: str) -> QuantifiedNoun:
    """Read a noun with number, colour and coldness.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown noun, ``INFEASIBLE`` for more copies than allowed.
    """
    bare = text.strip(" ,.;!?\"'")
    if "/" in bare:
        name = bare.split()[-1]
        return QuantifiedNoun(ObjectDescription(_object_id(state, name[0].upper() + name[1:]), 0))
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
    if count > MOST_COPIES:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"the instruction asks for {count} of one thing; at most {MOST_COPIES} can be provided",
        )
    while kept and kept[-1] == "of":
        kept.pop()
    if not kept or (len(kept) == 1 and (stems(kept[0]) or ("",))[0] in _ANYTHING):
        return QuantifiedNoun(ObjectDescription("", count, colour, cold=cold, every=every))
    if len(kept) == 1 and kept[0] in COLOUR_WORDS and not is_known(state, kept[0]):
        return QuantifiedNoun(ObjectDescription("", count, COLOUR_WORDS[kept[0]], cold=cold, every=every))
    before, noun = known_noun(state, kept)
    plural = _is_plural(kept[-1])
    thing = ObjectDescription(noun, count, colour, cold=cold, every=every or plural)
    return QuantifiedNoun(thing, " ".join(before), exact=exact, more=more, most="atmost" in words)


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
                    ErrorCode.INFEASIBLE, f"{name} is part of the building; the editor changes only objects"
                )
    if state.room(name.rsplit("/", 1)[0]) is None:
        raise unknown_words(name)
    return name


_PREPOSITIONS: Final = (
    r"\b(next to|inside of|inside|into|in|within|onto|on|under|underneath|below|at|by|off|"
    r"out of|from|to|for)\b"
)
_ID: Final = re.compile(r"\b[fF]-?\d+/[A-Za-z0-9_./-]+")
_EACH: Final = re.compile(
    r"^(?:the )?(?:each|every|both|all|either)(?: (?:single|one))?(?: of)?(?: the)?(?: (?:two|three|four|five|"
    r"six|\d+))?\b",
    re.IGNORECASE,
)
_EACH_FLOOR: Final = re.compile(
    r"\b(?:on |of |in )?(?:each|every|both|all)(?: of)?(?: the)?(?: \w+)? (?:floors?|storeys?|stories|levels?)\b",
    re.IGNORECASE,
)
_PRONOUNS: Final = frozenset(["it", "them", "there", "this", "that", "these", "those", "here"])
_PARTS: Final = frozenset(["floor", "ground", "building", "door", "top", "surface", "table top", "area", "place"])


@dataclass(frozen=True)
class NounPhrase:
    """An object and its place.

    Attributes
    ----------
    placed : bool
        The words name a place.
    each : {"", "receptacle", "room", "floor"}
        Part of the place that is quantified distributively (on each desk, in every office).
    anaphoric : bool
        The place refers to one mentioned before (on it, there).
    exact, more, most
        See `QuantifiedNoun`.
    """

    object: ObjectDescription
    where: Scope
    _: KW_ONLY
    placed: bool
    each: str = ""
    anaphoric: bool = False
    exact: bool = False
    more: bool = False
    most: bool = False


def read_place(state: SceneState, text: str) -> NounPhrase:
    """Read ``on the desk in the meeting room on the third floor``.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for words that name nothing.
    """
    return read_noun_phrase(state, f"things {text}")


def read_noun_phrase(state: SceneState, text: str) -> NounPhrase:
    """Read ``two red mugs on the desk in the meeting room on the third floor``.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for words that name nothing, ``INFEASIBLE`` for too many copies.
    """
    each = "floor" if _EACH_FLOOR.search(text) else ""
    text = " ".join(_EACH_FLOOR.sub(" ", text).split())
    floor, rest = find_floor(state, text)
    rest = re.sub(r"^((?:(?:things|on|in|at|the)\s+)*)'s ", r"\1", rest)
    pieces = re.split(_PREPOSITIONS, rest, flags=re.IGNORECASE)
    said = read_noun(state, re.sub(r" 's\b", "", pieces[0]))
    reader = _PlaceReader(state, floor, text)
    for preposition, words in zip(pieces[1::2], pieces[2::2], strict=False):
        if words.strip(" ,.").lower() in COLOUR_WORDS:
            colour = COLOUR_WORDS[words.strip(" ,.").lower()]
            said = replace(said, object=replace(said.object, colour=colour))
            continue
        reader.take(preposition.lower(), words)
    return reader.phrase(said, each)


class _PlaceReader:
    """Takes a place's parts one after the other: receptacle, neighbour, room."""

    def __init__(self, state: SceneState, floor: int | None, text: str) -> None:
        self.state, self.floor = state, floor
        self.ids = {match.group().lower(): match.group() for match in _ID.finditer(text)}
        self.relation, self.receptacle, self.colour, self.near = "room", "", "", ""
        self.base = ""
        self.rooms: tuple[str, ...] | None = None
        self.each = ""
        self.anaphoric = False

    def take(self, preposition: str, words: str) -> None:
        """Take ``in the meeting room`` or ``on the desk``."""
        quantified = _EACH.match(words.strip())
        name = _bare(_EACH.sub("", words.strip()) if quantified else words)
        if not name:
            self.anaphoric = self.anaphoric or bool(quantified)
            return
        if name.lower() in _PRONOUNS:
            self.anaphoric = True
            self.relation = "in" if preposition.startswith(("in", "with")) else "on"
            return
        name = self._owner(name)
        if name.lower() in _PARTS:
            return
        each = bool(quantified)
        found = None if self.rooms is not None else rooms_named(self.state, name, self.floor, every=each)
        if found and preposition not in ("next to", "under", "underneath", "below", "by"):
            self.rooms = found
            self.each = "room" if quantified else self.each
            return
        exact = vocabulary_of(self.state.catalogue).exact(stems(name))
        if self.rooms is not None and not exact and find_rooms(self.state, name, self.floor):
            raise unknown_words(name)
        if preposition in ("next to", "under", "underneath", "below", "by"):
            self.near = self._thing(name)[1]
        elif not self.receptacle:
            self.colour, self.receptacle = self._thing(name)
            inward = preposition in ("in", "inside", "into", "within", "inside of", "out of")
            self.relation = "in" if inward else "on"
            self.each = "receptacle" if quantified else self.each
        elif not self.base:
            self.base = self._thing(name)[1]
        else:
            raise unknown_words(name)

    def _owner(self, name: str) -> str:
        """Split ``table of the break room`` and ``break room 's table`` where one part is a room."""
        head, mark, tail = name.partition(" of ")
        if not mark:
            tail, mark, head = name.partition(" 's ")
        if not mark:
            return name
        rooms = rooms_named(self.state, _bare(tail), self.floor)
        if rooms and self.rooms is None:
            self.rooms = rooms
            return _bare(head)
        return _bare(tail) if _bare(head).lower() in _PARTS else name.replace(" 's ", " ")

    def _thing(self, name: str) -> tuple[str, str]:
        """Return the colour and the noun of a receptacle; a room's name before it narrows the place."""
        whole = self.ids.get(name.lower(), name)
        upper = whole[0].upper() + whole[1:]
        if self.state.find(upper) is not None:
            return "", upper
        if "/" in whole or re.search(r"_\d+$", whole):
            return "", whole
        words = re.findall(r"[a-z0-9'\-]+", name.lower())
        colour = next((COLOUR_WORDS[w] for w in words[:-1] if w in COLOUR_WORDS), "")
        plain = [w for w in words if w not in COLOUR_WORDS or w == words[-1]]
        if not plain:
            raise unknown_words(name)
        before, noun = known_noun(self.state, plain)
        self._narrow(" ".join(before), noun)
        return colour, noun

    def _narrow(self, words: str, noun: str) -> None:
        """Take the modifiers of a noun: the name of a room, or adjectives that describe all such objects."""
        if not words:
            return
        found = rooms_named(self.state, words, self.floor)
        if found and self.rooms is None:
            self.rooms = found
        fault = None if found else unknown_adjectives(self.state, words, noun)
        if fault is not None:
            raise fault

    def phrase(self, said: QuantifiedNoun, each: str) -> NounPhrase:
        """Return the object at the place that was read."""
        self._narrow(said.before, said.object.noun)
        relation = self.relation if self.receptacle or self.anaphoric else "room"
        where = Scope(
            relation,  # type: ignore[arg-type]
            self.receptacle,
            self.rooms or (),
            self.floor,
            self.colour,
            self.near,
            self.base,
        )
        placed = bool(where.receptacle or where.rooms or where.near or self.floor is not None)
        return NounPhrase(
            said.object,
            where,
            placed=placed or self.anaphoric or bool(each),
            each=each or self.each,
            anaphoric=self.anaphoric,
            exact=said.exact,
            more=said.more,
            most=said.most,
        )


def _bare(words: str) -> str:
    """Drop articles and punctuation around a noun."""
    out = re.sub(
        r"^[\s,]*(?:(?:the|a|an|any|all|every|each|one|its|my|our|your|their|of|same)\s+)*",
        "",
        words.strip(),
        flags=re.I,
    )
    return out.strip(" ,.;!?\"'")


def rooms_named(state: SceneState, name: str, floor: int | None, *, every: bool = False) -> tuple[str, ...] | None:
    """Return the rooms that a name means, None for none; an object of that name has precedence over part of a room's.

    Parameters
    ----------
    every : bool
        All rooms of the kind, not only those that the name fits best.
    """
    if not name:
        return None
    whole = state.room(name[0].upper() + name[1:])
    if whole is not None:
        return (whole[1].id,)
    found = [room.id for _, room in find_rooms(state, name, floor, every=every)]
    if not found:
        return None
    exact = any(
        name.replace(" ", "_").lower() in (room.room_type, room.id.split("/", 1)[-1])
        for number in state.floors
        for room in state.scenes[number].rooms
        if room.id in found
    )
    if not exact and not re.search(r"room|office|\d$", name.lower()) and is_known(state, name):
        return None
    return tuple(found)


def _move_splits(text: str) -> Iterator[re.Match[str]]:
    """Yield divisions of words into an object, its source and its target, the plain ones first."""
    plain = re.match(MOVED[0], text, re.IGNORECASE)
    if plain:
        yield plain
    for joint in re.finditer(r" (?:on|in|inside) ", text, re.IGNORECASE):
        head, tail = text[: joint.start()], text[joint.start() :]
        if re.search(r" from .+", head, re.IGNORECASE):
            match = re.match(MOVED[1], f"{head} =>{tail}", re.IGNORECASE)
            if match:
                yield match


def read_move(state: SceneState, text: str) -> tuple[NounPhrase, NounPhrase] | None:
    """Return what moves from where, and where to; the first division of the words that can be read, None without any.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when a division names something unknown and no other can be read.
    """
    fault: MansionError | None = None
    for match in _move_splits(text):
        source = f" on {match['source']}" if match["source"] else ""
        inward = match["to"].lower() in ("into", "in", "inside")
        try:
            what = read_noun_phrase(state, match["what"] + source)
            goal = read_place(state, f"{'in' if inward else 'on'} {match['target']}")
        except MansionError as error:
            fault = fault or error
            continue
        if goal.where.receptacle or goal.where.rooms or goal.anaphoric:
            return what, goal
    if fault is not None:
        raise fault
    return None


def typical_asset(state: SceneState, noun: str) -> Asset | None:
    """Return the first asset of the first category that a noun names, None where it names nothing."""
    categories = vocabulary_of(state.catalogue).nouns(noun)
    return state.catalogue.by_category(categories[0])[0] if categories else None


def has_state(state: SceneState, noun: str, word: str) -> bool:
    """Whether objects of a noun can be open, or on."""
    asset = typical_asset(state, noun)
    return asset is not None and (asset.openable if STATES[word][0] == "open" else asset.toggleable)
