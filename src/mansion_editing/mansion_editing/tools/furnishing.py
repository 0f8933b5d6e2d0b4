"""FurnishRoom: replace the furniture of a room, for its present use or for another one."""

import difflib
import re
from collections.abc import Callable, Collection, Sequence
from typing import Final, Protocol

import msgspec

from mansion_assets.catalogue import Catalogue
from mansion_assets.catalogue.room_matching import normalise
from mansion_editing.state import SceneState
from mansion_editing.tools.rooms import RoomRecords, change_room, names_on_floor, room_named, with_carriers
from mansion_knowledge import default_knowledge, is_class
from mansion_knowledge.object_kinds import answers, is_service
from mansion_language import singular
from mansion_msgs_py.editing.changes import RoomParts
from mansion_msgs_py.editing.rooms import FurnishRoomArgs
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import RequestedObject
from mansion_msgs_py.scene import Discard, FloorScene, SceneObject, SceneRoom
from mansion_scene.lighting import room_lights
from mansion_scene.spawn import place_spawn

__all__ = ["Furnisher", "furnish_room", "room_type_named"]

Judge = Callable[[int, FloorScene], Sequence[str]]
"""Gets a floor and its scene as it would be, and returns what would be wrong with it."""

_TRIALS: Final = 4
"""Arrangements that are tried until one differs from what stood there and has no fault."""

_ANOTHER: Final = 0.5
"""Share of furniture that stands as it stood, from which on an arrangement is not another."""


class Furnisher(Protocol):
    """The placer: see `mansion_scene.refurnishing.furnish_room`."""

    def __call__(
        self,
        scene: FloorScene,
        room: SceneRoom,
        standing: Sequence[SceneObject],
        requested: Sequence[RequestedObject],
        seed: int,
        catalogue: Catalogue,
        /,
    ) -> tuple[list[SceneObject], list[Discard]]:
        """Return new objects for a room, and what could not be placed."""


def furnish_room(
    state: SceneState, args: FurnishRoomArgs, records: RoomRecords, furnisher: Furnisher, judge: Judge
) -> tuple[SceneRoom, list[str]]:
    """Furnish a room again; return it and the ids of its new objects.

    All goes but the building's services (switches, detectors, radiators, ...) and what is to be kept, of which no more
    is brought. Where the first arrangement is the one that was there, or has a fault, others are tried.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown room, type or object, ``INFEASIBLE`` for a room that cannot be of the type, or
        when every arrangement has a fault.
    """
    floor, room = room_named(state, args.room_id)
    kind = room_type_named(state.catalogue, args.room_type) if args.room_type.strip() else room.room_type
    _refuse_unfit(room, kind)
    items = [item for item in state.scenes[floor].objects if item.room == room.id]
    staying = _staying(state, floor, room, items, args.keep)
    for item in items:
        if item.id not in staying:
            state.remove(floor, item)
    standing = [item for item in items if item.id in staying]
    gone = [item for item in items if item.id not in staying]
    change_room(state, floor, room.id, records, lambda parts: _as_kind(state, floor, parts, kind))
    new = _arranged(state, floor, room.id, standing, gone, records, furnisher, judge)
    return next(r for r in state.scenes[floor].rooms if r.id == room.id), new


def room_type_named(catalogue: Catalogue, words: str) -> str:
    """Return the room type that words name.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` with the nearest types.
    """
    name, known = normalise(words), default_knowledge().rooms
    if name in known or name in catalogue.room_types:
        return name
    plain = name.replace("_", " ")
    meant = next((kind.name for kind in known.values() if plain in kind.synonyms), "")
    if meant:
        return meant
    program = catalogue.room_program(name)
    if program.how == "synonym":
        return program.room_type
    names = sorted({*known, *catalogue.room_types})
    near = difflib.get_close_matches(name, names, n=6, cutoff=0.5)
    raise MansionError(
        ErrorCode.NOT_FOUND,
        f"no room type {words[:120]!r}; nearest: {', '.join(near) or 'none'}",
        path="$.room_type",
        details={"nearest": near},
    )


def _refuse_unfit(room: SceneRoom, kind: str) -> None:
    """Refuse a type that the room's walls or its place in the building rule out."""
    if kind == room.room_type:
        return
    reason = ""
    if is_class(kind, "outdoor") != is_class(room.room_type, "outdoor"):
        reason = "a room indoors and one outdoors have other walls"
    elif _is_passage(room.room_type, room.kind) and not _is_passage(kind):
        reason = "other rooms are reached through it"
    if reason:
        raise MansionError(
            ErrorCode.INFEASIBLE, f"{room.id} cannot become a {kind.replace('_', ' ')}: {reason}", path="$.room_type"
        )


def _is_passage(kind: str, place: str = "") -> bool:
    return place == "main" or default_knowledge().room(kind).zone == "circulation"


def _staying(
    state: SceneState, floor: int, room: SceneRoom, items: Collection[SceneObject], keep: Sequence[str]
) -> set[str]:
    wanted = [item for item in items if is_service(item.category)]
    for name in keep:
        _, item = state.get(name, "$.keep")
        if item.room != room.id:
            raise MansionError(ErrorCode.NOT_FOUND, f"{item.id} is not in {room.id}", path="$.keep")
        wanted += state.subtree(floor, item)
    return with_carriers(state, wanted)


def _as_kind(state: SceneState, floor: int, parts: RoomParts, kind: str) -> RoomParts:
    """Return a room as one of a type: type, program, room graph, and the name where nobody has given it one."""
    room, program, node = parts.room, parts.program, parts.node
    if room.room_type == kind:
        return parts
    if _has_own_name(parts):
        name, aliases = room.name, [alias for alias in room.aliases if not _names_kind(alias, room.room_type)]
        label = None if program is None else program.name
    else:
        name, aliases = _kind_name(kind, names_on_floor(state, floor, without=room.id)), []
        label = "" if program is None or not program.name else name
    if program is not None and label is not None:
        program = msgspec.structs.replace(program, room_type=kind, name=label, aliases=aliases, objects=[])
    if node is not None:
        node = msgspec.structs.replace(node, room_type=kind)
    room = msgspec.structs.replace(room, room_type=kind, name=name, aliases=aliases)
    return msgspec.structs.replace(parts, room=room, program=program, node=node)


def _has_own_name(parts: RoomParts) -> bool:
    """Whether a room's name says something else than what kind of room it is."""
    return not _names_kind(parts.room.name, parts.room.room_type) and (
        parts.program is None or bool(parts.program.name) or not _is_id(parts.room)
    )


def _is_id(room: SceneRoom) -> bool:
    return normalise(room.name) == normalise(room.id.partition("/")[2])


def _names_kind(name: str, kind: str) -> bool:
    known = default_knowledge().rooms.get(kind)
    *first, last = normalise(name).split("_")
    plain = " ".join([*first, singular(last)])
    return plain in ("", kind.replace("_", " ")) or (known is not None and plain in known.synonyms)


def _kind_name(kind: str, taken: Collection[str]) -> str:
    """Return the name of a type in words, with the first free number where a room has it already."""
    plain = kind.replace("_", " ").capitalize()
    numbered = [name for name in taken if re.fullmatch(rf"{re.escape(plain.casefold())}(?: \d+)?", name)]
    if not numbered:
        return plain
    number = 2 if plain.casefold() in taken else 1
    while f"{plain} {number}".casefold() in taken:
        number += 1
    return f"{plain} {number}"


def _arranged(
    state: SceneState,
    floor: int,
    room_id: str,
    standing: Sequence[SceneObject],
    gone: Sequence[SceneObject],
    records: RoomRecords,
    furnisher: Furnisher,
    judge: Judge,
) -> list[str]:
    """Add the first sound arrangement that is another, with its light; return the ids of its objects.

    Another is one in which less than half of the furniture stands as it stood; where there is none, the one that
    differs most.
    """
    scene = state.scenes[floor]
    faults: Sequence[str] = ()
    best, least = None, 1.0
    for seed in range(scene.seed, scene.seed + _TRIALS):
        start = len(state.pending)
        objects = _furnish(state, floor, room_id, standing, records, furnisher, seed)
        faults = judge(floor, state.scenes[floor])
        alike = 1.0 if faults else _alike(objects, gone)
        if alike < _ANOTHER:
            return [item.id for item in objects]
        state.roll_back(start)
        if alike < least:
            best, least = seed, alike
    if best is None:
        reason = "; ".join(faults[:5]) or "it is furnished as its type is already"
        raise MansionError(ErrorCode.INFEASIBLE, f"{room_id} cannot be refurnished: {reason}", path="$.room_id")
    return [item.id for item in _furnish(state, floor, room_id, standing, records, furnisher, best)]


def _alike(objects: Sequence[SceneObject], others: Sequence[SceneObject]) -> float:
    """Return the share of objects that are among the others, where they are; of furniture, where there is any."""
    sides = [[item for item in side if item.mount == "floor"] for side in (objects, others)]
    one, other = (
        {(i.asset, i.position, i.rotation) for i in side} for side in (sides if all(sides) else (objects, others))
    )
    return len(one & other) / max(len(one | other), 1)


def _furnish(
    state: SceneState,
    floor: int,
    room_id: str,
    standing: Sequence[SceneObject],
    records: RoomRecords,
    furnisher: Furnisher,
    seed: int,
) -> list[SceneObject]:
    scene = state.scenes[floor]
    room = next(room for room in scene.rooms if room.id == room_id)
    objects: list[SceneObject] = []

    def furnished(parts: RoomParts) -> RoomParts:
        asked = parts.program.objects if parts.program is not None else []
        made, lost = furnisher(scene, room, standing, _beside(standing, asked), seed, state.catalogue)
        objects.extend(made)
        everything = [*standing, *made]
        spawn = parts.spawn and place_spawn(room, scene.doors, everything)
        source = parts.source and "rules: furnished anew"
        return msgspec.structs.replace(
            parts, lights=room_lights(room, everything), discarded=lost, spawn=spawn, source=source
        )

    change_room(state, floor, room_id, records, furnished)
    for item in objects:
        state.add(floor, item)
    return objects


def _beside(standing: Sequence[SceneObject], asked: Sequence[RequestedObject]) -> list[RequestedObject]:
    """Return the furniture to add: the requested objects except those already there, and no more of the latter."""
    left = [
        msgspec.structs.replace(
            wish, count=max(0, wish.count - sum(answers(wish.category, item.category) for item in standing))
        )
        for wish in asked
    ]
    wanted = {wish.category for wish in left}
    kinds = dict.fromkeys(item.category for item in standing if item.category not in wanted)
    return [*left, *(RequestedObject(category=kind, count=0) for kind in kinds)]
