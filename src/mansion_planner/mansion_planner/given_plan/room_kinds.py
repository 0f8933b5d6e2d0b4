"""The room type that a name on a plan means, in English or five other languages; and whether it is a stair or lift."""

import re
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from mansion_knowledge import KnowledgeBase, RoomType
from mansion_language import tokenize
from mansion_planner.brief.lexicon import lexicon_of
from mansion_planner.brief.similarity import room_of_building, similar_room_type

__all__ = ["RoomKind", "core_kind", "in_english", "room_kind", "slug"]

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


_WORDS: Final[Mapping[str, str]] = MappingProxyType(
    {
        word: english
        for english, words in {
            "bathroom": "bad badezimmer duschbad salle_de_bain salle_de_bains salle_d_eau bano bagno badkamer",
            "toilet": "toilettes gabinetto",
            "kitchen": "kuche kueche wohnkuche wohnkueche cocina cucina keuken",
            "living room": "wohnen wohnzimmer wohnraum stube sejour sala sala_de_estar soggiorno woonkamer",
            "dining room": "essen esszimmer essplatz salle_a_manger comedor sala_da_pranzo eetkamer",
            "bedroom": "schlafen schlafzimmer schlafraum elternschlafzimmer gaestezimmer chambre dormitorio "
            "camera camera_da_letto slaapkamer",
            "children's room": "kind kinderzimmer chambre_d_enfant",
            "home office": "arbeiten arbeitszimmer",
            "office": "buro buero bureau oficina ufficio kantoor",
            "hallway": "flur diele korridor gang couloir degagement pasillo corridoio overloop",
            "entrance hall": "eingang windfang vorraum entree recibidor ingresso hal",
            "storage": "abstellraum abstellkammer keller kellerraum debarras rangement trastero ripostiglio berging",
            "utility room": "hauswirtschaftsraum hwr buanderie lavadero lavanderia bijkeuken",
            "technical room": "technik technikraum heizung heizraum hausanschlussraum local_technique",
            "pantry": "speisekammer vorrat cellier dispensa",
            "dressing room": "ankleide ankleidezimmer",
            "meeting room": "besprechung besprechungsraum salle_de_reunion sala_riunioni vergaderruimte",
            "terrace": "terrasse terraza terrazza terras",
            "stairs": "treppe treppenhaus treppenraum escalier escalera escaleras scala trappenhuis",
            "elevator": "aufzug fahrstuhl ascenseur ascensor ascensore",
        }.items()
        for word in words.split()
    }
)
"""English by word, without accents, lower case, with underscores."""


def in_english(name: str) -> str:
    """Return the English of the words that a room's name begins with, else of those that it ends with; else empty.

    Examples
    --------
    >>> in_english("schlafzimmer_2"), in_english("salle_de_bain"), in_english("1_og_flur"), in_english("kitchen")
    ('bedroom', 'bathroom', 'hallway', '')
    """
    parts = re.sub(r"^(\d+_)+|(_\d+)+$", "", name).split("_")
    beginnings = (parts[:length] for length in range(len(parts), 0, -1))
    endings = (parts[start:] for start in range(1, len(parts)))
    found = (_WORDS.get("_".join(words), "") for words in (*beginnings, *endings))
    return next(filter(None, found), "")
