"""Words that mean the same thing or the same room."""

from typing import Final, NamedTuple

from mansion_knowledge import name_groups

__all__ = ["ROOMS", "THINGS", "Synonyms"]


class Synonyms(NamedTuple):
    """Words for one thing.

    Attributes
    ----------
    same : tuple of str
        Words that mean the same to whoever uses them.
    goal : tuple of str
        Further words that the goal of a task takes for the same.
    talk : tuple of str
        Further words, of things close to it too, that people may mean it by; for who has to search.
    """

    same: tuple[str, ...]
    goal: tuple[str, ...] = ()
    talk: tuple[str, ...] = ()


THINGS: Final = (
    Synonyms(("sofa", "couch", "settee"), goal=("loveseat",)),
    Synonyms(("cell phone", "cellphone", "mobile phone", "smartphone", "mobile"), talk=("phone",)),
    Synonyms(("television", "tv"), talk=("tv set",)),
    Synonyms(("fridge", "refrigerator"), talk=("freezer",)),
    Synonyms(("laptop", "notebook computer"), talk=("laptop computer",)),
    Synonyms(("waste bin", "trash can", "garbage can", "bin"), talk=("trash bin", "dustbin", "wastebasket")),
    Synonyms(("cup",), talk=("coffee cup",)),
    Synonyms(("cloth", "rag", "dishcloth"), talk=("dish cloth", "cleaning cloth")),
    Synonyms(("toolbox", "tool box")),
    Synonyms(("basketball",), goal=("basket ball",)),
    Synonyms(("cabinet",), goal=("cupboard",)),
    Synonyms(("wardrobe",), talk=("closet",)),
    Synonyms(("bookshelf",), talk=("bookcase", "shelf", "shelves", "shelving unit")),
    Synonyms(("drawer",), talk=("dresser", "chest of drawers")),
    Synonyms(("remote",), talk=("remote control",)),
    Synonyms(("key",), talk=("keychain", "key chain")),
    Synonyms(("lift",), talk=("elevator",)),
)

ROOMS: Final = tuple(
    Synonyms(*(tuple(name for name, level in names.items() if level == wanted) for wanted in ("", "goal", "talk")))
    for names in name_groups().values()
    if "" in names.values()
)
