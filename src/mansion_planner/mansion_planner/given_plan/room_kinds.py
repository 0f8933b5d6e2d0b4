"""The room type that the name of a room on a plan means, and whether it is a stair or a lift."""

import re
import unicodedata
from dataclasses import dataclass

from mansion_knowledge import KnowledgeBase, RoomType
from mansion_language import tokenize
from mansion_planner.brief.lexicon import lexicon_of
from mansion_planner.brief.similarity import room_of_building, similar_room_type
from mansion_planner.given_plan.other_languages import in_english

__all__ = ["RoomKind", "core_kind", "room_kind", "slug"]

_SHAFT = "void"
"""What rooms that are cores are furnished like."""


@dataclass(frozen=True)
class RoomKind:
    """The type of a room; `known` is false where it is only the nearest to the words of the plan."""

    type: RoomType
    known: bool = True


def slug(name: str) -> str:
    """Return a name as an identifier.

    Examples
    --------
    >>> slug("Küche / Essen 2")
    'kuche_essen_2'
    """
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode().replace("'", "")
    return re.sub(r"[^a-z0-9]+", "_", plain.lower()).strip("_")[:60]


def core_kind(name: str, kind: str, knowledge: KnowledgeBase) -> str:
    """Return ``stair`` or ``elevator`` for a room that is one, else an empty string.

    Examples
    --------
    >>> from mansion_knowledge import default_knowledge
    >>> [core_kind(name, "", default_knowledge()) for name in ("Stairs 2", "Lift", "Lift lobby")]
    ['stair', 'elevator', '']
    """
    key = re.sub(r"(_\d+)+$", "", slug(kind or name))
    key = key if key in knowledge.words or key in knowledge.rooms else slug(in_english(key)) or key
    word = knowledge.words.get(key)
    if key in knowledge.rooms or word is None or word.like != _SHAFT:
        return ""
    parts = key.split("_")
    if any(part.startswith("stair") for part in parts):
        return "stair"
    return "elevator" if {"elevator", "lift"} & set(parts) else ""


def room_kind(name: str, kind: str, knowledge: KnowledgeBase) -> RoomKind:
    """Return the room type that the words of a plan mean.

    The stated kind goes before the name, and English before other languages. A phrase that the knowledge base has
    counts wherever it stands, best at the end ("master bedroom", "kitchen, open"); otherwise the nearest type is taken.

    Parameters
    ----------
    name, kind : str
        What the room is called, and what the plan says it is, if it does.

    Examples
    --------
    >>> from mansion_knowledge import default_knowledge
    >>> base = default_knowledge()
    >>> room_kind("Anna's bedroom", "", base).type.name, room_kind("Zorbium", "", base).known
    ('bedroom', False)
    """
    for words in (kind, name):
        if found := _known(words, knowledge):
            return RoomKind(knowledge.room(found))
    for words in (kind, name):
        if (english := in_english(slug(words))) and (found := _known(english, knowledge)):
            return RoomKind(knowledge.room(found))
    words = slug(kind or name)
    near = similar_room_type(re.sub(r"(_\d+)+$", "", words), knowledge) if words else "storage"
    return RoomKind(knowledge.room(near), known=False)


def _known(words: str, knowledge: KnowledgeBase) -> str:
    """Return the room type that a phrase in the words names; empty for none."""
    key = slug(words)
    for exact in (key, re.sub(r"(_\d+)+$", "", key)):
        if exact in knowledge.rooms:
            return exact
        entry = knowledge.words.get(exact)
        if entry is not None and entry.like in knowledge.rooms:
            return entry.like
    tokens = [token for token in tokenize(words.lower().replace("_", " ")) if token.kind != "number"]
    mentions = lexicon_of(knowledge).find(tokens)
    rooms = [(mention.last, mention.room) for mention in mentions if mention.room]
    rooms += [
        (mention.last, room)
        for mention in mentions
        if not mention.room and mention.building and (room := room_of_building(mention.building, knowledge))
    ]
    ending = [room for last, room in rooms if last == len(tokens)]
    return (ending or [room for _, room in rooms] or [""])[0]
