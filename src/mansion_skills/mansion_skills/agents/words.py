"""Words of instructions beside the names of categories and rooms."""

from typing import Final

__all__ = ["COLORS", "match_score", "matches", "singular"]

# fmt: off
COLORS: Final = frozenset((
    "red", "orange", "yellow", "green", "blue", "purple", "violet", "pink", "brown", "beige", "black", "white",
    "gray", "grey", "silver", "gold", "golden", "cream", "turquoise", "teal", "navy", "maroon", "tan", "transparent",
))
# fmt: on

_ALIKE: Final = (
    ("sofa", "couch", "settee"),
    ("cell phone", "cellphone", "mobile phone", "smartphone", "phone", "mobile"),
    ("television", "tv", "tv set"),
    ("restroom", "toilet", "bathroom", "washroom", "wc", "lavatory"),
    ("fridge", "refrigerator", "freezer"),
    ("laptop", "notebook computer", "laptop computer"),
    ("trash can", "garbage can", "waste bin", "bin", "trash bin", "dustbin", "wastebasket"),
    ("cup", "coffee cup"),
    ("cloth", "rag", "dish cloth", "dishcloth", "cleaning cloth"),
    ("toolbox", "tool box"),
    ("wardrobe", "closet"),
    ("bookshelf", "bookcase", "shelf", "shelves", "shelving unit"),
    ("lobby", "entrance hall", "foyer", "reception"),
    ("living room", "lounge"),
    ("corridor", "hallway", "hall", "passage"),
    ("drawer", "dresser", "chest of drawers"),
    ("remote", "remote control"),
    ("key", "keychain", "key chain"),
    ("lift", "elevator"),
)
_GROUPS: Final = {word: group for group in _ALIKE for word in group}


def singular(word: str) -> str:
    """Return an English noun in the singular, by its ending.

    Examples
    --------
    >>> singular("boxes"), singular("shelves"), singular("knives"), singular("gloves"), singular("glass")
    ('box', 'shelf', 'knife', 'glove', 'glass')
    """
    if word.endswith("ives"):
        return word[:-3] + "fe"
    if word.endswith(("lves", "aves")):
        return word[:-3] + "f"
    if word.endswith(("sses", "shes", "ches", "xes")):
        return word[:-2]
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    if word.endswith("s") and not word.endswith(("ss", "us", "is")) and len(word) > 3:
        return word[:-1]
    return word


def match_score(noun: str, name: str) -> int:
    """Return how well a noun names a category or a room.

    Returns
    -------
    int
        3: with the same or an equal word, and number. 2: the name is of a kind of the noun, or lacks the number ("1" is
        understood). 1: the noun is of a kind of the name. 0: not at all.

    Examples
    --------
    >>> match_score("couch", "sofa"), match_score("table", "dining_table"), match_score("pen", "open_shelf")
    (3, 2, 0)
    >>> match_score("round table", "table"), match_score("office 2", "office_3"), match_score("hall 1", "hall")
    (1, 0, 2)
    """
    wanted, known = _plain(noun), _plain(name)
    asked, given = _number(noun), _number(name)
    if not wanted or not known or (asked and asked != (given or "1")):
        return 0
    if any(a == b for a in _spellings(wanted) for b in _spellings(known)):
        return 3 if asked in ("", given) else 2
    if any(f" {known}".endswith(f" {a}") for a in _spellings(wanted)):
        return 2
    return int(any(f" {wanted}".endswith(f" {b}") for b in _spellings(known)))


def matches(noun: str, name: str) -> bool:
    """Whether a noun may name a category or a room."""
    return match_score(noun, name) > 0


def _plain(text: str) -> str:
    words = text.casefold().replace("_", " ").replace("-", " ").split()
    while words and words[-1].isdigit():
        words.pop()
    return " ".join([*words[:-1], singular(words[-1])]) if words else ""


def _number(text: str) -> str:
    """Return the number that a name ends with, empty for none."""
    last = text.replace("_", " ").split()[-1:]
    return last[0] if last and last[0].isdigit() else ""


def _spellings(text: str) -> tuple[str, ...]:
    """Return a noun, its joined spelling, and its synonyms."""
    joined = text.replace(" ", "")
    return tuple(dict.fromkeys((text, joined, *_GROUPS.get(text, ()))))
