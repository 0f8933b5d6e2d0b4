"""Things and places: the words of a clause as a thing and where it is in a building."""

import re
from dataclasses import dataclass, replace
from typing import Final

from mansion_editing.agent.facts import Scope, Thing
from mansion_editing.agent.things import MOST_THINGS, ThingWords, is_known, known_noun, read_thing, unknown, untold
from mansion_editing.references import find_floor, find_rooms
from mansion_editing.state import SceneState
from mansion_editing.vocabulary import COLOUR_WORDS, stems

__all__ = ["MOST_THINGS", "Phrase", "read_phrase", "read_place", "rooms_named"]

_PREPOSITIONS: Final = (
    r"\b(next to|inside of|inside|into|in|within|onto|on|under|underneath|below|at|by|off|"
    r"out of|from|to|for)\b"
)
_ID: Final = re.compile(r"\b[fF]-?\d+/[A-Za-z0-9_./-]+")
_EACH: Final = re.compile(
    r"^(?:the )?(?:each|every|both|all|either)(?: (?:single|one))?(?: of)?(?: the)?(?: (?:two|three|four|five|"
    r"six|\d+))?\b",
    re.IGNORECASE,
)
_EACH_FLOOR: Final = re.compile(
    r"\b(?:on |of |in )?(?:each|every|both|all)(?: of)?(?: the)?(?: \w+)? (?:floors?|storeys?|stories|levels?)\b",
    re.IGNORECASE,
)
_PRONOUNS: Final = frozenset(["it", "them", "there", "this", "that", "these", "those", "here"])
_PARTS: Final = frozenset(["floor", "ground", "building", "door", "top", "surface", "table top", "area", "place"])


@dataclass(frozen=True)
class Phrase:
    """A thing and where it is said to be.

    Attributes
    ----------
    placed : bool
        The words name a place at all.
    each : {"", "receptacle", "room", "floor"}
        What of the place is meant each for itself.
    back : bool
        The place is what was spoken of before (on it, there).
    exact, more, most
        See `ThingWords`.
    """

    thing: Thing
    where: Scope
    placed: bool
    each: str = ""
    back: bool = False
    exact: bool = False
    more: bool = False
    most: bool = False


def read_place(state: SceneState, text: str) -> Phrase:
    """Read ``on the desk in the meeting room on the third floor``.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for words that name nothing.
    """
    return read_phrase(state, f"things {text}")


def read_phrase(state: SceneState, text: str) -> Phrase:
    """Read ``two red mugs on the desk in the meeting room on the third floor``.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for words that name nothing, ``INFEASIBLE`` for too many copies.
    """
    each = "floor" if _EACH_FLOOR.search(text) else ""
    text = " ".join(_EACH_FLOOR.sub(" ", text).split())
    floor, rest = find_floor(state, text)
    rest = re.sub(r"^((?:(?:things|on|in|at|the)\s+)*)'s ", r"\1", rest)
    pieces = re.split(_PREPOSITIONS, rest, flags=re.IGNORECASE)
    said = read_thing(state, _room_first(state, pieces[0]))
    reader = _PlaceReader(state, floor, text)
    for preposition, words in zip(pieces[1::2], pieces[2::2], strict=False):
        if words.strip(" ,.").lower() in COLOUR_WORDS:
            colour = COLOUR_WORDS[words.strip(" ,.").lower()]
            said = replace(said, thing=replace(said.thing, colour=colour))
            continue
        reader.take(preposition.lower(), words)
    return reader.phrase(said, each)


def _room_first(state: SceneState, text: str) -> str:
    """Say ``the kitchen 's mug`` as ``the kitchen mug``."""
    return re.sub(r" 's\b", "", text)


class _PlaceReader:
    """Takes a place's parts one after the other: receptacle, neighbour, room."""

    def __init__(self, state: SceneState, floor: int | None, text: str) -> None:
        self.state, self.floor = state, floor
        self.ids = {match.group().lower(): match.group() for match in _ID.finditer(text)}
        self.relation, self.receptacle, self.colour, self.near = "room", "", "", ""
        self.base = ""
        self.rooms: tuple[str, ...] | None = None
        self.each = ""
        self.back = False

    def take(self, preposition: str, words: str) -> None:
        """Take ``in the meeting room`` or ``on the desk``."""
        quantified = _EACH.match(words.strip())
        name = _bare(_EACH.sub("", words.strip()) if quantified else words)
        if not name:
            self.back = self.back or bool(quantified)
            return
        if name.lower() in _PRONOUNS:
            self.back = True
            self.relation = "in" if preposition.startswith(("in", "with")) else "on"
            return
        name = self._owner(name)
        if name.lower() in _PARTS:
            return
        each = bool(quantified)
        found = None if self.rooms is not None else rooms_named(self.state, name, self.floor, each)
        if found and preposition not in ("next to", "under", "underneath", "below", "by"):
            self.rooms = found
            self.each = "room" if quantified else self.each
            return
        exact = self.state.vocabulary.exact(stems(name))
        if self.rooms is not None and not exact and find_rooms(self.state, name, self.floor):
            raise unknown(name)
        if preposition in ("next to", "under", "underneath", "below", "by"):
            self.near = self._thing(name)[1]
        elif not self.receptacle:
            self.colour, self.receptacle = self._thing(name)
            inward = preposition in ("in", "inside", "into", "within", "inside of", "out of")
            self.relation = "in" if inward else "on"
            self.each = "receptacle" if quantified else self.each
        elif not self.base:
            self.base = self._thing(name)[1]
        else:
            raise unknown(name)

    def _owner(self, name: str) -> str:
        """Split ``table of the break room`` and ``break room 's table`` where one part is a room."""
        head, mark, tail = name.partition(" of ")
        if not mark:
            tail, mark, head = name.partition(" 's ")
        if not mark:
            return name
        rooms = rooms_named(self.state, _bare(tail), self.floor)
        if rooms and self.rooms is None:
            self.rooms = rooms
            return _bare(head)
        return _bare(tail) if _bare(head).lower() in _PARTS else name.replace(" 's ", " ")

    def _thing(self, name: str) -> tuple[str, str]:
        """Return the colour and the noun of a receptacle; a room's name before it narrows the place."""
        whole = self.ids.get(name.lower(), name)
        upper = whole[0].upper() + whole[1:]
        if self.state.find(upper) is not None:
            return "", upper
        if "/" in whole or re.search(r"_\d+$", whole):
            return "", whole
        words = re.findall(r"[a-z0-9'\-]+", name.lower())
        colour = next((COLOUR_WORDS[w] for w in words[:-1] if w in COLOUR_WORDS), "")
        plain = [w for w in words if w not in COLOUR_WORDS or w == words[-1]]
        before, noun = known_noun(self.state, plain)
        self._narrow(" ".join(before), noun)
        return colour, noun

    def _narrow(self, words: str, noun: str) -> None:
        """Take words before a noun: a room's name, else what all such things are."""
        if not words:
            return
        found = rooms_named(self.state, words, self.floor)
        if found and self.rooms is None:
            self.rooms = found
        fault = None if found else untold(self.state, words, noun)
        if fault is not None:
            raise fault

    def phrase(self, said: ThingWords, each: str) -> Phrase:
        """Return the thing in the place that was read."""
        self._narrow(said.before, said.thing.noun)
        relation = self.relation if self.receptacle or self.back else "room"
        where = Scope(
            relation,  # type: ignore[arg-type]
            self.receptacle,
            self.rooms or (),
            self.floor,
            self.colour,
            self.near,
            self.base,
        )
        placed = bool(where.receptacle or where.rooms or where.near or self.floor is not None)
        return Phrase(
            said.thing,
            where,
            placed or self.back or bool(each),
            each or self.each,
            self.back,
            said.exact,
            said.more,
            said.most,
        )


def _bare(words: str) -> str:
    """Drop articles and punctuation around a noun."""
    out = re.sub(
        r"^[\s,]*(?:(?:the|a|an|any|all|every|each|one|its|my|our|your|their|of|same)\s+)*",
        "",
        words.strip(),
        flags=re.I,
    )
    return out.strip(" ,.;!?\"'")


def rooms_named(state: SceneState, name: str, floor: int | None, every: bool = False) -> tuple[str, ...] | None:
    """Return the rooms that a name means, None for none; a thing of that name goes before a part of a room's.

    Parameters
    ----------
    every : bool
        All rooms of the kind, not only those that the name fits best.
    """
    if not name:
        return None
    whole = state.room(name[0].upper() + name[1:])
    if whole is not None:
        return (whole[1].id,)
    found = [room.id for _, room in find_rooms(state, name, floor, every=every)]
    if not found:
        return None
    exact = any(
        name.replace(" ", "_").lower() in (room.room_type, room.id.split("/", 1)[-1])
        for number in state.floors
        for room in state.scenes[number].rooms
        if room.id in found
    )
    if not exact and not re.search(r"room|office|\d$", name.lower()) and is_known(state, name):
        return None
    return tuple(found)
