"""Find the known room type that a room of an unknown name is most like."""

import difflib
from functools import cache

from mansion_planner.knowledge import KnowledgeBase

__all__ = ["HEAD_TYPES", "similar_room_type"]

HEAD_TYPES = {
    "room": "study_room", "hall": "assembly_hall", "lab": "laboratory", "studio": "art_room",
    "area": "lounge", "space": "lounge", "zone": "lounge", "corner": "lounge", "suite": "private_office",
    "workshop": "workshop", "center": "common_room", "centre": "common_room", "shop": "shop",
    "store": "shop", "lounge": "lounge", "chamber": "meeting_room", "parlor": "lounge", "den": "lounge",
    "parlour": "lounge", "closet": "storage", "ward": "hospital_ward", "bay": "storage",
    "office": "private_office", "department": "open_office", "gallery": "gallery", "bar": "bar",
    "theater": "cinema_hall", "court": "sports_hall", "kitchen": "kitchen", "section": "lounge",
    "cellar": "storage", "vault": "vault", "nook": "lounge", "garden": "greenhouse", "pool": "indoor_pool",
}  # fmt: skip


def similar_room_type(name: str, knowledge: KnowledgeBase) -> str:
    """Return the room type that a room of unknown `name` is planned and furnished as.

    By the nearest spelling among names and synonyms, else by the name's last word.

    Examples
    --------
    >>> from mansion_planner.knowledge import default_knowledge
    >>> similar_room_type("pottery_workshop", default_knowledge())
    'workshop'
    """
    if name in knowledge.rooms:
        return name
    names = _names(tuple((room.name, room.synonyms) for room in knowledge.rooms.values()))
    close = difflib.get_close_matches(name.replace("_", " "), list(names), n=1, cutoff=0.88)
    if close:
        return names[close[0]]
    return HEAD_TYPES.get(name.rsplit("_", 1)[-1], "study_room")


@cache
def _names(rooms: tuple[tuple[str, tuple[str, ...]], ...]) -> dict[str, str]:
    names: dict[str, str] = {}
    for name, synonyms in rooms:
        for phrase in (name.replace("_", " "), *synonyms):
            names.setdefault(phrase, name)
    return names
