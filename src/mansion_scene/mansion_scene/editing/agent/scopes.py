"""Scopes put together, and the ways to divide the words of a move."""

import re
from collections.abc import Iterator
from dataclasses import replace
from typing import Final

from mansion_scene.editing.agent.facts import Scope, Thing

__all__ = ["divisions", "merged", "moved", "on_that_of"]

_TO: Final = (
    r"^(?P<what>.+?)(?: from (?P<source>.+?))? (?:over |back |up |down |upstairs |downstairs )?"
    r"(?P<to>to|into|onto) (?P<target>.+)$",
    r"^(?P<what>.+?) from (?P<source>.+?) => (?P<to>on|in|inside) "
    r"(?P<target>(?!(?:the )?(?:\w+ )?(?:floor|storey|level)\b).+)$",
)


def divisions(text: str) -> Iterator[re.Match[str]]:
    """Yield the ways to divide words into a thing, its source and its target, the plain ones first."""
    plain = re.match(_TO[0], text, re.IGNORECASE)
    if plain:
        yield plain
    for joint in re.finditer(r" (?:on|in|inside) ", text, re.IGNORECASE):
        head, tail = text[: joint.start()], text[joint.start() :]
        if re.search(r" from .+", head, re.IGNORECASE):
            match = re.match(_TO[1], f"{head} =>{tail}", re.IGNORECASE)
            if match:
                yield match


def moved(thing: Thing) -> Thing:
    """Return a thing to move: all of them where all are meant, else one."""
    return replace(thing, count=0 if thing.every and not thing.count else max(1, thing.count))


def on_that_of(own: Scope, other: Scope) -> Scope:
    """Return a place with the receptacle of another."""
    return replace(
        own,
        relation=other.relation,
        receptacle=other.receptacle,
        colour=other.colour,
        base=other.base,
    )


def merged(own: Scope, other: Scope | None) -> Scope:
    """Return a place with what it leaves open taken from another."""
    if other is None:
        return own
    placed = own if own.receptacle else on_that_of(own, other)
    return replace(
        placed,
        rooms=own.rooms or other.rooms,
        floor=other.floor if own.floor is None else own.floor,
        near=own.near or other.near,
    )
