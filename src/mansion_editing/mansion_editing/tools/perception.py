"""Questions to the static state: SearchAssets, ListObjects, CheckSurface, SearchContents; what words refer to."""

import math
import re
from collections.abc import Callable, Sequence

import numpy as np
import numpy.typing as npt

from mansion_assets.catalogue import Asset
from mansion_assets.catalogue.vocabulary import stems, vocabulary_of
from mansion_editing.state import FloorIndex, SceneState
from mansion_knowledge import interchangeable_names
from mansion_language.core_words import CORE_WORDS
from mansion_language.numbers import CARDINALS, ORDINALS, SOFT_NUMBERS
from mansion_msgs_py.editing.questions import (
    AssetHits,
    AssetInfo,
    CheckSurfaceArgs,
    ListObjectsArgs,
    ObjectInfo,
    ObjectList,
    ReceptacleContents,
    ReceptacleReport,
    SearchAssetsArgs,
    SearchContentsArgs,
)
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneCore, SceneObject, SceneRoom
from mansion_scene.decor.frames import to_local

__all__ = [
    "check_surface",
    "contents",
    "find_floor",
    "find_rooms",
    "list_objects",
    "matching_objects",
    "object_named",
    "on_top",
    "place_named",
    "search_assets",
    "search_contents",
]

MOST_RECEPTACLES = 20
_PROPERTIES = ("pickupable", "receptacle", "openable", "toggleable")


def search_assets(state: SceneState, args: SearchAssetsArgs) -> AssetHits:
    """Retrieve assets by words, with the state's retriever.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for an unknown property.
    """
    found = state.retriever.retrieve(state.catalogue, args.query, args.top_k, args.properties)
    assets = [
        AssetInfo(
            asset_id=hit.asset.key,
            category=hit.asset.category,
            name=hit.asset.name,
            size=hit.asset.size,
            score=hit.score,
            material=hit.asset.material,
            properties=_properties(hit.asset, None),
        )
        for hit in found.hits
    ]
    names = ", ".join(asset.asset_id for asset in assets) or f"nothing fits {args.query!r}"
    return AssetHits(message=names + (f" ({found.note})" if found.note else ""), assets=assets)


def list_objects(state: SceneState, args: ListObjectsArgs) -> ObjectList:
    """List the objects of the building, or those of a room, or those that a keyword or an id names.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a room that is not there.
    """
    rooms = None
    if args.room:
        found = find_rooms(state, args.room)
        if not found:
            raise MansionError(ErrorCode.NOT_FOUND, f"no room {args.room[:120]!r}", path="$.room")
        rooms = sorted({room.id for _, room in found})
    wanted = args.id or args.keyword
    if wanted:
        pairs = matching_objects(state, wanted, rooms)
    else:
        pairs = [p for p in state.objects() if rooms is None or p[1].room in rooms]
    shown = [object_info(state, floor, item) for floor, item in pairs[: args.limit]]
    return ObjectList(message=_count(len(pairs), "object"), total=len(pairs), objects=shown)


def check_surface(state: SceneState, args: CheckSurfaceArgs) -> ReceptacleReport:
    """List what rests on the receptacles that a keyword or an id names.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when nothing fits.
    """
    return _report(state, args.id or args.keyword, on_top, "on")


def search_contents(state: SceneState, args: SearchContentsArgs) -> ReceptacleReport:
    """List what lies in the containers that a keyword or an id names.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when nothing fits.
    """
    return _report(state, args.id or args.keyword, contents, "in")


def _report(
    state: SceneState,
    reference: str,
    find: Callable[[FloorIndex, SceneObject, Asset | None], list[SceneObject]],
    relation: str,
) -> ReceptacleReport:
    if not reference:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "give a keyword or an id", path="$.keyword")
    found = matching_objects(state, reference)
    if not found:
        state.get(reference, "$.keyword")
    entries = []
    for floor, receptacle in found[:MOST_RECEPTACLES]:
        children = find(state.index(floor), receptacle, state.asset(receptacle))
        entries.append(
            ReceptacleContents(
                receptacle=object_info(state, floor, receptacle),
                objects=[object_info(state, floor, child) for child in children],
            )
        )
    parts = [
        f"{relation} {entry.receptacle.id}: "
        + (", ".join(child.id.rsplit("/", 1)[-1] for child in entry.objects) or "nothing")
        for entry in entries
    ]
    if len(found) > MOST_RECEPTACLES:
        parts.append(f"and {len(found) - MOST_RECEPTACLES} more receptacles; give an id")
    return ReceptacleReport(message="; ".join(parts), receptacles=entries)


def object_info(state: SceneState, floor: int, item: SceneObject) -> ObjectInfo:
    """Return a tool's description of an object, with the properties of its asset in the catalogue."""
    return ObjectInfo(
        id=item.id,
        category=item.category,
        name=item.name,
        asset_id=item.asset,
        floor=floor,
        room=item.room,
        position=item.position,
        mount=item.mount,
        parent=item.parent,
        color=item.color,
        properties=_properties(state.asset(item), item),
        states=item.states,
    )


def _properties(asset: Asset | None, item: SceneObject | None) -> list[str]:
    return [name for name in _PROPERTIES if getattr(asset, name, False) or (item is not None and getattr(item, name))]


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"


REST = 0.05
"""Greatest distance between a surface and the foot of what rests on it, metres."""

LOW = 0.02
"""Furniture lower than this stands on the floor, metres."""

EDGE = 0.01
"""Slack of footprints, metres."""

Column = npt.NDArray[np.intp]
"""Numbers of the objects whose centre lies over a receptacle."""


def within_plan(index: FloorIndex, receptacle: SceneObject) -> Column:
    """Return the objects whose centroid lies within the receptacle's rectangle, seen from above; itself left out."""
    boxes = index.boxes
    angle = math.radians(-receptacle.rotation)
    dx = boxes[:, 0] - receptacle.position[0]
    dy = boxes[:, 1] - receptacle.position[1]
    u = math.cos(angle) * dx - math.sin(angle) * dy
    v = math.sin(angle) * dx + math.cos(angle) * dy
    inside = (np.abs(u) <= receptacle.size[0] / 2 + EDGE) & (np.abs(v) <= receptacle.size[1] / 2 + EDGE)
    own = index.at.get(receptacle.id, -1)
    return np.array([n for n in np.flatnonzero(inside) if n != own], dtype=np.intp)


def on_top(index: FloorIndex, receptacle: SceneObject, asset: Asset | None) -> list[SceneObject]:
    """Return what rests on a receptacle: on its top, or on a surface of its asset (a seat, a shelf).

    Notes
    -----
    On top is a child whose centroid lies above the top of the parent's bounding box and whose foot is within 5 cm
    of it. What hangs from the ceiling rests on nothing. Where something stands in between, that one is the carrier.
    """
    found = []
    for number in within_plan(index, receptacle):
        item = index.objects[int(number)]
        if item.mount == "ceiling" or (item.mount == "wall" and item.parent is None):
            continue
        foot = item.bottom
        if item.mount == "floor" and foot < LOW and receptacle.size[2] > REST:
            continue
        if _rests(item, receptacle, asset) and not _nested(index, item, receptacle):
            found.append(item)
    return found


def contents(index: FloorIndex, receptacle: SceneObject, asset: Asset | None) -> list[SceneObject]:
    """Return what lies in a container: its centroid strictly within the container's vertical range.

    Notes
    -----
    What rests on a seat, a mattress or a top below the container's highest point is not inside it; what stands on one
    of its shelves is, as the card has it, and lies on it too. Furniture that stands below a table top on the floor is
    inside only where one of the container's inner boxes holds it.
    """
    low = receptacle.bottom
    high = receptacle.top
    found = []
    for number in within_plan(index, receptacle):
        item = index.objects[int(number)]
        if item.mount == "ceiling" or not low < item.position[2] < high:
            continue
        below = item.mount == "floor" and item.parent == receptacle.id
        loose = item.mount in ("surface", "inside") or (item.pickupable and not below)
        held = _in_volume(item, receptacle, asset)
        open_seat = not held and _rests(item, receptacle, asset, shelves=False)
        if (held or (loose and not open_seat)) and not _nested(index, item, receptacle):
            found.append(item)
    return found


def _rests(item: SceneObject, receptacle: SceneObject, asset: Asset | None, *, shelves: bool = True) -> bool:
    foot = item.bottom
    top = receptacle.top
    if item.position[2] > top and abs(foot - top) <= REST:
        return True
    if asset is None:
        return False
    x, y = to_local(receptacle, item.position)
    for s in asset.surfaces:
        if s.kind == "shelf" and not shelves:
            continue
        near = abs(foot - (receptacle.position[2] + s.z)) <= REST
        if near and abs(x - s.x) <= s.w / 2 + EDGE and abs(y - s.y) <= s.d / 2 + EDGE:
            return True
    return False


def _in_volume(item: SceneObject, receptacle: SceneObject, asset: Asset | None) -> bool:
    if asset is None:
        return False
    x, y = to_local(receptacle, item.position)
    z = item.position[2] - receptacle.position[2]
    return any(
        abs(x - v.x) <= v.w / 2 + EDGE and abs(y - v.y) <= v.d / 2 + EDGE and abs(z - v.z) <= v.h / 2 + EDGE
        for v in asset.volumes
    )


def _nested(index: FloorIndex, item: SceneObject, receptacle: SceneObject) -> bool:
    """Whether the scene names another carrier that stands on or in this receptacle itself, and still holds the item."""
    number = index.at.get(item.parent or "", -1)
    if number < 0 or item.parent == receptacle.id:
        return False
    carrier = index.objects[number]
    x, y = to_local(carrier, item.position)
    over = abs(x) <= carrier.size[0] / 2 + EDGE and abs(y) <= carrier.size[1] / 2 + EDGE
    low, high = item.bottom, item.top
    base = carrier.bottom
    roof = carrier.top
    return over and low <= roof + REST and high >= base


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
    ordinal = "|".join(ORDINALS)
    patterns = (
        rf"{_TO}(?:{_FLOOR_WORDS} )?(?P<word>{ordinal}|{'|'.join(_NAMED)}|\d+(?:st|nd|rd|th)) {_FLOOR_WORDS}\b",
        rf"{_TO}{_FLOOR_WORDS} (?:number |no\.? )?(?P<word>-?\d+|{'|'.join(_NUMBERS)})\b",
        rf"\b(?:on|at) the (?P<word>{ordinal}|\d+(?:st|nd|rd|th))\b",
        rf"{_TO}(?P<word>basement|cellar|upstairs|downstairs)\b",
    )
    for pattern in patterns:
        match = re.search(pattern, low)
        if match:
            floor = _floor_number(state, match["word"])
            rest = f"{text[: match.start()]} {text[match.end() :]}"
            return floor, " ".join(rest.split())
    return None, text


_NAMED = [
    "ground",
    "entrance",
    "street",
    "lowest",
    "bottom",
    "top",
    "topmost",
    "uppermost",
    "highest",
    "upper",
    "lower",
    "last",
]
_NUMBERS = {word: number for word, number in CARDINALS.items() if word not in SOFT_NUMBERS}


def _floor_number(state: SceneState, word: str) -> int:
    digits = re.match(r"-?\d+", word)
    if digits:
        number = int(digits.group()) if len(digits.group()) < 6 else 10**6
    elif word in ORDINALS:
        number = ORDINALS[word]
    elif word in _NUMBERS:
        number = _NUMBERS[word]
    else:
        number = _named_floor(state, word)
    if number not in state.scenes:
        raise MansionError(
            ErrorCode.NOT_FOUND,
            f"there is no floor {word}; the building has floors {', '.join(map(str, state.floors))}",
            details={"floors": state.floors},
        )
    return number


def _named_floor(state: SceneState, word: str) -> int:
    if word in ("ground", "entrance", "street"):
        return 1
    if word in ("basement", "cellar"):
        return min(0, state.floors[0])
    if word in ("lowest", "bottom", "lower", "downstairs"):
        return state.floors[0] if word != "downstairs" else 1
    if word == "upstairs":
        return min(2, state.floors[-1])
    return state.floors[-1]


def find_rooms(
    state: SceneState, text: str, on_floor: int | None = None, *, every: bool = False
) -> list[tuple[int, SceneRoom]]:
    """Return the rooms that a text names, the best fits only: by id, by the end of it, or by words and floor.

    Parameters
    ----------
    on_floor : int, optional
        The floor, where the text does not name one.
    every : bool
        All rooms of the kind instead of the best fits.

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
    rooms = [(number, room) for number, room in state.rooms() if floor in (None, number)]
    ends = [pair for pair in rooms if pair[1].id.split("/", 1)[-1] == rest.strip().lower()]
    if ends and not every:
        return ends
    size = re.match(r"^(?:the )?(?P<word>largest|biggest|smallest)\s+(?P<rest>.+)$", rest, re.I)
    if size:
        few = find_rooms(state, size["rest"], floor, every=True)
        few.sort(key=lambda pair: pair[1].area, reverse=size["word"].lower() != "smallest")
        return few[:1]
    nth = re.match(rf"^(?:the )?(?P<word>{'|'.join(ORDINALS)})\s+(?P<rest>.+)$", rest, re.I)
    if nth:
        few = find_rooms(state, nth["rest"], floor, every=True)
        at = ORDINALS[nth["word"].lower()]
        return few[at - 1 : at]
    words = tuple(w for w in stems(rest) if w != "room") or stems(rest)
    if not words:
        return rooms if floor is not None else []
    ranked = [(_room_rank(room, words, stems(rest)), pair) for pair in rooms for room in [pair[1]]]
    best = max((rank for rank, _ in ranked), default=0)
    if not best:
        return _by_synonym(rooms, rest)
    least = min(best, 2) if every else best
    return [pair for rank, pair in ranked if rank >= least]


def _by_synonym(rooms: Sequence[tuple[int, SceneRoom]], text: str) -> list[tuple[int, SceneRoom]]:
    """Return the rooms that another word for the same kind of room names."""
    number = re.search(r"\s(?:number |no\.? )?(\d+)$", text.strip())
    words = stems(text[: number.start()] if number else text)
    group = next((names for name, names in interchangeable_names().items() if stems(name) == words), ())
    kinds = [stems(name) for name in group]
    return [
        pair
        for pair in rooms
        if (stems(pair[1].room_type.replace("_", " ")) in kinds or stems(pair[1].name) in kinds)
        and (number is None or pair[1].id.endswith(f"_{number[1]}"))
    ]


def _room_rank(room: SceneRoom, words: tuple[str, ...], whole: tuple[str, ...]) -> int:
    own = stems(room.id.split("/", 1)[-1].replace("_", " "))
    kind = stems(room.room_type.replace("_", " "))
    named = stems(room.name)
    if whole == own or (named and whole == named) or whole in [stems(alias) for alias in room.aliases]:
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
    words = vocabulary_of(state.catalogue)
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
    wanted = rest.strip().lower().removeprefix("the ")
    cores: list[tuple[int, SceneCore]] = [
        (number, core) for number in state.floors if floor in (None, number) for core in state.scenes[number].cores
    ]
    for number, core in cores:
        if core.id == wanted or core.type == CORE_WORDS.get(wanted):
            return number, core.id
    return None
