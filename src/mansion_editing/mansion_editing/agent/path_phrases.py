"""The ends of paths: ``from the lobby to the kitchen``, ``to every office``, ``to the fridge``."""

import re

from mansion_editing.agent.facts import PathFact
from mansion_editing.agent.noun_phrases import read_noun_phrase, rooms_named
from mansion_editing.state import SceneState
from mansion_editing.tools.perception import find_floor, matching_objects, place_named
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["path_facts"]

_ENTRANCE = re.compile(
    r"^(?:(?:main |front |building )?(?:entrance|door)|entry|outside|street|here)(?: door)?(?: of the building)?$",
    re.IGNORECASE,
)
_ALL = re.compile(r"^(?:every|each|all|both|any)\b(?: of)?(?: the)?\s*", re.IGNORECASE)
_ANYWHERE = re.compile(
    r"^(?:|everywhere|anywhere|(?:other )?rooms?|places?|of the rooms?|floors?|(?:the )?(?:whole|entire) building)$",
    re.IGNORECASE,
)


def path_facts(state: SceneState, text: str, start: str = "") -> list[PathFact]:
    """Return the ways that ``from the lobby to the kitchen``, ``to every office`` or ``the fridge from here`` mean.

    Parameters
    ----------
    start : str
        Words for the start, where the text names none.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for words that name no place.
    """
    words = re.sub(r"^(?:around|through|over|up|down|inside)\s+(?=to\b|from\b)", "", text.strip(" ."))
    end = words
    patterns = (
        r"^(?:over |up |down )?(?:to|into|towards|in) (?P<end>.+?) (?:starting )?(?:from|coming from) (?P<start>.+)$",
        r"^from (?P<start>.+?) (?:all the way |over |up |down )?(?:to|into|towards) (?P<end>.+)$",
        r"^(?:over |up |down )?(?:to|into|towards|inside) (?P<end>.+)$",
        r"^(?P<end>.+?) (?:starting )?from (?P<start>.+)$",
        r"^from (?P<start>.+)$",
    )
    for pattern in patterns:
        match = re.match(pattern, words, re.IGNORECASE)
        if match:
            found = match.groupdict()
            start, end = found.get("start") or start, found.get("end") or ""
            break
    first = _place(state, start)
    return [PathFact(first, place) for place in _ends(state, end)]


def _ends(state: SceneState, words: str) -> list[str]:
    bare = words.strip(" ,.;!?\"'")
    whole = _ALL.match(bare)
    if not whole:
        return [_place(state, bare)]
    rest = bare[whole.end() :]
    floor, without = find_floor(state, rest)
    if _ANYWHERE.match(without.strip()) and floor is None:
        return [""]
    if _ANYWHERE.match(without.strip()) and floor is not None:
        return [room.id for number, room in state.rooms() if number == floor]
    rooms = rooms_named(state, without.strip(), floor)
    return list(rooms) if rooms else [_place(state, rest)]


def _place(state: SceneState, words: str) -> str:
    bare = re.sub(r"^(?:(?:the|a|an|any|one of the)\s+)+", "", words.strip(" ,.;!?\"'"), flags=re.I)
    if not bare or _ENTRANCE.match(bare) or _ANYWHERE.match(bare):
        return ""
    if "/" in bare:
        return place_named(state, bare[0].upper() + bare[1:], "$.instruction")[1]
    try:
        floor, name = place_named(state, bare, "$.instruction")
    except MansionError as error:
        if error.code == ErrorCode.CONFLICT:
            return str(error.info.details["candidates"][0])
        return _object_place(state, bare)
    is_core = any(core.id == name for core in state.scenes[floor].cores)
    return bare if is_core else name


def _object_place(state: SceneState, words: str) -> str:
    """Return the object that ``fridge in the kitchen on the second floor`` names, or the room of its place."""
    phrase = read_noun_phrase(state, words)
    where = phrase.where
    rooms = list(where.rooms) or None
    for noun in (phrase.object.noun, where.receptacle):
        found = matching_objects(state, noun, rooms, where.floor) if noun else []
        if found:
            return found[0][1].id
    if where.rooms:
        return where.rooms[0]
    raise MansionError(ErrorCode.NOT_FOUND, f"there is no {words[:80]} to go to")
