"""Skill cards: the skills as they are described to a model, and the calls made from its answers."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite
from typing import Any, Final

from mansion_skills.skills.registry import SKILLS, in_order

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


_ORDER: Final = (
    "GoToLandmark",
    "GoNearObject",
    "MoveAhead",
    "Rotate",
    "LookUp",
    "LookDown",
    "PickUp",
    "Place",
    "OpenObject",
    "CloseObject",
    "OpenDoor",
    "CallElevator",
    "UseElevator",
    "TakeStairs",
)
"""Recorded answers are found again by the prompt, in which the cards have this order."""


def _cards() -> dict[str, Card]:
    cards = {}
    for skill in in_order(SKILLS.values(), _ORDER):
        if skill.card is not None:
            types = {name: skill.parameters[name].json_type for name in skill.card.arguments}
            cards[skill.name] = Card(skill.card.description, types, skill.card.optional)
    return cards


CARDS: Final[Mapping[str, Card]] = _cards()
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
            return f"{name} of {skill} must be a string, not {shown}"
    return ""
