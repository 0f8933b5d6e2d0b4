"""Scopes put together, and the ways to divide the words of a move."""

import re
from collections.abc import Iterator
from dataclasses import replace
from typing import Final

from mansion_editing.agent.facts import Scope, Thing
from mansion_editing.agent.phrases import Phrase, read_phrase, read_place
from mansion_editing.state import SceneState
from mansion_msgs_py.errors import MansionError

__all__ = ["merged", "moved", "on_that_of", "parted"]

_TO: Final = (
    r"^(?P<what>.+?)(?: from (?P<source>.+?))? (?:over |back |up |down |upstairs |downstairs )?"
    r"(?P<to>to|into|onto) (?P<target>.+)$",
    r"^(?P<what>.+?) from (?P<source>.+?) => (?P<to>on|in|inside) "
    r"(?P<target>(?!(?:the )?(?:\w+ )?(?:floor|storey|level)\b).+)$",
)


def _divisions(text: str) -> Iterator[re.Match[str]]:
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


def parted(state: SceneState, text: str) -> tuple[Phrase, Phrase] | None:
    """Return what moves from where, and where to; the first division of the words that can be read, None without any.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when a division names something unknown and no other can be read.
    """
    fault: MansionError | None = None
    for match in _divisions(text):
        source = f" on {match['source']}" if match["source"] else ""
        inward = match["to"].lower() in ("into", "in", "inside")
        try:
            what = read_phrase(state, match["what"] + source)
            goal = read_place(state, f"{'in' if inward else 'on'} {match['target']}")
        except MansionError as error:
            fault = fault or error
            continue
        if goal.where.receptacle or goal.where.rooms or goal.back:
            return what, goal
    if fault is not None:
        raise fault
    return None


def moved(thing: Thing) -> Thing:
    """Return a thing to move: all of them where all are meant, else one."""
    return replace(thing, count=0 if thing.every and not thing.count else max(1, thing.count))


def on_that_of(own: Scope, other: Scope) -> Scope:
    """Return a place with the receptacle of another."""
    return replace(own, relation=other.relation, receptacle=other.receptacle, colour=other.colour, base=other.base)


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
