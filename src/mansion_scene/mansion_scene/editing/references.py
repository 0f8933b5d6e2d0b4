"""What a user's words mean in a building: objects by id or keyword, rooms by id or by name and floor."""

import re
from collections.abc import Sequence

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneCore, SceneObject, SceneRoom
from mansion_scene.editing.state import SceneState
from mansion_scene.editing.vocabulary import stems

__all__ = ["find_floor", "find_rooms", "matching_objects", "object_named", "place_named"]

_ORDINALS = [
    "first",
    "second",
    "third",
    "fourth",
    "fifth",
    "sixth",
    "seventh",
    "eighth",
    "ninth",
    "tenth",
    "eleventh",
    "twelfth",
]
_TO = r"\b(?:on |at |of |from |to |in )?(?:the )?"
_FLOOR_WORDS = r"(?:floor|storey|story|level)"


def find_floor(state: SceneState, text: str) -> tuple[int | None, str]:
    """Return the floor that a text names, if any, and the text without it.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a floor that the building lacks.

    Notes
    -----
    Ordinals count from the entrance floor: the second floor is number 2; the ground floor is 1.
    """
    low = text.lower()
    ordinal = "|".join(_ORDINALS)
    patterns = (
        rf"{_TO}(?:{_FLOOR_WORDS} )?(?P<word>{ordinal}|ground|top|\d+(?:st|nd|rd|th)) {_FLOOR_WORDS}\b",
        rf"{_TO}{_FLOOR_WORDS} (?P<word>-?\d+|{'|'.join(_NUMBERS)})\b",
        rf"\b(?:on|at) the (?P<word>{ordinal}|\d+(?:st|nd|rd|th))\b",
        rf"{_TO}(?P<word>basement)\b",
    )
    for pattern in patterns:
        match = re.search(pattern, low)
        if match:
            floor = _floor_number(state, match["word"])
            rest = f"{text[: match.start()]} {text[match.end() :]}"
            return floor, " ".join(rest.split())
    return None, text


_NUMBERS = [
    "one",
    "two",
    "three",
    "four",
    "five",
    "six",
    "seven",
    "eight",
    "nine",
    "ten",
    "eleven",
    "twelve",
]


def _floor_number(state: SceneState, word: str) -> int:
    digits = re.match(r"-?\d+", word)
    if digits:
        number = int(digits.group()) if len(digits.group()) < 6 else 10**6
    elif word in _ORDINALS:
        number = _ORDINALS.index(word) + 1
    elif word in _NUMBERS:
        number = _NUMBERS.index(word) + 1
    else:
        number = {"ground": 1, "top": state.floors[-1], "basement": 0}[word]
    if number not in state.scenes:
        raise MansionError(
            ErrorCode.NOT_FOUND,
            f"there is no floor {word}; the building has floors {', '.join(map(str, state.floors))}",
            details={"floors": state.floors},
        )
    return number


def find_rooms(
    state: SceneState, text: str, on_floor: int | None = None
) -> list[tuple[int, SceneRoom]]:
    """Return the rooms that a text names, the best fits only: by id, by the end of it, or by words and floor.

    Parameters
    ----------
    on_floor : int, optional
        The floor, where the text does not name one.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a floor that is not there.
    """
    whole = state.room(text)
    if whole is not None:
        return [whole]
    floor, rest = find_floor(state, text)
    floor = on_floor if floor is None else floor
    rooms = [
        (number, room)
        for number in state.floors
        if floor in (None, number)
        for room in state.scenes[number].rooms
        if room.kind not in ("stair", "elevator")
    ]
    ends = [pair for pair in rooms if pair[1].id.split("/", 1)[-1] == rest.strip().lower()]
    if ends:
        return ends
    words = tuple(w for w in stems(rest) if w != "room") or stems(rest)
    if not words:
        return rooms if floor is not None else []
    ranked = [(_room_rank(room, words, stems(rest)), pair) for pair in rooms for room in [pair[1]]]
    best = max((rank for rank, _ in ranked), default=0)
    return [pair for rank, pair in ranked if rank == best and rank > 0]


def _room_rank(room: SceneRoom, words: tuple[str, ...], whole: tuple[str, ...]) -> int:
    own = stems(room.id.split("/", 1)[-1].replace("_", " "))
    kind = stems(room.room_type.replace("_", " "))
    named = stems(room.name)
    if whole == own or (named and whole == named):
        return 4
    if whole == kind:
        return 3
    if words == tuple(w for w in kind if w != "room"):
        return 2
    return 1 if set(words) <= {*own, *kind, *named} else 0


def matching_objects(
    state: SceneState, keyword: str, rooms: Sequence[str] | None = None, floor: int | None = None
) -> list[tuple[int, SceneObject]]:
    """Return the objects that a keyword or id names, the best fits first.

    Parameters
    ----------
    rooms : sequence of str, optional
        Only in these rooms.
    """
    whole = state.find(keyword)
    if whole is not None:
        return [whole]
    words = state.vocabulary
    ranked: list[tuple[int, int, tuple[int, SceneObject]]] = []
    memory: dict[tuple[str, str], int] = {}
    for number, (its_floor, item) in enumerate(state.objects()):
        if (rooms is not None and item.room not in rooms) or floor not in (None, its_floor):
            continue
        if "/" in keyword or "_" in keyword:
            rank = 4 if item.id.endswith(f"/{keyword}") else 0
        else:
            rank = 0
        if not rank:
            key = (item.category, item.name)
            if key not in memory:
                memory[key] = words.rank(item, keyword.replace("_", " "))
            rank = memory[key]
        if rank:
            ranked.append((-rank, number, (its_floor, item)))
    ranked.sort(key=lambda entry: entry[:2])
    if ranked and ranked[0][0] < -1:
        ranked = [entry for entry in ranked if entry[0] < -1]
    return [pair for _, _, pair in ranked]


def object_named(state: SceneState, reference: str, path: str) -> tuple[int, SceneObject]:
    """Return the one object that an id, the end of an id, or a keyword names.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for none, ``CONFLICT`` for several of a keyword, with ids to choose from.
    """
    whole = state.find(reference)
    if whole is not None:
        return whole
    found = matching_objects(state, reference) if reference else []
    if not found:
        return state.get(reference, path)
    if len(found) > 1:
        some = [item.id for _, item in found[:6]]
        raise MansionError(
            ErrorCode.CONFLICT,
            f"{reference[:120]!r} names {len(found)} objects; give an id: {', '.join(some)}"
            + (", ..." if len(found) > 6 else ""),
            path=path,
            details={"candidates": some},
        )
    return found[0]


def place_named(state: SceneState, reference: str, path: str) -> tuple[int, str]:
    """Return floor and id of the room or core that a reference names; an object stands for its room.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for none, ``CONFLICT`` for rooms that cannot be told apart.
    """
    core = _core(state, reference)
    if core is not None:
        return core
    rooms = find_rooms(state, reference)
    if len(rooms) == 1:
        return rooms[0][0], rooms[0][1].id
    if not rooms:
        found = state.find(reference) or next(iter(matching_objects(state, reference)), None)
        if found is not None:
            return found[0], found[1].room
        known = [room.id for scene in state.scenes.values() for room in scene.rooms]
        raise MansionError(
            ErrorCode.NOT_FOUND,
            f"no room {reference[:120]!r}; rooms are {', '.join(known[:40])}",
            path=path,
            details={"rooms": known},
        )
    some = [room.id for _, room in rooms[:8]]
    raise MansionError(
        ErrorCode.CONFLICT,
        f"{reference[:120]!r} names {len(rooms)} rooms; give an id: {', '.join(some)}",
        path=path,
        details={"candidates": some},
    )


def _core(state: SceneState, reference: str) -> tuple[int, str] | None:
    floor, rest = find_floor(state, reference)
    names = {"elevator": "elevator", "lift": "elevator", "stairs": "stair", "stair": "stair"}
    wanted = rest.strip().lower().removeprefix("the ")
    cores: list[tuple[int, SceneCore]] = [
        (number, core)
        for number in state.floors
        if floor in (None, number)
        for core in state.scenes[number].cores
    ]
    for number, core in cores:
        if core.id == wanted or core.type == names.get(wanted):
            return number, core.id
    return None
