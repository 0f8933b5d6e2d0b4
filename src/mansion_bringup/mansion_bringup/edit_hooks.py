"""What the scene editor leaves to others: the independent check before an edit, the files made from scenes after."""

import hashlib
from collections import OrderedDict
from collections.abc import Mapping, Sequence

import msgspec

from mansion_bringup.building.floor_files import scene_files
from mansion_bringup.check.fault import Fault
from mansion_bringup.check.identity import check_identity
from mansion_bringup.check.objects import check_objects
from mansion_bringup.check.reach import check_reach
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.scene import FloorScene

__all__ = ["building_files", "floor_files", "new_faults"]

_MOST_REMEMBERED = 64


def new_faults(before: Mapping[int, FloorScene], after: Mapping[int, FloorScene]) -> list[str]:
    """Return the faults that ``mansion check`` finds after an edit and not before it.

    Notes
    -----
    An edit changes objects alone, so that only names, poses and reach can go wrong; and reach only when something
    that stands on a floor or hangs on a wall changed.
    """
    changed = [floor for floor in after if after[floor] is not before[floor]]
    known = {str(fault) for fault in _faults(before, changed, after)}
    found = [str(fault) for fault in _faults(after, changed, before)]
    return [fault for fault in found if fault not in known]


def _faults(
    scenes: Mapping[int, FloorScene], changed: Sequence[int], other: Mapping[int, FloorScene]
) -> list[Fault]:
    faults = [fault for floor in changed for fault in _remembered("objects", [scenes[floor]])]
    if any(_obstacles(scenes[floor]) != _obstacles(other[floor]) for floor in changed):
        faults += _remembered("reach", [scenes[floor] for floor in sorted(scenes)])
    return faults


_memory: OrderedDict[tuple[str, bytes], list[Fault]] = OrderedDict()
"""Faults by what was checked: the floor after an edit is the one before the next."""


def _remembered(kind: str, scenes: Sequence[FloorScene]) -> list[Fault]:
    digest = hashlib.sha256()
    for scene in scenes:
        digest.update(encode_bytes(msgspec.structs.replace(scene, revision=0)))
    key = (kind, digest.digest())
    if key not in _memory:
        _memory[key] = list(check_reach(scenes)) if kind == "reach" else _object_faults(scenes[0])
        if len(_memory) > _MOST_REMEMBERED:
            _memory.popitem(last=False)
    return _memory[key]


def _object_faults(scene: FloorScene) -> list[Fault]:
    return [*check_identity(scene.building_id, [scene]), *check_objects(scene)]


def _obstacles(scene: FloorScene) -> dict[str, object]:
    return {
        thing.id: (thing.position, thing.rotation, thing.size)
        for thing in scene.objects
        if thing.mount in ("floor", "wall")
    }


def floor_files(scene: FloorScene) -> dict[str, bytes]:
    """Return the files made from one scene, the scene itself left out."""
    files = scene_files(scene)
    return {name: data for name, data in files.items() if not name.endswith("/scene.json")}


def building_files(scenes: Sequence[FloorScene]) -> dict[str, bytes]:
    """Return the files made from all scenes."""
    from mansion_scene.export.glb import building_glb
    from mansion_scene.export.overview import overview_png

    return {"building.glb": building_glb(scenes), "building.png": overview_png(scenes)}
