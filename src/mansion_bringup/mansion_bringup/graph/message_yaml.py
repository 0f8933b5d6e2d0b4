"""A ROS message as YAML, field by field, as ``ros2 topic echo`` prints it."""

import json
import re
from collections.abc import Iterator
from typing import Any, Final

__all__ = ["message_yaml"]

MOST: Final = 128
"""Elements of an array that are shown; an occupancy grid has thousands."""

_PLAIN = re.compile(r"[A-Za-z_/][\w/.-]*(?: [\w/.-]+)*")
_WORDS: Final = {"true", "false", "null", "yes", "no", "on", "off", "y", "n"}
"""What YAML reads as something else than text."""


def message_yaml(message: Any) -> str:
    """Return a message as YAML, without a separator after it.

    Parameters
    ----------
    message : ROS message
        Or anything else that has ``get_fields_and_field_types``.
    """
    return "\n".join(_fields(message)) + "\n"


def _fields(message: Any) -> Iterator[str]:
    for name in message.get_fields_and_field_types():
        value = getattr(message, name)
        inner = list(_block(value))
        if inner:
            indent = "" if inner[0].startswith("- ") else "  "
            yield f"{name}:"
            yield from (indent + line for line in inner)
        else:
            yield f"{name}: {_scalar(value)}"


def _block(value: Any) -> Iterator[str]:
    """Yield the lines of what takes more than one: a message or a filled sequence."""
    if hasattr(value, "get_fields_and_field_types"):
        yield from _fields(value)
    elif not isinstance(value, str) and hasattr(value, "__len__"):
        for element in list(value[:MOST]):
            inner = list(_block(element)) or [_scalar(element)]
            yield f"- {inner[0]}"
            yield from (f"  {line}" for line in inner[1:])
        if len(value) > MOST:
            yield "- '...'"


def _scalar(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, bytes):
        return str(value[0]) if value else "0"
    if isinstance(value, str):
        plain = _PLAIN.fullmatch(value) and value.lower() not in _WORDS
        return value if plain else json.dumps(value, ensure_ascii=False)
    if hasattr(value, "__len__"):
        return "[]"
    return _number(float(value)) if isinstance(value, float) else str(value)


def _number(value: float) -> str:
    if value != value:
        return ".nan"
    return repr(value) if abs(value) != float("inf") else (".inf" if value > 0 else "-.inf")
