"""What the structure has to know of a room type: is it circulation, wet, a store, open to the public, outdoors?

A type belongs to a class when one of its words (``staff_toilet`` has ``staff`` and ``toilet``) is one of the class's.
"""

from functools import cache
from typing import Final

__all__ = ["ROOM_CLASSES", "is_class"]

ROOM_CLASSES: Final[dict[str, frozenset[str]]] = {
    "circulation": frozenset(
        [
            "hall",
            "hallway",
            "corridor",
            "lobby",
            "foyer",
            "landing",
            "circulation",
            "atrium",
            "vestibule",
            "passage",
            "concourse",
            "entrance",
            "entry",
            "entryway",
            "hub",
            "core",
        ]
    ),
    "welcome": frozenset(["lobby", "foyer", "reception", "entrance", "entry", "entryway", "atrium", "vestibule"]),
    "wet": frozenset(["bathroom", "toilet", "toilets", "restroom", "wc", "shower", "lavatory", "washroom", "ensuite"]),
    "store": frozenset(
        [
            "storage",
            "store",
            "storeroom",
            "closet",
            "pantry",
            "archive",
            "janitor",
            "utility",
            "mechanical",
            "electrical",
            "server",
            "shaft",
            "plant",
            "wardrobe",
            "garage",
            "warehouse",
            "stockroom",
            "boiler",
            "cellar",
            "vault",
            "cleaning",
        ]
    ),
    "vehicle": frozenset(
        ["garage", "carport", "car", "parking", "carpark", "ambulance", "apparatus", "vehicle", "dock"]
    ),
    "outdoor": frozenset(["balcony", "terrace", "loggia", "patio", "veranda", "deck"]),
    "office": frozenset(
        [
            "office",
            "meeting",
            "conference",
            "boardroom",
            "workspace",
            "coworking",
            "study",
            "cubicle",
            "interview",
            "huddle",
            "focus",
        ]
    ),
    "assembly": frozenset(
        [
            "cafeteria",
            "canteen",
            "restaurant",
            "auditorium",
            "theater",
            "theatre",
            "cinema",
            "gym",
            "gymnasium",
            "ballroom",
            "lounge",
            "supermarket",
            "shop",
            "shopping",
            "retail",
            "gallery",
            "exhibition",
            "museum",
            "library",
            "food",
            "dining_hall",
            "banquet",
            "event",
            "sports",
            "casino",
            "arcade",
            "market",
            "showroom",
            "sanctuary",
            "nave",
            "chapel",
        ]
    ),
    "teaching": frozenset(["classroom", "lecture", "seminar", "laboratory", "lab", "workshop", "kindergarten"]),
    "clinical": frozenset(
        [
            "consultation",
            "patient",
            "ward",
            "surgery",
            "operating",
            "examination",
            "exam",
            "icu",
            "emergency",
            "treatment",
            "radiology",
            "imaging",
            "recovery",
            "triage",
            "xray",
            "mri",
        ]
    ),
    "dark": frozenset(["cinema", "theater", "theatre", "screening", "projection", "darkroom", "imax"]),
    "cooking": frozenset(["kitchen", "kitchenette", "kitchens", "scullery"]),
    "living": frozenset(["living", "kitchen", "dining", "family", "breakfast", "kitchenette", "den"]),
    "sleeping": frozenset(["bedroom", "guest", "suite", "dormitory", "nursery", "dorm"]),
}


@cache
def is_class(room_type: str, name: str) -> bool:
    """Tell whether a room type belongs to a class of `ROOM_CLASSES`.

    Examples
    --------
    >>> is_class("staff_toilet", "wet"), is_class("open_office", "wet")
    (True, False)
    >>> is_class("store_room", "store"), is_class("grocery_store", "store")
    (True, False)
    """
    words = room_type.lower().replace("-", "_").replace(" ", "_").split("_")
    words = [word for word in words if word and not word.isdigit()]
    if name == "dark":
        return any(word in ROOM_CLASSES["dark"] for word in words)
    if len(words) > 1 and words[-1] in ("store", "market"):
        # A "grocery store" sells; a "store room" keeps.
        return name == "assembly"
    if len(words) > 1 and words[-1] == "hall" and words[0] not in ROOM_CLASSES["circulation"]:
        # People gather in an "exhibition hall" and pass through an "entrance hall".
        return name == ("teaching" if words[0] in ROOM_CLASSES["teaching"] else "assembly")
    members = ROOM_CLASSES[name]
    return any(word in members for word in words)
