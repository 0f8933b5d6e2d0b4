"""Hooks of the scene editor: the independent check before an edit lands, and files made from scenes after it."""

import hashlib
import math
from collections import OrderedDict
from collections.abc import Mapping

import msgspec

from mansion_bringup.building.files import building_exports as building_files
from mansion_bringup.building.files import floor_exports as floor_files
from mansion_bringup.check.fault import Fault
from mansion_bringup.check.integrity import check_identity
from mansion_bringup.check.objects import carriers, check_objects
from mansion_bringup.check.reach import check_reach
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.scene import FloorScene, SceneObject

__all__ = ["building_files", "floor_files", "new_faults"]

_MAX_REMEMBERED = 64
_NEAR = 0.05
"""Slack of the circles that say which objects could touch, metres."""


def new_faults(before: Mapping[int, FloorScene], after: Mapping[int, FloorScene]) -> list[str]:
    """Return the faults that ``mansion check`` finds after an edit and not before it.

    Notes
    -----
    An edit changes objects alone, so that only names, poses and reach can go wrong. Faults of names and poses concern
    one object, an object and what carries it, or two objects that meet: only those that changed and those around them
    are judged. Reach is judged for the whole building, and only when something that stands on a floor or hangs on a
    wall changed. What has no fault afterwards has no new one: the state before is looked at only where there is any.
    """
    changed = [floor for floor in after if after[floor] is not before[floor]]
    found: list[Fault] = []
    known: set[str] = set()
    for floor in changed:
        names = _concerned(before[floor], after[floor])
        faults = _object_faults(after[floor], names)
        found += faults
        if faults:
            known |= {str(fault) for fault in _object_faults(before[floor], names)}
    if any(_obstacles(before[floor]) != _obstacles(after[floor]) for floor in changed):
        faults = _reach_faults(after)
        found += faults
        if faults:
            known |= {str(fault) for fault in _reach_faults(before)}
    return [text for text in map(str, found) if text not in known]


def _concerned(before: FloorScene, after: FloorScene) -> set[str]:
    """Return the ids of objects whose faults an edit can change, with all that carry them."""
    old = {item.id: item for item in before.objects}
    new = {item.id: item for item in after.objects}
    touched = {name for name in {*old, *new} if old.get(name) != new.get(name)}
    spots = [item for side in (old, new) for name in touched if (item := side.get(name))]
    names = set(touched)
    for side in (old, new):
        near = [item for item in side.values() if item.parent in touched or any(_meet(item, spot) for spot in spots)]
        for item in near:
            names.add(item.id)
            names.update(carriers(item, side))
    return names


def _meet(one: SceneObject, other: SceneObject) -> bool:
    reach = (math.hypot(*one.size[:2]) + math.hypot(*other.size[:2])) / 2 + _NEAR
    return math.dist(one.position[:2], other.position[:2]) <= reach


def _object_faults(scene: FloorScene, names: set[str]) -> list[Fault]:
    few = [item for item in scene.objects if item.id in names]
    part = msgspec.structs.replace(scene, objects=few)
    return [*check_identity(scene.building_id, [part]), *check_objects(part)]


_memory: OrderedDict[bytes, list[Fault]] = OrderedDict()
"""Faults of reach by what was checked: the building after an edit is the one before the next."""


def _reach_faults(scenes: Mapping[int, FloorScene]) -> list[Fault]:
    digest = hashlib.sha256()
    for floor in sorted(scenes):
        digest.update(encode_bytes(msgspec.structs.replace(scenes[floor], revision=0)))
    key = digest.digest()
    if key not in _memory:
        _memory[key] = list(check_reach([scenes[floor] for floor in sorted(scenes)]))
        if len(_memory) > _MAX_REMEMBERED:
            _memory.popitem(last=False)
    return _memory[key]


def _obstacles(scene: FloorScene) -> dict[str, object]:
    return {
        item.id: (item.position, item.rotation, item.size) for item in scene.objects if item.mount in ("floor", "wall")
    }
