"""The skills as a model is told of them, and the calls that its answers may become."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite
from typing import Any, Final

__all__ = ["CARDS", "Card", "card_lines", "faulty_arguments"]


@dataclass(frozen=True)
class Card:
    """A skill that a model may choose.

    Attributes
    ----------
    words : str
        What it does, and what it needs.
    arguments : mapping
        Name to type: ``number`` or ``text``.
    optional : tuple of str
        Arguments that may be left out.
    """

    words: str
    arguments: Mapping[str, str]
    optional: tuple[str, ...] = ()


CARDS: Final[Mapping[str, Card]] = {
    "GoToLandmark": Card("go to a landmark of this floor", {"landmark": "text"}),
    "GoNearObject": Card("go to an object in view, near enough to handle it", {"object": "text"}),
    "MoveAhead": Card("go straight ahead, metres; negative goes back", {"distance": "number"}),
    "Rotate": Card("turn on the spot, degrees, counter-clockwise; to look around", {"degrees": "number"}),
    "LookUp": Card("tilt the camera up, degrees", {"degrees": "number"}),
    "LookDown": Card("tilt the camera down, degrees", {"degrees": "number"}),
    "PickUp": Card("take an object within reach; the hand must be empty", {"object": "text"}),
    "Place": Card(
        "put what is held `on` or `in` an object within reach, or `on` the `floor` before the robot",
        {"target": "text", "relation": "text"},
        ("relation",),
    ),
    "OpenObject": Card("open an object within reach", {"object": "text"}),
    "CloseObject": Card("close an object within reach", {"object": "text"}),
    "OpenDoor": Card("open the nearest door", {}),
    "CallElevator": Card("call the lift; the robot must stand at its entrance (GoToLandmark elevator)", {}),
    "UseElevator": Card("ride the called lift to a floor", {"target_floor": "number"}),
    "TakeStairs": Card(
        "walk one floor `Up` or `Down`; the robot must stand at the stairs (GoToLandmark stairs)", {"direction": "text"}
    ),
}
"""Skill name to its card: all that a model can do, whatever it answers."""

LONGEST: Final = 200


def card_lines() -> str:
    """Return the cards, a line each."""
    return "\n".join(f"- {name}({', '.join(card.arguments)}): {card.words}" for name, card in CARDS.items())


def faulty_arguments(skill: str, arguments: Mapping[str, Any]) -> str:
    """Return what is wrong with a call, empty for nothing.

    Examples
    --------
    >>> faulty_arguments("UseElevator", {"target_floor": "up"})
    "target_floor of UseElevator must be a number, not 'up'"
    >>> faulty_arguments("MoveAhead", {"distance": 0.5})
    ''
    """
    card = CARDS.get(skill)
    if card is None:
        return f"there is no skill {skill[:40]!r}; known are {', '.join(CARDS)}"
    for name in arguments:
        if name not in card.arguments:
            return f"{skill} takes no {str(name)[:40]!r}; it takes {', '.join(card.arguments) or 'nothing'}"
    for name, kind in card.arguments.items():
        if name not in arguments:
            if name in card.optional:
                continue
            return f"{skill} needs {name}"
        value = arguments[name]
        shown = repr(value)[:40]
        if kind == "number":
            right = isinstance(value, int | float) and not isinstance(value, bool)
            if not right or not isfinite(value):
                return f"{name} of {skill} must be a number, not {shown}"
        elif not isinstance(value, str) or not 0 < len(value) <= LONGEST:
            return f"{name} of {skill} must be a text, not {shown}"
    return ""
