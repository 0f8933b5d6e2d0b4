"""Hooks of the scene editor: the independent check before an edit; files and wishes after it."""

import hashlib
import math
from collections import OrderedDict
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TypeAlias, TypeVar

import msgspec

from mansion_assets.library.building_assets import assets_of
from mansion_bringup.building.files import kept_files
from mansion_bringup.building.own_assets import asset_uses, assets_in
from mansion_bringup.building.receipt import receipt
from mansion_bringup.check.cores import check_cores
from mansion_bringup.check.fault import Fault
from mansion_bringup.check.integrity import check_identity
from mansion_bringup.check.objects import carriers, check_objects
from mansion_bringup.check.openings import check_openings
from mansion_bringup.check.reach import Walk, check_reach, floor_reach, walkable
from mansion_bringup.check.rooms import check_partition, check_walls
from mansion_msgs_py.building import Building, BuildingReport
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene, SceneObject

__all__ = ["kept_files", "new_faults", "records"]

T = TypeVar("T")

_MAX_REMEMBERED = 64
_NEAR = 0.05
"""Slack of the circles that say which objects could touch, metres."""


def new_faults(before: Mapping[int, FloorScene], after: Mapping[int, FloorScene]) -> list[str]:
    """Return the faults that ``mansion check`` finds after an edit and not before it.

    Notes
    -----
    Most edits change only objects and descriptions of rooms, so that only names, poses and reach can go wrong. Faults
    of names and poses concern one object, an object and what carries it, or two objects that meet: only those that
    changed and those around them are judged. Reach is judged for the whole building, and only when something that
    stands on a floor or hangs on a wall changed. A floor that is new or has other walls, openings or cores is judged
    whole, the doors that its room graph wants left out. What has no fault afterwards has no new one: the state before
    is looked at only where there is any.
    """
    built = [floor for floor in after if floor not in before or _structure(before[floor]) != _structure(after[floor])]
    changed = [floor for floor in after if floor not in built and after[floor] is not before[floor]]
    found: list[Fault] = []
    known: set[str] = set()
    for floor in changed:
        names = _concerned(before[floor], after[floor])
        faults = _object_faults(after[floor], names)
        found += faults
        if faults:
            known |= {str(fault) for fault in _object_faults(before[floor], names)}
    rebuilt = bool(built) or before.keys() != after.keys()
    if rebuilt:
        found += _structural_faults(after, built)
        known |= {str(fault) for fault in _structural_faults(before, [floor for floor in built if floor in before])}
    if rebuilt or any(_obstacles(before[floor]) != _obstacles(after[floor]) for floor in changed):
        faults = _reach_faults(after)
        found += faults
        if faults:
            known |= {str(fault) for fault in _reach_faults(before)}
    return [text for text in map(str, found) if text not in known]


def _structure(scene: FloorScene) -> tuple[object, ...]:
    """Return what a floor is built of, without the descriptions of its rooms and without materials."""
    rooms = [(r.id, r.kind, r.polygon, r.holes, r.net_polygon, r.net_holes, r.ceiling_height) for r in scene.rooms]
    walls = [(w.id, w.segment, w.thickness, w.height, w.exterior, w.left, w.right) for w in scene.walls]
    shell = (scene.outline, scene.holes, scene.elevation, scene.height)
    return (rooms, walls, shell, scene.doors, scene.windows, scene.cores)


def _structural_faults(scenes: Mapping[int, FloorScene], built: Sequence[int]) -> list[Fault]:
    faults = list(check_cores([scenes[floor] for floor in sorted(scenes)]))
    for scene in (scenes[floor] for floor in built):
        faults += check_identity(scene.building_id, [scene])
        faults += [*check_partition(scene), *check_walls(scene), *check_openings(scene, []), *check_objects(scene)]
    return faults


def _concerned(before: FloorScene, after: FloorScene) -> set[str]:
    """Return the ids of objects whose faults an edit can change, with all that carry them."""
    old = {item.id: item for item in before.objects}
    new = {item.id: item for item in after.objects}
    touched = {name for name in {*old, *new} if old.get(name) != new.get(name)}
    spots = [item for side in (old, new) for name in touched if (item := side.get(name))]
    names = set(touched)
    circles = [_circle(spot) for spot in spots]
    for side in (old, new):
        near = [item for item in side.values() if item.parent in touched or _meets(_circle(item), circles)]
        for item in near:
            names.add(item.id)
            names.update(carriers(item, side))
    return names


_Circle: TypeAlias = tuple[float, float, float]
"""Centre and radius of what an object covers, however it is turned."""


def _circle(item: SceneObject) -> _Circle:
    return (item.position[0], item.position[1], math.hypot(item.size[0], item.size[1]) / 2)


def _meets(one: _Circle, others: Iterable[_Circle]) -> bool:
    x, y, radius = one
    return any((x - a) ** 2 + (y - b) ** 2 <= (radius + other + _NEAR) ** 2 for a, b, other in others)


def _object_faults(scene: FloorScene, names: set[str]) -> list[Fault]:
    few = [item for item in scene.objects if item.id in names]
    part = msgspec.structs.replace(scene, objects=few)
    return [*check_identity(scene.building_id, [part]), *check_objects(part)]


_memory: OrderedDict[bytes, list[Fault]] = OrderedDict()
"""Faults of reach by what was checked: the building after an edit is the one before the next."""


_walks: OrderedDict[bytes, Walk] = OrderedDict()
"""Where a robot can be on a floor: an edit changes one floor, and the check asks about all."""


_floors: OrderedDict[bytes, list[Fault]] = OrderedDict()
"""Faults of a floor, by the floor and the pieces of it that a robot gets to."""


def _reach_faults(scenes: Mapping[int, FloorScene]) -> list[Fault]:
    digests = {floor: _digest(scenes[floor]) for floor in sorted(scenes)}
    key = b"".join(digests.values())

    def checked() -> list[Fault]:
        walks = {f: _remembered(_walks, digest, partial(walkable, scenes[f])) for f, digest in digests.items()}
        return list(check_reach([scenes[floor] for floor in digests], walks, judged))

    def judged(scene: FloorScene, walk: Walk, reached: set[int]) -> list[Fault]:
        pieces = " ".join(map(str, sorted(reached))).encode()
        return _remembered(_floors, digests[scene.floor] + pieces, lambda: list(floor_reach(scene, walk, reached)))

    return _remembered(_memory, key, checked)


def _digest(scene: FloorScene) -> bytes:
    return hashlib.sha256(encode_bytes(msgspec.structs.replace(scene, revision=0))).digest()


def _remembered(memory: OrderedDict[bytes, T], key: bytes, make: Callable[[], T]) -> T:
    """Return what is remembered, or make it; the least recently used is forgotten."""
    if key in memory:
        memory.move_to_end(key)
    else:
        memory[key] = make()
        if len(memory) > _MAX_REMEMBERED:
            memory.popitem(last=False)
    return memory[key]


def _obstacles(scene: FloorScene) -> dict[str, object]:
    return {
        item.id: (item.position, item.rotation, item.size) for item in scene.objects if item.mount in ("floor", "wall")
    }


def records(folder: Path, scenes: Mapping[int, FloorScene]) -> dict[str, bytes]:
    """Return ``building.json`` and ``report.json`` with what became of each wish, as far as that changed.

    Parameters
    ----------
    folder : Path
        The building's folder.
    scenes : mapping of int to FloorScene
        All floors as they are now.

    Notes
    -----
    A file that is missing or does not decode is left as it is: ``mansion check`` names it.
    """
    building = _read(Building, folder / "building.json")
    if building is None:
        return {}
    program = building.program
    ordered = [scenes[floor] for floor in sorted(scenes)]
    with assets_of(folder):
        wishes = receipt(program.wishes, program, ordered)
        assets = asset_uses(assets_in(ordered), ordered)
    files = {}
    if wishes != building.wishes:
        files["building.json"] = encode_bytes(msgspec.structs.replace(building, wishes=wishes), indent=1)
    name = building.files.get("report", "report.json")
    report = _read(BuildingReport, folder / name)
    if report is not None and (wishes, assets) != (report.wishes, report.assets):
        files[name] = encode_bytes(msgspec.structs.replace(report, wishes=wishes, assets=assets), indent=1)
    return files


def _read(kind: type[T], file: Path) -> T | None:
    try:
        return decode(kind, file.read_bytes())
    except (OSError, MansionError):
        return None
