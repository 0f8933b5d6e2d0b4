"""Where people keep things: which rooms are worth a look first."""

from typing import Final

from mansion_knowledge import words_by
from mansion_tasks.agents.words import match_score

__all__ = ["likelihood", "shut_away_in"]

_KEPT: Final = (
    (
        ("apple", "banana", "bread", "egg", "lettuce", "potato", "tomato", "juice carton", "can", "cola can", "bottle",
         "water bottle", "milk carton", "cup", "mug", "glass", "plate", "bowl", "fork", "knife", "butter knife",
         "spoon", "pan", "pot", "kettle", "salt shaker", "pepper shaker", "cutting board", "spatula", "ladle",
         "dish sponge", "detergent", "wine bottle", "wine glass", "lunch box"),
        "food",
    ),
    (
        ("keyboard", "mouse", "laptop", "notebook", "pen", "pencil", "paper stack", "folder", "stapler", "headphone",
         "desk phone", "monitor", "tablet", "document", "binder", "calculator", "marker", "desk lamp"),
        "office",
    ),
    (
        ("package", "box", "cardboard box", "toolbox", "spray bottle", "bucket", "broom", "crate", "basket", "drill",
         "hammer", "screwdriver"),
        "tools",
    ),
    (
        ("towel", "soap bar", "soap bottle", "toothpaste", "toothbrush", "toilet paper", "shampoo", "hand towel"),
        "washing",
    ),
    (
        ("pillow", "blanket", "alarm clock", "teddy bear", "table lamp", "hair brush"),
        "sleeping",
    ),
    (
        ("remote control", "vase", "candle", "newspaper", "magazine", "book", "cloth", "key chain", "picture frame"),
        "reading",
    ),
)  # fmt: skip
"""Things, and what the rooms where most of them are usually keep."""

_CHILLED: Final = (
    "apple", "banana", "bread", "egg", "lettuce", "potato", "tomato", "juice carton", "can", "cola can", "bottle",
    "water bottle", "milk carton", "wine bottle", "lunch box",
)  # fmt: skip


def likelihood(noun: str, room: str) -> int:
    """Return whether a thing is likely in a room: 2 where it belongs, 0 where hardly anything is, else 1.

    Examples
    --------
    >>> likelihood("potato", "break_room"), likelihood("potato", "office 2"), likelihood("potato", "corridor")
    (2, 1, 0)
    """
    keeps = words_by("keeps")
    for things, kept in _KEPT:
        if any(match_score(noun, thing) == 3 for thing in things) and any(
            match_score(name, room) > 1 for name in keeps[kept]
        ):
            return 2
    return 0 if any(match_score(name, room) > 1 for name in keeps["nothing"]) else 1


def shut_away_in(noun: str) -> str:
    """Return the closed furniture that a thing is often in, empty for none.

    Examples
    --------
    >>> shut_away_in("potato"), shut_away_in("laptop")
    ('fridge', '')
    """
    return "fridge" if any(match_score(noun, thing) == 3 for thing in _CHILLED) else ""
