"""Make the Python class of a message, as Jazzy's generator does.

Fields are properties over slots, constructors take keywords only, and assignments are checked with
assertions. ``ROS_PYTHON_CHECK_FIELDS=0`` turns the checks off (Jazzy has them off by default, and
then fails later, while converting).
"""

from __future__ import annotations

import os
from array import array
from collections.abc import Callable
from typing import Any

from rosidl_embedded.definition import PRIMITIVES, Field, FieldType, MessageDefinition
from rosidl_embedded.field_checks import (
    check_message,
    check_number,
    check_sequence,
    check_string,
    to_array,
    to_ndarray,
)

__all__ = ["CHECK_FIELDS", "build_message_class", "module_name"]

CHECK_FIELDS = os.environ.get("ROS_PYTHON_CHECK_FIELDS", "1") != "0"


def module_name(definition_name: str) -> str:
    """``std_msgs.msg._color_rgba`` for ``std_msgs/msg/ColorRGBA``."""
    package, kind, name = definition_name.split("/")
    if kind == "srv":
        for suffix in ("_Request", "_Response", "_Event"):
            name = name.removesuffix(suffix)
    out = ""
    for i, char in enumerate(name):
        previous = name[i - 1] if i else ""
        following = name[i + 1] if i + 1 < len(name) else ""
        boundary = previous.islower() or previous.isdigit() or (previous and following.islower())
        if i and char.isupper() and boundary:
            out += "_"
        out += char.lower()
    return f"{package}.{kind}._{out}"


def _default_maker(field: Field) -> Callable[[], Any]:
    kind = field.type
    if field.default is not None:
        value = field.default
        return lambda: value
    if kind.kind == "sequence":
        if kind.is_numeric:
            code = PRIMITIVES[kind.base][0]
            return lambda: array(code)
        return list
    single = _single_default(kind)
    if kind.kind == "array":
        if kind.is_numeric:
            return lambda: to_ndarray(None, kind)
        return lambda: [single() for _ in range(kind.size)]
    return single


def _single_default(kind: FieldType) -> Callable[[], Any]:
    if kind.is_message:
        from rosidl_embedded.registry import get_message

        return get_message(kind.base)
    if kind.base == "string":
        return str
    if kind.base == "byte":
        return lambda: b"\x00"
    return {"bool": bool, "float32": float, "float64": float}.get(kind.base, int)


def _checker(field: Field) -> Callable[[Any, bool], Any]:
    """A function of the new value and whether to check, that gives the value to store."""
    kind, name = field.type, field.name
    if kind.kind == "array" and kind.is_numeric:
        return lambda value, check: to_ndarray(value, kind, name, check)
    if kind.kind == "sequence" and kind.is_numeric:
        return lambda value, check: to_array(value, kind, name, check)
    if kind.kind != "single":
        return lambda value, check: check_sequence(value, kind, name, check)
    if kind.is_message:
        from rosidl_embedded.registry import get_message

        cls = get_message(kind.base)
        return lambda value, check: check_message(value, cls, name, check)
    if kind.base == "string":
        return lambda value, check: check_string(value, kind, name, check)
    return lambda value, check: check_number(value, kind.base, name, check)


def _property(field: Field) -> property:
    slot, check = f"_{field.name}", _checker(field)

    def getter(self: Any) -> Any:
        return getattr(self, slot)

    def setter(self: Any, value: Any) -> None:
        setattr(self, slot, check(value, self._check_fields))

    return property(getter, setter, doc=f"Message field '{field.name}'.")


def _same(left: Any, right: Any) -> bool:
    if hasattr(left, "dtype") or hasattr(right, "dtype"):
        return len(left) == len(right) and bool((left == right).all())
    return bool(left == right)


def _text(value: Any, kind: FieldType) -> str:
    if kind.kind == "sequence" and kind.is_numeric:
        return repr(value.tolist())
    return repr(value)


def build_message_class(definition: MessageDefinition) -> type:
    """The class of one message definition."""
    fields = definition.fields
    names = tuple(f.name for f in fields)
    makers = tuple((f"_{f.name}", f.name, _default_maker(f)) for f in fields)
    known = frozenset(names)

    def __init__(self: Any, **kwargs: Any) -> None:
        self._check_fields = kwargs.pop("check_fields", CHECK_FIELDS)
        if not kwargs:
            for slot, _, make in makers:
                setattr(self, slot, make())
            return
        unknown = kwargs.keys() - known
        assert not unknown, "Invalid arguments passed to constructor: " + ", ".join(sorted(unknown))
        for slot, name, make in makers:
            if name in kwargs:
                setattr(self, name, kwargs[name])
            else:
                setattr(self, slot, make())

    def __repr__(self: Any) -> str:
        args = ", ".join(f"{f.name}={_text(getattr(self, f.name), f.type)}" for f in fields)
        package, kind, name = definition.name.split("/")
        return f"{package}.{kind}.{name}({args})"

    def __eq__(self: Any, other: object) -> bool:
        if not isinstance(other, self.__class__):
            return False
        return all(_same(getattr(self, slot), getattr(other, slot)) for slot, _, _ in makers)

    field_types = {f.name: f.type.idl_name() for f in fields}

    def get_fields_and_field_types(cls: type) -> dict[str, str]:
        """The IDL type of each field, in order."""
        return dict(field_types)

    name = definition.name.split("/")[2]
    namespace: dict[str, Any] = {
        "__doc__": f"Message class '{name}'.",
        "__module__": module_name(definition.name),
        "__qualname__": name,
        "__slots__": [*(f"_{n}" for n in names), "_check_fields"],
        "__init__": __init__,
        "__repr__": __repr__,
        "__eq__": __eq__,
        "__hash__": None,
        "_fields_and_field_types": field_types,
        "_definition": definition,
        "get_fields_and_field_types": classmethod(get_fields_and_field_types),
    }
    for constant in definition.constants:
        namespace[constant.name] = constant.value
    for field in fields:
        namespace[field.name] = _property(field)
        if field.default is not None:
            namespace[f"{field.name.upper()}__DEFAULT"] = field.default
    cls: type = type(f"Metaclass_{name}", (type,), {})(name, (), namespace)
    return cls
