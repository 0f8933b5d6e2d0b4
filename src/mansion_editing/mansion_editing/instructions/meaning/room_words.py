"""Which rooms a name means: by id, by the name that the brief gave, by kind, by another word for the kind."""

import re
from collections.abc import Sequence
from functools import lru_cache

from shapely import Polygon

from mansion_assets.catalogue.vocabulary import stems
from mansion_editing.instructions.phrases.lexicon import READ_LIKE
from mansion_editing.state import SceneState
from mansion_knowledge import default_knowledge, interchangeable_names
from mansion_msgs_py.scene import SceneRoom

__all__ = ["adjoining", "best_named", "room_order", "room_title"]

_SHARED_WALL = 0.3
"""Least length of a wall between two rooms that are next to each other, metres."""

_ANY_ROOM = frozenset({"room", "space", "place", "area", "building", "house", "home", "everywhere", "floor", "storey"})


def best_named(rooms: Sequence[SceneRoom], words: str, *, every: bool = False) -> list[SceneRoom]:
    """Return the rooms that a name fits best, in the order of their ids; all rooms for a word like ``rooms``.

    Parameters
    ----------
    every : bool
        All of the kind: staff kitchens too where kitchens are meant, not only what is called just so.
    """
    ordered = sorted(rooms, key=room_order)
    name, number = _numbered(words)
    whole = [room for room in ordered if room.id.lower() == words.strip().lower()]
    if whole:
        return whole
    if set(stems(name)) <= _ANY_ROOM and number is None:
        return ordered
    ranks = {room.id: _rank(room, name, number) for room in ordered}
    best = max(ranks.values(), default=0)
    if not best:
        return []
    if not every:
        # Where none is called so, "the bedroom" may be the master bedroom as well as a children's bedroom.
        also = [room.id for room in ordered if best == 3 and ranks[room.id] == 2 and _is_called_so(room, name)]
        return [room for room in ordered if ranks[room.id] == best or room.id in also]
    # Other words for a kind mean rooms of it only where none is called so, unless its name ends with them.
    return [
        room
        for room in ordered
        if ranks[room.id] >= min(best, 2) and (best < 4 or ranks[room.id] != 3 or _ends_so(room, name))
    ]


def _is_called_so(room: SceneRoom, name: str) -> bool:
    """Whether the name that people read ends with a name, numbers aside: "Children's bedroom 2" is a bedroom."""
    wanted, called = _read_like(name), _read_like(_numbered(room.name)[0])
    return bool(wanted) and called[-len(wanted) :] == wanted


def _ends_so(room: SceneRoom, name: str) -> bool:
    """Whether the kind of a room ends with a name: a master bedroom is a bedroom."""
    wanted, kind = _read_like(name), stems(room.room_type.replace("_", " "))
    return bool(wanted) and kind[-len(wanted) :] == wanted


def _numbered(words: str) -> tuple[str, str | None]:
    match = re.fullmatch(r"(.*?\S)[\s_]+(?:number |no\.? ?|#)?(\d+)", words.strip(), re.IGNORECASE)
    return (match[1], match[2]) if match else (words, None)


def _rank(room: SceneRoom, name: str, number: str | None) -> int:
    """Return how well a name fits: 7 its own, 6 an alias, 5 its kind, 4 that without "room", 3 a synonym, 2 its end."""
    wanted = _read_like(name)
    called = [_read_like(text) for text in (room.name, room.id.rsplit("/", 1)[-1].replace("_", " ")) if text]
    aliases = [_read_like(alias) for alias in room.aliases]
    own = [*called, *aliases]
    whole = wanted if number is None else (*wanted, number)
    if whole in own:
        return 7 if whole in called else 6
    if number is not None and not re.search(rf"(?:_|\b){number}$", room.id):
        return 0
    kind = stems(room.room_type.replace("_", " "))
    if wanted == ("room",):
        return 1 if any(text[-2:] == ("room", number) for text in called) else 0  # "room 3" is consultation room 3
    if wanted == kind:
        return 5
    bare = tuple(word for word in wanted if word != "room")
    if bare and bare == tuple(word for word in kind if word != "room"):
        return 4
    other = wanted in _names_of_kind(room.room_type)
    if other or _is_synonym(wanted, kind) or any(_is_synonym(wanted, text) for text in own):
        return 3
    if bare and (kind[-len(bare) :] == bare or any(text[-len(bare) :] == bare for text in own)):
        return 2
    said = {*kind, *(word for text in own for word in text)}
    return 1 if bare and set(bare) <= said else 0


def _read_like(text: str) -> tuple[str, ...]:
    """Return the words of a name as instructions are read: without the s of genitives, children for kids."""
    return tuple(READ_LIKE.get(word, word) for word in stems(text) if word != "s")


def _is_synonym(wanted: tuple[str, ...], kind: tuple[str, ...]) -> bool:
    return kind in _names_like(wanted)


@lru_cache(maxsize=4096)
def _names_like(wanted: tuple[str, ...]) -> frozenset[tuple[str, ...]]:
    """Return the names, in stems, that people use for a name in stems."""
    groups = interchangeable_names()
    group = groups.get(" ".join(wanted)) or next((names for name, names in groups.items() if stems(name) == wanted), ())
    return frozenset(stems(name) for name in group)


@lru_cache(maxsize=512)
def _names_of_kind(room_type: str) -> frozenset[tuple[str, ...]]:
    """Return the other names of a kind of room, in stems: an operating theatre is an operating room."""
    entry = default_knowledge().rooms.get(room_type)
    return frozenset() if entry is None else frozenset(stems(name) for name in entry.synonyms)


def room_order(room: SceneRoom) -> tuple[str, ...]:
    """Return a key that puts rooms in the order of their ids, office_2 before office_10."""
    return _numbers_padded(room.id)


@lru_cache(maxsize=4096)
def _numbers_padded(name: str) -> tuple[str, ...]:
    return tuple(part.zfill(6) if part.isdigit() else part for part in re.split(r"(\d+)", name))


def room_title(state: SceneState, room_id: str) -> str:
    """Return what a reply calls a room: its name with its id."""
    found = state.room(room_id)
    if found is None:
        return room_id
    name = found[1].name or found[1].room_type.replace("_", " ")
    return f"the {name.removeprefix('the ')} ({room_id})"


def adjoining(state: SceneState, room_id: str) -> list[str]:
    """Return the rooms that share a door or a stretch of wall with a room."""
    found = state.room(room_id)
    if found is None:
        return []
    floor, room = found
    scene = state.scenes[floor]
    joined = {end for door in scene.doors if room_id in door.rooms for end in door.rooms}
    outline = Polygon(room.polygon).buffer(0.05)
    for other in scene.rooms:
        shape = Polygon(other.polygon)
        if other.id != room_id and outline.intersection(shape.exterior).length > _SHARED_WALL:
            joined.add(other.id)
    return [r.id for r in sorted(scene.rooms, key=room_order) if r.id in joined - {room_id}]
