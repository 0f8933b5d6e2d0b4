"""Instructions in natural language: varied, and saying no more and no less than the goals."""

from typing import Final

import numpy as np

from mansion_msgs_py.task import Need
from mansion_skills.world.building import LoadedBuilding
from mansion_tasks.tasks.needs import describe
from mansion_tasks.words.nouns import is_plural, plain

__all__ = ["BRING", "FIND", "OPEN_AND_PUT", "PUT_ON", "THEN_CLOSE", "instruction"]

BRING: Final = (
    "Find {thing} and bring {it} to {place}.",
    "Go to where {thing} is, take {it} to {place} and put {it} down there.",
    "Go and get {thing}, then leave {it} in {place}.",
    "Fetch {thing}. Please deliver {it} to {place}.",
    "Somebody needs {thing}. Bring {it} to {place}.",
)
PUT_ON: Final = (
    "Find {thing} and put {it} on {place}.",
    "Get {thing}, then place {it} on {place}.",
    "Please fetch {thing} and leave {it} on {place}.",
    "Take {thing}. Carry {it} away and set {it} down on {place}.",
)
FIND: Final = (
    "Find {thing} and go up to {it}.",
    "Look for {thing} and stop beside {it}.",
    "Search for {thing} and stop in front of {it}.",
    "Locate {thing}; you are done when you see {it} and stand next to {it}.",
)
OPEN_AND_PUT: Final = (
    "Find {thing}, open {place} and put {it} inside.",
    "Get {thing}; open {place}, then put {it} in there.",
    "Take {thing} and put {it} into {place}, which you have to open first.",
)
THEN_CLOSE: Final = (
    "Find {thing}, open {place}, put {it} inside and close it again.",
    "Take {thing} and put {it} into {place}; make sure that it is closed afterwards.",
    "Get {thing}, put {it} inside {place}, then close that.",
)


def instruction(
    forms: tuple[str, ...], thing: Need, place: Need | None, building: LoadedBuilding, rng: np.random.Generator
) -> str:
    """Return one of some forms, filled with what a thing and a place are called in a building."""
    form = forms[int(rng.integers(len(forms)))]
    there = "" if place is None else describe(place, building)
    pronoun = "them" if is_plural(plain(thing.noun)) else "it"
    text = form.format(thing=describe(thing, building), place=there, it=pronoun)
    return text[:1].upper() + text[1:]
