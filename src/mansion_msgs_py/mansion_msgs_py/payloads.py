"""The payload types by name, as ``mansion schema NAME`` lists them."""

from types import ModuleType
from typing import Any

import msgspec

from mansion_msgs_py import (
    building,
    editing,
    errors,
    layout,
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
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["PAYLOADS", "payload_type"]

_MODULES: tuple[ModuleType, ...] = (
    request,
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
    editing,
    errors,
)

PAYLOADS: dict[str, type[Any]] = {
    name: kind
    for module in _MODULES
    for name in module.__all__
    if isinstance(kind := getattr(module, name), type) and issubclass(kind, msgspec.Struct)
}
"""Every structure that the payload modules make public."""


def payload_type(name: str) -> type[Any]:
    """Return the payload type of that name.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` with the names that exist.
    """
    try:
        return PAYLOADS[name]
    except KeyError:
        known = ", ".join(sorted(PAYLOADS))
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no payload {name!r}; known are {known}") from None
