"""The walls and openings of a storey built again from a changed layout, with what did not change left as it was."""

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import msgspec
from shapely import Polygon

from mansion_editing.structure.storey_documents import Storey
from mansion_geometry.object_footprints import WALKABLE_HEIGHT, footprint
from mansion_geometry.wall_sizes import DOOR_HEAD
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import Downgrade
from mansion_msgs_py.scene import Door, FloorScene, SceneObject, SceneRoom, Wall, Window
from mansion_msgs_py.shapes import Segment
from mansion_msgs_py.stages import FurnishRequest
from mansion_scene.structure import FloorStructure, build_structure
from mansion_scene.structure.access import AccessPlan, Pair, Passage, pair_key
from mansion_scene.structure.held_openings import HeldAccess

__all__ = ["Rebuilt", "passages_of_scene", "rebuild"]

_ROUNDING = 2e-3
_SAME_FLOOR = 1e-3  # square metres by which equal interiors differ from rounding


@dataclass(frozen=True)
class Rebuilt:
    """A storey's structure after a change.

    Attributes
    ----------
    structure : FloorStructure
        With the names and the very values of before where nothing changed.
    touched : frozenset of str
        Rooms whose floor, doors or windows differ from before.
    new_doors : list of Door
    lost_doors : list of Door
        Former doors that are gone or elsewhere.
    """

    structure: FloorStructure
    touched: frozenset[str]
    new_doors: list[Door]
    lost_doors: list[Door]


def passages_of_scene(scene: FloorScene) -> list[Passage]:
    """Return which regions of a finished storey open to which, in the order of its doors."""
    passages: dict[Pair, Passage] = {}
    for door in scene.doors:
        a, b = door.rooms
        if b is not None:
            passages.setdefault(pair_key(a, b), Passage(pair_key(a, b), is_open=door.kind == "open"))
    return list(passages.values())


def rebuild(before: Storey, after: Storey, passages: Sequence[Passage], released: Collection[str] = ()) -> Rebuilt:
    """Build the structure of a storey again.

    Parameters
    ----------
    before : Storey
        As it stands.
    after : Storey
        The same with another layout, room graph or program; its scene is that of `before`.
    passages : sequence of Passage
        Which regions open to which.
    released : collection of str
        Ids of doors that need not stay where they are.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` where a passage has no wall to open, or no room for its door.
    """
    scene = before.scene
    access = [d for d in scene.downgrades if " access " in d.wish]
    held = HeldAccess(
        plan=AccessPlan(tuple(passages), tuple(access)),
        doors=tuple(door for door in scene.doors if door.id not in released),
        standing=_furniture(scene.objects),
    )
    structure = build_structure(_request(after), held)
    _require_passages(structure, passages)
    return _as_before(structure, scene)


def _request(storey: Storey) -> FurnishRequest:
    program = storey.program
    return FurnishRequest(
        building_id=program.building_id,
        floor=storey.floor,
        floors=[floor.index for floor in program.floors],
        labels=[floor.label for floor in program.floors],
        connectivity=program.vertical_connectivity,
        topology=storey.topology,
        layout=storey.layout,
        building_type=program.kind,
        style=program.style,
        outside=program.outside,
        seed=program.seed,
    )


def _furniture(objects: Iterable[SceneObject]) -> dict[str, list[Polygon]]:
    standing: dict[str, list[Polygon]] = {}
    for item in objects:
        if item.mount in ("floor", "wall") and item.size[2] > WALKABLE_HEIGHT and item.bottom < DOOR_HEAD:
            standing.setdefault(item.room, []).append(footprint(item))
    return standing


def _require_passages(structure: FloorStructure, passages: Sequence[Passage]) -> None:
    joined = {pair_key(a, b) for a, b in (door.rooms for door in structure.doors) if b is not None}
    for passage in passages:
        if passage.pair not in joined:
            first, second = passage.pair
            raise MansionError(ErrorCode.INFEASIBLE, f"{first} and {second} would no longer open to each other")
    narrow = [
        d
        for d in structure.downgrades
        if d.stage != "plan" and d.wish.startswith("door of ") and d.got.endswith(" clear")
    ]
    if narrow:
        raise MansionError(ErrorCode.INFEASIBLE, f"{narrow[0].wish}: {narrow[0].reason}")


def _as_before(structure: FloorStructure, scene: FloorScene) -> Rebuilt:
    """Give back to everything that did not change its name and its very value."""
    rooms = _same_rooms(structure.rooms, scene.rooms)
    walls = _faced(structure.walls, rooms)
    walls = _renamed(walls, scene.walls, _same_wall, f"F{scene.floor}/wall_")
    named = {new.id: kept.id for new, kept in zip(structure.walls, walls, strict=True)}
    doors = _renamed(_in_walls(structure.doors, named), scene.doors, _same_door, f"F{scene.floor}/door_")
    windows = _renamed(_in_walls(structure.windows, named), scene.windows, _same_window, f"F{scene.floor}/window_")
    door_names = {new.id: kept.id for new, kept in zip(structure.doors, doors, strict=True)}
    cores = [msgspec.structs.replace(core, door=door_names[core.door]) for core in structure.cores]
    known = {door.id: door for door in scene.doors}
    there = {door.id for door in doors}
    fresh = [door for door in doors if door.id not in known]
    lost = [door for door in scene.doors if door.id not in there]
    touched = {new.id for new, old in _pairs(rooms, scene.rooms) if new is not old}
    touched |= {name for door in (*fresh, *lost) if door.kind != "open" for name in door.rooms if name is not None}
    held = {window.id for window in scene.windows} & {window.id for window in windows}
    touched |= {window.room for window in (*scene.windows, *windows) if window.id not in held}
    built = replace(
        structure, rooms=rooms, walls=walls, doors=doors, windows=windows, cores=cores,
        downgrades=_downgrades(structure.downgrades, scene.downgrades, touched),
    )  # fmt: skip
    return Rebuilt(built, frozenset(touched & {room.id for room in rooms}), fresh, lost)


def _downgrades(new: Sequence[Downgrade], old: Sequence[Downgrade], touched: Collection[str]) -> list[Downgrade]:
    """Return what still differs from the room graph: notes of doors that were held are not made again."""
    kept = [d for d in old if "door" in d.wish and not any(room in d.wish.split() for room in touched)]
    return [*(d for d in new if d not in kept), *kept]


def _pairs(new: Sequence[SceneRoom], old: Sequence[SceneRoom]) -> list[tuple[SceneRoom, SceneRoom]]:
    known = {room.id: room for room in old}
    return [(room, known[room.id]) for room in new]


def _faced(walls: Sequence[Wall], rooms: Sequence[SceneRoom]) -> list[Wall]:
    """Return walls whose faces have the materials of the rooms, which edits may have changed since the building."""
    faces = {room.id: room.wall_material for room in rooms}
    return [
        msgspec.structs.replace(
            wall,
            left_material=faces.get(wall.left or "", wall.left_material),
            right_material=faces.get(wall.right or "", wall.right_material),
        )
        for wall in walls
    ]


def _same_rooms(new: Sequence[SceneRoom], old: Sequence[SceneRoom]) -> list[SceneRoom]:
    """Return the old rooms, with other polygons where those differ by more than rounding."""
    return [was if _same_floor(room, was) else _on_floor_of(was, room) for room, was in _pairs(new, old)]


def _on_floor_of(room: SceneRoom, other: SceneRoom) -> SceneRoom:
    return msgspec.structs.replace(
        room,
        polygon=other.polygon,
        holes=other.holes,
        net_polygon=other.net_polygon,
        net_holes=other.net_holes,
        area=other.area,
    )


def _same_floor(new: SceneRoom, old: SceneRoom) -> bool:
    nets = Polygon(new.net_polygon, new.net_holes), Polygon(old.net_polygon, old.net_holes)
    same = (new.polygon, new.holes) == (old.polygon, old.holes)
    return same and float(nets[0].symmetric_difference(nets[1]).area) < _SAME_FLOOR


Part = TypeVar("Part", Wall, Door, Window)
Opening = TypeVar("Opening", Door, Window)


def _in_walls(openings: Sequence[Opening], named: Mapping[str, str]) -> list[Opening]:
    return [msgspec.structs.replace(item, wall=named.get(item.wall, "")) for item in openings]


def _renamed(new: Sequence[Part], old: Sequence[Part], same: Callable[[Part, Part], bool], prefix: str) -> list[Part]:
    """Return each part as it was before where it still is the same, and the others under names that are free."""
    waiting = list(old)
    kept: list[Part | None] = []
    for part in new:
        was = next((other for other in waiting if same(part, other)), None)
        if was is not None:
            waiting.remove(was)
        kept.append(was)
    taken = {item.id for item in old}
    free = (name for n in range(1, len(new) + len(old) + 2) if (name := f"{prefix}{n}") not in taken)
    return [
        _like(part, was) if was is not None else msgspec.structs.replace(part, id=next(free))
        for part, was in zip(new, kept, strict=True)
    ]


def _like(part: Part, was: Part) -> Part:
    """Return the part under its former name, with its former place to the last digit."""
    return msgspec.structs.replace(part, id=was.id, segment=was.segment)


def _near(one: Segment, other: Segment) -> bool:
    return all(abs(a - b) < _ROUNDING for p, q in zip(one, other, strict=True) for a, b in zip(p, q, strict=True))


def _same_wall(new: Wall, old: Wall) -> bool:
    return (new.left, new.right) == (old.left, old.right) and _near(new.segment, old.segment)


def _same_door(new: Door, old: Door) -> bool:
    return new.rooms == old.rooms and new.kind == old.kind and _near(new.segment, old.segment)


def _same_window(new: Window, old: Window) -> bool:
    return new.room == old.room and new.sill == old.sill and _near(new.segment, old.segment)
