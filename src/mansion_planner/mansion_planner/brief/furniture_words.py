"""Which furniture of the asset catalogue a phrase of a brief names."""

from functools import lru_cache
from typing import TYPE_CHECKING

from mansion_knowledge.object_kinds import answers
from mansion_language import singular
from mansion_msgs_py.late_imports import importing

if TYPE_CHECKING:
    from mansion_assets.catalogue import Catalogue

__all__ = ["furniture_of", "furniture_vocabulary", "own_furniture_of", "special_kind", "usually_in"]


def furniture_of(words: tuple[str, ...]) -> tuple[str, int]:
    """Return the category of the asset catalogue that a phrase ends with, and of how many words; empty for none.

    A thing before another that it is a kind of tells the kind: "recliner armchairs".

    Examples
    --------
    >>> furniture_of(("grand", "piano")), furniture_of(("big", "sofa")), furniture_of(("dream",))
    (('grand_piano', 2), ('sofa', 1), ('', 0))
    """
    table = _furniture()
    for size in range(min(4, len(words)), 0, -1):
        category = table.get(words[-size:])
        if category is None:
            continue
        kind = table.get(words[-size - 1 : -size], "")
        if category and kind and kind != category and answers(category, kind):
            return kind, size + 1
        return category, size if category else 0
    return "", 0


def own_furniture_of(words: tuple[str, ...]) -> str:
    """Return the category of a preferred asset whose name, of several words, ends a phrase; empty for none.

    Such a name says the thing and not a room that is called so ("espresso bar").
    """
    table = _own_phrases_of(_present_catalogue())
    tails = (words[start:] for start in range(len(words) - 1)) if table else ()
    return next((table[tail] for tail in tails if tail in table), "")


_MEANT = {
    "seat": "chair",
    "place": "",
    "book": "",
    "cover": "",
    "box": "",
    "watch": "",
    "badge": "",
    "key": "",
    "light": "",
    "stage": "",
    "sign": "",
    "pump": "",
    "cart": "",
    "paper": "",
    "board": "",
    "stand": "",
    "case": "",
    "tea": "",
    "coffee": "",
    "post": "",
    "mail": "",
    "baggage": "",
    "luggage": "",
    "delivery": "",
    "report": "",
    "heating": "",
    "file": "",
    "score": "",
    "snack": "",
    "wheel": "",
    "green": "",
    "drum": "",
    "feeder": "",
    "plastic": "",
    "treatment plant": "",
    "power plant": "",
    "boiler plant": "",
    "chiller plant": "",
    "cooling plant": "",
    "filtration plant": "",
    "heating plant": "",
    "water plant": "",
    "plant": "house_plant",
    "computer": "computer_tower",
    "counter": "sales_counter",
    "screen": "",
    "window": "",
    "table": "dining_table",
    "tub": "bathtub",
    "telly": "television",
    "tv": "television",
    "bike": "bicycle",
    "press": "",
    "fan": "",
    "scale": "",
    "rack": "metal_shelf",
    "couch": "sofa",
    "settee": "sofa",
    "cooker": "stove",
    "exam couch": "exam_table",
    "treatment couch": "exam_table",
    "massage couch": "massage_table",
    "oven": "stove",
    "deck oven": "baking_oven",
    "shelf": "shelving_unit",
    "glass": "",
    "brick": "",
    "plaster": "",
    "lime": "",
    "range": "stove",
    "remote": "",
    "book case": "bookshelf",
    "shoe box": "shoe_rack",
    "bookcase": "bookshelf",
    "locker": "locker",
    "workstation": "office_desk",
    "workplace": "office_desk",
    "island": "kitchen_island",
    "breakfast bar": "kitchen_island",
    "little table": "cafe_table",
    "tiny table": "cafe_table",
    "bunk": "bunk_bed",
    "berth": "single_bed",
    "cot": "crib",
    "concert grand": "grand_piano",
    "steinway": "grand_piano",
}
"""Category that a phrase means here, before the catalogue's own names and synonyms; empty for none."""


def furniture_vocabulary() -> frozenset[str]:
    """Return the words of all names of furniture, in the singular."""
    return _words_of(_present_catalogue())


@lru_cache(maxsize=8)
def _words_of(catalogue: "Catalogue") -> frozenset[str]:
    return frozenset(word for phrase, category in _phrases_of(catalogue).items() if category for word in phrase)


def _furniture() -> dict[tuple[str, ...], str]:
    return _phrases_of(_present_catalogue())


def _present_catalogue() -> "Catalogue":
    """Return the catalogue with the user's own assets, which may be others for another call in this process."""
    with importing:
        from mansion_assets.catalogue import load_catalogue

    return load_catalogue()


@lru_cache(maxsize=512)
def _held(catalogue: "Catalogue", room_type: str) -> frozenset[str]:
    program = catalogue.room_program(room_type)
    named = [*(item.category for item in program.floor), *(item.category for item in program.wall)]
    return frozenset(category for names in named for category in ([names] if isinstance(names, str) else names))


def usually_in(category: str, room_type: str) -> bool:
    """Whether rooms of a type are usually furnished with pieces of a category."""
    return category in _held(_present_catalogue(), room_type)


def special_kind(category: str, noun: str, room_type: str) -> str:
    """Return what a bare noun means in a room: the racks of a server room are server racks.

    That is the category of the room's usual furniture that the noun is the last word of, where there is one such.

    Examples
    --------
    >>> special_kind("metal_shelf", "rack", "server_room"), special_kind("metal_shelf", "rack", "storage")
    ('server_rack', 'metal_shelf')
    """
    if not category or category.endswith(noun):
        return category
    found = [other for other in _held(_present_catalogue(), room_type) if other.endswith(f"_{noun}")]
    return found[0] if len(found) == 1 else category


def _key(phrase: str) -> tuple[str, ...]:
    return tuple(singular(word) for word in phrase.lower().replace("-", " ").replace("_", " ").split())


@lru_cache(maxsize=8)
def _own_phrases_of(catalogue: "Catalogue") -> dict[tuple[str, ...], str]:
    """Phrases for preferred assets, by their words in the singular."""
    table: dict[tuple[str, ...], str] = {}
    for asset in (catalogue.asset(key) for key in sorted(catalogue.preferred)):
        for phrase in (asset.category.replace("_", " "), asset.name, *asset.synonyms):
            table.setdefault(_key(phrase), asset.category)
    return table


@lru_cache(maxsize=8)
def _phrases_of(catalogue: "Catalogue") -> dict[tuple[str, ...], str]:
    """Phrases of an asset catalogue, by their words in the singular; names win over synonyms."""
    table: dict[tuple[str, ...], str] = {}
    for names in (True, False):
        for category in catalogue.categories:
            first, *others = catalogue.by_category(category)
            for asset in (first, *(other for other in others if other.record)):
                for phrase in (category.replace("_", " "), asset.name) if names else asset.synonyms:
                    table.setdefault(_key(phrase), category)
    for phrase, category in _MEANT.items():
        table[tuple(phrase.split())] = category
    return table
