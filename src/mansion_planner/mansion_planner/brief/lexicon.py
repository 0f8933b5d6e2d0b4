"""The phrases that a brief may use for rooms, buildings and styles, and the search for them in its tokens."""

from dataclasses import dataclass
from functools import cache

from mansion_knowledge import KnowledgeBase
from mansion_language import Token, singular

__all__ = ["Lexicon", "Mention", "lexicon_of"]


@dataclass(frozen=True)
class Mention:
    """A phrase of the lexicon found in the brief: tokens `first` to `last` (exclusive), and what it may mean."""

    first: int
    last: int
    room: str = ""
    building: str = ""
    style: str = ""
    plural: bool = False


@dataclass(frozen=True)
class _Meaning:
    room: str = ""
    building: str = ""
    style: str = ""


@dataclass(frozen=True)
class Lexicon:
    """Phrases by their tokens.

    Attributes
    ----------
    phrases : dict of tuple of str to meaning
    longest : int
        Tokens of the longest phrase.
    words : frozenset of str
        Every word of a phrase, for the correction of misspellings.
    heads : frozenset of str
        The last words of the names of rooms and buildings.
    building_heads : frozenset of str
        The last words of the names of buildings that are those of no room.
    """

    phrases: dict[tuple[str, ...], _Meaning]
    longest: int
    words: frozenset[str]
    heads: frozenset[str]
    building_heads: frozenset[str]

    def find(self, tokens: list[Token]) -> list[Mention]:
        """Return the longest phrases from left to right, without overlap."""
        mentions: list[Mention] = []
        index = 0
        texts = [token.text if token.kind != "mark" else "\0" for token in tokens]
        while index < len(tokens):
            for size in range(min(self.longest, len(tokens) - index), 0, -1):
                meaning = self.phrases.get(tuple(texts[index : index + size]))
                if meaning is not None:
                    last = index + size
                    mentions.append(
                        Mention(
                            index, last, meaning.room, meaning.building, meaning.style,
                            tokens[last - 1].plural,
                        )
                    )  # fmt: skip
                    index = last
                    break
            else:
                index += 1
        return mentions


_CACHE: dict[int, tuple[KnowledgeBase, Lexicon]] = {}


def lexicon_of(knowledge: KnowledgeBase) -> Lexicon:
    """Return the lexicon of a knowledge base, made once for each."""
    held = _CACHE.get(id(knowledge))
    if held is None or held[0] is not knowledge:
        held = (knowledge, _make(knowledge))
        _CACHE[id(knowledge)] = held
    return held[1]


@cache
def _key(phrase: str) -> tuple[str, ...]:
    words = phrase.replace("_", " ").replace("-", " ").split()
    return tuple(word if word == "people" else singular(singular(word)) for word in words)


def _make(knowledge: KnowledgeBase) -> Lexicon:
    phrases: dict[tuple[str, ...], dict[str, str]] = {}

    def add(kind: str, name: str, names: tuple[str, ...]) -> None:
        for phrase in names:
            phrases.setdefault(_key(phrase), {}).setdefault(kind, name)

    for room in knowledge.rooms.values():
        add("room", room.name, (room.name,))
    for room in knowledge.rooms.values():
        add("room", room.name, room.synonyms)
    for building in knowledge.buildings.values():
        add("building", building.name, building.synonyms)
    for style in knowledge.styles.values():
        add("style", style.name, style.synonyms)
    table = {key: _Meaning(**meaning) for key, meaning in phrases.items()}
    rooms = {key[-1] for key, meaning in table.items() if meaning.room}
    return Lexicon(
        phrases=table,
        longest=max(len(key) for key in table),
        words=frozenset(word for key in table for word in key),
        heads=frozenset(key[-1] for key, meaning in table.items() if meaning.room or meaning.building),
        building_heads=frozenset(key[-1] for key, meaning in table.items() if meaning.building) - rooms,
    )
