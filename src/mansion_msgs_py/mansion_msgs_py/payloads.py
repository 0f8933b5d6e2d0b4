"""The payload types by name, without those that a skill declares for itself."""

from types import ModuleType
from typing import Any

import msgspec

from mansion_msgs_py import (
    building,
    building_plan,
    errors,
    layout,
    openings,
    placement,
    program,
    request,
    scene,
    skills,
    stages,
    task,
    topology,
    world,
)
from mansion_msgs_py.editing import changes, instructions, objects, open_buildings, questions, rooms

__all__ = ["PAYLOADS"]

_MODULES: tuple[ModuleType, ...] = (
    request,
    building_plan,
    openings,
    program,
    topology,
    layout,
    scene,
    placement,
    stages,
    building,
    skills,
    world,
    task,
    open_buildings,
    questions,
    objects,
    rooms,
    changes,
    instructions,
    errors,
)

PAYLOADS: dict[str, type[Any]] = {
    name: kind
    for module in _MODULES
    for name in module.__all__
    if isinstance(kind := getattr(module, name), type) and issubclass(kind, msgspec.Struct)
}
"""Every structure that the payload modules make public."""
