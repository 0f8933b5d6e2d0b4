"""Where people keep things: which rooms are worth a look first."""

from typing import Final

from mansion_tasks.agents.words import match_score

__all__ = ["likelihood", "shut_away_in"]

_KEPT: Final = (
    (
        ("apple", "banana", "bread", "egg", "lettuce", "potato", "tomato", "juice carton", "can", "cola can", "bottle",
         "water bottle", "milk carton", "cup", "mug", "glass", "plate", "bowl", "fork", "knife", "butter knife",
         "spoon", "pan", "pot", "kettle", "salt shaker", "pepper shaker", "cutting board", "spatula", "ladle",
         "dish sponge", "detergent", "wine bottle", "wine glass", "lunch box"),
        ("kitchen", "break room", "cafeteria", "pantry", "dining room", "restaurant", "canteen", "bar"),
    ),
    (
        ("keyboard", "mouse", "laptop", "notebook", "pen", "pencil", "paper stack", "folder", "stapler", "headphone",
         "desk phone", "monitor", "tablet", "document", "binder", "calculator", "marker", "desk lamp"),
        ("office", "meeting room", "study", "classroom", "print room", "reception", "training room", "library",
         "teachers room"),
    ),
    (
        ("package", "box", "cardboard box", "toolbox", "spray bottle", "bucket", "broom", "crate", "basket", "drill",
         "hammer", "screwdriver"),
        ("storage", "mail room", "utility room", "janitor closet", "garage", "workshop", "laundry room", "stockroom"),
    ),
    (
        ("towel", "soap bar", "soap bottle", "toothpaste", "toothbrush", "toilet paper", "shampoo", "hand towel"),
        ("bathroom", "restroom", "laundry room", "changing room"),
    ),
    (
        ("pillow", "blanket", "alarm clock", "teddy bear", "table lamp", "hair brush"),
        ("bedroom", "master bedroom", "guest room", "patient room", "ward", "hotel room"),
    ),
    (
        ("remote control", "vase", "candle", "newspaper", "magazine", "book", "cloth", "key chain", "picture frame"),
        ("living room", "lounge", "library", "dining room", "study"),
    ),
)  # fmt: skip
"""Things, and the rooms where most of them are."""

_CHILLED: Final = (
    "apple", "banana", "bread", "egg", "lettuce", "potato", "tomato", "juice carton", "can", "cola can", "bottle",
    "water bottle", "milk carton", "wine bottle", "lunch box",
)  # fmt: skip

_BARE: Final = ("corridor", "restroom", "staircase", "elevator lobby", "shaft")


def likelihood(noun: str, room: str) -> int:
    """Return whether a thing is likely in a room: 2 where it belongs, 0 where hardly anything is, else 1.

    Examples
    --------
    >>> likelihood("potato", "break_room"), likelihood("potato", "office 2"), likelihood("potato", "corridor")
    (2, 1, 0)
    """
    for things, rooms in _KEPT:
        if any(match_score(noun, thing) == 3 for thing in things) and any(
            match_score(name, room) > 1 for name in rooms
        ):
            return 2
    return 0 if any(match_score(name, room) > 1 for name in _BARE) else 1


def shut_away_in(noun: str) -> str:
    """Return the closed furniture that a thing is often in, empty for none.

    Examples
    --------
    >>> shut_away_in("potato"), shut_away_in("laptop")
    ('fridge', '')
    """
    return "fridge" if any(match_score(noun, thing) == 3 for thing in _CHILLED) else ""
