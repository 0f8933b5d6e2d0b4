"""Find the known room type that a room of an unknown name is most like."""

import difflib
from functools import cache

from mansion_knowledge import KnowledgeBase
from mansion_language import singular
from mansion_planner.brief.lexicon import lexicon_of

__all__ = ["AS_ROOM", "HEAD_TYPES", "elliptic_room_type", "room_of_building", "similar_room_type", "told_room_type"]

AS_ROOM = {
    "office": "private_office", "flat": "apartment", "apartment_building": "apartment",
    "studio_flat": "studio_apartment", "hotel": "hotel_room", "supermarket": "sales_area",
    "factory": "production_hall", "bank": "bank_hall", "clinic": "consultation_room",
    "museum": "gallery", "cinema": "cinema_hall", "theater": "auditorium", "nightclub": "bar",
    "casino": "casino_floor", "kindergarten": "kindergarten_classroom", "sports_center": "sports_hall",
    "church": "prayer_hall", "mosque": "prayer_hall", "coworking": "coworking_area",
    "conference_center": "conference_hall", "swimming_center": "indoor_pool",
    "data_center": "server_room", "dental_clinic": "dental_room", "student_dormitory": "dorm_room",
    "school": "classroom", "post_office": "service_counter", "shopping_mall": "shop",
    "parking_garage": "parking", "hostel": "hostel_dorm", "library_building": "library",
    "police_station": "security_room", "penthouse": "apartment", "townhouse": "apartment",
    "community_center": "assembly_hall", "spa_building": "spa", "farm_building": "stable",
    "university": "lecture_hall", "hospital": "treatment_room", "town_hall": "service_counter",
    "courthouse": "courtroom", "fire_station": "apparatus_bay", "car_dealership": "car_showroom",
    "train_station": "waiting_hall", "airport_terminal": "departure_lounge",
    "veterinary_clinic": "consultation_room", "rehabilitation_center": "physiotherapy_room",
    "nursing_home": "resident_room", "entertainment_center": "arcade", "media_house": "newsroom",
    "music_school": "music_room", "art_gallery": "gallery", "call_center": "open_office",
    "observatory": "observatory_dome", "hair_salon": "salon_floor", "house": "apartment",
    "villa": "apartment", "bungalow": "apartment",
}  # fmt: skip
"""The room type that a building type stands for when it is a part of another building."""


HEAD_TYPES = {
    "room": "study_room", "hall": "assembly_hall", "lab": "laboratory", "studio": "art_room",
    "area": "lounge", "space": "lounge", "zone": "lounge", "corner": "lounge", "suite": "private_office",
    "workshop": "workshop", "center": "common_room", "centre": "common_room", "shop": "shop",
    "store": "shop", "lounge": "lounge", "chamber": "meeting_room", "parlor": "lounge", "den": "lounge",
    "parlour": "lounge", "closet": "storage", "ward": "hospital_ward", "bay": "storage",
    "office": "private_office", "department": "open_office", "gallery": "gallery", "bar": "bar",
    "theater": "cinema_hall", "court": "sports_hall", "kitchen": "kitchen", "section": "lounge",
    "booth": "phone_booth", "cabin": "bedroom", "cell": "holding_cell", "rental": "shop",
    "mess": "cafeteria", "galley": "kitchen",
    "salon": "lounge", "loft": "attic", "storeroom": "storage", "dock": "loading_dock",
    "kiosk": "shop", "station": "nurse_station",
    "checkpoint": "security_check", "surgery": "treatment_room", "theatre": "auditorium",
    "library": "library", "chapel": "prayer_hall",
    "garage": "garage", "bathroom": "bathroom", "bedroom": "bedroom", "archive": "archive", "cafe": "cafe",
    "gym": "gym", "school": "classroom", "wash": "laundry_room", "helpdesk": "open_office",
    "cellar": "storage", "depot": "storage", "post": "security_room",
    "atelier": "art_room", "reserve": "storage", "arena": "sports_hall", "wing": "common_room",
    "vault": "vault", "nook": "lounge", "garden": "greenhouse", "pool": "indoor_pool", "deposit": "storage",
}  # fmt: skip


def room_of_building(building: str, knowledge: KnowledgeBase) -> str:
    """Return the room type that a building type stands for within another building; empty for none."""
    record = knowledge.buildings.get(building)
    return AS_ROOM.get(building) or (AS_ROOM.get(record.like, "") if record is not None else "")


_NOT_ELLIPTIC = frozenset({"practice", "delivery", "dispatch", "server"})
"""Words that mean another place alone than before "room": a doctor's practice, deliveries, a servery."""


def elliptic_room_type(words: tuple[str, ...], knowledge: KnowledgeBase) -> str:
    """Return the room type that a list means by words without a head: "waiting" is a waiting room; empty for none.

    Examples
    --------
    >>> from mansion_knowledge import default_knowledge
    >>> elliptic_room_type(("waiting",), default_knowledge()), elliptic_room_type(("wood",), default_knowledge())
    ('waiting_room', '')
    """
    if not _NOT_ELLIPTIC.isdisjoint(words):
        return ""
    phrases = lexicon_of(knowledge).phrases
    found = next((held for head in ("room", "area") if (held := phrases.get((*words, head)))), None)
    return found.room if found is not None else ""


_GENERAL_HEADS = frozenset(
    """
    room hall area space zone corner section station booth bay point suite house department unit cell chamber studio
    center centre nook spot wing loft cellar cage deck shed village pit stand cabin salon
    """.split()
)
"""Nouns that say of a room only that it is one; words before them tell what it is for."""


def told_room_type(name: str, knowledge: KnowledgeBase) -> str:
    """Return the room type that the words before a general noun tell; empty where none does.

    Examples
    --------
    >>> from mansion_knowledge import default_knowledge
    >>> told_room_type("free_weights_corner", default_knowledge()), told_room_type("weights_shop", default_knowledge())
    ('gym', '')
    """
    *before, head = name.split("_")
    if singular(head) not in _GENERAL_HEADS:
        return ""
    told = (knowledge.telling.get(word) or knowledge.telling.get(singular(word)) for word in reversed(before))
    kind = next((kind for kind in told if kind), "")
    if singular(head) == "hall" and kind and knowledge.room(kind).usual < _LEAST_HALL:
        return "warehouse" if knowledge.room(kind).zone == "service" else ""
    return kind


_LEAST_HALL = 13.0
"""Square metres that a kind of room usually has so that one of them can be a hall; halls for boats are warehouses."""


def similar_room_type(name: str, knowledge: KnowledgeBase) -> str:
    """Return the room type that a room of unknown `name` is planned and furnished as.

    By the nearest spelling among names and synonyms, else by what its words tell, else by the last of them.

    Examples
    --------
    >>> from mansion_knowledge import default_knowledge
    >>> similar_room_type("pottery_workshop", default_knowledge())
    'workshop'
    """
    if name in knowledge.rooms:
        return name
    names = _names(tuple((room.name, room.synonyms) for room in knowledge.rooms.values()))
    close = difflib.get_close_matches(name.replace("_", " "), list(names), n=1, cutoff=0.92)
    if close:
        return names[close[0]]
    return told_room_type(name, knowledge) or HEAD_TYPES.get(name.rsplit("_", 1)[-1], "study_room")


@cache
def _names(rooms: tuple[tuple[str, tuple[str, ...]], ...]) -> dict[str, str]:
    names: dict[str, str] = {}
    for name, synonyms in rooms:
        for phrase in (name.replace("_", " "), *synonyms):
            names.setdefault(phrase, name)
    return names
