"""Singular and plural of English nouns, by rules of spelling and a table of the nouns that break them.

Statistical lemmatisers know more nouns but take a third of a second to load, and suffix rules alone turn "gas" into
"ga"; the table below holds the exceptions among the nouns of buildings, furniture and people.
"""

from functools import lru_cache

__all__ = ["is_plural", "plural", "singular"]

_IRREGULAR = {
    "men": "man", "women": "woman",
    "gentlemen": "gentleman", "workmen": "workman", "firemen": "fireman",
    "policemen": "policeman", "craftsmen": "craftsman", "salesmen": "salesman", "fishermen": "fisherman",
    "businessmen": "businessman", "doormen": "doorman",
    "children": "child", "people": "person", "feet": "foot", "geese": "goose",
    "mice": "mouse", "teeth": "tooth", "oxen": "ox",
    "knives": "knife", "wives": "wife", "lives": "life", "shelves": "shelf", "bookshelves": "bookshelf",
    "loaves": "loaf", "leaves": "leaf", "halves": "half", "calves": "calf", "wolves": "wolf", "scarves": "scarf",
    "midwives": "midwife", "customs": "customs", "thieves": "thief", "selves": "self",
    "atria": "atrium", "auditoria": "auditorium", "gymnasia": "gymnasium", "aquaria": "aquarium", "cacti": "cactus",
    "radii": "radius", "foci": "focus", "criteria": "criterion", "analyses": "analysis", "axes": "axis",
    "bases": "base", "buses": "bus", "gases": "gas", "lenses": "lens", "canvases": "canvas", "campuses": "campus",
    "viruses": "virus", "cookies": "cookie", "movies": "movie", "ties": "tie", "pies": "pie", "zombies": "zombie",
    "calories": "calorie", "selfies": "selfie", "smoothies": "smoothie", "brownies": "brownie",
    "shoes": "shoe", "toes": "toe", "canoes": "canoe", "horseshoes": "horseshoe",
    "potatoes": "potato", "tomatoes": "tomato", "heroes": "hero", "echoes": "echo", "mosquitoes": "mosquito",
    "volcanoes": "volcano", "torpedoes": "torpedo",
    "houses": "house", "warehouses": "warehouse", "greenhouses": "greenhouse", "caches": "cache", "niches": "niche",
    "headaches": "headache", "axles": "axle", "avalanches": "avalanche", "quiches": "quiche", "crèches": "crèche",
    "creches": "creche", "boxes": "box", "quizzes": "quiz", "waltzes": "waltz",
    "wcs": "wc", "tvs": "tv",
    "delis": "deli", "menus": "menu", "minis": "mini", "semis": "semi", "taxis": "taxi", "focuses": "focus",
    "octopuses": "octopus",
    "apparatuses": "apparatus", "thermoses": "thermos", "solaria": "solarium", "lies": "lie", "bonuses": "bonus",
    "mattresses": "mattress", "staffs": "staff", "cliffs": "cliff",
}  # fmt: skip
"""Plurals that no rule of spelling leads back to their singular."""

_INVARIABLE = frozenset(
    """
    access always analysis apparatus as asbestos atlas axis barracks basis bass besides billiards bonus boss bus
    business campus canvas census chaos chassis chess christmas circus cactus class clothes compass corps cosmos
    cross crossroads dress express fitness focus gas genius glasses-case glass gross gymnastics has haus
    headquarters is its iris lens less mass mathematics means mess minus news octopus pass perhaps physics plus
    premises press process progress radius series species status stress success tennis thermos this thus trellis
    terminus tennis us various versus virus was wellness yes across address analysis athletics electronics economics
    politics goggles jeans logistics pants pliers robotics scissors shorts tongs trousers tweezers upstairs
    downstairs outdoors indoors overseas alas dais pancreas trans canvas paris texas sometimes gis cms pos wireless
    endless seamless careless cashless restless business-class hers ours theirs yours does goes plans-chest bellows
    gallows ceramics acoustics optics genetics aerobics
    """.split()
)  # fmt: skip
"""Words in -s that are singular, or have no other form."""

_TAKES_VES = {"knife": "knives", "wife": "wives", "life": "lives", "shelf": "shelves", "bookshelf": "bookshelves",
              "loaf": "loaves", "leaf": "leaves", "half": "halves", "calf": "calves", "wolf": "wolves",
              "midwife": "midwives", "scarf": "scarves", "thief": "thieves", "self": "selves"}  # fmt: skip
_TAKES_OES = frozenset({"potato", "tomato", "hero", "echo", "mosquito", "volcano", "torpedo"})
_OTHER_PLURALS = {one: many for many, one in _IRREGULAR.items() if not many.endswith("s") or one.endswith("is")}


@lru_cache(maxsize=4096)
def singular(noun: str) -> str:
    """Return the singular of an English noun in lower case; a noun in the singular stays as it is.

    Examples
    --------
    >>> [singular(noun) for noun in ("knives", "lobbies", "glasses", "gas", "gloves", "stairs", "studies")]
    ['knife', 'lobby', 'glass', 'gas', 'glove', 'stair', 'study']
    """
    if noun in _IRREGULAR:
        return _IRREGULAR[noun]
    if len(noun) <= 3 or not noun.endswith("s") or noun in _INVARIABLE or noun.endswith(("ss", "us", "is", "ous")):
        return noun
    if noun.endswith("ies"):
        return noun[:-3] + "y"
    if noun.endswith(("ches", "shes", "xes", "sses", "zzes")):
        return noun[:-2]
    return noun[:-1]


@lru_cache(maxsize=4096)
def plural(noun: str) -> str:
    """Return the plural of an English noun in lower case.

    Examples
    --------
    >>> [plural(noun) for noun in ("knife", "lobby", "glass", "storey", "man", "roof", "sofa", "series")]
    ['knives', 'lobbies', 'glasses', 'storeys', 'men', 'roofs', 'sofas', 'series']
    """
    head, _, last = noun.rpartition(" ")
    start = f"{head} " if head else ""
    if last in _TAKES_VES:
        return start + _TAKES_VES[last]
    if last in _OTHER_PLURALS:
        return start + _OTHER_PLURALS[last]
    if last.endswith("man") and last not in ("human", "roman", "german", "ottoman", "talisman"):
        return start + last[:-3] + "men"
    if singular(last) != last or last in ("series", "species", "scissors", "premises", "headquarters", "barracks"):
        return noun
    if last.endswith("y") and last[-2:-1] not in tuple("aeiou"):
        return start + last[:-1] + "ies"
    if last.endswith(("s", "x", "ch", "sh")) or last in _TAKES_OES:
        return start + last + "es"
    if last.endswith("z"):
        return start + last + "zes"
    return start + last + "s"


def is_plural(noun: str) -> bool:
    """Whether a noun stands in the plural.

    Examples
    --------
    >>> is_plural("work gloves"), is_plural("glass"), is_plural("children")
    (True, False, True)
    """
    last = noun.rpartition(" ")[2]
    return singular(last) != last
