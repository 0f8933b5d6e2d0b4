"""Noun phrases and places: the words of a clause as things and scopes of a building."""

import re
from dataclasses import dataclass
from typing import Final

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_scene.editing.agent.facts import Relation, Scope, Thing
from mansion_scene.editing.references import find_floor, find_rooms
from mansion_scene.editing.state import SceneState
from mansion_scene.editing.vocabulary import COLOUR_WORDS

__all__ = ["MOST_THINGS", "Phrase", "read_phrase", "read_thing", "unknown"]

MOST_THINGS: Final = 20
"""Most copies of one thing that an instruction may ask for."""

_NUMBERS: Final = {
    **{
        word: number
        for number, word in enumerate(
            ["one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"], start=1
        )
    },
    "a": 1, "an": 1, "some": 1, "another": 1, "single": 1, "couple": 2, "pair": 2, "several": 3,
}  # fmt: skip
_EVERY: Final = frozenset(["the", "all", "every", "each", "any", "everything"])
_COLD: Final = frozenset(["cold", "chilled", "cool", "refrigerated"])
_IDLE: Final = frozenset(
    [
        "fresh",
        "clean",
        "new",
        "small",
        "large",
        "big",
        "nice",
        "full",
        "empty",
        "least",
        "at",
        "please",
        "more",
        "exactly",
        "of",
        "these",
        "those",
        "that",
        "this",
    ]
)
_PREPOSITIONS: Final = r"\b(on top of|onto|on|inside of|inside|into|in|within|at)\b"
_ID: Final = re.compile(r"\b[fF]-?\d+/[A-Za-z0-9_./-]+")


@dataclass(frozen=True)
class Phrase:
    """A thing and where it is said to be; `placed` when the words name a place at all."""

    thing: Thing
    where: Scope
    placed: bool


def unknown(what: str) -> MansionError:
    """Return the error for words that name nothing here."""
    return MansionError(
        ErrorCode.NOT_FOUND,
        f"{what[:80]!r} names no room of this building and nothing that the catalogue knows",
        details={"words": what[:200]},
    )


def read_phrase(state: SceneState, text: str) -> Phrase:
    """Read ``two red mugs on the desk in the meeting room on the third floor``.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for words that name nothing, ``INFEASIBLE`` for too many copies.
    """
    ids = {match.group().lower(): match.group() for match in _ID.finditer(text)}
    floor, rest = find_floor(state, text)
    pieces = re.split(_PREPOSITIONS, rest, flags=re.IGNORECASE)
    thing = read_thing(state, pieces[0])
    relation: Relation = "room"
    receptacle, rooms = "", None
    for preposition, words in zip(pieces[1::2], pieces[2::2], strict=False):
        name = _bare(words)
        if not name:
            continue
        name, inner = _of(state, name, floor)
        if inner is not None:
            rooms = inner
        found = (
            None
            if rooms is not None and not receptacle and inner is None
            else _rooms(state, name, floor)
        )
        if found and not (receptacle and rooms is not None):
            rooms = found
        elif not receptacle:
            receptacle = _receptacle(state, ids.get(name.lower(), name))
            inward = preposition.lower() in ("in", "inside", "into", "within", "inside of")
            relation = "in" if inward else "on"
        else:
            raise unknown(name)
    placed = bool(receptacle or rooms or floor is not None)
    return Phrase(thing, Scope(relation, receptacle, rooms or (), floor), placed)


def _bare(words: str) -> str:
    """Drop articles and punctuation around a noun."""
    out = re.sub(
        r"^[\s,]*(?:(?:the|a|an|any|all|every|each|its|my|our)\s+)*", "", words.strip(), flags=re.I
    )
    return out.strip(" ,.;!?\"'")


def _of(state: SceneState, name: str, floor: int | None) -> tuple[str, tuple[str, ...] | None]:
    """Split ``table of the break room`` where the end is a room."""
    head, mark, tail = name.partition(" of ")
    if mark:
        rooms = _rooms(state, _bare(tail), floor)
        if rooms:
            return _bare(head), rooms
    return name, None


def _rooms(state: SceneState, name: str, floor: int | None) -> tuple[str, ...] | None:
    """Return the rooms that a name means, None for none; a thing of that name goes before a part of a room's."""
    upper = name[0].upper() + name[1:] if name else name
    whole = state.room(upper)
    if whole is not None:
        return (whole[1].id,)
    found = [room.id for _, room in find_rooms(state, name, floor)]
    if not found:
        return None
    exact = any(
        name.replace(" ", "_").lower() in (room.room_type, room.id.split("/", 1)[-1])
        for number in state.floors
        for room in state.scenes[number].rooms
        if room.id in found
    )
    if not exact and "room" not in name.lower() and _known(state, name):
        return None
    return tuple(found)


def _known(state: SceneState, noun: str) -> bool:
    words = state.vocabulary
    snake = noun.lower().replace(" ", "_")
    if snake in state.catalogue.room_types and snake not in words.categories:
        return False
    return state.find(noun) is not None or bool(words.nouns(noun))


def _receptacle(state: SceneState, name: str) -> str:
    upper = name[0].upper() + name[1:]
    if state.find(upper) is not None:
        return upper
    if "/" in name or re.search(r"_\d+$", name) or _known(state, name):
        return name
    raise unknown(name)


def _object_id(state: SceneState, name: str) -> str:
    """Return an id that is or may have been an object's."""
    for floor in state.floors:
        scene = state.scenes[floor]
        fixed = [wall.id for wall in scene.walls] + [door.id for door in scene.doors]
        fixed += [window.id for window in scene.windows] + [room.id for room in scene.rooms]
        for part in (*fixed, *(core.id for core in scene.cores)):
            if part == name:
                raise MansionError(
                    ErrorCode.INFEASIBLE,
                    f"{name} is part of the building itself; the editor changes objects alone",
                )
    if state.room(name.rsplit("/", 1)[0]) is None:
        raise unknown(name)
    return name


def read_thing(state: SceneState, text: str) -> Thing:
    """Read a noun with number, colour and coldness.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown noun, ``INFEASIBLE`` for more copies than allowed.
    """
    bare = text.strip(" ,.;!?\"'")
    if "/" in bare:
        name = bare.split()[-1]
        return Thing(_object_id(state, name[0].upper() + name[1:]), 0)
    count, colour, cold = 0, "", False
    words = bare.lower().split()
    kept: list[str] = []
    for word in words:
        if not kept and (word in _NUMBERS or word.isdecimal()):
            count = int(word[:9]) if word.isdecimal() else _NUMBERS[word]
        elif word in _COLD:
            cold = True
        elif word in COLOUR_WORDS and word != words[-1]:
            colour = COLOUR_WORDS[word]
        elif (word not in _IDLE and (kept or word not in _EVERY)) or (word == "of" and kept):
            kept.append(word)
    if count > MOST_THINGS:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"the instruction asks for {count} of one thing; at most {MOST_THINGS} can be provided",
        )
    noun = " ".join(kept)
    if noun and noun not in ("thing", "things", "object", "objects", "stuff", "items", "item"):
        if not _known(state, noun):
            raise unknown(noun)
        return Thing(noun, count, colour, cold)
    return Thing("", count, colour, cold)
