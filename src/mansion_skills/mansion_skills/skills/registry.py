"""All skills by name: those that the modules of this folder declare."""

import pkgutil
from collections.abc import Iterable, Iterator, Mapping
from importlib import import_module
from types import ModuleType
from typing import Final

import msgspec

from mansion_skills import skills as folder
from mansion_skills.skills.declaration import Skill

__all__ = ["SKILLS", "SKILL_PAYLOADS", "in_order", "skill_named"]

_ORDER: Final = (
    "CallElevator",
    "UseElevator",
    "TakeStairs",
    "GoToLandmark",
    "MoveTo",
    "GoNearObject",
    "MoveAhead",
    "Rotate",
    "LookUp",
    "LookDown",
    "OpenDoor",
    "CloseDoor",
    "OpenObject",
    "CloseObject",
    "PickUp",
    "Place",
    "ToggleOn",
    "ToggleOff",
    "WhereAmI",
    "ListLandmarks",
    "ListVisible",
    "PlanRoute",
)


def in_order(skills: Iterable[Skill], first: tuple[str, ...]) -> list[Skill]:
    """Return skills in an order that is published: those that it names, then all others by name.

    Tables, prompts and the actions of trained policies depend on positions, so what is new goes to the end.
    """
    rank = {name: place for place, name in enumerate(first)}
    return sorted(skills, key=lambda skill: (rank.get(skill.name, len(first)), skill.name))


def _modules() -> Iterator[ModuleType]:
    for entry in pkgutil.iter_modules(folder.__path__, f"{folder.__name__}."):
        if entry.name != __name__:
            yield import_module(entry.name)


def _declared() -> Iterator[Skill]:
    for module in _modules():
        yield from (
            value
            for value in vars(module).values()
            if isinstance(value, Skill) and value.call.__module__ == module.__name__
        )


SKILLS: Final[Mapping[str, Skill]] = {skill.service: skill for skill in in_order(_declared(), _ORDER)}
"""Service name below ``skills/`` to skill."""

SKILL_PAYLOADS: Final[Mapping[str, type[msgspec.Struct]]] = {
    kind.__name__: kind for skill in SKILLS.values() for kind in (skill.arguments, skill.reply)
}
"""The payload types of arguments and replies by name."""

_BY_NAME: Final[Mapping[str, Skill]] = {**{skill.name.casefold(): skill for skill in SKILLS.values()}, **SKILLS}


def skill_named(name: str) -> Skill | None:
    """Return the skill of that name, ``CallElevator`` or ``call_elevator``, or ``None``."""
    return _BY_NAME.get(name) or _BY_NAME.get(name.casefold())
