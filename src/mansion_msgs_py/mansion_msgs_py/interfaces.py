"""The table of topics and services: names below the namespace, types, payloads and QoS, written once.

A node asks for its interface by name (``service("plan_program")``), and ``docs/interfaces.md`` is made from the table.
"""

from typing import Any

from mansion_msgs_py import building_interfaces, editing_interfaces, skill_interfaces
from mansion_msgs_py.interface_types import (
    DEFAULT_NAMESPACE,
    JSON_CALL,
    LATCHED,
    LATEST,
    SENSOR,
    STREAM,
    STRING,
    TRIGGER,
    Qos,
    ServiceInterface,
    TopicInterface,
)

__all__ = [
    "DEFAULT_NAMESPACE",
    "JSON_CALL",
    "LATCHED",
    "LATEST",
    "SENSOR",
    "SERVICES",
    "STREAM",
    "STRING",
    "TOPICS",
    "TRIGGER",
    "Qos",
    "ServiceInterface",
    "TopicInterface",
    "markdown_table",
    "service",
    "topic",
]

TOPICS: tuple[TopicInterface, ...] = (*building_interfaces.TOPICS, *skill_interfaces.TOPICS, *editing_interfaces.TOPICS)

SERVICES: tuple[ServiceInterface, ...] = (
    *building_interfaces.SERVICES,
    *skill_interfaces.SERVICES,
    *editing_interfaces.SERVICES,
)


def topic(name: str) -> TopicInterface:
    """Return the topic of that name; KeyError when the table has none."""
    return _TOPICS[name]


def service(name: str) -> ServiceInterface:
    """Return the service of that name; KeyError when the table has none."""
    return _SERVICES[name]


_TOPICS = {entry.name: entry for entry in TOPICS}
_SERVICES = {entry.name: entry for entry in SERVICES}


def _payload_name(kind: Any) -> str:
    if kind is None:
        return ""
    return getattr(kind, "__name__", str(kind)) if kind is not dict else "object"


def markdown_table() -> str:
    """Return the table of all interfaces as Markdown."""
    lines = ["| service | type | arguments | reply | node | what it does |", "| --- | --- | --- | --- | --- | --- |"]
    lines += [
        f"| `{s.name}` | `{s.type}` | {_payload_name(s.arguments)} | {_payload_name(s.reply)} "
        f"| `{s.node}` | {s.description} |"
        for s in SERVICES
    ]
    lines += ["", "| topic | type | payload | node | QoS | what it carries |", "| --- | --- | --- | --- | --- | --- |"]
    lines += [
        f"| `{t.name}` | `{t.type}` | {_payload_name(t.payload)} | `{t.node}` | {t.qos} | {t.description} |"
        for t in TOPICS
    ]
    return "\n".join(lines) + "\n"
