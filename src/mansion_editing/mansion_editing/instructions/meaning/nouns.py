"""What nouns name in a scene: kinds of the catalogue, an object's own name or id, and words for many kinds at once."""

import re
from collections.abc import Callable, Iterable
from functools import lru_cache
from typing import Final

from mansion_assets.catalogue.vocabulary import stems, vocabulary_of
from mansion_editing.instructions.phrases.lexicon import LIGHTS
from mansion_editing.instructions.phrases.nouns import HOLDERS
from mansion_editing.state import SceneState
from mansion_language.colours import COLOUR_WORDS, colour_of
from mansion_msgs_py.scene import SceneObject

__all__ = [
    "called",
    "has_colour",
    "has_material",
    "id_order",
    "is_among_counters",
    "is_fixed",
    "is_light",
    "is_loose",
    "looks_like",
    "names_many",
]

_BUILT_IN: Final = frozenset({"sink", "faucet", "beer_tap"})
"""Categories that stand in furniture and are fixed to it all the same."""

_SEATS: Final = ("chair", "stool", "sofa", "loveseat", "bench", "seat", "pouf", "ottoman", "recliner", "pew", "couch")
_SOFAS: Final = ("sofa", "loveseat")
_CUPBOARDS: Final = ("wall_cabinet", "storage_cabinet", "china_cabinet", "bathroom_cabinet", "medicine_cabinet")
_DRINKS: Final = ("cola_can", "juice_carton", "milk_carton", "water_bottle", "beer_bottle", "wine_bottle")
_FOOD: Final = (
    "yogurt", "cheese", "butter", "jam_jar", "cereal_box", "canned_food", "apple", "orange", "banana", "lemon",
    "tomato", "potato", "egg", "lettuce", "bread", "sandwich", "cake", "donut_box", "fruit_bowl", "popcorn_bucket",
)  # fmt: skip
_DISHES: Final = ("plate", "bowl", "cup", "mug", "glass", "wine_glass", "pot", "pan", "teapot")
_CUTLERY: Final = ("fork", "knife", "butter_knife", "spoon", "ladle", "spatula")
_PICTURES: Final = ("painting", "large_painting", "poster", "picture_frame", "tapestry")
_DECORATION: Final = (*_PICTURES, "vase", "flower_vase", "statue", "table_top_decor", "room_decor", "candle", "trophy")
_RUGS: Final = ("rug", "round_rug", "runner_rug", "door_mat", "bath_mat", "play_mat", "prayer_rug")
_APPLIANCES: Final = (
    "fridge", "freezer", "stove", "oven", "dishwasher", "microwave", "toaster", "kettle", "coffee_machine", "blender",
    "washing_machine", "clothes_dryer", "rice_cooker", "minibar",
)  # fmt: skip
_AMONG_COUNTERS: Final = ("stove", "oven", "sink", "sink_unit", "fridge", "freezer", "dishwasher", "washing_machine")
_COMPUTERS: Final = ("laptop", "monitor", "computer_tower", "desktop_computer", "all_in_one_computer")
_TOYS: Final = ("teddy_bear", "toy_car", "toy_blocks", "doll", "board_game", "rocking_horse", "toy_kitchen")
_BOOKS: Final = ("book", "book_stack", "book_upright")
_CLOTHES: Final = ("boots", "sneakers", "slippers", "work_gloves")
_ANYTHING: Final = frozenset(
    "thing object item stuff everything anything something content clutter belonging possession mess".split()
)


def _ending(ends: Iterable[str]) -> Callable[[SceneObject], bool]:
    found = tuple(ends)
    return lambda item: item.category.endswith(found)


def _one_of(categories: Iterable[str]) -> Callable[[SceneObject], bool]:
    found = frozenset(categories)
    return lambda item: item.category in found


def is_light(item: SceneObject) -> bool:
    """Whether an object gives light and switches."""
    return item.toggleable and item.category.endswith(LIGHTS)


def is_loose(item: SceneObject) -> bool:
    """Whether an object can be carried off by hand, or lies on or in furniture without being built into it."""
    return item.category not in _BUILT_IN and (item.pickupable or item.mount in ("surface", "inside"))


def is_fixed(item: SceneObject) -> bool:
    """Whether an object hangs on a wall or a ceiling, or is built into furniture."""
    return item.mount in ("wall", "ceiling") or item.category in _BUILT_IN


def is_among_counters(item: SceneObject) -> bool:
    """Whether furniture stands in a row with counters, on which lies what people put beside it: a stove, a sink."""
    return item.mount == "floor" and item.category.endswith(_AMONG_COUNTERS)


def _is_furniture(item: SceneObject) -> bool:
    return item.mount == "floor" and not item.pickupable and item.size[2] > 0.03


_MANY: Final[dict[str, Callable[[SceneObject], bool]]] = {
    **{word: (lambda item: not is_fixed(item)) for word in _ANYTHING},
    "switchable": lambda item: item.toggleable,
    "openable": lambda item: item.openable,
    "counter": _ending(("counter", "counter_top")),
    "sink": _ending(("sink", "sink_unit")),
    "basin": _ending(("washbasin", "sink")),
    "toilet": _one_of(("toilet", "toilet_pan")),
    "cupboard": _one_of(_CUPBOARDS),
    "couch": _ending(_SOFAS),
    "settee": _ending(_SOFAS),
    "pc": _one_of(_COMPUTERS),
    "furniture": _is_furniture,
    "furnishing": _is_furniture,
    "light": is_light,
    "lighting": is_light,
    "lamp": is_light,
    "ceiling light": lambda item: is_light(item) and item.mount == "ceiling",
    "ceiling lamp": lambda item: is_light(item) and item.mount == "ceiling",
    "overhead light": lambda item: is_light(item) and item.mount == "ceiling",
    "seat": _ending(_SEATS),
    "seating": _ending(_SEATS),
    "drink": _one_of(_DRINKS),
    "beverage": _one_of(_DRINKS),
    "water": _one_of(("water_bottle", "water_jug")),
    "wine": _one_of(("wine_bottle",)),
    "food": _one_of(_FOOD),
    "snack": _one_of(_FOOD),
    "grocery": _one_of((*_FOOD, *_DRINKS)),
    "dish": _one_of(_DISHES),
    "crockery": _one_of(_DISHES),
    "tableware": _one_of((*_DISHES, *_CUTLERY)),
    "cutlery": _one_of(_CUTLERY),
    "silverware": _one_of(_CUTLERY),
    "picture": _one_of(_PICTURES),
    "artwork": _one_of(_PICTURES),
    "art": _one_of((*_PICTURES, "statue", "sculpture")),
    "decoration": _one_of(_DECORATION),
    "decor": _one_of(_DECORATION),
    "carpet": _one_of(_RUGS),
    "rug": _one_of(_RUGS),
    "alcohol": _one_of(("beer_bottle", "wine_bottle", "beer_tap")),
    "appliance": _ending(_APPLIANCES),
    "toy": _one_of(_TOYS),
    "computer": _one_of(_COMPUTERS),
    "book": _one_of(_BOOKS),
    "shoe": _one_of(_CLOTHES),
}  # fmt: skip
"""Words for many kinds, and what answers to them besides the kinds that the catalogue knows them by."""


_AT_BEDS: Final = frozenset(["bedside table", "nightstand", "night table", "night stand", "bedside cabinet"])
"""What people call the side table of a bedroom too."""


def names_many(noun: str) -> bool:
    """Whether a noun stands for many kinds (``furniture``, ``seat``); the empty one stands for anything."""
    return not noun or " ".join(stems(noun)) in _MANY


def called(
    state: SceneState, items: Iterable[SceneObject], noun: str, *, many: bool = False, every: bool = False
) -> list[SceneObject]:
    """Return the objects that a noun names, in the order of their ids.

    Parameters
    ----------
    noun : str
        A kind, an object's own name, an id or the end of one ("mug_2", "mug 2"); empty for all that is not fixed.
    many : bool
        The noun stands in the plural, or for all: kinds whose name ends with it answer too (office desks are desks).
        Else a kind of exactly this name is preferred where there is one.
    every : bool
        All of the kind are meant: pendant lamps too where all lamps are.
    """
    pool = sorted(items, key=id_order)
    words = " ".join(stems(noun))
    if whole := [item for item in pool if item.id.lower() == noun.strip().lower()]:
        return whole
    tail = noun.strip().lower().replace(" ", "_")
    numbered = re.search(r"_\d+$", tail) is not None
    ended = [item for item in pool if numbered and item.id.lower().endswith(f"/{tail}")]
    if ended or "/" in noun:
        return ended
    if words == "door":
        return []  # part of the structure, no door mat
    general = _MANY.get(words) if words else _MANY["thing"]
    if not words or words in _ANYTHING:
        return [item for item in pool if general is not None and general(item)]
    ranks = _ranks(state, pool, noun)
    alike = [item for item in pool if ranks[item.id] >= 2 or (general is not None and general(item))]
    if words == "lamp":
        alike = [item for item in alike if item.mount != "ceiling" or (every and _hangs_as_lamp(item))] or alike
    if not alike and words:
        vocabulary = vocabulary_of(state.catalogue)
        holder = words in HOLDERS and words.replace(" ", "_") in vocabulary.exact(stems(noun))  # no yogurt cups
        synonymous = vocabulary.synonymous(stems(noun)) or ([] if holder else vocabulary.ending(stems(noun)))
        alike = [item for item in pool if item.category in synonymous]
    if not alike and words:
        alike = _by_another_name(state, pool, noun)
    if not alike and words in _AT_BEDS:
        alike = [item for item in pool if item.category == "side_table" and _sleeps_in(state, item.room)]
    alike = _standing_synonyms(state, alike, noun) or alike
    if alike and not many:
        best = max(ranks[item.id] for item in alike)
        return [item for item in alike if best < 3 or ranks[item.id] == 3]
    if alike or vocabulary_of(state.catalogue).nouns(noun):
        return alike
    return [item for item in pool if ranks[item.id] == 1]


def _standing_synonyms(state: SceneState, alike: list[SceneObject], noun: str) -> list[SceneObject]:
    """Return the furniture that a noun is a name of, where all else that ends so is small or fixed: the bar."""
    kinds = vocabulary_of(state.catalogue).exact(stems(noun))
    named = [item for item in alike if item.category in kinds]
    stands = any(item.mount == "floor" for item in named)
    return named if stands and all(item.category in kinds or item.mount != "floor" for item in alike) else []


def _hangs_as_lamp(item: SceneObject) -> bool:
    """Whether what hangs is a lamp by its kind; the rest people call a light where other lamps stand in the room."""
    return item.category.endswith("lamp")


def _by_another_name(state: SceneState, pool: Iterable[SceneObject], noun: str) -> list[SceneObject]:
    """Return what the other names of a kind, of one word each, mean: the telly is the TV, and so is one on the wall."""
    vocabulary = vocabulary_of(state.catalogue)
    names = {
        name
        for kind in vocabulary.exact(stems(noun))
        for asset in state.catalogue.by_category(kind)[:1]
        for name in asset.synonyms
        if " " not in name
    }
    kinds = {kind for name in names for kind in vocabulary.nouns(name)}
    return [item for item in pool if item.category in kinds]


def _sleeps_in(state: SceneState, room: str) -> bool:
    """Whether a bed stands in a room."""
    return any(item.room == room and item.category.endswith("bed") for _, item in state.objects())


def _ranks(state: SceneState, pool: Iterable[SceneObject], noun: str) -> dict[str, int]:
    words = vocabulary_of(state.catalogue)
    memory: dict[tuple[str, str], int] = {}
    out = {}
    for item in pool:
        key = (item.category, item.name)
        if key not in memory:
            memory[key] = words.rank(item, noun.replace("_", " "))
        out[item.id] = memory[key]
    return out


def id_order(item: SceneObject) -> tuple[str, ...]:
    """Return a key that puts objects in the order of their ids, chair_2 before chair_10."""
    return _numbers_padded(item.id)


@lru_cache(maxsize=65536)
def _numbers_padded(name: str) -> tuple[str, ...]:
    return tuple(part.zfill(6) if part.isdigit() else part for part in re.split(r"(\d+)", name))


def has_colour(item: SceneObject, colour: str) -> bool:
    """Whether an object has a colour."""
    return colour_of(item.material) == COLOUR_WORDS.get(colour.lower(), colour.lower())


_SEEN_AS: Final = {
    "oak": "brown", "walnut": "brown", "birch": "beige", "steel": "grey", "chrome": "grey", "brass": "yellow",
    "amber": "brown",
}  # fmt: skip
"""Shades of materials that people call by a colour."""


def looks_like(item: SceneObject, colour: str) -> bool:
    """Whether people may call an object by a colour that its material is not named after: oak is brown."""
    word = COLOUR_WORDS.get(colour.lower(), colour.lower())
    if word == "green" and item.category.rstrip("0123456789").endswith(("plant", "planter_box")):
        return True
    return word in {_SEEN_AS.get(part) for part in item.material.split("_")} or has_colour(item, colour)


_MATERIALS: Final = {
    "wooden": "wood",
    "timber": "wood",
    "metallic": "metal",
    "cloth": "fabric",
    "textile": "fabric",
    "upholstered": "fabric",
    "marble": "stone",
    "granite": "stone",
    "concrete": "stone",
    "porcelain": "ceramic",
    "cardboard": "paper",
    "painted": "paint",
}


def has_material(item: SceneObject, material: str) -> bool:
    """Whether an object's main material is of a family (``wood``) or a shade (``oak``)."""
    word = material.lower()
    return _MATERIALS.get(word, word) in item.material.split("_")
