"""Fill the modules ``PACKAGE.msg`` and ``PACKAGE.srv``: each class is made when first looked up."""

from __future__ import annotations

import sys
from collections.abc import Callable
from types import ModuleType
from typing import Any

from rosidl_embedded.definition import MessageDefinition, load_package
from rosidl_embedded.message_class import module_name
from rosidl_embedded.registry import get_interface

__all__ = ["populate"]


class _InterfaceModule(ModuleType):
    """``std_msgs.msg._string``: the module that a class names as its own."""

    _interfaces: dict[str, str]

    def __getattr__(self, name: str) -> Any:
        full = self._interfaces.get(name)
        if full is None:
            raise AttributeError(f"module {self.__name__!r} has no attribute {name!r}")
        return get_interface(full)


def populate(module: str) -> tuple[list[str], Callable[[str], Any]]:
    """Register the interfaces of ``std_msgs.msg`` or ``std_srvs.srv``.

    Returns
    -------
    tuple
        The module's ``__all__`` and its ``__getattr__``.
    """
    package, kind = module.split(".")
    names: list[str] = []
    for full, definition in load_package(package).items():
        if full.split("/")[1] != kind:
            continue
        short = full.split("/")[2]
        names.append(short)
        parts = [short]
        if not isinstance(definition, MessageDefinition):
            parts += [f"{short}_{part}" for part in ("Request", "Response", "Event")]
        home = _InterfaceModule(module_name(full))
        home._interfaces = {part: f"{package}/{kind}/{part}" for part in parts}
        sys.modules[home.__name__] = home

    def __getattr__(name: str) -> Any:
        service = name.rpartition("_")[0]
        if name in names or (service in names and kind == "srv"):
            value = get_interface(f"{package}/{kind}/{name}")
            setattr(sys.modules[module], name, value)
            return value
        hidden = sys.modules.get(f"{module}.{name}")
        if hidden is not None:
            return hidden
        raise AttributeError(
            f"module {module!r} of the embedded ROS has no type {name!r}; it has "
            + ", ".join(sorted(names))
        )

    return sorted(names), __getattr__
