"""Topics of any type for ``mansion echo``: find one, load the class of its messages, and print them as YAML."""

import importlib
import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Final

from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, ReliabilityPolicy

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interfaces import STREAM, TOPICS, Qos
from mansion_msgs_py.wording import choices, counted

__all__ = ["FoundTopic", "find_topic", "full_name", "message_class", "message_values", "message_yaml", "silence"]

_PLUMBING = ("/parameter_events", "/rosout")
"""Topics that every node publishes, the reader's own among them."""


@dataclass(frozen=True)
class FoundTopic:
    """A topic with the type and the quality of service to read it with."""

    name: str
    type: str
    qos: Qos


def full_name(name: str, namespace: str) -> str:
    """Return the absolute name of a topic.

    A relative name is one below the namespace, or one of the robot stack's (``map``) where only that is in the table.

    Examples
    --------
    >>> full_name("progress", "/mansion"), full_name("map", "/mansion"), full_name("/tf", "/mansion")
    ('/mansion/progress', '/map', '/tf')
    """
    if name.startswith("/"):
        return name
    known = {entry.name for entry in TOPICS}
    if name not in known and f"/{name}" in known:
        return f"/{name}"
    return f"{namespace.rstrip('/')}/{name}"


def find_topic(node: Node, name: str) -> FoundTopic | None:
    """Return a topic that is published, or that the interface table has; ``None`` while its type is not known."""
    full = full_name(name, node.get_namespace())
    for found, types in node.get_topic_names_and_types():
        if found == full and types and node.count_publishers(full):
            return FoundTopic(full, types[0], _offered(node, full))
    for entry in TOPICS:
        if full_name(entry.name, node.get_namespace()) == full:
            return FoundTopic(full, entry.type, entry.qos)
    return None


def _offered(node: Node, name: str) -> Qos:
    """Return the best quality of service that every publisher of a topic meets."""
    offers = [info.qos_profile for info in node.get_publishers_info_by_topic(name)]
    reliable = all(offer.reliability == ReliabilityPolicy.RELIABLE for offer in offers)
    latched = all(offer.durability == DurabilityPolicy.TRANSIENT_LOCAL for offer in offers)
    return Qos(
        depth=64 if latched else STREAM.depth,
        reliability="reliable" if reliable else "best_effort",
        durability="transient_local" if latched else "volatile",
    )


def message_class(topic: FoundTopic) -> Any:
    """Return the class of a topic's messages.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` when the package of the type is not installed.
    """
    package, _, kind = topic.type.partition("/msg/")
    try:
        return getattr(importlib.import_module(f"{package}.msg"), kind)
    except (ImportError, AttributeError):
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            f"{topic.name} carries {topic.type}, which is not installed here; where it is, "
            f"`ros2 topic echo {topic.name}` prints it",
            details={"topic": topic.name, "type": topic.type},
        ) from None


def silence(node: Node, name: str) -> str:
    """Say why nothing may have come from a topic: who publishes it, or which topics are published instead."""
    full = full_name(name, node.get_namespace())
    publishers = node.count_publishers(full)
    if publishers:
        return f"{full} has {counted(publishers, 'publisher')}; nothing has come yet"
    known = list(_published(node))
    if not known:
        return f"no node publishes {full}, nor any other topic; is the graph running (`mansion up`)?"
    return f"no node publishes {full}; {choices(full, known, 'topics')}"


def _published(node: Node) -> Iterator[str]:
    for name, _ in sorted(node.get_topic_names_and_types()):
        if name not in _PLUMBING and node.count_publishers(name):
            yield name


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


def message_values(message: Any) -> Any:
    """Return a message as dictionaries, lists and plain values, all of it.

    Parameters
    ----------
    message : ROS message
        Or anything else that has ``get_fields_and_field_types``, or what a field of one holds.
    """
    if hasattr(message, "get_fields_and_field_types"):
        return {name: message_values(getattr(message, name)) for name in message.get_fields_and_field_types()}
    if isinstance(message, str | bool | int | float):
        return message
    if isinstance(message, bytes):
        return list(message)
    if hasattr(message, "tolist"):
        return message.tolist()
    return [message_values(element) for element in message]


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
